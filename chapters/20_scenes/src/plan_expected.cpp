#include <contact/plan/plan_rules.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <variant>
#include <vector>

#include <contact/broad_phase_cost.hpp>
#include <contact/closest_points.hpp>
#include <contact/inertia.hpp>
#include <contact/plan/plan_bounds.hpp>
#include <contact/plan/plan_costs.hpp>
#include <contact/plan/plan_types.hpp>
#include <contact/quaternion.hpp>
#include <contact/scene/compiled.hpp>
#include <contact/scene/scene.hpp>
#include <contact/scene/scene_solids.hpp>
#include <contact/signed_distance.hpp>
#include <contact/stepped/stage_motion.hpp>
#include <contact/stepped/stepped_state.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace detail {

/// Whether both of a pair have vertices or edges.
CONTACT_SCENES_INLINE bool both_have_corners(const SceneBody& a, const SceneBody& b) {
  return !is_ball(a) && !is_ball(b) && !is_half_space(b);
}

CONTACT_SCENES_INLINE double gap_cost(const SceneBody& a, const SceneBody& b) {
  if (is_ball(a) || is_ball(b)) return cost::sphere_gap;
  return is_half_space(b) ? cost::half_space_gap : cost::corner_gap;
}

CONTACT_SCENES_INLINE double impact_cost(const SceneBody& a, const SceneBody& b) {
  return both_have_corners(a, b) ? cost::corner_impact : cost::sphere_impact;
}

/// The number of contact points of two bodies that lie on each other.
CONTACT_SCENES_INLINE double points_of_pair(const SceneBody& a, const SceneBody& b) {
  if (is_ball(a) || is_ball(b)) return 1;
  const bool capsule = std::holds_alternative<CapsuleShape>(a.shape) ||
                       std::holds_alternative<CapsuleShape>(b.shape);
  return capsule ? 2 : 4;
}

/// The distance of two bodies at the start: of their bounding balls where these do not overlap, so
/// that few pairs need the exact distance.
CONTACT_SCENES_INLINE double first_gap(const SceneBody& a, const SceneBody& b) {
  if (!is_half_space(b)) {
    const double balls = length_of(Vector3<double>(a.position - b.position)) -
                         (outer_radius(a.shape) + outer_radius(b.shape));
    if (balls > 0) return balls;
  }
  return std::max(0.0, starting_gap(a, b).value_or(infinite));
}

/// When and how fast two bodies first meet that fly towards each other, and from when on they stay
/// in contact; s, m/s, s.
struct Meeting {
  double time = infinite;
  double speed = 0;
  double together = infinite;
  bool pressed = false;  ///< by gravity
};

/// Along the line of their centres, or a half-space's normal. They stay in contact if e = 0 when
/// they meet, and where gravity presses after 2 e w/(g (1 − e)).
CONTACT_SCENES_INLINE Meeting meeting_of(const PlanInput& q, const PairBound& pair) {
  const SceneBody& a = q.scene->bodies[pair.a];
  const SceneBody& b = q.scene->bodies[pair.b];
  Meeting meeting;
  const double gap = first_gap(a, b);
  Vector3<double> n;
  if (const auto* wall = std::get_if<HalfSpaceShape>(&b.shape)) {
    n = wall->normal;
  } else {
    n = a.position - b.position;
    const double size = length_of(n);
    if (!(size > 0)) return meeting;
    n /= size;
  }
  const double g = gravity_felt(q) > 0 ? -n.dot(q.scene->gravity) : 0.0;
  const double pull = b.moves ? 0.0 : g;
  const double towards = -n.dot(Vector3<double>(a.velocity - b.velocity));
  // Gravity hardly presses an oblique pair.
  meeting.pressed = std::abs(g) > q.bounds.gravity / 8;
  const double near = 0x1p-10 * std::min(outer_radius(a.shape), outer_radius(b.shape));
  if (gap <= near && !(towards < 0)) {
    meeting.time = 0;
    meeting.speed = towards;
  } else {
    const double square = towards * towards + 2 * pull * gap;
    if (!(square >= 0) || (pull <= 0 && !(towards > 0))) return meeting;
    meeting.speed = std::sqrt(square);
    if (!(meeting.speed + towards > 0)) return meeting;
    meeting.time = 2 * gap / (meeting.speed + towards);
  }
  const double e = pair.max_restitution;
  if (e == 0 || meeting.speed == 0)
    meeting.together = meeting.time;
  else if (pull > 0 && e < 1)
    meeting.together = meeting.time + 2 * e * meeting.speed / (pull * (1 - e));
  return meeting;
}

