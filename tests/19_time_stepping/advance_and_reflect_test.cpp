// Named tests use exactly representable numbers. Random rooms are boxes with k = 1, in which each
// coordinate is a folded straight line: a computation without impacts. Every test asks for at least
// two different answers, so that no constant passes.
#include "advance_and_reflect.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>

namespace {

using namespace contact::testing;
using exercise::Ball;
using exercise::Wall;
using Vector = Eigen::Vector3d;

/// The loop, right and with each of its usual mistakes.
enum class Way { right, one_impact, rest_lost, point, last_wall, fraction };

Ball advanced(const Ball& ball, const std::vector<Wall>& walls, double k, double step, Way way) {
  Ball now = ball;
  for (int turns = 0; turns < 1000; ++turns) {
    double first = std::numeric_limits<double>::infinity();
    const Wall* met = nullptr;
    for (const Wall& wall : walls) {
      const double gap =
          wall.normal.dot(now.centre) - wall.offset - (way == Way::point ? 0 : ball.radius);
      const double rate = wall.normal.dot(now.velocity);
      if (rate >= 0) continue;
      double time = std::max(0.0, gap) / -rate;
      if (way == Way::fraction) time /= step;
      if (way == Way::last_wall ? time <= step : time < first) {
        first = time;
        met = &wall;
      }
    }
    if (met == nullptr || first > (way == Way::fraction ? 1 : step)) break;
    if (way == Way::one_impact && turns > 0) break;
    now.centre += now.velocity * first;
    now.velocity -= (1 + k) * met->normal.dot(now.velocity) * met->normal;
    ++now.impacts;
    step -= way == Way::fraction ? first * step : first;
    if (way == Way::rest_lost) return now;
  }
  now.centre += now.velocity * step;
  return now;
}

void check(const Ball& ball, const std::vector<Wall>& walls, double k, double step,
           const Ball& right, double room) {
  ask("Where is the ball one step later?")
      .given("ball", ball)
      .given("walls", walls)
      .given("k", k)
      .given("step", step)
      .suspect("rest-of-step-lost", [&] { return advanced(ball, walls, k, step, Way::rest_lost); })
      .suspect("one-impact-a-step", [&] { return advanced(ball, walls, k, step, Way::one_impact); })
      .suspect_if("bounce-when-separating",
                  [&](const Ball& got) {
                    // Only where the ball leaves the one wall from the start: elsewhere a wall that
                    // reflects again and again may be one that reverses no velocity.
                    return walls.size() == 1 && got.impacts > ball.impacts &&
                           walls[0].normal.dot(ball.centre) - ball.radius <= walls[0].offset &&
                           walls[0].normal.dot(ball.velocity) > 0;
                  })
      .suspect_if("no-wall-found",
                  [&](const Ball& got) {
                    return got.impacts == ball.impacts &&
                           std::any_of(walls.begin(), walls.end(), [&](const Wall& wall) {
                             return wall.normal.dot(got.centre) < wall.offset - 1e-9;
                           });
                  })
      .suspect("sphere-as-point", [&] { return advanced(ball, walls, k, step, Way::point); })
      .suspect("last-wall-of-the-list",
               [&] { return advanced(ball, walls, k, step, Way::last_wall); })
      .suspect("fraction-for-time", [&] { return advanced(ball, walls, k, step, Way::fraction); })
      .answer([&] { return exercise::advance(ball, walls, k, step); })
      .close_to(right, within(room));
}

void check_exact(const Ball& ball, const std::vector<Wall>& walls, double k, double step) {
  check(ball, walls, k, step, advanced(ball, walls, k, step, Way::right), 0x1p-40);
}

const Wall floor_wall{Vector(0, 0, 1), 0};
const Wall left{Vector(1, 0, 0), 0};
const Wall right_wall{Vector(-1, 0, 0), -1};

}  // namespace

TEST_CASE("a step without an impact") {
  check_exact({Vector(0, 0, 2), Vector(1, 0, -1), 0, 3}, {floor_wall}, 1, 0.5);
  check_exact({Vector(0, 0, 2), Vector(1, 2, 4), 0, 0}, {floor_wall}, 0.5, 2);
  check_exact({Vector(0, 0, 2), Vector(1, 2, 0), 0, 0}, {floor_wall}, 0.5, 2);
  check_exact({Vector(0, 0, 0), Vector(1, 0, 2), 0, 0}, {floor_wall}, 0.5, 1);
}

