#pragma once

// One scene of contact simulate: run to its end, with its output, and its report.

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <contact/plan/plan_types.hpp>
#include <contact/scene/scene.hpp>

#include "../exit_codes.hpp"
#include "../terminal/progress_line.hpp"
#include "plan_options.hpp"

namespace contact::cli {

/// The options of contact simulate.
struct SimulateOptions {
  std::vector<std::string> scenes;
  std::string output;
  std::string events;
  std::string checkpoint;
  std::string resume;
  scenes::PlanWords plan;
  std::string until;
  std::string every;
  std::uint64_t max_events = std::numeric_limits<std::uint64_t>::max();
  std::uint64_t event_budget = std::numeric_limits<std::uint64_t>::max();
  int jobs = 0;  // scenes at a time; 0: one a core
  bool expect = false;
  bool strict = false;
  bool json = false;
};

/// The report of a run that has ended.
struct SimulateOutcome {
  int code = exit_passed;
  std::string said;   // lines for standard output
  std::string noted;  // lines for standard error
  nlohmann::json json;

  void say(const std::string& line) { said += line + "\n"; }
  void note(const std::string& line) { noted += line + "\n"; }
};

/// A scene that is read, and its plan.
struct Planned {
  Scene scene;
  Plan plan;
};

/// Set by a signal: every simulation stops at its present time.
extern std::atomic<bool> simulate_interruption;

/// Runs a scene as its plan decides.
/// @param progress where to report how far it is
/// @param piece which of that line's pieces this scene is
/// @throws std::runtime_error if a file cannot be written, or a checkpoint belongs to something
/// else
SimulateOutcome simulated(const SimulateOptions& options, Planned planned, ProgressLine& progress,
                          std::size_t piece);

}  // namespace contact::cli
