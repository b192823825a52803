#pragma once

// What contact simulate says of a run that is over.

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <contact/scene/scene.hpp>
#include <contact/scene/scene_run.hpp>

#include "simulation.hpp"

namespace contact::cli {

enum class Ending { complete, out_of_events, endless_hits, interrupted };

/// What a scene's file expects, and what the run gave.
struct Checked {
  const SceneExpectation* wanted;
  std::optional<double> got;  // nothing: its time was before the run was resumed, or never came

  [[nodiscard]] bool met() const { return got && std::abs(*got - wanted->value) <= wanted->within; }
};

/// How a simulation ended, and what it found.
struct SimulationEnd {
  const SimulateOptions& options;
  const Scene& scene;
  const SceneRun& run;
  const std::vector<Checked>& checked;
  Ending ending;
  std::string way;  // how it goes if it does not go step by step
  double until;
  double first_energy;
  std::uint64_t frames;
  double seconds;  // on the clock
};

/// As lines, or as JSON if that was asked for; the exit code is left to the caller.
SimulateOutcome reported(const SimulationEnd& end);

}  // namespace contact::cli
