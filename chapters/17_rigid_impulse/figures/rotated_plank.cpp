// A rotated plank floats and is hit from above: its angular velocity by the tensor in the axes of
// the world, by the tensor in its own axes, which ignores its orientation, and as for a sphere.
#include <contact/figure.hpp>
#include <contact/quaternion.hpp>
#include <contact/rigid_body.hpp>
#include <contact/rotation.hpp>

using Vector = contact::Vector3<double>;
using Matrix = contact::Matrix3<double>;

struct Input {
  Vector tip;      // the plank points to it, horizontal
  double at;       // where it is hit, in half lengths from its middle
  double impulse;  // downwards, N·s
  double shape;    // 0: plank; 1: cube
  double time;     // since the hit, s
};

struct Output {
  double problem;
  Vector half;             // half the edges, m
  Vector point, axis;      // where it is hit, m; unit vector along the plank
  Vector moments;          // principal moments, kg·m²
  Vector angular_impulse;  // r × J, kg·m²/s
  Vector angular_velocity, wrong_angular_velocity;  // just after the hit, rad/s
  Vector sphere_angular_velocity;                   // by the mean of the moments
  Vector momentum, wrong_momentum;                  // I ω of either, kg·m²/s
  double energy, wrong_energy;                      // of the rotation, J
  double size, wrong_size;                          // of either angular velocity, rad/s
  double agree;                                     // whether both are the same
  std::array<Vector, 8> first;         // vertices at the hit, from the centre of mass, m
  std::array<Vector, 8> later, wrong;  // and at the time
};

namespace {

constexpr double mass = 3;  // kg

// WRONG: the inverse of the tensor in the body's own axes, without R to its left and Rᵀ to its
// right. It divides an angular impulse about the world's x by the moment about the body's x,
// whatever the orientation.
Vector angular_velocity_by_body_axes(const Vector& angular_impulse, const Vector& moments) {
  return angular_impulse.cwiseQuotient(moments);
}

// WRONG: one number, the mean of the moments, as for a sphere. It is right for a body with equal
// moments in any orientation; any other rotates too fast about one axis and too slowly about
// another.
Vector angular_velocity_of_sphere(const Vector& angular_impulse, const Vector& moments) {
  return 3 * angular_impulse / moments.sum();
}

std::array<Vector, 8> corners(const Matrix& rotation, const Vector& half) {
  std::array<Vector, 8> all;
  for (std::size_t k = 0; k < 8; ++k) {
    const Vector corner((k & 1U) != 0 ? half.x() : -half.x(), (k & 2U) != 0 ? half.y() : -half.y(),
                        (k & 4U) != 0 ? half.z() : -half.z());
    all[k] = rotation * corner;
  }
  return all;
}

}  // namespace

Output compute(const Input& in) {
  Output out{};
  const Vector level(in.tip.x(), in.tip.y(), 0);
  const double size = level.cwiseAbs().maxCoeff();
  if (!(size > 0)) out.problem = contact::figure::zero_direction;
  if (size > 1e100 || std::abs(in.at) > 1 || std::abs(in.impulse) > 1e3 ||
      std::abs(in.time) > 1e3) {
    out.problem = contact::figure::too_large;
  }
  if (out.problem == 0 && size < 1e-100) out.problem = contact::figure::too_small;
  if (out.problem != 0) return out;

  const bool cube = in.shape > 0.5;
  out.half = cube ? Vector(0.4, 0.4, 0.4) : Vector(1, 0.5, 0.1);
  const Matrix of_cube = contact::box_inertia<double>(mass, {0.8, 0.8, 0.8});
  const Matrix of_plank = contact::box_inertia<double>(mass, {2, 1, 0.2});
  const Matrix own = cube ? of_cube : of_plank;
  out.moments = own.diagonal();
  // A turn about z by the angle whose cosine and sine are those of the axis.
  out.axis = level / level.norm();
  const double z = std::sqrt(std::fmax(0, (1 - out.axis.x()) / 2));
  const contact::Quaternion<double> start{std::sqrt(std::fmax(0, (1 + out.axis.x()) / 2)),
                                          {0, 0, out.axis.y() < 0 ? -z : z}};
  const Matrix rotation = contact::matrix_of(start);

  out.point = rotation * Vector(in.at * out.half.x(), 0, out.half.z());
  out.angular_impulse = out.point.cross(Vector(0, 0, -in.impulse));
  out.angular_velocity =
      contact::free_angular_velocity<double>(out.angular_impulse, out.moments, rotation);
  out.wrong_angular_velocity = angular_velocity_by_body_axes(out.angular_impulse, out.moments);
  out.sphere_angular_velocity = angular_velocity_of_sphere(out.angular_impulse, out.moments);
  out.size = out.angular_velocity.norm();
  out.wrong_size = out.wrong_angular_velocity.norm();
  out.agree =
      (out.angular_velocity - out.wrong_angular_velocity).norm() <= 1e-12 * out.size ? 1 : 0;
  // For both, momentum and energy are computed with the true tensor of the rotated plank.
  contact::RigidBody<double> body;
  body.inertia = contact::rotated<double>(own, rotation);
  body.angular_velocity = out.angular_velocity;
  out.momentum = contact::angular_momentum<double>(body, body.position);
  out.energy = contact::kinetic_energy(body);
  body.angular_velocity = out.wrong_angular_velocity;
  out.wrong_momentum = contact::angular_momentum<double>(body, body.position);
  out.wrong_energy = contact::kinetic_energy(body);

  constexpr int steps = 64;
  contact::Quaternion<double> later = start;
  for (int k = 0; k < steps; ++k) {
    later = contact::midpoint_step<double>(later, out.momentum, out.moments, in.time / steps);
  }
  out.first = corners(rotation, out.half);
  out.later = corners(contact::matrix_of(later), out.half);
  // With a tensor that is constant in the world, the angular velocity is constant.
  const auto astray = contact::exponential_step<double>(start, out.wrong_angular_velocity, in.time);
  out.wrong = corners(contact::matrix_of(astray), out.half);
  return out;
}

FIGURE(Input, FIELDS(tip, at, impulse, shape, time), Output,
       FIELDS(problem, half, point, axis, moments, angular_impulse, angular_velocity,
              wrong_angular_velocity, sphere_angular_velocity, momentum, wrong_momentum, energy,
              wrong_energy, size, wrong_size, agree, first, later, wrong))
