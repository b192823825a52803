#pragma once

// What the programs have in common: parse, run the command, turn what went wrong into a sentence
// and an exit code.

#include <vector>

#include "commands.hpp"

namespace contact::cli {

/// The book's version, as CMakeLists.txt has it.
const char* program_version();

/// Runs the command that is asked for, and returns the exit code.
/// @param commands those of this program, in the order of its help
int run_program(int argc, char** argv, const std::vector<void (*)(Command, Action&)>& commands);

}  // namespace contact::cli
