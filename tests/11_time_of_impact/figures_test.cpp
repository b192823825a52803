// What the figures of the chapter draw: the starts from which slices miss a touch, the order of the
// methods' times, and that no advance of the rod passes its touch.
#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/conservative_advancement.hpp>
#include <contact/moving_spheres.hpp>
#include <contact/offset_plane.hpp>
#include <contact/sine_cosine.hpp>
#include <contact/sliced_steps.hpp>
#include <contact/sphere_capsule_impact.hpp>
#include <contact/swept_volumes.hpp>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "support/generators.hpp"

#define CONTACT_FIGURE_NO_MAIN
#include <contact/figure.hpp>
namespace bullet_and_plate {
#include "figures/bullet_and_plate.cpp"
}
namespace turning_rod {
#include "figures/turning_rod.cpp"
}

namespace {

using generators::Random;
using Point = contact::Vector2<double>;

Point anywhere(Random& random) { return {random.uniform(-5, 5), random.uniform(-2, 4)}; }

bullet_and_plate::Input shot(Random& random) {
  bullet_and_plate::Input in{};
  in.target = random.integer(0, 1);
  in.from = anywhere(random);
  in.to = anywhere(random);
  in.radius = random.uniform(0.05, 0.8);
  in.thickness = random.uniform(0.05, 2);
  in.other_from = anywhere(random);
  in.other_to = anywhere(random);
  in.other_radius = random.uniform(0.05, 0.8);
  in.slices = random.integer(1, 12);
  in.halvings = random.integer(0, 20);
  in.time = random.uniform();
  return in;
}

double distance_of_segment(const Point& p, const Point& a, const Point& b) {
  const Point along = b - a;
  const double square = along.squaredNorm();
  const double share = square > 0 ? std::clamp((p - a).dot(along) / square, 0.0, 1.0) : 0.0;
  return std::sqrt((p - a - share * along).squaredNorm());
}

enum class Where { inside, outside, near };

/// Where a point is in the outlines of the starts from which slices miss, by crossings of a ray.
Where in_missed_starts(const bullet_and_plate::Output& out, const Point& p, double near) {
  bool inside = false;
  for (int k = 0; k < int(out.slices); ++k) {
    for (std::size_t part = 0; part < std::size_t(out.parts); ++part) {
      std::vector<Point> outline;
      const auto &low = out.missed_low[part], &high = out.missed_high[part];
      for (const Point& q : low) outline.push_back(q + k * out.shift);
      for (std::size_t i = high.size(); i-- > 0;) outline.push_back(high[i] + k * out.shift);
      bool odd = false;
      for (std::size_t i = 0; i < outline.size(); ++i) {
        const Point &a = outline[i], &b = outline[(i + 1) % outline.size()];
        if (distance_of_segment(p, a, b) <= near) return Where::near;
        const bool above = a.y() > p.y(), then_above = b.y() > p.y();
        if (above == then_above) continue;
        const double x = a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
        if (x > p.x()) odd = !odd;
      }
      inside = inside || odd;
    }
  }
  return inside ? Where::inside : Where::outside;
}

turning_rod::Input turn(Random& random) {
  turning_rod::Input in{};
  in.target = random.integer(0, 1);
  in.from = {random.uniform(-4, 0), random.uniform(0, 4)};
  in.to = {random.uniform(-4, 4), random.uniform(0, 4)};
  in.angle = random.uniform(-180, 180);
  in.turns = random.uniform(-3, 3);
  in.wall = random.uniform(0, 4);
  in.disc = {random.uniform(0, 3), random.uniform(0, 4)};
  in.towards = random.integer(0, 1);
  in.exponent = random.integer(-3, -1);
  in.step = random.integer(1, 60);
  in.samples = random.integer(1, 30);
  return in;
}

}  // namespace

TEST_CASE("the figure colours the starts from which slices miss the touch, and no others") {
  Random random(1);
  int missed = 0, seen = 0;
  for (int i = 0; i < generators::tried(20000); ++i) {
    const bullet_and_plate::Input in = shot(random);
    const bullet_and_plate::Output out = bullet_and_plate::compute(in);
    REQUIRE(out.problem == 0);
    // Arcs are drawn as polygons, and their sagitta is less than this.
    const Where where = in_missed_starts(out, in.from, 0.02);
    if (where == Where::near) continue;
    INFO("shot " << i);
    CHECK((where == Where::inside) == (out.missed == 1));
    (out.missed == 1 ? missed : seen) += out.touches == 1 ? 1 : 0;
  }
  CHECK(missed > generators::tried(500));
  CHECK(seen > generators::tried(2000));
}

TEST_CASE("in the figure the exact time is between those of bisection, and slices are late") {
  Random random(2);
  int found = 0;
  for (int i = 0; i < generators::tried(20000); ++i) {
    const bullet_and_plate::Output out = bullet_and_plate::compute(shot(random));
    if (out.sliced == 0) continue;
    ++found;
    INFO("shot " << i);
    // Tests are rounded, so an instant of a touch may be seen as none.
    constexpr double slack = 1e-12;
    CHECK(out.touches == 1);
    CHECK(out.free_time <= out.time + slack);
    CHECK(out.time <= out.hit_time + slack);
    CHECK(out.hit_time <= out.sliced_time);
    CHECK(out.sliced_time - out.time <= 1 / out.slices + slack);
  }
  CHECK(found > generators::tried(2000));
}

TEST_CASE("no advance of the figure's rod passes the touch that samples see") {
  Random random(3);
  int touched = 0, clear = 0, passed = 0;
  for (int i = 0; i < generators::tried(2000); ++i) {
    const turning_rod::Output out = turning_rod::compute(turn(random));
    REQUIRE(out.problem == 0);
    INFO("rod " << i);
    const auto advances = std::size_t(out.advances);
    for (std::size_t k = 0; k + 1 < advances; ++k) {
      CHECK(out.times[k] < out.times[k + 1]);
      CHECK(out.distances[k] > out.tolerance);
    }
    for (std::size_t k = 0; k < out.curve.size(); ++k) {
      if (out.curve[k] > 0) continue;
      const double t = double(k) / double(out.curve.size() - 1);
      CHECK(out.ended != 1);
      CHECK(out.time <= t);
      CHECK(out.touches == 1);
      CHECK(out.touch_time <= t);
      break;
    }
    if (out.ended == 0) CHECK(out.distances[advances - 1] <= out.tolerance);
    if (out.touches == 1 && out.time > 0) CHECK(out.time <= out.touch_time + 1e-8);
    touched += out.touches == 1 ? 1 : 0;
    clear += out.ended == 1 ? 1 : 0;
    passed += out.passed == 1 ? 1 : 0;
  }
  CHECK(touched > generators::tried(300));
  CHECK(clear > generators::tried(100));
  CHECK(passed > generators::tried(10));
}
