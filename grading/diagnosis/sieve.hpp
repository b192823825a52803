#pragma once

// One mistake causes many compiler messages: selects those to show.

#include <vector>

#include "../verdict/verdict.hpp"
#include "compiler_messages.hpp"
#include "source_text.hpp"

namespace contact::grading {

/// A message at its place in the student's file.
struct FoundMessage {
  const Diagnostic* diagnostic;
  Place place;
  bool in_library;  ///< raised in a header, by what the student's line asks of it
  Remark remark;

  [[nodiscard]] bool is_error() const { return remark.severity == "error"; }
};

/// In the order of their lines, errors first, without what follows from an earlier message. All of
/// it stays in the compiler's own words.
std::vector<FoundMessage> sifted(std::vector<FoundMessage> all, const SourceText& source);

}  // namespace contact::grading
