// A ball hits a rod at rest on ice: the point of the hit decides how the rod moves and rotates.
#include <contact/figure.hpp>
#include <contact/rigid_impulse.hpp>
#include <contact/sine_cosine.hpp>

using Vector = contact::Vector3<double>;

struct Input {
  double at;         // where the ball hits, from the middle of the rod, m
  double rod, ball;  // masses, kg
  double speed;      // of the ball, m/s
  double e;          // coefficient of restitution
  double time;       // since the hit, s
  double half;       // of the rod's length, m
  double way;        // how the impulse is computed; 0: the book's, 1: as if the rod could not turn
};

struct Output {
  double problem;
  double impulse;                       // N s
  double without_turning;               // the same for a rod that cannot rotate
  double velocity, angular_velocity;    // of the rod afterwards, m/s and rad/s
  double ball_velocity;                 // afterwards
  std::array<double, 5> along;          // velocities of points from the left end to the right
  double grip;                          // velocity of the left end
  double still;                         // the point that the hit leaves at rest, from the middle
  double lost;                          // share of the kinetic energy
  double ratio;                         // of separation and closing speed: should be e
  Eigen::Vector2d middle, left, right;  // of the rod at the time
  double ball_position;
  double grip_at_rest;  // goal of a question
};

Output compute(const Input& in) {
  Output out{};
  if (!(in.rod > 0) || !(in.ball > 0) || !(in.half > 0))
    out.problem = contact::figure::not_positive;
  for (const double x : {in.at, in.rod, in.ball, in.speed, in.e, in.time, in.half}) {
    if (std::abs(x) > 1e30) out.problem = contact::figure::too_large;
  }
  if (out.problem == 0 && (in.rod < 1e-30 || in.ball < 1e-30 || in.half < 1e-10)) {
    out.problem = contact::figure::too_small;
  }
  if (out.problem != 0) return out;

  const double inertia = contact::rod_inertia<double>(in.rod, 2 * in.half);
  const Vector zero(0, 0, 0);
  const auto rod = contact::rigid_body<double>(
      in.rod, contact::detail::diagonal<double>(inertia, inertia, inertia), zero, zero, zero);
  const auto ball_inertia = contact::sphere_inertia<double>(in.ball, 0.1);
  const auto ball =
      contact::rigid_body<double>(in.ball, ball_inertia, {in.at, -0.1, 0}, {0, in.speed, 0}, zero);
  const contact::ContactPoint<double> hit{{in.at, 0, 0}, {0, 1, 0}};
  // A ball that passes beside the rod hits nothing.
  const bool meets = std::abs(in.at) <= in.half;
  auto after =
      meets ? contact::collide(rod, ball, hit, in.e) : contact::Collided<double>{rod, ball, zero};
  out.without_turning = meets ? contact::impulse_without_rotation(rod, ball, hit, in.e) : 0;
  if (in.way == 1) {
    // WRONG: the rod rotates all the same, so the effective mass is smaller, and this impulse is
    // too large.
    after.impulse = hit.normal * out.without_turning;
    after.a = contact::after_impulse(rod, after.impulse, hit.point);
    after.b = contact::after_impulse<double>(ball, -after.impulse, hit.point);
  }
  out.impulse = after.impulse.y();
  const double closing = contact::normal_velocity(rod, ball, hit);
  out.ratio = meets && closing < 0 ? contact::normal_velocity(after.a, after.b, hit) / -closing : 0;
  out.velocity = after.a.velocity.y();
  out.angular_velocity = after.a.angular_velocity.z();
  out.ball_velocity = after.b.velocity.y();
  for (int k = 0; k < 5; ++k) {
    out.along[static_cast<std::size_t>(k)] =
        contact::velocity_at(after.a, Vector((k / 2.0 - 1) * in.half, 0, 0)).y();
  }
  out.grip = out.along[0];
  out.still = -contact::centre_of_percussion(inertia, in.rod, in.at);
  const double before = contact::kinetic_energy(ball);
  const double kept = contact::kinetic_energy(after.a) + contact::kinetic_energy(after.b);
  out.lost = before > 0 ? 1 - kept / before : 0;
  const bool hit_yet = in.time > 0;
  const auto turn = contact::sine_cosine(hit_yet ? out.angular_velocity * in.time : 0.0);
  out.middle = {0, hit_yet ? out.velocity * in.time : 0.0};
  out.right = out.middle + in.half * Eigen::Vector2d(turn.cosine, turn.sine);
  out.left = out.middle - in.half * Eigen::Vector2d(turn.cosine, turn.sine);
  out.ball_position = -0.1 + (hit_yet ? out.ball_velocity : in.speed) * in.time;
  out.grip_at_rest = out.impulse > 0.1 && std::abs(out.grip) <= 0.02 * std::abs(out.velocity);
  return out;
}

FIGURE(Input, FIELDS(at, rod, ball, speed, e, time, half, way), Output,
       FIELDS(problem, impulse, without_turning, velocity, angular_velocity, ball_velocity, along,
              grip, still, lost, ratio, middle, left, right, ball_position, grip_at_rest))
