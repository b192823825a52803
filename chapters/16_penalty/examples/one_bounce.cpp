// By which factor one bounce on a spring without a damper changes the energy, in steps of several
// schemes. The first touch is in the middle of a step.
#include <contact/penalty_step.hpp>
#include <cstdio>

namespace {

using contact::PenaltyScheme;

/// For a ball of 1 kg at 1 m/s on a spring of 1 N/m, so that ω₀ = 1 and h = ω₀ h.
double energy_factor(PenaltyScheme scheme, double h) {
  const auto spring = contact::spring_damper(1.0, 0.0);
  contact::PenaltyState<double> state{-h / 2, 1};  // half a step in front of the surface
  do {
    state = contact::penalty_step(scheme, state, spring, 1.0, h, 0.0);
  } while (state.penetration >= 0);
  return state.approach * state.approach;
}

void print(const char* name, PenaltyScheme scheme) {
  std::printf("%-20s", name);
  for (const double h : {0.1, 0.5, 1.0, 1.9}) std::printf("  %6.3f", energy_factor(scheme, h));
  std::printf("\n");
}

}  // namespace

int main() {
  print("explicit Euler", PenaltyScheme::explicit_euler);
  print("semi-implicit Euler", PenaltyScheme::semi_implicit_euler);
  print("velocity Verlet", PenaltyScheme::velocity_verlet);
  print("Runge-Kutta", PenaltyScheme::runge_kutta_4);
  print("implicit Euler", PenaltyScheme::implicit_euler);
}
