#pragma once

// Random questions for contact-explain: real sources and messages of the forms that compilers use,
// both spoiled in the ways that an attacker would choose.

#include <cstdint>
#include <string>
#include <vector>

#include "diagnosis/explain_request.hpp"

namespace contact::testing {

/// splitmix64: the same numbers everywhere.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next();
  /// From 0 to below `n`; 0 if n is 0.
  std::size_t below(std::size_t n);
  bool chance(unsigned percent) { return below(100) < percent; }
  template <typename List>
  const auto& of(const List& list) {
    return list[below(list.size())];
  }

 private:
  std::uint64_t state_;
};

/// A source with the headers of its exercise.
struct Seed {
  std::string source;
  std::vector<grading::HeaderText> headers;
};

/// Every known mistake's source, every stub and solution of those exercises.
std::vector<Seed> read_seeds(const std::string& root);

/// The question of a number: the same number, the same question.
grading::ExplainRequest fuzzed(const std::vector<Seed>& seeds, std::uint64_t number);

}  // namespace contact::testing
