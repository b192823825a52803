#pragma once

// What is taken in of each submission, kept in the run's folder for the workers.

#include <vector>

#include "regrade.hpp"
#include "results.hpp"

namespace contact::grading {

/// Writes the texts of one entrant below RESULTS/.grade/submissions, and notes in `all` where each
/// exercise stands and the SHA-256 of what is to be graded. A text that is replaced by another was
/// handed in before, so it is kept in `earlier`.
void keep_texts(const Entrant& entrant, const std::vector<const Exercise*>& exercises,
                const RunFolder& folder, Earlier& earlier, Class& all);

}  // namespace contact::grading
