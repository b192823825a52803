#pragma once

// The first step of grading a unit: a stranger's file, compiled and linked in a box.

#include <filesystem>
#include <string_view>

#include "unit.hpp"

namespace contact::grading {

struct CompiledUnit {
  Explained said;
  /// Empty if it does not compile.
  std::filesystem::path program;
  Seconds seconds;
  /// It came so near a limit, or ended in such a way, that it must be run again alone.
  bool near_limit = false;
};

/// Compiles `file`, known by a relative path, in `folder`, and links it with the server of the
/// exercise's contract. What the compiler says is explained in a box of its own.
/// @param text what the file holds
CompiledUnit compile_unit(Loop& loop, const Book& book, const BuildDescription& build,
                          const Machine& machine, const Seat& seat, const Exercise& exercise,
                          const std::filesystem::path& file, std::string_view text,
                          const std::filesystem::path& folder, const GradeLimits& limits);

}  // namespace contact::grading
