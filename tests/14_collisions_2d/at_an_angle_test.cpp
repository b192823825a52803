// Angles go through sine, cosine and arctangent, which differ in their last digits from library to
// library; and a π written with twelve digits is off by 1e-12. So answers may have an error of
// 1e-10 of their terms. Every test asks for at least two different answers, so that
// no constant passes one.
#include "at_an_angle.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>

namespace {

using namespace contact::testing;
using exercise::Motion;
using exercise::Sizes;
using exercise::Vehicle;
using Vector = Eigen::Vector2d;

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kRoom = 1e-10;

/// Mass times velocity, with the heading in degrees times `unit`.
Vector momentum(const Vehicle& v, double unit = kDegree) {
  return v.mass * v.speed * Vector(std::cos(v.heading * unit), std::sin(v.heading * unit));
}

Motion motion(const Vector& p, double mass) {
  return {p.norm() / mass, std::atan2(p.y(), p.x()) / kDegree};
}

void check_crash(const Vehicle& a, const Vehicle& b) {
  const Vector p = momentum(a) + momentum(b);
  const double mass = a.mass + b.mass;
  const double scale = a.mass * a.speed + b.mass * b.speed;
  const Motion right = motion(p, mass);
  // An angle is off by the error of the momentum over its magnitude.
  const Motion room{kRoom * scale / mass, kRoom * scale / p.norm() / kDegree + kRoom * 180};
  ask("What is the motion of the wreck?")
      .given("a", a)
      .given("b", b)
      .suspect("degrees-in-sin", [&] { return motion(momentum(a, 1) + momentum(b, 1), mass); })
      .suspect("momenta-as-numbers",
               [&]() -> Motion {
                 return {scale / mass, right.heading};
               })
      .suspect("heading-quadrant-lost",
               [&]() -> Motion {
                 return {right.speed, std::atan(p.y() / p.x()) / kDegree};
               })
      .suspect("angle-from-the-other-axis",
               [&]() -> Motion {
                 return {right.speed, std::atan2(p.x(), p.y()) / kDegree};
               })
      .suspect("mean-of-velocities",
               [&] { return motion(momentum(a) / a.mass + momentum(b) / b.mass, 2); })
      .answer([&] { return exercise::stuck_together(a, b); })
      .close_to(right, within(room));
}

void check_triangle(double total, double angle_a, double angle_b) {
  const auto sizes = [&](double unit) -> Sizes {
    const double whole = std::sin((angle_a + angle_b) * unit);
    return {total * std::sin(angle_b * unit) / whole, total * std::sin(angle_a * unit) / whole};
  };
  const Sizes right = sizes(kDegree);
  // The sine in the denominator is off by that of the angle.
  const double room = 4 * kRoom / std::sin((angle_a + angle_b) * kDegree);
  ask("What are the momenta of the two balls?")
      .given("total", total)
      .given("angle_a", angle_a)
      .given("angle_b", angle_b)
      .suspect("degrees-in-sin", [&] { return sizes(1); })
      .suspect("sine-of-own-angle",
               [&]() -> Sizes {
                 return {right.b, right.a};
               })
      .suspect("right-angle-assumed",
               [&]() -> Sizes {
                 return {total * std::cos(angle_a * kDegree), total * std::cos(angle_b * kDegree)};
               })
      .answer([&] { return exercise::leaving_at(total, angle_a, angle_b); })
      .close_to(right, within(Sizes{room * total, room * total}));
}

}  // namespace

TEST_CASE("car and van along the axes") {
  check_crash({1500, 16, 0}, {2000, 9, 90});
  check_crash({1200, 20, 90}, {1800, 5, 0});
  check_crash({1000, 10, 0}, {1000, 10, 90});
}

TEST_CASE("any headings, in every quadrant") {
  check_crash({1500, 16, 30}, {2000, 9, 75});
  check_crash({1500, 16, 150}, {2000, 9, 100});
  check_crash({1500, 16, -150}, {2000, 9, -100});
  check_crash({1500, 16, -20}, {2000, 9, -80});
}

TEST_CASE("the triangle with a right angle") {
  check_triangle(10, 40, 50);
  check_triangle(3, 30, 60);
}

TEST_CASE("the triangle of 30, 35 and 115 degrees") {
  check_triangle(10, 35, 30);
  check_triangle(10, 30, 35);
  check_triangle(4, 100, 25);
}

TEST_CASE("random crashes and triangles") {
  generators::Random random(seed(0));
  for (int asked = 0; asked < 200;) {
    const Vehicle a{random.uniform(500, 3000), random.uniform(0, 40), random.uniform(-179, 179)};
    const Vehicle b{random.uniform(500, 3000), random.uniform(0, 40), random.uniform(-179, 179)};
    const Vector p = momentum(a) + momentum(b);
    // A momentum that cancels has no heading, and -180 degrees are 180.
    if (p.norm() < 0.1 * (a.mass * a.speed + b.mass * b.speed)) continue;
    if (p.x() < 0 && std::abs(p.y()) < 1e-3 * p.norm()) continue;
    check_crash(a, b);
    const double angle_a = random.uniform(5, 85);
    const double momentum_before = random.uniform(0.1, 50);
    check_triangle(momentum_before, angle_a, random.uniform(5, 85));
    ++asked;
  }
}
