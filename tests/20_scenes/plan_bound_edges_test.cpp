// Bounds at their edges: shapes, what energy allows, which pairs may meet. Each scene was made for
// one term of a bound, so that a bound without it, or with another in its place, is too small for a
// possible motion.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/plan/plan.hpp>
#include <contact/plan/plan_bounds.hpp>
#include <contact/quaternion.hpp>
#include <contact/scene/scene_runs.hpp>

#include "plan_at_edge.hpp"
#include "plan_scenes.hpp"
#include "support/generators.hpp"
#include "support/oracle.hpp"

using contact::Decision;
using contact::Effect;
using contact::Scene;
using contact::SceneBounds;
using generators::Random;
using generators::tried;
using oracle::exact;
using oracle::Rational;
using plan_scenes::ball;
using plan_scenes::box;
using plan_scenes::decision;
using plan_scenes::dropped;
using plan_scenes::empty;
using plan_scenes::free_ball;
using plan_scenes::Point;
using plan_scenes::stepped;
using plan_scenes::unbounded;
using plan_scenes::wall;

TEST_CASE("thickness and bounding radius of a shape, whichever side is longest") {
  using contact::inner_radius;
  using contact::outer_radius;
  for (const Point& half : {Point(2, 1, 3), Point(1, 2, 3), Point(3, 2, 1)}) {
    CHECK(inner_radius(contact::BoxShape{half}) == 1);
    CHECK(exact(outer_radius(contact::BoxShape{half})) * outer_radius(contact::BoxShape{half}) >=
          14);
    CHECK(contact::rotation_radius(contact::BoxShape{half}) >= 3.74);
  }
  CHECK(inner_radius(contact::CapsuleShape{0.5, 2}) == 0.5);
  CHECK(outer_radius(contact::CapsuleShape{0.5, 2}) >= 2.5);
  contact::HullShape hull;
  hull.points = {Point(3, 0, 0), Point(-1, 1, 0), Point(-1, -1, 0), Point(-1, 0, 1)};
  CHECK(inner_radius(hull) == 0);
  CHECK(outer_radius(hull) >= 3);
  CHECK_FALSE(contact::is_proven({}));
}

