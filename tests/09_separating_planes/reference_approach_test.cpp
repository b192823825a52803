// Separating, resting or colliding against fractions.
#include <catch2/catch_test_macros.hpp>
#include <contact/approach.hpp>
#include <limits>

#include "support/generators.hpp"
#include "support/oracle.hpp"

namespace approach_test {
namespace {

using contact::BodyMotion;
using contact::Motion;
using contact::Vector3;
using oracle::Rational;

Motion of_sign(const Rational& value) {
  return value > 0 ? Motion::separating : (value < 0 ? Motion::colliding : Motion::resting);
}

/// A vector of few digits, so that exact zeros occur.
Vector3<double> small(generators::Random& random) {
  const int x = random.integer(-3, 3), y = random.integer(-3, 3), z = random.integer(-3, 3);
  return Vector3<double>(x, y, z) / 10;
}

oracle::Vector velocity(const BodyMotion& body, const Vector3<double>& point) {
  const oracle::Vector arm = oracle::exact(point) - oracle::exact(body.centre);
  return oracle::exact(body.linear) + oracle::exact(body.angular).cross(arm);
}

}  // namespace

TEST_CASE("motion in contact has the exact sign of the relative velocity along the normal") {
  generators::Random random(91);
  int resting = 0;
  for (int i = 0; i < generators::tried(4000); ++i) {
    const Vector3<double> n = small(random), a = small(random), b = small(random);
    const Rational along = oracle::exact(n).dot(oracle::exact(a) - oracle::exact(b));
    REQUIRE(contact::motion_in_contact(n, a, b) == of_sign(along));
    resting += along == 0 ? 1 : 0;
  }
  CHECK(resting > generators::tried(40));
}

TEST_CASE("motion in contact counts the rotation of both bodies") {
  generators::Random random(92);
  for (int i = 0; i < generators::tried(2000); ++i) {
    const Vector3<double> n = small(random), point = small(random);
    BodyMotion a, b;
    for (BodyMotion* body : {&a, &b}) {
      body->centre = small(random);
      body->linear = small(random);
      body->angular = small(random);
    }
    const Rational along = oracle::exact(n).dot(velocity(a, point) - velocity(b, point));
    REQUIRE(contact::motion_in_contact(n, point, a, b) == of_sign(along));
  }
}

TEST_CASE("a velocity difference that rounds to 0 is still told from 0") {
  const Vector3<double> n(1, 1, 0), a(1, -1, 0), b(0x1p-60, 0, 0);
  CHECK(contact::motion_in_contact(n, a, b) == Motion::colliding);
}

TEST_CASE("motion in contact with a number that is not finite is resting") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Vector3<double> n(1, 0, 0), zero(0, 0, 0);
  CHECK(contact::motion_in_contact(n, Vector3<double>(nan, 0, 0), zero) == Motion::resting);
  BodyMotion fast;
  fast.linear.x() = std::numeric_limits<double>::infinity();
  CHECK(contact::motion_in_contact(n, zero, fast, BodyMotion{}) == Motion::resting);
}

TEST_CASE("sliding along a face rests, and so does a rotation about the contact") {
  const Vector3<double> still(0, 0, 0);
  const Vector3<double> n(1, 2, 2);
  CHECK(contact::motion_in_contact(n, Vector3<double>(2, -1, 0), still) == Motion::resting);
  CHECK(contact::motion_in_contact(n, Vector3<double>(2, -1, 0x1p-60), still) ==
        Motion::separating);
  CHECK(contact::motion_in_contact(n, Vector3<double>(2, -1, -0x1p-60), still) ==
        Motion::colliding);
  const Vector3<double> p(0.1, 0.2, 0.3);
  const contact::BodyMotion rolling{p, Vector3<double>(0, 0, 0), Vector3<double>(7, 8, 9)};
  CHECK(contact::motion_in_contact(n, p, rolling, {}) == Motion::resting);
}

TEST_CASE("motions of any size are decided") {
  const Vector3<double> still(0, 0, 0), tiny(1e-300, 0, 0), huge(1e300, 0, 0);
  CHECK(contact::motion_in_contact(tiny, tiny, still) == Motion::separating);
  CHECK(contact::motion_in_contact(huge, still, huge) == Motion::colliding);
}

}  // namespace approach_test
