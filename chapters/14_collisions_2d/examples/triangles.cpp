// Triangles of momenta: the sides from the angles. A arrives with a momentum of 1, B is at rest.
#include <cmath>
#include <contact/momentum_triangle.hpp>
#include <cstdio>
#include <numbers>

using Vector = contact::Vector2<double>;

Vector direction(double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  return {std::cos(angle), std::sin(angle)};
}

void solve(double left, double right) {
  // [share]
  const auto shares = contact::share_momentum<double>({1, 0}, direction(left), direction(-right));
  // [/share]
  const double a = shares->a.norm();
  const double b = shares->b.norm();
  std::printf("%g and %g degrees, the third angle %g: p_A = %.4f, p_B = %.4f\n", left, right,
              180 - left - right, a, b);
  // Kinetic energy goes with p squared over m.
  std::printf("  equal masses would keep %.3f of the kinetic energy\n", a * a + b * b);
  if (a * a + b * b < 0.9999) {
    std::printf("  an elastic collision needs m_B = %.3f m_A\n", b * b / (1 - a * a));
  }
}

int main() {
  solve(30, 35);
  solve(40, 50);
}
