#pragma once

// The commonest mistakes of beginners, recognised in the messages of g++ and clang++ and explained
// in words. Each kind of mistake has a file with the patterns of its messages and their
// explanations. rules.cpp tries them in order.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "../compiler_messages.hpp"
#include "../contract_text.hpp"
#include "../source_text.hpp"

namespace contact::grading {

/// A message about the student's file, with the data needed to understand it. Its numbers, and
/// those of its notes, have been checked against the files (claims.hpp): 0 if they are not valid.
struct Said {
  const Diagnostic& diagnostic;
  /// Where in the student's file; 0 where it is not known.
  Place place;
  const SourceText& source;
  const ContractText& contract;
};

struct Mistake {
  /// Its id, such as "missing-semicolon": the same for every compiler.
  std::string id;
  std::string words;
  /// Where to point, if not where the compiler does.
  std::optional<Place> place = std::nullopt;
};

/// A message in which the type of a cross product is the vector that it is.
std::string with_vectors(std::string_view message);

/// The mistake behind a message; nothing if it is none of the known.
std::optional<Mistake> recognise(const Said& said);

/// Whether after this mistake a compiler misreads what follows.
bool derails(const std::string& mistake);

/// The mistake behind a failed link; nothing if it is none of the known.
std::optional<Mistake> recognise_link(const LinkFaults& faults, const SourceText& source,
                                      const ContractText& contract);

}  // namespace contact::grading