TEST_CASE("an impact after half of the step") {
  // The lecture's numbers: a step of one second, the impact after half of it.
  check_exact({Vector(0, 0, 0.5), Vector(0, 0, -1), 0, 0}, {floor_wall}, 1, 1);
  check_exact({Vector(0, 0, 1), Vector(1, 0, -4), 0, 2}, {floor_wall}, 0.5, 0.75);
  check_exact({Vector(0, 0, 1), Vector(1, 0, -4), 0, 2}, {floor_wall}, 0.5, 0.25);
}

TEST_CASE("several impacts in one step") {
  check_exact({Vector(0.5, 0, 0), Vector(4, 0, 0), 0, 0}, {left, right_wall}, 1, 1);
  check_exact({Vector(0.5, 0, 0), Vector(4, 0, 0), 0, 0}, {left, right_wall}, 0.5, 2.5);
  check_exact({Vector(0.5, 0, 1), Vector(8, 0, -1), 0, 0}, {left, right_wall, floor_wall}, 1, 1.25);
}

TEST_CASE("the nearest wall comes first") {
  const Wall far{Vector(-1, 0, 0), -2};
  check_exact({Vector(0.75, 0, 0), Vector(4, 0, 0), 0, 0}, {left, right_wall, far}, 1, 0.5);
  check_exact({Vector(0.25, 0, 0), Vector(4, 0, 0), 0, 0}, {far, right_wall, left, far}, 1, 0.625);
}

TEST_CASE("a ball that touches a wall and moves away is not reflected") {
  check_exact({Vector(0, 0, 0), Vector(1, 0, 2), 0, 0}, {floor_wall}, 0.5, 1);
  check_exact({Vector(0, 0, 0), Vector(1, 0, 0), 0, 0}, {floor_wall}, 0.5, 1);
  check_exact({Vector(0, 0, 0), Vector(1, 0, -2), 0, 0}, {floor_wall}, 0.5, 1);
}

TEST_CASE("the radius of the ball counts") {
  check_exact({Vector(0, 0, 1), Vector(0, 0, -2), 0.25, 0}, {floor_wall}, 1, 1);
  check_exact({Vector(0.5, 0, 0), Vector(2, 0, 0), 0.25, 0}, {left, right_wall}, 1, 0.75);
}

TEST_CASE("random rooms agree with mirror images") {
  generators::Random random(seed(0));
  for (int asked = 0; asked < 200; ++asked) {
    const double radius = random.uniform(0.05, 0.2);
    std::vector<Wall> walls;
    Vector size;
    Ball ball{Vector::Zero(), Vector::Zero(), radius, 0};
    const double step = random.uniform(0.2, 1.5);
    Ball right = ball;
    bool close = false;
    for (int i = 0; i < 3; ++i) {
      size(i) = random.uniform(1, 3);
      ball.centre(i) = random.uniform(radius + 0.01, size(i) - radius - 0.01);
      ball.velocity(i) = random.uniform(-6, 6);
      Vector normal = Vector::Zero();
      normal(i) = 1;
      walls.push_back({normal, 0});
      walls.push_back({-normal, -size(i)});
      // The position on a straight line, folded back at the mirrors.
      const double length = size(i) - 2 * radius;
      const double position = ball.centre(i) - radius + ball.velocity(i) * step;
      const double turns = std::floor(position / length);
      const double rest = position - turns * length;
      const bool odd = std::fmod(std::abs(turns), 2) == 1;
      right.centre(i) = radius + (odd ? length - rest : rest);
      right.velocity(i) = odd ? -ball.velocity(i) : ball.velocity(i);
      right.impacts += static_cast<int>(std::abs(turns));
      close = close || rest < 1e-9 || length - rest < 1e-9;
    }
    if (close) continue;
    // About thirty impacts, each with a few roundings of numbers below 10.
    check(ball, walls, 1, step, right, 1e-11);
  }
}
