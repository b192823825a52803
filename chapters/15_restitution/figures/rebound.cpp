// A ball that meets a surface: the normal and the tangential component of its velocity, the
// velocity afterwards, and the two angles, both from the normal.
#include <contact/figure.hpp>
#include <contact/rebound_angle.hpp>
#include <contact/restitution.hpp>

using Vector2 = Eigen::Matrix<double, 2, 1>;
using Vector3 = contact::Vector3<double>;

struct Input {
  Vector2 from;     // origin of the ball's path; the ball moves to (0, 0), m/s
  Vector2 facing;   // a point in front of the surface, in the direction of its normal
  double k;         // coefficient of restitution
  double friction;  // μ
  double turns;     // 1: a solid ball that may rotate; 0: a body that does not
  double beside;    // drawn beside it. 0: the mirror; 1: −k v; 2: the formula without a test
};

struct Output {
  double problem;
  double approaching;     // 1 if it meets the surface from its front
  Vector2 normal;         // unit vector
  Vector2 before, after;  // velocities, m/s
  Vector2 normal_before, along_before;
  Vector2 normal_after, along_after;
  Vector2 mirror;              // after a bounce with k = 1 and no friction
  Vector2 wrong;               // −k v
  Vector2 untested;            // by the formula that does not ask whether it approaches
  double angle_in, angle_out;  // degrees from the normal
  double closing, parting;     // normal speeds, m/s
  double kept;                 // share of the kinetic energy, without that of the rotation
  double stays;                // its velocity is 0 afterwards
  double right_angle;          // goal: incidence and rebound are perpendicular
};

namespace {

// WRONG: the tangential component is reversed too, although no force acts there. So the ball goes
// back along its path, whatever the normal; that is right only head-on.
Vector2 reflected_whole(const Vector2& velocity, double k) { return -k * velocity; }

// WRONG: without the test for approach the formula gives the same for N and −N. A ball that moves
// away is reversed and sent into the surface; one that approaches comes out right.
template <class Bounce>
Vector3 without_test(const Vector3& velocity, const Vector3& normal, const Bounce& bounce) {
  return bounce(velocity, contact::approaches(velocity, normal) ? normal : Vector3(-normal));
}

}  // namespace

Output compute(const Input& in) {
  Output out{};
  const double least = 1e-100;
  const double most = 1e100;
  if (!(in.facing.cwiseAbs().maxCoeff() > least)) out.problem = contact::figure::zero_normal;
  if (!(in.from.cwiseAbs().maxCoeff() > least)) out.problem = contact::figure::zero_direction;
  if (in.facing.cwiseAbs().maxCoeff() > most || in.from.cwiseAbs().maxCoeff() > most || in.k > 1 ||
      in.friction > most) {
    out.problem = contact::figure::too_large;
  }
  if (in.k < 0 || in.friction < 0) out.problem = contact::figure::too_small;
  if (out.problem != 0) return out;

  const Vector3 facing(in.facing.x(), in.facing.y(), 0);
  const Vector3 n = facing / facing.norm();
  const Vector3 v(-in.from.x(), -in.from.y(), 0);
  const double grip = in.turns > 0.5 ? contact::solid_ball_grip<double> : 1;
  const auto bounce = [&](const Vector3& velocity, const Vector3& normal) {
    return contact::after_bounce_with_friction(velocity, normal, in.k, in.friction, grip);
  };
  const Vector3 after = bounce(v, n);
  out.approaching = contact::approaches(v, n) ? 1 : 0;
  const auto flat = [](const Vector3& x) { return Vector2(x.x(), x.y()); };
  out.normal = flat(n);
  out.before = flat(v);
  out.after = flat(after);
  out.normal_before = flat(n * v.dot(n));
  out.along_before = flat(v - n * v.dot(n));
  out.normal_after = flat(n * after.dot(n));
  out.along_after = flat(after - n * after.dot(n));
  out.mirror = flat(contact::after_bounce<double>(v, n, 1));
  out.wrong = reflected_whole(out.before, in.k);
  out.untested = flat(without_test(v, n, bounce));
  out.angle_in = contact::degrees(contact::angle_from_normal(v, n));
  out.angle_out = contact::degrees(contact::angle_from_normal(after, n));
  out.closing = -v.dot(n);
  out.parting = after.dot(n);
  out.kept = after.squaredNorm() / v.squaredNorm();
  out.stays = after.norm() <= 1e-12 * v.norm() ? 1 : 0;
  const double turn = v.dot(after);
  out.right_angle = out.approaching > 0 && in.friction == 0 && in.k <= 0.8 &&
                            std::abs(turn) <= 0.02 * v.norm() * after.norm()
                        ? 1
                        : 0;
  return out;
}

FIGURE(Input, FIELDS(from, facing, k, friction, turns, beside), Output,
       FIELDS(problem, approaching, normal, before, after, normal_before, along_before,
              normal_after, along_after, mirror, wrong, untested, angle_in, angle_out, closing,
              parting, kept, stays, right_angle))
