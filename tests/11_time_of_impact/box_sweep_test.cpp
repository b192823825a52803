// Translating boxes against fractions: no touch missed, none invented.
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/box_sweep.hpp>
#include <limits>
#include <stdexcept>
#include <string>

#include "boxes.hpp"

using boxes::Box;
using boxes::V;
using contact::Aabb;
using generators::Random;
using oracle::Rational;

TEST_CASE("2,000 translating box pairs: none missed, none invented") {
  Random random(1);
  int hits = 0;
  int misses = 0;
  int by_filter = 0;
  int beyond_filter = 0;
  for (int i = 0; i < generators::tried(2000); ++i) {
    const boxes::Kind kind = boxes::all_kinds[static_cast<std::size_t>(i) % 8];
    const auto [a, b] = boxes::make(random, kind);
    const auto right = boxes::first_touch(a, b);
    const auto got = contact::box_impact(a, b);
    INFO("pair " << i << ", kind " << i % 8);
    REQUIRE(got.has_value() == right.has_value());
    const auto filtered =
        contact::detail::rounded_sweep(contact::detail::rounded_pair(a, b)).answer;
    (filtered == contact::detail::RoundedSweep::Answer::unsure ? beyond_filter : by_filter) += 1;
    // The filter never contradicts the fractions.
    if (filtered == contact::detail::RoundedSweep::Answer::hit) CHECK(right.has_value());
    if (filtered == contact::detail::RoundedSweep::Answer::miss) CHECK_FALSE(right.has_value());
    if (!right) {
      ++misses;
      continue;
    }
    ++hits;
    CHECK(oracle::error(got->t, *right) <= 0x1p-42);
    CHECK((got->t == 0) == (*right == 0));
    // With the boxes exchanged the touch is the same.
    const auto mirrored = contact::box_impact(b, a);
    REQUIRE(mirrored.has_value());
    CHECK(oracle::error(mirrored->t, *right) <= 0x1p-42);
    if (*right == 0) {
      CHECK(got->normal == V(0, 0, 0));
      continue;
    }
    // At the touch the normal separates them: the corners of b are behind all of a's, up to the
    // rounding of the normal, 16 u of the sizes, and the error of the time.
    CHECK(std::abs(got->normal.dot(got->normal) - 1) <= 0x1p-48);
    const oracle::Vector n = oracle::exact(got->normal);
    Rational front = 0;
    Rational back = 0;
    Rational size = 0;
    bool first = true;
    for (const oracle::Vector& corner : boxes::corners(a)) {
      const oracle::Vector at = corner + oracle::exact(a.displacement) * *right;
      const Rational x = n.dot(at);
      if (first || x < back) back = x;
      first = false;
    }
    first = true;
    for (const oracle::Vector& corner : boxes::corners(b)) {
      const oracle::Vector at = corner + oracle::exact(b.displacement) * *right;
      const Rational x = n.dot(at);
      if (first || x > front) front = x;
      first = false;
      for (int k = 0; k < 3; ++k) size = std::max(size, Rational(abs(at(k))));
    }
    const V way = b.displacement - a.displacement;
    for (int k = 0; k < 3; ++k) {
      size = std::max(size, oracle::exact(std::abs(way(k))));
      size = std::max(size, oracle::exact(a.half_lengths(k)));
      size = std::max(size, Rational(abs(oracle::exact(a.frame.origin(k)))));
    }
    CHECK(front - back <= size * oracle::exact(0x1p-38));
    CHECK(back - front <= size * oracle::exact(0x1p-38));
  }
  CHECK(hits > generators::tried(600));
  CHECK(misses > generators::tried(400));
  CHECK(by_filter > generators::tried(1200));
  CHECK(beyond_filter > generators::tried(100));
}

TEST_CASE("boxes with axes that are orthonormal only to 2^-20 are decided as they are stored") {
  Random random(4);
  int quick = 0;
  for (int i = 0; i < generators::tried(800); ++i) {
    auto [a, b] = boxes::make(random, boxes::all_kinds[static_cast<std::size_t>(i) % 8]);
    for (Box* box : {&a, &b}) {
      for (int k = 0; k < 3; ++k) {
        for (int j = 0; j < 3; ++j) box->frame.axes(k, j) += random.uniform(-0x1p-22, 0x1p-22);
      }
    }
    const auto right = boxes::first_touch(a, b);
    const auto got = contact::box_impact(a, b);
    INFO("pair " << i);
    REQUIRE(got.has_value() == right.has_value());
    if (right) CHECK(oracle::error(got->t, *right) <= 0x1p-42);
    const auto end = contact::detail::quick_sweep(a, b).end;
    quick += end == contact::detail::QuickSweep::End::unsure ? 0 : 1;
  }
  CHECK(quick > generators::tried(400));
}

TEST_CASE("boxes near the bound of the quick sweep: it never contradicts the fractions") {
  using End = contact::detail::QuickSweep::End;
  Random random(5);
  int unsure = 0;
  int sure = 0;
  for (int i = 0; i < generators::tried(1000); ++i) {
    auto [a, b] = boxes::make(random, i % 2 == 0 ? boxes::Kind::plain : boxes::Kind::far);
    const auto touch = boxes::first_touch(a, b);
    if (!touch || *touch == 0) continue;
    // The touch is moved to the end of the step, up to a little more or less than the bound.
    const double share = oracle::nearest(*touch) * (1 + random.uniform(-1, 1) * 0x1p-12);
    a.displacement *= share;
    b.displacement *= share;
    const auto right = boxes::first_touch(a, b);
    const auto quick = contact::detail::quick_sweep(a, b);
    INFO("pair " << i);
    if (quick.end == End::meet) {
      REQUIRE(right.has_value());
      CHECK(oracle::error(quick.impact.t, *right) <= 0x1p-43);
    }
    if (quick.end == End::apart) REQUIRE_FALSE(right.has_value());
    ++(quick.end == End::unsure ? unsure : sure);
  }
  CHECK(unsure > generators::tried(30));
  CHECK(sure > generators::tried(30));
}

