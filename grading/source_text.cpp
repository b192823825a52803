#include "source_text.hpp"

#include <algorithm>
#include <cctype>

#include "build_text.hpp"

namespace contact::grading {

namespace {

bool is_continuation(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

// Blanks for comments, for what stands in quotes (the quotes stay) and for preprocessor lines.
std::vector<std::string> only_code(const std::vector<std::string>& lines) {
  std::vector<std::string> result;
  bool in_comment = false;
  for (const std::string& line : lines) {
    std::string code(line.size(), ' ');
    const std::size_t first = line.find_first_not_of(" \t");
    const bool directive = !in_comment && first != std::string::npos && line[first] == '#';
    char quote = '\0';
    for (std::size_t i = 0; !directive && i < line.size(); ++i) {
      const std::string_view two = std::string_view(line).substr(i, 2);
      if (in_comment) {
        if (two != "*/") continue;
        in_comment = false;
        ++i;
      } else if (quote != '\0') {
        if (line[i] == '\\') {
          ++i;
        } else if (line[i] == quote) {
          code[i] = quote;
          quote = '\0';
        }
      } else if (two == "//") {
        break;
      } else if (two == "/*") {
        in_comment = true;
        ++i;
      } else {
        code[i] = line[i];
        // 1'000 is a number.
        const bool digit = i > 0 && std::isdigit(static_cast<unsigned char>(line[i - 1])) != 0;
        if (line[i] == '"' || (line[i] == '\'' && !digit)) quote = line[i];
      }
    }
    result.push_back(std::move(code));
  }
  return result;
}

std::string on_one_line(std::string_view text) {
  std::string result;
  for (const char c : text) {
    const bool blank = std::isspace(static_cast<unsigned char>(c)) != 0;
    if (!blank)
      result += c;
    else if (!result.empty() && result.back() != ' ' && result.back() != '(')
      result += ' ';
  }
  while (!result.empty() && result.back() == ' ') result.pop_back();
  return result;
}

// Reads the code of a file and notes each function body that opens outside any other.
class DefinitionReader {
 public:
  void take(char c, int line) {
    if (c == '{') {
      open();
    } else if (c == '}') {
      if (!scopes_.empty()) scopes_.pop_back();
      start();
    } else if (c == ';' && outside()) {
      start();
    } else if (outside()) {
      if (head_.empty() && c == ' ') return;
      if (head_.empty()) line_ = line;
      head_ += c;
    }
  }
  [[nodiscard]] std::vector<FunctionDefinition>& found() { return found_; }

 private:
  struct Scope {
    bool is_namespace = false;
    std::string name;
  };

  [[nodiscard]] bool outside() const {
    return std::all_of(scopes_.begin(), scopes_.end(),
                       [](const Scope& scope) { return scope.is_namespace; });
  }

  void start() { head_.clear(); }

  void open() {
    Scope scope;
    if (outside()) {
      const std::string head = on_one_line(head_);
      if (head == "namespace" || head.starts_with("namespace ") ||
          head.starts_with("inline namespace")) {
        scope.is_namespace = true;
        scope.name = head.substr(head.find("namespace") + 9);
        scope.name.erase(0, scope.name.find_first_not_of(' '));
      } else if (head.starts_with("extern \"")) {
        scope.is_namespace = true;
      } else {
        note_function(head);
      }
    }
    scopes_.push_back(std::move(scope));
    start();
  }

  void note_function(const std::string& head) {
    const std::size_t open = head.find('(');
    const std::size_t close = head.rfind(')');
    if (open == std::string::npos || close == std::string::npos || close < open) return;
    std::size_t end = open;
    while (end > 0 && head[end - 1] == ' ') --end;
    std::size_t begin = end;
    while (begin > 0 && (is_identifier_character(head[begin - 1]) || head[begin - 1] == ':'))
      --begin;
    if (begin == end || head.find('=') < open) return;
    FunctionDefinition function;
    function.qualified = head.substr(begin, end - begin);
    const std::size_t colon = function.qualified.rfind(':');
    function.name =
        colon == std::string::npos ? function.qualified : function.qualified.substr(colon + 1);
    function.written = head.substr(begin, close + 1 - begin);
    function.line = line_;
    for (auto scope = scopes_.rbegin(); scope != scopes_.rend(); ++scope) {
      if (!scope->name.empty()) function.qualified = scope->name + "::" + function.qualified;
    }
    found_.push_back(std::move(function));
  }

  std::vector<Scope> scopes_;
  std::string head_;
  int line_ = 0;
  std::vector<FunctionDefinition> found_;
};

std::size_t indentation(std::string_view line) {
  return std::min(line.find_first_not_of(" \t"), line.size());
}

bool begins_namespace(std::string_view line) {
  const std::string_view code = line.substr(indentation(line));
  return code.starts_with("namespace") || code.starts_with("inline namespace") ||
         code.starts_with("extern \"");
}

// "}  // namespace exercise": what it closes is said behind it.
bool says_namespace(std::string_view line) {
  const std::size_t comment = line.find("//");
  return comment != std::string_view::npos &&
         line.find("namespace", comment) != std::string_view::npos;
}

}  // namespace

SourceText::SourceText(std::string_view text)
    : lines_(split_lines(text)), code_(only_code(lines_)) {}

std::string_view SourceText::line(int number) const {
  if (number < 1 || number > line_count()) return {};
  return lines_[static_cast<std::size_t>(number) - 1];
}

std::string_view SourceText::code(int number) const {
  if (number < 1 || number > line_count()) return {};
  return code_[static_cast<std::size_t>(number) - 1];
}

int SourceText::byte_column(Place place, Columns columns) const {
  if (columns == Columns::bytes) return place.column;
  const std::string_view text = line(place.line);
  int shown = 0;
  int bytes = 0;
  for (const char c : text) {
    if (!is_continuation(c)) {
      if (shown + 1 >= place.column) return bytes + 1;
      shown = c == '\t' ? (shown / 8 + 1) * 8 : shown + 1;
    }
    ++bytes;
  }
  return bytes + std::max(place.column - shown, 1);
}

int SourceText::character_column(Place place) const {
  const std::string_view text = line(place.line);
  const auto bytes = std::min(static_cast<std::size_t>(std::max(place.column - 1, 0)), text.size());
  const auto more = std::count_if(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(bytes),
                                  is_continuation);
  return place.column - static_cast<int>(more);
}

std::string_view SourceText::word_at(Place place) const {
  const std::string_view text = line(place.line);
  const auto begin = static_cast<std::size_t>(std::max(place.column - 1, 0));
  std::size_t end = begin;
  while (end < text.size() && is_identifier_character(text[end])) ++end;
  return begin < end ? text.substr(begin, end - begin) : std::string_view();
}

std::string_view SourceText::word_before(Place place) const {
  const std::string_view text = line(place.line);
  std::size_t end = std::min(static_cast<std::size_t>(std::max(place.column - 1, 0)), text.size());
  while (end > 0 && !is_identifier_character(text[end - 1])) --end;
  std::size_t begin = end;
  while (begin > 0 && is_identifier_character(text[begin - 1])) --begin;
  return text.substr(begin, end - begin);
}

std::string_view SourceText::sign_at(Place place) const {
  const std::string_view text = line(place.line);
  const std::size_t begin = text.find_first_not_of(
      " \t", std::min(static_cast<std::size_t>(std::max(place.column - 1, 0)), text.size()));
  if (begin == std::string_view::npos) return {};
  std::size_t end = begin + 1;
  while (end < text.size() && is_continuation(text[end])) ++end;
  return text.substr(begin, end - begin);
}

Place SourceText::end_of_code_before(Place place) const {
  std::string_view text =
      code(place.line)
          .substr(0, std::min(static_cast<std::size_t>(std::max(place.column - 1, 0)),
                              code(place.line).size()));
  for (int number = place.line; number >= 1; text = code(--number)) {
    const std::size_t last = text.find_last_not_of(" \t");
    if (last != std::string_view::npos) return {number, static_cast<int>(last) + 2};
  }
  return place;
}

bool SourceText::includes(std::string_view header) const {
  return std::any_of(lines_.begin(), lines_.end(), [&](const std::string& text) {
    const std::size_t first = text.find_first_not_of(" \t");
    if (first == std::string::npos || text[first] != '#') return false;
    const std::size_t name = text.find(header);
    return text.find("include") < name && name != std::string::npos;
  });
}

std::vector<FunctionDefinition> SourceText::definitions() const {
  DefinitionReader reader;
  for (int number = 1; number <= line_count(); ++number) {
    for (const char c : code(number)) reader.take(c, number);
    reader.take(' ', number);
  }
  return std::move(reader.found());
}

std::optional<int> SourceText::unclosed_brace() const {
  struct Opened {
    int line;
    std::size_t indented;
    bool is_namespace;
  };
  std::vector<Opened> open;
  int statement = 0;  // the line where what may end in a brace begins
  for (int number = 1; number <= line_count(); ++number) {
    const std::string_view text = code(number);
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (text[i] == ' ' || text[i] == '\t') continue;
      if (statement == 0) statement = number;
      if (text[i] == '{')
        open.push_back({number, indentation(code(statement)), begins_namespace(code(statement))});
      if (text[i] == '}' && !open.empty()) {
        // A brace that stands first in its line closes what begins as far in as it does.
        const bool first = i == indentation(text);
        if (first && open.back().line != number && open.back().indented > i)
          return open.back().line;
        if (first && says_namespace(line(number)) && !open.back().is_namespace)
          return open.back().line;
        open.pop_back();
      }
      if (text[i] == '{' || text[i] == '}' || text[i] == ';') statement = 0;
    }
  }
  return open.empty() ? std::nullopt : std::optional<int>(open.back().line);
}

std::optional<OpenFunction> SourceText::open_function(Place brace) const {
  struct Opened {
    int line;
    bool is_namespace;
  };
  std::vector<Opened> open;
  int statement = 0;
  for (int number = 1; number <= brace.line; ++number) {
    const std::string_view text = code(number);
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (text[i] == ' ' || text[i] == '\t') continue;
      if (statement == 0) statement = number;
      if (number == brace.line && static_cast<int>(i) + 1 == brace.column) {
        const auto function = std::find_if(
            open.begin(), open.end(), [](const Opened& opened) { return !opened.is_namespace; });
        if (function == open.end()) return std::nullopt;
        return OpenFunction{function->line, statement};
      }
      if (text[i] == '{') open.push_back({number, begins_namespace(code(statement))});
      if (text[i] == '}' && !open.empty()) open.pop_back();
      if (text[i] == '{' || text[i] == '}' || text[i] == ';') statement = 0;
    }
  }
  return std::nullopt;
}

std::optional<FunctionDefinition> SourceText::function_around(int line) const {
  std::optional<FunctionDefinition> around;
  std::vector<FunctionDefinition> defined = definitions();
  for (FunctionDefinition& function : defined) {
    if (function.line <= line) around = std::move(function);
  }
  return around;
}

}  // namespace contact::grading
