#include <contact/plan/plan_rules.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <contact/ballistic.hpp>
#include <contact/closest_points.hpp>
#include <contact/convex_hull.hpp>
#include <contact/inertia.hpp>
#include <contact/plan/plan_bounds.hpp>
#include <contact/plan/plan_hypotheses.hpp>
#include <contact/plan/plan_spreading.hpp>
#include <contact/plan/plan_types.hpp>
#include <contact/scene/compiled.hpp>
#include <contact/scene/scene.hpp>
#include <contact/scene/scene_solids.hpp>
#include <contact/signed_distance.hpp>
#include <contact/sphere_sphere_impact.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace detail {

CONTACT_SCENES_INLINE Room room_of(const Scene& scene) {
  Room room;
  Vector3<double> low = Vector3<double>::Constant(infinite);
  Vector3<double> high = Vector3<double>::Constant(-infinite);
  Vector3<double> floor = Vector3<double>::Constant(-infinite);
  Vector3<double> ceiling = Vector3<double>::Constant(infinite);
  std::vector<double> diameters;
  for (const SceneBody& body : scene.bodies) {
    if (const auto* wall = std::get_if<HalfSpaceShape>(&body.shape)) {
      const int axis = level_axis(wall->normal);
      if (axis < 0) continue;
      if (wall->normal(axis) > 0) floor(axis) = std::max(floor(axis), wall->offset);
      if (wall->normal(axis) < 0) ceiling(axis) = std::min(ceiling(axis), -wall->offset);
    }
    if (!body.moves) continue;
    const double radius = outer_radius(body.shape);
    diameters.push_back(2 * radius);
    room.widest = std::max(room.widest, 2 * radius);
    low = low.cwiseMin(body.position - Vector3<double>::Constant(radius));
    high = high.cwiseMax(body.position + Vector3<double>::Constant(radius));
  }
  if (diameters.empty()) return room;
  const auto n = static_cast<double>(diameters.size());
  room.mean = sorted_sum(std::move(diameters)) / n;
  for (int k = 0; k < 3; ++k) {
    const bool walled = std::isfinite(floor(k)) && std::isfinite(ceiling(k));
    room.walled[static_cast<std::size_t>(k)] = walled;
    room.size(k) = std::max(walled ? ceiling(k) - floor(k) : high(k) - low(k), room.widest);
  }
  return room;
}

/// The path of a body from hit to hit.
struct FreePath {
  double speed = 0;   ///< of the fast bodies, m/s: initially, or when all have shared their energy
  double length = 0;  ///< mean free path, m
  double radius = 0;  ///< the smallest sum of radii in a hit, m
};

/// The speed of the fast bodies: the largest initial speed, or the root mean square of the lightest
/// of a group when each of its n bodies has 1/n of the energy. Gravity adds to it.
CONTACT_SCENES_INLINE double fast_speed(const PlanInput& q) {
  struct Share {
    double count = 0;
    double lightest = infinite;
  };
  std::vector<Share> shares(q.bounds.groups.size());
  double speed = 0;
  for (std::size_t i = 0; i < q.scene->bodies.size(); ++i) {
    const SceneBody& body = q.scene->bodies[i];
    if (!body.moves) continue;
    Share& share = shares[q.bounds.bodies[i].group];
    share.count += 1;
    share.lightest = std::min(share.lightest, body.mass);
    speed = std::max(speed, body.velocity.norm());
  }
  for (std::size_t i = 0; i < shares.size(); ++i) {
    if (shares[i].count == 0) continue;
    const EnergyShare& energy = q.bounds.groups[i];
    const double mass = shares[i].count * shares[i].lightest;
    const double with_time =
        std::sqrt(energy.twice_kinetic / mass) + gravity_felt(q) * q.scene->duration;
    speed = std::max(speed, std::min(std::sqrt(energy.twice_floor / mass), with_time));
  }
  return speed;
}

