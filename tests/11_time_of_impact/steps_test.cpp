// Finding impacts by tests, advancing to them, and proving that none is missed.
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/conservative_advancement.hpp>
#include <contact/sliced_steps.hpp>
#include <contact/tunnelling.hpp>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "boxes.hpp"

using boxes::V;
using contact::ConservativeEnd;
using contact::ImpactBracket;
using generators::Random;
using oracle::Interval;
using oracle::Rational;

namespace {

void says(const std::function<void()>& make, const std::string& words) {
  try {
    make();
  } catch (const std::invalid_argument& error) {
    INFO(error.what());
    CHECK(std::string(error.what()).find(words) != std::string::npos);
    return;
  }
  FAIL("nothing was thrown; expected: " << words);
}

}  // namespace

TEST_CASE("slices find an overlap that lasts a slice, and bisection its beginning") {
  Random random(1);
  int seen = 0;
  int unseen = 0;
  for (int i = 0; i < generators::tried(2000); ++i) {
    const double duration = random.uniform(0.1, 3);
    const int slices = random.integer(1, 40);
    const double from = random.uniform(0, duration);
    const double to = from + random.uniform(0, duration / 10);
    const auto overlap = [&](double t) { return from <= t && t <= to; };
    const auto bracket = contact::sliced_step<double>(overlap, duration, slices);
    const double slice = duration / slices;
    if (!bracket) {
      ++unseen;
      // An overlap longer than a slice, rounding included, is found, unless the step ends before.
      CHECK((to - from <= slice + 0x1p-50 * duration || to > duration));
      continue;
    }
    ++seen;
    CHECK(overlap(bracket->hit));
    CHECK_FALSE(overlap(bracket->free));
    // Two tests, each with a time rounded twice.
    CHECK(bracket->hit - bracket->free <= slice + 0x1p-50 * duration);
    const int halvings = random.integer(0, 45);
    const auto close = contact::bisect_impact<double>(overlap, *bracket, halvings);
    CHECK(overlap(close.hit));
    CHECK_FALSE(overlap(close.free));
    CHECK(close.free <= from);
    CHECK(from <= close.hit);
    // Each halving rounds a middle to the nearest number: at least an ulp of the time remains.
    CHECK(close.hit - close.free <=
          std::ldexp(bracket->hit - bracket->free, -halvings) + 0x1p-52 * duration);
    const auto all = contact::bisect_impact<double>(overlap, *bracket, 2000);
    CHECK(all.hit == from);
    CHECK(all.free == std::nextafter(from, 0.0));
  }
  CHECK(seen > generators::tried(500));
  CHECK(unseen > generators::tried(300));
  const auto at_once = contact::sliced_step<double>([](double) { return true; }, 1.0, 4);
  REQUIRE(at_once.has_value());
  CHECK(at_once->hit == 0);
  says([] { contact::sliced_step<double>([](double) { return true; }, 1.0, 0); }, "slices = 0");
  says([] { contact::sliced_step<double>([](double) { return true; }, -1.0, 4); }, "duration = -1");
}

TEST_CASE("the error of interpolation is within its bound") {
  // A ball falls from the height h: the gap is h − v t − g t²/2, with |gap''| = g.
  Random random(2);
  for (int i = 0; i < generators::tried(1000); ++i) {
    const double g = 10;
    const double v = random.uniform(0.1, 20);
    const double width = random.uniform(0.001, 0.1);
    const double impact = random.uniform(0.1, 0.9) * width;
    const double h = v * impact + g * impact * impact / 2;
    const auto gap = [&](double t) { return h - v * t - g * t * t / 2; };
    const ImpactBracket<double> bracket{0, width};
    const double got = contact::interpolated_impact(bracket, gap(0), gap(width));
    // Closing at least at v; and 2^-45 for the rounding of the heights here.
    CHECK(std::abs(got - impact) <= g * width * width / (8 * v) + 0x1p-45 * (h + v * width) / v);
    CHECK(got >= 0);
    CHECK(got <= width);
  }
  CHECK(contact::interpolated_impact<double>({1, 2}, 0, -1) == 1);
  CHECK(contact::interpolated_impact<double>({1, 2}, 3, 0) == 2);
}

