/// @file
/// What a test says of a wrong answer, and what a closer look at a test adds: a second run, which
/// does not end at the first wrong answer (CONTACT_LOOK in the environment).
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace contact::testing {

/// The report on the first wrong answer of a test.
struct Failure {
  std::string asked;
  std::vector<std::pair<std::string, std::string>> inputs;  ///< name and text, in order
  std::string got;
  std::string right;
  std::string allowed;  ///< how far from `right` an answer may be; empty if not at all
  /// Ids in chapters/misconceptions.toml: every mistake that gives this answer, each once.
  std::vector<std::string> misconceptions;
  /// What is true of this answer whatever caused it (observed.hpp); empty if a mistake is
  /// recognised, or there is nothing to say.
  std::string observed;
  /// The code under test threw, crashed, ended or ran out of time, as `reason` says: there is no
  /// answer.
  bool stopped = false;
  std::string reason;
};

/// What a closer look at a test finds.
struct CloserLook {
  /// Name and text of each input of a question.
  using Inputs = std::vector<std::pair<std::string, std::string>>;

  int right = 0;  ///< questions
  int wrong = 0;
  /// The first few, with numbers to four digits.
  std::vector<Inputs> right_inputs, wrong_inputs;
  /// A wrong answer to the same question with simpler inputs (support/shrinkable.hpp).
  std::optional<Failure> smaller;
};

/// The closer look at the test that runs now, or nullptr if this run ends a test at its first wrong
/// answer.
const CloserLook* closer_look();

/// Calls `tell` each time that a closer look has found a smaller input: a later one may crash.
void tell_closer_look(std::function<void()> tell);

namespace detail {

/// Whether inputs are to be made smaller: CONTACT_LOOK is `smaller`, and this test has none yet.
bool wants_smaller();

/// The first failure of what `ask` asks, which the test is not told of; nothing if all is right or
/// if it cannot be told.
std::optional<Failure> probe(const std::function<void()>& ask);

void found_smaller(Failure smaller);

}  // namespace detail
}  // namespace contact::testing