TEST_CASE("a distance is never overestimated, to the last bit") {
  Random random(40);
  for (int trial = 0; trial < tried(1000); ++trial) {
    const auto any = [&](double size) {
      const double x = random.uniform(-size, size);
      const double y = random.uniform(-size, size);
      return Point(x, y, random.uniform(-size, size));
    };
    const Point p = any(9);
    const auto far_from = [](const Point& x) { return Point(x * 1024); };
    CAPTURE(trial);
    // A half-space whose normal is as long as 1 but for rounding: D n = n · p − d.
    Scene scene = empty(1, 0, 1, 0);
    const Point normal = random.chance(0.5) ? Point::UnitZ() : any(1).normalized();
    wall(scene, normal, random.uniform(-1, 1));
    const Rational along = exact(normal).dot(exact(p)) -
                           exact(std::get<contact::HalfSpaceShape>(scene.bodies[0].shape).offset);
    const Rational squared = exact(normal).dot(exact(normal));
    const Rational far = exact(contact::distance_at_least(scene.bodies[0], p));
    REQUIRE((far <= 0 || far * far * squared <= along * along));
    REQUIRE(far <= abs(along) * 2);
    // A ball, and a box that lies straight: both are squares of fractions.
    ball(scene, random.uniform(0.1, 1), 0, any(1));
    const double radius = contact::inner_radius(scene.bodies[1].shape);
    const auto d = oracle::Vector(exact(p) - exact(scene.bodies[1].position));
    const Rational from_ball =
        exact(contact::distance_at_least(scene.bodies[1], p)) + exact(radius);
    REQUIRE((from_ball <= 0 || from_ball * from_ball <= d.dot(d)));
    const Point half(0.5, 0.75, random.uniform(0.1, 1));
    box(scene, half, 0, any(1));
    Rational square = 0;
    for (int k = 0; k < 3; ++k) {
      const Rational outside =
          abs(exact(p(k)) - exact(scene.bodies[2].position(k))) - exact(half(k));
      if (outside > 0) square += outside * outside;
    }
    const Rational from_box = exact(contact::distance_at_least(scene.bodies[2], p));
    REQUIRE((from_box <= 0 || from_box * from_box <= square));
    // A box and a capsule, rotated by a quaternion of length 1 to 10⁻¹²: its rotation, divided by
    // the square of its length below, is a matrix of fractions.
    auto turned = contact::exponential<double>(any(2));
    const double longer = 1 + random.uniform(-5e-13, 5e-13);
    turned = {turned.w * longer, turned.v * longer};
    box(scene, half, 0, any(1)).orientation = turned;
    plan_scenes::add(scene, contact::CapsuleShape{radius, 0.5}, 0, any(1)).orientation = turned;
    const Rational w = exact(turned.w);
    const oracle::Vector v = exact(turned.v);
    const Rational length = w * w + v.dot(v);
    // The rotor back: x − 2 w (v × x) + 2 v × (v × x), over the length.
    const auto seen = [&](const oracle::Vector& x) {
      const oracle::Vector once = v.cross(x);
      const oracle::Vector twice = v.cross(once);
      return oracle::Vector(x + (twice - once * w) * (2 / length));
    };
    for (const auto* body : {&scene.bodies[3], &scene.bodies[4]}) {
      const oracle::Vector at = seen(oracle::Vector(exact(far_from(p)) - exact(body->position)));
      Rational right = 0;
      Rational thick = 0;
      if (body == &scene.bodies[3]) {
        for (int k = 0; k < 3; ++k) {
          const Rational outside = abs(at(k)) - exact(half(k));
          if (outside > 0) right += outside * outside;
        }
      } else {
        const Rational over = abs(at.z()) - exact(0.5);
        thick = exact(radius);
        right = at.x() * at.x() + at.y() * at.y() + (over > 0 ? over * over : Rational(0));
      }
      const Rational from = exact(contact::distance_at_least(*body, far_from(p))) + thick;
      REQUIRE((from <= 0 || from * from <= right));
    }
  }
}

TEST_CASE("the moments of inertia of a body rotated in its own axes") {
  Random random(41);
  for (int trial = 0; trial < tried(200); ++trial) {
    // [[a, b], [b, a]] has the moments a ± b: whole numbers here.
    const int a = random.integer(20, 40);
    const int b = random.integer(1, 10);
    contact::Matrix3<double> inertia = contact::Matrix3<double>::Zero();
    inertia(0, 0) = inertia(2, 2) = a;
    inertia(0, 2) = inertia(2, 0) = b;
    inertia(1, 1) = a + random.integer(-b, b);
    const contact::MomentRange range = contact::moment_range(inertia);
    REQUIRE(range.min <= a - b);
    REQUIRE(range.max >= a + b);
    REQUIRE(range.max <= (a + b) * (1 + 1e-12));
  }
}

TEST_CASE("the bound on the speed of a plate's point is what its energy allows") {
  // A thin plate of 1 m half-lengths that flies at 1 m/s along its normal and rotates about a
  // diagonal: its moment of inertia there is ⅓ kg m², and a corner is at √2 m. At 6/√2 rad/s the
  // corner adds 6 m/s. 2 K is 1 + ⅓ · 18 = 7 J, and 7 m/s is the most that 7 J can give: 1/m + R²/I
  // = 7.
  const auto plates = [](double speed) {
    Scene scene = empty(1, 0, 1, 1e-6);
    box(scene, {1, 1, 0x1p-20}, 1, {0, 0, -2}, {0, 0, speed});
    return scene;
  };
  // One has 14 J. Two like that could use it to approach each other at 14 m/s.
  Scene two = plates(std::sqrt(14.0));
  box(two, {1, 1, 0x1p-20}, 1, Point::Zero());
  const auto pair = contact::scene_bounds(two).pairs.at(0);
  CHECK(pair.closing >= 14 * (1 - 1e-6));
  CHECK(pair.closing <= 14 * (1 + 1e-6));
  // With a ball it is 7 for the plate and 1 for the ball.
  for (const bool ball_first : {false, true}) {
    Scene beside = plates(std::sqrt(7.0));
    ball(beside, 0.5, 1, Point::Zero());
    if (ball_first) std::swap(beside.bodies[0], beside.bodies[1]);
    CHECK(contact::scene_bounds(beside).pairs.at(0).closing >= std::sqrt(56) * (1 - 1e-6));
  }
}

