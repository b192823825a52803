#include "support/questions.hpp"

#include <algorithm>
#include <cmath>
#include <contact/block_count.hpp>
#include <contact/collision_1d.hpp>
#include <contact/cradle.hpp>
#include <set>

#define CONTACT_FIGURE_NO_MAIN
#include <contact/figure.hpp>
namespace head_on {
#include "figures/head_on.cpp"
}
namespace cradle {
#include "figures/cradle.cpp"
}

namespace questions_test {

using contact::line_body;

KEY("truck-elastic") {
  return contact::collide(line_body(3000.0, 20.0), line_body(1000.0, 0.0), 1.0).second;
}

KEY("same-velocity") {
  const auto after = contact::collide(line_body(3000.0, 20.0), line_body(1000.0, 0.0), 0.0);
  return after.first == 15 && after.second == 15 ? 1 : 2;
}

KEY("energy-of-half") {
  const auto first = line_body(2.0, 3.0);
  return contact::energy_lost(first, line_body(2.0, 0.0), 0.5) / contact::kinetic_energy(first);
}

KEY("loss-from-train") {
  const double here = contact::energy_lost(line_body(2.0, 3.0), line_body(1.0, -1.0), 0.5);
  const double train = contact::energy_lost(line_body(2.0, 33.0), line_body(1.0, 29.0), 0.5);
  return train > here ? 0 : train == here ? 1 : 2;
}

KEY("ball-and-lorry") {
  const auto wall = line_body(std::numeric_limits<double>::infinity(), -15.0);
  return std::abs(contact::collide(line_body(0.5, 10.0), wall, 1.0).first);
}

KEY("do-they-collide") {
  return contact::approaching(line_body(1.0, -3.0), line_body(1.0, -2.0)) ? 0 : 1;
}

KEY("cradle-two") {
  // Springs conserve momentum and energy as pairs do, with another result: two equations do not
  // determine it.
  const std::vector<contact::LineBody<double>> row{{1, 1}, {1, 1}, {1, 0}, {1, 0}, {1, 0}};
  const auto pairs = contact::collide_row(row, 1.0, contact::PairOrder::fastest_first, 100);
  const auto springs = contact::row_on_springs(row, contact::ContactSpring::linear, 2000);
  const bool two_leave = pairs.velocities == std::vector<double>{0, 0, 0, 1, 1};
  double energy = 0;
  double momentum = 0;
  double difference = 0;
  for (std::size_t i = 0; i < row.size(); ++i) {
    energy += springs.velocities[i] * springs.velocities[i];
    momentum += springs.velocities[i];
    difference = std::max(difference, std::abs(springs.velocities[i] - pairs.velocities[i]));
  }
  const bool both_conserved = std::abs(energy - 2) < 1e-3 && std::abs(momentum - 2) < 1e-9;
  return two_leave && both_conserved && difference > 0.05 ? 2 : 1;
}

KEY("derivation-steps") {
  // The steps that must come before each step; the momentum equation is written first.
  const std::vector<std::set<int>> needs{{1, 3}, {}, {0}, {1}};
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

KEY("where-digits-go") {
  // The relative change of a velocity near 0 if the input changes by an ulp.
  const auto stopped = [](double v2) {
    return contact::collide_exactly(line_body(0.3, 1.0), line_body(1.0, v2), 0.3).first;
  };
  const double here = stopped(0);
  const double beside = stopped(-0x1p-53);
  return std::abs(beside - here) > std::abs(here) ? 1 : 0;
}

KEY("clicks-of-100") { return static_cast<double>(*contact::count_collisions(100)); }

KEY("stop-the-first") {
  head_on::Input state{30, 60, 2, 0, 0.5, 1, 0.5};
  const double winning = head_on::compute(state).first_stops;
  state.mass_1 = state.mass_2 = 60;
  state.e = 1;
  return questions::Construct{winning, head_on::compute(state).first_stops};
}

KEY("order-decides") {
  cradle::Input state{2, 0, 0, 0, -1, 4, 0.5, 0};
  const double winning = cradle::compute(state).order_matters;
  state.middle = 1;
  state.e = 1;
  return questions::Construct{winning, cradle::compute(state).order_matters};
}

KEY("truck-half") {
  const auto truck = line_body(3000.0, 20.0);
  const auto car = line_body(1000.0, 0.0);
  const auto after = contact::collide(truck, car, 0.5);
  return questions::Gaps{{"common", contact::collide(truck, car, 0.0).first},
                         {"apart", after.second - after.first},
                         {"truck", after.first},
                         {"car", after.second}};
}

KEY("why-same-loss") {
  // Two observers, the second in a train: the loss, and the energy itself.
  const auto first = line_body(2.0, 3.0), second = line_body(1.0, -1.0);
  const auto first_seen = line_body(2.0, 33.0), second_seen = line_body(1.0, 29.0);
  return questions::Claim{contact::energy_lost(first, second, 0.5) ==
                              contact::energy_lost(first_seen, second_seen, 0.5),
                          contact::kinetic_energy(first) == contact::kinetic_energy(first_seen)};
}

}  // namespace questions_test
