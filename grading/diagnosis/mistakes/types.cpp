#include <array>
#include <cstdint>
#include <utility>

#include "../message_text.hpp"
#include "rules.hpp"

namespace contact::grading {

namespace {

bool is_product(const std::string& type) { return type.find("Product<") < type.find("Matrix<"); }

}  // namespace

Mistake product_of_vectors() {
  return {
      "product-of-vectors",
      "Two vectors have no product *. Write u.dot(v) for the number, u.cross(v) for the vector."};
}

namespace {

bool in_a_return(const Said& said) {
  const std::string_view code = said.source.code(said.place.line);
  const std::size_t at = code.find("return");
  return at != std::string_view::npos && static_cast<int>(at) < std::max(said.place.column, 1);
}

bool is_vector(std::string_view type) {
  return type.starts_with("Vector") || type.starts_with("Eigen::Vector");
}

bool is_number(std::string_view type) {
  constexpr std::array<std::string_view, 9> numbers{"double",      "float",    "int",
                                                    "long",        "long int", "unsigned int",
                                                    "std::size_t", "size_t",   "unsigned long"};
  return lists(numbers, type);
}

std::string with_its_kind(const std::string& type) {
  return (is_vector(type) ? "a vector (" : "a number (") + type + ")";
}

Mistake mismatch(const Said& said, const std::string& from, const std::string& to) {
  if (is_product(from)) return product_of_vectors();
  const std::string have = bare_type(from);
  const std::string want = bare_type(to);
  if (have.starts_with('<'))
    return {"wrong-type", "What stands in the braces { } does not make " + want + "."};
  if (want == "bool")
    return {"wrong-type", "A yes or no is asked for here, and this is of type " + have + "."};
  if ((is_vector(have) && is_number(want)) || (is_number(have) && is_vector(want))) {
    if (in_a_return(said))
      return {"wrong-type-returned", "The function returns " + with_its_kind(want) +
                                         ", and this is " + with_its_kind(have) + "."};
    return {"wrong-type",
            "C++ cannot turn " + with_its_kind(have) + " into " + with_its_kind(want) + "."};
  }
  if (in_a_return(said)) {
    constexpr std::array<std::string_view, 6> nothings{
        "bool", "int", "long", "long int", "std::nullptr_t", "nullptr_t"};
    const bool nothing = want.starts_with("std::optional<") && lists(nothings, have);
    return {"wrong-type-returned", "The function returns " + want + ", and this is of type " +
                                       have + "." +
                                       (nothing ? " For nothing, write std::nullopt." : "")};
  }
  return {"wrong-type", "This is of type " + have + ", and what is asked for is " + want + "."};
}

std::optional<Mistake> from_to(const Said& said, const Holes& holes) {
  return mismatch(said, holes[0], holes[1]);
}

std::optional<Mistake> to_from(const Said& said, const Holes& holes) {
  return mismatch(said, holes.back(), holes.front());
}

// g++ shows the expression first.
std::optional<Mistake> expression_from_to(const Said& said, const Holes& holes) {
  return mismatch(said, holes[1], holes[2]);
}

std::optional<Mistake> to_bool(const Said& said, const Holes& holes) {
  return mismatch(said, holes[0], "bool");
}

Mistake passed(const std::string& from, const std::string& to, const std::string& function) {
  return {"wrong-type-passed", (function.empty() ? "What is called here" : function) + " takes " +
                                   bare_type(to) + " here, and what is passed is " +
                                   bare_type(from) + "."};
}

}  // namespace

// "twice" of "double exercise::twice(double)" or of "Eigen::Matrix<double, 3, 1>::dot() const".
std::string function_name(const std::string& signature) {
  std::size_t end = signature.rfind(')');
  int depth = 0;
  for (; end != std::string::npos && end > 0; --end) {
    if (signature[end] == ')') ++depth;
    if (signature[end] == '(' && --depth == 0) break;
  }
  if (end == std::string::npos || end == 0) return signature;
  std::size_t begin = end;
  while (begin > 0 && is_identifier_character(signature[begin - 1])) --begin;
  return signature.substr(begin, end - begin);
}

namespace {

std::optional<Mistake> cannot_convert(const Said& said, const Holes& holes) {
  Holes note;
  if (find_note(said, "{}initializing argument {} of '{}'", note) != nullptr)
    return passed(holes[0], holes[1], function_name(note[2]));
  return mismatch(said, holes[0], holes[1]);
}

std::string arguments(const std::string& count) {
  if (count == "0" || count == "no") return "no argument";
  return count + (count == "1" ? " argument" : " arguments");
}

Mistake argument_count(const std::string& function, const std::string& wanted,
                       const std::string& given) {
  return {
      "wrong-argument-count",
      function + " takes " + arguments(wanted) +
          (given.empty() ? "" : ", and is given " + (given == "no" ? std::string("none") : given)) +
          "."};
}

// clang++ and g++ say of a call only that nothing matches; the notes say why.
std::optional<Mistake> no_matching_call(const Said& said, const Holes& holes) {
  const std::string function =
      contains(holes.back(), "(") ? function_name(holes.back()) : holes.back();
  Holes note;
  if (find_note(said, "{}requires single argument '{}', but {} argument{}", note) != nullptr)
    return argument_count(function, "1", note[2]);
  if (find_note(said, "{}requires {} arguments, but {} w{}", note) != nullptr ||
      find_note(said, "{}requires {} argument, but {} w{}", note) != nullptr)
    return argument_count(function, note[1], note[2]);
  if (find_note(said, "{}candidate expects {} argument{}, {} provided", note) != nullptr)
    return argument_count(function, note[1], note[3]);
  if (find_note(said, "{}no known conversion for argument {} from '{}' to '{}'", note) != nullptr ||
      find_note(said, "{}no known conversion {}from '{}' to '{}' for {}", note) != nullptr)
    return passed(note[2], note[3], function);
  return std::nullopt;
}

// "double exercise::twice(double)": how many it takes can be counted.
std::optional<Mistake> argument_count_gcc(const Said&, const Holes& holes) {
  const std::string& signature = holes.back();
  const std::size_t open = signature.find('(', signature.rfind(function_name(signature)));
  if (open == std::string::npos) return std::nullopt;
  const std::string list = signature.substr(open + 1, signature.rfind(')') - open - 1);
  int depth = 0;
  int count = list.empty() ? 0 : 1;
  for (const char c : list) {
    if (c == '<' || c == '(') ++depth;
    if (c == '>' || c == ')') --depth;
    if (c == ',' && depth == 0) ++count;
  }
  return argument_count(function_name(signature), std::to_string(count), "");
}

Mistake operands(const std::string& sign, const std::string& left, const std::string& right) {
  if (sign == "^")
    return {"caret-for-power", "^ is no power in C++. Write x * x, or std::pow(x, 3.0)."};
  return {"wrong-operands",
          (sign.empty() ? "These do not go together: " : sign + " does not go between ") +
              bare_type(left) + " and " + bare_type(right) + "."};
}

bool notes_say_const(const Said& said) {
  return any_note(said, "discards qualifiers") || any_note(said, "method is not marked const");
}

Mistake const_changed(const std::string& name) {
  return {"assigned-to-const",
          (name.empty() ? std::string("This") : name) +
              " is const: it can be read and not changed. Put the new value into a variable of "
              "your own."};
}

std::optional<Mistake> operands_gcc(const Said& said, const Holes& holes) {
  // What is const about the left one may be only in its other name.
  Holes left;
  if (holes[0] == "=" && (notes_say_const(said) || holes[1].starts_with("const ") ||
                          matches("{}(operand types are '{}' {aka 'const {}'} and {}",
                                  with_plain_quotes(said.diagnostic.message), left)))
    return const_changed("");
  return operands(holes[0], holes[1], holes[2]);
}

std::optional<Mistake> operands_gcc_builtin(const Said&, const Holes& holes) {
  return operands(holes[2], holes[0], holes[1]);
}

std::optional<Mistake> operands_clang(const Said& said, const Holes& holes) {
  const std::string_view code = said.source.code(said.place.line);
  std::string sign;
  for (auto at = static_cast<std::size_t>(std::max(said.place.column - 1, 0));
       at < code.size() && sign.size() < 2 && contains("+-*/%<>=!&|^", code.substr(at, 1)); ++at)
    sign += code[at];
  return operands(sign, holes[0], holes[1]);
}

std::optional<Mistake> no_overload(const Said& said, const Holes&) {
  if (notes_say_const(said)) return const_changed("");
  return std::nullopt;
}

// Whether a place lies in the brackets of an if or a while.
bool in_a_condition(const Said& said) {
  const std::string_view code = said.source.code(said.place.line);
  const std::string_view before = code.substr(
      0, std::min(static_cast<std::size_t>(std::max(said.place.column - 1, 0)), code.size()));
  const std::size_t at = std::min(before.find("if ("), before.find("while ("));
  return (at != std::string_view::npos || contains(before, "if(") || contains(before, "while(")) &&
         lacks_parenthesis(before);
}

// holes: what is const, such as "variable 't' with ".
std::optional<Mistake> const_named(const Said& said, const Holes& holes) {
  Holes quoted;
  const bool named = matches("{}'{}'{}", holes[0], quoted);
  Mistake mistake = const_changed(named ? quoted[1] : "");
  if (in_a_condition(said))
    mistake.words =
        (named ? quoted[1] : "This") + " is const, and one = assigns. To compare, write ==.";
  return mistake;
}

std::optional<Mistake> const_unnamed(const Said&, const Holes&) { return const_changed(""); }

std::optional<Mistake> const_called(const Said&, const Holes& holes) {
  return Mistake{"assigned-to-const",
                 holes[0] + " changes what it is called on, and that is const. Take a copy first" +
                     (holes[0] == "normalize" ? ", or call normalized()." : ".")};
}

std::optional<Mistake> const_passed(const Said& said, const Holes&) {
  Holes note;
  if (find_note(said, "{}in call to '{}'{}", note) != nullptr) {
    const std::string name = function_name(note[1].substr(0, note[1].find(" [with")));
    if (!name.empty() && !contains(note[1], "operator")) return const_called(said, {name});
  }
  return const_changed("");
}

constexpr std::array rules{
    Rule{"cannot convert '{}' to '{}' in {}", {}, {}, from_to},
    Rule{"cannot convert '{}' to '{}'", {}, {}, cannot_convert},
    Rule{"could not convert '{}' from '{}' to '{}'", {}, {}, expression_from_to},
    Rule{"conversion from '{}' to non-scalar type '{}' requested", {}, {}, from_to},
    Rule{"no viable conversion from returned value of type '{}' to function return type '{}'",
         {},
         {},
         from_to},
    Rule{"no viable conversion from '{}' to '{}'", {}, {}, from_to},
    Rule{"cannot initialize return object of type '{}' with an {} of type '{}'", {}, {}, to_from},
    Rule{"cannot initialize a variable of type '{}' with an {} of type '{}'", {}, {}, to_from},
    Rule{"assigning to '{}' from incompatible type '{}'", {}, {}, to_from},
    Rule{"value of type '{}' is not contextually convertible to 'bool'", {}, {}, to_bool},
    Rule{"too many arguments to function '{}'", {}, {}, argument_count_gcc},
    Rule{"too few arguments to function '{}'", {}, {}, argument_count_gcc},
    Rule{"no matching function for call to '{}'", {}, {}, no_matching_call},
    Rule{"no matching member function for call to '{}'", {}, {}, no_matching_call},
    Rule{"no match for 'operator{}' (operand types are '{}' and '{}')", {}, {}, operands_gcc},
    Rule{"invalid operands of types '{}' and '{}' to binary 'operator{}'",
         {},
         {},
         operands_gcc_builtin},
    Rule{"invalid operands to binary expression ('{}' and '{}')", {}, {}, operands_clang},
    Rule{"assignment of member '{}' in read-only object", {}, {}, const_unnamed},
    Rule{"assignment of read-only {}", {}, {}, const_named},
    Rule{"increment of read-only {}", {}, {}, const_named},
    Rule{"decrement of read-only {}", {}, {}, const_named},
    Rule{"cannot assign to {}const-qualified type '{}'", {}, {}, const_named},
    Rule{"cannot assign to {}", {}, {}, const_named},
    Rule{"passing '{}' as 'this' argument discards qualifiers{}", {}, {}, const_passed},
    Rule{"'this' argument to member function '{}' has type '{}', but function is not marked const",
         {},
         {},
         const_called},
    Rule{"no viable overloaded '{}'", {}, {}, no_overload},
    Rule{"binding reference of type '{}' discards qualifiers{}", {}, {}, const_unnamed},
};

}  // namespace

std::span<const Rule> rules_of_types() { return rules; }

}  // namespace contact::grading
