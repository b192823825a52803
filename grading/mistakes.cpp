#include "mistakes.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>
#include <utility>

#include "build_text.hpp"
#include "contract_text.hpp"

namespace contact::grading {

namespace {

using Holes = std::vector<std::string>;

bool contains(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

bool any_note(const Said& said, std::string_view part) {
  return std::any_of(said.diagnostic.notes.begin(), said.diagnostic.notes.end(),
                     [&](const Diagnostic& note) { return contains(note.message, part); });
}

/// The first note of a pattern.
const Diagnostic* find_note(const Said& said, std::string_view pattern, Holes& holes) {
  for (const Diagnostic& note : said.diagnostic.notes) {
    if (matches(pattern, with_plain_quotes(without_aliases(note.message)), holes)) return &note;
  }
  return nullptr;
}

// ---- Signs -------------------------------------------------------------------------------------

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

// A sign that C++ does not know: any beyond ASCII, and some of ASCII's.
bool stray(std::string_view sign) {
  return !sign.empty() && ((static_cast<unsigned char>(sign.front()) & 0x80U) != 0 ||
                           contains("@`$", sign.substr(0, 1)));
}

std::string_view written_instead_of(std::string_view sign) {
  for (const Sign& known : signs) {
    if (known.sign == sign) return known.instead;
  }
  return {};
}

Mistake stray_sign(std::string_view sign) {
  if (sign == "\xC2\xA0")
    return {"stray-character",
            "There is a blank here that is no ordinary one: delete it and type a new one.",
            std::nullopt};
  const std::string_view instead = written_instead_of(sign);
  return {"stray-character",
          "C++ does not know the character " + std::string(sign) + ". " +
              (instead.empty() ? "Delete it." : "Write " + std::string(instead) + " instead."),
          std::nullopt};
}

// The next such sign in the line: compilers point at it or a little before.
std::optional<Mistake> stray_character(const Said& said, const Holes&) {
  const std::string_view code = said.source.code(said.place.line);
  for (std::size_t at = static_cast<std::size_t>(std::max(said.place.column - 1, 0));
       at < code.size(); ++at) {
    const std::string_view sign = said.source.sign_at({said.place.line, static_cast<int>(at) + 1});
    if (stray(sign)) return stray_sign(sign);
  }
  return Mistake{"stray-character", "There is a character here that C++ does not know.",
                 std::nullopt};
}

// ---- What is missing ---------------------------------------------------------------------------

Mistake missing_bracket(char bracket, const Said& said) {
  Holes holes;
  std::string words = std::string("A closing ") + bracket + " is missing here";
  if (const Diagnostic* const note = find_note(said, "to match this {}", holes);
      note != nullptr && note->line != said.place.line)
    words += ": it belongs to the one that opens in line " + std::to_string(note->line);
  return {"missing-parenthesis", words + ".", std::nullopt};
}

bool lacks_parenthesis(std::string_view code) {
  return std::count(code.begin(), code.end(), '(') > std::count(code.begin(), code.end(), ')');
}

std::optional<Mistake> missing_semicolon(const Said& said, const Holes&) {
  if (const std::string_view next = said.source.sign_at(said.place); stray(next))
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
  if (const std::string_view next = said.source.sign_at(said.place); stray(next))
    return stray_sign(next);
  return missing_bracket(Bracket, said);
}

std::optional<Mistake> missing_opening(const Said& said, const Holes&) {
  if (const std::string_view next = said.source.sign_at(said.place); stray(next))
    return stray_sign(next);
  return Mistake{"missing-parenthesis", "An opening ( is missing here.", std::nullopt};
}

// A struct ends with }; and the compiler points at what it takes for a variable of it.
std::optional<Mistake> missing_semicolon_above(const Said& said, const Holes&) {
  for (int line = said.place.line; line >= 1; --line) {
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
  return Mistake{"missing-brace", words + ".", std::nullopt};
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
  return Mistake{"missing-brace", words + ".", std::nullopt};
}

std::optional<Mistake> expected_expression(const Said& said, const Holes&) {
  if (said.source.word_at(said.place) == "else")
    return Mistake{"else-without-if", "This else has no if: a ; or a } ended the if before it.",
                   std::nullopt};
  if (stray(said.source.sign_at(said.place))) return stray_sign(said.source.sign_at(said.place));
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
                 "none. Each way through it needs its return.",
                 std::nullopt};
}

// ---- Names -------------------------------------------------------------------------------------

struct Header {
  std::string_view name;
  std::string_view header;
};

constexpr std::array<Header, 30> headers{{{"cout", "iostream"},
                                          {"cerr", "iostream"},
                                          {"cin", "iostream"},
                                          {"endl", "iostream"},
                                          {"map", "map"},
                                          {"multimap", "map"},
                                          {"set", "set"},
                                          {"unordered_map", "unordered_map"},
                                          {"unordered_set", "unordered_set"},
                                          {"deque", "deque"},
                                          {"list", "list"},
                                          {"queue", "queue"},
                                          {"priority_queue", "queue"},
                                          {"stack", "stack"},
                                          {"function", "functional"},
                                          {"unique_ptr", "memory"},
                                          {"shared_ptr", "memory"},
                                          {"make_unique", "memory"},
                                          {"make_shared", "memory"},
                                          {"stringstream", "sstream"},
                                          {"ostringstream", "sstream"},
                                          {"setprecision", "iomanip"},
                                          {"mt19937", "random"},
                                          {"span", "span"},
                                          {"complex", "complex"},
                                          {"bitset", "bitset"},
                                          {"format", "format"},
                                          {"regex", "regex"},
                                          {"thread", "thread"},
                                          {"ofstream", "fstream"}}};

constexpr std::array<std::string_view, 36> standard_names{"vector",
                                                          "array",
                                                          "optional",
                                                          "nullopt",
                                                          "string",
                                                          "string_view",
                                                          "pair",
                                                          "tuple",
                                                          "tie",
                                                          "variant",
                                                          "get",
                                                          "swap",
                                                          "move",
                                                          "min",
                                                          "max",
                                                          "clamp",
                                                          "abs",
                                                          "sort",
                                                          "find",
                                                          "count",
                                                          "accumulate",
                                                          "sqrt",
                                                          "hypot",
                                                          "fabs",
                                                          "numeric_limits",
                                                          "runtime_error",
                                                          "isnan",
                                                          "isfinite",
                                                          "size_t",
                                                          "make_pair",
                                                          "make_optional",
                                                          "invalid_argument",
                                                          "minmax",
                                                          "fma",
                                                          "signbit",
                                                          "copysign"};

template <typename List>
bool lists(const List& list, std::string_view name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

std::string_view header_of(std::string_view name) {
  for (const Header& known : headers) {
    if (known.name == name) return known.header;
  }
  return {};
}

bool is_eigen_name(std::string_view name) {
  return ((name.starts_with("Vector") || name.starts_with("Matrix")) && name.size() == 8 &&
          name[6] >= '2' && name[6] <= '4') ||
         name == "Matrix" || name == "VectorXd" || name == "MatrixXd" || name == "Quaterniond";
}

Mistake missing_include(const std::string& name, std::string_view header) {
  return {"missing-include",
          "std::" + name + " is in a header that the file does not include: write #include <" +
              std::string(header) + "> at the top.",
          std::nullopt};
}

std::string_view last_word(std::string_view text) {
  std::size_t end = text.size();
  while (end > 0 && !is_identifier_character(text[end - 1])) --end;
  std::size_t begin = end;
  while (begin > 0 && is_identifier_character(text[begin - 1])) --begin;
  return text.substr(begin, end - begin);
}

// "plane.d", for each parameter of which the name is a member: "a.t or b.t".
// "const contact::Ray<double>& ray" is a Ray called ray; one without a name is left out.
std::string as_member(const std::string& name, const Said& said) {
  const std::optional<FunctionDefinition> function = said.source.function_around(said.place.line);
  if (!function) return {};
  const std::string_view written = function->written;
  std::string text;
  int depth = 0;
  std::size_t begin = std::min(written.find('('), written.size() - 1) + 1;
  for (std::size_t i = begin; i < written.size(); ++i) {
    const char c = written[i];
    if (depth == 0 && (c == ',' || c == ')')) {
      const std::string_view one = written.substr(begin, i - begin);
      begin = i + 1;
      const std::string_view parameter = last_word(one);
      if (parameter.empty() || !one.ends_with(parameter)) continue;
      std::string_view type = one.substr(0, one.size() - parameter.size());
      type = last_word(type.substr(0, type.find('<')));
      if (lists(members_of(said.exercise, std::string(type)), name))
        text += (text.empty() ? "" : " or ") + std::string(parameter) + "." + name;
    }
    if (c == '<' || c == '(' || c == '{') ++depth;
    if (c == '>' || c == ')' || c == '}') --depth;
  }
  return text;
}

// The line of the head of the function around, if the name of a parameter is commented out there.
std::optional<int> commented_out(const std::string& name, const Said& said) {
  const std::optional<FunctionDefinition> function = said.source.function_around(said.place.line);
  if (!function) return std::nullopt;
  for (int line = function->line; line <= said.place.line; ++line) {
    const std::string_view text = said.source.line(line);
    for (std::size_t at = text.find("/*"); at != std::string_view::npos;
         at = text.find("/*", at + 2)) {
      std::string_view inside = text.substr(at + 2, text.find("*/", at) - at - 2);
      while (inside.starts_with(' ')) inside.remove_prefix(1);
      while (inside.ends_with(' ')) inside.remove_suffix(1);
      if (inside == name) return line;
    }
    if (contains(said.source.code(line), "{")) break;
  }
  return std::nullopt;
}

constexpr std::array<std::string_view, 20> keywords{
    "return", "if",    "else",      "for",    "while", "do",      "const",
    "double", "int",   "bool",      "float",  "auto",  "break",   "void",
    "true",   "false", "constexpr", "switch", "throw", "continue"};

std::string in_small_letters(std::string text) {
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return text;
}

// "int i = 0" of "for (i = 0; i < 3; ++i)", if that is where the name stands.
std::string counter_of(const std::string& name, std::string_view code) {
  std::string_view rest = code.substr(std::min(code.find("for"), code.size()));
  const auto skip = [&](std::string_view part) {
    rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
    if (!rest.starts_with(part)) return false;
    rest.remove_prefix(part.size());
    return true;
  };
  if (!skip("for") || !skip("(") || !skip(name) || !skip("=") || rest.starts_with("=")) return {};
  rest = rest.substr(0, rest.find(';'));
  while (rest.starts_with(' ')) rest.remove_prefix(1);
  return "int " + name + " = " + std::string(rest);
}

// The scope in which a name is known, with its colons, if the reader left it out.
std::string scope_of(const std::string& name, const std::string& suggestion, const Said& said) {
  const std::string end = "::" + name;
  const auto is_struct = [&](const std::string& scoped) {
    const std::string scope = scoped.substr(0, scoped.size() - end.size());
    return lists(members_of(said.exercise, scope.substr(scope.rfind(':') + 1)), name);
  };
  // What a struct holds is no name of its own, whatever the compiler suggests.
  if (suggestion.ends_with(end) && is_struct(suggestion)) return {};
  if (suggestion.ends_with(end)) return suggestion.substr(0, suggestion.size() - name.size());
  for (const Diagnostic& note : said.diagnostic.notes) {
    Holes holes;
    if (matches("{}'{}'", with_plain_quotes(note.message), holes) && holes[1].ends_with(end))
      return holes[1].substr(0, holes[1].size() - name.size());
  }
  if (lists(standard_names, name) || !header_of(name).empty()) return "std::";
  if (is_eigen_name(name)) return "Eigen::";
  if (const std::optional<ContractLine> shape = declaration_of(said.exercise, name);
      shape && !same_file(shape->file, said.exercise.contract))
    return "contact::";
  return {};
}

Mistake unknown(const std::string& name, const std::string& suggestion, const Said& said) {
  if (const std::optional<int> line = commented_out(name, said))
    return {"name-in-comment",
            "C++ does not know " + name + ". Its name stands in a comment on line " +
                std::to_string(*line) + ": take the /* and */ away.",
            std::nullopt};
  if (const std::string small = in_small_letters(name); small != name && lists(keywords, small))
    return {"capital-letter",
            small + " is written small: C++ tells capital letters from small ones.", std::nullopt};
  const std::string scope = scope_of(name, suggestion, said);
  if (!scope.empty())
    return {scope == "std::" ? "missing-std" : "missing-namespace",
            "C++ does not know " + name + " by this name alone: write " + scope + name + ".",
            std::nullopt};
  std::string words = "C++ does not know the name " + name;
  const std::string_view code = said.source.code(said.place.line);
  const std::size_t after = code.find(name) == std::string_view::npos
                                ? std::string_view::npos
                                : code.find_first_not_of(' ', code.find(name) + name.size());
  const bool assigned = code.find_first_not_of(' ') == code.find(name) &&
                        after != std::string_view::npos && code[after] == '=' &&
                        code.substr(after, 2) != "==";
  if (const std::string member = as_member(name, said); !assigned && !member.empty())
    return {"unknown-name", words + " by itself: write " + member + ".", std::nullopt};
  if (const std::string counter = counter_of(name, code); !counter.empty())
    return {"unknown-name", words + ". If it is new here, its type comes first: " + counter + ".",
            std::nullopt};
  if (!suggestion.empty() && !suggestion.starts_with("std::") &&
      !suggestion.ends_with("::" + name)) {
    words += ": is it " + suggestion + ", misspelt?";
    return {"unknown-name", words, std::nullopt};
  }
  words += assigned ? ". If it is new here, its type comes first: double " + name + " = ..."
                    : ". Is it misspelt, or not declared before this line?";
  return {"unknown-name", words, std::nullopt};
}

std::optional<Mistake> unknown_name(const Said& said, const Holes& holes) {
  return unknown(holes[0], "", said);
}

std::optional<Mistake> unknown_name_suggested(const Said& said, const Holes& holes) {
  return unknown(holes[0], holes[1], said);
}

// holes: the name; perhaps more text, with a suggestion.
std::optional<Mistake> not_in_std(const Said& said, const Holes& holes) {
  const std::string& name = holes[0];
  Holes note;
  if (find_note(said, "'std::{}' is defined in header '<{}>'{}", note) != nullptr)
    return missing_include(name, note[1]);
  if (const std::string_view header = header_of(name); !header.empty())
    return missing_include(name, header);
  Holes suggestion;
  const bool suggested = holes.size() > 1 && matches("{}did you mean '{}'{}", holes[1], suggestion);
  return Mistake{"unknown-name",
                 "std has no " + name +
                     (suggested ? ": is it " + suggestion[1] + ", misspelt?"
                                : " here. Is it misspelt, or is its header not included?"),
                 std::nullopt};
}

// holes: the name, the namespace, perhaps more.
std::optional<Mistake> not_in_namespace(const Said& said, const Holes& holes) {
  if (holes[1] == "std") return not_in_std(said, {holes[0]});
  return Mistake{"unknown-name", holes[1] + " has no " + holes[0] + ": is it misspelt?",
                 std::nullopt};
}

std::optional<Mistake> no_such_header(const Said& said, const Holes& holes) {
  const std::string contract = said.exercise.contract.filename().string();
  std::string words = "There is no header " + holes[0] + ".";
  if (!nearest(holes[0], {contract}).empty()) words += " The contract is \"" + contract + "\".";
  return Mistake{"no-such-header", words, std::nullopt};
}

// ---- Members -----------------------------------------------------------------------------------

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

// "Ray" of "const contact::Ray<double>".
std::string short_name(const std::string& type) {
  std::string name = type.substr(0, type.find('<'));
  if (const std::size_t at = name.find_last_of(": "); at != std::string::npos)
    name.erase(0, at + 1);
  return name;
}

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
    return {"no-such-member", shown + " has no " + member + ": " + other, std::nullopt};
  std::string words = shown + " has no " + member;
  std::vector<std::string> known = members_of(said.exercise, short_name(shown));
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
  return {"no-such-member", words, std::nullopt};
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
  return Mistake{"missing-call",
                 name + " is a function: to call it, write " + name + "() with its parentheses.",
                 std::nullopt};
}

// ---- Types -------------------------------------------------------------------------------------

bool is_product(const std::string& type) { return type.find("Product<") < type.find("Matrix<"); }

Mistake product_of_vectors() {
  return {
      "product-of-vectors",
      "Two vectors have no product *. Write u.dot(v) for the number, u.cross(v) for the vector.",
      std::nullopt};
}

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
    return {"wrong-type", "What stands in the braces { } does not make " + want + ".",
            std::nullopt};
  if (want == "bool")
    return {"wrong-type", "A yes or no is asked for here, and this is of type " + have + ".",
            std::nullopt};
  if ((is_vector(have) && is_number(want)) || (is_number(have) && is_vector(want))) {
    if (in_a_return(said))
      return {"wrong-type-returned",
              "The function returns " + with_its_kind(want) + ", and this is " +
                  with_its_kind(have) + ".",
              std::nullopt};
    return {"wrong-type",
            "C++ cannot turn " + with_its_kind(have) + " into " + with_its_kind(want) + ".",
            std::nullopt};
  }
  if (in_a_return(said)) {
    constexpr std::array<std::string_view, 6> nothings{
        "bool", "int", "long", "long int", "std::nullptr_t", "nullptr_t"};
    const bool nothing = want.starts_with("std::optional<") && lists(nothings, have);
    return {"wrong-type-returned",
            "The function returns " + want + ", and this is of type " + have + "." +
                (nothing ? " For nothing, write std::nullopt." : ""),
            std::nullopt};
  }
  return {"wrong-type", "This is of type " + have + ", and what is asked for is " + want + ".",
          std::nullopt};
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
  return {"wrong-type-passed",
          (function.empty() ? "What is called here" : function) + " takes " + bare_type(to) +
              " here, and what is passed is " + bare_type(from) + ".",
          std::nullopt};
}

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
          ".",
      std::nullopt};
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
    return {"caret-for-power", "^ is no power in C++. Write x * x, or std::pow(x, 3.0).",
            std::nullopt};
  return {"wrong-operands",
          (sign.empty() ? "These do not go together: " : sign + " does not go between ") +
              bare_type(left) + " and " + bare_type(right) + ".",
          std::nullopt};
}

