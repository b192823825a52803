#pragma once

// What a compiler or linker printed, as data.

#include <string>
#include <string_view>
#include <vector>

namespace contact::grading {

/// A step on the way from the student's line into a library.
struct Step {
  std::string file;
  int line = 0;
  int column = 0;
};

/// One message of g++ or clang++ in its plain text form.
struct Diagnostic {
  std::string file;
  int line = 0;
  int column = 0;
  /// Where what it is about ends, one past its last column; 0 if the compiler did not say.
  int end_line = 0;
  int end_column = 0;
  std::string severity;  ///< "error", "fatal error", "warning" or "note"
  std::string message;
  std::string excerpt;  ///< source line and caret, as printed
  /// Places given before (g++) or after (clang++) that lead from the student's line to here.
  std::vector<Step> required_from;
  std::vector<Diagnostic> notes;

  [[nodiscard]] bool is_error() const { return severity == "error" || severity == "fatal error"; }
};

std::vector<Diagnostic> parse_diagnostics(std::string_view text);

/// What a linker could not find, or found twice: in the words of GNU ld, gold, mold, lld and
/// wasm-ld.
struct LinkFaults {
  std::vector<std::string> missing;
  std::vector<std::string> twice;
};

LinkFaults parse_link_faults(std::string_view text);

}  // namespace contact::grading
