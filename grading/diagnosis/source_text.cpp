#include "source_text.hpp"

#include <algorithm>
#include <cctype>
#include <limits>
#include <utility>

#include "message_text.hpp"

namespace contact::grading {

namespace {

bool is_continuation(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool is_blank(char c) { return c == ' ' || c == '\t'; }

std::size_t index_before(int column) { return static_cast<std::size_t>(std::max(column - 1, 0)); }

// "7" of "7 "other.cpp"", at most `most`.
std::optional<int> take_line_number(std::string_view& text) {
  constexpr int most = std::numeric_limits<int>::max();
  if (text.empty() || !is_digit(text.front())) return std::nullopt;
  std::int64_t number = 0;
  while (!text.empty() && is_digit(text.front())) {
    number = std::min<std::int64_t>(10 * number + (text.front() - '0'), most);
    text.remove_prefix(1);
  }
  return static_cast<int>(number);
}

void skip_blanks(std::string_view& text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
}

// Blanks and comments between the tokens of a directive.
void skip_blanks_and_comments(std::string_view& text) {
  skip_blanks(text);
  while (text.starts_with("/*")) {
    const std::size_t end = text.find("*/", 2);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 2);
    skip_blanks(text);
  }
}

}  // namespace

SourceText::SourceText(std::string text) : text_(std::move(text)) {
  for (std::size_t at = 0; at < text_.size();) {
    starts_.push_back(static_cast<std::uint32_t>(at));
    at = std::min(text_.find('\n', at), text_.size()) + 1;
  }
  blank_out_what_is_not_code();
}

std::string_view SourceText::part(const std::string& of, int number, std::size_t most) const {
  if (number < 1 || number > line_count()) return {};
  const std::size_t begin = starts_[static_cast<std::size_t>(number) - 1];
  std::size_t end = number < line_count() ? starts_[static_cast<std::size_t>(number)] : of.size();
  while (end > begin && (text_[end - 1] == '\n' || text_[end - 1] == '\r')) --end;
  return std::string_view(of).substr(begin, std::min(end - begin, most));
}

std::string_view SourceText::line(int number) const { return part(text_, number, max_line_bytes); }
std::string_view SourceText::code(int number) const { return part(code_, number, max_line_bytes); }
std::string_view SourceText::whole_code(int number) const {
  return part(code_, number, std::string_view::npos);
}

// Blanks for comments, for what stands in quotes (the quotes stay) and for preprocessor lines.
void SourceText::blank_out_what_is_not_code() {
  code_.assign(text_.size(), ' ');
  bool in_comment = false;
  for (int number = 1; number <= line_count(); ++number) {
    const std::string_view line = part(text_, number, std::string_view::npos);
    const std::size_t start = starts_[static_cast<std::size_t>(number) - 1];
    bool begun = false;  // whether code of this line has been seen
    char quote = '\0';
    for (std::size_t i = 0; i < line.size(); ++i) {
      const std::string_view two = line.substr(i, 2);
      if (in_comment) {
        if (two != "*/") continue;
        in_comment = false;
        ++i;
      } else if (quote != '\0') {
        if (line[i] == '\\') {
          ++i;
        } else if (line[i] == quote) {
          code_[start + i] = quote;
          quote = '\0';
        }
      } else if (two == "//") {
        break;
      } else if (two == "/*") {
        in_comment = true;
        ++i;
      } else if (!begun && (line[i] == '#' || two == "%:")) {
        note_directive(number, line.substr(i + (line[i] == '#' ? 1 : 2)));
        break;
      } else {
        code_[start + i] = line[i];
        begun = begun || !is_blank(line[i]);
        // 1'000 is a number.
        const bool digit = i > 0 && is_digit(line[i - 1]);
        if (line[i] == '"' || (line[i] == '\'' && !digit)) quote = line[i];
      }
    }
  }
}

// ---- Lines that are counted otherwise ---------------------------------------------------------

// Also "# 7", which is what a preprocessor writes. A number that is a macro, or a directive that
// goes on in the next line, cannot be followed: nothing after it has a number that can be believed.
void SourceText::note_directive(int number, std::string_view line) {
  skip_blanks_and_comments(line);
  std::size_t letters = 0;
  while (letters < line.size() && is_identifier_character(line[letters])) ++letters;
  const bool named = line.substr(0, letters) == "line";
  const bool marker = !line.empty() && is_digit(line.front());
  const bool goes_on = line.ends_with('\\') && (letters == 0 || line.size() == letters + 1);
  if (!named && !marker && !goes_on) return;
  LineDirective directive;
  directive.line = number;
  if (named) line.remove_prefix(letters);
  skip_blanks_and_comments(line);
  const std::optional<int> first = take_line_number(line);
  directive.first = first ? *first : -1;
  skip_blanks_and_comments(line);
  const std::size_t end = line.find('"', 1);
  if (line.starts_with('"') && end != std::string_view::npos)
    directive.file = std::string(line.substr(1, std::min(end - 1, max_line_bytes)));
  else if (!directives_.empty())
    directive.file = directives_.back().file;
  directives_.push_back(std::move(directive));
}

bool SourceText::goes_by_name(std::string_view file) const {
  return std::any_of(directives_.begin(), directives_.end(), [&](const LineDirective& directive) {
    return !directive.file.empty() && directive.file == file;
  });
}

int SourceText::physical_line(std::string_view file, bool own, int line) const {
  const std::int64_t last = line_count() + 1;
  std::int64_t found = 0;
  // Lines `from` to `to` count from `first`.
  const auto look = [&](std::int64_t from, std::int64_t to, std::int64_t first, bool named) {
    const std::int64_t physical = from + line - first;
    if (!named || physical < from || physical > to) return true;
    if (found != 0) return false;
    found = physical;
    return true;
  };
  for (const LineDirective& directive : directives_) {
    if (directive.first < 0) return 0;
  }
  std::int64_t from = 1;
  std::int64_t first = 1;
  bool named = own;
  for (const LineDirective& directive : directives_) {
    if (!look(from, directive.line - 1, first, named)) return 0;
    from = directive.line + 1;
    first = directive.first;
    named = directive.file.empty() ? own : directive.file == file;
  }
  if (!look(from, last, first, named)) return 0;
  return static_cast<int>(found);
}

// ---- Columns ----------------------------------------------------------------------------------

int SourceText::byte_column(Place place, Columns columns) const {
  const std::string_view text = line(place.line);
  if (place.column < 1) return 0;
  if (columns == Columns::bytes)
    return index_before(place.column) <= text.size() ? place.column : 0;
  int shown = 0;
  int bytes = 0;
  for (const char c : text) {
    if (!is_continuation(c)) {
      if (shown + 1 >= place.column) return bytes + 1;
      shown = c == '\t' ? (shown / 8 + 1) * 8 : shown + 1;
    }
    ++bytes;
  }
  return place.column == shown + 1 ? bytes + 1 : 0;
}

int SourceText::character_column(Place place) const {
  const std::string_view text = line(place.line);
  const auto bytes = std::min(index_before(place.column), text.size());
  const auto more = std::count_if(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(bytes),
                                  is_continuation);
  return place.column - static_cast<int>(more);
}

// ---- What stands at a place -------------------------------------------------------------------

std::string_view SourceText::word_at(Place place) const {
  const std::string_view text = line(place.line);
  const std::size_t begin = index_before(place.column);
  std::size_t end = begin;
  while (end < text.size() && is_identifier_character(text[end])) ++end;
  return begin < end ? text.substr(begin, std::min(end - begin, max_name_bytes))
                     : std::string_view();
}

std::string_view SourceText::word_before(Place place) const {
  const std::string_view text = line(place.line);
  std::size_t end = std::min(index_before(place.column), text.size());
  while (end > 0 && !is_identifier_character(text[end - 1])) --end;
  std::size_t begin = end;
  while (begin > 0 && is_identifier_character(text[begin - 1]) && end - begin < max_name_bytes)
    --begin;
  return text.substr(begin, end - begin);
}

std::string_view SourceText::sign_at(Place place) const {
  const std::string_view text = line(place.line);
  const std::size_t begin =
      text.find_first_not_of(" \t", std::min(index_before(place.column), text.size()));
  if (begin == std::string_view::npos) return {};
  std::size_t end = begin + 1;
  // A character of UTF-8 has at most four bytes.
  while (end < text.size() && end < begin + 4 && is_continuation(text[end])) ++end;
  return text.substr(begin, end - begin);
}

Place SourceText::end_of_code_before(Place place) const {
  std::string_view text =
      code(place.line).substr(0, std::min(index_before(place.column), code(place.line).size()));
  const int stop = std::max(place.line - max_lines_upwards, 1);
  for (int number = place.line; number >= stop; text = code(--number)) {
    const std::size_t last = text.find_last_not_of(" \t");
    if (last != std::string_view::npos) return {number, static_cast<int>(last) + 2};
  }
  return place;
}

bool SourceText::includes(std::string_view header) const {
  for (int number = 1; number <= line_count(); ++number) {
    const std::string_view text = line(number);
    const std::size_t first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos || text[first] != '#') continue;
    const std::size_t name = text.find(header);
    if (name != std::string_view::npos && text.find("include") < name) return true;
  }
  return false;
}

// ---- Functions and braces ---------------------------------------------------------------------

const SourceText::Structure& SourceText::structure() const {
  if (!structure_) {
    structure_.emplace();
    read_definitions(*structure_);
    read_braces(*structure_);
  }
  return *structure_;
}

const std::vector<FunctionDefinition>& SourceText::definitions() const {
  return structure().definitions;
}

std::optional<int> SourceText::unclosed_brace() const { return structure().unclosed; }

std::optional<OpenFunction> SourceText::open_function(Place brace) const {
  const std::vector<Brace>& braces = structure().braces;
  const auto before = [](const Brace& one, const Place& other) {
    return std::pair(one.place.line, one.place.column) < std::pair(other.line, other.column);
  };
  const auto found = std::lower_bound(braces.begin(), braces.end(), brace, before);
  if (found == braces.end() || found->place != brace) return std::nullopt;
  return found->inside;
}

const FunctionDefinition* SourceText::function_around(int line) const {
  const std::vector<FunctionDefinition>& all = definitions();
  const auto after = std::upper_bound(
      all.begin(), all.end(), line,
      [](int wanted, const FunctionDefinition& function) { return wanted < function.line; });
  return after == all.begin() ? nullptr : &*std::prev(after);
}

}  // namespace contact::grading
