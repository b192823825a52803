// The same orientation predicate near the origin and far from it.
#include <cmath>
#include <contact/orientation.hpp>
#include <cstdio>

int main() {
  using Point = contact::Vector2<double>;
  std::printf("   far away    products first    differences first    true\n");
  for (const double far : {0.0, 1e5, 1e6, 1e7, 1e8}) {
    const Point position(far, 2 * far);
    const Point a = position + Point(0, 0);
    const Point b = position + Point(1, 1);
    const Point p = position + Point(0.5, 0.5009765625);  // a little to the left
    std::printf("%9g m %17.10g %20.10g %7d\n", far, contact::orientation_expanded(a, b, p),
                contact::orientation(a, b, p), contact::orient_2d_exactly(a, b, p));
  }
}
