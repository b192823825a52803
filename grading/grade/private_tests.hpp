#pragma once

// Tests that are not in the book: an instructor's folder DIR/NN_slug/NAME/ with tests.toml and
// *_test.cpp, written against the exercise's contract as the book's own are.

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "../build/build.hpp"
#include "../sandbox/machine.hpp"

namespace contact::grading {

/// The private tests of one exercise.
struct PrivateExercise {
  std::string exercise;  ///< 02_triangles/ray_triangle
  /// They and the proxy of the contract: runs as the exercise's `asks` does.
  std::filesystem::path program;
  std::vector<TestSpec> tests;
  /// SHA-256 of everything that the program and its points are made of.
  std::string fingerprint;
};

struct PrivateTests {
  std::vector<PrivateExercise> exercises;

  /// nullptr if the exercise has none.
  [[nodiscard]] const PrivateExercise* of(const std::string& exercise) const;
};

struct PrivateTestsPlace {
  std::filesystem::path folder;       ///< what --private names
  std::filesystem::path submissions;  ///< it may not be inside
  std::filesystem::path cache;  ///< RESULTS/.grade/private: programs, kept while they are current
  /// Goes on where the boxes' user could read the folder.
  bool accept_weak = false;
};

/// Reads, checks and compiles them. Programs of an earlier call that are still current are kept.
/// @throws BookError with a sentence that says what to put right; a compiler's words stand in it.
PrivateTests load_private_tests(Loop& loop, const Book& book, const BuildDescription& build,
                                const Machine& machine, const PrivateTestsPlace& place);

/// The exercise as it is graded: its own tests, and after them the private ones.
Exercise with_private_tests(const Exercise& exercise, const PrivateTests& tests);

/// For RUN.json: [{"exercise","program","fingerprint","tests":[{"name","points","requires",
/// "visibility"}]}]
nlohmann::json to_json(const PrivateTests& tests);
PrivateTests private_tests_from_json(const nlohmann::json& json);

}  // namespace contact::grading
