// An angle from its cosine, and from both products.
#include <algorithm>
#include <cmath>
#include <contact/angle.hpp>
#include <cstdio>

int main() {
  using Vector = contact::Vector3<double>;
  std::printf("  true      acos          atan2\n");
  for (const double angle : {1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9}) {
    // tan θ = θ to the digits shown.
    const Vector u(1, 0, 0);
    const Vector v(1, angle, 0);
    const double cosine = u.dot(v) / (u.norm() * v.norm());
    std::printf("%6.0e  %.6e  %.6e\n", angle, std::acos(std::min(cosine, 1.0)),
                *contact::angle_between(u, v));
  }
}
