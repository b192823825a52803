#include "support/questions.hpp"

#include <algorithm>
#include <cmath>
#include <contact/bouncing.hpp>
#include <contact/fixed_step_bounce.hpp>
#include <contact/rebound_angle.hpp>
#include <contact/restitution.hpp>
#include <contact/stacked_drop.hpp>
#include <set>

#define CONTACT_FIGURE_NO_MAIN
#include <contact/figure.hpp>
namespace rebound {
#include "figures/rebound.cpp"
}
namespace zeno {
#include "figures/zeno.cpp"
}
namespace steps {
#include "figures/steps.cpp"
}

namespace questions_test {

using Vector = contact::Vector3<double>;
using contact::StepRule;

KEY("oblique-bounce") {
  return contact::after_bounce<double>(Vector(3, 0, -4), Vector(0, 0, 1), 0.5).norm();
}

KEY("moving-away") {
  const Vector n(0, 0, 1);
  const Vector up = contact::after_bounce<double>(Vector(0, 0, -4), n, 0.5);
  // The formula without the test for approach.
  const double again = (up - 1.5 * up.dot(n) * n).z();
  return again == up.z() ? 0 : again > up.z() ? 1 : again < 0 ? 2 : 3;
}

KEY("angle-without-friction") {
  const Vector n(0, 0, 1);
  const Vector after = contact::after_bounce<double>(Vector(1, 0, -1), n, 0.5);
  return contact::degrees(contact::angle_from_normal(after, n));
}

KEY("k-of-a-drop") { return contact::restitution_from_heights(1.0, 0.49); }

KEY("property-of-what") {
  // Newton's coefficient is a ratio of two speeds of two bodies: at least the other body, and the
  // speed, are missing from "steel".
  const double of_one_pair = contact::restitution_from_speeds(1.0, 0.9);
  const double of_another = contact::restitution_from_speeds(1.0, 0.1);
  return of_one_pair == of_another ? 0 : 2;
}

KEY("end-of-the-bounces") {
  return contact::rest_time(contact::bouncing_ball(1.0, 0.0, 8.0, 0.8));  // falls for 0.5 s
}

KEY("rest-speed-for-a-millimetre") { return contact::rest_speed(0.001, 9.81); }

KEY("which-velocity") {
  // Whether a ball that leaves the floor with this speed rises higher than it was.
  const auto ball = contact::bouncing_ball(0.05, -4.0, 9.81, 1.0);
  const double before = 4.0 * 4.0 / 2 + 9.81 * 0.05;
  const auto gains = [before](double speed) { return speed * speed / 2 > before * (1 + 1e-12); };
  const double end = std::abs(ball.velocity - ball.gravity / 60);
  return questions::Claim{gains(end), gains(contact::impact_speed(ball))};
}

KEY("order-of-a-step") {
  // The prerequisites of each piece of work.
  const std::vector<std::set<int>> needs{{3}, {}, {0, 5}, {1, 4}, {1}, {0}};
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

KEY("ball-on-ball") {
  const double ratio = contact::drop_stacked(1e9, 1.0, 1.0, 1.0, 1.0).upper;
  // Nothing is lost, so they approach as fast as they separate.
  const double lower = contact::drop_stacked(1e9, 1.0, 1.0, 1.0, 1.0).lower;
  return questions::Gaps{{"meet", ratio - lower}, {"leave", ratio}, {"height", ratio * ratio}};
}

KEY("right-angle") {
  rebound::Input state{{-4 * std::sqrt(0.5), 4}, {0, 2}, 0.5, 0, 0, 0};
  const double winning = rebound::compute(state).right_angle;
  state.k = 0.8;
  return questions::Construct{winning, rebound::compute(state).right_angle};
}

KEY("over-after-three") {
  zeno::Input state{1, 0, 9.81, 0, 0, 0};
  // (1 + k)/(1 − k) = 3 s / T₁
  const double ratio = 3 / contact::first_impact_time(contact::bouncing_ball(1.0, 0.0, 9.81, 0.5));
  const double restitution = (ratio - 1) / (ratio + 1);
  state.rebound = restitution * restitution;
  const double winning = zeno::compute(state).ends_at_three;
  state.rebound = 0.8;
  return questions::Construct{winning, zeno::compute(state).ends_at_three};
}

KEY("higher-than-dropped") {
  steps::Input state{1.2, 0.05, 1, 3};
  const double winning = steps::compute(state).gains;
  state.rule = 4;
  return questions::Construct{winning, steps::compute(state).gains};
}

}  // namespace questions_test
