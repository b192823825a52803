/// @file
/// The interface of a simulation of a scene, whatever it is composed of, in terms of the scene's
/// bodies.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <contact/quaternion.hpp>
#include <contact/scene/scene.hpp>
#include <contact/vector.hpp>

namespace contact {

/// How a run ended.
enum class SceneRunEnd {
  reached,        ///< the time that was asked for
  out_of_budget,  ///< of hits, from event to event, or of steps; the run can go on
  stopped,        ///< the observer asked to stop; the run can go on
  endless_hits    ///< infinitely many hits at one instant, and no stepped run can take over
};

/// A stage of which a run is composed; it has only those that it needs.
struct SceneStage {
  std::string name;    ///< "gravity", "broad phase", "friction", ...
  std::string detail;  ///< how it is done, one phrase: "cells", "5 iterations at most"
};

/// What happens in a run step by step that a plan cannot foresee, and that says which errors it may
/// have from then on.
enum class RunDoubt {
  contact,     ///< a contact carries a force: until then all bodies fly freely
  hit,         ///< an impact, which may amplify rounding errors
  rest,        ///< a bounce is left out, or a body that moves a little falls asleep
  spring,      ///< a compliant contact pushes
  varying,     ///< a contact force varies within a substep: on a curved surface, or on a body with
               ///< vertices that rotates. A substep has constant forces
  late_event,  ///< an event of a contact falls inside a substep
  crowd,       ///< impacts that reach a body at the same instant are taken at once
  unsettled    ///< a solver ends before its contacts are solved
};
/// The number of different doubts.
inline constexpr std::size_t run_doubts = 8;

/// Since when each doubt exists, s; ∞: it does not.
class RunDoubts {
 public:
  RunDoubts() { since_.fill(std::numeric_limits<double>::infinity()); }
  /// Since when.
  double since(RunDoubt doubt) const { return since_[static_cast<std::size_t>(doubt)]; }
  /// Records that it exists at a time; the earliest one counts.
  void add(RunDoubt doubt, double time) {
    double& since = since_[static_cast<std::size_t>(doubt)];
    since = std::min(since, time);
  }
  /// Adds those of a run that began at a time.
  void add(const RunDoubts& later, double began) {
    for (std::size_t i = 0; i < run_doubts; ++i)
      since_[i] = std::min(since_[i], began + later.since_[i]);
  }
  /// Of each doubt in its order, s.
  const std::array<double, run_doubts>& times() const { return since_; }

 private:
  std::array<double, run_doubts> since_;
};

/// What a run has done so far. Counts that a kind of run does not have stay 0.
struct SceneRunCounts {
  std::uint64_t steps = 0;          ///< of time
  std::uint64_t substeps = 0;       ///< substeps, into which impacts and springs divide them
  std::uint64_t hits = 0;           ///< impacts: pairs that met faster than the speed of rest
  std::uint64_t pairs = 0;          ///< tested by the narrow phase
  std::uint64_t contacts = 0;       ///< points that were solved, over all substeps
  std::uint64_t iterations = 0;     ///< of the solver
  std::uint64_t crossings = 0;      ///< from event to event: from cell to cell
  std::uint64_t rests = 0;          ///< how often a body came to rest, or fell asleep
  std::uint64_t crowded_steps = 0;  ///< with more impacts than are taken one by one
  std::uint64_t max_impacts = 0;    ///< of a step, that are taken one by one; 0: not limited
  double largest_overlap = 0;       ///< of hard bodies, m
  RunDoubts doubts;                 ///< of steps: which errors the run may have, and since when
  double rest_error = 0;            ///< largest displacement of paths by coming to rest, m
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

/// Receives each hit.
class SceneObserver {
 public:
  SceneObserver() = default;
  SceneObserver(const SceneObserver&) = delete;
  SceneObserver& operator=(const SceneObserver&) = delete;
  virtual ~SceneObserver() = default;
  /// @return whether to go on
  virtual bool on_hit(const SceneHit& hit) = 0;
};

/// When and why an event-driven run went on step by step.
struct SceneFallback {
  double time = 0;  ///< s; since when
  std::string why;  ///< one sentence
};

// [scene-checkpoint]
/// The complete state, from which a run goes on with the same bits. The run defines what the
/// numbers mean.
struct SceneCheckpoint {
  std::string kind;                       ///< "event-driven" or "stepped"
  double now = 0;                         ///< s
  SceneRunCounts counts;                  ///< so far
  std::vector<double> numbers;            ///< every number of the state, in the run's order
  std::vector<std::int64_t> integers;     ///< every whole number of the state, in the run's order
  std::optional<SceneFallback> fallback;  ///< if it had fallen back to steps
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

  /// Whether it is event-driven, now.
  virtual bool event_driven() const = 0;
  /// Step size, s; 0 from event to event.
  virtual double step() const = 0;
  /// The stages of which it is composed, in their order.
  virtual std::vector<SceneStage> stages() const = 0;
  /// When and why it fell back to steps, if it did.
  virtual std::optional<SceneFallback> fallback() const { return std::nullopt; }

  /// Simulates until a time. Stopping on the way changes no bit of the later result.
  /// @param until s; nothing happens if it is past
  /// @param budget of hits from event to event, of steps otherwise
  /// @param observer receives each hit, or null. A step's hits are reported when the whole step is
  /// done
  virtual SceneRunEnd advance(double until, std::uint64_t budget, SceneObserver* observer) = 0;
  /// The same without a limit and without an observer.
  SceneRunEnd advance(double until) {
    return advance(until, std::numeric_limits<std::uint64_t>::max(), nullptr);
  }

  /// Reports the hits of the present, unfinished step until now, which advance() has not reported.
  /// A run that goes on from here reports them again.
  virtual void report_unfinished(SceneObserver& /*observer*/) const {}

  /// The time that was reached, s.
  virtual double now() const = 0;
  /// Position of a body's origin now, m.
  virtual Vector3<double> position(std::size_t body) const = 0;
  /// Orientation of a body now; the initial one if the run keeps no orientations.
  virtual Quaternion<double> orientation(std::size_t body) const = 0;
  /// Velocity of a body now, m/s.
  virtual Vector3<double> velocity(std::size_t body) const = 0;
  /// Angular velocity of a body now, rad/s; the initial one if the run keeps none.
  virtual Vector3<double> angular_velocity(std::size_t body) const = 0;
  /// ½ m v² + ½ ω · I ω − m g · x of all moving bodies, J, by recursive summation.
  virtual double energy() const = 0;
  /// What it has done so far.
  virtual SceneRunCounts counts() const = 0;
  /// Bytes that it holds.
  virtual std::size_t bytes() const = 0;
  /// Bytes of one moving body's state: of the effects that are on.
  virtual std::size_t bytes_per_body() const = 0;
  /// The present state.
  virtual SceneCheckpoint checkpoint() const = 0;
  /// Restores a state of the same scene and plan, earlier or later.
  /// @throws std::invalid_argument if it is of another kind or size
  virtual void restore(const SceneCheckpoint& from) = 0;
};
// [/scene-run]

namespace detail {

/// ½ m v² + ½ ω · I ω − m g · x of all moving bodies, by recursive summation.
double energy_of_run(const Scene& scene, const SceneRun& run);

}  // namespace detail

}  // namespace contact

#ifndef CONTACT_SCENES_COMPILED
#include "../../src/scene_run.cpp"
#endif