/// Which bodies lie on something at the start, pressed by gravity: they do not fall.
CONTACT_SCENES_INLINE std::vector<bool> lying_bodies(const PlanInput& q) {
  std::vector<bool> lies(q.scene->bodies.size(), false);
  for (const PairBound& pair : q.pairs) {
    const Meeting meeting = meeting_of(q, pair);
    if (!meeting.pressed || meeting.together > 0) continue;
    lies[pair.a] = true;
    if (pair.both_move) lies[pair.b] = true;
  }
  return lies;
}

/// Whether every moving body lies on something at the start, at rest.
CONTACT_SCENES_INLINE bool begins_at_rest(const PlanInput& q, const std::vector<bool>& lies) {
  for (std::size_t i = 0; i < lies.size(); ++i) {
    const SceneBody& body = q.scene->bodies[i];
    if (body.moves && (!lies[i] || !body.velocity.isZero(0) || !body.angular_velocity.isZero(0)))
      return false;
  }
  return true;
}

/// Mean square of the initial speeds, plus that of falling through half of the room; m²/s².
CONTACT_SCENES_INLINE double mean_square_speed(const PlanInput& q, const Room& room) {
  std::vector<double> squares;
  for (const SceneBody& body : q.scene->bodies)
    if (body.moves) squares.push_back(body.velocity.dot(body.velocity));
  if (squares.empty()) return 0;
  const double n = static_cast<double>(squares.size());
  const double square = sorted_sum(std::move(squares)) / n;
  double fall = 0;
  for (int k = 0; k < 3; ++k)
    fall += gravity_felt(q) > 0 && room.walled[static_cast<std::size_t>(k)]
                ? std::abs(q.scene->gravity(k)) * (room.size(k) - room.widest) / 2
                : 0.0;
  const double fallen = gravity_felt(q) * q.scene->duration;
  return square + std::min(fall, fallen * fallen);
}

/// Whether walls confine the moving bodies along every axis along which any moves.
CONTACT_SCENES_INLINE bool is_enclosed(const PlanInput& q, const Room& room) {
  for (int k = 0; k < 3; ++k) {
    bool moves = gravity_felt(q) > 0 && q.scene->gravity(k) != 0;
    for (const SceneBody& body : q.scene->bodies)
      moves = moves || (body.moves && body.velocity(k) != 0);
    if (moves && !room.walled[static_cast<std::size_t>(k)]) return false;
  }
  return true;
}

/// Hits of a gas: each ball has √2 π D² n/V χ v of them in a second with others, with Enskog's χ
/// for their own volume, and with the walls of an axis its speed along it over the free width.
CONTACT_SCENES_INLINE void expect_gas(const PlanInput& q, const Room& room, ExpectedRun& run) {
  const double t = q.scene->duration;
  const double speed = std::sqrt(mean_square_speed(q, room));
  const double volume = room.size.x() * room.size.y() * room.size.z();
  const double d = room.mean;
  const double filled = std::min(0.6, run.movers * d * d * d * 0.5235987755982988 / volume);
  const double crowding = (1 - filled / 2) / ((1 - filled) * (1 - filled) * (1 - filled));
  const double rate = 4.442882938158366 * d * d * (run.movers - 1) / volume * crowding * speed;
  run.hits = run.movers * t * rate / 2;
  double axes = 0;
  for (int k = 0; k < 3; ++k) axes += room.size(k) > room.widest ? 1 : 0;
  const double along = axes > 0 ? speed / std::sqrt(axes) : 0.0;
  for (int k = 0; k < 3; ++k) {
    const double free = room.size(k) - room.widest;
    if (room.walled[static_cast<std::size_t>(k)] && free > 0)
      run.wall_hits += run.movers * t * along / (free + d / 2);
  }
  run.hits += run.wall_hits;
  // Cells are as wide as the widest ball, or wider, so that there are at most four a ball.
  double cell = room.widest;
  while (volume > cell * cell * cell * (4 * run.movers + 64)) cell *= 1.125;
  run.occupancy = run.movers * cell * cell * cell / volume;
  run.crossings = run.movers * t * along * axes / cell;
}

