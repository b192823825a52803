// The filter applied to two determinants.
#include <contact/exact.hpp>
#include <contact/exact_ray_triangle.hpp>
#include <cstdio>

using contact::Exact;
using contact::Vector3;

namespace {

void show(const char* what, const Vector3<double>& p, const Vector3<double>& q,
          const Vector3<double>& r) {
  const contact::Bounded bounded = contact::bounded_volume(p, q, r);
  const auto exact = [](const Vector3<double>& v) { return Vector3<Exact>(v.x(), v.y(), v.z()); };
  const Exact volume = exact(p).dot(Vector3<Exact>(exact(q).cross(exact(r))));
  std::printf("%s\n  in double %.3g, at most %.3g off: %s\n  exactly   %.3g, sign %d\n", what,
              bounded.value, bounded.bound, bounded.certain_sign() != 0 ? "certain" : "not certain",
              rounded<double>(volume), volume.sign());
}

}  // namespace

int main() {
  show("three vectors in general position", {1, 2, 3}, {-2, 1, 0.5}, {0.25, -1, 2});
  // p is q + r, rounded: two of its coordinates are half an ulp off, so nearly coplanar.
  show("three nearly coplanar vectors", {0.1 + 0.3, 0.2 + 0.7, 0.4 + 0.5}, {0.1, 0.2, 0.4},
       {0.3, 0.7, 0.5});
}
