// Right answers come from exact arithmetic on the numbers as they are stored. The first questions
// of a test each bring one mistake to light that no question before did.
#include "contact_force.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>
#include <support/shrinkable.hpp>

#include <contact/exact.hpp>

#include <16_penalty/force_with_mistakes.hpp>

namespace {

using namespace contact::testing;
using contact::Exact;
using exercise::Spring;
using force_with_mistakes::BallWay;
using force_with_mistakes::Way;
using Plane = contact::Plane<double>;
using Sphere = contact::Sphere<double>;
using Vector = Eigen::Vector3d;

// ---------------------------------------------------------------- what is right

Exact right_push(const Exact& penetration, const Exact& approach, const Spring& spring) {
  if (penetration.sign() < 0) return Exact(0.0);
  const Exact sum = Exact(spring.stiffness) * penetration + Exact(spring.damping) * approach;
  return sum.sign() < 0 ? Exact(0.0) : sum;
}

double rounded(const Exact& x) { return quotient<double>(x, Exact(1.0)); }

Exact along(const Vector& normal, const Vector& v) {
  Exact sum;
  for (int i = 0; i < 3; ++i) sum += Exact(normal(i)) * Exact(v(i));
  return sum;
}

Exact exact_penetration(const Sphere& ball, const Plane& surface) {
  return Exact(ball.radius) - along(surface.normal, ball.centre) + Exact(surface.offset);
}

// ---------------------------------------------------------------- questions

void check_force(double penetration, double approach, const Spring& spring) {
  const auto with = [&](Way way) {
    return [&, way] { return force_with_mistakes::force(penetration, approach, spring, way); };
  };
  std::vector<Suspect<double>> suspects;
  // A hint must be true of the answer in hand: these are asked only where it is.
  const auto suspect = [&](std::string_view id, Way way, bool where) {
    if (where) suspects.push_back({id, with(way)});
  };
  const bool contact = penetration >= 0;
  const double sum = spring.stiffness * penetration + spring.damping * approach;
  suspect("spring-energy-for-force", Way::energy, contact);
  suspect("contact-damper-left-out", Way::no_damper, contact && approach != 0);
  suspect("contact-damper-reversed", Way::damper_reversed, contact && approach != 0);
  suspect("contact-damper-by-depth", Way::damper_by_depth, contact && approach != 0);
  suspect("contact-damper-one-way", Way::damper_one_way, contact && approach < 0);
  suspect("contact-damper-by-speed", Way::speed, contact && approach < 0);
  suspect("contact-ends-at-greatest-depth", Way::ends_at_depth, contact && approach < 0);
  suspect("contact-pulls", Way::pulls, contact && sum < 0);
  suspect("pull-becomes-a-push", Way::magnitude, contact && sum < 0);
  suspect("contact-damper-let-go-alone", Way::damper_let_go, contact && sum < 0);
  suspect("touching-without-force", Way::touching_missed, penetration == 0);
  suspect("force-across-a-gap", Way::across_a_gap, !contact);
  suspect("force-across-a-gap", Way::pulls_over_a_gap, !contact);
  const double size =
      spring.stiffness * std::abs(penetration) + spring.damping * std::abs(approach);
  // Two products and a sum: 2 u of the magnitudes.
  ask("What is the force of the spring and the damper?")
      .given("penetration", penetration)
      .given("approach", approach)
      .given("spring", spring)
      .suspects(std::move(suspects))
      .answer([&] { return exercise::contact_force(penetration, approach, spring); })
      .close_to(rounded(right_push(Exact(penetration), Exact(approach), spring)),
                within(8 * 0x1p-53 * size));
}

void check_ball(const Sphere& ball, const Vector& velocity, const Plane& surface,
                const Spring& spring) {
  const Exact penetration = exact_penetration(ball, surface);
  const Exact approach = Exact(0.0) - along(surface.normal, velocity);
  const Exact push = right_push(penetration, approach, spring);
  const Vector right{rounded(push * Exact(surface.normal.x())),
                     rounded(push * Exact(surface.normal.y())),
                     rounded(push * Exact(surface.normal.z()))};
  const auto with = [&](BallWay way) {
    return [&, way] {
      return force_with_mistakes::force_on_ball(ball, velocity, surface, spring, way);
    };
  };
  std::vector<Suspect<Vector>> suspects;
  const auto suspect = [&](std::string_view id, BallWay way, bool where) {
    if (where) suspects.push_back({id, with(way)});
  };
  const double towards = rounded(approach);
  const bool contact = penetration.sign() >= 0;
  // Along the normal alone, the mistakes with the whole velocity look like others.
  const bool slides = surface.normal.cross(velocity).norm() > 1e-6;
  const bool inside = (penetration - Exact(ball.radius)).sign() > 0;
  suspect("penetration-of-the-centre", BallWay::centre, true);
  suspect("penetration-by-the-diameter", BallWay::diameter, true);
  suspect("half-space-with-two-sides", BallWay::either_side, inside);
  suspect("plane-offset-added", BallWay::offset_added, surface.offset != 0);
  suspect("force-into-the-surface", BallWay::into, contact);
  suspect("approach-with-the-wrong-sign", BallWay::moving_away, contact && towards != 0);
  suspect("speed-for-the-approach", BallWay::whole_speed, contact && slides);
  suspect("damper-against-the-whole-velocity", BallWay::whole_damper, contact && slides);
  suspect("force-against-the-velocity", BallWay::along_path, contact && slides);
  suspect("ball-is-pulled", BallWay::pulled, contact && towards < 0 && push.sign() == 0);
  // The penetration is off by 4 u (Σ|nᵢ cᵢ| + |k| + r), the approach by 3 u Σ|nᵢ vᵢ|, and each is
  // multiplied, added and multiplied by the normal: 4 times as much is allowed.
  const Vector magnitudes = surface.normal.cwiseAbs();
  const double length =
      magnitudes.dot(ball.centre.cwiseAbs()) + std::abs(surface.offset) + ball.radius;
  const double speed = magnitudes.dot(velocity.cwiseAbs());
  const double bound = 32 * 0x1p-53 * (spring.stiffness * length + spring.damping * speed);
  ask("What is the force of the half-space on the ball?")
      .given("ball", ball)
      .given("velocity", velocity)
      .given("surface", surface)
      .given("spring", spring)
      .suspects(std::move(suspects))
      .answer([&] { return exercise::force_on_ball(ball, velocity, surface, spring); })
      .close_to(right, within(bound));
}

bool is_spring(const Spring& spring) {
  return spring.stiffness > 0 && spring.damping >= 0 && spring.stiffness <= 1e4 &&
         spring.damping <= 1e4;
}

bool is_state(double penetration, double approach, const Spring& spring) {
  return is_spring(spring) && std::abs(penetration) <= 100 && std::abs(approach) <= 100;
}

/// Whether rounding cannot change whether they touch.
bool is_clear(const Sphere& ball, const Vector& velocity, const Plane& surface,
              const Spring& spring) {
  if (!(ball.radius > 0) || !is_spring(spring)) return false;
  if (std::abs(surface.normal.norm() - 1) > 1e-15) return false;
  const double size = std::max({ball.centre.cwiseAbs().maxCoeff(), ball.radius,
                                velocity.cwiseAbs().maxCoeff(), std::abs(surface.offset)});
  const double penetration = ball.radius - surface.normal.dot(ball.centre) + surface.offset;
  return size <= 100 && std::abs(penetration) >= 1e-3;
}

const Spring kSpring{8, 2};
// The half-space z <= -1, and a ball that overlaps with it by 0.5 m.
const Plane kFloor{{0, 0, 1}, -1};
const Sphere kBall{{1, 2, 1.5}, 3};

}  // namespace

