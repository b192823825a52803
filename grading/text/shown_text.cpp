#include "shown_text.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <iterator>

namespace contact::grading {

namespace {

struct Range {
  char32_t first;
  char32_t last;
};

// What Unicode calls control, format, separator, private use or "default ignorable", and what has
// no glyph although it is a letter. The ideographic space, U+3000, stands in names and is shown.
constexpr Range not_shown[] = {
    {0x0, 0x1F},        {0x7F, 0xA0},       {0xAD, 0xAD},        {0x34F, 0x34F},
    {0x61C, 0x61C},     {0x115F, 0x1160},   {0x1680, 0x1680},    {0x17B4, 0x17B5},
    {0x180B, 0x180F},   {0x2000, 0x200F},   {0x2028, 0x202F},    {0x205F, 0x206F},
    {0x2800, 0x2800},   {0x3164, 0x3164},   {0xE000, 0xF8FF},    {0xFDD0, 0xFDEF},
    {0xFE00, 0xFE0F},   {0xFEFF, 0xFEFF},   {0xFFA0, 0xFFA0},    {0xFFF0, 0xFFFC},
    {0xFFFE, 0xFFFF},   {0x110BD, 0x110BD}, {0x110CD, 0x110CD},  {0x13430, 0x1345F},
    {0x1BCA0, 0x1BCA3}, {0x1D159, 0x1D159}, {0x1D173, 0x1D17A},  {0x1FFFE, 0x1FFFF},
    {0x2FFFE, 0x2FFFF}, {0x3FFFE, 0xDFFFF}, {0xE0000, 0x10FFFF},
};

bool is_shown(char32_t code) {
  const Range* range =
      std::find_if(std::begin(not_shown), std::end(not_shown),
                   [code](const Range& candidate) { return code <= candidate.last; });
  return range == std::end(not_shown) || code < range->first;
}

std::string formatted(const char* format, unsigned value) {
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), format, value);
  return text.data();
}

std::string escaped_byte(char c) { return formatted("\\x%02x", static_cast<unsigned char>(c)); }

// @param most characters, after which "..." stands for the rest
std::string escaped_up_to(std::string_view text, std::size_t most) {
  std::string result;
  std::size_t count = 0;
  for (std::size_t at = 0; at < text.size(); ++count) {
    if (count == most) return result + "...";
    const Character character = character_at(text, at);
    const std::size_t length = std::max<std::size_t>(character.length, 1);
    if (character.length == 0 || character.code < 0x80)
      result += character.length == 1 && is_shown(character.code) ? std::string(1, text[at])
                                                                  : escaped_byte(text[at]);
    else if (is_shown(character.code))
      result += text.substr(at, length);
    else
      result += formatted("\\u{%x}", static_cast<unsigned>(character.code));
    at += length;
  }
  return result;
}

}  // namespace

Character character_at(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) {
    return at + i < text.size() ? static_cast<unsigned char>(text[at + i]) : 0u;
  };
  const unsigned first = byte(0);
  const std::size_t length = first < 0x80                     ? 1
                             : first >= 0xC2 && first <= 0xDF ? 2
                             : first >= 0xE0 && first <= 0xEF ? 3
                             : first >= 0xF0 && first <= 0xF4 ? 4
                                                              : 0;
  if (length == 0) return {};
  char32_t code = length == 1 ? first : first & (0x7Fu >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return {};
    code = code << 6 | (byte(i) & 0x3F);
  }
  if ((first == 0xE0 && byte(1) < 0xA0) || (first == 0xED && byte(1) > 0x9F) ||
      (first == 0xF0 && byte(1) < 0x90) || (first == 0xF4 && byte(1) > 0x8F))
    return {};
  return {code, length};
}

void append_utf8(std::string& text, char32_t code) {
  if (code < 0x80) {
    text += static_cast<char>(code);
    return;
  }
  const int more = code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
  text += static_cast<char>((0xFF00u >> (more + 1) & 0xFF) | code >> (6 * more));
  for (int i = more; i-- > 0;) text += static_cast<char>(0x80 | (code >> (6 * i) & 0x3F));
}

bool is_utf8(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = character_at(text, at).length;
    if (length == 0) return false;
    at += length;
  }
  return true;
}

std::string as_utf8(std::string_view text) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = character_at(text, at).length;
    if (length == 0)
      result += escaped_byte(text[at]);
    else
      result += text.substr(at, length);
    at += std::max<std::size_t>(length, 1);
  }
  return result;
}

std::string escaped(std::string_view text) { return escaped_up_to(text, std::string_view::npos); }

std::string shown_name(std::string_view name) { return "'" + escaped_up_to(name, 80) + "'"; }

}  // namespace contact::grading
