#include <array>
#include <cstdint>
#include <utility>

#include "../../text/near_names.hpp"
#include "../message_text.hpp"
#include "rules.hpp"

namespace contact::grading {

namespace {

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
              std::string(header) + "> at the top."};
}

}  // namespace

std::string_view last_word(std::string_view text) {
  std::size_t end = text.size();
  while (end > 0 && !is_identifier_character(text[end - 1])) --end;
  std::size_t begin = end;
  while (begin > 0 && is_identifier_character(text[begin - 1])) --begin;
  return text.substr(begin, end - begin);
}

namespace {

// "plane.d", for each parameter of which the name is a member: "a.t or b.t".
// "const contact::Ray<double>& ray" is a Ray called ray; one without a name is left out.
std::string as_member(const std::string& name, const Said& said) {
  const FunctionDefinition* const function = said.source.function_around(said.place.line);
  if (function == nullptr) return {};
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
      if (lists(said.contract.members_of(std::string(type)), name))
        text += (text.empty() ? "" : " or ") + std::string(parameter) + "." + name;
    }
    if (c == '<' || c == '(' || c == '{') ++depth;
    if (c == '>' || c == ')' || c == '}') --depth;
  }
  return text;
}

// The line of the head of the function around, if the name of a parameter is commented out there.
std::optional<int> commented_out(const std::string& name, const Said& said) {
  const FunctionDefinition* const function = said.source.function_around(said.place.line);
  if (function == nullptr) return std::nullopt;
  const int stop = std::min(said.place.line, function->line + max_lines_upwards);
  for (int line = function->line; line <= stop; ++line) {
    const std::string_view text = said.source.line(line);
    for (std::size_t at = text.find("/*"); at != std::string_view::npos;
         at = text.find("/*", at + 2)) {
      const std::size_t end = text.find("*/", at + 2);
      if (end == std::string_view::npos) break;
      std::string_view inside = text.substr(at + 2, end - at - 2);
      while (inside.starts_with(' ')) inside.remove_prefix(1);
      while (inside.ends_with(' ')) inside.remove_suffix(1);
      if (!name.empty() && inside == name) return line;
    }
    if (contains(said.source.code(line), "{")) break;
  }
  return std::nullopt;
}

constexpr std::array<std::string_view, 20> keywords{
    "return", "if",    "else",      "for",    "while", "do",      "const",
    "double", "int",   "bool",      "float",  "auto",  "break",   "void",
    "true",   "false", "constexpr", "switch", "throw", "continue"};

}  // namespace

std::string in_small_letters(std::string text) {
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return text;
}

namespace {

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
    return lists(said.contract.members_of(scope.substr(scope.rfind(':') + 1)), name);
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
  if (const std::optional<ContractLine> shape = said.contract.declaration_of(name);
      shape && shape->file != said.contract.contract().file)
    return "contact::";
  return {};
}

Mistake unknown(const std::string& name, const std::string& suggestion, const Said& said) {
  if (const std::optional<int> line = commented_out(name, said))
    return {"name-in-comment", "C++ does not know " + name +
                                   ". Its name stands in a comment on line " +
                                   std::to_string(*line) + ": take the /* and */ away."};
  if (const std::string small = in_small_letters(name); small != name && lists(keywords, small))
    return {"capital-letter",
            small + " is written small: C++ tells capital letters from small ones."};
  const std::string scope = scope_of(name, suggestion, said);
  if (!scope.empty())
    return {scope == "std::" ? "missing-std" : "missing-namespace",
            "C++ does not know " + name + " by this name alone: write " + scope + name + "."};
  std::string words = "C++ does not know the name " + name;
  const std::string_view code = said.source.code(said.place.line);
  const std::size_t after = code.find(name) == std::string_view::npos
                                ? std::string_view::npos
                                : code.find_first_not_of(' ', code.find(name) + name.size());
  const bool assigned = code.find_first_not_of(' ') == code.find(name) &&
                        after != std::string_view::npos && code[after] == '=' &&
                        code.substr(after, 2) != "==";
  if (const std::string member = as_member(name, said); !assigned && !member.empty())
    return {"unknown-name", words + " by itself: write " + member + "."};
  if (const std::string counter = counter_of(name, code); !counter.empty())
    return {"unknown-name", words + ". If it is new here, its type comes first: " + counter + "."};
  if (!suggestion.empty() && !suggestion.starts_with("std::") &&
      !suggestion.ends_with("::" + name)) {
    words += ": is it " + suggestion + ", misspelt?";
    return {"unknown-name", words};
  }
  words += assigned ? ". If it is new here, its type comes first: double " + name + " = ..."
                    : ". Is it misspelt, or not declared before this line?";
  return {"unknown-name", words};
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
                                : " here. Is it misspelt, or is its header not included?")};
}

// holes: the name, the namespace, perhaps more.
std::optional<Mistake> not_in_namespace(const Said& said, const Holes& holes) {
  if (holes[1] == "std") return not_in_std(said, {holes[0]});
  return Mistake{"unknown-name", holes[1] + " has no " + holes[0] + ": is it misspelt?"};
}

std::optional<Mistake> no_such_header(const Said& said, const Holes& holes) {
  const std::string contract = said.contract.name();
  std::string words = "There is no header " + holes[0] + ".";
  if (!nearest(holes[0], {contract}).empty()) words += " The contract is \"" + contract + "\".";
  return Mistake{"no-such-header", words};
}

constexpr std::array rules{
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
};

}  // namespace

std::span<const Rule> rules_of_names() { return rules; }

}  // namespace contact::grading
