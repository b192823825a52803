#include <contact/plan/plan_bounds.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <variant>
#include <vector>

#include <contact/aabb.hpp>
#include <contact/box_pairs.hpp>
#include <contact/scene/compiled.hpp>
#include <contact/scene/scene.hpp>
#include <contact/tree_pairs.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace detail {

/// Whether no contact of the scene can exert a torque: then rotation and translation exchange no
/// energy.
CONTACT_SCENES_INLINE bool rotation_is_decoupled(const Scene& scene) {
  for (const SceneBody& body : scene.bodies) {
    if (body.moves && !is_ball(body)) return false;
  }
  double rough = 0;
  for (const SceneMaterial& material : scene.materials) rough = std::max(rough, material.friction);
  return rough == 0;
}

// [floor]
/// How far a body can fall before the highest level floor holds it: a half-space whose normal and
/// gravity are exactly along one axis. Its centre stays above the floor by its core's thickness.
/// @return J, twice the energy of the fall, rounded up; plus the compression of a compliant floor,
/// (m g)²/k; ∞ without such a floor
CONTACT_SCENES_INLINE double twice_fall(const Scene& scene, const std::vector<std::size_t>& floors,
                                        const SceneBody& body, double gravity) {
  double least = infinite;
  if (gravity == 0) return 0;
  for (const std::size_t k : floors) {
    const SceneBody& floor = scene.bodies[k];
    const auto& half_space = std::get<HalfSpaceShape>(floor.shape);
    const double size = coordinate_size(body.position) + std::abs(half_space.offset);
    double fall = half_space.normal.dot(body.position) - half_space.offset -
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

CONTACT_SCENES_INLINE std::vector<std::size_t> level_floors(const Scene& scene) {
  std::vector<std::size_t> floors;
  const int axis = only_axis(scene.gravity);
  if (axis < 0) return floors;
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    const auto* half_space = std::get_if<HalfSpaceShape>(&scene.bodies[k].shape);
    if (half_space == nullptr || level_axis(half_space->normal) != axis) continue;
    if (half_space->normal(axis) * scene.gravity(axis) < 0) floors.push_back(k);
  }
  return floors;
}

/// J; more than the terms of an energy lose that underflow: a mass is at most 2^100 kg, a moment of
/// inertia 2^300 kg·m², and what is lost of a square 2^-1074. Too small to change other sums.
inline constexpr double energy_lost_by_underflow = 0x1p-700;

CONTACT_SCENES_INLINE EnergyShare energy_of(const Scene& scene,
                                            const std::vector<std::size_t>& floors,
                                            const std::vector<std::size_t>& members, bool locked,
                                            double gravity) {
  std::vector<double> kinetic;
  std::vector<double> masses;
  std::vector<double> falls;
  for (const std::size_t i : members) {
    const SceneBody& body = scene.bodies[i];
    double twice = body.mass * body.velocity.dot(body.velocity);
    if (!locked)
      twice += moment_range(body.inertia).max * body.angular_velocity.dot(body.angular_velocity);
    kinetic.push_back(twice);
    masses.push_back(body.mass);
    falls.push_back(twice_fall(scene, floors, body, gravity));
  }
  // Squares of the smallest speeds underflow to 0, and √(2K) must not.
  const bool still = std::all_of(members.begin(), members.end(), [&](std::size_t i) {
    const SceneBody& body = scene.bodies[i];
    return body.velocity.isZero(0) && (locked || body.angular_velocity.isZero(0));
  });
  if (!still) kinetic.push_back(energy_lost_by_underflow);
  if (gravity > 0) falls.push_back(energy_lost_by_underflow);
  const double n = 32 + static_cast<double>(members.size());
  EnergyShare share;
  share.twice_kinetic = rounded_up(sorted_sum(std::move(kinetic)), n);
  share.mass = rounded_up(sorted_sum(std::move(masses)), n);
  share.twice_floor = rounded_up(share.twice_kinetic + sorted_sum(std::move(falls)), n);
  if (!scene.tolerance.event_order)
    share.twice_dip = rounded_up(2 * share.mass * gravity * scene.tolerance.position.value_or(0));
  return share;
}

/// Sets of bodies that are united (union-find).
class BodySets {
 public:
  explicit BodySets(std::size_t n) : parent_(n) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  std::size_t find(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  /// Unites two sets; the smaller index represents both.
  void unite(std::size_t i, std::size_t k) {
    const std::size_t a = find(i);
    const std::size_t b = find(k);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::size_t> parent_;
};

// [free-flight]
/// Whether two bodies may touch while both fly freely: gravity accelerates both equally, so their
/// relative path is straight.
CONTACT_SCENES_INLINE bool flights_may_meet(const SceneBody& a, const SceneBody& b, double reach,
                                            double t) {
  const Vector3<double> x = a.position - b.position;
  const Vector3<double> v = a.velocity - b.velocity;
  const double vv = v.dot(v);
  const double nearest = vv > 0 ? std::clamp(-x.dot(v) / vv, 0.0, t) : 0.0;
  const Vector3<double> at = x + v * nearest;
  const double size = coordinate_size(a.position) + coordinate_size(b.position) +
                      (coordinate_size(a.velocity) + coordinate_size(b.velocity)) * t + reach;
  return length_of(at) - 128 * plan_u * size <= reach;
}

/// Whether a body may touch a fixed one while it flies freely: its path is divided into pieces,
/// each of which lies within half its length of its middle.
CONTACT_SCENES_INLINE bool flight_may_meet(const Scene& scene, const SceneBody& body, double outer,
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

/// Fills in the bounds that a body has by itself.
CONTACT_SCENES_INLINE BodyBound body_bound(const SceneBody& body) {
  BodyBound bound;
  bound.moves = body.moves;
  bound.inner = inner_radius(body.shape);
  bound.outer = outer_radius(body.shape);
  bound.rotation_radius = rotation_radius(body.shape);
  if (!body.moves) return bound;
  bound.inverse_mass = rounded_up(1 / body.mass);
  const double least = moment_range(body.inertia).min;
  bound.surface_inverse_mass = bound.inverse_mass;
  if (bound.rotation_radius > 0)
    bound.surface_inverse_mass =
        rounded_up(bound.inverse_mass + bound.rotation_radius * bound.rotation_radius / least);
  return bound;
}

/// Speed and travel of every body from its group's energy.
CONTACT_SCENES_INLINE void spread_energy(const Scene& scene, SceneBounds& bounds) {
  for (BodyBound& body : bounds.bodies) {
    if (!body.moves) continue;
    const EnergyShare& share = bounds.groups[body.group];
    body.speed = speed_at_most(share, body.inverse_mass, bounds.gravity, scene.duration);
    body.travel = travel_at_most(share, body.inverse_mass, bounds.gravity, scene.duration);
  }
}

/// Groups from the sets, with their energies; a body's group is its set's smallest index.
CONTACT_SCENES_INLINE void regroup(const Scene& scene, bool locked, BodySets& sets,
                                   SceneBounds& bounds) {
  std::vector<std::vector<std::size_t>> members(scene.bodies.size());
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    if (scene.bodies[i].moves) members[sets.find(i)].push_back(i);
  }
  bounds.groups.assign(scene.bodies.size(), EnergyShare{});
  for (std::size_t g = 0; g < members.size(); ++g) {
    if (members[g].empty()) continue;
    bounds.groups[g] = energy_of(scene, bounds.floors, members[g], locked, bounds.gravity);
    bounds.compared += members[g].size() * bounds.floors.size();
    for (const std::size_t i : members[g]) bounds.bodies[i].group = g;
  }
  spread_energy(scene, bounds);
}

/// Adds the material of two bodies to the worst of a pair.
CONTACT_SCENES_INLINE void add_materials(const Scene& scene, std::size_t a, std::size_t b,
                                         PairBound& pair) {
  const PairMaterial material = pair_material(scene.materials[a], scene.materials[b]);
  pair.friction = std::max(pair.friction, material.friction);
  if (material.stiffness) {
    pair.soft = true;
    pair.stiffness = std::max(pair.stiffness, *material.stiffness);
    pair.damping = std::max(pair.damping, material.damping);
    return;
  }
  pair.hard = true;
  pair.min_restitution = std::min(pair.min_restitution, material.restitution);
  pair.max_restitution = std::max(pair.max_restitution, material.restitution);
}

/// Whether a ball and a half-space perpendicular to an axis do not touch, or separate: exactly.
CONTACT_SCENES_INLINE bool begins_apart(const SceneBody& body, const SceneBody& other) {
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
CONTACT_SCENES_INLINE PairBound pair_bound(const Scene& scene, const SceneBounds& bounds,
                                           std::size_t a, std::size_t b) {
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
  pair.inverse_mass = first.inverse_mass + second.inverse_mass;
  pair.closing = speed_at_most(bounds.groups[first.group],
                               first.surface_inverse_mass + second.surface_inverse_mass,
                               bounds.gravity, scene.duration);
  return pair;
}

/// Whether no two balls of many touch at the start, and none may: only those are compared whose
/// bounding boxes touch, with room for the doubt of begins_apart().
/// @param compared grows by the number of comparisons, of boxes and of balls
CONTACT_SCENES_INLINE bool crowd_begins_apart(const Scene& scene, std::size_t& compared) {
  std::vector<Aabb<double>> boxes;
  std::vector<std::size_t> placed;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const SceneBody& body = scene.bodies[i];
    if (!body.moves) continue;
    if (!is_ball(body)) return false;
    const double radius = inner_radius(body.shape);
    const double reach =
        rounded_up(radius) + 256 * plan_u * (coordinate_size(body.position) + radius);
    const Vector3<double> half = Vector3<double>::Constant(reach);
    boxes.push_back({body.position - half, body.position + half});
    placed.push_back(i);
  }
  const PairSearch near = tree_pairs<double>(boxes);
  compared += near.box_tests + near.pairs.size();
  return std::all_of(near.pairs.begin(), near.pairs.end(), [&](const BoxPair& pair) {
    return begins_apart(scene.bodies[placed[pair.a]], scene.bodies[placed[pair.b]]);
  });
}

/// All pairs of a crowd as one bound, and one for each fixed body.
CONTACT_SCENES_INLINE void crowd_pairs(const Scene& scene, SceneBounds& bounds) {
  PairBound all;
  all.crowd = all.both_move = all.round = true;
  all.hard = false;
  all.core = infinite;
  double min_inner = infinite;
  double max_surface_inverse_mass = 0;
  double max_inverse_mass = 0;
  std::vector<std::size_t> materials;
  std::size_t first = scene.bodies.size();
  std::size_t group = 0;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    if (!scene.bodies[i].moves) continue;
    first = std::min(first, i);
    const BodyBound& body = bounds.bodies[i];
    group = body.group;
    all.round = all.round && is_ball(scene.bodies[i]);
    min_inner = std::min(min_inner, body.inner);
    max_surface_inverse_mass = std::max(max_surface_inverse_mass, body.surface_inverse_mass);
    max_inverse_mass = std::max(max_inverse_mass, body.inverse_mass);
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
  all.core = rounded_down(2 * min_inner);
  all.graze = all.round ? all.core : 0.0;
  all.inverse_mass = 2 * max_inverse_mass;
  const EnergyShare& share = bounds.groups[group];
  all.closing = speed_at_most(share, 2 * max_surface_inverse_mass, bounds.gravity, scene.duration);
  all.apart = crowd_begins_apart(scene, bounds.compared);
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
    pair.core = rounded_down(min_inner + bounds.bodies[k].inner);
    if (all.round && !pair.half_space) pair.graze = min_inner;
    pair.inverse_mass = max_inverse_mass;
    pair.closing = speed_at_most(share, max_surface_inverse_mass, bounds.gravity, scene.duration);
    pair.apart = true;
    for (std::size_t i = 0; i < scene.bodies.size() && pair.apart; ++i) {
      if (!scene.bodies[i].moves) continue;
      ++bounds.compared;
      pair.apart = begins_apart(scene.bodies[i], other);
    }
    bounds.pairs.push_back(pair);
  }
}

/// Every pair on its own: which may meet follows from how far each body can move.
///
/// The first touch of all is of bodies that fly freely. A body that may take part in it is
/// disturbed, and may then go as far as its energy allows; a body that it may reach there is
/// disturbed too, and shares its energy; and so on until nothing changes. Suppose that this missed
/// a touch: the first touch that it missed would happen while all bounds still held, between bodies
/// that the bounds keep apart.
CONTACT_SCENES_INLINE void separate_pairs(const Scene& scene, bool locked, SceneBounds& bounds) {
  const std::size_t n = scene.bodies.size();
  BodySets sets(n);
  const auto meet = [&](std::size_t i, std::size_t k) {
    bounds.bodies[i].disturbed = true;
    if (!scene.bodies[k].moves) return;
    bounds.bodies[k].disturbed = true;
    sets.unite(i, k);
  };
  std::vector<std::size_t> movers;
  for (std::size_t i = 0; i < n; ++i)
    if (scene.bodies[i].moves) movers.push_back(i);
  for (const std::size_t i : movers) {
    const double outer = bounds.bodies[i].outer;
    for (std::size_t k = 0; k < n; ++k) {
      ++bounds.compared;
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
      if (!bounds.bodies[i].disturbed) continue;
      for (const std::size_t k : movers) {
        if (i == k || sets.find(i) == sets.find(k) || !in_reach(i, k)) continue;
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
CONTACT_SCENES_INLINE SceneBounds scene_bounds(const Scene& scene) {
  SceneBounds bounds;
  const int axis = detail::only_axis(scene.gravity);
  bounds.gravity = axis >= 0 ? std::abs(scene.gravity(axis))
                             : detail::rounded_up(detail::length_of(scene.gravity), 4);
  for (const SceneBody& body : scene.bodies) {
    bounds.bodies.push_back(detail::body_bound(body));
    if (body.moves) ++bounds.movers;
  }
  bounds.floors = detail::level_floors(scene);
  const bool locked = detail::rotation_is_decoupled(scene);
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

}  // namespace contact