TEST_CASE("a touch of boxes has no negative zero in its normal") {
  const contact::CoordinateFrame<double> frame;
  contact::CoordinateFrame<double> other;
  for (int k = 0; k < 3; ++k) {
    for (const double side : {-4.0, 4.0}) {
      other.origin = V::Zero();
      other.origin(k) = side;
      V way = V::Zero();
      way(k) = side;
      const auto got =
          contact::box_impact(contact::translating_box<double>(frame, V(1, 1, 1), way),
                              contact::translating_box<double>(other, V(1, 1, 1), V(0, 0, 0)));
      REQUIRE(got.has_value());
      CHECK(got->t == 0.5);
      V right = V::Zero();
      right(k) = side > 0 ? -1 : 1;
      CHECK(got->normal == right);
      for (int j = 0; j < 3; ++j)
        CHECK_FALSE((got->normal(j) == 0 && std::signbit(got->normal(j))));
    }
  }
}

TEST_CASE("sizes beyond the filter's range are decided exactly") {
  Random random(2);
  for (int i = 0; i < generators::tried(60); ++i) {
    auto [a, b] = boxes::make(random, boxes::Kind::plain);
    const int power = i % 2 == 0 ? random.integer(300, 1000) : -random.integer(300, 1000);
    for (Box* box : {&a, &b}) {
      for (int k = 0; k < 3; ++k) {
        box->frame.origin(k) = std::ldexp(box->frame.origin(k), power);
        box->half_lengths(k) = std::ldexp(box->half_lengths(k), power);
        box->displacement(k) = std::ldexp(box->displacement(k), power);
      }
    }
    const auto right = boxes::first_touch(a, b);
    const auto got = contact::box_impact(a, b);
    REQUIRE(got.has_value() == right.has_value());
    if (right) CHECK(oracle::error(got->t, *right) <= 0x1p-53);
  }
}

TEST_CASE("axis-aligned boxes: decided exactly, and the time rounded once") {
  Random random(3);
  int hits = 0;
  int misses = 0;
  for (int i = 0; i < generators::tried(3000); ++i) {
    std::array<Aabb<double>, 2> box;
    std::array<V, 2> way;
    for (std::size_t k = 0; k < 2; ++k) {
      if (i % 2 == 0) {
        const V low = boxes::whole(random, 3);
        const V extent = boxes::whole(random, 2).cwiseAbs();
        box[k] = {low, low + extent};
        way[k] = boxes::whole(random, 4);
      } else {
        const V low = boxes::in_box(random, 3);
        const V extent = boxes::in_box(random, 1).cwiseAbs();
        box[k] = {low, low + extent};
        way[k] = boxes::in_box(random, 4);
      }
    }
    // Most pairs that are not on integers are aimed at each other.
    if (i % 4 == 1) way[1] = way[0] + (box[0].low - box[1].low) * random.uniform(0.5, 2);
    // In fractions: the times at which the intervals on each axis begin and end to overlap.
    Rational from = 0;
    Rational to = 1;
    bool apart = false;
    for (int k = 0; k < 3; ++k) {
      const Rational speed = oracle::exact(way[1](k)) - oracle::exact(way[0](k));
      const Rational forth = oracle::exact(box[0].low(k)) - oracle::exact(box[1].high(k));
      const Rational back = oracle::exact(box[0].high(k)) - oracle::exact(box[1].low(k));
      if (speed == 0) {
        apart = apart || forth > 0 || back < 0;
        continue;
      }
      from = std::max(from, std::min(Rational(forth / speed), Rational(back / speed)));
      to = std::min(to, std::max(Rational(forth / speed), Rational(back / speed)));
    }
    const bool right = !apart && from <= to;
    const auto got = contact::aabb_impact(box[0], way[0], box[1], way[1]);
    REQUIRE(got.has_value() == right);
    (right ? hits : misses) += 1;
    if (right) CHECK(*got == oracle::nearest(from));
  }
  CHECK(hits > generators::tried(500));
  CHECK(misses > generators::tried(500));
}

TEST_CASE("an invalid moving box is refused, with the argument and the value") {
  const auto says = [](auto make, const std::string& words) {
    try {
      make();
    } catch (const std::invalid_argument& error) {
      INFO(error.what());
      CHECK(std::string(error.what()).find(words) != std::string::npos);
      return;
    }
    FAIL("nothing was thrown; expected: " << words);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const contact::CoordinateFrame<double> frame;
  contact::CoordinateFrame<double> skew;
  skew.axes(0, 1) = 0.5;
  says([&] { contact::translating_box<double>(frame, V(1, 0, 1), V(0, 0, 0)); },
       "half_lengths = (1, 0, 1)");
  says([&] { contact::translating_box<double>(frame, V(1, nan, 1), V(0, 0, 0)); },
       "half_lengths = (1, nan, 1)");
  says([&] { contact::translating_box<double>(frame, V(1, 1, 1), V(0, nan, 0)); },
       "displacement = (0, nan, 0)");
  says([&] { contact::translating_box<double>(skew, V(1, 1, 1), V(0, 0, 0)); }, "frame.axes");
  const auto box = contact::translating_box<double>(frame, V(1, 1, 1), V(0, 0, 2));
  CHECK(box.displacement == V(0, 0, 2));
}
