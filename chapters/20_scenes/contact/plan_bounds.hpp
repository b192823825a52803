/// @file
/// What energy allows in a scene: how fast each body can get, how far it can come, and so which
/// pairs may meet at all.
///
/// Every bound is on the motion itself, not on a computed one, and is rounded outward.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <string>
#include <vector>

#include <contact/plan_shapes.hpp>
#include <contact/scene.hpp>

namespace contact {

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

/// How far a centre of mass can come: the integral of its speed.
/// @return m, rounded up
inline double travel_at_most(const EnergyShare& share, double w, double gravity, double t) {
  const double with_time =
      std::sqrt(share.twice_kinetic * w) * t + gravity * std::sqrt(share.mass * w) * t * t / 2;
  const double with_floor = std::sqrt((share.twice_floor + share.twice_dip) * w) * t;
  return detail::rounded_up(std::min(with_time, with_floor));
}
// [/speed-bound]

namespace detail {

/// Whether no contact of the scene can turn anything: then spins keep their energy to themselves.
inline bool spins_are_locked(const Scene& scene) {
  for (const SceneBody& body : scene.bodies) {
    if (body.moves && !is_ball(body)) return false;
  }
  double rough = 0;
  for (const SceneMaterial& material : scene.materials) rough = std::max(rough, material.friction);
  return rough == 0;
}

// [floor]
/// How far a body can fall before the highest level floor holds it: a half-space whose normal and
/// gravity lie on one axis, exactly. Its centre stays above the floor by its core's thickness.
/// @return J, twice the energy that falling gives, rounded up; with what a soft floor gives way,
/// (m g)²/k; ∞ without such a floor
inline double twice_fall(const Scene& scene, const SceneBody& body, double gravity) {
  double least = infinite;
  const int axis = only_axis(scene.gravity);
  if (gravity == 0) return 0;
  if (axis < 0) return infinite;
  for (const SceneBody& floor : scene.bodies) {
    const auto* half_space = std::get_if<HalfSpaceShape>(&floor.shape);
    if (half_space == nullptr || level_axis(half_space->normal) != axis) continue;
    if (half_space->normal(axis) * scene.gravity(axis) > 0) continue;  // a ceiling
    const double size = coordinate_size(body.position) + std::abs(half_space->offset);
    double fall = half_space->normal.dot(body.position) - half_space->offset -
                  inner_radius(body.shape) + 64 * plan_u * size;
    fall = std::max(fall, 0.0);
    const double weight = body.mass * gravity;
    double twice = 2 * weight * fall;
    const PairMaterial pair =
        pair_material(scene.materials[body.material], scene.materials[floor.material]);
    if (pair.stiffness) twice += weight * weight / *pair.stiffness;
    least = std::min(least, twice);
  }
  return rounded_up(least);
}
// [/floor]

/// A group's bounds from its members.
inline EnergyShare energy_of(const Scene& scene, const std::vector<std::size_t>& members,
                             bool locked, double gravity) {
  std::vector<double> kinetic;
  std::vector<double> masses;
  std::vector<double> falls;
  for (const std::size_t i : members) {
    const SceneBody& body = scene.bodies[i];
    double twice = body.mass * body.velocity.dot(body.velocity);
    if (!locked) twice += moment_range(body.inertia).most * body.spin.dot(body.spin);
    kinetic.push_back(twice);
    masses.push_back(body.mass);
    falls.push_back(twice_fall(scene, body, gravity));
  }
  const double n = 32 + static_cast<double>(members.size());
  EnergyShare share;
  share.twice_kinetic = rounded_up(sum_in_order(std::move(kinetic)), n);
  share.mass = rounded_up(sum_in_order(std::move(masses)), n);
  share.twice_floor = rounded_up(share.twice_kinetic + sum_in_order(std::move(falls)), n);
  if (!scene.tolerance.event_order)
    share.twice_dip = rounded_up(2 * share.mass * gravity * scene.tolerance.position.value_or(0));
  return share;
}

/// Sets of bodies that grow together.
class BodySets {
 public:
  explicit BodySets(std::size_t n) : parent_(n) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  std::size_t find(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  /// Makes one set of two; the smaller index stands for both.
  void unite(std::size_t i, std::size_t k) {
    const std::size_t a = find(i);
    const std::size_t b = find(k);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::size_t> parent_;
};

// [free-flight]
/// Whether two bodies may touch while both fly freely: gravity pulls both alike, so that one sees
/// the other move on a straight line.
inline bool flights_may_meet(const SceneBody& a, const SceneBody& b, double reach, double t) {
  const Vector3<double> x = a.position - b.position;
  const Vector3<double> v = a.velocity - b.velocity;
  const double vv = v.dot(v);
  const double nearest = vv > 0 ? std::clamp(-x.dot(v) / vv, 0.0, t) : 0.0;
  const Vector3<double> at = x + v * nearest;
  const double size = coordinate_size(a.position) + coordinate_size(b.position) +
                      (coordinate_size(a.velocity) + coordinate_size(b.velocity)) * t + reach;
  return length_of(at) - 128 * plan_u * size <= reach;
}

/// Whether a body may touch what stands still while it flies freely: its path is cut into pieces,
/// each lies within half its length of its middle.
inline bool flight_may_meet(const Scene& scene, const SceneBody& body, double outer,
                            const SceneBody& still) {
  constexpr int pieces = 64;
  const double t = scene.duration;
  const double gravity = length_of(scene.gravity);
  const double dt = t / pieces;
  const double size = coordinate_size(body.position) + coordinate_size(body.velocity) * t +
                      coordinate_size(scene.gravity) * t * t;
  for (int k = 0; k < pieces; ++k) {
    const double middle = (k + 0.5) * dt;
    const Vector3<double> at =
        body.position + body.velocity * middle + scene.gravity * (middle * middle / 2);
    const Vector3<double> velocity = body.velocity + scene.gravity * middle;
    double aside = length_of(velocity) * dt / 2 + gravity * dt * dt / 8;
    if (const auto* wall = std::get_if<HalfSpaceShape>(&still.shape))
      aside = std::abs(wall->normal.dot(velocity)) * dt / 2 + gravity * dt * dt / 8;
    if (distance_at_least(still, at) - 64 * plan_u * size <= outer + rounded_up(aside)) return true;
  }
  return false;
}
// [/free-flight]

}  // namespace detail

namespace detail {

/// Fills in what a body alone says of itself.
inline BodyBound body_bound(const SceneBody& body) {
  BodyBound bound;
  bound.moves = body.moves;
  bound.inner = inner_radius(body.shape);
  bound.outer = outer_radius(body.shape);
  bound.arm = spin_arm(body.shape);
  if (!body.moves) return bound;
  bound.slowness = rounded_up(1 / body.mass);
  const double least = moment_range(body.inertia).least;
  bound.turning = bound.slowness;
  if (bound.arm > 0) bound.turning = rounded_up(bound.slowness + bound.arm * bound.arm / least);
  return bound;
}

/// Speed and travel of every body from its group's energy.
inline void spread_energy(const Scene& scene, SceneBounds& bounds) {
  for (BodyBound& body : bounds.bodies) {
    if (!body.moves) continue;
    const EnergyShare& share = bounds.groups[body.group];
    body.speed = speed_at_most(share, body.slowness, bounds.gravity, scene.duration);
    body.travel = travel_at_most(share, body.slowness, bounds.gravity, scene.duration);
  }
}

/// Groups as the sets say, with their energies; a body's group is its set's smallest index.
inline void regroup(const Scene& scene, bool locked, BodySets& sets, SceneBounds& bounds) {
  std::vector<std::vector<std::size_t>> members(scene.bodies.size());
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    if (scene.bodies[i].moves) members[sets.find(i)].push_back(i);
  }
  bounds.groups.assign(scene.bodies.size(), EnergyShare{});
  for (std::size_t g = 0; g < members.size(); ++g) {
    if (members[g].empty()) continue;
    bounds.groups[g] = energy_of(scene, members[g], locked, bounds.gravity);
    for (const std::size_t i : members[g]) bounds.bodies[i].group = g;
  }
  spread_energy(scene, bounds);
}

/// What two materials add to the worst of a pair.
inline void add_materials(const Scene& scene, std::size_t a, std::size_t b, PairBound& pair) {
  const PairMaterial material = pair_material(scene.materials[a], scene.materials[b]);
  pair.friction = std::max(pair.friction, material.friction);
  if (material.stiffness) {
    pair.soft = true;
    pair.stiffness = std::max(pair.stiffness, *material.stiffness);
    pair.damping = std::max(pair.damping, material.damping);
    return;
  }
  pair.hard = true;
  pair.restitution_least = std::min(pair.restitution_least, material.restitution);
  pair.restitution_most = std::max(pair.restitution_most, material.restitution);
}

/// Whether a ball and a half-space on an axis do not touch, or part: exactly.
inline bool begins_apart(const SceneBody& body, const SceneBody& other) {
  const auto* ball = std::get_if<BallShape>(&body.shape);
  const auto* wall = std::get_if<HalfSpaceShape>(&other.shape);
  if (ball == nullptr) return false;
  if (wall == nullptr) {
    const auto* second = std::get_if<BallShape>(&other.shape);
    if (second == nullptr) return false;
    return distance_at_least(other, body.position) > rounded_up(ball->radius);
  }
  const int axis = level_axis(wall->normal);
  if (axis < 0) return distance_at_least(other, body.position) > rounded_up(ball->radius);
  const double side = wall->normal(axis);
  const int gap = sign_of_rest(side * body.position(axis), wall->offset, ball->radius);
  return gap > 0 || (gap == 0 && side * body.velocity(axis) > 0);
}

/// The bound on one pair.
inline PairBound pair_bound(const Scene& scene, const SceneBounds& bounds, std::size_t a,
                            std::size_t b) {
  const BodyBound& first = bounds.bodies[a];
  const BodyBound& second = bounds.bodies[b];
  const SceneBody& body = scene.bodies[a];
  const SceneBody& other = scene.bodies[b];
  PairBound pair;
  pair.a = a;
  pair.b = b;
  pair.both_move = other.moves;
  pair.half_space = is_half_space(other);
  pair.round = is_ball(body) && (is_ball(other) || pair.half_space);
  pair.hard = false;
  add_materials(scene, body.material, other.material, pair);
  pair.apart = begins_apart(body, other);
  pair.core = rounded_down(first.inner + second.inner);
  const bool bodies_are_round = is_ball(body) || is_ball(other);
  if (bodies_are_round && !pair.half_space) {
    pair.graze = is_ball(body) ? first.inner : second.inner;
    if (pair.round || std::holds_alternative<CapsuleShape>(other.shape) ||
        std::holds_alternative<CapsuleShape>(body.shape))
      pair.graze = pair.core;
  }
  pair.slowness = first.slowness + second.slowness;
  pair.closing = speed_at_most(bounds.groups[first.group], first.turning + second.turning,
                               bounds.gravity, scene.duration);
  return pair;
}

/// Whether any two balls of many touch at the beginning, or may: by cells as wide as the largest.
inline bool crowd_begins_apart(const Scene& scene) {
  struct Placed {
    std::array<double, 3> cell;
    std::size_t body;
  };
  double widest = 0;
  for (const SceneBody& body : scene.bodies) {
    if (!body.moves) continue;
    if (!is_ball(body)) return false;
    widest = std::max(widest, 2 * inner_radius(body.shape));
  }
  widest = rounded_up(widest);
  std::vector<Placed> placed;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    if (!scene.bodies[i].moves) continue;
    const Vector3<double>& x = scene.bodies[i].position;
    placed.push_back(
        {{std::floor(x.x() / widest), std::floor(x.y() / widest), std::floor(x.z() / widest)}, i});
  }
  const auto before = [](const Placed& a, const Placed& b) {
    return a.cell != b.cell ? a.cell < b.cell : a.body < b.body;
  };
  std::sort(placed.begin(), placed.end(), before);
  for (const Placed& one : placed) {
    for (int near = 0; near < 27; ++near) {
      const int right = near % 3 - 1;
      const int ahead = near / 3 % 3 - 1;
      const int up = near / 9 - 1;
      const std::array<double, 3> cell{one.cell[0] + right, one.cell[1] + ahead, one.cell[2] + up};
      auto other = std::lower_bound(placed.begin(), placed.end(), Placed{cell, 0}, before);
      for (; other != placed.end() && other->cell == cell; ++other) {
        if (other->body <= one.body) continue;
        if (!begins_apart(scene.bodies[one.body], scene.bodies[other->body])) return false;
      }
    }
  }
  return true;
}

/// All pairs of a crowd as one bound, and one for each body that stands still.
inline void crowd_pairs(const Scene& scene, SceneBounds& bounds) {
  PairBound all;
  all.crowd = all.both_move = all.round = true;
  all.hard = false;
  all.core = infinite;
  double least_inner = infinite;
  double most_turning = 0;
  double most_slowness = 0;
  std::vector<std::size_t> materials;
  std::size_t first = scene.bodies.size();
  std::size_t group = 0;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    if (!scene.bodies[i].moves) continue;
    first = std::min(first, i);
    const BodyBound& body = bounds.bodies[i];
    group = body.group;
    all.round = all.round && is_ball(scene.bodies[i]);
    least_inner = std::min(least_inner, body.inner);
    most_turning = std::max(most_turning, body.turning);
    most_slowness = std::max(most_slowness, body.slowness);
    materials.push_back(scene.bodies[i].material);
  }
  std::sort(materials.begin(), materials.end());
  materials.erase(std::unique(materials.begin(), materials.end()), materials.end());
  const auto n = static_cast<double>(bounds.movers);
  PairBound still = all;
  all.a = all.b = first;
  all.count = n * (n - 1) / 2;
  for (const std::size_t a : materials) {
    for (const std::size_t b : materials) add_materials(scene, a, b, all);
  }
  all.core = rounded_down(2 * least_inner);
  all.graze = all.round ? all.core : 0.0;
  all.slowness = 2 * most_slowness;
  const EnergyShare& share = bounds.groups[group];
  all.closing = speed_at_most(share, 2 * most_turning, bounds.gravity, scene.duration);
  all.apart = crowd_begins_apart(scene);
  bounds.pairs.push_back(all);
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    const SceneBody& other = scene.bodies[k];
    if (other.moves) continue;
    PairBound pair = still;
    pair.a = first;
    pair.b = k;
    pair.count = n;
    pair.both_move = false;
    pair.half_space = is_half_space(other);
    pair.round = all.round && (pair.half_space || is_ball(other));
    for (const std::size_t a : materials) add_materials(scene, a, other.material, pair);
    pair.core = rounded_down(least_inner + bounds.bodies[k].inner);
    if (all.round && !pair.half_space) pair.graze = least_inner;
    pair.slowness = most_slowness;
    pair.closing = speed_at_most(share, most_turning, bounds.gravity, scene.duration);
    pair.apart = true;
    for (std::size_t i = 0; i < scene.bodies.size() && pair.apart; ++i) {
      if (scene.bodies[i].moves) pair.apart = begins_apart(scene.bodies[i], other);
    }
    bounds.pairs.push_back(pair);
  }
}

