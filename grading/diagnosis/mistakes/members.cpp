#include <array>
#include <cstdint>
#include <utility>

#include "../../text/near_names.hpp"
#include "../message_text.hpp"
#include "rules.hpp"

namespace contact::grading {

namespace {

constexpr std::array<std::string_view, 30> vector_members{
    "x",         "y",         "z",           "w",           "dot",
    "cross",     "norm",      "squaredNorm", "stableNorm",  "normalized",
    "normalize", "transpose", "inverse",     "determinant", "cwiseProduct",
    "cwiseAbs",  "cwiseMin",  "cwiseMax",    "maxCoeff",    "minCoeff",
    "sum",       "isZero",    "isApprox",    "allFinite",   "head",
    "tail",      "segment",   "size",        "setZero",     "unitOrthogonal"};

std::string in_a_row(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  return text;
}

}  // namespace

// "Ray" of "const contact::Ray<double>".
std::string short_name(const std::string& type) {
  std::string name = type.substr(0, type.find('<'));
  if (const std::size_t at = name.find_last_of(": "); at != std::string::npos)
    name.erase(0, at + 1);
  return name;
}

namespace {

// Names so like another that they may be meant: for a short one, a guess would be arbitrary.
std::vector<std::string> like(const std::string& name, const std::vector<std::string>& names) {
  std::vector<std::string> near = nearest(name, names);
  std::erase_if(near, [&](const std::string& other) {
    return edit_distance(name, other) > std::min<std::size_t>(2, name.size() / 2);
  });
  return near;
}

// What other languages call a length has a name of its own here.
std::string called_here(const std::string& type, const std::string& member) {
  const bool length = !like(in_small_letters(member), {"length"}).empty();
  if (type.starts_with("std::vector<") || type.starts_with("std::array<"))
    return length || member == "count" || member == "len" ? "how many there are is size()." : "";
  if ((type.starts_with("Vector") || type.starts_with("Eigen::Vector")) &&
      (length || member == "magnitude" || member == "len" || member == "mag"))
    return "the length of a vector is norm().";
  return "";
}

Mistake no_member(const std::string& type, const std::string& member, const Said& said) {
  std::string shown = bare_type(type);
  if (shown.starts_with("exercise::")) shown.erase(0, std::string_view("exercise::").size());
  if (const std::string other = called_here(shown, member); !other.empty())
    return {"no-such-member", shown + " has no " + member + ": " + other};
  std::string words = shown + " has no " + member;
  std::vector<std::string> known = said.contract.members_of(short_name(shown));
  if (!known.empty()) {
    const std::vector<std::string> near = like(member, known);
    words += near.empty() ? "." : ": is it " + near.front() + ", misspelt?";
    words += " It has " + in_a_row(known) + ".";
  } else {
    if (shown.starts_with("Vector") || shown.starts_with("Matrix") ||
        shown.starts_with("Eigen::Vector") || shown.starts_with("Eigen::Matrix"))
      known.assign(vector_members.begin(), vector_members.end());
    const std::vector<std::string> near = like(member, known);
    words += near.empty() ? "." : ": is it " + near.front() + ", misspelt?";
  }
  return {"no-such-member", words};
}

std::optional<Mistake> no_member_gcc(const Said& said, const Holes& holes) {
  return no_member(holes[0], holes[1], said);
}

std::optional<Mistake> no_member_clang(const Said& said, const Holes& holes) {
  return no_member(holes[1], holes[0], said);
}

std::optional<Mistake> missing_call(const Said& said, const Holes&) {
  std::string name(said.source.word_at(said.place));
  if (name.empty()) name = std::string(said.source.word_before(said.place));
  if (name.empty()) return std::nullopt;
  return Mistake{"missing-call",
                 name + " is a function: to call it, write " + name + "() with its parentheses."};
}

constexpr std::array rules{
    Rule{"'{}' has no member named '{}'{}", {}, {}, no_member_gcc},
    Rule{"no type named '{}' in '{}ScalarBinaryOpTraits<{}, {}, {}", {}, {}, eigen_types},
    Rule{"no member named '{}' in '{}'{}", {}, {}, no_member_clang},
    Rule{"base operand of '->' has non-pointer type '{}'", "arrow-for-dot",
         "This is no pointer: write . instead of ->."},
    Rule{"member reference type '{}' is not a pointer{}", "arrow-for-dot",
         "This is no pointer: write . instead of ->."},
    Rule{"cannot resolve overloaded function '{}' based on conversion{}", {}, {}, missing_call},
    Rule{"invalid use of non-static member function{}", {}, {}, missing_call},
    Rule{"invalid use of member function{}", {}, {}, missing_call},
    Rule{"{}did you forget the '()'{}", {}, {}, missing_call},
    Rule{"reference to non-static member function must be called{}", {}, {}, missing_call},
};

}  // namespace

std::span<const Rule> rules_of_members() { return rules; }

}  // namespace contact::grading
