#include "json_tree.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <iterator>
#include <utility>

#include <contact/scene/compiled.hpp>
#include <contact/scene/scene_file.hpp>
#include <nlohmann/json.hpp>

namespace contact::scenes {

namespace detail {

inline constexpr std::size_t deepest_nesting = 16;

/// The parser's position in the text.
struct Place {
  int line = 1;
  const char* last = nullptr;  // the character that was read last; null before the first
};

/// Passes characters on and counts lines.
class CountedChar {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  CountedChar(const char* at, Place* place) : at_(at), place_(place) {}
  reference operator*() const { return *at_; }
  CountedChar& operator++() {
    if (*at_ == '\n') ++place_->line;
    place_->last = at_;
    ++at_;
    return *this;
  }
  CountedChar operator++(int) {
    CountedChar before = *this;
    ++*this;
    return before;
  }
  bool operator==(const CountedChar& other) const { return at_ == other.at_; }
  bool operator!=(const CountedChar& other) const { return at_ != other.at_; }

 private:
  const char* at_;
  Place* place_;
};

CONTACT_SCENES_INLINE std::string excerpt(const std::string& text, std::size_t most) {
  if (text.size() <= most) return text;
  std::size_t end = most;  // not within a multi-byte character
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0U) == 0x80U) --end;
  return text.substr(0, end) + "...";
}

/// The position of the last character before one that is not white space; null if there is none.
CONTACT_SCENES_INLINE const char* word_before(std::string_view text, const char* place) {
  while (place != text.data()) {
    --place;
    if (*place != ' ' && *place != '\t' && *place != '\r' && *place != '\n') return place;
  }
  return nullptr;
}

/// Whether the parser stopped at a comma with no value after or before it: [1, 2,] or [1,, 2].
/// @param last the character that was read last
/// @return what the comma stands beside; empty if it is something else
CONTACT_SCENES_INLINE std::string stray_comma(std::string_view text, const char* last) {
  if (last == nullptr) return "";
  if (*last == ']' || *last == '}') {
    const char* const before = word_before(text, last);
    return before != nullptr && *before == ',' ? std::string("before ") + *last : "";
  }
  if (*last != ',') return "";
  const char* const before = word_before(text, last);
  if (before == nullptr) return "at the beginning";
  if (*before == ',') return "after a comma";
  return *before == '[' || *before == '{' ? std::string("after ") + *before : "";
}

/// The word at a position of a text: letters, digits, signs and points.
CONTACT_SCENES_INLINE std::string word_at(std::string_view text, const char* place) {
  const auto in_word = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '+' || c == '-' || c == '.';
  };
  if (place == nullptr || !in_word(*place)) return "";
  auto begin = static_cast<std::size_t>(place - text.data());
  std::size_t end = begin;
  while (begin > 0 && in_word(text[begin - 1])) --begin;
  while (end < text.size() && in_word(text[end])) ++end;
  return std::string(text.substr(begin, end - begin));
}

