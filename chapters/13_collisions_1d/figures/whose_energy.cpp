// One collision in frames of different velocities: the kinetic energy before and after, and what
// would remain if e, or its square, were the kept fraction of the total.
#include <contact/collision_1d.hpp>
#include <contact/figure.hpp>

struct Input {
  double mass_1, mass_2;  // kg
  double v_1, v_2;        // before, over the ground, m/s
  double e;               // coefficient of restitution
  double frame;           // velocity of the frame over the ground, m/s
  double part;            // fraction assumed to be kept. 2: e²; 1: e
};

constexpr int samples = 61;

struct Output {
  double problem;
  double approach;
  std::array<double, samples> frames;                // m/s
  std::array<double, samples> before, after, wrong;  // kJ, in each frame
  std::array<double, samples> centre;                // kJ: of the centre of mass, always kept
  double k_before, k_after, k_wrong, k_centre;       // kJ, in the frame
  double lost, fraction;   // kJ, and as a fraction of the total in the frame
  double centre_velocity;  // over the ground, m/s
  double impossible;       // whether the wrong value is less than what is always kept
};

namespace {

// WRONG: e is a ratio of speeds, and its square the kept fraction of the *relative* energy. It is
// the kept fraction of the total only in the frame of the centre of mass.
double kept_of_all(double energy, double e, bool squared) { return energy * (squared ? e * e : e); }

struct Seen {
  double before, after, centre;  // kJ
};

Seen seen_from(double frame, const Input& in, double centre_velocity) {
  const auto energy = [](double mass, double v) {
    return contact::kinetic_energy(contact::line_body(mass, v)) / 1000;
  };
  const double v_1 = in.v_1 - frame;
  const double v_2 = in.v_2 - frame;
  const auto after = contact::collide(contact::line_body(in.mass_1, v_1),
                                      contact::line_body(in.mass_2, v_2), in.e);
  return {energy(in.mass_1, v_1) + energy(in.mass_2, v_2),
          energy(in.mass_1, after.first) + energy(in.mass_2, after.second),
          energy(in.mass_1 + in.mass_2, centre_velocity - frame)};
}

}  // namespace

Output compute(const Input& in) {
  Output out{};
  for (const double mass : {in.mass_1, in.mass_2}) {
    if (!(mass > 0)) out.problem = contact::figure::not_positive;
  }
  if (!(in.e >= 0)) out.problem = contact::figure::too_small;
  if (in.e > 1) out.problem = contact::figure::too_large;
  for (const double x : {in.mass_1, in.mass_2, in.v_1, in.v_2, in.frame}) {
    if (std::abs(x) > 1e50) out.problem = contact::figure::too_large;
  }
  if (out.problem == 0 && (in.mass_1 < 1e-50 || in.mass_2 < 1e-50)) {
    out.problem = contact::figure::too_small;
  }
  if (out.problem != 0) return out;

  const auto first = contact::line_body(in.mass_1, in.v_1);
  const auto second = contact::line_body(in.mass_2, in.v_2);
  const auto share = contact::mass_shares(in.mass_1, in.mass_2);
  const bool squared = in.part != 1;
  out.approach = contact::approaching(first, second) ? 1 : 0;
  out.centre_velocity = share.first * in.v_1 + share.second * in.v_2;
  for (int i = 0; i < samples; ++i) {
    const auto at = static_cast<std::size_t>(i);
    out.frames[at] = i / 2.0;
    const Seen seen = seen_from(out.frames[at], in, out.centre_velocity);
    out.before[at] = seen.before;
    out.after[at] = seen.after;
    out.wrong[at] = kept_of_all(seen.before, in.e, squared);
    out.centre[at] = seen.centre;
  }
  const Seen seen = seen_from(in.frame, in, out.centre_velocity);
  out.k_before = seen.before;
  out.k_after = seen.after;
  out.k_wrong = kept_of_all(seen.before, in.e, squared);
  out.k_centre = seen.centre;
  out.lost = contact::energy_lost(first, second, in.e) / 1000;
  out.fraction = seen.before > 0 ? out.lost / seen.before : 0;
  out.impossible = out.approach > 0 && out.k_wrong < seen.centre - 1e-9 * (1 + seen.before) ? 1 : 0;
  return out;
}

FIGURE(Input, FIELDS(mass_1, mass_2, v_1, v_2, e, frame, part), Output,
       FIELDS(problem, approach, frames, before, after, wrong, centre, k_before, k_after, k_wrong,
              k_centre, lost, fraction, centre_velocity, impossible))