/// Every pair on its own: which may meet follows from where each body can come.
///
/// The first touch of all is made by bodies that fly freely. Who may be in it is disturbed, and may
/// then come as far as its energy allows; whom it may reach there is disturbed too, and shares its
/// energy; and so on until nothing changes. If a touch were left out, the first such touch would
/// happen while every bound still held: between bodies that are too far apart for it.
inline void separate_pairs(const Scene& scene, bool locked, SceneBounds& bounds) {
  const std::size_t n = scene.bodies.size();
  BodySets sets(n);
  const auto meet = [&](std::size_t i, std::size_t k) {
    bounds.bodies[i].disturbed = true;
    if (!scene.bodies[k].moves) return;
    bounds.bodies[k].disturbed = true;
    sets.unite(i, k);
  };
  for (std::size_t i = 0; i < n; ++i) {
    if (!scene.bodies[i].moves) continue;
    const double outer = bounds.bodies[i].outer;
    for (std::size_t k = 0; k < n; ++k) {
      const SceneBody& other = scene.bodies[k];
      if (other.moves ? k > i && flights_may_meet(scene.bodies[i], other,
                                                  rounded_up(outer + bounds.bodies[k].outer),
                                                  scene.duration)
                      : flight_may_meet(scene, scene.bodies[i], outer, other))
        meet(i, k);
    }
  }
  const auto in_reach = [&](std::size_t i, std::size_t k) {
    const BodyBound& body = bounds.bodies[i];
    const BodyBound& other = bounds.bodies[k];
    if (!other.moves)
      return distance_at_least(scene.bodies[k], scene.bodies[i].position) <=
             rounded_up(body.outer + body.travel);
    const Vector3<double> d = scene.bodies[i].position - scene.bodies[k].position;
    const double size =
        coordinate_size(scene.bodies[i].position) + coordinate_size(scene.bodies[k].position);
    return length_of(d) - 64 * plan_u * size <=
           rounded_up(body.outer + body.travel + other.outer + other.travel);
  };
  for (bool changed = true; changed;) {
    changed = false;
    regroup(scene, locked, sets, bounds);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t k = 0; k < n; ++k) {
        if (i == k || !bounds.bodies[i].disturbed || !scene.bodies[k].moves) continue;
        if (sets.find(i) == sets.find(k) || !in_reach(i, k)) continue;
        meet(i, k);
        changed = true;
      }
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (!bounds.bodies[i].disturbed) continue;
    for (std::size_t k = 0; k < n; ++k) {
      const bool still = !scene.bodies[k].moves;
      if (!still && (k <= i || sets.find(i) != sets.find(k))) continue;
      if (!in_reach(i, k)) continue;
      bounds.pairs.push_back(pair_bound(scene, bounds, i, k));
    }
  }
}

}  // namespace detail

