// The slide's two mistakes, each with a number: the sign of beta, and the dimension to drop.
#include <contact/barycentric.hpp>
#include <cstdio>

using contact::cross2;
using contact::drop_dimension;
using contact::Vector3;

int main() {
  const Vector3<double> v0(0, 0, 0), v1(4, 0, 0), v2(0, 4, 0);
  const Vector3<double> x(1, 2, 0);  // in the triangle: v0 + 1/4 (v1 - v0) + 1/2 (v2 - v0)
  const Vector3<double> n = (v1 - v0).cross(v2 - v0);
  std::printf("normal (%g, %g, %g): largest in dimension %d\n", n.x(), n.y(), n.z(),
              contact::largest_dimension(n));
  for (int k = 0; k < 3; ++k) {
    const auto e1 = drop_dimension<double>(v1 - v0, k);
    const auto e2 = drop_dimension<double>(v2 - v0, k);
    const auto to_x = drop_dimension<double>(x - v0, k);
    const double area = cross2(e1, e2);
    std::printf("drop %d: e1 x e2 = %g", k, area);
    if (area == 0) {
      std::printf(", no division possible\n");
      continue;
    }
    std::printf(", alpha = %g, beta on the slide = %g, beta = %g\n", cross2(to_x, e2) / area,
                cross2(to_x, e1) / area, cross2(e1, to_x) / area);
  }
}
