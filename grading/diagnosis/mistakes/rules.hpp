#pragma once

// What the kinds of mistakes share: a table of rules each, and the tools that several use.

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mistake.hpp"

namespace contact::grading {

/// What the holes of a pattern stand for.
using Holes = std::vector<std::string>;

/// A form of message: what it looks like, and the mistake behind it. Where `tell` is null, the
/// words are a template in which $1, $2, ... are the pattern's holes. `tell` may find that it is
/// another mistake, or none: then the next rule is asked.
struct Rule {
  std::string_view pattern;
  std::string_view mistake;
  std::string_view words;
  std::optional<Mistake> (*tell)(const Said&, const Holes&) = nullptr;
};

// The first that fits counts. In each, both compilers' forms of one mistake stand together: g++,
// then clang++.
std::span<const Rule> rules_of_signs();
std::span<const Rule> rules_of_what_is_missing();
std::span<const Rule> rules_of_names();
std::span<const Rule> rules_of_members();
std::span<const Rule> rules_of_types();
std::span<const Rule> rules_of_definitions();
std::span<const Rule> rules_of_eigen();
std::span<const Rule> rules_of_warnings();
/// All of them, in the order in which they are asked.
std::vector<std::span<const Rule>> all_rules();

template <typename List>
bool lists(const List& list, std::string_view name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

inline bool contains(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

/// Whether a note says this.
bool any_note(const Said& said, std::string_view part);
/// The first note of a pattern; null if there is none.
const Diagnostic* find_note(const Said& said, std::string_view pattern, Holes& holes);

// Signs.
/// A sign that C++ does not know: any beyond ASCII, and some of ASCII's.
bool is_stray(std::string_view sign);
Mistake stray_sign(std::string_view sign);

// What is missing.
bool lacks_parenthesis(std::string_view code);

// Names.
std::string in_small_letters(std::string text);
/// "Ray" of "const contact::Ray<double>".
std::string short_name(const std::string& type);
/// "twice" of "double exercise::twice(double)" or of "Eigen::Matrix<double, 3, 1>::dot() const".
std::string function_name(const std::string& signature);
/// The name that ends a text, signs behind it skipped.
std::string_view last_word(std::string_view text);

// Eigen.
Mistake product_of_vectors();
std::optional<Mistake> eigen_types(const Said& said, const Holes& holes);

}  // namespace contact::grading
