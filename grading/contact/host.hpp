/// @file
/// What a program that runs an exercise's tests offers to the code underneath: the start of each
/// test, and a way to say that a call could not be made at all.
#pragma once

#include <functional>
#include <stdexcept>
#include <vector>

namespace contact::host {

/// The code under test could not answer: it crashed, ended, ran out of time or sent garbage. This
/// is neither a wrong answer nor an exception of the code under test; the test it happened in is
/// "stopped".
class Stopped : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

inline std::vector<std::function<void()>>& test_start_hooks() {
  static std::vector<std::function<void()>> hooks;
  return hooks;
}

/// Asks for a call before each test.
inline void at_test_start(std::function<void()> hook) {
  test_start_hooks().push_back(std::move(hook));
}

/// Called by the program before each test.
inline void test_starts() {
  for (const auto& hook : test_start_hooks()) hook();
}

}  // namespace contact::host
