#include "support/questions.hpp"

#include <algorithm>
#include <cmath>
#include <contact/advance.hpp>
#include <contact/ballistic.hpp>
#include <contact/rollback.hpp>
#include <contact/spring_motion.hpp>
#include <contact/two_balls_wall.hpp>
#include <set>
#include <vector>

#define CONTACT_FIGURE_NO_MAIN
#include <contact/figure.hpp>
namespace swing {
#include "figures/swing.cpp"
}
namespace walls {
#include "figures/walls.cpp"
}
namespace squeeze {
#include "figures/squeeze.cpp"
}

namespace questions_test {

using contact::Integrator;
using Line = contact::MotionState<double>;
using Vector = contact::Vector3<double>;

namespace {

const contact::Plane<double> level{Vector(0, 0, 1), 0};

}  // namespace

KEY("one-frame") {
  const auto gravity = [](double) { return -0.5; };
  const Line start{40, 0};
  return questions::Gaps{
      {"explicit", contact::explicit_euler_step(start, 2.0, gravity).position},
      {"symplectic", contact::semi_implicit_euler_step(start, 2.0, gravity).position},
      // Verlet is exact under a constant force.
      {"exact", contact::integrate(Integrator::velocity_verlet, start, 2.0, 1, gravity).position}};
}

KEY("which-order-swings") {
  const auto spring = contact::linear_spring(1.0);
  const auto kept = [&spring](Integrator integrator) {
    const auto end = contact::integrate(integrator, Line{1, 0}, 0.05, 200000, spring);
    const double ratio = contact::spring_energy(spring, end) / 0.5;
    return ratio > 0.9 && ratio < 1.1;
  };
  return questions::Claim{kept(Integrator::semi_implicit_euler), kept(Integrator::explicit_euler)};
}

KEY("growth-of-a-swing") {
  const auto spring = contact::linear_spring(2.0);
  const Line start{1, 0.5};
  const auto end = contact::integrate(Integrator::explicit_euler, start, 0.05, 100, spring);
  return contact::spring_energy(spring, end) / contact::spring_energy(spring, start);
}

KEY("step-halved") {
  const auto spring = contact::linear_spring(1.0);
  const auto off = [&spring](int steps) {
    const auto end =
        contact::integrate(Integrator::velocity_verlet, Line{1, 0.5}, 2.0 / steps, steps, spring);
    return std::abs(end.position - contact::spring_motion(spring, Line{1, 0.5}, 2.0).position);
  };
  // The order from two halvings: the error falls as n^−order. It must fall by a factor of 16.
  const double order = std::log2(off(120) / off(480)) / 2;
  return 60 * std::pow(16, 1 / order);
}

KEY("verlet-and-gravity") {
  const auto end = contact::integrate(Integrator::velocity_verlet, Line{0, 0}, 1.0, 10,
                                      [](double) { return -9.81; });
  const double off = std::abs(end.position + 9.81 * 50);
  return off < 1e-10 ? 0 : off < 1 ? 3 : off < 10 ? 1 : 2;
}

KEY("rest-of-a-second") {
  return contact::advance_straight<double>({Vector(0, 0, 0.5), Vector(0, 0, -1)}, 0, 1, {level},
                                           contact::impact_rules(0.5, 0.0, 10))
      .state.position.z();
}

KEY("the-loop") {
  // The parts that must come before each part.
  const std::vector<std::set<int>> needs{{3}, {}, {1}, {4}, {2}};
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
    if (possible.size() != 1) return std::vector<int>{};  // two right orders would be no question
    order.push_back(possible.front());
    done.insert(possible.front());
  }
  return order;
}

KEY("tested-once") {
  const std::vector<contact::Plane<double>> room{{Vector(1, 0, 0), 0}, {Vector(-1, 0, 0), -1}};
  const contact::MotionState<Vector> start{Vector(0.5, 0, 0), Vector(-3, 0, 0)};
  const auto rules = contact::impact_rules(1.0, 0.0, 10);
  const auto whole = contact::advance_straight<double>(start, 0, 1, room, rules);
  if (whole.impacts != 3) return -1;
  const auto first = contact::advance_straight<double>(start, 0, 0.5 / 3, room, rules);
  const double place = first.state.position.x() + first.state.velocity.x() * (1 - 0.5 / 3);
  if (std::abs(place - whole.state.position.x()) < 1e-9) return 0;
  return place < 0 || place > 1 ? 2 : 1;
}

KEY("how-many-halvings") {
  int halvings = 0;
  for (double width = 1.0 / 60; width > 1e-6; width /= 2) ++halvings;
  const auto bracket =
      contact::bisected<double>([](double t) { return t < 0.01; }, {0, 1.0 / 60, 0}, 1e-6);
  return bracket.tests == halvings ? static_cast<double>(halvings) : -1.0;
}

KEY("slices-for-a-pole") {
  // The smallest number of slices that finds the pole at every position.
  for (int slices = 1;; ++slices) {
    bool always = true;
    for (int place = 0; place < 450 && always; ++place) {
      const double front = place / 1000.0;
      const auto is_free = [front](double t) { return 30 * t < front || 30 * t > front + 0.05; };
      always = contact::last_free_slice<double>(is_free, 1.0 / 60, slices).has_value();
    }
    if (always) return static_cast<double>(slices);
  }
}

KEY("heavy-enough") {
  double low = 1;
  double high = 100;
  while (high - low > 1e-9) {
    const double middle = (low + high) / 2;
    (contact::collapses(1.0, middle, 0.5) ? high : low) = middle;
  }
  return high;
}

KEY("verlet-flies") {
  swing::Input state{{1.2, 0}, 2.4, 2};
  const double winning = swing::compute(state).flies_away;
  state.step = 1.9;
  return questions::Construct{winning, swing::compute(state).flies_away};
}

KEY("five-impacts") {
  walls::Input state{{2.5, 0.5}, {-2.5, 0.5}, {0.05, 3.2}, 3.6, 1, 16, 0};
  const double winning = walls::compute(state).five;
  state.most = 4;
  return questions::Construct{winning, walls::compute(state).five};
}

KEY("no-end") {
  squeeze::Input state{0.8, 1.8, 5, 0.3, 0.1};
  const double winning = squeeze::compute(state).stubborn;
  state.ratio = 1;
  return questions::Construct{winning, squeeze::compute(state).stubborn};
}

}  // namespace questions_test
