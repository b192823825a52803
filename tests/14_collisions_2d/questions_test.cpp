#include "support/questions.hpp"

#include <algorithm>
#include <cmath>
#include <contact/billiard_table.hpp>
#include <contact/collision_1d.hpp>
#include <contact/disc_collision.hpp>
#include <contact/disc_events.hpp>
#include <contact/impulse.hpp>
#include <contact/momentum.hpp>
#include <contact/momentum_triangle.hpp>
#include <contact/pieces.hpp>
#include <numbers>
#include <set>

#define CONTACT_FIGURE_NO_MAIN
#include <contact/figure.hpp>
namespace two_discs {
#include "figures/two_discs.cpp"
}
namespace table {
#include "figures/table.cpp"
}

namespace questions_test {

using Vector = contact::Vector2<double>;
using Disc = contact::Disc<double>;

constexpr double degree = std::numbers::pi / 180;

Vector direction(double degrees) {
  return {std::cos(degrees * degree), std::sin(degrees * degree)};
}

KEY("tangential-component") {
  return contact::components<double>({5, 0}, {0.6, 0.8}).tangential.norm();
}

KEY("which-pair-pushes") {
  const std::vector<std::pair<Vector, Vector>> velocities{
      {{-1, 0}, {1, 0}}, {{2, 0}, {3, -5}}, {{-2, 1}, {-3, 0}}, {{0, 4}, {0, -4}}};
  int pushes = -1;
  for (int i = 0; i < 4; ++i) {
    const auto& [a, b] = velocities[static_cast<std::size_t>(i)];
    if (!contact::approaching(Disc{1, 0.5, {-1, 0}, a}, Disc{1, 0.5, {0, 0}, b})) continue;
    if (pushes >= 0) return -1;  // two right answers would be no question
    pushes = i;
  }
  return pushes;
}

KEY("response-steps") {
  // The prerequisites of each step; the test for approach has none and comes first.
  const std::vector<std::set<int>> needs{{2}, {4}, {3}, {1}, {}};
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

KEY("ball-b-leaves") {
  return contact::collide_discs(Disc{1, 0.5, {0, 0}, {20, 0}}, Disc{1, 0.5, direction(40), {0, 0}},
                                1.0)
      .velocity_b.norm();
}

KEY("a-stops-dead") {
  two_discs::Input state{{-1, 0}, {1, 0}, {3, 0}, {0, 0}, 1, 1, 1, 0};
  const double winning = two_discs::compute(state).a_stops;
  state.velocity_a = Vector(3, 0.5);
  return questions::Construct{winning, two_discs::compute(state).a_stops};
}

KEY("keeps-the-right-angle") {
  const auto product = [](double mass_b, const Vector& velocity_a, const Vector& centre_b, double e,
                          const Vector& velocity_b) {
    const auto after = contact::collide_discs(Disc{1, 0.5, {0, 0}, velocity_a},
                                              Disc{mass_b, 0.5, centre_b, velocity_b}, e);
    return std::abs(after.velocity_a.dot(after.velocity_b));
  };
  const std::vector<double> products{
      product(2, {2, 0}, {0.8, 0.6}, 1, {0, 0}), product(1, {4, 0}, {0.6, 0.8}, 1, {0, 0}),
      product(1, {2, 0}, {0.8, 0.6}, 0.9, {0, 0}), product(1, {2, 0}, {0.8, 0.6}, 1, {0.5, 0})};
  const auto right = [](double x) { return x < 1e-12; };
  if (std::count_if(products.begin(), products.end(), right) != 1) return -1;
  return static_cast<int>(std::find_if(products.begin(), products.end(), right) - products.begin());
}

KEY("the-other-angle") {
  const auto after = contact::collide_discs(Disc{1, 0.5, {0, 0}, {3, 0}},
                                            Disc{1, 0.5, direction(35), {0, 0}}, 1.0);
  return -std::atan2(after.velocity_a.y(), after.velocity_a.x()) / degree;
}

KEY("share-of-a") {
  return contact::share_momentum<double>({10, 0}, direction(30), direction(-35))->a.norm();
}

KEY("speed-of-the-wreck") {
  const contact::PointMass<double> car{1500, {0, 0, 0}, {16, 0, 0}};
  const contact::PointMass<double> van{2000, {0, 0, 0}, {0, 9, 0}};
  const auto velocity = *contact::centre_velocity<double>({car, van});
  return questions::Gaps{{"car", contact::total_momentum<double>({car}).norm()},
                         {"van", contact::total_momentum<double>({van}).norm()},
                         {"whole", contact::total_momentum<double>({car, van}).norm()},
                         {"speed", velocity.norm()},
                         {"angle", std::atan2(velocity.y(), velocity.x()) / degree}};
}

KEY("how-fast-was-a") {
  // The momentum of b is the component of the whole along b's direction; the rest is that of a.
  const double along = 1400 * 15;
  const Vector whole = direction(25) * (along / direction(25).x());
  return contact::share_momentum<double>(whole, {1, 0}, {0, 1})->b.norm() / 1000;
}

KEY("share-of-alpha") {
  const auto after = contact::fly_apart<double>(206, 4, {0, 0, 0}, 1, {1, 0, 0});
  const double alpha = 4 * after.second.squaredNorm() / 2;
  const double rest = 206 * after.first.squaredNorm() / 2;
  return 100 * alpha / (alpha + rest);
}

KEY("force-of-the-wall") {
  const Vector before(-10 * std::sin(60 * degree), 10 * std::cos(60 * degree));
  const Vector after = contact::off_cushion<double>(before, {1, 0}, 1.0);
  return contact::impulse_of_change<double>(3, {before.x(), before.y(), 0},
                                            {after.x(), after.y(), 0})
             .norm() /
         0.2;
}

KEY("time-of-the-touch") {
  return *contact::time_to_touch(Disc{1, 0.5, {-3, 0.6}, {1, 0}}, Disc{1, 0.5, {0, 0}, {0, 0}});
}

KEY("predict-the-cushion") {
  table::Input state{{0.25, 0.4}, {0.9, 0.65}, {1.25, 1.3}, {0.9, 0.2}, {1.2, 0.9}, 0, 1, 0, 1};
  const Vector position = table::compute(state).b_at_cushion;
  state.show = 0;
  state.guess = position + Vector(0.05, 0);
  const double winning = table::compute(state).guessed_unseen;
  state.guess = position + Vector(0, 0.2);
  return questions::Construct{winning, table::compute(state).guessed_unseen};
}

KEY("why-right-angle") {
  const auto right = [](double e) {
    const auto after =
        contact::collide_discs(Disc{1, 0.5, {0, 0}, {2, 0}}, Disc{1, 0.5, {0.8, 0.6}, {0, 0}}, e);
    return std::abs(after.velocity_a.dot(after.velocity_b)) < 1e-12;
  };
  return questions::Claim{right(1), right(0.9)};
}

}  // namespace questions_test
