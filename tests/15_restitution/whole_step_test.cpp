// Named tests use exact times and speeds, so that an impact can be exactly at the end of a step.
// The long step is tested where no impact and no rest is close. Every test asks for at least two
// different answers, so that no constant passes one.
#include "whole_step.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>

namespace {

using namespace contact::testing;
using exercise::Ball;

struct Asked {
  Ball ball;
  double gravity, k, rest_speed, step;
};

/// The variations of the step: the solution, and the wrong answers of the misconceptions.
enum class Way { right, end_velocity, one_impact, rest_lost, incoming };

Ball stepped(const Asked& q, Way way) {
  Ball now = q.ball;
  double step = q.step;
  for (int impacts = 0; !now.resting && impacts < 100000; ++impacts) {
    const double speed = std::sqrt(now.velocity * now.velocity + 2 * q.gravity * now.height);
    const double until = now.velocity > 0 ? (now.velocity + speed) / q.gravity
                                          : 2 * now.height / (speed - now.velocity);
    if (until > step || (way == Way::one_impact && impacts > 0)) {
      now.height = std::max(0.0, now.height + (now.velocity - q.gravity * step / 2) * step);
      now.velocity -= q.gravity * step;
      break;
    }
    const double leaving =
        q.k * (way == Way::end_velocity ? q.gravity * step - now.velocity : speed);
    step -= until;
    ++now.bounces;
    now.height = 0;
    now.velocity = leaving;
    if ((way == Way::incoming ? speed : leaving) <= q.rest_speed) {
      now.velocity = 0;
      now.resting = true;
    }
    if (way == Way::rest_lost) break;
  }
  return now;
}

void check(const Asked& q, double room) {
  const Ball right = stepped(q, Way::right);
  ask("What is the state of the ball one step later?")
      .given("ball", q.ball)
      .given("gravity", q.gravity)
      .given("k", q.k)
      .given("rest_speed", q.rest_speed)
      .given("step", q.step)
      .suspect("end-of-step-velocity", [&] { return stepped(q, Way::end_velocity); })
      .suspect("one-impact-a-step", [&] { return stepped(q, Way::one_impact); })
      .suspect("rest-of-step-lost", [&] { return stepped(q, Way::rest_lost); })
      .suspect("rest-by-incoming-speed", [&] { return stepped(q, Way::incoming); })
      .suspect_if("more-impacts-than-fit",
                  [&](const Ball& got) {
                    const auto is = [&](Way way) {
                      const Ball wrong = stepped(q, way);
                      return got.bounces == wrong.bounces &&
                             std::abs(got.height - wrong.height) <= room;
                    };
                    return got.bounces > right.bounces && !is(Way::end_velocity) &&
                           !is(Way::one_impact) && !is(Way::rest_lost) && !is(Way::incoming);
                  })
      .answer([&] { return exercise::whole_step(q.ball, q.gravity, q.k, q.rest_speed, q.step); })
      .close_to(right, within(room));
}

/// For numbers whose times and speeds are exact: more than enough for rounding.
void check_exact(const Asked& q) { check(q, 0x1p-40); }

}  // namespace

TEST_CASE("a step in the air") {
  check_exact({{1, 0, 0, false}, 8, 0.5, 0.01, 0.25});
  check_exact({{1, 4, 3, false}, 8, 0.5, 0.01, 0.5});
  check_exact({{0, 4, 1, false}, 8, 0.5, 0.01, 0.25});
  check_exact({{0, 0, 7, true}, 8, 0.5, 0.01, 0.25});
}

TEST_CASE("a step with one impact") {
  check_exact({{1, 0, 0, false}, 8, 0.5, 0.01, 0.75});
  check_exact({{1, 0, 0, false}, 8, 1, 0.01, 0.625});
  check_exact({{0.4375, -3, 2, false}, 8, 0.5, 0.01, 0.25});
  check_exact({{1, 0, 0, false}, 8, 0.5, 0.01, 0.5});  // exactly at its end
}

TEST_CASE("a step with several impacts") {
  check_exact({{1, 0, 0, false}, 8, 0.5, 0.01, 1.125});
  check_exact({{1, 0, 0, false}, 8, 0.5, 0.01, 1.3125});
  check_exact({{1, 0, 0, false}, 8, 1, 0.01, 7.75});
}

TEST_CASE("the ball comes to rest") {
  check_exact({{1, 0, 0, false}, 8, 0.5, 1.5, 0.75});
  check_exact({{1, 0, 0, false}, 8, 0.5, 1.5, 2});  // leaves with 2, then with 1
  check_exact({{1, 0, 0, false}, 8, 0.5, 0.0625, 2});
  check_exact({{1, 0, 0, false}, 8, 0, 0.25, 1});
}

TEST_CASE("one long step is many short ones") {
  generators::Random random(seed(0));
  for (int asked = 0; asked < 250; ++asked) {
    Asked q{};
    q.ball = {random.uniform(0.1, 3), random.uniform(-4, 4), 0, false};
    q.gravity = random.uniform(4, 16);
    q.k = random.uniform(0.3, 0.9);
    q.rest_speed = random.uniform(0.05, 0.5);
    // Follow the impacts to a time well inside a flight, or well after the rest.
    double speed = std::sqrt(q.ball.velocity * q.ball.velocity + 2 * q.gravity * q.ball.height);
    double time = (q.ball.velocity + speed) / q.gravity;
    double flight = time;
    bool close = false;
    for (int impacts = random.integer(0, 12); impacts > 0; --impacts) {
      speed *= q.k;
      close = close || std::abs(speed - q.rest_speed) < 1e-6;
      if (speed <= q.rest_speed) break;
      flight = 2 * speed / q.gravity;
      time += flight;
    }
    if (close) continue;
    const double share = random.uniform(0.2, 0.8);
    q.step = speed <= q.rest_speed ? time + share : time - share * flight;
    // Thirteen flights with eight roundings of a time below 15 s, times a speed below 11 m/s or a
    // gravity below 16 m/s²: 3e-12.
    check(q, 1e-11);
  }
}
