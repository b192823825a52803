#pragma once

// What to say to an answer that was typed, as the page says it.

#include <optional>
#include <string>
#include <vector>

#include "../../grading/book/questions.hpp"
#include "../../grading/text/quantity.hpp"

namespace contact::cli {

struct Judged {
  bool right = false;
  /// False for what is no answer yet, such as a number without its unit.
  bool counts = false;
  /// In Markdown.
  std::string say;
};

Judged judge_number(const grading::Units& units, const grading::NumberKey& key,
                    const std::string& text);

/// "a" and "1" name the first of `count`.
std::optional<std::size_t> named_choice(const std::string& text, std::size_t count);
/// "c a b", "cab" and "3, 1, 2" name all of `count`, each once.
std::optional<std::vector<std::size_t>> named_sequence(const std::string& text, std::size_t count);

Judged judge_choice(const grading::Question& question, std::optional<std::size_t> choice);
Judged judge_sequence(const grading::Question& question,
                      const std::optional<std::vector<std::size_t>>& sequence);

/// The number of a key with its unit: "−4 m/s".
std::string shown_key(const grading::NumberKey& key);

}  // namespace contact::cli
