#include "compiler_messages.hpp"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <optional>

#include "message_text.hpp"

namespace contact::grading {

namespace {

constexpr std::size_t max_file_name = 1024;
constexpr std::size_t max_excerpt_line = 400;
constexpr int max_excerpt_lines = 6;
constexpr std::size_t max_symbol = 1000;

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

// Takes a number from the start of a text; one that is too large becomes max_claimed.
std::optional<int> take_number(std::string_view& text) {
  if (text.empty() || !is_digit(text.front())) return std::nullopt;
  std::int64_t number = 0;
  for (; !text.empty() && is_digit(text.front()); text.remove_prefix(1))
    number = std::min<std::int64_t>(10 * number + (text.front() - '0'), max_claimed);
  return static_cast<int>(number);
}

bool take(std::string_view& text, std::string_view start) {
  if (!text.starts_with(start)) return false;
  text.remove_prefix(start.size());
  return true;
}

struct Range {
  int line = 0;
  int column = 0;
  int end_line = 0;
  int end_column = 0;
};

// "LINE:COLUMN-LINE:COLUMN}"
std::optional<Range> take_range(std::string_view& text) {
  const std::optional<int> line = take_number(text);
  if (!line || !take(text, ":")) return std::nullopt;
  const std::optional<int> column = take_number(text);
  if (!column || !take(text, "-")) return std::nullopt;
  const std::optional<int> end_line = take_number(text);
  if (!end_line || !take(text, ":")) return std::nullopt;
  const std::optional<int> end_column = take_number(text);
  if (!end_column || !take(text, "}")) return std::nullopt;
  return Range{*line, *column, *end_line, *end_column};
}

// "FILE:LINE:COLUMN:{RANGE}{RANGE}: REST", the column and the ranges (clang++'s) if there are any.
bool parse_head(std::string_view text, Diagnostic& head, std::string_view& rest) {
  if (text.empty() || text.front() == ' ' || text.front() == '\t') return false;
  const std::size_t colon = text.find(':');
  if (colon == 0 || colon == std::string_view::npos || colon > max_file_name) return false;
  head.file = std::string(text.substr(0, colon));
  text.remove_prefix(colon + 1);
  const std::optional<int> line = take_number(text);
  if (!line || !take(text, ":")) return false;
  head.line = *line;
  if (const std::optional<int> column = take_number(text)) {
    head.column = *column;
    if (!take(text, ":")) return false;
  }
  bool ranges = false;
  while (take(text, "{")) {
    const std::optional<Range> range = take_range(text);
    if (!range) return false;
    ranges = true;
    if (range->line == head.line && range->column <= head.column &&
        (range->end_line > head.line || range->end_column > head.column)) {
      head.end_line = range->end_line;
      head.end_column = range->end_column;
    }
  }
  if (ranges && !take(text, ":")) return false;
  if (!take(text, " ")) return false;
  rest = text;
  return true;
}

// "   12 | source" or "      | caret".
bool is_excerpt(std::string_view line) {
  const std::size_t bar = line.find(" |");
  return bar != std::string_view::npos &&
         std::all_of(line.begin(), line.begin() + static_cast<std::ptrdiff_t>(bar),
                     [](char c) { return c == ' ' || is_digit(c) || c == '+'; });
}

// g++ gives no ranges; the underlining below the source says as much: "~~^~~".
void take_underline(std::string_view line, Diagnostic& diagnostic) {
  if (diagnostic.end_column != 0) return;
  const std::size_t bar = line.find("| ");
  const std::size_t caret = line.find('^');
  if (bar == std::string_view::npos || caret == std::string_view::npos ||
      caret != bar + 1 + static_cast<std::size_t>(diagnostic.column))
    return;
  std::size_t end = caret + 1;
  while (end < line.size() && line[end] == '~') ++end;
  diagnostic.end_line = diagnostic.line;
  diagnostic.end_column = diagnostic.column + static_cast<int>(end - caret);
}

bool contains(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

}  // namespace

Diagnostics parse_diagnostics(std::string_view text) {
  Diagnostics result;
  std::vector<Diagnostic>& messages = result.messages;
  std::vector<Step> required_from;
  Diagnostic* latest = nullptr;  // where excerpt lines belong
  int excerpt_lines = 0;
  for (const std::string& line : split_lines(text)) {
    if (is_excerpt(line)) {
      if (latest == nullptr || ++excerpt_lines > max_excerpt_lines) continue;
      take_underline(line, *latest);
      latest->excerpt += (latest->excerpt.empty() ? "" : "\n") + cut(line, max_excerpt_line);
      continue;
    }
    Diagnostic diagnostic;
    std::string_view rest;
    if (!parse_head(line, diagnostic, rest)) continue;
    latest = nullptr;
    excerpt_lines = 0;
    for (const char* severity : {"fatal error", "error", "warning", "note"}) {
      if (take(rest, std::string(severity) + ": ")) {
        diagnostic.severity = severity;
        break;
      }
    }
    if (diagnostic.severity.empty()) {
      if ((contains(rest, "required from") || contains(rest, "required by")) &&
          required_from.size() < max_notes)
        required_from.push_back({diagnostic.file, diagnostic.line, diagnostic.column});
      continue;
    }
    diagnostic.message = cut(rest, max_message_bytes);
    if (diagnostic.severity == "note" && !messages.empty()) {
      Diagnostic& about = messages.back();
      if (result.more > 0 || about.notes.size() >= max_notes) continue;
      if (contains(rest, "requested here") || contains(rest, "required from here"))
        about.required_from.push_back({diagnostic.file, diagnostic.line, diagnostic.column});
      about.notes.push_back(std::move(diagnostic));
      latest = &about.notes.back();
    } else if (messages.size() >= max_messages) {
      ++result.more;
    } else {
      diagnostic.required_from = std::move(required_from);
      required_from.clear();
      messages.push_back(std::move(diagnostic));
      latest = &messages.back();
    }
  }
  return result;
}

LinkFaults parse_link_faults(std::string_view text) {
  LinkFaults faults;
  const auto add = [](std::vector<std::string>& list, std::string_view name) {
    // mold names the two objects before the symbol: "FILE: FILE: main".
    for (std::size_t at; (at = name.find(": ")) != std::string_view::npos;)
      name.remove_prefix(at + 2);
    if (const std::size_t quote = name.find('\''); quote != std::string_view::npos)
      name = name.substr(0, quote);
    name = name.substr(0, max_symbol);
    if (name.empty() || name.front() == ' ' || list.size() >= max_symbols) return;
    if (std::find(list.begin(), list.end(), name) == list.end()) list.emplace_back(name);
  };
  for (const std::string& raw : split_lines(text)) {
    const std::string line = with_plain_quotes(raw);
    for (const std::string_view start : {"undefined reference to '", "undefined symbol: "}) {
      if (const std::size_t at = line.find(start); at != std::string::npos)
        add(faults.missing, std::string_view(line).substr(at + start.size()));
    }
    for (const std::string_view start : {"multiple definition of '", "duplicate symbol: "}) {
      if (const std::size_t at = line.find(start); at != std::string::npos)
        add(faults.twice, std::string_view(line).substr(at + start.size()));
    }
  }
  return faults;
}

}  // namespace contact::grading
