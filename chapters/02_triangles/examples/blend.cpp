// Values at the vertices, interpolated at a point: a temperature, and the point itself.
#include <contact/barycentric.hpp>
#include <cstdio>

using contact::Triangle;
using contact::Vector3;

int main() {
  const Triangle<double> plate{{0, 0, 0}, {4, 0, 0}, {0, 4, 2}};  // m
  const Vector3<double> point(1, 1, 0.5);
  const auto weights = contact::barycentric(point, plate);
  if (!weights) return 1;
  std::printf("weights of a, b, c: %g, %g, %g; inside: %s\n", weights->x(), weights->y(),
              weights->z(), contact::inside(*weights) ? "yes" : "no");
  std::printf("20, 60 and 100 degrees at the vertices give %g degrees here\n",
              contact::interpolate(*weights, 20.0, 60.0, 100.0));
  const Vector3<double> again = contact::interpolate(*weights, plate.a, plate.b, plate.c);
  std::printf("the interpolated vertices are (%g, %g, %g)\n", again.x(), again.y(), again.z());
}
