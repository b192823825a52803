#pragma once

// What a compiler or linker printed, reduced to what helps: its first error at a line of the
// student's file, and the line of the contract that it is about.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "verdict.hpp"

namespace contact::grading {

/// One message of g++ or clang++ in its plain text form.
struct Diagnostic {
  std::string file;
  int line = 0;
  int column = 0;
  std::string severity;  ///< "error", "fatal error", "warning" or "note"
  std::string message;
  std::string excerpt;  ///< source line and caret, as printed
  /// Places given before (g++) or after (clang++) that lead from the student's line to here.
  std::vector<std::pair<std::string, int>> required_from;
  std::vector<Diagnostic> notes;
};

std::vector<Diagnostic> parse_diagnostics(std::string_view text);

/// The first error, told at the student's line even where a template of a library raised it.
CompileError explain_compile(std::string_view text, const Exercise& exercise,
                             const std::filesystem::path& source);

/// Warnings at lines of the student's file, one line each.
std::vector<std::string> warnings_of(std::string_view text, const std::filesystem::path& source);

/// A link error; `defined` lists the functions that the student's object defines, demangled.
CompileError explain_link(std::string_view text, const Exercise& exercise,
                          const std::filesystem::path& source,
                          const std::vector<std::string>& defined);

/// The lines of the contract that declare a name (a function, a struct), to the end of the
/// declaration.
std::vector<ContractLine> declaration_of(const std::filesystem::path& contract,
                                         const std::string& name);

}  // namespace contact::grading
