// The cross product of two nearly parallel edges: as defined, compensated, and exact.
#include <contact/products.hpp>
#include <cstdio>

int main() {
  using Vector = contact::Vector3<double>;
  const Vector u(0.1, 0.3, 0.7);
  const Vector v(0.3, 0.9, 2.1);  // three times u, except for rounding
  const auto line = [](const char* how, const Vector& n) {
    std::printf("%-12s (% .17g, % .17g, % .17g)\n", how, n.x(), n.y(), n.z());
  };
  line("as defined", contact::cross_plain(u, v));
  line("accurately", contact::cross_accurately(u, v));
  line("exactly", contact::cross_exactly(u, v));
}
