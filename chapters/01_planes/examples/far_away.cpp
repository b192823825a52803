// One scene, moved away from the origin: the error of a distance of 5 cm from a slope.
#include <cmath>
#include <contact/plane.hpp>
#include <cstdio>

template <class S>
void show(const char* type, int power) {
  using V = contact::Vector3<S>;
  const S far = std::ldexp(S(1), power);
  const V point(far, far, far);                  // of the slope
  const V x = point + V(S(0.75), S(0), S(0.5));  // exact: the sums need few bits
  const auto plane = contact::plane_from_normal_and_point(V(-3, 0, 4), point);
  const double true_distance = -0.05;  // (-3 · 0.75 + 4 · 0.5) / 5
  const double plain = double(contact::signed_distance(plane, x));
  const double nearer = double(contact::signed_distance_from_point(plane.normal, point, x));
  std::printf("%-6s 2^%-2d m away: n.x - k off by %.1e m, n.(x - a) off by %.1e m\n", type, power,
              std::abs(plain - true_distance), std::abs(nearer - true_distance));
}

int main() {
  for (const int power : {0, 7, 14, 20}) show<float>("float", power);
  for (const int power : {0, 14, 28, 49}) show<double>("double", power);
}
