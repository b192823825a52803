#pragma once

// The common part of the programs: parse, run the command, turn an error into a message and an exit
// code.

#include <vector>

#include "commands.hpp"

namespace contact::cli {

/// The book's version, as CMakeLists.txt has it.
const char* program_version();

/// Runs the command that is asked for, and returns the exit code.
/// @param commands those of this program, in the order of its help
int run_program(int argc, char** argv, const std::vector<void (*)(Command, Action&)>& commands);

}  // namespace contact::cli
