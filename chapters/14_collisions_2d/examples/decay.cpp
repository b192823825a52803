// Polonium 210 at rest emits an alpha particle and becomes lead 206.
#include <contact/momentum.hpp>
#include <contact/pieces.hpp>
#include <cstdio>

int main() {
  const double unit = 1.66053907e-27;  // kg
  const double mev = 1.602176634e-13;  // J
  const double lead = 205.974 * unit;
  const double alpha = 4.0026 * unit;
  const double energy = 5.407 * mev;
  // [decay]
  const auto after = contact::fly_apart<double>(lead, alpha, {0, 0, 0}, energy, {1, 0, 0});
  // [/decay]
  std::printf("alpha: %.3g m/s, lead: %.3g m/s\n", after.second.x(), after.first.x());
  std::printf("momenta: %.3g and %.3g kg m/s\n", alpha * after.second.x(), lead * after.first.x());
  const double k_alpha = alpha * after.second.squaredNorm() / 2;
  const double k_lead = lead * after.first.squaredNorm() / 2;
  std::printf("kinetic energy: 0 before, %.3f + %.3f = %.3f MeV after\n", k_alpha / mev,
              k_lead / mev, (k_alpha + k_lead) / mev);
  // The slide's equation, for a nucleus that moves: m_n v = (m_n - m_p) v' + m_p v_p, in units.
  const double v = 2;
  const double v_p = 10;
  const double rest = (210 * v - 4 * v_p) / (210 - 4);
  std::printf("210 at 2, of which 4 leave at 10: the remainder at %.4f\n", rest);
  std::printf("energy: %.1f before, %.1f after, gained %.1f = %.1f\n", 210 * v * v / 2,
              206 * rest * rest / 2 + 4 * v_p * v_p / 2,
              206 * rest * rest / 2 + 4 * v_p * v_p / 2 - 210 * v * v / 2,
              contact::energy_apart<double>(206, 4, {v_p - rest, 0, 0}));
}