bool notes_say_const(const Said& said) {
  return any_note(said, "discards qualifiers") || any_note(said, "method is not marked const");
}

Mistake const_changed(const std::string& name) {
  return {"assigned-to-const",
          (name.empty() ? std::string("This") : name) +
              " is const: it can be read and not changed. Put the new value into a variable of "
              "your own.",
          std::nullopt};
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
                     (holes[0] == "normalize" ? ", or call normalized()." : "."),
                 std::nullopt};
}

std::optional<Mistake> const_passed(const Said& said, const Holes&) {
  Holes note;
  if (find_note(said, "{}in call to '{}'{}", note) != nullptr) {
    const std::string name = function_name(note[1].substr(0, note[1].find(" [with")));
    if (!name.empty() && !contains(note[1], "operator")) return const_called(said, {name});
  }
  return const_changed("");
}

// ---- Definitions -------------------------------------------------------------------------------

std::optional<Mistake> redefinition(const Said& said, const Holes& holes) {
  const std::string& what = holes[0];
  // "std::optional<...> exercise::ray_triangle(...)", "struct contact::Ray<S>", "double t" or "t".
  std::string name = contains(what, "(")   ? function_name(what)
                     : what.ends_with('>') ? short_name(bare_type(what))
                                           : what.substr(what.find_last_of(": ") + 1);
  for (const Diagnostic& note : said.diagnostic.notes) {
    if (!contains(note.message, "revious") && !contains(note.message, "declared here")) continue;
    for (const std::filesystem::path& file : contract_files(said.exercise)) {
      if (same_file(note.file, file))
        return Mistake{"redefinition",
                       name + " is defined already, in " + file.filename().string() +
                           ", which your file includes. Use that one and delete this.",
                       std::nullopt};
    }
    return Mistake{"redefinition",
                   name + " is declared twice: first in line " + std::to_string(note.line) + ".",
                   std::nullopt};
  }
  return Mistake{"redefinition", name + " is declared twice.", std::nullopt};
}

