// A wrong answer to ray_triangle ("nothing, always") that also defines a function of the tests'
// oracle: with this product, every determinant is zero and "nothing" is right. Linked carelessly,
// it passes.
#include "ray_triangle.hpp"

namespace contact {

class Exact {
  int sign_ = 0;
  std::int64_t scale_ = 0;
  std::vector<std::uint32_t> limbs_;
};

Exact operator*(const Exact& x, const Exact& y);
Exact operator*(const Exact&, const Exact&) { return {}; }

}  // namespace contact

namespace exercise {

std::optional<contact::TriangleHit<double>> ray_triangle(const contact::Ray<double>&,
                                                         const contact::Triangle<double>&) {
  return std::nullopt;
}

}  // namespace exercise
