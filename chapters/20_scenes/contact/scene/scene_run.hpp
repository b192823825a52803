/// @file
/// A simulation of a scene as its user sees it, whatever it is composed of: asked in terms of the
/// scene's bodies.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <contact/rotation.hpp>
#include <contact/scene/scene.hpp>
#include <contact/vector.hpp>

namespace contact {

/// How an advance of a scene ended.
enum class SceneRunEnd {
  reached,        ///< the time that was asked for
  out_of_budget,  ///< of hits, from event to event, or of steps; the run can go on
  stopped,        ///< the observer said so; the run can go on
  endless_hits    ///< hits pile up without time going on, and no stepped run can take over
};

/// A stage of which a run is composed: there is none that it does not need.
struct SceneStage {
  std::string name;    ///< "gravity", "broad phase", "friction", ...
  std::string detail;  ///< how it is done, one phrase: "cells", "5 iterations at most"
};

/// What a run has done so far. What a kind of run does not have stays 0.
struct SceneRunCounts {
  std::uint64_t steps = 0;          ///< of time
  std::uint64_t parts = 0;          ///< into which impacts and springs cut them
  std::uint64_t hits = 0;           ///< impacts: pairs that met faster than they rest
  std::uint64_t pairs = 0;          ///< that the narrow phase looked at
  std::uint64_t contacts = 0;       ///< points that were solved, over all parts of steps
  std::uint64_t sweeps = 0;         ///< of the solver
  std::uint64_t crossings = 0;      ///< from event to event: from cell to cell
  std::uint64_t rests = 0;          ///< how often a body lay down, or fell asleep
  std::uint64_t crowded_steps = 0;  ///< with more impacts than are taken one by one
  std::uint64_t most_impacts = 0;   ///< of a step, that are taken one by one; 0: there is no such
  double largest_overlap = 0;       ///< of hard bodies, m
  double rest_error = 0;            ///< how far lying down has put paths off at most, m
  std::size_t endless_first = 0;    ///< after endless_hits, or a fallback: index of a body, ...
  std::size_t endless_second = 0;   ///< ... and of the one that it hits again and again
};

/// A hit, just after it.
struct SceneHit {
  double time = 0;                                    ///< s
  std::size_t first = 0;                              ///< index into Scene::bodies
  std::size_t second = 0;                             ///< the same of the other
  Vector3<double> point = Vector3<double>::Zero();    ///< where they touch, m
  Vector3<double> impulse = Vector3<double>::Zero();  ///< on the first, N·s
};

/// Is told of each hit.
class SceneObserver {
 public:
  SceneObserver() = default;
  SceneObserver(const SceneObserver&) = delete;
  SceneObserver& operator=(const SceneObserver&) = delete;
  virtual ~SceneObserver() = default;
  /// @return whether to go on
  virtual bool on_hit(const SceneHit& hit) = 0;
};

/// That a run from event to event went on step by step, and why.
struct SceneFallback {
  double time = 0;  ///< s; from when on
  std::string why;  ///< one sentence
};

// [scene-checkpoint]
/// All that a run needs to go on with the same bits. What the numbers mean is the run's business.
struct SceneCheckpoint {
  std::string kind;                       ///< "event-driven" or "stepped"
  double now = 0;                         ///< s
  SceneRunCounts counts;                  ///< so far
  std::vector<double> numbers;            ///< every number of the state, in the run's order
  std::vector<std::int64_t> integers;     ///< every whole number of the state, in the run's order
  std::optional<SceneFallback> fallback;  ///< if it had gone over to stepping
};
// [/scene-checkpoint]

// [scene-run]
/// A simulation of a scene. Bodies are named by their index in Scene::bodies.
class SceneRun {
 public:
  SceneRun() = default;
  SceneRun(const SceneRun&) = delete;
  SceneRun& operator=(const SceneRun&) = delete;
  virtual ~SceneRun() = default;

  /// Whether it goes from event to event, now.
  virtual bool event_driven() const = 0;
  /// s between two looks; 0 from event to event.
  virtual double step() const = 0;
  /// Of what it is composed, in the order in which it is done.
  virtual std::vector<SceneStage> stages() const = 0;
  /// When and why it went over to stepping, if it did.
  virtual std::optional<SceneFallback> fallback() const { return std::nullopt; }

  /// Simulates until a time. Where a caller stops on the way changes no bit of what comes later.
  /// @param until s; nothing happens if it is past
  /// @param budget of hits from event to event, of steps otherwise
  /// @param observer told of each hit, or null. A step's hits are told when the whole step is done
  virtual SceneRunEnd advance(double until, std::uint64_t budget, SceneObserver* observer) = 0;
  /// The same without a limit, and nobody is told.
  SceneRunEnd advance(double until) {
    return advance(until, std::numeric_limits<std::uint64_t>::max(), nullptr);
  }

  /// Tells the hits of a step that is not done: of those until now, the ones that advance() has
  /// not told. A run that goes on from here tells them once more.
  virtual void tell_unfinished(SceneObserver& /*observer*/) const {}

  /// The time that was reached, s.
  virtual double now() const = 0;
  /// Where a body's origin is now, m.
  virtual Vector3<double> position(std::size_t body) const = 0;
  /// How a body lies now; as at first if the run knows no orientations.
  virtual Rotor<double> orientation(std::size_t body) const = 0;
  /// How a body moves now, m/s.
  virtual Vector3<double> velocity(std::size_t body) const = 0;
  /// How a body turns now, rad/s; as at first if the run knows no spins.
  virtual Vector3<double> spin(std::size_t body) const = 0;
  /// ½ m v² + ½ ω · I ω − m g · x of all that moves, J, in order.
  virtual double energy() const = 0;
  /// What it has done so far.
  virtual SceneRunCounts counts() const = 0;
  /// Bytes that it holds.
  virtual std::size_t bytes() const = 0;
  /// Bytes of one moving body's state: of the effects that are on.
  virtual std::size_t bytes_per_body() const = 0;
  /// The present state.
  virtual SceneCheckpoint checkpoint() const = 0;
  /// Goes back, or on, to a state of the same scene and plan.
  /// @throws std::invalid_argument if it is of another kind or size
  virtual void restore(const SceneCheckpoint& from) = 0;
};
// [/scene-run]

namespace detail {

/// ½ m v² + ½ ω · I ω − m g · x of all that moves, in order.
double energy_of_run(const Scene& scene, const SceneRun& run);

}  // namespace detail

}  // namespace contact

#ifndef CONTACT_SCENES_COMPILED
#include "../../src/scene_run.cpp"
#endif
