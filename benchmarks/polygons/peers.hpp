/// @file
/// The point tests of other programs, each behind one function. Their headers stay in their own
/// files.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace peers {

/// Where a point is.
enum class Place : signed char { outside, on, inside };

/// Tells of each point where it is. The program's own polygons and points were made before.
using Locate = std::function<void(std::vector<Place>&)>;

/// Point i is asked about polygon i modulo their number. The coordinates are x and y one after the
/// other; a polygon does not cross itself and is counter-clockwise, without its first vertex
/// repeated at the end.
struct Questions {
  std::vector<std::vector<double>> polygons;
  std::vector<double> points;
};

Locate cgal(const Questions& questions);
/// Says `inside` also of points on the boundary.
Locate boost_covered_by(const Questions& questions);
Locate geos(const Questions& questions);
/// With an index of the edges that is made before, as GEOS does for prepared polygons.
Locate geos_indexed(const Questions& questions);

/// Calls ask(polygon, point) for each point with its polygon, and keeps the answers.
template <class Polygons, class Points, class Ask>
void in_turn(Polygons& polygons, const Points& points, std::vector<Place>& places, const Ask& ask) {
  std::size_t next = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    places[i] = ask(polygons[next], points[i]);
    if (++next == polygons.size()) next = 0;
  }
}

}  // namespace peers