/// The share of the time in which a crowd lies in a heap: after it has fallen until it fills six
/// tenths of its volume.
CONTACT_SCENES_INLINE double share_in_heap(const PlanInput& q, const Room& room) {
  const double volume = room.size.x() * room.size.y() * room.size.z();
  const double n = static_cast<double>(q.bounds.movers);
  const double filled = n * room.mean * room.mean * room.mean * 0.5235987755982988 / volume;
  const double g = q.bounds.gravity;
  const double height = room.size.dot(q.scene->gravity.cwiseAbs()) / g;
  const double fall = height * std::max(0.0, 1 - filled / 0.6) / 2;
  return std::max(0.0, 1 - std::sqrt(2 * fall / g) / q.scene->duration);
}

/// Hits, and lasting contacts, of pairs that are considered one by one.
CONTACT_SCENES_INLINE void expect_pairs(const PlanInput& q, const std::vector<bool>& lies,
                                        bool enclosed, ExpectedRun& run) {
  const double t = q.scene->duration;
  std::vector<double> hits;
  std::vector<double> wall_hits;
  std::vector<double> touching;
  std::vector<double> contacts;
  std::vector<double> gaps;
  std::vector<double> unpressed;
  for (const PairBound& pair : q.pairs) {
    if (pair.soft) continue;
    const SceneBody& a = q.scene->bodies[pair.a];
    const SceneBody& b = q.scene->bodies[pair.b];
    const Meeting meeting = meeting_of(q, pair);
    if (!(meeting.time < t) || (meeting.time > 0 && meeting.pressed && lies[pair.a])) continue;
    if (meeting.speed > 0) {
      // A bounce takes 2 w/g, and each is shorter than the previous one.
      double count = 1;
      const double g = b.moves ? 0.0 : meeting.pressed ? q.bounds.gravity : 0.0;
      double bounce = g > 0 ? 2 * pair.max_restitution * meeting.speed / g : 0.0;
      for (double at = meeting.time + bounce; g > 0 && at < t && count < 40; at += bounce) {
        count += 1;
        bounce *= pair.max_restitution;
        if (!(bounce > 0)) break;
      }
      if (!enclosed) (pair.half_space ? wall_hits : hits).push_back(count);
    }
    const double share = std::max(0.0, 1 - meeting.together / t);
    if (!(share > 0)) continue;
    touching.push_back(share);
    gaps.push_back(share * gap_cost(a, b));
    if (meeting.pressed || (pair.max_restitution == 0 && meeting.speed > 0))
      contacts.push_back(share * points_of_pair(a, b));
    if (!meeting.pressed) unpressed.push_back(share);
  }
  run.wall_hits += sorted_sum(std::move(wall_hits));
  run.hits += sorted_sum(std::move(hits)) + (enclosed ? 0.0 : run.wall_hits);
  run.touching = sorted_sum(std::move(touching));
  run.contacts = sorted_sum(std::move(contacts));
  run.gaps = sorted_sum(std::move(gaps));
  run.unpressed = sorted_sum(std::move(unpressed));
}

