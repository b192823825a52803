#pragma once

// What a compiler or linker said, turned into what helps the student: each message at its line and
// in words, the first error whole, and the line of the contract that it is about. `contact check`
// and the page both come here.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "build_messages.hpp"
#include "source_text.hpp"
#include "verdict.hpp"

namespace contact::grading {

/// A student's file, by its name and as text.
struct Answer {
  std::filesystem::path file;
  SourceText source;
};

struct Explained {
  /// The first error, if there is one.
  std::optional<CompileError> error;
  std::vector<Remark> remarks;
  /// Warnings at lines of the student's file, one line each.
  std::vector<std::string> warnings;
};

/// What a compiler said; `failed` if there is no object.
Explained explain_compile(std::string_view log, bool failed, const Exercise& exercise,
                          const Answer& answer, Columns columns);

/// What a linker said when it failed.
Explained explain_link(std::string_view log, const Exercise& exercise, const Answer& answer);

/// The same for faults that are known otherwise: a main() that the page's linker takes for its own.
Explained explain_link_faults(const LinkFaults& faults, std::string_view log,
                              const Exercise& exercise, const Answer& answer);

}  // namespace contact::grading
