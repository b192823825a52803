// Boost.Geometry's covered_by with its default strategy for the plane, which is a winding number.
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/ring.hpp>

#include "peers.hpp"

using Point = boost::geometry::model::d2::point_xy<double>;

static std::vector<Point> pairs(const std::vector<double>& coordinates) {
  std::vector<Point> points;
  for (std::size_t i = 0; i + 1 < coordinates.size(); i += 2)
    points.emplace_back(coordinates[i], coordinates[i + 1]);
  return points;
}

peers::Locate peers::boost_covered_by(const Questions& questions) {
  // The default: clockwise, with the first vertex repeated at the end.
  std::vector<boost::geometry::model::ring<Point>> rings;
  for (const std::vector<double>& polygon : questions.polygons) {
    const std::vector<Point> vertices = pairs(polygon);
    rings.emplace_back(vertices.begin(), vertices.end());
    boost::geometry::correct(rings.back());
  }
  return [rings, at = pairs(questions.points)](std::vector<Place>& places) {
    in_turn(rings, at, places, [](const auto& ring, const Point& p) {
      // Without a branch, as for the other programs.
      return static_cast<Place>(2 * static_cast<int>(boost::geometry::covered_by(p, ring)));
    });
  };
}