// [scene-bounds]
/// What energy allows in a scene, from its first moment to its last.
///
/// Beyond crowd_size moving bodies all are taken to meet, and every pair to be as bad as the worst:
/// still sound, and of order n log n.
/// @param scene checked; only its bodies, materials, gravity and duration are read
inline SceneBounds scene_bounds(const Scene& scene) {
  SceneBounds bounds;
  const int axis = detail::only_axis(scene.gravity);
  bounds.gravity = axis >= 0 ? std::abs(scene.gravity(axis))
                             : detail::rounded_up(detail::length_of(scene.gravity), 4);
  for (const SceneBody& body : scene.bodies) {
    bounds.bodies.push_back(detail::body_bound(body));
    if (body.moves) ++bounds.movers;
  }
  const bool locked = detail::spins_are_locked(scene);
  bounds.crowded = bounds.movers > crowd_size;
  if (bounds.crowded) {
    detail::BodySets sets(scene.bodies.size());
    std::size_t first = scene.bodies.size();
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      if (!scene.bodies[i].moves) continue;
      first = std::min(first, i);
      sets.unite(first, i);
      bounds.bodies[i].disturbed = true;
    }
    detail::regroup(scene, locked, sets, bounds);
    detail::crowd_pairs(scene, bounds);
  } else {
    detail::separate_pairs(scene, locked, bounds);
  }
  for (const BodyBound& body : bounds.bodies) bounds.speed = std::max(bounds.speed, body.speed);
  return bounds;
}
// [/scene-bounds]

/// How many pairs may meet.
inline double pairs_that_may_meet(const SceneBounds& bounds) {
  double count = 0;
  for (const PairBound& pair : bounds.pairs) count += pair.count;
  return count;
}

}  // namespace contact
