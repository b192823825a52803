// What a user of the headers writes: which side of the floor is a point on?
#include <contact/plane.hpp>
#include <iostream>

int main() {
  using Vector = contact::Vector3<double>;
  const auto floor =
      contact::plane_from_normal_and_point(Vector(0.0, 0.0, 2.0), Vector(1.0, 1.0, 3.0));
  std::cout << contact::signed_distance(floor, Vector(4.0, 4.0, 7.0)) << '\n';
}