TEST_CASE("a spring pushes in proportion to the penetration") {
  check_force(0.5, 0, kSpring);
  check_force(1.5, 0, kSpring);
  check_force(0.25, 0, {64, 0});
  check_force(1e-170, 0, {1e10, 0});
}

TEST_CASE("in approach the damper adds to the force") {
  check_force(0.5, 3, kSpring);
  check_force(1.5, 1, {2, 10});
  check_force(0.5, 3, {8, 0});
}

TEST_CASE("in separation the damper reduces the force") {
  check_force(1, -2, kSpring);
  check_force(1.5, -1, kSpring);
  check_force(0.5, -2, kSpring);
  check_force(2, -9, {4, 0});
}

TEST_CASE("a contact does not pull") {
  check_force(0.5, -5, kSpring);
  check_force(0, -1, kSpring);
  check_force(1, -5, kSpring);
  check_force(1, -3, kSpring);
}

TEST_CASE("touching is a contact and a gap is none") {
  check_force(0, 3, kSpring);
  check_force(-0.5, 5, kSpring);
  check_force(-0.5, 1, kSpring);
  check_force(-0x1p-1000, 3, kSpring);
  check_force(0, 0.25, {1, 4});
}

TEST_CASE("a ball at rest overlaps with the floor") {
  check_ball(kBall, {0, 0, 0}, kFloor, kSpring);
  check_ball({{1, 2, 2}, 3}, {0, 0, 0}, kFloor, kSpring);
  check_ball({{1, 2, 2.5}, 3}, {0, 0, 0}, kFloor, kSpring);
  check_ball({{4, 1, 6}, 5}, {0, 0, 0}, {{0.6, 0, 0.8}, 2.5}, kSpring);
}

TEST_CASE("the velocity along the normal counts alone") {
  check_ball(kBall, {3, 4, 0}, kFloor, kSpring);
  check_ball(kBall, {3, 0, -1}, kFloor, kSpring);
  check_ball(kBall, {-8, 6, 1}, kFloor, kSpring);
}

TEST_CASE("a ball that leaves is not pulled back") {
  check_ball(kBall, {0, 0, 1}, kFloor, kSpring);
  check_ball(kBall, {0, 0, 5}, kFloor, kSpring);
  check_ball(kBall, {2, 1, 3}, kFloor, kSpring);
}

TEST_CASE("a ball with its centre inside is pushed out") {
  check_ball({{1, 2, -2}, 3}, {0, 0, 0}, kFloor, kSpring);
  check_ball({{1, 2, -9}, 3}, {1, 0, 2}, kFloor, kSpring);
  check_ball({{1, 2, -9}, 0.5}, {1, 0, -2}, kFloor, kSpring);
}

TEST_CASE("random contacts agree with exact arithmetic") {
  generators::Random random(seed(0));
  const auto vector = [&](double size) {
    return Vector{random.uniform(-size, size), random.uniform(-size, size),
                  random.uniform(-size, size)};
  };
  for (int asked = 0; asked < 300;) {
    const Vector normal = vector(1), centre = vector(4), velocity = vector(4);
    if (normal.norm() < 0.1) continue;
    const Plane surface{normal.normalized(), random.uniform(-2, 2)};
    const Sphere ball{centre, random.uniform(0.5, 4)};
    const Spring spring{random.uniform(1, 50), random.uniform(0, 20)};
    const double penetration = random.uniform(-0.5, 2);
    const double approach = random.uniform(-5, 5);
    if (!is_clear(ball, velocity, surface, spring)) continue;
    ++asked;
    shrinkable(check_force, is_state, penetration, approach, spring);
    shrinkable(check_ball, is_clear, ball, velocity, surface, spring);
  }
}
