#pragma once

// The report of contact simulate on a run that has ended.

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <contact/scene/kept_tolerance.hpp>
#include <contact/scene/scene.hpp>
#include <contact/scene/scene_run.hpp>

#include "simulation.hpp"

namespace contact::cli {

enum class Ending { complete, out_of_events, endless_hits, interrupted };

/// An expectation of a scene's file, and the result of the run.
struct Checked {
  const SceneExpectation* wanted;
  std::optional<double> got;  // empty: its time was before the run was resumed, or was not reached

  [[nodiscard]] bool met() const { return got && std::abs(*got - wanted->value) <= wanted->within; }
};

/// How a simulation ended, and its results.
struct SimulationEnd {
  const SimulateOptions& options;
  const Scene& scene;
  const SceneRun& run;
  const std::vector<Checked>& checked;
  Ending ending;
  std::string way;     // how it runs if not step by step
  KeptTolerance kept;  // until when its positions are within the tolerance
  double until;
  double first_energy;
  std::uint64_t frames;
  double seconds;  // on the clock
};

/// As lines, or as JSON if requested; the exit code is left to the caller.
SimulateOutcome reported(const SimulationEnd& end);

}  // namespace contact::cli
