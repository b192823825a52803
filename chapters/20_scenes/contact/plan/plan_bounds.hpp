/// @file
/// What a plan needs to know of a shape: its thickness, its bounding radius, its distance from a
/// point, all on the safe side. And what energy allows in a scene: how fast each body can get, how
/// far it can move, and so which pairs may meet at all.
///
/// Each bound holds for the exact motion, not for a computed one, and is rounded outwards.
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

/// x ≥ 0, enlarged to bound the exact value after at most n roundings, each off by at most u of a
/// result that is not negative. Twice γ(n) leaves room for this product's own rounding.
inline double rounded_up(double x, double n = 64) { return x * (1 + 2 * n * plan_u); }

/// x ≥ 0, reduced in the same way.
inline double rounded_down(double x, double n = 64) { return x * (1 - 2 * n * plan_u); }

inline double length_of(const Vector3<double>& v) { return std::sqrt(v.dot(v)); }

/// The size of a position's coordinates, by which its rounding is measured.
inline double coordinate_size(const Vector3<double>& x) { return x.cwiseAbs().sum(); }

/// The sign of a − b − c, exactly.
inline int sign_of_rest(double a, double b, double c) {
  const auto first = two_sum(a, -b);
  // If the first difference is near c this is exact (Sterbenz); if not, its sign is still right.
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
/// The thickness of a shape's core: the shape contains all points within this distance of some set
/// about its origin (a point for a ball, a segment for a capsule, a rectangle for a box).
/// @return m; ∞ for a half-space; 0 for a hull, for which this proves nothing
inline double inner_radius(const SceneShape& shape) {
  if (const auto* ball = std::get_if<BallShape>(&shape)) return ball->radius;
  if (const auto* box = std::get_if<BoxShape>(&shape)) return box->half_lengths.minCoeff();
  if (const auto* capsule = std::get_if<CapsuleShape>(&shape)) return capsule->radius;
  return std::holds_alternative<HalfSpaceShape>(shape) ? detail::infinite : 0.0;
}
// [/inner-radius]

/// Bounding radius: no point of a shape is farther than this from its origin, in any orientation.
/// @return m, rounded up; ∞ for a half-space
double outer_radius(const SceneShape& shape);

/// The largest lever arm with which rotation moves a shape's points: 0 for a ball, which looks the
/// same in every orientation.
/// @return m, rounded up
inline double rotation_radius(const SceneShape& shape) {
  return std::holds_alternative<BallShape>(shape) ? 0.0 : outer_radius(shape);
}

/// A lower bound on the distance of a point from a body in its initial pose; negative only inside a
/// half-space or by rounding.
/// @param p in the world, m
/// @return m, rounded down by 128 u of the coordinates' sizes, and by pose_slack of the distance
/// where a direction is rounded
double distance_at_least(const SceneBody& body, const Vector3<double>& p);

/// The largest and the smallest moment of inertia of a body about any axis through its centre.
struct MomentRange {
  double min = 0;  ///< kg·m², rounded down
  double max = 0;  ///< kg·m², rounded up
};

/// The range of a moving body's moments of inertia. Exactly those of the diagonal if the tensor is
/// diagonal.
MomentRange moment_range(const Matrix3<double>& inertia);

/// Bounds on the energy of bodies that may exchange energy.
struct EnergyShare {
  double twice_kinetic = 0;               ///< 2 K at the start, J
  double mass = 0;                        ///< of all together, kg
  double twice_floor = detail::infinite;  ///< no 2 K is ever larger, J; ∞ without a floor
  double twice_dip = 0;  ///< gain of a run whose hits are late, by dips into the floor, J
};

/// Bounds on a body before the scene runs.
struct BodyBound {
  bool moves = false;               ///< whether it can move
  bool disturbed = false;           ///< whether it may touch anything
  std::size_t group = 0;            ///< bodies of one group may exchange energy
  double inner = 0;                 ///< thickness of its core, m
  double outer = 0;                 ///< bounding radius, m
  double rotation_radius = 0;       ///< lever arm of its surface, m
  double inverse_mass = 0;          ///< 1/m, inverse mass, 1/kg
  double surface_inverse_mass = 0;  ///< lever arm²/I + 1/m, least I: inverse effective mass, 1/kg
  double speed = 0;                 ///< its centre is never faster, m/s
  double travel = 0;                ///< its centre never moves farther from its start, m
};

/// Two bodies that may meet, or all pairs of a crowd together: then each number is the worst of
/// them.
struct PairBound {
  std::size_t a = 0;           ///< index of a body that moves
  std::size_t b = 0;           ///< index of the other
  double count = 1;            ///< how many pairs this represents
  bool crowd = false;          ///< whether it represents a crowd's pairs
  bool both_move = false;      ///< false: b is fixed
  bool half_space = false;     ///< b is a half-space
  bool round = false;          ///< a is a ball, and b a ball or a half-space
  bool hard = true;            ///< some of the pairs are hard contacts
  bool soft = false;           ///< some are compliant, like springs
  bool apart = false;          ///< at the start they do not touch, or they separate
  double friction = 0;         ///< the largest
  double min_restitution = 1;  ///< of hard contacts
  double max_restitution = 0;  ///< of hard contacts
  double stiffness = 0;        ///< the largest, N/m
  double damping = 0;          ///< the largest of compliant contacts, N·s/m
  double core = 0;             ///< sum of both cores' thicknesses, m; ∞ for a half-space
  double graze = 0;            ///< least radius of curvature where they can graze, m; 0: unknown
  double closing = 0;          ///< surface points never approach each other faster, m/s
  double inverse_mass = 0;     ///< 1/m + 1/m', inverse reduced mass, 1/kg
};

/// The bounds that the rules use.
struct SceneBounds {
  std::vector<BodyBound> bodies;    ///< as many as the scene has
  std::vector<PairBound> pairs;     ///< the pairs that may meet
  std::vector<EnergyShare> groups;  ///< by BodyBound::group
  std::size_t movers = 0;           ///< bodies that move
  double gravity = 0;               ///< its size, m/s²
  double speed = 0;                 ///< the largest of all, m/s
  bool crowded = false;             ///< too many bodies to test each pair
  std::vector<std::size_t> floors;  ///< level half-spaces that hold what falls onto them, by index
  std::size_t compared = 0;         ///< how often two bodies were compared to make these bounds
};

/// Beyond this number of moving bodies pairs are not tested one by one: all may meet.
inline constexpr std::size_t crowd_size = 256;

namespace detail {

/// A sum that does not depend on the order of its terms.
inline double sorted_sum(std::vector<double> terms) {
  std::sort(terms.begin(), terms.end());
  return std::accumulate(terms.begin(), terms.end(), 0.0);
}

}  // namespace detail

// [speed-bound]
/// Largest speed in a group of bodies: √(2K w), with w = 1/m for a centre of mass.
///
/// Contacts only take energy: a hard contact returns at most what it got (e ≤ 1), friction and
/// damping dissipate, a spring returns what it stored, and a fixed body does no work. (An impact
/// law that can create energy, as Newton's can for rough bodies that are not balls, is excluded.)
/// So only gravity adds energy, at the rate Σ m g·v ≤ |g| √(M 2K): √(2K) grows by at most |g| √M in
/// a second. Over a level floor, gravity adds at most the energy of falling to the floor; in a run
/// whose hits are late by a step, also that of the dip into the floor, up to the tolerance.
/// @param w inverse mass, 1/kg: 1/m for the speed of one body, as v² ≤ 2K/m; 1/m + 1/m' for the sum
/// of two bodies' speeds, as |v| + |v'| ≤ √((m v² + m' v'²)(1/m + 1/m')) by Cauchy and Schwarz
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

/// How far a centre of mass can move: the integral of its speed.
/// @return m, rounded up
inline double travel_at_most(const EnergyShare& share, double w, double gravity, double t) {
  const double with_time =
      std::sqrt(share.twice_kinetic * w) * t + gravity * std::sqrt(share.mass * w) * t * t / 2;
  const double with_floor = std::sqrt((share.twice_floor + share.twice_dip) * w) * t;
  return detail::rounded_up(std::min(with_time, with_floor));
}

namespace detail {

/// The half-spaces onto which gravity pulls, with normal and gravity exactly along one axis; by
/// index.
std::vector<std::size_t> level_floors(const Scene& scene);

/// A group's bounds from its members.
/// @param floors from level_floors()
EnergyShare energy_of(const Scene& scene, const std::vector<std::size_t>& floors,
                      const std::vector<std::size_t>& members, bool locked, double gravity);

}  // namespace detail

/// What energy allows in a scene, from its start to its end.
///
/// Beyond crowd_size moving bodies all pairs may meet, and each gets the worst bounds: still sound,
/// and of order n log n.
/// @param scene checked; only its bodies, materials, gravity and duration are read
SceneBounds scene_bounds(const Scene& scene);

/// The number of pairs that may meet.
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
