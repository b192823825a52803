// An answer to ray_triangle ("nothing, always") that uses parts of the standard library which the
// tests and their libraries use too: it must link with the sealed tests.
#include "ray_triangle.hpp"

#include <map>
#include <regex>
#include <string>
#include <unordered_map>

namespace exercise {

std::optional<contact::TriangleHit<double>> ray_triangle(const contact::Ray<double>& ray,
                                                         const contact::Triangle<double>&) {
  std::map<int, std::string> names;
  names[3] = std::to_string(ray.origin.x());
  names.insert_or_assign(4, "four");
  std::unordered_map<std::string, int> lengths;
  lengths[names[3]] = std::regex_match(names[4], std::regex("fo.r")) ? 1 : 0;
  if (lengths.size() == 2) return contact::TriangleHit<double>{};
  return std::nullopt;
}

}  // namespace exercise
