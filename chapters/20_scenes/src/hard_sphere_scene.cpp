#include <contact/events/hard_sphere_scene.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <contact/events/hard_sphere_run.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/scene/compiled.hpp>
#include <contact/scene/scene.hpp>
#include <contact/scene/scene_run.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace detail {

CONTACT_SCENES_INLINE std::string body_text(const Scene& scene, std::size_t body) {
  return "bodies[" + std::to_string(body) + "] (" + scene.bodies[body].name + ")";
}

/// Bodies that represent every kind of contact of a scene: of each material the first two that move
/// and the first that is fixed.
CONTACT_SCENES_INLINE std::vector<std::size_t> one_of_each(const Scene& scene) {
  std::vector<std::size_t> moving(scene.materials.size(), 0);
  std::vector<std::size_t> standing(scene.materials.size(), 0);
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const SceneBody& body = scene.bodies[i];
    const std::size_t seen = (body.moves ? moving : standing)[body.material]++;
    if (seen < (body.moves ? 2u : 1u)) chosen.push_back(i);
  }
  return chosen;
}

}  // namespace detail

// [refusal]
CONTACT_SCENES_INLINE std::optional<std::string> hard_sphere_refusal(const Scene& scene) {
  bool moves = false;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const SceneBody& body = scene.bodies[i];
    const bool ball = std::holds_alternative<BallShape>(body.shape);
    if (!ball && !std::holds_alternative<HalfSpaceShape>(body.shape))
      return detail::body_text(scene, i) + " is neither a ball nor a half-space";
    moves = moves || (ball && body.moves);
  }
  if (!moves) return "no ball moves";
  const std::vector<std::size_t> bodies = detail::one_of_each(scene);
  for (const std::size_t i : bodies) {
    for (const std::size_t k : bodies) {
      if (k <= i) continue;
      if (!scene.bodies[i].moves && !scene.bodies[k].moves) continue;
      const PairMaterial pair = pair_material(scene.materials[scene.bodies[i].material],
                                              scene.materials[scene.bodies[k].material]);
      const std::string both = detail::body_text(scene, i) + " and " + detail::body_text(scene, k);
      if (pair.friction > 0)
        return both + " have friction: their coefficient is " + number_text(pair.friction);
      if (pair.stiffness)
        return both + " are compliant: their stiffness is " + number_text(*pair.stiffness) + " N/m";
    }
  }
  return std::nullopt;
}
// [/refusal]

CONTACT_SCENES_INLINE HardSphereScene hard_sphere_setup(const Scene& scene) {
  if (const auto refusal = hard_sphere_refusal(scene))
    throw_invalid_argument("scene", scene.name, *refusal);
  HardSphereScene made;
  made.setup.gravity = scene.gravity;
  for (const bool moving : {true, false}) {
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      const SceneBody& body = scene.bodies[i];
      const auto* ball = std::get_if<BallShape>(&body.shape);
      if (ball == nullptr || body.moves != moving) continue;
      made.setup.balls.push_back(
          {body.position, body.velocity, ball->radius, body.mass, body.material, moving});
      made.ball_body.push_back(i);
    }
  }
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    if (const auto* wall = std::get_if<HalfSpaceShape>(&scene.bodies[i].shape)) {
      made.setup.walls.push_back({wall->normal, wall->offset, scene.bodies[i].material});
      made.wall_body.push_back(i);
    }
  }
  made.setup.restitution.clear();
  bool elastic = true;
  for (const SceneMaterial& a : scene.materials) {
    for (const SceneMaterial& b : scene.materials) {
      made.setup.restitution.push_back(pair_material(a, b).restitution);
      elastic = elastic && made.setup.restitution.back() == 1;
    }
  }
  if (elastic) made.setup.cutoff = 0x1p-30;
  return made;
}

// [hard-sphere-scene-run]
CONTACT_SCENES_INLINE HardSphereSceneRun::HardSphereSceneRun(const Scene& scene,
                                                             ComposeHardSpheres compose,
                                                             double cutoff)
    : scene_(scene), balls_(hard_sphere_setup(scene)) {
  if (cutoff > 0) balls_.setup.cutoff = cutoff;
  run_ = compose(balls_.setup);
  ball_of_.assign(scene.bodies.size(), no_ball);
  for (std::size_t i = 0; i < balls_.ball_body.size(); ++i) ball_of_[balls_.ball_body[i]] = i;
}

