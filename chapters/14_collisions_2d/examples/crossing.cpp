// A car and a van meet at a crossing and stick together; and a speed found from skid marks.
#include <cmath>
#include <contact/collision_1d.hpp>
#include <contact/momentum.hpp>
#include <cstdio>
#include <numbers>

constexpr double degree = std::numbers::pi / 180;

int main() {
  const auto car = contact::point_mass<double>(1500, {0, 0, 0}, {16, 0, 0});
  const auto van = contact::point_mass<double>(2000, {0, 0, 0}, {0, 9, 0});
  const auto together = *contact::centre_velocity<double>({car, van});
  std::printf("momenta: %g and %g kg m/s, together %g\n", contact::momentum(car).norm(),
              contact::momentum(van).norm(), contact::total_momentum<double>({car, van}).norm());
  std::printf("tan(theta) = %g, theta = %.2f degrees, v = %.3f m/s\n", together.y() / together.x(),
              std::atan2(together.y(), together.x()) / degree, together.norm());
  const double before = (1500 * 16.0 * 16.0 + 2000 * 9.0 * 9.0) / 2;
  const double lost =
      contact::reduced_mass(1500.0, 2000.0) * (car.velocity - van.velocity).squaredNorm() / 2;
  std::printf("kinetic energy: %.0f kJ before, %.1f kJ lost\n", before / 1000, lost / 1000);
  std::printf("momenta added as numbers would give %.3f m/s\n", (1500 * 16.0 + 2000 * 9.0) / 3500);

  // The wreck of another crash slid at 25 degrees to the direction of b, which had 15 m/s.
  const double m_a = 1000;
  const double m_b = 1400;
  const double v_b = 15;
  const double v_t = m_b * v_b / ((m_a + m_b) * std::cos(25 * degree));
  const double v_a = (m_a + m_b) * v_t * std::sin(25 * degree) / m_a;
  std::printf("25 degrees: v_T = %.3f m/s, and a had %.3f m/s\n", v_t, v_a);
  std::printf("check: m_b v_b tan(25) / m_a = %.3f m/s\n", m_b * v_b * std::tan(25 * degree) / m_a);
}
