#include "near_names.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

namespace contact::grading {

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t above = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, diagonal + (a[i - 1] == b[j - 1] ? 0 : 1)});
      diagonal = above;
    }
  }
  return row[b.size()];
}

namespace {

// A third of the letters may be wrong, two of a short word, and never more than half.
std::size_t max_wrong(std::size_t letters) {
  return std::min(std::max<std::size_t>(2, letters / 3), letters / 2);
}

// The edit distance of near names. Each part of a path must be near: a long folder that is right
// says nothing about the file.
std::optional<std::size_t> distance_if_near(std::string_view name, std::string_view candidate) {
  std::size_t distance = 0;
  for (;;) {
    const std::string_view part = name.substr(0, name.find('/'));
    const std::string_view other = candidate.substr(0, candidate.find('/'));
    const std::size_t wrong = edit_distance(part, other);
    if (wrong > max_wrong(part.size())) return std::nullopt;
    distance += wrong;
    const bool last = part.size() == name.size();
    if (last != (other.size() == candidate.size())) return std::nullopt;
    if (last) return distance;
    name.remove_prefix(part.size() + 1);
    candidate.remove_prefix(other.size() + 1);
  }
}

}  // namespace

std::vector<std::string> nearest(std::string_view name, const std::vector<std::string>& names) {
  std::vector<std::pair<std::size_t, std::string>> ranked;
  if (name.size() > max_near_name) return {};
  for (const std::string& candidate : names) {
    if (candidate.size() > max_near_name) continue;
    if (const std::optional<std::size_t> distance = distance_if_near(name, candidate))
      ranked.emplace_back(*distance, candidate);
  }
  std::sort(ranked.begin(), ranked.end());
  std::vector<std::string> result;
  for (std::size_t i = 0; i < ranked.size() && i < 3; ++i) result.push_back(ranked[i].second);
  return result;
}

}  // namespace contact::grading
