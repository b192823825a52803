// A body that nearly stops: the error of its small velocity, relative to itself and to the input.
// In float, where the error is larger; the truth is computed without rounding.
#include <cmath>
#include <contact/collision_1d.hpp>
#include <cstdio>

int main() {
  const float u = 0x1p-24f;
  const auto second = contact::line_body(1.0f, 0.0f);
  std::printf("   m1      exact v1'    computed      relative error   of u(|v1| + |v2|)\n");
  for (const float m1 : {0.6f, 0.31f, 0.3001f, 0.30001f, 0.3000001f}) {
    const auto first = contact::line_body(m1, 1.0f);
    const float e = 0.3f;
    const float got = contact::collide(first, second, e).first;
    const float right = contact::collide_exactly(first, second, e).first;
    const double off = std::abs(double{got} - double{right});
    std::printf("%-9.7g %11.4g %11.4g %14.1e %17.2f\n", double{m1}, double{right}, double{got},
                off / std::abs(double{right}), off / double{u});
  }
}
