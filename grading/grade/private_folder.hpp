#pragma once

// An instructor's folder of private tests: its path, its permissions and its contents.

#include <filesystem>
#include <vector>

#include "private_tests.hpp"

namespace contact::grading {

/// A folder of tests, and the exercise that they are of.
struct PrivateFolder {
  const Exercise* exercise;
  std::filesystem::path folder;
  std::vector<std::filesystem::path> sources;
  std::vector<TestSpec> tests;
};

/// @throws BookError if it is not there, or lies among the submissions
void check_apart(const std::filesystem::path& folder, const std::filesystem::path& submissions);

/// @throws BookError if a submission could read these tests while it is compiled
void check_unreadable(const Machine& machine, const PrivateTestsPlace& place);

/// @throws BookError that says what of its files is wrong; also if there are no tests
std::vector<PrivateFolder> read_private_folder(const Book& book,
                                               const std::filesystem::path& folder);

}  // namespace contact::grading