std::optional<Mistake> without_its_number(const Said& said, const Holes& holes) {
  std::string name = holes.empty() ? std::string() : short_name(bare_type(holes[0]));
  if (name.empty()) name = std::string(said.source.word_before(said.place));
  return Mistake{
      "missing-template-argument",
      name + " needs to be told of which numbers it is made: write " + name + "<double>.",
      std::nullopt};
}

// ---- Eigen -------------------------------------------------------------------------------------

// The first two different vectors or matrices that a message and its notes name.
std::vector<std::string> shapes_in(const Said& said) {
  std::string text = said.diagnostic.message;
  for (const Diagnostic& note : said.diagnostic.notes) text += " " + note.message;
  text = readable(std::move(text));
  std::vector<std::string> shapes;
  for (std::size_t at = 0; at < text.size() && shapes.size() < 2; ++at) {
    const std::string_view rest = std::string_view(text).substr(at);
    if ((!rest.starts_with("Vector") && !rest.starts_with("Matrix")) || rest.size() < 9 ||
        rest[7] != '<' || (at > 0 && is_identifier_character(text[at - 1])))
      continue;
    std::string shape(rest.substr(0, rest.find('>') + 1));
    if (shapes.empty() || shapes[0] != shape) shapes.push_back(std::move(shape));
  }
  return shapes;
}

