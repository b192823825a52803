#pragma once

// One unit of grading: one exercise of one submission, compiled in one box, run in another and
// judged in a third.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "../build/build.hpp"
#include "../sandbox/box.hpp"
#include "../verdict/verdict.hpp"

namespace contact::grading {

/// What an instructor's profile can set. Defaults are those of the book.
struct GradeLimits {
  /// Of a test: 0 takes the exercise's own time_limit. Never less than ten times what the solution
  /// takes here.
  double test_cpu_seconds = 0.0;
  /// On the clock, as a multiple of the processor's, and seconds on top.
  double wall_factor = 4.0;
  double wall_extra = 10.0;
  /// In which a test may only wait, and all tests of an exercise before each has a tenth of that.
  double idle_seconds = 1.0;
  double idle_seconds_in_all = 6.0;
  int memory_mb = 512;
  int processes = 1;
  std::size_t output_bytes = 64u << 10;
  int files_mb = 16;
  int files = 64;
  double compile_cpu_seconds = 30.0;
  double compile_idle_seconds = 3.0;
  int compile_memory_mb = 1024;
  int compile_processes = 32;
  std::size_t diagnostics_bytes = 64u << 10;
  int object_mb = 64;
  /// Of one answer that comes back, and of calls in one test.
  std::size_t answer_bytes = 16u << 20;
  long calls = 1'000'000;
  /// Of a whole unit on the clock; 0 adds up what its boxes may take (unit_time.hpp).
  double unit_seconds = 0.0;
};

struct UnitSettings {
  /// CONTACT_SEED of the tests; empty for the book's own.
  std::string seed;
  GradeLimits limits;
  /// Seconds of processor time that one test may take, after calibrate().
  double test_cpu_seconds = 5.0;
  /// Private tests' programs besides the exercise's own, as private_tests.hpp builds them.
  std::vector<std::filesystem::path> more_tests;
};

struct UnitResult {
  Verdict verdict;
  /// Some test used so much of its limit, or ended in such a way, that it must be run again alone
  /// to be believed.
  bool near_limit = false;
  /// Most processor time of a test.
  double slowest_test = 0.0;
  double seconds = 0.0;
};

/// @param text the submission's file, copied into the compile box by this call; it is read as a
/// stranger's
/// @throws BookError if the machine itself fails (no box, no disk); nothing that a submission does
/// throws.
UnitResult grade_unit(Loop& loop, const Book& book, const BuildDescription& build,
                      const Machine& machine, const Seat& seat, const Exercise& exercise,
                      std::string_view text, const UnitSettings& settings);

}  // namespace contact::grading