TEST_CASE("tunnelling: the end of a rod is faster than its centre, and a plate is thin") {
  // The rod's end rotates by 0.8 rad a step about its centre: the chord is 0.78 m, and two radii of
  // ¼ m and 0.05 m together are 0.6 m. At the speed of its energy all of it would move 0.47 m.
  const double h = 0.2;
  Scene rod = empty(0.5, 0, 1, 1e9);
  plan_scenes::add(rod, contact::CapsuleShape{0.05, 1}, 1, Point::Zero()).angular_velocity = {4, 0,
                                                                                              0};
  ball(rod, 0.25, 1e6, {0, -std::sin(0.4) * 0.9, std::cos(0.4) * 0.9});
  CHECK_FALSE(contact::holds(
      decision(rod, Effect::continuous_detection, stepped(h)).tried.at(1).conditions.at(0)));
  // A bullet of 5 cm and a plate of 5 cm half thickness: 0.2 m, not their bounding radii.
  Scene bullet = empty(0.5, 0, 1, 1e9);
  ball(bullet, 0.05, 1, {-1.25, 0, 0}, {2.5, 0, 0});
  box(bullet, {0.05, 1, 1}, 0, Point::Zero());
  const auto passing =
      decision(bullet, Effect::continuous_detection, stepped(0.1)).tried.at(1).conditions.at(0);
  CHECK_FALSE(contact::holds(passing));
  CHECK(passing.right <= 0.2);
  // A large ball and a small one: twice the sum, not four times the larger.
  Scene unlike = empty(0.5, 0, 1, 1e9);
  ball(unlike, 0.05, 1, {-1.25, 0, 0}, {7, 0, 0});
  ball(unlike, 0.25, 1e9, Point::Zero());
  CHECK_FALSE(contact::holds(
      decision(unlike, Effect::continuous_detection, stepped(0.1)).tried.at(1).conditions.at(0)));
}

TEST_CASE("tunnelling: the worst of several pairs counts, in any order") {
  // Fast and thick, 0.5 < 4; slow and thin, 0.25 > 0.2.
  for (const bool thin_first : {false, true}) {
    Scene scene = empty(0.5, 0, 1, 1e9);
    const auto thin = [&] {
      ball(scene, 0.05, 1, {-1, 0, 0}, {2.5, 0, 0});
      ball(scene, 0.05, 1e9, {0, 0, 0});
    };
    if (thin_first) thin();
    ball(scene, 1, 1, {-4, 100, 0}, {5, 0, 0});
    ball(scene, 1, 1e9, {0, 100, 0});
    if (!thin_first) thin();
    const Decision made = decision(scene, Effect::continuous_detection, stepped(0.1));
    CHECK_FALSE(contact::holds(made.tried.at(1).conditions.at(0)));
    // And the step is not proven, whatever lateness costs.
    const Decision step = decision(scene, Effect::step_size, stepped(0.1));
    CHECK_FALSE(step.proven);
  }
}

