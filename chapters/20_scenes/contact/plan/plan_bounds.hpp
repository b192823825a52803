/// @file
/// What a plan needs to know of a shape: how thick it is, how far it reaches, how far off a point
/// is. All of it on the safe side.
/// What energy allows in a scene: how fast each body can get, how far it can come, and so which
/// pairs may meet at all.
///
/// Every bound is on the motion itself, not on a computed one, and is rounded outward.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <variant>
#include <vector>

#include <contact/error_free.hpp>
#include <contact/scene/scene.hpp>
#include <contact/tolerance.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace detail {

inline constexpr double infinite = std::numeric_limits<double>::infinity();
inline constexpr double plan_u = tolerance::unit_roundoff<double>;

/// x ≥ 0 made larger than what it stands for, if that took at most n roundings, each off by at most
/// u of a result that is not negative. Twice γ(n) leaves room for this product's own rounding.
inline double rounded_up(double x, double n = 64) { return x * (1 + 2 * n * plan_u); }

/// x ≥ 0 made smaller in the same way.
inline double rounded_down(double x, double n = 64) { return x * (1 - 2 * n * plan_u); }

inline double length_of(const Vector3<double>& v) { return std::sqrt(v.dot(v)); }

/// The size of a place's coordinates: what its rounding is measured with.
inline double coordinate_size(const Vector3<double>& x) { return x.cwiseAbs().sum(); }

/// The sign of a − b − c, exactly.
inline int sign_of_rest(double a, double b, double c) {
  const auto first = two_sum(a, -b);
  // If the first difference is near c this is exact (Sterbenz); if not, its sign is right anyway.
  const double rest = (first.value - c) + first.error;
  return rest > 0 ? 1 : (rest < 0 ? -1 : 0);
}

/// The axis along which a vector points, if all its other coordinates are exactly 0.
int only_axis(const Vector3<double>& v);

/// The axis along which a half-space's normal points, if it is exactly an axis of the world.
inline int level_axis(const Vector3<double>& normal) {
  const int axis = only_axis(normal);
  return axis >= 0 && std::abs(normal(axis)) == 1 ? axis : -1;
}

}  // namespace detail

/// Whether a body is a ball.
inline bool is_ball(const SceneBody& body) { return std::holds_alternative<BallShape>(body.shape); }

/// Whether a body is a half-space.
inline bool is_half_space(const SceneBody& body) {
  return std::holds_alternative<HalfSpaceShape>(body.shape);
}

// [inner-radius]
/// The thickness of a shape's core: the shape contains every point at most this far from some set
/// about its origin (a point for a ball, a segment for a capsule, a rectangle for a box).
/// @return m; ∞ for a half-space; 0 for a hull, of which this proves nothing
inline double inner_radius(const SceneShape& shape) {
  if (const auto* ball = std::get_if<BallShape>(&shape)) return ball->radius;
  if (const auto* box = std::get_if<BoxShape>(&shape)) return box->half_lengths.minCoeff();
  if (const auto* capsule = std::get_if<CapsuleShape>(&shape)) return capsule->radius;
  return std::holds_alternative<HalfSpaceShape>(shape) ? detail::infinite : 0.0;
}
// [/inner-radius]

/// No point of a shape is farther than this from its origin, however it is turned.
/// @return m, rounded up; ∞ for a half-space
double outer_radius(const SceneShape& shape);

/// How far a spin can move a shape's points: 0 for a ball, which looks alike from all sides.
/// @return m, rounded up
inline double spin_arm(const SceneShape& shape) {
  return std::holds_alternative<BallShape>(shape) ? 0.0 : outer_radius(shape);
}

/// At most the distance of a point from a body as it lies when the scene begins; less than 0 only
/// inside a half-space or by rounding.
/// @param p in the world, m
/// @return m, rounded down by 128 u of the coordinates' sizes, and by pose_slack of the distance
/// where a direction is rounded
double distance_at_least(const SceneBody& body, const Vector3<double>& p);

/// The largest and the smallest moment of inertia of a body about any axis through its centre.
struct MomentRange {
  double least = 0;  ///< kg·m², rounded down
  double most = 0;   ///< kg·m², rounded up
};

/// The range of a moving body's moments. Exactly the diagonal's if nothing stands beside it.
MomentRange moment_range(const Matrix3<double>& inertia);

/// What bounds the motion of bodies that may give each other energy.
struct EnergyShare {
  double twice_kinetic = 0;               ///< 2 K at the beginning, J
  double mass = 0;                        ///< of all together, kg
  double twice_floor = detail::infinite;  ///< no 2 K is ever larger, J; ∞ without a floor
  double twice_dip = 0;  ///< what a run gains that is off by the tolerance, into the floor, J
};

/// What is known of a body before the scene runs.
struct BodyBound {
  bool moves = false;      ///< whether anything can move it
  bool disturbed = false;  ///< whether it may touch anything
  std::size_t group = 0;   ///< bodies of one group may give each other energy
  double inner = 0;        ///< thickness of its core, m
  double outer = 0;        ///< how far it reaches, m
  double arm = 0;          ///< how far out spin moves its surface, m
  double slowness = 0;     ///< 1/m, 1/kg
  double turning = 0;      ///< arm²/I + 1/m with the least I: of points of its surface, 1/kg
  double speed = 0;        ///< its centre is never faster, m/s
  double travel = 0;       ///< its centre never comes farther from where it began, m
};