/// Whether a word means a number that is not JSON: NaN, -inf, +1, .5.
CONTACT_SCENES_INLINE bool is_foreign_number(std::string word) {
  if (word.empty()) return false;
  if (word.front() == '+' || word.front() == '.') return true;
  if (word.front() == '-') word.erase(0, 1);
  std::transform(word.begin(), word.end(), word.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return word == "nan" || word == "inf" || word == "infinity" || word.rfind('.', 0) == 0;
}

/// Whether a number's text has a digit other than 0 before its exponent.
CONTACT_SCENES_INLINE bool has_value(const std::string& text) {
  return text.find_first_of("123456789") < text.find_first_of("eE");
}

/// Builds the tree as the parser goes.
class Builder : public nlohmann::json_sax<nlohmann::json> {
 public:
  Builder(std::string_view text, std::string file, const Place& place)
      : text_(text), file_(std::move(file)), place_(place) {}

  bool null() override { return add({}); }
  bool boolean(bool value) override {
    JsonNode node;
    node.kind = JsonKind::boolean;
    node.truth = value;
    return add(std::move(node));
  }
  bool number_integer(number_integer_t value) override {
    return number(static_cast<double>(value), std::to_string(value));
  }
  bool number_unsigned(number_unsigned_t value) override {
    return number(static_cast<double>(value), std::to_string(value));
  }
  bool number_float(number_float_t value, const string_t& text) override {
    return number(value, text);
  }
  bool string(string_t& value) override {
    JsonNode node;
    node.kind = JsonKind::text;
    node.text = value;
    return add(std::move(node));
  }
  bool binary(binary_t& /*value*/) override { return false; }
  bool start_object(std::size_t /*elements*/) override { return open(JsonKind::object); }
  bool key(string_t& value) override {
    keys_.back() = value;
    return true;
  }
  bool end_object() override { return close(); }
  bool start_array(std::size_t /*elements*/) override { return open(JsonKind::array); }
  bool end_array() override { return close(); }

  bool parse_error(std::size_t /*position*/, const std::string& last_token,
                   const nlohmann::detail::exception& error) override {
    if (error.id == 406) return unfit_number(last_token);
    const std::string word = word_at(text_, place_.last);
    if (is_foreign_number(word)) {
      return stop(path(), excerpt(word, 20),
                  "must be a JSON value: a number, a \"text\", true, false, [...] or {...}; NaN, "
                  "Infinity, +1 and .5 are not JSON");
    }
    if (text_.find('\0') != std::string_view::npos || nlohmann_says(error, "UTF-8"))
      return stop("", "", "is not JSON: must be a text in UTF-8, and has bytes that are not");
    if (text_.find_first_not_of(" \t\r\n") == std::string_view::npos)
      return stop("", "", "is not JSON: the file is empty");
    if (const std::string where = stray_comma(text_, place_.last); !where.empty())
      return stop(path(), "", "is not JSON: a stray comma " + where + "; take it out");
    std::string why = error.what();
    const std::size_t colon = why.find(": ");
    if (why.rfind('[', 0) == 0 && colon != std::string::npos) why = why.substr(colon + 2);
    const bool ended = nlohmann_says(error, "unexpected end of input");
    return stop(ended ? "" : path(), "", "is not JSON: " + excerpt(why, 197));
  }

  JsonNode take() { return std::move(root_); }

 private:
  static bool nlohmann_says(const nlohmann::detail::exception& error, const char* words) {
    return std::string_view(error.what()).find(words) != std::string_view::npos;
  }
  /// The parser has read one character beyond a number.
  [[nodiscard]] int line_of_number() const {
    return place_.last != nullptr && *place_.last == '\n' ? place_.line - 1 : place_.line;
  }
  bool unfit_number(const std::string& token) const {
    const std::size_t from = token.find_last_of(" \n\t:,[{");
    const std::string number = from == std::string::npos ? token : token.substr(from + 1);
    return stop(path(), excerpt(number, 40), "must be a number that a double holds");
  }
  bool number(double value, std::string text) {
    if (value == 0 && has_value(text)) return unfit_number(text);
    JsonNode node;
    node.kind = JsonKind::number;
    node.number = value;
    node.text = std::move(text);
    return add(std::move(node), line_of_number());
  }
  bool add(JsonNode node) { return add(std::move(node), place_.line); }
  bool add(JsonNode node, int line) {
    node.line = line;
    if (open_.empty()) {
      root_ = std::move(node);
      return true;
    }
    JsonNode& parent = *open_.back();
    if (parent.kind == JsonKind::array) {
      parent.items.push_back(std::move(node));
    } else {
      parent.members.push_back({keys_.back(), std::move(node)});
    }
    return true;
  }
  bool open(JsonKind kind) {
    if (open_.size() >= deepest_nesting)
      return stop(path(), "",
                  "must not be nested more than " + std::to_string(deepest_nesting) + " deep");
    JsonNode node;
    node.kind = kind;
    add(std::move(node));
    // Only the innermost list of children grows while a value is open, so that this stays valid.
    if (open_.empty()) {
      open_.push_back(&root_);
    } else if (open_.back()->kind == JsonKind::array) {
      open_.push_back(&open_.back()->items.back());
    } else {
      open_.push_back(&open_.back()->members.back().value);
    }
    keys_.emplace_back();
    return true;
  }
  bool close() {
    open_.pop_back();
    keys_.pop_back();
    return true;
  }
  std::string path() const {
    std::string path;
    for (std::size_t i = 0; i < open_.size(); ++i) {
      const std::string step =
          open_[i]->kind == JsonKind::array
              ? '[' + std::to_string(open_[i]->items.size() - (i + 1 < open_.size() ? 1 : 0)) + ']'
              : (keys_[i].empty() ? std::string() : path_step(keys_[i]));
      path += step;
    }
    if (!path.empty() && path.front() == '.') path.erase(path.begin());
    return path;
  }
  bool stop(const std::string& path, const std::string& value, const std::string& allowed) const {
    throw SceneFileError(file_, {{place_.line, {path, value, allowed}}});
  }

  std::string_view text_;
  std::string file_;
  const Place& place_;
  JsonNode root_;
  std::vector<JsonNode*> open_;
  std::vector<std::string> keys_;
};

}  // namespace detail

