// CGAL's bounded_side_2 with exact predicates.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>

#include "peers.hpp"

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

static std::vector<Kernel::Point_2> pairs(const std::vector<double>& coordinates) {
  std::vector<Kernel::Point_2> points;
  for (std::size_t i = 0; i + 1 < coordinates.size(); i += 2)
    points.emplace_back(coordinates[i], coordinates[i + 1]);
  return points;
}

peers::Locate peers::cgal(const Questions& questions) {
  std::vector<std::vector<Kernel::Point_2>> rings;
  for (const std::vector<double>& polygon : questions.polygons) rings.push_back(pairs(polygon));
  return [rings, at = pairs(questions.points)](std::vector<Place>& places) {
    in_turn(rings, at, places, [](const auto& ring, const auto& p) {
      const CGAL::Bounded_side side = CGAL::bounded_side_2(ring.begin(), ring.end(), p, Kernel());
      // Without a branch, as for the other programs.
      static_assert(CGAL::ON_UNBOUNDED_SIDE == -1 && CGAL::ON_BOUNDARY == 0);
      return static_cast<Place>(static_cast<int>(side) + 1);
    });
  };
}
