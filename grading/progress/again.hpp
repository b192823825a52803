#pragma once

// A test that fails again and again, each time with other code, has more said of it each time: the
// second time which inputs are answered right and which wrong, the third time a smaller input, the
// fourth time and later one more of the exercise's hints.

#include <optional>
#include <string>

#include "../book/book.hpp"
#include "progress_record.hpp"

namespace contact::grading {

struct Again {
  std::string test;
  /// Texts with which this test has failed, this one included.
  int times = 0;
  /// CONTACT_LOOK for a second run of this test (tests/support/runner.cpp); empty if it would not
  /// come to its end.
  std::string look;
};

/// The test that the verdict shows in full, if it has failed before with other code.
std::optional<Again> failed_again(const ProgressRecord& before, const Verdict& verdict);

/// Adds the next hint to the test that has failed often enough; the same code gets the same hint.
void add_next_hint(const Exercise& exercise, const ProgressRecord& before, Verdict& verdict);

}  // namespace contact::grading
