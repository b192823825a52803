#include <array>
#include <cstdint>
#include <utility>

#include "../message_text.hpp"
#include "rules.hpp"

namespace contact::grading {

namespace {

Mistake missing_bracket(char bracket, const Said& said) {
  Holes holes;
  std::string words = "A closing ? is missing here";
  words[words.find('?')] = bracket;
  if (const Diagnostic* const note = find_note(said, "to match this {}", holes);
      note != nullptr && note->own && note->line > 0 && note->line != said.place.line)
    words += ": it belongs to the one that opens in line " + std::to_string(note->line);
  return {"missing-parenthesis", words + "."};
}

}  // namespace

bool lacks_parenthesis(std::string_view code) {
  return std::count(code.begin(), code.end(), '(') > std::count(code.begin(), code.end(), ')');
}

namespace {

std::optional<Mistake> missing_semicolon(const Said& said, const Holes&) {
  if (const std::string_view next = said.source.sign_at(said.place); is_stray(next))
    return stray_sign(next);
  if (lacks_parenthesis(said.source.code(said.place.line))) return missing_bracket(')', said);
  const Place end = said.source.end_of_code_before(said.place);
  return Mistake{"missing-semicolon",
                 end.line == said.place.line ? "A semicolon ; is missing here."
                                             : "A semicolon ; is missing at the end of line " +
                                                   std::to_string(end.line) + ".",
                 end};
}

template <char Bracket>
std::optional<Mistake> missing_closing(const Said& said, const Holes&) {
  if (const std::string_view next = said.source.sign_at(said.place); is_stray(next))
    return stray_sign(next);
  return missing_bracket(Bracket, said);
}

std::optional<Mistake> missing_opening(const Said& said, const Holes&) {
  if (const std::string_view next = said.source.sign_at(said.place); is_stray(next))
    return stray_sign(next);
  return Mistake{"missing-parenthesis", "An opening ( is missing here."};
}

// A struct ends with }; and the compiler points at what it takes for a variable of it.
std::optional<Mistake> missing_semicolon_above(const Said& said, const Holes&) {
  const int stop = std::max(said.place.line - max_lines_upwards, 1);
  for (int line = said.place.line; line >= stop; --line) {
    const std::size_t brace = said.source.code(line).rfind('}');
    if (brace == std::string_view::npos) continue;
    return Mistake{"missing-semicolon",
                   "A semicolon ; is missing after the } of line " + std::to_string(line) + ".",
                   Place{line, static_cast<int>(brace) + 2}};
  }
  return std::nullopt;
}

std::optional<Mistake> missing_brace(const Said& said, const Holes&) {
  std::string words = "A closing brace } is missing";
  if (const std::optional<int> line = said.source.unclosed_brace())
    words += ": nothing closes the { of line " + std::to_string(*line);
  return Mistake{"missing-brace", words + "."};
}

std::optional<Mistake> function_inside(const Said& said, const Holes&) {
  std::string words =
      "A function begins inside another one here: a closing brace } is missing above";
  if (const std::optional<OpenFunction> outer = said.source.open_function(said.place)) {
    // A brace of the function's inside may be the one that is missing: indentation tells.
    const std::optional<int> inner = said.source.unclosed_brace();
    const bool its_own = !inner || *inner <= outer->line || *inner >= outer->next;
    const std::string next = std::to_string(outer->next);
    if (its_own)
      return Mistake{"missing-brace",
                     "A closing brace } is missing before line " + next +
                         ": the function's { of line " + std::to_string(outer->line) +
                         " is still open there.",
                     said.source.end_of_code_before({outer->next, 1})};
    words += ", for the { of line " + std::to_string(*inner);
  }
  return Mistake{"missing-brace", words + "."};
}

std::optional<Mistake> expected_expression(const Said& said, const Holes&) {
  if (said.source.word_at(said.place) == "else")
    return Mistake{"else-without-if", "This else has no if: a ; or a } ended the if before it."};
  if (is_stray(said.source.sign_at(said.place))) return stray_sign(said.source.sign_at(said.place));
  return std::nullopt;
}

// "double f(double x);" and then its body.
std::optional<Mistake> semicolon_after_head(const Said& said, const Holes&) {
  if (said.source.sign_at(said.place) != "{") return std::nullopt;
  const Place end = said.source.end_of_code_before(said.place);
  std::string_view head =
      said.source.code(end.line).substr(0, static_cast<std::size_t>(end.column) - 1);
  if (!head.ends_with(';')) return std::nullopt;
  head.remove_suffix(1);
  while (head.ends_with(' ')) head.remove_suffix(1);
  if (!head.ends_with(')')) return std::nullopt;
  return Mistake{"semicolon-after-head",
                 "The ; ends the function before its body: take it away, so that the { follows the "
                 "closing bracket.",
                 Place{end.line, end.column - 1}};
}

std::optional<Mistake> missing_return(const Said&, const Holes&) {
  return Mistake{"missing-return",
                 "The function promises a value, and there is a way to its end on which it returns "
                 "none. Each way through it needs its return."};
}

constexpr std::array rules{
    Rule{"expected unqualified-id{}", {}, {}, semicolon_after_head},
    Rule{"expected ';'{}", {}, {}, missing_semicolon},
    Rule{"expected ',' or ';' before {}", {}, {}, missing_semicolon},
    Rule{"invalid declarator before {}", {}, {}, missing_semicolon_above},
    Rule{"two or more data types in declaration of {}", {}, {}, missing_semicolon_above},
    Rule{"expected ')'{}", {}, {}, missing_closing<')'>},
    Rule{"expected ']'{}", {}, {}, missing_closing<']'>},
    Rule{"expected '('{}", {}, {}, missing_opening},
    Rule{"expected '}' at end of input", {}, {}, missing_brace},
    Rule{"expected '}'{}", {}, {}, missing_brace},
    Rule{"a function-definition is not allowed here{}", {}, {}, function_inside},
    Rule{"function definition is not allowed here", {}, {}, function_inside},
    Rule{"expected declaration before '}' token", "extra-brace",
         "This } closes nothing: there is one } too many, here or above."},
    Rule{"extraneous closing brace ('}')", "extra-brace",
         "This } closes nothing: there is one } too many, here or above."},
    Rule{"'else' without a previous 'if'", "else-without-if",
         "This else has no if: a ; or a } ended the if before it."},
    Rule{"expected expression", {}, {}, expected_expression},
    Rule{"unable to find numeric literal operator 'operator\"\"{}'", "missing-operator",
         "Between the number and $1 a sign is missing: a product is written 2 * x."},
    Rule{"invalid suffix '{}' on {} constant", "missing-operator",
         "Between the number and $1 a sign is missing: a product is written 2 * x."},
    Rule{"expression cannot be used as a function", "missing-operator",
         "What stands before the ( is no function. If a product is meant, write the *."},
    Rule{"'{}' cannot be used as a function", "missing-operator",
         "What stands before the ( is no function. If a product is meant, write the *."},
    Rule{"called object type '{}' is not a function or function pointer", "missing-operator",
         "What stands before the ( is no function. If a product is meant, write the *."},
    Rule{"no return statement in function returning non-void{}", {}, {}, missing_return},
    Rule{"control reaches end of non-void function{}", {}, {}, missing_return},
    Rule{"non-void function does not return a value{}", {}, {}, missing_return},
    Rule{"non-void lambda does not return a value{}", {}, {}, missing_return},
    Rule{"return-statement with no value, in function returning '{}'{}", "missing-return",
         "The function returns $1, and this return has no value."},
    Rule{"non-void function '{}' should return a value", "missing-return",
         "The function promises a value, and this return has none."},
};

}  // namespace

std::span<const Rule> rules_of_what_is_missing() { return rules; }

}  // namespace contact::grading
