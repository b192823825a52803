#include "support/questions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <contact/bounce_energy.hpp>
#include <contact/hertz.hpp>
#include <contact/hunt_crossley.hpp>
#include <contact/penalty_force.hpp>
#include <contact/penalty_step.hpp>
#include <contact/soft_to_rigid.hpp>
#include <contact/spring_impact.hpp>
#include <contact/spring_stack.hpp>
#include <contact/squash.hpp>
#include <limits>
#include <vector>

#define CONTACT_FIGURE_NO_MAIN
#include <contact/figure.hpp>
namespace questions_test {

namespace soft_to_rigid {
#include "figures/soft_to_rigid.cpp"
}
namespace step_and_energy {
#include "figures/step_and_energy.cpp"
}

namespace {

using contact::ContactRelease;
using contact::PenaltyScheme;
using contact::SpringDamper;

constexpr SpringDamper<double> two_thousand{2000, 30};

double limit_of(double stiffness, double mass) {
  return contact::step_limit(PenaltyScheme::semi_implicit_euler, SpringDamper<double>{stiffness, 0},
                             mass);
}

contact::SpringStack<double> equal_boxes(std::size_t count, double mass, double stiffness) {
  return contact::spring_stack(std::vector<double>(count, mass),
                               std::vector<double>(count, stiffness));
}

}  // namespace

KEY("force-in-approach") { return contact::contact_force(two_thousand, 0.005, 0.4); }

KEY("when-it-pulls") {
  double low = 0, high = 10;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    const double force =
        contact::contact_force(two_thousand, 0.005, -middle, ContactRelease::at_zero_penetration);
    (force > 0 ? low : high) = middle;
  }
  return high;
}

KEY("find-a-pull") {
  soft_to_rigid::Input state{0.1, 0.5, 0.25, 1};
  const double winning = soft_to_rigid::compute(state).pulled;
  state.release = 0;
  return questions::Construct{winning, soft_to_rigid::compute(state).pulled};
}

KEY("area-of-a-harder-contact") {
  const auto soft = contact::spring_for_restitution(1e3, 0.5, 4.0 / 6);
  const double area = contact::contact_impulse(soft, 0.5, 6.0);
  CHECK(std::abs(area - 5) < 1e-12);
  return contact::contact_impulse(contact::stiffened(soft, 10.0), 0.5, 6.0);
}

KEY("hundred-times-stiffer") {
  const SpringDamper<double> soft{1e4, 0};
  CHECK(std::abs(contact::spring_impact(soft, 1.0, 1.0).duration - 0.0314) < 1e-4);
  return 1000 * contact::spring_impact(contact::stiffened(soft, 10.0), 1.0, 1.0).duration;
}

KEY("find-a-hard-bounce") {
  soft_to_rigid::Input state{0.8, 0.05, 0, 0};
  const double winning = soft_to_rigid::compute(state).hard_bounce;
  state.hardness = 0.1;
  return questions::Construct{winning, soft_to_rigid::compute(state).hard_bounce};
}

KEY("duration-of-a-contact") {
  return 1000 * contact::spring_impact(SpringDamper<double>{20000, 0}, 2.0, 3.0).duration;
}

KEY("damper-for-a-half") {
  return contact::damping_ratio_for(0.5, ContactRelease::at_zero_penetration);
}

KEY("stiffness-for-a-centimetre") { return contact::stiffness_for_depth<double>(2, 3, 9.81, 0.01); }

KEY("let-go-at-the-surface") {
  // The step is so short that the greatest overlap is found to a millionth.
  const SpringDamper<double> spring{9810, 0};
  double deepest = 0;
  for (double t = 0; t < 0.1; t += 1e-5) {
    const auto state = contact::damped_motion<double>({0, 0}, spring, 1, 9.81, t);
    deepest = std::fmax(deepest, state.penetration);
  }
  return 1000 * deepest;
}

KEY("longest-step") { return 1000 * limit_of(40000, 1); }

KEY("find-a-gain") {
  step_and_energy::Input state{0.06, 1000, 0, 1, 0.05};
  const double winning = step_and_energy::compute(state).gains;
  state.step = 0.005;
  return questions::Construct{winning, step_and_energy::compute(state).gains};
}

KEY("steps-for-a-percent") {
  const SpringDamper<double> spring{1, 0};
  const double h = contact::step_for_energy(spring, 1.0, 0.01);
  CHECK(std::abs(contact::bounce_energy_factor(spring, 1.0, h).max - 1.01) < 1e-12);
  return contact::spring_impact(spring, 1.0, 1.0).duration / h;
}

KEY("find-a-loss") {
  step_and_energy::Input state{0.02, 1000, 0, 3, 0.5};
  const double winning = step_and_energy::compute(state).damps_itself;
  state.scheme = 1;
  return questions::Construct{winning, step_and_energy::compute(state).damps_itself};
}

KEY("sag-of-the-lowest") {
  return 1000 * contact::stack_sag(equal_boxes(10, 2, 20000), 9.81).front();
}

KEY("step-of-two-boxes") {
  CHECK(std::abs(limit_of(1e4, 1) - 0.02) < 1e-12);
  return 1000 * contact::stack_step_limit(equal_boxes(2, 1, 1e4));
}

KEY("thirty-two-times-faster") {
  const auto steel = contact::hertz_contact(1e10);
  return 0.1 * contact::hertz_impact(steel, 1.0, 32.0).duration /
         contact::hertz_impact(steel, 1.0, 1.0).duration;
}

KEY("slow-impact") {
  return contact::hunt_crossley_restitution(contact::hunt_crossley(1.0, 0.1), 0.3);
}

}  // namespace questions_test
