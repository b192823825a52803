#pragma once

#include <string>
#include <vector>

#include "progress_record.hpp"

namespace contact::grading {

/// Two records of one reader as one, by the rules in cli/README.md: nothing done is forgotten, and
/// merging twice changes nothing more. `theirs` may come from a stranger: values of a wrong type
/// and keys that name no exercise are passed over.
ProgressRecord merged(const ProgressRecord& ours, const ProgressRecord& theirs);

/// The exercises whose entries differ.
std::vector<std::string> changed_entries(const ProgressRecord& before, const ProgressRecord& after);

}  // namespace contact::grading