TEST_CASE("where the bound holds, no ball passes through a wall unnoticed") {
  Random random(3);
  int proven = 0;
  int passed = 0;
  for (int i = 0; i < generators::tried(3000); ++i) {
    const double radius = random.uniform(0, 0.5);
    const double wall = random.uniform(0, 0.5);
    const double speed = random.uniform(1, 60);
    const double step = 1.0 / 60;
    const auto body = contact::mover(radius, radius, 0.0);
    const auto bound =
        contact::slab_tunnelling(body, wall, contact::centre_displacement(speed, 0.0, step));
    // Tests at the times k h, in fractions: the ball starts within a step of the wall.
    const Rational start = -(oracle::exact(wall) / 2 + oracle::exact(radius)) -
                           oracle::exact(random.uniform()) * oracle::exact(speed) / 60;
    const Rational advance = oracle::exact(speed) * oracle::exact(step);
    const Rational near = oracle::exact(wall) / 2 + oracle::exact(radius);
    bool seen = false;
    for (Rational x = start; x <= near; x += advance) seen = seen || abs(x) <= near;
    if (bound.nothing_passes()) {
      ++proven;
      CHECK(seen);
    } else if (!seen) {
      ++passed;
    }
    // The bound is sharp: it fails only if a step is really longer, up to rounding.
    if (!bound.nothing_passes()) CHECK(advance * (1 + oracle::exact(0x1p-40)) > 2 * near);
  }
  CHECK(proven > generators::tried(500));
  CHECK(passed > generators::tried(100));
}

TEST_CASE("a missed chord is within the bounds on length, depth and angle") {
  Random random(4);
  int missed = 0;
  double deepest = 0;
  for (int i = 0; i < generators::tried(4000); ++i) {
    const double radius_sum = random.uniform(0.2, 2);
    const double step = radius_sum * random.uniform(0.05, 2.2);
    // A path along x at the height y above the centre: chord c = 2 √(ρ² − y²); a test every `step`.
    const double y = radius_sum * (1 - random.uniform() * random.uniform());
    const double first = -2 * radius_sum - step * random.uniform();
    bool seen = false;
    for (int k = 0; first + k * step < 2 * radius_sum; ++k) {
      const Rational x = oracle::exact(first) + k * oracle::exact(step);
      seen = seen || x * x + oracle::exact(y) * oracle::exact(y) <=
                         oracle::exact(radius_sum) * oracle::exact(radius_sum);
    }
    if (seen) continue;
    ++missed;
    const auto bound = contact::missed_chord(radius_sum, step);
    const Rational square =
        oracle::exact(radius_sum) * oracle::exact(radius_sum) - oracle::exact(y) * oracle::exact(y);
    CHECK(oracle::exact(bound.depth) >= oracle::exact(radius_sum) - oracle::exact(y));
    CHECK(oracle::exact(bound.length) * oracle::exact(bound.length) >= 4 * square);
    // The cosine at the entry is half the chord divided by ρ.
    CHECK(oracle::exact(bound.approach) * oracle::exact(bound.approach) *
              oracle::exact(radius_sum) * oracle::exact(radius_sum) >=
          square);
    deepest = std::max(deepest, (radius_sum - y) / bound.depth);
  }
  CHECK(missed > generators::tried(500));
  CHECK(deepest > 0.8);  // the bound is almost attained
  const auto all = contact::missed_chord(1.0, 2.0);
  CHECK(all.length == 2);
  CHECK(all.depth == 1);
  CHECK(all.approach == 1);
  // The depth itself, ρ − √(ρ² − D²/4), is below the bound, and close to it also for a small D.
  for (const double d : {1e-9, 1e-3, 0.5, 1.0, 1.9, 1.999999999}) {
    const auto bound = contact::missed_chord(1.0, d);
    const oracle::Surd right{1, -1, 1 - oracle::exact(d) * oracle::exact(d) / 4};
    CHECK(oracle::sign(oracle::Surd(-right) + oracle::exact(bound.depth)) >= 0);
    CHECK(oracle::error(bound.depth, right) <= 0x1p-24 * bound.depth);
  }
}

