// The same slope made in three ways, and the signed distances of three points.
#include <contact/plane.hpp>
#include <iostream>

using contact::Plane;
using contact::Vector3;

int main() {
  const Vector3<double> a(0, 0, 2);
  const Vector3<double> b(4, 0, 5);
  const Vector3<double> c(0, 1, 2);

  const Plane<double> from_points = contact::plane_from_points(a, b, c);
  const Plane<double> from_normal = contact::plane_from_normal_and_point<double>({-3, 0, 4}, a);
  const Plane<double> from_coefficients = contact::plane_from_coefficients(-3.0, 0.0, 4.0, -8.0);

  for (const Plane<double>& plane : {from_points, from_normal, from_coefficients}) {
    std::cout << "normal " << plane.normal.transpose() << ", offset " << plane.offset << '\n';
  }
  for (const Vector3<double>& x : {Vector3<double>(0, 0, 12), b, Vector3<double>(5, 7, 2)}) {
    std::cout << "signed distance of (" << x.transpose()
              << "): " << contact::signed_distance(from_points, x) << " m\n";
  }
  try {
    contact::plane_from_points(a, b, Vector3<double>((a + b) / 2));
  } catch (const std::invalid_argument& refused) {
    std::cout << "refused: " << refused.what() << '\n';
  }
}
