#include "plain_text.hpp"

#include <optional>

namespace contact::cli {

namespace {

// What begins at the front of `text` and ends with `end`; the text loses both, and what is between.
std::optional<std::string_view> taken(std::string_view& text, std::string_view begin,
                                      std::string_view end) {
  if (!text.starts_with(begin)) return {};
  const std::size_t close = text.find(end, begin.size());
  if (close == std::string_view::npos) return {};
  const std::string_view inside = text.substr(begin.size(), close - begin.size());
  text.remove_prefix(close + end.size());
  return inside;
}

// `{term}`words <target>``: the words.
std::optional<std::string_view> taken_role(std::string_view& text) {
  std::string_view rest = text;
  if (!taken(rest, "{", "}")) return {};
  const std::optional<std::string_view> inside = taken(rest, "`", "`");
  if (!inside) return {};
  text = rest;
  return inside->substr(0, inside->find(" <"));
}

// `[words](target)`: the words.
std::optional<std::string_view> taken_link(std::string_view& text) {
  std::string_view rest = text;
  const std::optional<std::string_view> words = taken(rest, "[", "](");
  if (!words || words->find(']') != std::string_view::npos) return {};
  const std::size_t close = rest.find(')');
  if (close == std::string_view::npos) return {};
  text = rest.substr(close + 1);
  return words;
}

}  // namespace

std::string plain_text(std::string_view markdown) {
  std::string result;
  while (!markdown.empty()) {
    if (const auto code = taken(markdown, "`", "`")) {
      result += "`" + std::string(*code) + "`";
    } else if (const auto shown = taken(markdown, "$$", "$$")) {
      result += plain_formula(*shown);
    } else if (const auto formula = taken(markdown, "$", "$")) {
      result += plain_formula(*formula);
    } else if (const auto role = taken_role(markdown)) {
      result += *role;
    } else if (const auto words = taken_link(markdown)) {
      result += plain_text(*words);
    } else if (const auto strong = taken(markdown, "**", "**")) {
      result += plain_text(*strong);
    } else if (const auto stressed = taken(markdown, "*", "*")) {
      result += plain_text(*stressed);
    } else if (markdown.starts_with("\\") && markdown.size() > 1) {
      result += markdown[1];
      markdown.remove_prefix(2);
    } else {
      result += markdown.front();
      markdown.remove_prefix(1);
    }
  }
  return result;
}

}  // namespace contact::cli
