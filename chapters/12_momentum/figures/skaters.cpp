// Two skaters push off each other: their velocities, and the conserved momentum.
#include <contact/figure.hpp>
#include <contact/momentum.hpp>

struct Input {
  double mass_1, mass_2;  // kg
  double together;        // velocity of both before the push, m/s
  double apart;           // velocity of the second relative to the first afterwards, m/s
  double time;            // since the push, s
};

struct Output {
  double problem;
  double first, second;      // velocities after the push, m/s
  double impulse;            // on the second, N·s; that on the first is the opposite
  double first_share;        // share of `apart` that the second gets
  double p_1, p_2;           // momenta afterwards, kg·m/s
  double p_before, p_after;  // of both
  double centre_velocity;    // after the push
  double x_1, x_2, centre;   // at the time, m; the push is at 0
  double
      first_at_rest;  // goal of a question: they were moving, and the push brings the first to rest
};

Output compute(const Input& in) {
  Output out{};
  if (!(in.mass_1 > 0) || !(in.mass_2 > 0)) out.problem = contact::figure::not_positive;
  for (const double x : {in.mass_1, in.mass_2, in.together, in.apart, in.time}) {
    if (std::abs(x) > 1e100) out.problem = contact::figure::too_large;
  }
  if (out.problem == 0 && (in.mass_1 < 1e-100 || in.mass_2 < 1e-100)) {
    out.problem = contact::figure::too_small;
  }
  if (out.problem != 0) return out;

  using V = contact::Vector3<double>;
  const auto after =
      contact::push_off<double>(in.mass_1, in.mass_2, V(in.together, 0, 0), V(in.apart, 0, 0));
  out.first = after.first.x();
  out.second = after.second.x();
  out.impulse = after.impulse.x();
  out.first_share =
      contact::push_off<double>(in.mass_1, in.mass_2, V(0, 0, 0), V(1, 0, 0)).second.x();
  // Before the push both have one velocity, afterwards each its own.
  const bool pushed = in.time > 0;
  out.x_1 = (pushed ? out.first : in.together) * in.time;
  out.x_2 = (pushed ? out.second : in.together) * in.time;
  const std::vector<contact::PointMass<double>> pair{
      contact::point_mass<double>(in.mass_1, V(out.x_1, 0, 0), after.first),
      contact::point_mass<double>(in.mass_2, V(out.x_2, 0, 0), after.second)};
  out.p_1 = contact::momentum(pair[0]).x();
  out.p_2 = contact::momentum(pair[1]).x();
  out.p_before = (in.mass_1 + in.mass_2) * in.together;
  out.p_after = contact::total_momentum(pair).x();
  out.centre_velocity = contact::centre_velocity(pair)->x();
  out.centre = contact::centre_of_mass(pair)->x();
  out.first_at_rest = std::abs(in.together) >= 0.3 && std::abs(out.first) <= 0.02 ? 1 : 0;
  return out;
}

FIGURE(Input, FIELDS(mass_1, mass_2, together, apart, time), Output,
       FIELDS(problem, first, second, impulse, first_share, p_1, p_2, p_before, p_after,
              centre_velocity, x_1, x_2, centre, first_at_rest))
