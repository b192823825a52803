#include "support/questions.hpp"

#include <algorithm>
#include <cmath>
#include <contact/impulse.hpp>
#include <contact/impulse_sum.hpp>
#include <contact/momentum.hpp>
#include <contact/momentum_balance.hpp>
#include <contact/variable_mass.hpp>
#include <cstdint>
#include <limits>
#include <set>

#define CONTACT_FIGURE_NO_MAIN
#include <contact/figure.hpp>
namespace force_time {
#include "figures/force_time.cpp"
}
namespace skaters {
#include "figures/skaters.cpp"
}
namespace balance {
#include "figures/balance.cpp"
}

namespace questions_test {

using Vector = contact::Vector3<double>;
using Body = contact::PointMass<double>;

KEY("players-together") {
  return contact::centre_velocity<double>({{90, {0, 0, 0}, {6, 0, 0}}, {80, {0, 0, 0}, {-7, 0, 0}}})
      ->x();
}

KEY("bounce-or-stop") {
  const auto bounce = contact::impulse_of_change<double>(0.4, {10, 0, 0}, {-5, 0, 0});
  const auto stop = contact::impulse_of_change<double>(0.4, {10, 0, 0}, {0, 0, 0});
  return bounce.x() / stop.x();
}

KEY("belt-force") {
  const auto impulse = contact::impulse_of_change<double>(5, {15, 0, 0}, {0, 0, 0});
  const auto average = [&impulse](double time) {
    // A constant force with this impulse is its own average.
    const Vector force = impulse / time;
    return std::abs(
        contact::average_force(contact::force_curve<double>({0, time}, {force, force})).x());
  };
  return questions::Gaps{
      {"dashboard", average(0.005)}, {"belt", average(0.1)}, {"bag", 1000 * impulse.norm() / 1000}};
}

KEY("triangle-area") {
  const auto curve =
      contact::force_curve<double>({0, 0.002, 0.006}, {{0, 0, 0}, {4000, 0, 0}, {0, 0, 0}});
  return contact::impulse(curve).x();
}

KEY("internal-or-external") {
  // The impulse J of the man on the boat, that of the boat on the man, and the change of the total.
  const Body man{80, {0, 0, 0}, {0, 0, 0}};
  const Body boat{200, {0, 0, 0}, {0, 0, 0}};
  const Vector push(-50, 0, 0);
  Body pushed_boat = boat;
  pushed_boat.velocity = contact::velocity_after<double>(boat.mass, boat.velocity, push);
  Body pushed_man = man;
  pushed_man.velocity = contact::velocity_after<double>(man.mass, man.velocity, Vector(-push));
  const Vector before = contact::total_momentum<double>({man, boat});
  return contact::total_momentum<double>({pushed_man, pushed_boat}) == before ? 3 : 2;
}

KEY("conservation-steps") {
  // The steps that must come before each step.
  const std::vector<std::set<int>> needs{{1, 3, 4}, {}, {0}, {1, 4}, {1}};
  std::vector<int> order;
  std::set<int> done;
  while (order.size() < needs.size()) {
    std::vector<int> possible;
    for (int i = 0; i < static_cast<int>(needs.size()); ++i) {
      const auto& before = needs[static_cast<std::size_t>(i)];
      if (done.count(i) == 0 &&
          std::includes(done.begin(), done.end(), before.begin(), before.end())) {
        possible.push_back(i);
      }
    }
    if (possible.size() != 1) return std::vector<int>{};  // the order must be unique
    order.push_back(possible.front());
    done.insert(possible.front());
  }
  return order;
}

KEY("gravity-in-a-hit") {
  const double mass = 0.145;
  const Vector weight(0, 0, -9.81 * mass);
  const auto hit = contact::force_curve<double>({0, 0.001}, {weight, weight});
  return 1000 * contact::velocity_after<double>(mass, Vector(0, 0, 0), -contact::impulse(hit)).z();
}

KEY("leaking-wagon") {
  const Vector v(3, 0, 0);
  const double after = contact::velocity_after_exchange<double>(4000, v, -1000, v)->x();
  return after > v.x() ? 0 : after == v.x() ? 1 : 2;
}

KEY("recoil-of-thrower") {
  return contact::push_off<double>(60, 20, {0, 0, 0}, {3, 0, 0}).first.x();
}

KEY("which-sum") {
  const std::vector<double> terms{1, 1e100, 1, -1e100};
  double kahan = 0;
  double carry = 0;
  for (const double x : terms) {
    const double y = x - carry;
    const double next = kahan + y;
    carry = (next - kahan) - y;
    kahan = next;
  }
  const std::vector<double> got{contact::total_recursive(terms), contact::total_pairwise(terms),
                                kahan, contact::total_compensated(terms)};
  const double right = contact::total_exactly(terms);
  if (std::count(got.begin(), got.end(), right) != 1) return -1;
  return static_cast<int>(std::find(got.begin(), got.end(), right) - got.begin());
}

KEY("stop-it-gently") {
  // 0.8 kN for 8 ms except at the ends: 31 · 0.8 · 8/32 = 6.2 N·s for 6.2 kg·m/s.
  force_time::Input state{{}, 8, 0.5, 12.4, 0};
  state.drawn.fill(0.8);
  const double winning = force_time::compute(state).stops_gently;
  state.drawn[15] = 1.6;  // nearly the same area, but too large a force
  state.drawn[10] = state.drawn[20] = 0.4;
  return questions::Construct{winning, force_time::compute(state).stops_gently};
}

KEY("one-skater-at-rest") {
  skaters::Input state{80, 40, 0.5, 1.5, 1};
  const double winning = skaters::compute(state).first_at_rest;
  state.apart = -1.5;
  return questions::Construct{winning, skaters::compute(state).first_at_rest};
}

KEY("why-centre-keeps") {
  // Whether the centre's velocity stays, if the second skater gets a share of the opposite impulse.
  const auto keeps = [](double share) {
    const Body first{80, {0, 0, 0}, {1, 0, 0}};
    const Body second{40, {1, 0, 0}, {1, 0, 0}};
    const Vector push(-30, 0, 0);
    Body after_first = first;
    after_first.velocity = contact::velocity_after<double>(first.mass, first.velocity, push);
    Body after_second = second;
    after_second.velocity =
        contact::velocity_after<double>(second.mass, second.velocity, Vector(-share * push));
    const Vector before = *contact::centre_velocity<double>({first, second});
    return (*contact::centre_velocity<double>({after_first, after_second}) - before).norm() < 1e-12;
  };
  return questions::Claim{keeps(1), keeps(0)};
}

TEST_CASE("in the figure of the drift only one line stays at zero") {
  for (const double wide : {0.0, 1.0}) {
    double farther = 0;  // of how many orders the formulas drift further when there are more
    for (int order = 0; order < 20; ++order) {
      balance::Input state{3, -2, 1.5, -1, 2, wide, double(order), 100};
      const auto few = balance::compute(state);
      state.power = 4;
      const auto many = balance::compute(state);
      CHECK(many.problem == 0);
      CHECK(many.collisions == 10000);
      for (const double off : many.grid) CHECK(off == 0);
      CHECK((many.off[0] != 0 && many.off[1] != 0 && many.off[2] == 0));
      CHECK(many.read[0] == many.formulas.back());
      CHECK(many.read[1] == many.impulses.back());
      farther += many.most > few.most;
    }
    CHECK(farther == 20);
  }
  CHECK(balance::compute({101, 0, 0, 0, 2, 0, 0, 0}).problem == contact::figure::too_large);
  CHECK(balance::compute({0, 0, 0, 0, 2, 0, 0, 0}).most == 0);
}

}  // namespace questions_test
