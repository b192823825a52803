#pragma once

#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>

namespace contact::cli {

/// Colour for a stream: on a terminal only, and never when NO_COLOR is set.
class Style {
 public:
  explicit Style(std::FILE* stream);
  [[nodiscard]] std::string good(std::string_view text) const { return wrap("32", text); }
  [[nodiscard]] std::string bad(std::string_view text) const { return wrap("1;31", text); }
  [[nodiscard]] std::string warn(std::string_view text) const { return wrap("33", text); }
  [[nodiscard]] std::string dim(std::string_view text) const { return wrap("2", text); }
  [[nodiscard]] std::string bold(std::string_view text) const { return wrap("1", text); }
  [[nodiscard]] bool on() const { return on_; }

 private:
  [[nodiscard]] std::string wrap(std::string_view code, std::string_view text) const;
  bool on_;
};

/// Writes to standard output and flushes at once, so that a watcher in a pipe sees each line when
/// it is said.
void say(std::string_view text);
/// A note for the reader, on standard error, so that --json stays clean.
void note(std::string_view text);

/// A path as a reader would type it: relative to the present folder if that is shorter.
std::string shown(const std::filesystem::path& path);

/// A word as a shell takes it: in quotes if it needs them.
std::string quoted_for_shell(const std::string& word);

/// The text with every line indented.
std::string indented(std::string_view text, std::size_t by);
/// Text broken at spaces into lines of at most `width`, each indented; kept line breaks stay.
std::string wrapped(std::string_view text, std::size_t by, std::size_t width = 92);
/// Padded with spaces on the right, counting characters rather than bytes.
std::string padded(std::string_view text, std::size_t width);
std::size_t display_width(std::string_view text);

/// Text from a student's program made safe for a terminal: control characters become visible.
std::string printable(std::string_view text);

}  // namespace contact::cli
