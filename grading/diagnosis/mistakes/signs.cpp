#include <array>
#include <cstdint>
#include <utility>

#include "../message_text.hpp"
#include "rules.hpp"

namespace contact::grading {

namespace {

struct Sign {
  std::string_view sign;
  std::string_view instead;
};

constexpr std::array<Sign, 14> signs{{{"“", "\""},
                                      {"”", "\""},
                                      {"„", "\""},
                                      {"‘", "'"},
                                      {"’", "'"},
                                      {"−", "-"},
                                      {"–", "-"},
                                      {"—", "-"},
                                      {"×", "*"},
                                      {"·", "*"},
                                      {"÷", "/"},
                                      {"≤", "<="},
                                      {"≥", ">="},
                                      {"≠", "!="}}};

}  // namespace

// A sign that C++ does not know: any beyond ASCII, and some of ASCII's.
bool is_stray(std::string_view sign) {
  return !sign.empty() && ((static_cast<unsigned char>(sign.front()) & 0x80U) != 0 ||
                           contains("@`$", sign.substr(0, 1)));
}

namespace {

std::string_view written_instead_of(std::string_view sign) {
  for (const Sign& known : signs) {
    if (known.sign == sign) return known.instead;
  }
  return {};
}

}  // namespace

Mistake stray_sign(std::string_view sign) {
  if (sign == "\xC2\xA0")
    return {"stray-character",
            "There is a blank here that is no ordinary one: delete it and type a new one."};
  const std::string_view instead = written_instead_of(sign);
  return {"stray-character",
          "C++ does not know the character " + std::string(sign) + ". " +
              (instead.empty() ? "Delete it." : "Write " + std::string(instead) + " instead.")};
}

namespace {

// The next such sign in the line: compilers point at it or a little before.
std::optional<Mistake> stray_character(const Said& said, const Holes&) {
  const std::string_view line = said.source.line(said.place.line);
  auto at = static_cast<std::size_t>(std::max(said.place.column - 1, 0));
  while ((at = line.find_first_not_of(" \t", at)) != std::string_view::npos) {
    const std::string_view sign = said.source.sign_at({said.place.line, static_cast<int>(at) + 1});
    if (is_stray(sign)) return stray_sign(sign);
    ++at;
  }
  return Mistake{"stray-character", "There is a character here that C++ does not know."};
}

constexpr std::array rules{
    Rule{"extended character {} is not valid in an identifier", {}, {}, stray_character},
    Rule{"stray '{}' in program", {}, {}, stray_character},
    Rule{"unexpected character <{}", {}, {}, stray_character},
    Rule{"character <{}> not allowed in an identifier", {}, {}, stray_character},
    Rule{"missing terminating {} character{}", "unfinished-text",
         "A text begins here and does not end in this line: its closing quote \" is missing."},

    Rule{"unterminated comment", "unfinished-comment",
         "A comment begins here with /* and has no */: all that follows is part of it."},
    Rule{"unterminated /* comment", "unfinished-comment",
         "A comment begins here with /* and has no */: all that follows is part of it."},
};

}  // namespace

std::span<const Rule> rules_of_signs() { return rules; }

}  // namespace contact::grading