std::optional<Mistake> eigen_sizes(const Said& said, const Holes&) {
  const std::vector<std::string> shapes = shapes_in(said);
  return Mistake{"eigen-sizes",
                 shapes.size() == 2 ? shapes[0] + " and " + shapes[1] +
                                          " are of different sizes and cannot be mixed."
                                    : "Vectors or matrices of different sizes are mixed here.",
                 std::nullopt};
}

std::optional<Mistake> eigen_types(const Said&, const Holes& holes) {
  const std::string kinds =
      holes.size() > 3 ? holes[2] + " and " + holes[3] : std::string("different kinds of numbers");
  return Mistake{"eigen-types",
                 "Vectors of " + kinds +
                     " are mixed here. Make both of double; v.cast<double>() turns one into it.",
                 std::nullopt};
}

std::optional<Mistake> eigen_product(const Said&, const Holes&) { return product_of_vectors(); }

// ---- The table ---------------------------------------------------------------------------------

/// A form of message: what it looks like, and the mistake behind it. Where `tell` is null, the
/// words are a template in which $1, $2, ... are the pattern's holes.
struct Rule {
  std::string_view pattern;
  std::string_view mistake;
  std::string_view words;
  std::optional<Mistake> (*tell)(const Said&, const Holes&) = nullptr;
};

