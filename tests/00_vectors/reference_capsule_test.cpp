// capsule.hpp against rational arithmetic.
#include <boost/multiprecision/eigen.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/capsule.hpp>
#include <contact/tolerance.hpp>
#include <limits>
#include <support/generators.hpp>
#include <support/oracle.hpp>
#include <support/refusal.hpp>

namespace capsule_test {

using contact::Capsule;
using contact::CoordinateFrame;
using contact::Vector3;
using generators::Random;
using oracle::Rational;
using support::contains;
using support::refusal;
using V = Vector3<double>;

V any_point(Random& random, int range) {
  const double x = random.magnitude(-range, range);
  const double y = random.magnitude(-range, range);
  return {x, y, random.magnitude(-range, range)};
}

TEST_CASE("the box of a capsule contains it, and no smaller one does") {
  Random random(21);
  const double infinity = std::numeric_limits<double>::infinity();
  for (int i = 0; i < generators::tried(2000); ++i) {
    const int range = i % 3 == 0 ? 60 : 3;
    const Capsule<double> capsule{{any_point(random, range), any_point(random, range)},
                                  std::abs(random.magnitude(-range, range))};
    const auto box = contact::aabb_of_capsule(capsule);
    const Rational radius = oracle::exact(capsule.radius);
    for (int k = 0; k < 3; ++k) {
      const Rational start = oracle::exact(capsule.core.start(k));
      const Rational end = oracle::exact(capsule.core.end(k));
      const Rational low = std::min(start, end) - radius, high = std::max(start, end) + radius;
      CHECK(oracle::exact(box.low(k)) <= low);
      CHECK(oracle::exact(std::nextafter(box.low(k), infinity)) > low);
      CHECK(oracle::exact(box.high(k)) >= high);
      CHECK(oracle::exact(std::nextafter(box.high(k), -infinity)) < high);
    }
  }
}

TEST_CASE("a capsule along the z axis of a frame, and a capsule in a pose") {
  Random random(22);
  const double u = contact::tolerance::unit_roundoff<double>;
  for (int i = 0; i < generators::tried(1000); ++i) {
    const auto frame = contact::frame_on_normal<double>(any_point(random, 3), any_point(random, 3));
    const double half_length = random.uniform(0, 2);
    const auto capsule = contact::capsule_along_z<double>(frame, half_length, 0.5);
    const Rational length = oracle::exact(half_length);
    for (int k = 0; k < 3; ++k) {
      const Rational centre = oracle::exact(frame.origin(k));
      const Rational half = oracle::exact(frame.axes(k, 2)) * length;
      const Rational room = 2 * oracle::exact(u) * (abs(centre) + abs(half)) * 2;
      CHECK(abs(oracle::exact(capsule.core.start(k)) - (centre - half)) <= room);
      CHECK(abs(oracle::exact(capsule.core.end(k)) - (centre + half)) <= room);
    }
    CHECK(capsule.radius == 0.5);
    // The same as the capsule of the frame's own axes, seen from the world.
    const auto own = contact::capsule_along_z<double>({}, half_length, 0.5);
    CHECK((own.core.start == V(0, 0, -half_length) && own.core.end == V(0, 0, half_length)));
    const auto moved = contact::transformed(own, frame);
    CHECK((moved.core.start == capsule.core.start && moved.core.end == capsule.core.end));
    CHECK(moved.radius == 0.5);
    const auto ball = contact::transformed(contact::Sphere<double>{V(0, 0, 0), 2}, frame);
    CHECK((ball.centre == frame.origin && ball.radius == 2));
    CHECK(contact::as_capsule(ball).core.start == ball.centre);
    CHECK(contact::as_capsule(ball).core.end == ball.centre);
    CHECK(contact::as_capsule(ball).radius == 2);
  }
}

TEST_CASE("an invalid capsule is refused, with the argument and the value") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double largest = std::numeric_limits<double>::max();
  const auto make = [](const V& start, const V& end, double radius) {
    return refusal([&] { contact::capsule_from_segment<double>(start, end, radius); });
  };
  CHECK(contains(make(V(0, 0x1p300, 0), V(0, 0, 0), 1), "start"));
  CHECK(contains(make(V(0, 0, 0), V(nan, 0, 0), 1), "end"));
  CHECK(contains(make(V(0, 0, 0), V(1, 0, 0), -1), "radius = -1"));
  CHECK(contact::capsule_from_segment<double>(V(0, 0, 1), V(0, 0, 1), 0).radius == 0);
  CHECK(contains(refusal([&] {
                   contact::aabb_of_capsule<double>({{V(largest, 0, 0), V(0, 0, 0)}, largest});
                 }),
                 "its box overflows"));
}

}  // namespace capsule_test
