#include "support/questions.hpp"

#include <cmath>
#include <contact/vector.hpp>
#include <limits>

#include "support/generators.hpp"

using contact::Vector3;

KEY("dot-sign") {
  // Among random pairs, what the angle is (by the law of cosines) when the dot product is negative.
  generators::Random random(1);
  std::array<int, 3> seen{};
  for (int i = 0; i < 1000; ++i) {
    const auto a = generators::point(random, generators::Family::random);
    const auto b = generators::point(random, generators::Family::random);
    if (a.dot(b) >= 0) continue;
    const double opposite = (a - b).squaredNorm();
    const double right_angle = a.squaredNorm() + b.squaredNorm();
    ++seen[opposite < right_angle ? 0 : opposite == right_angle ? 1 : 2];
  }
  return static_cast<int>(std::max_element(seen.begin(), seen.end()) - seen.begin());
}

KEY("cross-direction") {
  const Vector3<double> a(0, 0, 0);
  const Vector3<double> b(1, 0, 0);
  const Vector3<double> c(0, 1, 0);
  const Vector3<double> normal = Vector3<double>(b - a).cross(Vector3<double>(c - a));
  if (normal.z() > 0) return 0;
  if (normal.z() < 0) return 1;
  return normal.x() > 0 ? 2 : 3;
}

KEY("cancellation") {
  const double big = std::ldexp(1.0, 53);
  return (big + 1.0) - big;
}

KEY("ulp-far-away") {
  const float place = 10000.0f;
  const float next = std::nextafter(place, std::numeric_limits<float>::infinity());
  return 1000.0 * (double(next) - double(place));
}