// The first that fits counts. Both compilers' forms of one mistake stand together: g++, then
// clang++.
constexpr std::array rules{
    // What C++ does not know as a sign.
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

    // What is missing, or too much.
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

    // Names.
    Rule{"'{}' is not a member of 'std'{}", {}, {}, not_in_std},
    Rule{"no member named '{}' in namespace 'std'{}", {}, {}, not_in_std},
    Rule{"no type named '{}' in namespace 'std'{}", {}, {}, not_in_std},
    Rule{"no template named '{}' in namespace 'std'{}", {}, {}, not_in_std},
    Rule{"'{}' in namespace '{}' does not name a {}", {}, {}, not_in_namespace},
    Rule{"'{}' is not a member of '{}'{}", {}, {}, not_in_namespace},
    Rule{"no member named '{}' in namespace '{}'{}", {}, {}, not_in_namespace},
    Rule{"no type named '{}' in namespace '{}'{}", {}, {}, not_in_namespace},
    Rule{"no template named '{}' in namespace '{}'{}", {}, {}, not_in_namespace},
    Rule{"'{}' was not declared in this scope; did you mean '{}'?", {}, {}, unknown_name_suggested},
    Rule{"'{}' does not name a type; did you mean '{}'?", {}, {}, unknown_name_suggested},
    Rule{"use of undeclared identifier '{}'; did you mean '{}'?", {}, {}, unknown_name_suggested},
    Rule{"unknown type name '{}'; did you mean '{}'?", {}, {}, unknown_name_suggested},
    Rule{"no template named '{}'; did you mean '{}'?", {}, {}, unknown_name_suggested},
    Rule{"'{}' was not declared in this scope", {}, {}, unknown_name},
    Rule{"'{}' does not name a type", {}, {}, unknown_name},
    Rule{"'{}' has not been declared", {}, {}, unknown_name},
    Rule{"invalid use of non-static data member '{}'", {}, {}, unknown_name},
    Rule{"use of undeclared identifier '{}'", {}, {}, unknown_name},
    Rule{"unknown type name '{}'", {}, {}, unknown_name},
    Rule{"no template named '{}'", {}, {}, unknown_name},
    Rule{"{}: No such file or directory", {}, {}, no_such_header},
    Rule{"'{}' file not found", {}, {}, no_such_header},

    // Members.
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

    // Types.
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

    // Definitions.
    Rule{"ambiguating new declaration of '{}'", "another-return-type",
         "The contract declares this function with another return type."},
    Rule{"functions that differ only in their return type cannot be overloaded",
         "another-return-type", "The contract declares this function with another return type."},
    Rule{"redefinition of '{}' {}", {}, {}, redefinition},
    Rule{"redefinition of '{}'", {}, {}, redefinition},
    Rule{"redeclaration of '{}'", {}, {}, redefinition},
    Rule{"conflicting declaration '{}'", {}, {}, redefinition},
    Rule{"declaration of '{}' shadows a parameter", {}, {}, redefinition},
    Rule{"template placeholder type '{}' must be followed by{}", {}, {}, without_its_number},
    Rule{"cannot form reference to deduced class template specialization type",
         {},
         {},
         without_its_number},
    Rule{"use of class template '{}' requires template arguments{}", {}, {}, without_its_number},
    Rule{"invalid use of template-name '{}' without an argument list", {}, {}, without_its_number},

    // Eigen says in capitals what is wrong.
    Rule{"{}YOU_MIXED_MATRICES_OF_DIFFERENT_SIZES{}", {}, {}, eigen_sizes},
    Rule{"{}YOU_MIXED_DIFFERENT_NUMERIC_TYPES{}", {}, {}, eigen_types},
    Rule{"{}INVALID_VECTOR_VECTOR_PRODUCT{}", {}, {}, eigen_product},

    // Warnings: it compiles, and is hardly what was meant.
    Rule{"comparisons like '{}' do not have{}", "chained-comparison",
         "Two comparisons cannot stand in a row: for a <= b <= c, write a <= b && b <= c."},
    Rule{"chained comparison '{}' does not{}", "chained-comparison",
         "Two comparisons cannot stand in a row: for a <= b <= c, write a <= b && b <= c."},
    Rule{"infinite recursion detected{}", "endless-recursion",
         "This function always calls itself and never returns."},
    Rule{"all paths through this function will call itself{}", "endless-recursion",
         "This function always calls itself and never returns."},
    Rule{"suggest parentheses around assignment used as truth value{}", "assignment-for-comparison",
         "One = assigns. To compare, write ==."},
    Rule{"using the result of an assignment as a condition without parentheses{}",
         "assignment-for-comparison", "One = assigns. To compare, write ==."},
    Rule{"suggest braces around empty body in an '{}' statement{}", "empty-body",
         "The ; ends the $1 here, so that what follows runs in any case."},
    Rule{"{} statement has empty body{}", "empty-body",
         "The ; ends the $1 here, so that what follows runs in any case."},
    Rule{"{} loop has empty body{}", "empty-body",
         "The ; ends the $1 here, so that what follows runs in any case."},
    Rule{"this '{}' clause does not guard{}", "misleading-indentation",
         "Only the first statement after this $1 depends on it. Put braces { } around all that "
         "do."},
    Rule{"misleading indentation; {}", "misleading-indentation",
         "This looks as if it depended on what stands above, and does not. Put braces { } around "
         "all that does."},
    Rule{"'{}' is used uninitialized{}", "uninitialised",
         "$1 has no value yet where it is used here: give it one where it is declared."},
    Rule{"'{}' may be used uninitialized{}", "uninitialised",
         "$1 may have no value yet where it is used here: give it one where it is declared."},
    Rule{"variable '{}' is uninitialized when {}", "uninitialised",
         "$1 has no value yet where it is used here: give it one where it is declared."},
    Rule{"variable '{}' is used uninitialized whenever{}", "uninitialised",
         "$1 may have no value yet where it is used here: give it one where it is declared."},
    Rule{
        "conversion from '{}' to '{}' may change {}", "narrowing",
        "Turning $1 into $2 may lose a part of the number: the digits after the point, or a number "
        "too large."},
    Rule{
        "implicit conversion turns floating-point number into integer: '{}' to '{}'{}", "narrowing",
        "Turning $1 into $2 may lose a part of the number: the digits after the point, or a number "
        "too large."},
    Rule{
        "implicit conversion loses {}: '{}' to '{}'{}", "narrowing",
        "Turning $2 into $3 may lose a part of the number: the digits after the point, or a number "
        "too large."},
    Rule{"comparison of integer expressions of different signedness: '{}' and '{}'{}",
         "signed-compared",
         "$1 can be negative and $2 cannot, or the other way round. Compare with "
         "static_cast<int>(...), or let both be of one type."},
    Rule{"comparison of integers of different signs: '{}' and '{}'{}", "signed-compared",
         "$1 can be negative and $2 cannot, or the other way round. Compare with "
         "static_cast<int>(...), or let both be of one type."},
    Rule{"unused variable '{}'{}", "unused", "$1 is never used."},
    Rule{"variable '{}' set but not used{}", "unused", "$1 gets a value and is never used."},
    Rule{"declaration of '{}' shadows {}", "shadowed",
         "There is a $1 already, declared further out: from here on this one hides it."},
    Rule{"declaration shadows {}", "shadowed",
         "A variable of this name is declared further out: from here on this one hides it."},
    Rule{"statement has no effect{}", "no-effect", "This computes something and drops it."},
    Rule{"value computed is not used{}", "no-effect", "This computes something and drops it."},
    Rule{"{} result unused{}", "no-effect", "This computes something and drops it."},
};