/// The mean free path of a gas, V/(√2 π D² N), but no longer than the room is wide.
CONTACT_SCENES_INLINE FreePath free_path(const PlanInput& q) {
  FreePath path;
  const Room room = room_of(*q.scene);
  double balls = 0;
  double least = infinite;
  for (const SceneBody& body : q.scene->bodies)
    if (body.moves) least = std::min(least, outer_radius(body.shape));
  path.speed = fast_speed(q);
  path.radius = infinite;
  for (const PairBound& pair : q.pairs) {
    if (pair.half_space) continue;
    const SceneShape& other = q.scene->bodies[pair.b].shape;
    const bool post = !pair.both_move && std::holds_alternative<BallShape>(other);
    path.radius = std::min(path.radius, least + (post ? outer_radius(other) : 0));
  }
  if (std::isinf(path.radius)) return path;
  for (const BodyBound& body : q.bounds.bodies) balls += body.disturbed ? 1 : 0;
  const double widest = room.size.maxCoeff();
  const double volume = room.size.x() * room.size.y() * room.size.z();
  const double area = 4.442882938158366 * room.mean * room.mean;  // √2 π D²
  path.length = std::min(volume / (area * std::max(1.0, balls)), widest);
  return path;
}

/// The smallest cage of a moving body: the distance to the fourth nearest fixed body, half-spaces
/// included. Fewer than four leave it a way out.
CONTACT_SCENES_INLINE double narrowest_cage(const PlanInput& q) {
  std::map<std::size_t, std::vector<double>> gaps;  // of each body that moves
  for (const PairBound& pair : q.pairs) {
    if (pair.both_move) continue;
    const SceneBody& mover = q.scene->bodies[pair.a];
    if (const auto gap = starting_gap(mover, q.scene->bodies[pair.b]))
      gaps[pair.a].push_back(std::max(0.0, *gap));
  }
  double narrowest = infinite;
  for (auto& [mover, list] : gaps) {
    if (list.size() < 4) continue;
    std::nth_element(list.begin(), list.begin() + 3, list.end());
    narrowest = std::min(narrowest, list[3]);
  }
  return narrowest;
}

/// Twice the width of the middle half of some numbers: the whole width if they are evenly
/// distributed, and no wider for a few outliers.
CONTACT_SCENES_INLINE double middle_width(std::vector<double>& numbers) {
  const std::size_t quarter = numbers.size() / 4;
  std::sort(numbers.begin(), numbers.end());
  const double width = numbers[numbers.size() - 1 - quarter] - numbers[quarter];
  return quarter == 0 ? width : 2 * width;
}

/// How far a body flies from hit to hit where the bodies are densest at the start: in a gas that
/// fills only the box around most of the moving bodies, and no farther than the width of its cage.
CONTACT_SCENES_INLINE double crowded_path(const PlanInput& q, const FreePath& even) {
  std::array<std::vector<double>, 3> places;
  for (const SceneBody& body : q.scene->bodies)
    for (std::size_t k = 0; k < 3; ++k)
      if (body.moves) places[k].push_back(body.position(static_cast<int>(k)));
  const auto balls = static_cast<double>(places[0].size());
  const Room room = room_of(*q.scene);
  double volume = 1;
  for (std::vector<double>& along : places) volume *= middle_width(along) + room.widest;
  const double area = 4.442882938158366 * room.mean * room.mean;  // √2 π D²
  // One ball is not a gas.
  const double among = balls > 1 ? volume / (area * balls) : infinite;
  return std::min({even.length, among, narrowest_cage(q)});
}