TEST_CASE("no point moves further than the bound, with rotation and acceleration") {
  Random random(5);
  double nearest = 0;
  for (int i = 0; i < generators::tried(2000); ++i) {
    const double h = random.uniform(0.001, 0.05);
    const V v = boxes::in_box(random, 5);
    const V acceleration = boxes::in_box(random, 10);
    const V angular_velocity_a = boxes::in_box(random, 8);
    const V angular_velocity_b = boxes::in_box(random, 8);
    const double ra = random.uniform(0.1, 1);
    const double rb = random.uniform(0.1, 1);
    const auto a = contact::mover(0.0, ra, angular_velocity_a.norm() * (1 + 0x1p-50));
    const auto b = contact::mover(0.0, rb, angular_velocity_b.norm() * (1 + 0x1p-50));
    const double centres = contact::centre_displacement(v.norm() * (1 + 0x1p-50),
                                                        acceleration.norm() * (1 + 0x1p-50), h);
    const double bound = contact::relative_displacement(a, b, centres, h);
    // The centre of a relative to b, and a point of a at its rim, in the frame that rotates with b.
    const V x0 = contact::normalised(boxes::in_box(random, 1)) * ((ra + rb) * random.uniform());
    const V p0 = contact::normalised(boxes::in_box(random, 1)) * ra;
    const auto in_b = [&](const V& x, double t) {
      return V(
          contact::matrix_of(contact::exponential<double>(angular_velocity_b * t)).transpose() * x);
    };
    for (const double t : {h / 3, h}) {
      const V x1 = x0 + v * t + acceleration * (t * t / 2);
      const V p1 = contact::matrix_of(contact::exponential<double>(angular_velocity_a * t)) * p0;
      const V centre = in_b(x1, t) - x0;
      CHECK(centre.norm() <= bound);
      // Only within the radius of b: a point of a that is farther away cannot touch it.
      if (V(x0 + p0).norm() <= ra + rb) {
        const V point = in_b(V(x1 + p1), t) - V(x0 + p0);
        CHECK(point.norm() <= bound);
        nearest = std::max(nearest, point.norm() / bound);
      }
    }
  }
  CHECK(nearest > 0.3);
  says([] { contact::mover(2.0, 1.0, 0.0); }, "outer_radius = 1");
  says([] { contact::mover(-1.0, 1.0, 0.0); }, "inner_radius = -1");
  says([] { contact::centre_displacement(1.0, -1.0, 1.0); }, "acceleration = -1");
  says([] { contact::missed_chord(0.0, 1.0); }, "radius_sum = 0");
}

TEST_CASE("upper bounds are above the exact values, and the thickness of two balls below") {
  Random random(6);
  for (int i = 0; i < generators::tried(2000); ++i) {
    const double v = random.uniform(0, 100);
    const double g = random.uniform(0, 20);
    const double h = random.uniform(0, 0.1);
    const double ra = random.uniform(0, 1);
    const double rb = random.uniform(0, 1);
    const Rational right = oracle::exact(v) * oracle::exact(h) +
                           oracle::exact(g) * oracle::exact(h) * oracle::exact(h) / 2;
    const double centres = contact::centre_displacement(v, g, h);
    CHECK(oracle::exact(centres) >= right);
    CHECK(oracle::exact(centres) <=
          right * (1 + oracle::exact(0x1p-48)) + oracle::exact(0x1p-1060));
    const auto a = contact::mover(ra, ra, 3.0);
    const auto b = contact::mover(rb, rb, 4.0);
    const Rational turned =
        oracle::exact(centres) +
        7 * oracle::exact(h) * (oracle::exact(ra) + oracle::exact(rb) + oracle::exact(centres));
    CHECK(oracle::exact(contact::relative_displacement(a, b, centres, h)) >= turned);
    const auto bound = contact::pair_tunnelling(a, b, centres);
    CHECK(oracle::exact(bound.thickness) <= 2 * (oracle::exact(ra) + oracle::exact(rb)));
    CHECK(oracle::exact(bound.thickness) * (1 + oracle::exact(0x1p-48)) >=
          2 * (oracle::exact(ra) + oracle::exact(rb)));
    CHECK(bound.nothing_passes() == (centres <= bound.thickness));
    // v² = 2 (E − U) / m
    const double energy = random.uniform(-5, 50);
    const double low = random.uniform(-20, 10);
    const double mass = random.uniform(0.1, 9);
    const double speed = contact::energy_speed(energy, low, mass);
    const Rational square = 2 * (oracle::exact(energy) - oracle::exact(low)) / oracle::exact(mass);
    CHECK(oracle::exact(speed) * oracle::exact(speed) >= square);
    if (square > 0) {
      CHECK(oracle::exact(speed) * oracle::exact(speed) <= square * (1 + oracle::exact(0x1p-45)));
    } else {
      CHECK(speed == 0);
    }
  }
  says([] { contact::energy_speed(1.0, 0.0, 0.0); }, "mass = 0");
}

