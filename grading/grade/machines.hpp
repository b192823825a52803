#pragma once

// The machines that graded a part of a run: on a cluster, each worker leaves a file of its own.

#include <nlohmann/json.hpp>

#include "run_state.hpp"

namespace contact::grading {

/// What the weakest of them enforces, for the results: {"level", "measures"}.
/// @param here the coordinator's own
nlohmann::json weakest_machine(const Machine& here, const RunFolder& folder);

}  // namespace contact::grading