/// The growth rate of the largest of n errors, of balls that hit each other, relative to a mean
/// error.
///
/// The ball with the largest error passes it to each ball that it hits, and the next hit of either
/// multiplies it: for very many balls the largest error grows as if that ball hit 2 e^γ = 4.311
/// times as often, where e^γ (1 − γ) = ½. For n balls it is 2 e^γ (1 − γ π²/(2 ln² n)) times. All
/// hits together are n/2 times as many as one ball's; for few balls that is taken, up to twice.
///
/// Sources: van Zon, van Beijeren and Dellago, *Largest Lyapunov exponent for many particle systems
/// at low densities*, Physical Review Letters 80 (1998); for n Brunet and Derrida, *Shift in the
/// velocity of a front due to a cutoff*, Physical Review E 56 (1997).
CONTACT_SCENES_INLINE double max_error_growth(double n) {
  constexpr double half_of_pi_squared = 4.934802200544679;
  const double digits = std::log(std::max(n, 2.0));
  return std::max(std::min(n / 2, 2.0),
                  4.311 * (1 - 0.768 * half_of_pi_squared / (digits * digits)));
}

/// Until when positions are known if nothing confines the balls: each pair meets once, and no
/// flight from hit to hit is longer than the whole time.
CONTACT_SCENES_INLINE double horizon_in_the_open(const FreePath& path, double pairs,
                                                 double growth) {
  return (std::pow(growth, 1 / pairs) - 1) * path.radius / (4 * path.speed);
}

/// The number of half-spaces oblique to gravity, if there are others beside them: between two such
/// walls a ball that bounces under gravity does not come back to its position.
CONTACT_SCENES_INLINE double oblique_walls(const PlanInput& q) {
  if (!(gravity_felt(q) > 0)) return 0;
  std::vector<std::size_t> walls;
  for (const PairBound& pair : q.pairs)
    if (pair.half_space) walls.push_back(pair.b);
  std::sort(walls.begin(), walls.end());
  walls.erase(std::unique(walls.begin(), walls.end()), walls.end());
  double slanting = 0;
  for (const std::size_t wall : walls) {
    const Vector3<double>& n = std::get<HalfSpaceShape>(q.scene->bodies[wall].shape).normal;
    const Vector3<double>& g = q.scene->gravity;
    const bool level = n.cross(g) == Vector3<double>::Zero();
    slanting += level || n.dot(g) == 0 ? 0 : 1;
  }
  return walls.size() > 1 ? slanting : 0;
}

/// Whether bodies fall and bounce on a line.
CONTACT_SCENES_INLINE bool bounces_under_gravity(const PlanInput& q) {
  double rebound = 0;
  for (const PairBound& pair : q.pairs)
    rebound = std::max(rebound, pair.soft ? 1.0 : pair.max_restitution);
  return gravity_felt(q) > 0 && rebound > 0;
}

/// The proofs that small differences grow no faster than time, if they hold.
CONTACT_SCENES_INLINE std::vector<Proof> nothing_spreads(const PlanInput& q, bool turning) {
  double lenses = 0;
  for (const PairBound& pair : q.pairs) lenses += pair.half_space ? 0 : pair.count;
  const double soft = springs_beside_others(q);
  const double oblique = oblique_walls(q);
  std::vector<Proof> proofs{
      {proof_claim("flat-walls"),
       {required(q, "flat-walls/no-round-pairs", lenses),
        required(q, "flat-walls/no-turning-shapes", turning ? touching_non_balls(q) : 0.0),
        required(q, "flat-walls/level-walls", oblique),
        required(q, "flat-walls/smooth-beside-others", rough_pairs_beside_others(q)),
        required(q, "flat-walls/no-springs-beside-others", soft),
        required(q, "flat-walls/square-corners", oblique > 0 ? 0.0 : corners_of_two_ways(q)),
        required(q, "flat-walls/no-grazed-ceiling", ceilings_grazed(q))}}};
  if (auto line = proven_line(q)) {
    const bool columns = bounces_under_gravity(q);
    line->why = proof_claim("one-line");
    line->conditions.push_back(
        required(q, "one-line/one-falls", columns ? static_cast<double>(q.bounds.movers) : 0.0, 1));
    line->conditions.push_back(required(q, "one-line/no-springs-beside-others", soft));
    // One that falls alone is hit by fixed bodies only.
    line->conditions.push_back(
        required(q, "one-line/equal-or-alone", columns ? 0.0 : hit_from_two_sides(q)));
    line->conditions.push_back(
        required(q, "one-line/no-grazed-ceiling", columns ? ceilings_grazed(q) : 0.0));
    proofs.push_back(*line);
  }
  return proofs;
}