TEST_CASE("a rod that rotates above a floor is advanced to just before its end touches") {
  // Half lengths l along the rod and s perpendicular to it; it starts horizontal at the height h
  // and rotates at ω. Its lowest point is at h − l sin ωt − s cos ωt: checked by intervals.
  Random random(7);
  for (int i = 0; i < generators::tried(300); ++i) {
    const double l = random.uniform(0.5, 2);
    const double s = random.uniform(0.01, 0.1);
    const double w = random.uniform(0.5, 40);
    const double h = s + l * random.uniform(0.1, 0.9);
    const double tolerance = std::ldexp(1.0, -random.integer(8, 30));
    contact::RotatingBox<double> rod;
    rod.half_lengths = V(l, s, s);
    rod.position = V(0, 0, h);
    rod.angular_velocity = V(0, w, 0);
    const contact::Plane<double> floor{V(0, 0, 1), 0};
    const double quarter = 1.6 / w;
    const auto end = contact::rotating_box_plane_impact(rod, floor, quarter, tolerance, 10000);
    INFO("l = " << l << ", s = " << s << ", ω = " << w << ", h = " << h);
    REQUIRE(end.end == ConservativeEnd::impact);
    const Interval angle = Interval(oracle::exact(w) * oracle::exact(end.t), 128);
    const Interval gap = Interval(oracle::exact(h), 128) -
                         Interval(oracle::exact(l), 128) * sin(angle) -
                         Interval(oracle::exact(s), 128) * cos(angle);
    // Not passed: before the touch the gap is positive. Close: at most the tolerance and the
    // rounding of the distance, 64 u of its terms.
    const Rational room = oracle::exact(64 * 0x1p-53 * (h + l + s));
    CHECK(gap.low() > -room);
    CHECK(gap.high() <= oracle::exact(tolerance) + room);
    // It rotates by at most a quarter turn, in which the gap only shrinks.
    CHECK(w * end.t < 1.5707963267948966);
  }
}

TEST_CASE(
    "rotating boxes: no impact is passed, and without rotation the time is that of the sweep") {
  Random random(8);
  std::array<int, 3> ends{};
  for (int i = 0; i < generators::tried(160); ++i) {
    std::array<contact::RotatingBox<double>, 2> box;
    for (auto& each : box) {
      each.half_lengths = boxes::in_box(random, 0.6).cwiseAbs() + V::Constant(0.1);
      each.position = boxes::in_box(random, 2.5);
      each.orientation =
          contact::normalised(contact::exponential<double>(boxes::in_box(random, 3)));
      each.velocity = boxes::in_box(random, 3);
      if (i % 2 == 0) each.angular_velocity = boxes::in_box(random, 6);
    }
    auto& [a, b] = box;
    if (random.chance(0.6)) a.velocity = b.velocity + (b.position - a.position) * 1.5;
    const double tolerance = 1e-4;
    const auto end = contact::rotating_boxes_impact(a, b, 1.0, tolerance, 2000);
    ++ends[static_cast<std::size_t>(end.end)];
    INFO("pair " << i);
    REQUIRE(end.end != ConservativeEnd::gave_up);
    // Decided exactly for the boxes at many earlier times: they are separated.
    const auto touch_at = [&](double t) {
      boxes::Box at_a{contact::frame_at(a, t), a.half_lengths, V(0, 0, 0)};
      boxes::Box at_b{contact::frame_at(b, t), b.half_lengths, V(0, 0, 0)};
      return contact::box_impact(at_a, at_b).has_value();
    };
    if (end.t > 0) {
      for (int k = 0; k < 60; ++k) CHECK_FALSE(touch_at(end.t * k / 60));
    }
    if (end.end == ConservativeEnd::impact) {
      CHECK(end.distance <= tolerance);
    } else {
      CHECK(end.t == 1);
      CHECK_FALSE(touch_at(1));
    }
    if (i % 2 == 1) {
      boxes::Box at_a{contact::frame_at(a, 0.0), a.half_lengths, a.velocity};
      boxes::Box at_b{contact::frame_at(b, 0.0), b.half_lengths, b.velocity};
      const auto swept = contact::box_impact(at_a, at_b);
      if (swept) {
        REQUIRE(end.end == ConservativeEnd::impact);
        CHECK(end.t <= swept->t + 0x1p-40);
      }
    }
  }
  CHECK(ends[static_cast<std::size_t>(ConservativeEnd::impact)] > generators::tried(40));
  CHECK(ends[static_cast<std::size_t>(ConservativeEnd::clear)] > generators::tried(20));
}

