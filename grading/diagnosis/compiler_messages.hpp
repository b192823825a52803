#pragma once

// What a compiler or linker printed, as data. The author of the source can make it print anything,
// so the messages are only claims: numbers are limited to max_claimed, and claims.hpp checks them
// against the files that they name.

#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace contact::grading {

/// A larger number is read as this one.
inline constexpr int max_claimed = std::numeric_limits<int>::max();
/// More messages, notes or symbols than these are passed over.
inline constexpr std::size_t max_messages = 100;
inline constexpr std::size_t max_notes = 40;
inline constexpr std::size_t max_symbols = 50;

/// A step on the way from the student's line into a library.
struct Step {
  std::string file;
  int line = 0;
  int column = 0;
  bool own = false;  ///< as in Diagnostic
};

/// One message of g++ or clang++ in its plain text form.
struct Diagnostic {
  std::string file;
  int line = 0;
  int column = 0;
  /// Where what it is about ends, one past its last column; 0 if the compiler did not say.
  int end_line = 0;
  int end_column = 0;
  /// Whether it is about the student's file, which claims.hpp finds out.
  bool own = false;
  std::string severity;  ///< "error", "fatal error", "warning" or "note"
  std::string message;
  std::string excerpt;  ///< source line and caret, as printed; at most a few short lines
  /// Places given before (g++) or after (clang++) that lead from the student's line to here.
  std::vector<Step> required_from;
  std::vector<Diagnostic> notes;

  [[nodiscard]] bool is_error() const { return severity == "error" || severity == "fatal error"; }
};

struct Diagnostics {
  std::vector<Diagnostic> messages;
  /// Errors and warnings that were passed over, since there are so many.
  std::size_t more = 0;
};

Diagnostics parse_diagnostics(std::string_view text);

/// What a linker could not find, or found twice: in the words of GNU ld, gold, mold, lld and
/// wasm-ld.
struct LinkFaults {
  std::vector<std::string> missing;
  std::vector<std::string> twice;
};

LinkFaults parse_link_faults(std::string_view text);

}  // namespace contact::grading