/// The speed of a fall from the initial position to the farthest wall below, m/s.
CONTACT_SCENES_INLINE double falling_speed(const PlanInput& q) {
  double drop = 0;
  double speed = 0;
  for (const SceneBody& body : q.scene->bodies)
    speed = std::max(speed, body.moves ? body.velocity.norm() : 0.0);
  for (const PairBound& pair : q.pairs) {
    if (!pair.half_space) continue;
    const auto gap = starting_gap(q.scene->bodies[pair.a], q.scene->bodies[pair.b]);
    drop = std::max(drop, gap.value_or(0));
  }
  return std::sqrt(speed * speed + 2 * gravity_felt(q) * drop);
}

/// How often an error grows by a factor e, 1/s: by hits on balls, and by falling.
CONTACT_SCENES_INLINE double spreading(const PlanInput& q, const FreePath& path) {
  double pace = 0;
  if (std::isfinite(path.radius)) {
    bool gas = false;
    bool posts = false;
    for (const PairBound& pair : q.pairs) {
      gas = gas || pair.both_move;
      posts = posts || !(pair.both_move || pair.half_space);
    }
    const double way = crowded_path(q, path);
    // For short flights, ln(1 + 4 λ/R)/λ is 4/R.
    const double widening = 4 * way / path.radius;
    const double a_way = widening < 1e-6 ? 4 / path.radius : std::log(1 + widening) / way;
    // A single ball may have more oblique hits than the average: half as much again.
    const double leading = gas ? max_error_growth(static_cast<double>(q.bounds.movers)) : 1;
    pace = std::max(leading, posts ? 1.5 : 1) * a_way * path.speed;
  }
  if (!(gravity_felt(q) > 0)) return pace;
  return pace + 3 * gravity_felt(q) / std::min(path.speed, falling_speed(q));
}

/// The earliest time at which a pair may touch, if nothing else does before; empty: never. For two
/// balls it is exact. Any other distance decreases no faster than both surfaces move, plus gravity
/// if one of the two is fixed.
CONTACT_SCENES_INLINE std::optional<double> earliest_touch(const PlanInput& q,
                                                           const PairBound& pair, double gap) {
  const SceneBody& a = q.scene->bodies[pair.a];
  const SceneBody& b = q.scene->bodies[pair.b];
  const auto swing = [](const SceneBody& body) {
    return body.moves ? body.angular_velocity.norm() * rotation_radius(body.shape) : 0;
  };
  const bool falls = gravity_felt(q) > 0;
  const auto* ball = std::get_if<BallShape>(&a.shape);
  const auto* other = std::get_if<BallShape>(&b.shape);
  if (ball && other && (pair.both_move || !falls)) {
    return sphere_sphere_impact<double>({a.position, ball->radius}, a.velocity,
                                        {b.position, other->radius}, b.velocity);
  }
  const Vector3<double> relative = a.velocity - b.velocity;
  double rate = -relative.norm();
  double pull = pair.both_move ? 0 : -gravity_felt(q);
  if (const auto* ground = std::get_if<HalfSpaceShape>(&b.shape)) {
    rate = ground->normal.dot(relative);
    pull = falls ? ground->normal.dot(q.scene->gravity) : 0;
  }
  return closing_time<double>(std::max(gap, 0.0), rate - swing(a) - swing(b), pull);
}

