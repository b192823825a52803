#include <contact/plan/plan_spreading.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include <contact/plan/plan_bounds.hpp>
#include <contact/plan/plan_rules.hpp>
#include <contact/scene/compiled.hpp>
#include <contact/scene/scene.hpp>
#include <contact/scene/scene_solids.hpp>
#include <contact/sphere_sphere_impact.hpp>
#include <contact/vector.hpp>

namespace contact {

CONTACT_SCENES_INLINE double rough_pairs_beside_others(const PlanInput& q) {
  if (max_partners(q) <= 1 || proven_line(q)) return 0;
  double rough = 0;
  for (const PairBound& pair : q.pairs) rough += pair.friction > 0 ? pair.count : 0;
  return rough;
}

CONTACT_SCENES_INLINE double springs_beside_others(const PlanInput& q) {
  double soft = 0;
  for (const PairBound& pair : q.pairs) soft += pair.soft ? pair.count : 0;
  return max_partners(q) > 1 ? soft : 0;
}

namespace detail {

/// Each moving body's pairs; a crowd's are those of its first body.
CONTACT_SCENES_INLINE std::map<std::size_t, std::vector<const PairBound*>> pairs_by_body(
    const PlanInput& q) {
  std::map<std::size_t, std::vector<const PairBound*>> by_body;
  for (const PairBound& pair : q.pairs) {
    by_body[pair.a].push_back(&pair);
    if (pair.both_move && pair.b != pair.a) by_body[pair.b].push_back(&pair);
  }
  return by_body;
}

CONTACT_SCENES_INLINE const HalfSpaceShape& wall_of(const PlanInput& q, const PairBound& pair) {
  return std::get<HalfSpaceShape>(q.scene->bodies[pair.b].shape);
}

/// Whether a corner of two walls is left in one direction, whichever wall is first.
CONTACT_SCENES_INLINE bool corner_has_one_way(const PlanInput& q, const PairBound& one,
                                              const PairBound& other) {
  const Vector3<double>& n = wall_of(q, one).normal;
  const Vector3<double>& m = wall_of(q, other).normal;
  if (n.cross(m) == Vector3<double>::Zero() || n.dot(m) == 0) return true;
  if (std::min(one.min_restitution, other.min_restitution) < 1) return false;
  constexpr double half_turn = 3.141592653589793;
  for (int k = 3; k <= 64; ++k)
    if (std::abs(n.dot(m) + std::cos(half_turn / k)) <= 8 * plan_u) return true;
  return false;
}

}  // namespace detail

// [corners]
CONTACT_SCENES_INLINE double corners_of_two_ways(const PlanInput& q) {
  double count = 0;
  for (const auto& [body, pairs] : detail::pairs_by_body(q)) {
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      for (std::size_t k = i + 1; k < pairs.size(); ++k) {
        if (pairs[i]->half_space && pairs[k]->half_space)
          count += detail::corner_has_one_way(q, *pairs[i], *pairs[k]) ? 0 : 1;
      }
    }
  }
  return count;
}
// [/corners]

// [two-sides]
CONTACT_SCENES_INLINE double hit_from_two_sides(const PlanInput& q) {
  struct Group {
    double min_mass = detail::infinite;
    double max_mass = 0;
    double min_restitution = 1;  // between bodies that move
    double max_restitution = 0;  // of all pairs
  };
  std::map<std::size_t, Group> groups;
  for (std::size_t i = 0; i < q.scene->bodies.size(); ++i) {
    if (!q.scene->bodies[i].moves) continue;
    Group& group = groups[q.bounds.bodies[i].group];
    group.min_mass = std::min(group.min_mass, q.scene->bodies[i].mass);
    group.max_mass = std::max(group.max_mass, q.scene->bodies[i].mass);
  }
  for (const PairBound& pair : q.pairs) {
    if (!pair.hard) continue;
    Group& group = groups[q.bounds.bodies[pair.a].group];
    group.max_restitution = std::max(group.max_restitution, pair.max_restitution);
    if (pair.both_move)
      group.min_restitution = std::min(group.min_restitution, pair.min_restitution);
  }
  double count = 0;
  for (const auto& [body, pairs] : detail::pairs_by_body(q)) {
    double hard = 0;
    bool moving = false;
    for (const PairBound* pair : pairs) {
      if (!pair->hard) continue;
      hard += pair->crowd && pair->both_move ? 2 : 1;
      moving = moving || pair->both_move;
    }
    if (hard < 2 || !moving) continue;
    const Group& group = groups[q.bounds.bodies[body].group];
    const bool exchange = group.min_mass == group.max_mass && group.min_restitution == 1;
    count += exchange || group.max_restitution == 0 ? 0 : 1;
  }
  return count;
}
// [/two-sides]

