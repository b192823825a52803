// Five touching balls: the velocities after the impact by several methods.
#include <contact/cradle.hpp>
#include <contact/figure.hpp>

struct Input {
  double v_1, v_2, v_3, v_4, v_5;  // before, m/s
  double middle;                   // mass of the third ball relative to the others
  double e;       // coefficient of restitution of every pair; springs lose no energy
  double method;  // 0: fastest pair first, 1: from the left, 2: from the right,
                  // 3: linear springs, 4: elastic spheres, 5: all pairs at once
};

struct Output {
  double problem;
  std::array<double, 5> after;  // m/s
  double collisions;            // of pairs; 0 for springs
  double settled;               // whether no neighbours approach any more
  double p, after_p;            // momenta, in masses of an outer ball times m/s
  double kept;                  // remaining fraction of the kinetic energy; 1 if there was none
  std::array<double, 5> other;  // by pairs from the other end: equal unless the order matters
  double order_matters;         // goal: from the left and from the right differ by 0.05 m/s
};

Output compute(const Input& in) {
  Output out{};
  if (!(in.middle > 0)) out.problem = contact::figure::not_positive;
  if (!(in.e >= 0) || !(in.e <= 1)) out.problem = contact::figure::too_large;
  const std::array<double, 5> before{in.v_1, in.v_2, in.v_3, in.v_4, in.v_5};
  for (const double v : before) {
    if (std::abs(v) > 1e50) out.problem = contact::figure::too_large;
  }
  if (out.problem == 0 && in.middle > 1e6) out.problem = contact::figure::too_large;
  if (out.problem == 0 && in.middle < 1e-6) out.problem = contact::figure::too_small;
  if (out.problem != 0) return out;

  std::vector<contact::LineBody<double>> row;
  for (std::size_t i = 0; i < before.size(); ++i) {
    row.push_back(contact::line_body(i == 2 ? in.middle : 1.0, before[i]));
  }
  using contact::PairOrder;
  constexpr int limit = 2000;
  const auto left = contact::collide_row(row, in.e, PairOrder::left_to_right, limit);
  const auto right = contact::collide_row(row, in.e, PairOrder::right_to_left, limit);
  contact::RowOutcome<double> outcome = left;
  if (in.method == 0) {
    outcome = contact::collide_row(row, in.e, PairOrder::fastest_first, limit);
  } else if (in.method == 2) {
    outcome = right;
  } else if (in.method == 3 || in.method == 4) {
    outcome = contact::row_on_springs(
        row, in.method == 3 ? contact::ContactSpring::linear : contact::ContactSpring::hertz, 1000);
  } else if (in.method == 5) {
    outcome = contact::collide_simultaneously(row, in.e, limit);
  }
  const auto& other = in.method == 2 ? left : right;
  double energy = 0;
  double after_energy = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    out.after[i] = outcome.velocities[i];
    out.other[i] = other.velocities[i];
    out.p += row[i].mass * before[i];
    out.after_p += row[i].mass * out.after[i];
    energy += contact::kinetic_energy(row[i]);
    after_energy += contact::kinetic_energy(contact::line_body(row[i].mass, out.after[i]));
    if (std::abs(left.velocities[i] - right.velocities[i]) >= 0.05 && left.settled &&
        right.settled) {
      out.order_matters = 1;
    }
  }
  out.collisions = outcome.collisions;
  out.settled = outcome.settled ? 1 : 0;
  out.kept = energy > 0 ? after_energy / energy : 1;
  return out;
}

FIGURE(Input, FIELDS(v_1, v_2, v_3, v_4, v_5, middle, e, method), Output,
       FIELDS(problem, after, collisions, settled, p, after_p, kept, other, order_matters))