CONTACT_SCENES_INLINE double first_touch(const PlanInput& q) {
  if (q.bounds.crowded) return 0;
  double first = q.scene->duration;
  for (const PairBound& pair : q.pairs) {
    const auto gap = starting_gap(q.scene->bodies[pair.a], q.scene->bodies[pair.b]);
    if (!gap) return 0;
    const auto time = earliest_touch(q, pair, *gap);
    if (time) first = std::min(first, *time);
  }
  return first;
}

CONTACT_SCENES_INLINE bool is_dropped(const PlanInput& q, std::string_view id) {
  return std::find(q.dropped.begin(), q.dropped.end(), id) != q.dropped.end();
}

/// The earliest time at which the order of hits, or a graze of a ceiling, may decide where bodies
/// go. On a line and between flat walls it is a bound; of other balls only the first hits are
/// examined.
/// @return s; ∞ where none is known
CONTACT_SCENES_INLINE double first_decided_by_order(const PlanInput& q) {
  double until = infinite;
  const auto by = [&](std::string_view id, double time) {
    if (!is_dropped(q, id)) until = std::min(until, time);
  };
  const bool falls = gravity_felt(q) > 0;
  bool flat = true;
  for (const PairBound& pair : q.pairs) flat = flat && pair.half_space;
  if (proven_line(q)) {
    if (!bounces_under_gravity(q) && hit_from_two_sides(q) > 0)
      by("one-line/equal-or-alone", earliest_hits_at_once(q));
    if (bounces_under_gravity(q) && q.bounds.movers == 1 && ceilings_grazed(q) > 0)
      by("one-line/no-grazed-ceiling", first_touch(q));
  } else if (flat) {
    if (!falls && corners_of_two_ways(q) > 0)
      by("flat-walls/square-corners", earliest_hits_at_once(q));
    if (ceilings_grazed(q) > 0) by("flat-walls/no-grazed-ceiling", first_touch(q));
  } else {
    by("first-hits/not-at-once", first_hits_at_once(q, first_hits(q, 0)));
  }
  return until;
}

/// What the horizon is computed from.
struct HorizonGrowth {
  FreePath path;
  bool open = false;     ///< nothing confines the balls
  double pairs = 0;      ///< that may meet
  double error = 0;      ///< an ulp of the largest coordinate, m
  double tolerance = 0;  ///< to which it grows, m: the scene's, or a radius
};

/// The time from the first hit on in which an error grows by a factor, s.
CONTACT_SCENES_INLINE double growing_time(const PlanInput& q, const HorizonGrowth& of,
                                          double factor) {
  const double growth = std::max(1.0, factor);
  double time = std::log(growth) / spreading(q, of.path);
  if (of.open) time = std::max(time, horizon_in_the_open(of.path, of.pairs, growth));
  return std::isnan(time) ? 0 : time;
}

/// The horizon after a first hit that is more oblique than on average.
///
/// The spread of the deflection is computed from the impact parameter and its error. What it is
/// more than 4/R of the error counts as growth of the error itself; and until the next hit the two
/// paths diverge at this angle.
/// @param more set to the growth beside an average hit's
/// @return s; ∞ if the hit is no more oblique
CONTACT_SCENES_INLINE double after_oblique_hit(const PlanInput& q, const HorizonGrowth& of,
                                               const FirstHit& hit, double& more) {
  const double error = of.error + 4 * std::numeric_limits<double>::epsilon() * hit.speed * hit.time;
  const double spread = spread_of_deflection(hit, error);
  more = spread * hit.radius / (4 * error);
  if (!(more > 1)) return infinite;
  const double straight = std::max(0.0, of.tolerance - error) / (spread * hit.speed);
  return hit.time + std::min(straight, growing_time(q, of, of.tolerance / error / more));
}

}  // namespace detail

