#pragma once

// A student's file as text: its lines, what of them is code, and the functions that it defines. It
// is read without a compiler, so that a file that does not compile can be talked about.
//
// The file may be written to slow this down. It is read once, in time linear in its length; every
// later query about one position reads a bounded part of the text.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace contact::grading {

/// Of a line, no more than this many bytes are looked at or shown.
inline constexpr std::size_t max_line_bytes = 4096;
/// A search from a line upwards ends after this many lines.
inline constexpr int max_lines_upwards = 400;
/// Of all functions of a file, only the first so many are known.
inline constexpr std::size_t max_definitions = 2000;
/// Names and heads of functions are cut to this many bytes.
inline constexpr std::size_t max_name_bytes = 256;

/// A function that a file defines, as it is written there.
struct FunctionDefinition {
  std::string
      qualified;  ///< with its namespaces: exercise::ray_triangle; empty if that is too long
  std::string name;
  std::string written;  ///< ray_triangle(const contact::Ray<double>& ray), on one line
  int line = 0;
};

/// A position in a file; lines and columns count from 1, columns in bytes. 0 means "not known".
struct Place {
  int line = 0;
  int column = 0;
  friend bool operator==(const Place&, const Place&) = default;
};

/// A function whose opening brace is still open where another one begins.
struct OpenFunction {
  int line = 0;  ///< of its {
  int next = 0;  ///< where the head of the other begins
};

/// How a compiler counts columns: in bytes (clang++), or as a terminal shows them, with a tab up to
/// the next multiple of eight (g++).
enum class Columns { bytes, displayed };

class SourceText {
 public:
  explicit SourceText(std::string text);

  /// A line as written, cut to max_line_bytes; empty if there is none of this number.
  [[nodiscard]] std::string_view line(int number) const;
  /// The same with blanks for comments, for what stands in quotes and for preprocessor lines.
  [[nodiscard]] std::string_view code(int number) const;
  [[nodiscard]] int line_count() const { return static_cast<int>(starts_.size()); }
  [[nodiscard]] const std::string& text() const { return text_; }

  /// What a compiler's line of a file of this name is in this text: the line itself, or, where the
  /// text has #line directives, the only line that they give this number and name. The line after
  /// the last one, where a compiler sees the end of the file, counts; a directive itself does not.
  /// 0 if there is no such line.
  /// @param own whether the name is the text's own
  [[nodiscard]] int physical_line(std::string_view file, bool own, int line) const;
  /// Whether a #line directive gives a part of the text this name.
  [[nodiscard]] bool goes_by_name(std::string_view file) const;

  /// A compiler's column as a count of bytes; 0 if the line has no such column, or none that is
  /// looked at.
  [[nodiscard]] int byte_column(Place place, Columns columns) const;
  /// A count of bytes as a count of characters, which is what an editor wants.
  [[nodiscard]] int character_column(Place place) const;

  /// The name or number that begins at a place; empty if none does.
  [[nodiscard]] std::string_view word_at(Place place) const;
  /// The name that ends before a place, signs between skipped.
  [[nodiscard]] std::string_view word_before(Place place) const;
  /// The character, of as many bytes as it has, at a place or after blanks; empty at a line's end.
  [[nodiscard]] std::string_view sign_at(Place place) const;

  /// Just after the last code before a place; the place itself if none is near.
  [[nodiscard]] Place end_of_code_before(Place place) const;

  /// Whether a line includes a header of this name.
  [[nodiscard]] bool includes(std::string_view header) const;
  [[nodiscard]] const std::vector<FunctionDefinition>& definitions() const;
  /// The line of the opening brace that, by the indentation of the closing ones, lacks its own.
  [[nodiscard]] std::optional<int> unclosed_brace() const;
  /// The function inside which another function's { is at a position.
  [[nodiscard]] std::optional<OpenFunction> open_function(Place brace) const;
  /// The function that a line belongs to; null if none begins before it.
  [[nodiscard]] const FunctionDefinition* function_around(int line) const;

 private:
  /// "#line 7 "other.cpp"": from the next line on, lines count from `first`.
  struct LineDirective {
    int line = 0;
    int first = 0;
    std::string file;  ///< empty: the file's own name
  };
  /// A { inside a function.
  struct Brace {
    Place place;
    OpenFunction inside;
  };
  struct Structure {
    std::vector<FunctionDefinition> definitions;
    std::vector<Brace> braces;
    std::optional<int> unclosed;
  };

  void blank_out_what_is_not_code();
  void note_directive(int number, std::string_view line);
  [[nodiscard]] std::string_view part(const std::string& of, int number, std::size_t most) const;
  [[nodiscard]] std::string_view whole_code(int number) const;
  [[nodiscard]] const Structure& structure() const;
  void read_definitions(Structure& found) const;
  void read_braces(Structure& found) const;

  std::string text_;
  std::string code_;                   ///< as long as the text
  std::vector<std::uint32_t> starts_;  ///< where each line begins
  std::vector<LineDirective> directives_;
  mutable std::optional<Structure> structure_;  ///< found when it is first asked for
};

}  // namespace contact::grading