namespace detail {

/// Whether a body between a floor and a ceiling comes near the energy of a graze, in a bounce.
/// @param below, above distances from the floor and the ceiling, m
/// @param up speed away from the floor, m/s
/// @param e_floor, e_ceiling restitution at the floor and at the ceiling
CONTACT_SCENES_INLINE bool grazes_in_a_bounce(double gravity, double below, double above, double up,
                                              double e_floor, double e_ceiling) {
  const double top = gravity * (below + above);  // energy at the ceiling for each kilogram
  double energy = up * up / 2 + gravity * below;
  bool rises = up > 0;
  for (int bounce = 0; bounce < 100000; ++bounce) {
    if (rises) {
      if (std::abs(energy - top) <= top / 100) return true;
      if (energy < top) return false;  // and no later bounce is higher
      energy = top + e_ceiling * e_ceiling * (energy - top);
    }
    if (rises && e_floor == 1 && e_ceiling == 1) return false;  // it repeats
    energy *= e_floor * e_floor;
    rises = true;
  }
  return true;
}

}  // namespace detail

// [ceilings]
CONTACT_SCENES_INLINE double ceilings_grazed(const PlanInput& q) {
  const double gravity = gravity_felt(q);
  if (!(gravity > 0)) return 0;
  double count = 0;
  for (const auto& [body, pairs] : detail::pairs_by_body(q)) {
    const PairBound* floor = nullptr;
    const PairBound* ceiling = nullptr;
    double below = detail::infinite;
    double above = detail::infinite;
    double round = 0;  // fixed bodies of other shapes
    for (const PairBound* pair : pairs) {
      if (pair->both_move) continue;
      const auto gap = starting_gap(q.scene->bodies[body], q.scene->bodies[pair->b]);
      const double open = std::max(0.0, gap.value_or(0));
      if (!pair->half_space) {
        round += 1;
        continue;
      }
      const Vector3<double>& n = detail::wall_of(q, *pair).normal;
      const double along = n.dot(q.scene->gravity);
      if (along == 0 || n.cross(q.scene->gravity) != Vector3<double>::Zero()) continue;
      PairBound const*& nearest = along < 0 ? floor : ceiling;
      double& least = along < 0 ? below : above;
      if (nearest == nullptr || open < least) {
        nearest = pair;
        least = open;
      }
    }
    if (round + (floor != nullptr ? 1 : 0) + (ceiling != nullptr ? 1 : 0) <= 1) continue;
    if (round > 0) {
      count += 1;
      continue;
    }
    if (floor->crowd || ceiling->crowd || floor->min_restitution != floor->max_restitution ||
        ceiling->min_restitution != ceiling->max_restitution) {
      count += 1;
      continue;
    }
    const double up = detail::wall_of(q, *floor).normal.dot(q.scene->bodies[body].velocity);
    count += detail::grazes_in_a_bounce(gravity, below, above, up, floor->max_restitution,
                                        ceiling->max_restitution)
                 ? 1
                 : 0;
  }
  return count;
}
// [/ceilings]

// [at-once]
CONTACT_SCENES_INLINE double earliest_hits_at_once(const PlanInput& q) {
  if (q.bounds.crowded) return 0;
  double earliest = detail::infinite;
  for (const auto& [body, pairs] : detail::pairs_by_body(q)) {
    if (pairs.size() < 2) continue;
    std::vector<double> times;
    for (const PairBound* pair : pairs) {
      const auto gap = starting_gap(q.scene->bodies[pair->a], q.scene->bodies[pair->b]);
      const double open = std::max(0.0, gap.value_or(0));
      times.push_back(open > 0 ? detail::rounded_down(open / pair->closing) : 0.0);
    }
    std::nth_element(times.begin(), times.begin() + 1, times.end());
    earliest = std::min(earliest, times[1]);
  }
  return std::max(earliest, detail::first_touch(q));
}
// [/at-once]

// [first-hits]
CONTACT_SCENES_INLINE std::vector<FirstHit> first_hits(const PlanInput& q, double margin) {
  std::vector<FirstHit> hits;
  if (q.bounds.crowded) return hits;
  for (const PairBound& pair : q.pairs) {
    const SceneBody& a = q.scene->bodies[pair.a];
    const SceneBody& b = q.scene->bodies[pair.b];
    const auto* ball = std::get_if<BallShape>(&a.shape);
    const auto* other = std::get_if<BallShape>(&b.shape);
    if (ball == nullptr || other == nullptr) continue;
    if (!pair.both_move && gravity_felt(q) > 0) continue;
    const Vector3<double> x = a.position - b.position;
    const Vector3<double> v = a.velocity - b.velocity;
    const double speed = detail::length_of(v);
    if (!(speed > 0) || !(x.dot(v) < 0)) continue;
    FirstHit hit{pair.a, pair.b, 0, speed, ball->radius + other->radius, 0};
    hit.distance = detail::length_of(x.cross(v)) / speed;
    const auto time = sphere_sphere_impact<double>({a.position, ball->radius}, a.velocity,
                                                   {b.position, other->radius}, b.velocity);
    if (!time && hit.distance > hit.radius + margin) continue;
    hit.time = time.value_or(-x.dot(v) / (speed * speed));
    if (hit.time <= q.scene->duration) hits.push_back(hit);
  }
  return hits;
}

