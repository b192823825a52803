#include "message_text.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace contact::grading {

std::size_t end_of_brackets(std::string_view text, std::size_t open) {
  int depth = 0;
  for (std::size_t i = open; i < text.size(); ++i) {
    if (text[i] == '<') ++depth;
    if (text[i] == '>' && --depth == 0) return i + 1;
  }
  return text.size();
}

namespace {

std::string without_between(std::string_view text, std::string_view from, std::string_view to) {
  std::string kept;
  std::size_t begin = 0;
  while (true) {
    const std::size_t at = text.find(from, begin);
    const std::size_t end = at == std::string_view::npos ? at : text.find(to, at + from.size());
    kept += text.substr(begin, end == std::string_view::npos ? end : at - begin);
    if (end == std::string_view::npos) return kept;
    begin = end + to.size();
  }
}

// Template arguments that are there by themselves: std::vector<int, std::allocator<int>>.
void cut_default_arguments(std::string& text) {
  for (const std::string_view start : {", std::allocator<", ", std::char_traits<"}) {
    for (std::size_t at = 0; (at = text.find(start, at)) != std::string::npos;)
      text.erase(at, end_of_brackets(text, at + start.size() - 1) - at);
  }
}

std::vector<std::string> arguments_of(std::string_view list) {
  std::vector<std::string> arguments(1);
  int depth = 0;
  for (const char c : list) {
    if (c == '<') ++depth;
    if (c == '>') --depth;
    if (c == ',' && depth == 0) {
      arguments.emplace_back();
    } else if (c != ' ' || !arguments.back().empty()) {
      arguments.back() += c;
    }
  }
  return arguments;
}

// Matrix<double, 3, 1, 0, 3, 1> is a Vector3<double>; Matrix<double, 3, 3> a Matrix3<double>.
std::string matrix_name(std::string_view list) {
  const std::vector<std::string> arguments = arguments_of(list);
  if (arguments.size() < 3 || arguments[1].size() != 1 || arguments[2].size() != 1) return {};
  const std::string& rows = arguments[1];
  if (rows[0] < '2' || rows[0] > '4') return {};
  if (arguments[2] == "1") return "Vector" + rows + "<" + arguments[0] + ">";
  if (arguments[2] == rows) return "Matrix" + rows + "<" + arguments[0] + ">";
  return {};
}

// A message that names more types than this is unreadable.
constexpr int max_named_types = 200;

void name_matrices(std::string& text) {
  constexpr std::string_view start = "Matrix<";
  int named = 0;
  for (std::size_t at = 0; (at = text.find(start, at)) != std::string::npos; ++at) {
    if (at > 0 && is_identifier_character(text[at - 1])) continue;
    if (++named > max_named_types) return;
    const std::size_t open = at + start.size() - 1;
    const std::size_t end = end_of_brackets(text, open);
    if (text[end - 1] != '>') continue;
    const std::string name = matrix_name(std::string_view(text).substr(open + 1, end - open - 2));
    if (name.empty()) continue;
    constexpr std::string_view scope = "Eigen::";
    const bool scoped =
        at >= scope.size() && text.compare(at - scope.size(), scope.size(), scope) == 0;
    const std::size_t begin = scoped ? at - scope.size() : at;
    text.replace(begin, end - begin, name);
    at = begin;
  }
}

// The operands of an Eigen expression do not help a student here.
void name_expressions(std::string& text) {
  constexpr std::array<std::string_view, 10> expressions{
      "CwiseBinaryOp<", "CwiseUnaryOp<", "CwiseNullaryOp<", "CwiseTernaryOp<", "Product<",
      "Transpose<",     "VectorBlock<",  "Block<",          "Diagonal<",       "ReturnByValue<"};
  int named = 0;
  for (const std::string_view start : expressions) {
    for (std::size_t at = 0; (at = text.find(start, at)) != std::string::npos; ++at) {
      if (at > 0 && is_identifier_character(text[at - 1])) continue;
      if (++named > max_named_types) return;
      const std::size_t end = end_of_brackets(text, at + start.size() - 1);
      std::size_t begin = at;
      while (begin > 0 && (is_identifier_character(text[begin - 1]) || text[begin - 1] == ':'))
        --begin;
      text.replace(begin, end - begin, "Eigen expression");
      at = begin;
    }
  }
}

}  // namespace

std::vector<std::string> split_lines(std::string_view text) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    std::size_t length = end - at;
    if (length > 0 && text[end - 1] == '\r') --length;
    lines.emplace_back(text.substr(at, length));
    at = end + 1;
  }
  return lines;
}

