// CGAL with exact predicates; the result is a mesh of triangles.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include "peers.hpp"

peers::Counts peers::cgal(const std::vector<double>& coordinates) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<Kernel::Point_3> points;
  points.reserve(coordinates.size() / 3);
  for (std::size_t i = 0; i + 2 < coordinates.size(); i += 3) {
    points.emplace_back(coordinates[i], coordinates[i + 1], coordinates[i + 2]);
  }
  CGAL::Surface_mesh<Kernel::Point_3> mesh;
  CGAL::convex_hull_3(points.begin(), points.end(), mesh);
  return {mesh.number_of_vertices(), mesh.number_of_faces()};
}
