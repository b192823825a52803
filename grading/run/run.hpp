#pragma once

// One check from a source file to a verdict: compile, link, run. `contact check`, `watch` and `dev
// check` all come here.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "../build/build.hpp"
#include "../process/run_process.hpp"
#include "../progress/progress_record.hpp"
#include "../verdict/verdict.hpp"

namespace contact::grading {

struct Limits {
  /// Megabytes of address space: CONTACT_MEMORY_MB, else 1024.
  int memory_mb = 1024;
  /// Bytes that a student's program may print before it is stopped.
  std::size_t output_bytes = 1u << 20;
};

/// @throws BookError if CONTACT_MEMORY_MB is not a number of megabytes.
Limits limits_from_environment();

/// Variables that a program is given on top of the environment.
using Environment = std::vector<std::pair<std::string, std::string>>;

/// Runs every test of a linked program. A test that crashes or never ends costs itself only: the
/// rest run in a new process.
std::vector<TestResult> run_tests(Loop& loop, const Exercise& exercise,
                                  const std::filesystem::path& program, const Limits& limits,
                                  const Environment& environment, std::string& output);

/// Compiles, links and runs `source` as an answer to `exercise`. If its first failing test has
/// failed before with other code, as `before` says, it has a closer look at that test.
Verdict check_file(Loop& loop, const Book& book, const BuildDescription& build,
                   const Exercise& exercise, const std::filesystem::path& source,
                   const Limits& limits, const ProgressRecord& before);

/// The same for each of these environments in turn: compiled once, run and judged in each.
std::vector<Verdict> check_file_in_each(Loop& loop, const Book& book, const BuildDescription& build,
                                        const Exercise& exercise,
                                        const std::filesystem::path& source, const Limits& limits,
                                        const std::vector<std::string>& more_include,
                                        const std::vector<Environment>& environments);

}  // namespace contact::grading