/// Until when positions can be predicted: an estimate for typical hits.
///
/// Two balls spread an error as a lens does: an error perpendicular to the path grows by about 1 +
/// 2 λ/(R cos θ) from hit to hit, with the flight λ and the sum R of the radii; the mean of 1/cos θ
/// over all directions of impact is 2. So an ulp of the largest coordinate grows to the tolerance,
/// at v/λ hits a second; the largest error of many balls faster. Of the first hits the obliqueness
/// is computed from the scene; of later ones it is not known, so only where a pair meets once is
/// this a bound. Falling spreads too, where walls are oblique or masses differ: by a factor e in at
/// least a third of the time v/g. Flat walls alone do not spread, and on a line without gravity
/// nothing does: there rounding errors only add up, until hits may be at the same instant. For
/// rotating bodies with vertices no estimate is known. All of this begins with the first hit.
/// @param turning whether the plan has rotation
CONTACT_SCENES_INLINE Decision plan_horizon(const PlanInput& q, bool turning) {
  Decision decision = decide(Effect::horizon, detail::nothing_spreads(q, turning),
                             "Estimated: an ulp grows by 1 + 4 λ/R from hit to hit.");
  if (!decision.on) return decision;
  if (turning && touching_non_balls(q) > 0) {
    decision.why = "Not known: a rotating body with vertices may diverge from its twin at any hit.";
    return decision;
  }
  detail::HorizonGrowth of;
  of.path = detail::free_path(q);
  if (!(of.path.speed > 0) || !std::isfinite(of.path.speed)) {
    decision.why = "Not proven: nothing moves at first, so the rate of hits is not known.";
    return decision;
  }
  of.open = !(gravity_felt(q) > 0);
  for (const PairBound& pair : q.pairs) {
    of.open = of.open && pair.both_move;
    of.pairs += pair.count;
  }
  // [horizon-rule]
  double size = of.path.length;
  double least = detail::infinite;
  for (const SceneBody& body : q.scene->bodies) {
    if (!body.moves) continue;
    size = std::max(size, body.position.cwiseAbs().maxCoeff());
    least = std::min(least, outer_radius(body.shape));
  }
  of.error = size * std::numeric_limits<double>::epsilon();
  of.tolerance = q.tolerance > 0 ? q.tolerance : least;
  const double first = detail::first_touch(q);
  double until = first + detail::growing_time(q, of, of.tolerance / of.error);
  // [/horizon-rule]
  const bool no_lens =
      proven_line(q) && !detail::bounces_under_gravity(q) && !(springs_beside_others(q) > 0);
  if (no_lens) until = detail::infinite;
  const std::string to = q.tolerance > 0 ? "the tolerance" : "a radius";
  std::vector<Inequality> shorter;
  if (!no_lens && !detail::is_dropped(q, "first-hits/obliqueness")) {
    double oblique = 0;
    for (const FirstHit& hit : first_hits(q, 8 * of.error)) {
      double more = 0;
      const double then = detail::after_oblique_hit(q, of, hit, more);
      if (!(then < until)) continue;
      until = then;
      oblique = more;
    }
    if (oblique > 1) shorter.push_back(required(q, "first-hits/obliqueness", oblique, 1));
  }
  const double at_once = detail::first_decided_by_order(q);
  if (at_once < until) {
    until = at_once;
    shorter.push_back(required(q, "first-hits/not-at-once", 1));
    decision.why =
        "Until hits may be at the same instant, in an order that the scene does not give, or a "
        "bounce may graze a ceiling.";
  }
  if (!std::isfinite(until)) {
    decision.why = "Not known: no rate is known at which springs or friction spread paths here.";
    return decision;
  }
  decision.value = until;
  decision.because = {
      {"the start", 0, Relation::at_most, first, "earliest possible first touch", "s"},
      {"time until an ulp has grown to " + to + ", by 1 + 4 λ/R a hit", until, Relation::at_most,
       q.scene->duration, "duration", "s"}};
  decision.because.insert(decision.because.end(), shorter.begin(), shorter.end());
  return decision;
}

}  // namespace contact
