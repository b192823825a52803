#pragma once

// JSON with what a reader of files reports: the line of a value, duplicate keys. nlohmann::json
// parses; its own tree keeps neither.

#include <string>
#include <string_view>
#include <vector>

namespace contact::scenes {

enum class JsonKind { null, boolean, number, text, array, object };

struct JsonMember;

/// A value of a JSON document.
struct JsonNode {
  JsonKind kind = JsonKind::null;
  int line = 0;
  bool truth = false;               ///< of a boolean
  double number = 0;                ///< of a number
  std::string text;                 ///< of a text; of a number, as it stands in the file
  std::vector<JsonNode> items;      ///< of an array
  std::vector<JsonMember> members;  ///< of an object, also those that repeat

  /// The first member of this name, or null.
  [[nodiscard]] const JsonNode* find(std::string_view key) const;
  /// The value as a few characters for an error: `-1`, `"ball"`, `[1, 2]`, `{...}`.
  [[nodiscard]] std::string shown() const;
};

/// A key of an object and its value.
struct JsonMember {
  std::string key;
  JsonNode value;
};

/// Reads a document.
/// @throws SceneFileError with the line and the path where it is not JSON, or where a double cannot
/// hold a number
JsonNode parse_json(std::string_view text, const std::string& file);

/// A key as it continues a path: `.mass`, or `["two words"]`.
std::string path_step(const std::string& key);

/// The value at a path such as "bodies[3].mass", or the last one on the path that exists.
const JsonNode& deepest(const JsonNode& root, std::string_view path);

}  // namespace contact::scenes
