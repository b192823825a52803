#pragma once

// What a task of a job array left in its log: its worker's events, a line of JSON each, and
// whatever else was said.

#include <filesystem>
#include <map>
#include <string>

#include "engine.hpp"

namespace contact::grading {

/// What a worker said about a unit that it could not grade.
struct SlurmTrouble {
  std::string what;
  bool out_of_time = false;
};

/// The units that a worker could not grade.
std::map<Job, SlurmTrouble> troubles_in(const std::filesystem::path& log);

/// The last that was said besides events; of a long line its end.
std::string last_words(const std::filesystem::path& log);

}  // namespace contact::grading
