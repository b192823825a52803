#pragma once

// The commonest mistakes of beginners, recognised in what g++ and clang++ say, and said in words.

#include <optional>
#include <string>
#include <vector>

#include "build_messages.hpp"
#include "source_text.hpp"
#include "verdict.hpp"

namespace contact::grading {

/// A message about the student's file, with what it takes to understand it.
struct Said {
  const Diagnostic& diagnostic;
  /// Where in the student's file; the column in bytes, 0 if it is not known.
  Place place;
  const SourceText& source;
  const Exercise& exercise;
};

struct Mistake {
  /// Its id, such as "missing-semicolon": the same for every compiler.
  std::string id;
  std::string words;
  /// Where to point, if not where the compiler does.
  std::optional<Place> place;
};

/// A message in which the type of a cross product is the vector that it is.
std::string with_vectors(std::string message);

/// The mistake behind a message; nothing if it is none of the known.
std::optional<Mistake> recognise(const Said& said);

/// Whether after this mistake a compiler misreads what follows.
bool derails(const std::string& mistake);

/// The mistake behind a failed link; nothing if it is none of the known.
std::optional<Mistake> recognise_link(const LinkFaults& faults, const SourceText& source,
                                      const Exercise& exercise);

}  // namespace contact::grading
