// turning_impact.hpp and moving_pose.hpp: no time of impact of turning bodies is after the touch.
#include <algorithm>
#include <array>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/proximity.hpp>
#include <contact/signed_distance.hpp>
#include <contact/turning_impact.hpp>
#include <limits>
#include <stdexcept>
#include <vector>

#include "families_turning.hpp"
#include "support/generators.hpp"

namespace {

using contact::ConservativeEnd;
using contact::OrientedBox;
using contact::TurningImpact;
using contact::TurningMotion;
using generators::Random;

using Vec = contact::Vector3<double>;
using Motion = TurningMotion<double>;

constexpr double pi = 3.141592653589793;

Vec random_vec(Random& random, double size) {
  return Vec{random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
}

Motion random_motion(Random& random, double path, double angle) {
  const Vec centre = random_vec(random, 2);
  const Vec displacement = random_vec(random, path);
  return {centre, displacement, random_vec(random, angle)};
}

contact::Matrix3<double> random_axes(Random& random) {
  return contact::matrix_of(
      contact::normalised(contact::exponential<double>(random_vec(random, 3))));
}

template <class Body>
Body random_body(Random& random, const Vec& at);
template <>
contact::Sphere<double> random_body(Random& random, const Vec& at) {
  return {at, random.uniform(0.1, 0.6)};
}
template <>
contact::Capsule<double> random_body(Random& random, const Vec& at) {
  const Vec half = random_vec(random, 1);
  return {{Vec(at - half), Vec(at + half)}, random.uniform(0.0, 0.3)};
}
template <>
contact::Lozenge<double> random_body(Random& random, const Vec& at) {
  const Vec first = random_vec(random, 1), second = random_vec(random, 1);
  return {at, first, second, random.uniform(0.0, 0.3)};
}
template <>
OrientedBox<double> random_body(Random& random, const Vec& at) {
  const contact::Matrix3<double> axes = random_axes(random);
  return {at, axes, Vec(random_vec(random, 0.8).cwiseAbs() + Vec::Constant(0.05))};
}
template <>
contact::Triangle<double> random_body(Random& random, const Vec& at) {
  const Vec a = at + random_vec(random, 1), b = at + random_vec(random, 1);
  return {a, b, Vec(at + random_vec(random, 1))};
}
template <>
contact::ConvexHull<double> random_body(Random& random, const Vec& at) {
  contact::ConvexHull<double> hull;
  for (int k = 0; k < 8; ++k) hull.vertices.emplace_back(at + random_vec(random, 0.8));
  hull.radius = random.chance(0.5) ? 0 : 0.1;
  return hull;
}
template <>
contact::Cylinder<double> random_body(Random& random, const Vec& at) {
  const Vec half = random_vec(random, 0.8) + Vec(0.01, 0.01, 0.01);
  return {{Vec(at - half), Vec(at + half)}, random.uniform(0.1, 0.4)};
}
template <>
contact::Ellipsoid<double> random_body(Random& random, const Vec& at) {
  const contact::Matrix3<double> axes = random_axes(random);
  return {at, axes, Vec(random_vec(random, 0.6).cwiseAbs() + Vec::Constant(0.1))};
}

/// Whether the bodies are certainly disjoint at a time.
template <class A, class B>
bool disjoint_at(double t, const A& a, const Motion& motion_a, const B& b, const Motion& motion_b) {
  return contact::proximity(contact::moved_body(a, motion_a, t),
                            contact::moved_body(b, motion_b, t)) == contact::Proximity::disjoint;
}

/// Compares the answer for two bodies with their state at times before the impact, and at it.
template <class A, class B>
void check_pair(Random& random, const A& a, const Motion& motion_a, const B& b,
                const Motion& motion_b) {
  constexpr double tolerance = 0x1p-16;
  const TurningImpact<double> found =
      contact::turning_impact(a, motion_a, b, motion_b, tolerance, 4000);
  REQUIRE(found.end != ConservativeEnd::gave_up);
  if (found.t > 0) {
    for (int k = 0; k < 12; ++k) {
      const double share = k < 4 ? 1 - std::ldexp(1.0, -6 * k - 2) : random.uniform();
      REQUIRE(disjoint_at(found.t * share, a, motion_a, b, motion_b));
    }
  }
  if (found.end == ConservativeEnd::clear) return;
  const auto now_a = contact::moved_body(a, motion_a, found.t);
  const auto now_b = contact::moved_body(b, motion_b, found.t);
  const double distance = contact::signed_distance(now_a, now_b).distance;
  const double size = std::max(contact::gjk_detail::largest_number(now_a),
                               contact::gjk_detail::largest_number(now_b));
  CHECK(distance <= tolerance * (1 + 0x1p-10) + 0x1p-40 * size);
  CHECK(found.distance <= std::max(distance, 0.0) + 0x1p-40);
  if (found.t > 0) {
    CHECK(std::abs(found.normal.norm() - 1) < 0x1p-40);
    CHECK(contact::detail::separation_down(now_a, now_b, found.normal) > 0);
  }
}

template <class A, class B>
void check_pairs(int rounds) {
  Random random(1121);
  for (int round = 0; round < generators::tried(rounds); ++round) {
    const Vec of_a = random_vec(random, 2);
    const A a = random_body<A>(random, of_a);
    const B b = random_body<B>(random, Vec(of_a + random_vec(random, 3)));
    const double angle = round % 3 == 0 ? 8 : 2;
    const Motion motion_a = random_motion(random, 3, angle);
    const Motion motion_b = random_motion(random, 3, round % 2 == 0 ? 0 : angle);
    INFO("round " << round);
    check_pair(random, a, motion_a, b, motion_b);
  }
}

/// R(a) x by Rodrigues' formula.
Vec rotated(const Vec& rotation, const Vec& x) {
  using Long = contact::Vector3<long double>;
  const Long a = rotation.cast<long double>();
  const long double angle = std::sqrt(a.dot(a));
  if (angle == 0) return x;
  const Long axis = a / angle, p = x.cast<long double>();
  const Long turned = p * std::cos(angle) + Long(axis.cross(p)) * std::sin(angle) +
                      axis * (axis.dot(p) * (1 - std::cos(angle)));
  return turned.cast<double>();
}

/// Two boxes that share a point at a time, and their motions.
struct MeetingBoxes {
  std::array<OrientedBox<double>, 2> box;
  std::array<Motion, 2> motion;
};
MeetingBoxes meeting_boxes(Random& random, double time) {
  MeetingBoxes made;
  const Vec common = random_vec(random, 1);
  for (std::size_t k = 0; k < 2; ++k) {
    const Vec displacement = random_vec(random, 4), rotation = random_vec(random, 4);
    const Vec inside = random_vec(random, 0.99);
    OrientedBox<double>& box = made.box[k];
    box = random_body<OrientedBox<double>>(random, Vec::Zero());
    // The point of the box that is at the common point then.
    const Vec lever = box.axes * Vec(inside.cwiseProduct(box.half_lengths));
    box.centre = common - rotated(Vec(rotation * time), lever) - displacement * time;
    made.motion[k] = {box.centre, displacement, rotation};
  }
  return made;
}

}  // namespace

TEST_CASE("a moved body is where the motion takes it, within the bound", "[turning]") {
  Random random(1122);
  for (int round = 0; round < generators::tried(4000); ++round) {
    const double far = round % 4 == 0 ? 1e6 : 1;
    const contact::Triangle<double> body{random_vec(random, far), random_vec(random, far),
                                         random_vec(random, far)};
    Motion motion = random_motion(random, 5, round % 3 == 0 ? 60 : 3);
    motion.centre *= far;
    const double t = random.uniform();
    const auto moved = contact::moved_body(body, motion, t);
    const double bound = contact::pose_error(contact::turning_radius(body, motion.centre), motion);
    for (int i = 0; i < 3; ++i) {
      const Vec lever = vertex(body, i) - motion.centre;
      const Vec expected =
          motion.centre + motion.displacement * t + rotated(Vec(motion.rotation * t), lever);
      CHECK((vertex(moved, i) - expected).norm() <= bound);
    }
    CHECK(bound < 1e-10 * far);
  }
}

TEST_CASE("no point of a body is farther from the centre than its turning radius", "[turning]") {
  Random random(1123);
  for (int round = 0; round < generators::tried(300); ++round) {
    const Vec centre = random_vec(random, 2);
    const auto check = [&](const auto& body) {
      const double radius = contact::turning_radius(body, centre);
      for (int k = 0; k < 20; ++k) {
        const Vec n = random_vec(random, 1).normalized();
        REQUIRE(contact::support_down(body, n) - n.dot(centre) <= radius * (1 + 0x1p-40));
      }
    };
    check(random_body<contact::Sphere<double>>(random, random_vec(random, 2)));
    check(random_body<contact::Lozenge<double>>(random, random_vec(random, 2)));
    check(random_body<OrientedBox<double>>(random, random_vec(random, 2)));
    check(random_body<contact::Cylinder<double>>(random, random_vec(random, 2)));
    check(random_body<contact::Ellipsoid<double>>(random, random_vec(random, 2)));
  }
}

TEST_CASE("turning polytopes are disjoint until the time of impact", "[turning]") {
  check_pairs<OrientedBox<double>, OrientedBox<double>>(3000);
  check_pairs<OrientedBox<double>, contact::ConvexHull<double>>(1000);
  check_pairs<contact::ConvexHull<double>, contact::ConvexHull<double>>(1000);
  check_pairs<contact::Triangle<double>, OrientedBox<double>>(1000);
  check_pairs<contact::Triangle<double>, contact::Triangle<double>>(1000);
}

TEST_CASE("turning bodies with a radius are disjoint until the time of impact", "[turning]") {
  check_pairs<contact::Capsule<double>, contact::Capsule<double>>(2000);
  check_pairs<contact::Sphere<double>, contact::ConvexHull<double>>(1000);
  check_pairs<contact::Lozenge<double>, contact::Capsule<double>>(1000);
  check_pairs<contact::Sphere<double>, OrientedBox<double>>(1000);
}

TEST_CASE("turning smooth bodies are disjoint until the time of impact", "[turning]") {
  check_pairs<contact::Cylinder<double>, OrientedBox<double>>(100);
  check_pairs<contact::Ellipsoid<double>, contact::Sphere<double>>(100);
}

TEST_CASE("turning boxes that share a point at a time are found at or before it", "[turning]") {
  Random random(1124);
  for (int round = 0; round < generators::tried(10000); ++round) {
    const double time = random.uniform();
    const auto [box, motion] = meeting_boxes(random, time);
    const auto found = contact::turning_impact(box[0], motion[0], box[1], motion[1], 0x1p-10, 4000);
    INFO("round " << round);
    REQUIRE(found.end == ConservativeEnd::impact);
    REQUIRE(found.t <= time);
  }
}

TEST_CASE("turning boxes of every family are disjoint until the time of impact", "[turning]") {
  Random random(1125);
  for (const families::Turning family : families::all_turning) {
    for (int round = 0; round < generators::tried(300); ++round) {
      const families::TurningBoxes drawn = families::turning_boxes(random, family);
      std::array<OrientedBox<double>, 2> box;
      std::array<Motion, 2> motion;
      for (std::size_t k = 0; k < 2; ++k) {
        const auto turn = contact::exponential<double>(drawn.rotation[k]);
        box[k] = {drawn.position[k], contact::matrix_of(contact::normalised(turn)),
                  drawn.half_lengths[k]};
        motion[k] = {drawn.position[k], drawn.displacement[k], drawn.angular_displacement[k]};
      }
      INFO(families::name(family) << ", round " << round);
      check_pair(random, box[0], motion[0], box[1], motion[1]);
    }
  }
}

TEST_CASE("a rod that turns towards a half-space stops just before the touch", "[turning]") {
  // Its end is at the height h − L sin φt.
  constexpr double tolerance = 0x1p-30;
  for (const double height : {0.125, 0.5, 0.75, 0.96875}) {
    for (const double angle : {0.5 * pi, pi, 8 * pi}) {
      const contact::Capsule<double> rod{{Vec(-1, 0, height), Vec(1, 0, height)}, 0};
      const Motion motion{Vec(0, 0, height), Vec::Zero(), Vec(0, angle, 0)};
      const contact::HalfSpace<double> floor{{Vec(0, 0, 1), 0}};
      const auto found = contact::turning_impact(rod, motion, floor, tolerance, 4000);
      const double touch = std::asin(height) / angle;
      REQUIRE(found.end == ConservativeEnd::impact);
      CHECK(found.t <= touch);
      // The height falls at the rate φ cos φt, so the tolerance is left for at most twice this.
      CHECK(found.t >= touch - 2 * tolerance / (angle * std::sqrt(1 - height * height)));
    }
  }
}

TEST_CASE("a rod that turns above a half-space within its length passes", "[turning]") {
  const contact::Capsule<double> rod{{Vec(-1, 0, 2), Vec(1, 0, 2)}, 0.5};
  const Motion motion{Vec(0, 0, 2), Vec(5, 0, 0), Vec(0, 20 * pi, 0)};
  const contact::HalfSpace<double> floor{{Vec(0, 0, 1), 0}};
  CHECK(contact::turning_impact(rod, motion, floor, 1e-6, 4000).end == ConservativeEnd::clear);
}

TEST_CASE("a rod that turns fully within a step hits what is beside it", "[turning]") {
  // At both ends of the step the rod has the same pose, away from the ball.
  const contact::Capsule<double> rod{{Vec(-1, 0, 0), Vec(1, 0, 0)}, 0.01};
  const contact::Sphere<double> ball{Vec(0, 0.9, 0), 0.05};
  const Motion turn{Vec::Zero(), Vec::Zero(), Vec(0, 0, 2 * pi)};
  const Motion none{Vec::Zero(), Vec::Zero(), Vec::Zero()};
  const auto found = contact::turning_impact(rod, turn, ball, none, 1e-9, 4000);
  REQUIRE(found.end == ConservativeEnd::impact);
  const double touch = (pi / 2 - std::asin(0.06 / 0.9)) / (2 * pi);
  CHECK(found.t <= touch);
  CHECK(found.t > touch - 1e-8);
}

TEST_CASE("a plane that never closes ends the advances at once", "[turning]") {
  Random random(1126);
  for (int round = 0; round < generators::tried(200); ++round) {
    const auto a = random_body<OrientedBox<double>>(random, Vec(4, 0, 0));
    const auto b = random_body<OrientedBox<double>>(random, Vec(-4, 0, 0));
    const Motion away{Vec(4, 0, 0), Vec(random.uniform(8, 1000), 0, 0), random_vec(random, 1)};
    const Motion none{Vec(-4, 0, 0), Vec::Zero(), Vec::Zero()};
    const auto found = contact::turning_impact(a, away, b, none, 1e-6);
    CHECK(found.end == ConservativeEnd::clear);
    CHECK(found.advances == 1);
  }
}

TEST_CASE("turning bodies that overlap at the start have their impact there", "[turning]") {
  const contact::Sphere<double> ball{Vec::Zero(), 1};
  const Motion away{Vec::Zero(), Vec(9, 0, 0), Vec(1, 2, 3)};
  const Motion none{Vec::Zero(), Vec::Zero(), Vec::Zero()};
  const auto found = contact::turning_impact(ball, away, ball, none, 1e-6);
  CHECK(found.end == ConservativeEnd::impact);
  CHECK(found.t == 0);
  CHECK_FALSE(std::signbit(found.t));
  CHECK(found.distance == 0);
  CHECK(found.normal == Vec(Vec::Zero()));
}

TEST_CASE("turning bodies of any scale have their impact at the same time", "[turning]") {
  Random random(1127);
  for (int round = 0; round < generators::tried(60); ++round) {
    const auto [box, motion] = meeting_boxes(random, random.uniform());
    const auto scaled = [&, &one = box, &other = motion](double factor) {
      std::array<OrientedBox<double>, 2> boxes = one;
      std::array<Motion, 2> motions = other;
      for (std::size_t k = 0; k < 2; ++k) {
        boxes[k].centre *= factor;
        boxes[k].half_lengths *= factor;
        motions[k].centre *= factor;
        motions[k].displacement *= factor;
      }
      return contact::turning_impact(boxes[0], motions[0], boxes[1], motions[1], 0x1p-12 * factor,
                                     4000);
    };
    const auto same = scaled(1);
    for (const double factor : {0x1p-498, 0x1p498}) {
      const auto found = scaled(factor);
      CHECK(found.end == same.end);
      CHECK(std::abs(found.t - same.t) < 0x1p-20);
    }
  }
}

TEST_CASE("turning bodies with a number that is not finite are not advanced", "[turning]") {
  const contact::Sphere<double> ball{Vec(3, 0, 0), 1}, other{Vec::Zero(), 1};
  const Motion none{Vec::Zero(), Vec::Zero(), Vec::Zero()};
  for (const double bad :
       {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    Motion motion = none;
    motion.rotation.x() = bad;
    const auto found = contact::turning_impact(ball, motion, other, none, 1e-6);
    CHECK(found.end == ConservativeEnd::gave_up);
    CHECK(found.t == 0);
    contact::Sphere<double> no_ball = ball;
    no_ball.radius = bad;
    CHECK(contact::turning_impact(no_ball, none, other, none, 1e-6).end ==
          ConservativeEnd::gave_up);
  }
}

TEST_CASE("a half-space without a normal is not met", "[turning]") {
  const contact::Sphere<double> ball{Vec(3, 0, 0), 1};
  const Motion none{Vec::Zero(), Vec::Zero(), Vec::Zero()};
  for (const double offset : {-1.0, 0.0, 1.0}) {
    const contact::HalfSpace<double> nothing{{Vec::Zero(), offset}};
    const auto found = contact::turning_impact(ball, none, nothing, 1e-6);
    CHECK(found.end == ConservativeEnd::gave_up);
    CHECK(found.t == 0);
  }
}

TEST_CASE("a turning impact refuses a tolerance or a count that cannot end", "[turning]") {
  const contact::Sphere<double> ball{Vec(3, 0, 0), 1}, other{Vec::Zero(), 1};
  const Motion none{Vec::Zero(), Vec::Zero(), Vec::Zero()};
  for (const double tolerance : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    CHECK_THROWS_AS(contact::turning_impact(ball, none, other, none, tolerance),
                    std::invalid_argument);
  }
  CHECK_THROWS_AS(contact::turning_impact(ball, none, other, none, 1e-6, 0), std::invalid_argument);
  CHECK_THROWS_AS(contact::turning_motion<double>(
                      Vec::Zero(), Vec(0, std::numeric_limits<double>::infinity(), 0), Vec::Zero()),
                  std::invalid_argument);
}

TEST_CASE("too few advances leave a time before the touch", "[turning]") {
  const contact::Sphere<double> ball{Vec(0, 0.9, 0), 0.05};
  const contact::Capsule<double> rod{{Vec(-1, 0, 0), Vec(1, 0, 0)}, 0.01};
  const Motion turn{Vec::Zero(), Vec::Zero(), Vec(0, 0, 2 * pi)};
  const Motion none{Vec::Zero(), Vec::Zero(), Vec::Zero()};
  double last = 0;
  for (int advances = 1; advances < 4; ++advances) {
    const auto found = contact::turning_impact(rod, turn, ball, none, 1e-12, advances);
    REQUIRE(found.end == ConservativeEnd::gave_up);
    CHECK(found.advances == advances);
    CHECK(found.t > last);
    CHECK(found.t < 0.25);
    last = found.t;
  }
}

TEMPLATE_TEST_CASE("a turning box in float or double stops before a wall", "", float, double) {
  using S = TestType;
  using V = contact::Vector3<S>;
  const OrientedBox<S> box{V(0, 0, 4), contact::Matrix3<S>::Identity(), V(1, 1, 1)};
  const OrientedBox<S> wall{V(0, 0, -1), contact::Matrix3<S>::Identity(), V(9, 9, 1)};
  const TurningMotion<S> falls{V(0, 0, 4), V(0, 0, -4), V(0, 0, 3)};
  const TurningMotion<S> none{V::Zero(), V::Zero(), V::Zero()};
  const auto found = contact::turning_impact(box, falls, wall, none, S(0x1p-12));
  REQUIRE(found.end == ConservativeEnd::impact);
  CHECK(found.t <= S(0.75));
  CHECK(found.t > S(0.749));
  CHECK(found.normal == V(0, 0, 1));
}