TEST_CASE("a light ball is as fast as a heavy one that falls on it can make it") {
  Scene scene = empty(1, 0, 1, 1e-6);
  scene.gravity = {0, 0, -8};
  ball(scene, 0.5, 0, Point::Zero());
  ball(scene, 0.5, 1, {0, 0, 2});
  ball(scene, 0.5, 1000, {0, 0, 3.2});
  const SceneBounds bounds = contact::scene_bounds(scene);
  const auto run = contact::scenes::make_run(scene, contact::plan_scene(scene));
  double fastest = 0;
  double farthest = 0;
  for (int k = 1; k <= 64; ++k) {
    run->advance(k / 64.0);
    fastest = std::max(fastest, run->velocity(1).norm());
    farthest = std::max(farthest, (run->position(1) - scene.bodies[1].position).norm());
  }
  CHECK(fastest > 8);  // than which it would not be by itself
  CHECK(fastest <= bounds.bodies[1].speed);
  CHECK(farthest <= bounds.bodies[1].travel);
  // 2 K = 1001 · 8² at most, if all of it were the light one's.
  CHECK(bounds.bodies[1].speed >= 8 * std::sqrt(1001.0) * (1 - 1e-9));
  CHECK(bounds.bodies[1].travel >= 4 * std::sqrt(1001.0) * (1 - 1e-9));
}

TEST_CASE("a body falls to a floor as far as its thickness allows, on a slope without end") {
  // A box that is 6 m high ends lying, 1 m high.
  Scene standing = empty(0, 0, 100, 0);
  standing.gravity = {0, 0, -8};
  wall(standing, Point::UnitZ(), 0);
  box(standing, {2, 3, 1}, 1, {0, 0, 6});
  CHECK(exact(contact::plan_scene(standing).speed) * contact::plan_scene(standing).speed >=
        2 * 8 * 5);
  // Down a slope of 3 in 5, for ten seconds.
  Scene slope = empty(0, 0, 10, 0);
  slope.gravity = {0, 0, -8};
  wall(slope, {0.6, 0, 0.8}, 0);
  ball(slope, 0.5, 1, Point(0.6, 0, 0.8) * 0.5);
  CHECK(contact::plan_scene(slope).speed >= 8 * 0.6 * 10);
  // Gravity oblique to the floor's normal: it slides off along the floor.
  Scene aside = dropped(0, 0, 10, 0);
  aside.gravity = {6, 0, -8};
  CHECK(contact::plan_scene(aside).speed >= 6 * 10);
  // Weak gravity has time.
  Scene weak = dropped(0, 1024, 1e6, 0);
  weak.gravity = {0, 0, -0x1p-11};
  CHECK(exact(contact::plan_scene(weak).speed) * contact::plan_scene(weak).speed >= 1);
  // The size of oblique gravity includes all of its components.
  Scene asymmetric = free_ball(0, 10, 1e-6);
  asymmetric.gravity = {3, 4, -12};
  CHECK(contact::plan_scene(asymmetric).speed >= 13 * 10);
  // A ball that starts within its floor still has all of its speed.
  Scene deep = dropped(0, -1e-6, 100, 0);
  deep.bodies[1].velocity = {0.1, 0, 0};
  CHECK(contact::plan_scene(deep).speed >= 0.1);
  // Half an ulp of a height counts: 0.5 + 2^-53 is above a floor at −3 · 2^-56 by more than 2^-53.
  Scene hair = dropped(0, 0, 100, 0);
  std::get<contact::HalfSpaceShape>(hair.bodies[0].shape).offset = -0x1.8p-55;
  hair.bodies[1].position.z() = 0.5 + 0x1p-53;
  const Rational height = exact(0x1p-53) + exact(0x1.8p-55);
  CHECK(exact(contact::plan_scene(hair).speed) * contact::plan_scene(hair).speed >= 2 * 8 * height);
}