std::string filled(std::string_view words, const Holes& holes) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::size_t hole = words[i] == '$' && i + 1 < words.size()
                                 ? static_cast<std::size_t>(words[i + 1] - '1')
                                 : holes.size();
    if (hole < holes.size()) {
      text += bare_type(holes[hole]);
      ++i;
    } else {
      text += words[i];
    }
  }
  return text;
}

std::optional<Mistake> recognise_message(const Said& said) {
  const std::string message =
      with_plain_quotes(without_aliases(with_vectors(said.diagnostic.message)));
  for (const Rule& rule : rules) {
    Holes holes;
    if (!matches(rule.pattern, message, holes)) continue;
    if (rule.tell == nullptr)
      return Mistake{std::string(rule.mistake), filled(rule.words, holes), std::nullopt};
    if (std::optional<Mistake> mistake = rule.tell(said, holes)) return mistake;
  }
  return std::nullopt;
}

// Where the contract writes Eigen::Vector3d, so does the message.
void name_vectors(std::string& words, const Exercise& exercise) {
  for (const std::string_view size : {"2", "3", "4"}) {
    const std::string name = "Vector" + std::string(size);
    if (!contains(words, name + "<double>") || !mentions(exercise.contract, "Eigen::" + name + "d"))
      continue;
    replace_all(words, "Eigen::" + name + "<double>", name + "<double>");
    replace_all(words, name + "<double>", "Eigen::" + name + "d");
  }
}

}  // namespace