CONTACT_SCENES_INLINE double spread_of_deflection(const FirstHit& hit, double error) {
  // asin α − asin β by tan ½(α − β) = (sin α − sin β)/(cos α + cos β), which loses no digits
  // however small the error is. A path farther out than the radius is not deflected.
  const double inside = hit.radius - hit.distance + error;
  if (!(inside > 0)) return 0;
  const double outside = std::max(0.0, hit.radius - hit.distance - error);
  const double apart = std::min(2 * error, inside);
  const double cosines = std::sqrt(inside * std::max(0.0, hit.radius + hit.distance - error)) +
                         std::sqrt(outside * (hit.radius + hit.distance + error));  // times R
  return 4 * std::atan(apart / cosines);
}

CONTACT_SCENES_INLINE double first_hits_at_once(const PlanInput& q,
                                                const std::vector<FirstHit>& hits) {
  constexpr double share = 1e-12;
  double earliest = detail::infinite;
  std::map<std::size_t, std::vector<double>> times;  // of each body that moves
  for (const FirstHit& hit : hits) {
    times[hit.a].push_back(hit.time);
    if (q.scene->bodies[hit.b].moves) times[hit.b].push_back(hit.time);
  }
  for (auto& [body, list] : times) {
    std::sort(list.begin(), list.end());
    if (list.size() > 1 && list[1] - list[0] <= share * (list[0] + list[1]))
      earliest = std::min(earliest, list[0]);
  }
  // Two that touch and do not separate are both hit when one of them is.
  for (const PairBound& pair : q.pairs) {
    if (pair.crowd || pair.half_space || pair.apart) continue;
    const SceneBody& a = q.scene->bodies[pair.a];
    const SceneBody& b = q.scene->bodies[pair.b];
    const double size = detail::coordinate_size(a.position) + detail::coordinate_size(b.position);
    const auto gap = starting_gap(a, b);
    if (!gap || *gap > share * size || (a.position - b.position).dot(a.velocity - b.velocity) > 0)
      continue;
    for (const std::size_t one : {pair.a, pair.b}) {
      const auto found = times.find(one);
      if (found != times.end()) earliest = std::min(earliest, found->second.front());
    }
  }
  return earliest;
}
// [/first-hits]

CONTACT_SCENES_INLINE bool at_most_one_hit(const PlanInput& q) {
  return q.pairs.size() == 1 && !q.pairs[0].crowd && q.pairs[0].round && !q.pairs[0].half_space &&
         !q.pairs[0].soft && q.pairs[0].friction == 0 && !(gravity_felt(q) > 0);
}

CONTACT_SCENES_INLINE double hits_at_once(const PlanInput& q) {
  constexpr double share = 1e-12;
  double count = 0;
  std::map<std::size_t, double> partners;  // that are no half-spaces
  for (const PairBound& pair : q.pairs) {
    if (pair.half_space) continue;
    partners[pair.a] += pair.crowd ? pair.count : 1;
    if (pair.both_move) partners[pair.b] += 1;
  }
  for (const PairBound& pair : q.pairs) {
    if (pair.half_space || !pair.hard || !(pair.max_restitution > 0)) continue;
    if (pair.crowd) {
      count += pair.apart ? 0 : 1;
      continue;
    }
    const SceneBody& a = q.scene->bodies[pair.a];
    const SceneBody& b = q.scene->bodies[pair.b];
    if (partners[pair.a] < 2 && !(pair.both_move && partners[pair.b] > 1)) continue;
    const double size = detail::coordinate_size(a.position) + detail::coordinate_size(b.position);
    const auto gap = starting_gap(a, b);
    count += gap && *gap <= share * size ? 1 : 0;
  }
  const std::vector<FirstHit> hits = first_hits(q, 0);
  for (std::size_t i = 0; i < hits.size(); ++i) {
    for (std::size_t k = i + 1; k < hits.size(); ++k) {
      const auto shared = [&](std::size_t body) {
        return q.scene->bodies[body].moves && (body == hits[k].a || body == hits[k].b);
      };
      if (!shared(hits[i].a) && !shared(hits[i].b)) continue;
      count +=
          std::abs(hits[i].time - hits[k].time) <= share * (hits[i].time + hits[k].time) ? 1 : 0;
    }
  }
  return count;
}

}  // namespace contact
