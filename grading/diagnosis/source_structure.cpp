// The functions and braces of a student's file, found in one pass each.

#include <algorithm>
#include <cctype>
#include <utility>

#include "message_text.hpp"
#include "source_text.hpp"

namespace contact::grading {

namespace {

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

// Reads the code of a file and notes each function body that opens outside any other. What it keeps
// of a scope or a head is bounded, however deep and long they are.
class DefinitionReader {
 public:
  explicit DefinitionReader(std::vector<FunctionDefinition>& found) : found_(found) {}

  void take(char c, int line) {
    if (c == '{') {
      open();
    } else if (c == '}') {
      close();
    } else if (c == ';' && outside()) {
      start();
    } else if (outside()) {
      if (head_.empty() && c == ' ') return;
      if (head_.empty()) line_ = line;
      if (head_.size() < max_line_bytes) head_ += c;
    }
  }

 private:
  [[nodiscard]] bool outside() const { return inside_ == 0; }

  void start() { head_.clear(); }

  void open() {
    if (!outside()) {
      ++inside_;
      return;
    }
    const std::string head = on_one_line(head_);
    start();
    if (head == "namespace" || head.starts_with("namespace ") ||
        head.starts_with("inline namespace")) {
      std::string name = head.substr(head.find("namespace") + 9);
      name.erase(0, std::min(name.find_first_not_of(' '), name.size()));
      enter(name);
    } else if (head.starts_with("extern \"")) {
      enter("");
    } else {
      note_function(head);
      ++inside_;
    }
  }

  void close() {
    if (inside_ > 0)
      --inside_;
    else if (!prefixes_.empty())
      prefixes_.pop_back();
    start();
  }

  // A name that does not fit any more is none: it can be no function of a contract.
  void enter(const std::string& name) {
    std::uint16_t size = prefix_size();
    bool fits = prefixes_.empty() || prefixes_.back().fits;
    if (fits && !name.empty()) {
      fits = size + name.size() + 2 <= max_name_bytes;
      if (fits) {
        prefix_.resize(size);
        prefix_ += name + "::";
        size = static_cast<std::uint16_t>(prefix_.size());
      }
    }
    prefixes_.push_back({size, fits});
  }

  [[nodiscard]] std::uint16_t prefix_size() const {
    return prefixes_.empty() ? std::uint16_t{0} : prefixes_.back().size;
  }

  void note_function(const std::string& head) {
    if (found_.size() >= max_definitions) return;
    const std::size_t open = head.find('(');
    const std::size_t close = head.rfind(')');
    if (open == std::string::npos || close == std::string::npos || close < open) return;
    std::size_t end = open;
    while (end > 0 && head[end - 1] == ' ') --end;
    std::size_t begin = end;
    while (begin > 0 && (is_identifier_character(head[begin - 1]) || head[begin - 1] == ':'))
      --begin;
    if (begin == end || head.find('=') < open) return;
    const std::string_view name = std::string_view(head).substr(begin, end - begin);
    const std::size_t colon = name.rfind(':');
    FunctionDefinition function;
    function.name = std::string(
        name.substr(colon == std::string_view::npos ? 0 : colon + 1).substr(0, max_name_bytes));
    function.written = head.substr(begin, std::min(close + 1 - begin, 4 * max_name_bytes));
    function.line = line_;
    const bool fits = prefixes_.empty() || prefixes_.back().fits;
    if (fits && prefix_size() + name.size() <= 2 * max_name_bytes)
      function.qualified = prefix_.substr(0, prefix_size()) + std::string(name);
    found_.push_back(std::move(function));
  }

  /// What the namespaces around here are called together is the beginning of prefix_.
  struct Prefix {
    std::uint16_t size = 0;
    bool fits = true;
  };

  std::vector<FunctionDefinition>& found_;
  std::string prefix_;
  std::vector<Prefix> prefixes_;
  std::size_t inside_ = 0;  ///< braces open that are no namespace's
  std::string head_;
  int line_ = 0;
};

bool begins_namespace(std::string_view code) {
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

void SourceText::read_definitions(Structure& found) const {
  DefinitionReader reader(found.definitions);
  for (int number = 1; number <= line_count(); ++number) {
    for (const char c : whole_code(number)) reader.take(c, number);
    reader.take(' ', number);
  }
}

void SourceText::read_braces(Structure& found) const {
  /// A line in which a statement begins, or a brace opens.
  struct Begun {
    int line = 0;
    std::size_t indented = 0;
    bool is_namespace = false;
  };
  struct Opened {
    int line = 0;
    Begun statement;
  };
  std::vector<Opened> open;
  std::optional<std::size_t> function;  // of what is open, the first that is no namespace
  Begun statement;                      // line 0: none has begun
  bool unclosed_is_known = false;
  const auto lacks_its_own = [&](const Opened& opened) {
    if (!unclosed_is_known) found.unclosed = opened.line;
    unclosed_is_known = true;
  };
  for (int number = 1; number <= line_count(); ++number) {
    const std::string_view text = whole_code(number);
    const std::size_t indented = std::min(text.find_first_not_of(" \t"), text.size());
    const Begun here{number, indented, begins_namespace(text.substr(indented))};
    for (std::size_t i = indented; i < text.size(); ++i) {
      const char c = text[i];
      if (c == ' ' || c == '\t') continue;
      if (statement.line == 0) statement = here;
      if (c == '{') {
        if (function)
          found.braces.push_back(
              {{number, static_cast<int>(i) + 1}, {open[*function].line, statement.line}});
        else if (!statement.is_namespace)
          function = open.size();
        open.push_back({number, statement});
      }
      if (c == '}' && !open.empty()) {
        // A brace that stands first in its line closes what begins as far in as it does.
        const Opened& last = open.back();
        const bool first = i == indented;
        if (first && last.line != number && last.statement.indented > i) lacks_its_own(last);
        if (first && !last.statement.is_namespace && says_namespace(line(number)))
          lacks_its_own(last);
        open.pop_back();
        if (function && open.size() == *function) function.reset();
      }
      if (c == '{' || c == '}' || c == ';') statement = {};
    }
  }
  if (!open.empty()) lacks_its_own(open.back());
}

}  // namespace contact::grading
