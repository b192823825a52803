#pragma once

// A student's file as text: its lines, what of them is code, and the functions it defines. Read
// without a compiler, so that a file that does not compile can be talked about.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace contact::grading {

/// A function that a file defines, as it is written there.
struct FunctionDefinition {
  std::string qualified;  ///< with its namespaces: exercise::ray_triangle
  std::string name;
  std::string written;  ///< ray_triangle(const contact::Ray<double>& ray), on one line
  int line = 0;
};

/// A place; lines and columns count from 1.
struct Place {
  int line = 0;
  int column = 0;
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
  explicit SourceText(std::string_view text);

  /// A line as written; empty if there is none of this number.
  [[nodiscard]] std::string_view line(int number) const;
  /// The same with blanks for comments, for what stands in quotes and for preprocessor lines.
  [[nodiscard]] std::string_view code(int number) const;
  [[nodiscard]] int line_count() const { return static_cast<int>(lines_.size()); }

  /// A compiler's column as a count of bytes.
  [[nodiscard]] int byte_column(Place place, Columns columns) const;
  /// A count of bytes as a count of characters, which is what an editor wants.
  [[nodiscard]] int character_column(Place place) const;

  /// The name or number that begins at a place (in bytes); empty if none does.
  [[nodiscard]] std::string_view word_at(Place place) const;
  /// The name that ends before a place, signs between skipped.
  [[nodiscard]] std::string_view word_before(Place place) const;
  /// The character, of as many bytes as it has, at a place or after blanks; empty at a line's end.
  [[nodiscard]] std::string_view sign_at(Place place) const;

  /// Just after the last code before a place.
  [[nodiscard]] Place end_of_code_before(Place place) const;

  /// Whether a line includes a header of this name.
  [[nodiscard]] bool includes(std::string_view header) const;
  [[nodiscard]] std::vector<FunctionDefinition> definitions() const;
  /// The line of the opening brace that, by the indentation of the closing ones, lacks its own.
  [[nodiscard]] std::optional<int> unclosed_brace() const;
  /// The function inside which another one's { stands at a place.
  [[nodiscard]] std::optional<OpenFunction> open_function(Place brace) const;
  /// The function that a line belongs to.
  [[nodiscard]] std::optional<FunctionDefinition> function_around(int line) const;

 private:
  std::vector<std::string> lines_;
  std::vector<std::string> code_;
};

}  // namespace contact::grading
