#pragma once

// The system calls of a sandbox: an allow-list for each kind; all others are refused with an error,
// as if the kernel did not have them.

#include <string>

#include "box.hpp"

namespace contact::grading {

struct FilterSpec {
  BoxKind kind = BoxKind::answer;
  /// May start processes and threads.
  bool processes = false;
  /// The box sees private files only, so that opening one is harmless.
  bool private_files = true;
  /// If not negative: the one descriptor that a program may be started from, and only so.
  int program = -1;
};

/// The filter as the kernel's own instructions, for prctl() and for bubblewrap.
/// @throws BookError if the library cannot make it.
const std::string& filter_of(const FilterSpec& spec);

}  // namespace contact::grading