/// Substeps of rotation with the gyroscopic term, as its stage takes them: at least one for each
/// rotating body with unequal moments, more for a fast one.
CONTACT_SCENES_INLINE double expected_gyroscopic_substeps(const PlanInput& q, double substeps) {
  std::vector<double> gyroscopic_substeps;
  for (std::size_t i = 0; i < q.scene->bodies.size(); ++i) {
    const SceneBody& body = q.scene->bodies[i];
    if (!body.moves) continue;
    const MomentRange moments = moment_range(body.inertia);
    if (!(moments.max > moments.min)) continue;
    if (body.angular_velocity.isZero(0) && !q.bounds.bodies[i].disturbed) continue;
    const PrincipalAxes<double> principal = principal_axes<double>(body.inertia);
    const Vector3<double> seen =
        (matrix_of(body.orientation) * principal.rotation).transpose() * body.angular_velocity;
    const double ratio = moments.max / moments.min;
    const double fastest = std::sqrt(contact::largest_free_square(principal.moments, seen) * ratio);
    gyroscopic_substeps.push_back(
        std::max(substeps, fastest * q.scene->duration / gyroscopic_angle));
  }
  return sorted_sum(std::move(gyroscopic_substeps));
}

}  // namespace detail

CONTACT_SCENES_INLINE ExpectedRun expected_run(const PlanInput& q, double h, double spring_substep,
                                               bool sleeps) {
  const Scene& scene = *q.scene;
  const double t = scene.duration;
  ExpectedRun run;
  run.movers = static_cast<double>(q.bounds.movers);
  for (const SceneBody& body : scene.bodies) (is_half_space(body) ? run.walls : run.bounded) += 1;
  run.steps = std::ceil(t / h * (1 - 0x1p-40));
  const bool crowd = q.bounds.movers > max_one_by_one;
  run.substeps = run.steps;
  if (pairs_that_may_meet(q.bounds) == 0) {
    run.gyroscopic_substeps = detail::expected_gyroscopic_substeps(q, run.substeps);
    return run;
  }
  const detail::Room room = detail::room_of(scene);
  const bool enclosed = run.walls > 1 && detail::is_enclosed(q, room) &&
                        detail::mean_square_speed(q, room) > 0 && !q.bounds.crowded;
  if (enclosed || q.bounds.crowded) detail::expect_gas(q, room, run);
  std::vector<bool> lies;
  if (!q.bounds.crowded) {
    lies = detail::lying_bodies(q);
    detail::expect_pairs(q, lies, enclosed, run);
  } else if (gravity_felt(q) > 0 && !is_proven(resting_proofs(q)[2])) {
    run.heap = true;
    run.hits = 3 * run.movers;
    run.touching = run.contacts = 3 * run.movers * detail::share_in_heap(q, room);
    const bool round = q.pairs.front().round;
    run.gaps = run.touching * (round ? cost::sphere_gap : cost::corner_gap);
    if (!round) run.contacts *= 4;
  }
  run.search = pair_search_cost(detail::first_boxes(scene, h));
  for (const PairBound& pair : q.pairs)
    run.impact =
        std::max(run.impact, detail::impact_cost(scene.bodies[pair.a], scene.bodies[pair.b]));
  if (crowd) run.substeps = run.steps * crowd_substeps;
  // An impact divides twice: a substep ends where it is found, and one of length zero solves it.
  else
    run.substeps += std::min(2 * run.hits, 2.0 * run.steps * max_impacts(q.bounds.movers, false));
  const double swing = detail::fastest_spring(q);
  if (spring_substep > 0 && swing > 0) {
    double closing = 0;
    for (const PairBound& pair : q.pairs) closing = std::max(closing, pair.soft ? pair.closing : 0);
    const double half = 3.141592653589793 / swing;
    const double flight = gravity_felt(q) > 0 ? 2 * closing / q.bounds.gravity : t;
    run.spring_substeps = t / (half + flight) * half / spring_substep;
    run.substeps += run.spring_substeps;
  }
  if (sleeps && !lies.empty() && detail::begins_at_rest(q, lies))
    run.awake = std::min(1.0, (sleep_after + 2 * h) / t);
  run.gyroscopic_substeps = detail::expected_gyroscopic_substeps(q, run.substeps * run.awake);
  return run;
}

}  // namespace contact
