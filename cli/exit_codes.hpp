#pragma once

namespace contact::cli {

/// What `contact` returns to the shell. cli/README.md and --help say the same.
enum ExitCode : int {
  exit_passed = 0,        ///< success
  exit_not_passed = 1,    ///< a test failed, was not attempted or could not be compiled
  exit_usage = 2,         ///< the command line was not understood
  exit_trouble = 3,       ///< the set-up, the book's files or an archive must be corrected first
  exit_interrupted = 130  ///< Ctrl-C
};

}  // namespace contact::cli