CONTACT_SCENES_INLINE std::vector<SceneStage> HardSphereSceneRun::stages() const {
  const HardSphereEffects& on = run_->effects();
  std::vector<SceneStage> stages;
  stages.push_back({"flight", std::to_string(on.dimension) +
                                  (on.dimension == 1 ? " coordinate" : " coordinates") +
                                  (on.gravity ? ", parabolas" : ", straight lines")});
  if (on.gravity) stages.push_back({"gravity", "exact, with rest on walls"});
  if (on.grid) stages.push_back({"broad phase", "cells"});
  stages.push_back({"event queue", "the earliest hit first"});
  stages.push_back({"impulse", on.sizes ? "by mass and radius" : "of equal balls"});
  if (on.restitution) stages.push_back({"restitution", "of each pair of materials"});
  return stages;
}

CONTACT_SCENES_INLINE SceneRunEnd HardSphereSceneRun::advance(double until, std::uint64_t budget,
                                                              SceneObserver* observer) {
  HitForwarder teller(*this, observer);
  switch (run_->advance(until, budget, observer == nullptr ? nullptr : &teller)) {
    case HardSphereEnd::reached:
      return SceneRunEnd::reached;
    case HardSphereEnd::out_of_events:
      return SceneRunEnd::out_of_budget;
    case HardSphereEnd::stopped:
      return SceneRunEnd::stopped;
    default:
      return SceneRunEnd::endless_hits;
  }
}

CONTACT_SCENES_INLINE SceneRunCounts HardSphereSceneRun::counts() const {
  const HardSphereCounts of = run_->counts();
  SceneRunCounts counts;
  counts.hits = of.hits;
  counts.crossings = of.crossings;
  counts.rests = of.rests;
  counts.largest_overlap = of.largest_overlap;
  counts.rest_error = of.rest_error;
  if (of.endless_partner >= 0) {
    counts.endless_first = balls_.ball_body[of.endless_ball];
    counts.endless_second = body_of(static_cast<std::size_t>(of.endless_partner));
  }
  return counts;
}

CONTACT_SCENES_INLINE SceneCheckpoint HardSphereSceneRun::checkpoint() const {
  const HardSphereCheckpoint from = run_->checkpoint();
  SceneCheckpoint to;
  to.kind = "event-driven";
  to.now = from.now;
  to.counts = counts();
  to.integers = {static_cast<std::int64_t>(from.simultaneous),
                 static_cast<std::int64_t>(from.counts.stale)};
  for (const HardSphereCheckpoint::Ball& ball : from.balls) {
    for (int k = 0; k < 3; ++k) to.numbers.push_back(ball.position(k));
    for (int k = 0; k < 3; ++k) to.numbers.push_back(ball.velocity(k));
    to.numbers.push_back(ball.time);
    to.integers.insert(to.integers.end(), {ball.last, ball.rests_on, ball.short_flights});
  }
  return to;
}

CONTACT_SCENES_INLINE void HardSphereSceneRun::restore(const SceneCheckpoint& from) {
  const std::size_t balls = balls_.ball_body.size();
  if (from.kind != "event-driven" || from.numbers.size() != 7 * balls ||
      from.integers.size() != 3 * balls + 2) {
    throw_invalid_argument("from", "a checkpoint of kind " + from.kind,
                           "must be one of this run from event to event");
  }
  HardSphereCheckpoint to;
  to.now = from.now;
  to.simultaneous = static_cast<std::uint64_t>(from.integers[0]);
  to.counts.stale = static_cast<std::uint64_t>(from.integers[1]);
  to.counts.hits = from.counts.hits;
  to.counts.crossings = from.counts.crossings;
  to.counts.rests = from.counts.rests;
  to.counts.largest_overlap = from.counts.largest_overlap;
  to.counts.rest_error = from.counts.rest_error;
  for (std::size_t i = 0; i < balls; ++i) {
    HardSphereCheckpoint::Ball ball;
    for (int k = 0; k < 3; ++k) {
      const auto at = 7 * i + static_cast<std::size_t>(k);
      ball.position(k) = from.numbers[at];
      ball.velocity(k) = from.numbers[at + 3];
    }
    ball.time = from.numbers[7 * i + 6];
    ball.last = static_cast<std::int32_t>(from.integers[3 * i + 2]);
    ball.rests_on = static_cast<std::int32_t>(from.integers[3 * i + 3]);
    ball.short_flights = static_cast<std::int32_t>(from.integers[3 * i + 4]);
    to.balls.push_back(ball);
  }
  run_->restore(to);
}

CONTACT_SCENES_INLINE Vector3<double> HardSphereSceneRun::touching_point(
    const HardSphereHit& hit) const {
  const std::size_t count = balls_.ball_body.size();
  const Vector3<double> centre = run_->position(hit.ball);
  const double radius = balls_.setup.balls[hit.ball].radius;
  if (hit.partner >= count) return centre - balls_.setup.walls[hit.partner - count].normal * radius;
  const double other = balls_.setup.balls[hit.partner].radius;
  return centre + (run_->position(hit.partner) - centre) * (radius / (radius + other));
}
// [/hard-sphere-scene-run]

}  // namespace contact
