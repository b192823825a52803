#pragma once

// The members of a file's objects, each read as its type, and their faults.

#include <algorithm>
#include <array>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <contact/scene/scene_file.hpp>
#include <contact/vector.hpp>

#include "json_tree.hpp"

namespace contact::scenes::detail {

using Keys = std::vector<std::string_view>;

inline std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t k = 0; k <= b.size(); ++k) row[k] = k;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t k = 1; k <= b.size(); ++k) {
      const std::size_t changed = diagonal + (a[i - 1] == b[k - 1] ? 0 : 1);
      diagonal = row[k];
      row[k] = std::min({row[k] + 1, row[k - 1] + 1, changed});
    }
  }
  return row.back();
}

inline std::string joined(const Keys& words) {
  std::string all;
  for (const std::string_view word : words) all += (all.empty() ? "" : ", ") + std::string(word);
  return shortened(all);
}

/// The most similar of some words, if it is similar: at most a third of its letters differ, or one.
inline std::string hint(std::string_view word, const Keys& words) {
  if (word.size() > 64) return "";
  std::string_view best;
  std::size_t least = 0;
  for (const std::string_view candidate : words) {
    const std::size_t far = distance(word, candidate);
    if (best.empty() || far < least) {
      best = candidate;
      least = far;
    }
  }
  if (best.empty() || least > std::max<std::size_t>(1, best.size() / 3)) return "";
  return "did you mean \"" + std::string(best) + "\"? ";
}

inline constexpr const char* kind_names[] = {"null",   "true or false", "a number",
                                             "a text", "an array",      "an object"};

/// Reads the tree of a file, and collects its faults.
class FieldReader {
 protected:
  explicit FieldReader(const JsonNode& root) : root_(root) {}

  // Faults, and where they are.

  void fault(const std::string& path, const std::string& value, const std::string& allowed) {
    fault_at(deepest(root_, path).line, path, value, allowed);
  }
  void fault_at(int line, const std::string& path, const std::string& value,
                const std::string& allowed) {
    faults_.push_back({line, {path, shortened(value), allowed}});
    wrong_.insert(path);
  }
  void unfit(const std::string& path, const JsonNode& node, const std::string& allowed) {
    fault_at(node.line, path, node.shown(), allowed);
  }
  static std::string below(const std::string& path, const std::string& key) {
    return path.empty() ? key : path + '.' + key;
  }
  static std::string at(const std::string& path, std::size_t i) {
    return path + '[' + std::to_string(i) + ']';
  }
  bool kind(const JsonNode& node, const std::string& path, JsonKind wanted,
            const std::string& more = "") {
    if (node.kind == wanted) return true;
    unfit(path, node,
          "must be " + std::string(kind_names[static_cast<std::size_t>(wanted)]) + more);
    return false;
  }
  bool object(const JsonNode& node, const std::string& path, const Keys& keys) {
    if (!kind(node, path, JsonKind::object)) return false;
    std::set<std::string> seen;
    for (const auto& [key, value] : node.members) {
      std::string where = path + path_step(key);
      if (where.front() == '.') where.erase(where.begin());
      if (!seen.insert(key).second) {
        unfit(where, value, "appears twice; a key may appear once");
      } else if (std::find(keys.begin(), keys.end(), key) == keys.end()) {
        unfit(where, value, "is an unknown key; " + hint(key, keys) + "known are " + joined(keys));
      }
    }
    return true;
  }
  bool is_wrong(const std::string& path) const { return wrong_.count(path) != 0; }

  // Members of an object, each read as its type.

  const JsonNode* member(const JsonNode& from, const std::string& path, const std::string& key,
                         const std::string& wanted) {
    const JsonNode* node = from.find(key);
    if (!node) fault(below(path, key), "", "is missing; must be " + wanted);
    return node;
  }
  std::optional<double> number(const JsonNode& from, const std::string& path,
                               const std::string& key, const std::string& unit) {
    const JsonNode* node = member(from, path, key, "a number, " + unit);
    if (!node || !kind(*node, below(path, key), JsonKind::number, ", " + unit)) return std::nullopt;
    return node->number;
  }
  std::optional<double> number_if_there(const JsonNode& from, const std::string& path,
                                        const std::string& key, const std::string& unit) {
    return from.find(key) ? number(from, path, key, unit) : std::nullopt;
  }
  bool truth(const JsonNode& from, const std::string& path, const std::string& key,
             bool otherwise) {
    const JsonNode* node = from.find(key);
    if (!node || !kind(*node, below(path, key), JsonKind::boolean)) return otherwise;
    return node->truth;
  }
  std::string text(const JsonNode& from, const std::string& path, const std::string& key) {
    const JsonNode* node = member(from, path, key, "a text");
    if (!node || !kind(*node, below(path, key), JsonKind::text)) return "";
    return node->text;
  }
  template <std::size_t N>
  std::optional<std::array<double, N>> numbers(const JsonNode& node, const std::string& path) {
    const std::string wanted = " of " + std::to_string(N) + " numbers";
    if (!kind(node, path, JsonKind::array, wanted)) return std::nullopt;
    if (node.items.size() != N) {
      unfit(path, node, "must be an array" + wanted);
      return std::nullopt;
    }
    std::array<double, N> values{};
    bool good = true;
    for (std::size_t i = 0; i < N; ++i) {
      good = kind(node.items[i], at(path, i), JsonKind::number) && good;
      values[i] = node.items[i].number;
    }
    if (!good) return std::nullopt;
    return values;
  }
  Vector3<double> vector(const JsonNode& from, const std::string& path, const std::string& key,
                         bool needed) {
    const JsonNode* node =
        needed ? member(from, path, key, "an array of 3 numbers") : from.find(key);
    if (!node) return Vector3<double>::Zero();
    const auto values = numbers<3>(*node, below(path, key));
    if (!values) return Vector3<double>::Zero();
    return {(*values)[0], (*values)[1], (*values)[2]};
  }
  void absent(const JsonNode& from, const std::string& path,
              std::initializer_list<const char*> keys, const std::string& why) {
    for (const char* key : keys) {
      if (const JsonNode* node = from.find(key)) {
        unfit(below(path, key), *node, "must be absent: " + why);
      }
    }
  }
  void fixed(const std::string& key, const std::string& wanted) {
    const JsonNode* node = member(root_, "", key, '"' + wanted + '"');
    if (node && (node->kind != JsonKind::text || node->text != wanted))
      unfit(key, *node, "must be \"" + wanted + '"');
  }
  const JsonNode* list(const std::string& key, bool needed) {
    const JsonNode* node = needed ? member(root_, "", key, "an array of objects") : root_.find(key);
    if (!node || !kind(*node, key, JsonKind::array, " of objects")) return nullptr;
    return node;
  }

  const JsonNode& root_;
  std::vector<FileFault> faults_;
  std::set<std::string> wrong_;
};

}  // namespace contact::scenes::detail
