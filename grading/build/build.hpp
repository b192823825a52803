#pragma once

// From a student's file to a program that runs an exercise's tests: one compile with the
// precompiled prelude, one link with the tests that were compiled before. Neither CMake nor Ninja
// is started for it.

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "../book/book.hpp"
#include "../diagnosis/diagnosis.hpp"
#include "../process/run_process.hpp"
#include "../verdict/verdict.hpp"

namespace contact::grading {

/// build/dev/exercises.json: what CMake knows and a check needs.
struct BuildDescription {
  std::string compiler;
  std::vector<std::string> compile_flags;
  std::vector<std::string> include;
  /// The header whose precompiled form is in the same folder; empty if there is none.
  std::string pch;
  std::vector<std::string> link_flags;
  /// Of a program that answers from a box, where no library can be loaded.
  std::vector<std::string> server_link_flags;
  std::vector<std::string> support_libs;
  /// The objects that a test program is linked from besides its tests and a proxy.
  std::vector<std::string> asks_objects;
  struct Bundle {
    std::string tests;   ///< one object that holds the tests, the asking, Catch2 and main
    std::string target;  ///< what CMake calls it
    std::vector<std::string> include;
    std::string
        server;        ///< one object: main, and the far side of every call, to link an answer with
    std::string asks;  ///< the tests as a program that asks a server
    std::string proxy;  ///< the contract, asking a submission in another process
  };
  std::map<std::string, Bundle> exercises;
};

/// @throws BookError if the file is missing or not understood.
BuildDescription read_build_description(const std::filesystem::path& build_dir);

/// Whether the compiled tests of an exercise are older than their sources. Costs a few dozen stat
/// calls.
bool tests_are_stale(const Book& book, const BuildDescription& build, const Exercise& exercise);

/// Builds CMake targets, one build at a time with whatever else builds here (they share
/// build/lock).
/// @throws BookError with the end of what the build printed.
void build_target(Loop& loop, const Book& book, const std::vector<std::string>& targets);

/// Builds the compiled tests of these exercises through CMake and says so on standard error.
/// @throws BookError with the end of what the build printed.
void build_tests(Loop& loop, const Book& book, const std::vector<const Exercise*>& exercises);

/// Brings the compiled tests up to date if they are stale, and returns a description that knows
/// them.
BuildDescription ready_build(Loop& loop, const Book& book,
                             const std::vector<const Exercise*>& exercises);

/// Builds through CMake whatever grading needs of these exercises and is not current: the tests as
/// programs that ask, the servers, what starts a box.
/// @throws BookError with the end of what the build printed.
BuildDescription ready_to_grade(Loop& loop, const Book& book,
                                const std::vector<const Exercise*>& exercises);

struct CompiledFile {
  std::filesystem::path object;
  Explained said;
  double seconds = 0.0;
};

/// Compiles a student's file for an exercise into `folder`. @throws BookError if the compiler
/// cannot be started.
CompiledFile compile(Loop& loop, const Book& book, const BuildDescription& build,
                     const Exercise& exercise, const std::filesystem::path& source,
                     const std::filesystem::path& folder,
                     const std::vector<std::string>& more_include = {});

/// How the compiler of this build counts columns.
Columns columns_of(const BuildDescription& build);

struct LinkedProgram {
  std::filesystem::path program;
  Explained said;
  double seconds = 0.0;
};

/// Links a student's object with the exercise's tests into `folder`.
LinkedProgram link(Loop& loop, const Book& book, const BuildDescription& build,
                   const Exercise& exercise, const std::filesystem::path& source,
                   const std::filesystem::path& object, const std::filesystem::path& folder);

/// The command that compile() runs: for the benchmark, which measures it alone.
std::vector<std::string> compile_command(const BuildDescription& build, const Exercise& exercise,
                                         const std::filesystem::path& source,
                                         const std::filesystem::path& object);
std::vector<std::string> link_command(const BuildDescription& build, const Exercise& exercise,
                                      const std::filesystem::path& object,
                                      const std::filesystem::path& program);
/// Links a student's object with the server of its contract instead of the tests.
std::vector<std::string> server_link_command(const BuildDescription& build,
                                             const Exercise& exercise,
                                             const std::filesystem::path& object,
                                             const std::filesystem::path& program);

/// The environment of a compiler or linker: its messages are read, so they come in English and
/// without a terminal's width.
std::vector<std::pair<std::string, std::string>> compiler_environment();

}  // namespace contact::grading
