// Right answers are polynomials of the input without rounding; velocities are rounded once. Every
// test asks for at least two different answers, so that no constant passes one.
#include "contact_velocity.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>
#include <support/shrinkable.hpp>

#include <contact/exact.hpp>

namespace {

using namespace contact::testing;
using contact::Exact;
using exercise::Closing;
using exercise::Motion;
using Vector = Eigen::Vector3d;

Exact exact_velocity(const Motion& body, const Vector& p, int k) {
  const int y = (k + 1) % 3;
  const int z = (k + 2) % 3;
  const auto lever_arm = [&](int i) { return Exact(p(i)) - Exact(body.centre(i)); };
  return Exact(body.velocity(k)) + Exact(body.angular_velocity(y)) * lever_arm(z) -
         Exact(body.angular_velocity(z)) * lever_arm(y);
}

void check_velocity(const Motion& body, const Vector& p) {
  Vector right;
  Vector bound;
  const Vector lever_arm = (p - body.centre).cwiseAbs();
  const Vector angular_velocity = body.angular_velocity.cwiseAbs();
  for (int k = 0; k < 3; ++k) {
    const int y = (k + 1) % 3;
    const int z = (k + 2) % 3;
    right(k) = rounded<double>(exact_velocity(body, p, k));
    // Difference, product, difference, sum: 4 u of the terms, 1 u of the oracle's. Doubled.
    bound(k) = 10 * 0x1p-53 *
               (std::abs(body.velocity(k)) + angular_velocity(y) * lever_arm(z) +
                angular_velocity(z) * lever_arm(y));
  }
  ask("What is the velocity of the body's point at `point`?")
      .given("body", body)
      .given("point", p)
      .suspect("omega-cross-r-reversed",
               [&]() -> Vector {
                 return body.velocity +
                        Vector(Vector(p - body.centre).cross(body.angular_velocity));
               })
      .suspect("arm-from-origin",
               [&]() -> Vector { return body.velocity + Vector(body.angular_velocity.cross(p)); })
      .suspect("spin-left-out", [&]() -> Vector { return body.velocity; })
      .answer([&] { return exercise::velocity_of_point(body, p); })
      .close_to(right, within(bound));
}

int sign_of_closing(const Motion& a, const Motion& b, const Vector& p, const Vector& n) {
  Exact sum;
  for (int k = 0; k < 3; ++k) {
    sum += Exact(n(k)) * (exact_velocity(a, p, k) - exact_velocity(b, p, k));
  }
  return sum.sign();
}

Closing case_of(int sign) {
  return sign < 0 ? Closing::approaching : sign > 0 ? Closing::separating : Closing::touching;
}

/// The coordinates are small multiples of one half, so no order of summation rounds.
void check_closing(const Motion& a, const Motion& b, const Vector& p, const Vector& n) {
  const int sign = sign_of_closing(a, b, p, n);
  const auto with = [&](const auto& velocity) {
    const double v = n.dot(Vector(velocity(a) - velocity(b)));
    return case_of((v > 0) - (v < 0));
  };
  ask("Do the two bodies approach each other, touch or separate?")
      .given("a", a)
      .given("b", b)
      .given("point", p)
      .given("normal", n)
      .suspect_if("touching-closes",
                  [&](const Closing& got) { return sign == 0 && got == Closing::approaching; })
      .suspect("other-body-at-rest",
               [&] {
                 const double v = n.dot(
                     Vector(a.velocity + Vector(a.angular_velocity.cross(Vector(p - a.centre)))));
                 return case_of((v > 0) - (v < 0));
               })
      .suspect("normal-from-a-to-b", [&] { return case_of(-sign); })
      .suspect("spin-left-out",
               [&] { return with([](const Motion& m) -> Vector { return m.velocity; }); })
      .suspect("omega-cross-r-reversed",
               [&] {
                 return with([&](const Motion& m) -> Vector {
                   return m.velocity - Vector(m.angular_velocity.cross(Vector(p - m.centre)));
                 });
               })
      .suspect("arm-from-origin",
               [&] {
                 return with([&](const Motion& m) -> Vector {
                   return m.velocity + Vector(m.angular_velocity.cross(p));
                 });
               })
      .answer([&] { return exercise::closing(a, b, p, n); })
      .equals(case_of(sign));
}

const Motion ground{{0, 0, -5}, {0, 0, 0}, {0, 0, 0}};

}  // namespace