/// Two bodies that may meet, or all pairs of a crowd taken together: then each number is the worst
/// of them.
struct PairBound {
  std::size_t a = 0;             ///< index of a body that moves
  std::size_t b = 0;             ///< index of the other
  double count = 1;              ///< how many pairs this stands for
  bool crowd = false;            ///< whether it stands for a crowd's pairs
  bool both_move = false;        ///< false: b stands still
  bool half_space = false;       ///< b is a half-space
  bool round = false;            ///< a is a ball, and b a ball or a half-space
  bool hard = true;              ///< some of the pairs are hard contacts
  bool soft = false;             ///< some give way like springs
  bool apart = false;            ///< at the beginning they do not touch, or they part
  double friction = 0;           ///< the largest
  double restitution_least = 1;  ///< of hard contacts
  double restitution_most = 0;   ///< of hard contacts
  double stiffness = 0;          ///< the largest, N/m
  double damping = 0;            ///< the largest of those that give way, N·s/m
  double core = 0;               ///< both cores' thicknesses together, m; ∞ for a half-space
  double graze = 0;              ///< least radius of curvature where they can graze, m; 0: unknown
  double closing = 0;            ///< surface points never move faster towards each other, m/s
  double slowness = 0;           ///< 1/m + 1/m', 1/kg
};

/// All that the rules ask.
struct SceneBounds {
  std::vector<BodyBound> bodies;    ///< as many as the scene has
  std::vector<PairBound> pairs;     ///< that may meet
  std::vector<EnergyShare> groups;  ///< by BodyBound::group
  std::size_t movers = 0;           ///< bodies that move
  double gravity = 0;               ///< its size, m/s²
  double speed = 0;                 ///< the largest of all, m/s
  bool crowded = false;             ///< too many bodies to ask each pair
};

/// Beyond this number of moving bodies pairs are not asked one by one: all are taken to meet.
inline constexpr std::size_t crowd_size = 256;

namespace detail {

/// A sum that does not depend on the order in which its terms are given.
inline double sum_in_order(std::vector<double> terms) {
  std::sort(terms.begin(), terms.end());
  return std::accumulate(terms.begin(), terms.end(), 0.0);
}

}  // namespace detail

// [speed-bound]
/// How fast something of a group can get: no faster than √(2K w) with w = 1/m for a centre of mass.
///
/// Contacts only take energy: a hard one returns at most what it got (e ≤ 1), friction and damping
/// lose, a spring returns what it took, and what stands still does no work. (A law of impact that
/// can give energy, as Newton's can to rough bodies that are no balls, is none of these.) So a
/// group's energy grows by gravity's work alone, at the rate Σ m g·v ≤ |g| √(M 2K): √(2K) grows by
/// at most |g| √M in a second. Over a level floor, gravity can give no more than down to the floor;
/// to a run whose hits come late by a step, as much more as it is in the floor: the tolerance.
/// @param w squared speed for each joule of 2K, 1/kg; for two bodies the sum of both: by Cauchy and
/// Schwarz |v| + |v'| ≤ √((m v² + m' v'²)(1/m + 1/m'))
/// @param gravity |g|, m/s²
/// @param t at any time up to this, s
/// @return m/s, rounded up
inline double speed_at_most(const EnergyShare& share, double w, double gravity, double t) {
  const double with_time =
      std::sqrt(share.twice_kinetic * w) + gravity * std::sqrt(share.mass * w) * t;
  const double with_floor = std::sqrt((share.twice_floor + share.twice_dip) * w);
  return detail::rounded_up(std::min(with_time, with_floor));
}
// [/speed-bound]

/// How far a centre of mass can come: the integral of its speed.
/// @return m, rounded up
inline double travel_at_most(const EnergyShare& share, double w, double gravity, double t) {
  const double with_time =
      std::sqrt(share.twice_kinetic * w) * t + gravity * std::sqrt(share.mass * w) * t * t / 2;
  const double with_floor = std::sqrt((share.twice_floor + share.twice_dip) * w) * t;
  return detail::rounded_up(std::min(with_time, with_floor));
}

namespace detail {

/// A group's bounds from its members.
EnergyShare energy_of(const Scene& scene, const std::vector<std::size_t>& members, bool locked,
                      double gravity);

}  // namespace detail

/// What energy allows in a scene, from its first moment to its last.
///
/// Beyond crowd_size moving bodies all are taken to meet, and every pair to be as bad as the worst:
/// still sound, and of order n log n.
/// @param scene checked; only its bodies, materials, gravity and duration are read
SceneBounds scene_bounds(const Scene& scene);

/// How many pairs may meet.
inline double pairs_that_may_meet(const SceneBounds& bounds) {
  double count = 0;
  for (const PairBound& pair : bounds.pairs) count += pair.count;
  return count;
}

}  // namespace contact

#ifndef CONTACT_SCENES_COMPILED
#include "../../src/plan_bounds.cpp"
#include "../../src/plan_shapes.cpp"
#endif