CONTACT_SCENES_INLINE const JsonNode* JsonNode::find(std::string_view key) const {
  const auto found = std::find_if(members.begin(), members.end(),
                                  [&](const auto& member) { return member.key == key; });
  return found == members.end() ? nullptr : &found->value;
}

CONTACT_SCENES_INLINE std::string JsonNode::shown() const {
  switch (kind) {
    case JsonKind::null:
      return "null";
    case JsonKind::boolean:
      return truth ? "true" : "false";
    case JsonKind::number:
      return detail::excerpt(text, 40);
    case JsonKind::text:
      return detail::excerpt(nlohmann::json(text).dump(), 60);
    case JsonKind::object:
      return members.empty() ? "{}" : "{...}";
    case JsonKind::array:
      break;
  }
  std::string list = "[";
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (i > 3) return list + ", ...]";
    list += (i > 0 ? ", " : "");
    list += items[i].kind == JsonKind::array ? "[...]" : items[i].shown();
  }
  return list + "]";
}

CONTACT_SCENES_INLINE JsonNode parse_json(std::string_view text, const std::string& file) {
  detail::Place place;
  detail::Builder builder(text, file, place);
  const detail::CountedChar begin(text.data(), &place);
  const detail::CountedChar end(text.data() + text.size(), &place);
  nlohmann::json::sax_parse(begin, end, &builder);
  return builder.take();
}

CONTACT_SCENES_INLINE std::string path_step(const std::string& key) {
  const bool plain = !key.empty() && std::all_of(key.begin(), key.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_';
  });
  return plain ? '.' + key : '[' + detail::excerpt(nlohmann::json(key).dump(), 60) + ']';
}

CONTACT_SCENES_INLINE const JsonNode& deepest(const JsonNode& root, std::string_view path) {
  const JsonNode* node = &root;
  while (!path.empty()) {
    if (path.front() == '.') path.remove_prefix(1);
    if (path.front() == '[') {
      const std::size_t end = path.find(']');
      if (end == std::string_view::npos || path.size() < 2 || path[1] < '0' || path[1] > '9') break;
      const std::size_t at = std::stoul(std::string(path.substr(1, end - 1)));
      if (node->kind != JsonKind::array || at >= node->items.size()) break;
      node = &node->items[at];
      path.remove_prefix(end + 1);
    } else {
      const std::size_t end = std::min(path.find('.'), path.find('['));
      const JsonNode* next = node->find(path.substr(0, end));
      if (!next) break;
      node = next;
      path.remove_prefix(std::min(end, path.size()));
    }
  }
  return *node;
}

}  // namespace contact::scenes
