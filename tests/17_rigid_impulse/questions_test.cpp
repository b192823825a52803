#include "support/questions.hpp"

#include <algorithm>
#include <cmath>
#include <contact/impact_friction.hpp>
#include <contact/rigid_impulse.hpp>
#include <contact/rotation.hpp>
#include <set>

#define CONTACT_FIGURE_NO_MAIN
#include <contact/figure.hpp>
namespace hit_rod {
#include "figures/hit_rod.cpp"
}
namespace rough_floor {
#include "figures/rough_floor.cpp"
}

namespace questions_test {

using V = contact::Vector3<double>;
using M = contact::Matrix3<double>;

namespace {

const V none(0, 0, 0);

contact::RigidBody<double> rod_on_ice() {
  return contact::rigid_body<double>(3, contact::detail::diagonal<double>(1, 1, 1), none, none,
                                     none);
}

double end_impulse(double e) {
  const auto ball = contact::rigid_body<double>(1, contact::sphere_inertia<double>(1, 0.1),
                                                {1, -0.1, 0}, {0, 4, 0}, none);
  return contact::collision_impulse<double>(rod_on_ice(), ball, {{1, 0, 0}, {0, 1, 0}}, e);
}

}  // namespace

KEY("top-of-the-wheel") {
  const double radius = 0.3;
  // Rolling: the point on the road is at rest, so 30 m/s = spin · radius.
  const auto wheel =
      contact::rigid_body<double>(10, contact::cylinder_inertia<double>(10, 0.3, 0.2),
                                  {0, 0, radius}, {30, 0, 0}, {0, 30 / radius, 0});
  if (std::abs(contact::velocity_at(wheel, none).x()) > 1e-9) return -1.0;
  return contact::velocity_at(wheel, V(0, 0, 2 * radius)).x();
}

KEY("rising-and-closing") {
  // Seen from the front (−y), x to the right and z up: clockwise is an angular velocity along +y.
  const auto closes = [](double angular_velocity) {
    const auto plank =
        contact::rigid_body<double>(6, contact::box_inertia<double>(6, {2, 0.2, 0.1}), none,
                                    {0, 0, 1}, {0, angular_velocity, 0});
    const auto ground = contact::immovable<double>({0, 0, -1}, none, none);
    const auto found = contact::closing_case(plank, ground, {{1, 0, 0}, {0, 0, 1}});
    return found != contact::Closing::separating && found != contact::Closing::touching;
  };
  return questions::Claim{closes(2), closes(0)};
}

KEY("end-against-middle") {
  const double middle = 3.0 * 2 * 2 / 12;
  const double added = contact::parallel_axis<double>(3, V(1, 0, 0))(2, 2);
  return questions::Gaps{{"middle", middle}, {"added", added}, {"end", middle + added}};
}

KEY("which-tensor") {
  M quarter;  // by 90° about z
  quarter << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  const V moments(1, 4, 5);
  const auto plank = contact::rigid_body_from_axes<double>(1, moments, quarter, none, none, none);
  return V(plank.inverse_inertia * V(1, 0, 0)).x();
}

KEY("middle-or-end") { return end_impulse(0.5); }

KEY("impulse-steps") {
  const std::vector<std::set<int>> needs{{3}, {4}, {0}, {5}, {}, {1}};
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

KEY("spare-the-hand") {
  hit_rod::Input state{0.33, 3, 1, 4, 0.5, 0.4, 1, 0};
  const double winning = hit_rod::compute(state).grip_at_rest;
  state.at = 0.4;
  return questions::Construct{winning, hit_rod::compute(state).grip_at_rest};
}

KEY("lawful-gain") {
  const contact::PlanarContact<double> rod{-0.6, -1, 2.5, 1.5, 2.5};
  const auto newton = contact::newton_impact(rod, 1.0, 0.5);
  const auto stronge = contact::stronge_impact(rod, 1.0, 0.5);
  const auto joint = contact::joint_impact(rod, 1.0, 0.5);
  if (contact::energy_change(newton) <= 0 || contact::energy_change(stronge) > 0) return -1;
  // The joint law gains more than Newton's law.
  if (!joint || contact::energy_change(*joint) <= contact::energy_change(newton)) return -1;
  return 1;
}

KEY("make-energy") {
  rough_floor::Input state{{-1.41421356, 1.41421356}, {-0.6, -1}, -1, 0.5, 1, 3};
  const double winning = rough_floor::compute(state).gains;
  state.law = 2;
  return questions::Construct{winning, rough_floor::compute(state).gains};
}

KEY("missed-e") {
  const contact::PlanarContact<double> rod{-0.6, -1, 2.5, 1.5, 2.5};
  const auto clamped = contact::clamped_impact(rod, 1.0, 0.5);
  if (std::abs(clamped.path[1].normal - 1) > 1e-12) return -1.0;
  if (std::abs(clamped.end().tangential + 0.24) > 1e-12) return -1.0;
  return clamped.end().normal;
}

KEY("growing-matrix") {
  M r = M::Identity();
  for (int step = 0; step < 600; ++step) {
    r = contact::matrix_step<double>(r, V(0, 0, 3), 1.0 / 60);
  }
  return V(r.col(0)).norm();
}

}  // namespace questions_test
