/// @file
/// The hulls of other programs, each behind one function. Their headers stay in their own files.
#pragma once

#include <cstddef>
#include <vector>

namespace peers {

/// What a program says of the hull of points (x, y, z one after the other).
struct Counts {
  std::size_t vertices = 0;
  std::size_t faces = 0;  ///< as the program joins triangles, or does not
};

Counts qhull(const std::vector<double>& coordinates);
Counts cgal(const std::vector<double>& coordinates);
Counts bullet(const std::vector<double>& coordinates);

}  // namespace peers
