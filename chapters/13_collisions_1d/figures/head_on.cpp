// Two carts on a line: their positions against time, and their momenta and energies before and
// after. A switch selects the formula of the slides, which does not test for approach.
#include <contact/collision_1d.hpp>
#include <contact/figure.hpp>

struct Input {
  double mass_1, mass_2;  // kg
  double v_1, v_2;        // before, m/s
  double e;               // coefficient of restitution
  double tested;          // 1: with the test for approach; 0: without
  double time;            // since the contact, s
};

struct Output {
  double problem;
  double approach;              // whether they approach
  double after_1, after_2;      // velocities, m/s
  double closing, separation;   // m/s
  double impulse;               // on the second, N·s
  double p_1, p_2, p;           // momenta afterwards, kg·m/s
  double k_1, k_2;              // kinetic energies before, J
  double after_k_1, after_k_2;  // and afterwards
  double lost;                  // by ½ μ (1 − e²) w², J
  double fraction;              // of the kinetic energy before; 0 if there is none
  double centre;                // velocity of the centre of mass, m/s
  double x_1, x_2;              // at the time, m; they touch at 0
  double through;               // whether they have passed through each other
  double first_stops;           // goal: unequal masses, the second at rest, the first stops
};

Output compute(const Input& in) {
  Output out{};
  for (const double mass : {in.mass_1, in.mass_2}) {
    if (!(mass > 0)) out.problem = contact::figure::not_positive;
  }
  if (!(in.e >= 0) || !(in.e <= 1)) out.problem = contact::figure::too_large;
  for (const double x : {in.mass_1, in.mass_2, in.v_1, in.v_2, in.time}) {
    if (std::abs(x) > 1e50) out.problem = contact::figure::too_large;
  }
  if (out.problem == 0 && (in.mass_1 < 1e-50 || in.mass_2 < 1e-50)) {
    out.problem = contact::figure::too_small;
  }
  if (out.problem != 0) return out;

  const auto first = contact::line_body(in.mass_1, in.v_1);
  const auto second = contact::line_body(in.mass_2, in.v_2);
  const auto share = contact::mass_shares(in.mass_1, in.mass_2);
  out.approach = contact::approaching(first, second) ? 1 : 0;
  out.closing = contact::closing_speed(first, second);
  auto after = contact::collide(first, second, in.e);
  out.impulse = contact::collision_impulse(first, second, in.e);
  out.lost = contact::energy_lost(first, second, in.e);
  if (in.tested == 0) {
    // WRONG: no test for approach. The formula is right if they approach; if they separate it
    // reverses their velocities, so that they pass through each other.
    const double change = (1 + in.e) * out.closing;
    after.first = in.v_1 - change * share.second;
    after.second = in.v_2 + change * share.first;
    out.impulse = change * contact::reduced_mass(in.mass_1, in.mass_2);
  }
  out.after_1 = after.first;
  out.after_2 = after.second;
  const auto first_after = contact::line_body(in.mass_1, after.first);
  const auto second_after = contact::line_body(in.mass_2, after.second);
  out.separation = contact::closing_speed(second_after, first_after);
  out.p_1 = in.mass_1 * after.first;
  out.p_2 = in.mass_2 * after.second;
  out.p = out.p_1 + out.p_2;
  out.k_1 = contact::kinetic_energy(first);
  out.k_2 = contact::kinetic_energy(second);
  out.after_k_1 = contact::kinetic_energy(first_after);
  out.after_k_2 = contact::kinetic_energy(second_after);
  const double before = out.k_1 + out.k_2;
  out.fraction = before > 0 ? out.lost / before : 0;
  out.centre = share.first * in.v_1 + share.second * in.v_2;
  const bool later = in.time > 0;
  out.x_1 = (later ? after.first : in.v_1) * in.time;
  out.x_2 = (later ? after.second : in.v_2) * in.time;
  out.through = contact::approaching(first_after, second_after) ? 1 : 0;
  const bool unequal = std::abs(in.mass_1 - in.mass_2) >= 10;
  out.first_stops = unequal && in.v_2 == 0 && in.v_1 >= 1 && std::abs(after.first) <= 0.02 ? 1 : 0;
  return out;
}

FIGURE(Input, FIELDS(mass_1, mass_2, v_1, v_2, e, tested, time), Output,
       FIELDS(problem, approach, after_1, after_2, closing, separation, impulse, p_1, p_2, p, k_1,
              k_2, after_k_1, after_k_2, lost, fraction, centre, x_1, x_2, through, first_stops))