TEST_CASE("rotation is energy: of the largest moment of inertia, and with any friction") {
  Scene scene = empty(1, 0, 1, 1e-6);
  box(scene, {1, 2, 3}, 1, Point::Zero()).angular_velocity = {2, 0,
                                                              0};  // about x the moment is 13/3
  ball(scene, 0.5, 1, {5, 0, 0}, {-2, 0, 0});
  const double twice = 13.0 / 3 * 4 + 4;
  CHECK(contact::plan_scene(scene).speed >= std::sqrt(twice) * (1 - 1e-9));
  Scene rolling = empty(0, 0x1p-40, 3, 1e-6);
  rolling.gravity = {0, 0, -8};
  wall(rolling, Point::UnitZ(), 0);
  ball(rolling, 0.5, 1, {0, 0, 0.5}).angular_velocity = {0, 100, 0};
  ball(rolling, 0.5, 1, {5, 0, 0.5});
  CHECK(contact::plan_scene(rolling).pairs == 3);
}

TEST_CASE("bodies that just touch in exact fractions meet, whatever rounding says") {
  Random random(42);
  for (int trial = 0; trial < tried(600); ++trial) {
    const double v = random.uniform(0.5, 30);
    const double t = random.uniform(0.1, 3);
    const double radius = random.uniform(0.1, 1);
    const double other = random.uniform(0.1, 1);
    const double start = random.uniform(-5000, 5000);
    const Rational reach = exact(start) + exact(v) * exact(t) + exact(radius);
    // A position that is not beyond that.
    double place = oracle::nearest(reach);
    if (exact(place) > reach) place = std::nextafter(place, -unbounded);
    double centre = oracle::nearest(Rational(reach + exact(other)));
    if (exact(centre) > reach + exact(other)) centre = std::nextafter(centre, -unbounded);
    CAPTURE(trial);
    const auto thrown = [&] {
      Scene scene = empty(1, 0, t, 1e-6);
      ball(scene, radius, 1, {start, 0, 0}, {v, 0, 0});
      return scene;
    };
    Scene at_wall = thrown();
    wall(at_wall, -Point::UnitX(), -place);
    REQUIRE(contact::plan_scene(at_wall).pairs == 1);
    for (const double mass : {0.0, 1.0}) {
      Scene at_ball = thrown();
      ball(at_ball, other, mass, {centre, 0, 0});
      REQUIRE(contact::plan_scene(at_ball).pairs == 1);
    }
  }
}

TEST_CASE("a parabola is met at its very end") {
  // 4 m in the second: in the last 64th it bends by all of g dt²/8.
  for (const bool on_a_ball : {false, true}) {
    Scene scene = dropped(0.5, 4 * (1 - 1e-12), 1);
    if (on_a_ball) {
      scene.bodies[0].shape = contact::BallShape{8};
      scene.bodies[0].position = {0, 0, -8};
    }
    CHECK(contact::plan_scene(scene).pairs == 1);
  }
}

TEST_CASE("a thrown body reaches as far as both paths go, and with its vertices") {
  // Two balls meet; the second may then fly at 4 m/s for 1 s, and the third arrives at 3 m/s.
  const auto third = [](double gap) {
    Scene scene = empty(1, 0, 1, 1e-6);
    ball(scene, 0.5, 1, {-1.5, 0, 0}, {4, 0, 0});
    ball(scene, 0.5, 1, Point::Zero());
    ball(scene, 0.5, 1, {0, 1 + gap, 0}, {0, 0, -3});
    return contact::scene_bounds(scene).bodies[2].disturbed;
  };
  CHECK(third(6.9));
  CHECK_FALSE(third(7.1));
  // A box that is hit may rotate: its corners are √14 m from its centre.
  const auto corner = [](double gap) {
    Scene scene = empty(1, 0, 1, 1e-6);
    ball(scene, 0.5, 1, {-2, 0, 0}, {2, 0, 0});
    box(scene, {1, 2, 3}, 1, Point::Zero());
    wall(scene, -Point::UnitX(), -gap);
    return contact::scene_bounds(scene).pairs.size();
  };
  CHECK(corner(2 + 3.7) == 2);  // the ball can reach neither
  CHECK(corner(2 + 3.8) == 1);
}