std::string with_vectors(std::string message) {
  constexpr std::string_view start = "cross_product_return_type<";
  for (std::size_t at = 0; (at = message.find(start, at)) != std::string::npos; ++at) {
    const std::size_t end = end_of_brackets(message, at + start.size() - 1);
    const std::size_t factor = message.find("Matrix<", at);
    constexpr std::string_view member = "::type";
    if (factor >= end || message.compare(end, member.size(), member) != 0) continue;
    const std::size_t open = factor + std::string_view("Matrix").size();
    const std::string vector =
        "Eigen::" + message.substr(factor, end_of_brackets(message, open) - factor);
    const std::size_t quote = message.find_last_of("'\x98", at);
    const std::size_t begin = quote == std::string::npos ? at : quote + 1;
    message.replace(begin, end + member.size() - begin, vector);
    at = begin;
  }
  return message;
}

std::optional<Mistake> recognise(const Said& said) {
  std::optional<Mistake> mistake = recognise_message(said);
  if (mistake) name_vectors(mistake->words, said.exercise);
  return mistake;
}
bool derails(const std::string& mistake) {
  constexpr std::array<std::string_view, 8> derailing{
      "stray-character",   "unfinished-text",     "unfinished-comment", "semicolon-after-head",
      "missing-semicolon", "missing-parenthesis", "missing-brace",      "extra-brace"};
  return lists(derailing, mistake);
}