TEST_CASE("the bound on the approach speed holds for any two points") {
  Random random(9);
  double nearest = 0;
  for (int i = 0; i < generators::tried(2000); ++i) {
    std::array<contact::RotatingBox<double>, 2> box;
    std::array<V, 2> velocity;
    for (std::size_t k = 0; k < 2; ++k) {
      box[k].half_lengths = boxes::in_box(random, 1).cwiseAbs() + V::Constant(0.1);
      box[k].velocity = boxes::in_box(random, 3);
      box[k].angular_velocity = boxes::in_box(random, 3);
      const V corner = box[k].half_lengths.cwiseProduct(
          V(random.chance(0.5) ? 1 : -1, random.chance(0.5) ? 1 : -1, random.chance(0.5) ? 1 : -1));
      velocity[k] = box[k].velocity + box[k].angular_velocity.cross(corner);
    }
    const double bound = contact::approach_bound(box[0], box[1]);
    const V relative = velocity[0] - velocity[1];
    CHECK(relative.norm() <= bound);
    nearest = std::max(nearest, relative.norm() / bound);
  }
  CHECK(nearest > 0.8);
}

TEST_CASE("an advance that does not converge gives up, and invalid numbers are refused") {
  // The lower bound never reaches 0, and the bound on the approach speed is far too large.
  const auto slow = [](double t) { return 1 - t / 2; };
  const auto end = contact::conservative_advancement<double>(slow, 1e6, 1.0, 1e-3, 50);
  CHECK(end.end == ConservativeEnd::gave_up);
  CHECK(end.advances == 50);
  CHECK(end.t > 0);
  CHECK(end.t < 1e-4);
  const auto clear = contact::conservative_advancement<double>(slow, 0.5, 1.0, 1e-3, 50);
  CHECK(clear.end == ConservativeEnd::clear);
  const auto rest = contact::conservative_advancement<double>(slow, 0.0, 1.0, 1e-3, 50);
  CHECK(rest.end == ConservativeEnd::clear);
  CHECK(rest.advances == 1);
  says([&] { contact::conservative_advancement<double>(slow, -1.0, 1.0, 1e-3, 5); },
       "approach = -1");
  says([&] { contact::conservative_advancement<double>(slow, 1.0, -1.0, 1e-3, 5); },
       "duration = -1");
  says([&] { contact::conservative_advancement<double>(slow, 1.0, 1.0, 0.0, 5); }, "tolerance = 0");
}

TEST_CASE("a distance that is no number is not taken for a clear step") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  contact::RotatingBox<double> box;
  box.position = V(nan, 0, 4);
  box.half_lengths = V(1, 1, 1);
  const auto end = contact::rotating_box_plane_impact<double>(box, {V(0, 0, 1), 0}, 1, 1e-3, 50);
  CHECK(end.end == contact::ConservativeEnd::gave_up);
  CHECK(end.t == 0);
}

TEST_CASE("an accelerated ball may touch a wall unseen, but does not get to its other side") {
  // It dips 0.249 m in between two tests and turns back.
  const auto bound = contact::slab_tunnelling(contact::mover(0.5, 0.5, 0.0), 10.0,
                                              contact::centre_displacement(1.0, 2.0, 1.0));
  CHECK(bound.nothing_passes());
  const auto gap = [](double t) { return 0.001 - (t - t * t); };
  CHECK(gap(0) > 0);
  CHECK(gap(0.5) < 0);
  CHECK(gap(1) > 0);
}
