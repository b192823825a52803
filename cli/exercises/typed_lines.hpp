#pragma once

// What a reader types, line by line.

#include <optional>
#include <string>

namespace contact::cli {

/// Standard input. While it exists, Ctrl-C ends a read and not the program.
class TypedLines {
 public:
  TypedLines();
  TypedLines(const TypedLines&) = delete;
  TypedLines& operator=(const TypedLines&) = delete;
  ~TypedLines();

  /// Shows the prompt and reads a line without its end and the blanks around it; nothing at the end
  /// of the input. Where the input is no terminal, the line is shown too.
  /// @throws grading::Interrupted after Ctrl-C
  std::optional<std::string> next(const std::string& prompt);

 private:
  std::optional<std::string> read();

  bool terminal_;
  bool ended_ = false;
  std::string buffer_;
};

}  // namespace contact::cli