std::optional<Mistake> recognise_link(const LinkFaults& faults, const SourceText& source,
                                      const Exercise& exercise) {
  const std::vector<FunctionDefinition> defined = source.definitions();
  for (const std::string& symbol : faults.twice) {
    if (symbol == "main" || symbol.starts_with("__main") || symbol.starts_with("main("))
      return Mistake{"main-defined", "The tests bring their own main(): yours must go.",
                     std::nullopt};
    return Mistake{
        "defined-twice",
        "The tests or the book define " + function_name(symbol) + " too: give yours another name.",
        std::nullopt};
  }
  for (const std::string& symbol : faults.missing) {
    const std::string name = function_name(symbol);
    const std::string qualified = symbol.substr(0, symbol.find('('));
    if (!declaration_of(exercise.contract, name))
      return Mistake{"undefined-function",
                     name + " is declared and called, but your file does not define it.",
                     std::nullopt};
    std::vector<std::string> others;
    for (const FunctionDefinition& other : defined) {
      if (other.qualified == qualified)
        return Mistake{
            "another-signature",
            "Your file defines " + other.written + ", whose parameters are not the contract's.",
            Place{other.line, 1}};
      if (other.name == name)
        return Mistake{
            "outside-namespace",
            "Your file defines " + other.qualified + ", which is not in namespace exercise.",
            Place{other.line, 1}};
      if (other.qualified.starts_with("exercise::") &&
          !declaration_of(exercise.contract, other.name))
        others.push_back(other.name);
    }
    if (const std::vector<std::string> near = nearest(name, others); !near.empty()) {
      const auto meant =
          std::find_if(defined.begin(), defined.end(),
                       [&](const FunctionDefinition& other) { return other.name == near.front(); });
      return Mistake{"misspelt-function",
                     "Your file defines " + near.front() +
                         ", which the contract does not name: is it " + name + ", misspelt?",
                     Place{meant->line, 1}};
    }
    return Mistake{"function-missing",
                   "The contract asks for " + name + ", and your file does not define it.",
                   std::nullopt};
  }
  return std::nullopt;
}

}  // namespace contact::grading
