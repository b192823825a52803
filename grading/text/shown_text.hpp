#pragma once

// Makes untrusted text, such as names of files, safe for a message, a report or JSON.

#include <cstddef>
#include <string>
#include <string_view>

namespace contact::grading {

struct Character {
  char32_t code = 0;
  /// In bytes; 0 if it is not UTF-8.
  std::size_t length = 0;
};

/// Strict, as the page's decoder is: no overlong form, no half of a surrogate pair.
Character character_at(std::string_view text, std::size_t at);
void append_utf8(std::string& text, char32_t code);
bool is_utf8(std::string_view text);

/// The text as UTF-8: bytes that are not become \xff, everything else stays.
std::string as_utf8(std::string_view text);

/// The text on one line, as it looks: controls, bytes that are not UTF-8 and characters that are
/// invisible, break the line or change the direction of writing become \x1b or \u{202e}.
std::string escaped(std::string_view text);

/// An untrusted name, safe to show: quoted, escaped, at most 80 characters.
std::string shown_name(std::string_view name);

}  // namespace contact::grading
