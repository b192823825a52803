// Separating, resting or colliding against fractions.
#include <catch2/catch_test_macros.hpp>
#include <contact/approach.hpp>
#include <limits>

#include "random_poses.hpp"
#include "support/generators.hpp"
#include "support/oracle.hpp"

namespace approach_test {

using contact::BodyVelocity;
using contact::Motion;
using contact::motion_in_contact;
using generators::Random;
using generators::tried;
using oracle::Rational;
using oracle::Vector;
using random_poses::any_point;
using V = contact::Vector3<double>;

namespace {

const V none(0, 0, 0);

V whole(Random& random) {
  const int x = random.integer(-3, 3);
  const int y = random.integer(-3, 3);
  return V(x, y, random.integer(-3, 3));
}
BodyVelocity<double> moving(Random& random, bool grid) {
  const V centre = grid ? whole(random) : any_point(random, 3);
  const V velocity = grid ? whole(random) : any_point(random, 3);
  return {centre, velocity, grid ? whole(random) : any_point(random, 3)};
}
Motion motion_of(int sign) {
  if (sign == 0) return Motion::resting;
  return sign > 0 ? Motion::separating : Motion::colliding;
}
/// n · (velocity of A − velocity of B) at p.
int exact_sign(const BodyVelocity<double>& a, const BodyVelocity<double>& b, const V& p,
               const V& n) {
  const auto at = [&p](const BodyVelocity<double>& body) {
    const Vector lever = oracle::exact(p) - oracle::exact(body.centre);
    return Vector(oracle::exact(body.velocity) +
                  Vector(oracle::exact(body.angular_velocity).cross(lever)));
  };
  return oracle::sign(Rational(oracle::exact(n).dot(Vector(at(a) - at(b)))));
}

}  // namespace

TEST_CASE("the motion in a contact has the exact sign of the velocity along the normal") {
  Random random(931);
  int seen[3] = {0, 0, 0};
  for (int i = 0; i < tried(6000); ++i) {
    const bool grid = i % 2 == 0;
    BodyVelocity<double> a = moving(random, grid);
    const BodyVelocity<double> b = moving(random, grid);
    const V p = grid ? whole(random) : any_point(random, 3);
    const V n = grid ? whole(random) : random_poses::direction(random);
    if (!grid) {  // at rest but for rounding
      const V other = b.velocity + b.angular_velocity.cross(p - b.centre);
      a.velocity = other - a.angular_velocity.cross(p - a.centre);
    }
    const int sign = exact_sign(a, b, p, n);
    ++seen[sign + 1];
    CHECK(motion_in_contact(n, p, a, b) == motion_of(sign));
    CHECK(motion_in_contact(-n, p, b, a) == motion_of(sign));
  }
  for (const int count : seen) CHECK(count > tried(40));
}

TEST_CASE("sliding along a face rests, and so does a rotation about the contact") {
  const V n(1, 2, 2);
  CHECK(motion_in_contact(n, V(2, -1, 0), none) == Motion::resting);
  CHECK(motion_in_contact(n, V(2, -1, 0x1p-60), none) == Motion::separating);
  CHECK(motion_in_contact(n, V(2, -1, -0x1p-60), none) == Motion::colliding);
  const V p(0.1, 0.2, 0.3);
  const BodyVelocity<double> rolling{p, V(0, 0, 0), V(7, 8, 9)};
  CHECK(motion_in_contact(n, p, rolling, {}) == Motion::resting);
}

TEST_CASE("motions of any size are decided, and those that are not finite rest") {
  CHECK(motion_in_contact(V(1e-300, 0, 0), V(1e-300, 0, 0), none) == Motion::separating);
  CHECK(motion_in_contact(V(1e300, 0, 0), V(-1e300, 0, 0), none) == Motion::colliding);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(motion_in_contact(V(1, 0, 0), V(nan, 0, 0), none) == Motion::resting);
  CHECK(motion_in_contact(V(0, 0, std::numeric_limits<double>::infinity()), V(1, 0, 0), none) ==
        Motion::resting);
}

}  // namespace approach_test