TEST_CASE("without rotation every point has the velocity of the centre") {
  check_velocity({{1, 2, 3}, {4, -5, 6}, {0, 0, 0}}, {7, 7, 7});
  check_velocity({{0, 0, 0}, {0, 0, -2}, {0, 0, 0}}, {1, 0, 0});
}

TEST_CASE("a rotation carries a point around the centre of mass") {
  check_velocity({{0, 0, 0}, {0, 0, 0}, {0, 0, 2}}, {3, 0, 0});
  check_velocity({{4, 0, 0}, {0, 0, 0}, {0, 0, 2}}, {3, 0, 0});
  check_velocity({{1, 1, 1}, {5, 0, 0}, {1, -2, 3}}, {2, 4, -1});
}

TEST_CASE("a rolling wheel is at rest where it touches the road") {
  // To the right, so it rotates clockwise as seen from the front (−y).
  const Motion wheel{{8, 0, 2}, {6, 0, 0}, {0, 3, 0}};
  check_velocity(wheel, {8, 0, 0});
  check_velocity(wheel, {8, 0, 4});
  check_velocity(wheel, {10, 0, 2});
}

TEST_CASE("the three cases of the normal velocity") {
  const Vector up(0, 0, 1);
  check_closing({{0, 0, 1}, {3, 0, -2}, {0, 0, 0}}, ground, {0, 0, 0}, up);
  check_closing({{0, 0, 1}, {3, 0, 2}, {0, 0, 0}}, ground, {0, 0, 0}, up);
  check_closing({{0, 0, 1}, {3, 0, 0}, {0, 0, 0}}, ground, {0, 0, 0}, up);
  // The centre of mass sinks and the end in contact rises; then the reverse.
  check_closing({{2, 0, 1}, {0, 0, -1}, {0, 2, 0}}, ground, {0, 0, 0}, up);
  check_closing({{2, 0, 1}, {0, 0, 1}, {0, -2, 0}}, ground, {0, 0, 0}, up);
  check_closing({{2, 0, 1}, {0, 0, -4}, {0, 2, 0}}, ground, {0, 0, 0}, up);
}

TEST_CASE("both bodies move") {
  const Vector n(1, 0, 0);
  const Motion slow{{1, 0, 0}, {-1, 0, 0}, {0, 0, 0}};
  check_closing(slow, {{-1, 0, 0}, {-3, 0, 0}, {0, 0, 0}}, {0, 0, 0}, n);
  check_closing(slow, {{-1, 0, 0}, {-1, 0, 0}, {0, 0, 0}}, {0, 0, 0}, n);
  check_closing({{1, 0, 0}, {2, 0, 0}, {0, 0, 0}}, {{-1, 0, 0}, {3, 0, 0}, {0, 0, 0}}, {0, 0, 0},
                n);
}

TEST_CASE("random bodies agree with exact arithmetic") {
  generators::Random random(seed(0));
  const auto vector = [&](double size) {
    return Vector{random.uniform(-size, size), random.uniform(-size, size),
                  random.uniform(-size, size)};
  };
  const auto whole = [&] {
    return Vector{double(random.integer(-3, 3)), double(random.integer(-3, 3)),
                  double(random.integer(-3, 3))};
  };
  for (int asked = 0; asked < 200; ++asked) {
    const Vector centre = vector(5);
    const Vector velocity = vector(9);
    const Motion body{centre, velocity, vector(9)};
    shrinkable(
        check_velocity, [](const Motion&, const Vector&) { return true; }, body, vector(5));
    const auto on_grid = [&] {
      const Vector x = whole();
      const Vector v = whole();
      return Motion{x, v, whole()};
    };
    const Motion a = on_grid();
    const Motion b = on_grid();
    Vector n = Vector::Zero();
    n(random.integer(0, 2)) = random.chance(0.5) ? 1 : -1;
    check_closing(a, b, whole(), n);
  }
}
