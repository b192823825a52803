#pragma once

// Which known names a misspelt one may mean.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace contact::grading {

/// Names longer than this are near to none.
inline constexpr std::size_t max_near_name = 80;

/// How many letters must be added, dropped or changed to make one name of another.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The names nearest to `name` by edit distance, nearest first, at most three. In each part between
/// slashes at most half of the letters are wrong, of a long one at most a third.
std::vector<std::string> nearest(std::string_view name, const std::vector<std::string>& names);

}  // namespace contact::grading