bool is_identifier_character(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  std::size_t at = from.empty() ? std::string::npos : text.find(from);
  if (at == std::string::npos) return;
  std::string result;
  std::size_t begin = 0;
  for (; at != std::string::npos; at = text.find(from, begin)) {
    result.append(text, begin, at - begin).append(to);
    begin = at + from.size();
  }
  result.append(text, begin);
  text = std::move(result);
}

std::string cut(std::string_view text, std::size_t most) {
  if (text.size() <= most) return std::string(text);
  std::size_t end = most;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
  return std::string(text.substr(0, end)) + " ...";
}

std::string_view first_lines(std::string_view text, std::size_t most) {
  if (text.size() <= most) return text;
  const std::size_t end = text.rfind('\n', most - 1);
  return text.substr(0, end == std::string_view::npos ? most : end + 1);
}

// The words between two holes are looked for from the left, once; only those at the end have a
// place given. So no part of the text is read twice for a hole.
bool matches(std::string_view pattern, std::string_view text, std::vector<std::string>& holes) {
  holes.clear();
  constexpr std::string_view mark = "{}";
  std::size_t hole = pattern.find(mark);
  if (text.substr(0, std::min(hole, text.size())) != pattern.substr(0, hole)) return false;
  if (hole == std::string_view::npos) return true;
  text.remove_prefix(hole);
  while (true) {
    pattern.remove_prefix(hole + mark.size());
    hole = pattern.find(mark);
    if (hole == std::string_view::npos) break;
    const std::size_t at = text.find(pattern.substr(0, hole));
    if (at == std::string_view::npos) return false;
    holes.emplace_back(text.substr(0, at));
    text.remove_prefix(at + hole);
  }
  if (!text.ends_with(pattern)) return false;
  holes.emplace_back(text.substr(0, text.size() - pattern.size()));
  return true;
}

std::string with_plain_quotes(std::string text) {
  for (const std::string_view quote : {"\xE2\x80\x98", "\xE2\x80\x99", "`"})
    replace_all(text, quote, "'");
  return text;
}

std::string without_aliases(std::string_view text) {
  return without_between(without_between(text, " {aka ", "}"), " (aka '", "')");
}

std::string readable(std::string_view message) {
  std::string text = without_aliases(cut(message, max_message_bytes));
  for (const std::string_view kind : {"struct ", "class "}) {
    for (const std::string_view before : {"'", "\xE2\x80\x98", "const "})
      replace_all(text, std::string(before) + std::string(kind), before);
  }
  cut_default_arguments(text);
  replace_all(text, "std::__cxx11::basic_string<char>", "std::string");
  replace_all(text, "std::basic_string<char>", "std::string");
  replace_all(text, "> >", ">>");
  name_matrices(text);
  replace_all(text, "contact::Vector", "Vector");
  name_expressions(text);
  replace_all(text, "> >", ">>");
  return text;
}

std::string bare_type(std::string_view type) {
  std::string text = readable(type);
  for (const std::string_view before : {"const ", "struct ", "class "}) {
    if (text.starts_with(before)) text.erase(0, before.size());
  }
  while (!text.empty() && (text.back() == '&' || text.back() == ' ')) text.pop_back();
  if (text == "Eigen expression") return "an Eigen expression";
  return text;
}

std::vector<std::string> quoted_names(std::string_view message) {
  std::vector<std::string> names;
  bool inside = false;
  std::string name;
  for (const char c : with_plain_quotes(std::string(message)) + "'") {
    if (inside && is_identifier_character(c)) {
      name += c;
      continue;
    }
    if (!name.empty()) names.push_back(std::move(name));
    name.clear();
    if (c == '\'') inside = !inside;
  }
  return names;
}

std::string eigen_sentence(std::string_view message) {
  // The longest word of capitals, digits and at least two underscores.
  std::string best;
  std::string word;
  for (const char c : std::string(message) + " ") {
    const bool part = c == '_' || std::isupper(static_cast<unsigned char>(c)) != 0 ||
                      std::isdigit(static_cast<unsigned char>(c)) != 0;
    if (part) {
      word += c;
      continue;
    }
    if (std::count(word.begin(), word.end(), '_') >= 2 && word.size() > best.size()) best = word;
    word.clear();
  }
  if (best.empty()) return {};
  std::string sentence;
  for (const char c : best) {
    if (c != '_')
      sentence += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    else if (!sentence.empty() && sentence.back() != ' ')
      sentence += ' ';
  }
  return sentence;
}

}  // namespace contact::grading
