// CGAL: the smallest sphere of points, by Welzl's method and by the farthest point, in exact
// numbers and in double; and its box, which is the best that a search of turns finds.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Min_sphere_annulus_d_traits_3.h>
#include <CGAL/Min_sphere_d.h>
#include <CGAL/Min_sphere_of_points_d_traits_3.h>
#include <CGAL/Min_sphere_of_spheres_d.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/optimal_bounding_box.h>

#include <cmath>

#include "peers.hpp"

namespace {

template <class Kernel>
std::vector<typename Kernel::Point_3> points_of(const peers::Points& from) {
  std::vector<typename Kernel::Point_3> points;
  for (const peers::Numbers& p : from) points.emplace_back(p[0], p[1], p[2]);
  return points;
}

template <class Kernel>
peers::Fit<peers::Ball> min_sphere(const char* name, std::size_t max_points) {
  return peers::fit<peers::Ball>(
      name, points_of<Kernel>,
      [](const auto& points) {
        const CGAL::Min_sphere_d<CGAL::Min_sphere_annulus_d_traits_3<Kernel>> sphere(points.begin(),
                                                                                     points.end());
        const auto centre = sphere.center();
        const auto number = [](const auto& x) { return CGAL::to_double(x); };
        return peers::Ball{{number(centre.x()), number(centre.y()), number(centre.z())},
                           std::sqrt(number(sphere.squared_radius()))};
      },
      max_points);
}

/// In double, this one has the radius itself; in exact numbers, a sum of a fraction and a root.
template <class Kernel, class Algorithm>
peers::Fit<peers::Ball> min_sphere_of_spheres(const char* name, std::size_t max_points) {
  using Number = typename Kernel::FT;
  using Traits = CGAL::Min_sphere_of_points_d_traits_3<
      Kernel, Number,
      std::conditional_t<std::is_same_v<Number, double>, CGAL::Tag_true, CGAL::Tag_false>,
      Algorithm>;
  return peers::fit<peers::Ball>(
      name, points_of<Kernel>,
      [](const auto& points) {
        CGAL::Min_sphere_of_spheres_d<Traits> sphere(points.begin(), points.end());
        if constexpr (std::is_same_v<Number, double>) {
          const auto* centre = sphere.center_cartesian_begin();
          return peers::Ball{{centre[0], centre[1], centre[2]}, sphere.radius()};
        } else {
          const double root = std::sqrt(CGAL::to_double(sphere.discriminant()));
          const auto number = [root](const auto& x) {
            return CGAL::to_double(x.first) + CGAL::to_double(x.second) * root;
          };
          const auto* centre = sphere.center_cartesian_begin();
          return peers::Ball{{number(centre[0]), number(centre[1]), number(centre[2])},
                             number(sphere.radius())};
        }
      },
      max_points);
}

using Plain = CGAL::Exact_predicates_inexact_constructions_kernel;

/// The corners are in the order of make_hexahedron: from the first the edges go to 1, 3 and 5.
peers::Box box_of(const std::vector<Plain::Point_3>& points) {
  std::array<Plain::Point_3, 8> corners;
  CGAL::oriented_bounding_box(points, corners, CGAL::parameters::random_seed(0));
  peers::Box box;
  for (int k = 0; k < 3; ++k) {
    box.centre[static_cast<std::size_t>(k)] = (corners[0][k] + corners[7][k]) / 2;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const Plain::Vector_3 edge = corners[2 * i + 1] - corners[0];
    const double length = std::sqrt(edge.squared_length());
    box.half_lengths[i] = length / 2;
    for (int k = 0; k < 3; ++k) box.axes[i][static_cast<std::size_t>(k)] = edge[k] / length;
  }
  return box;
}

}  // namespace

std::vector<peers::Fit<peers::Ball>> peers::cgal_balls() {
  using Fractions = CGAL::Simple_cartesian<CGAL::Gmpq>;
  using Doubles = CGAL::Simple_cartesian<double>;
  // The exact ones take seconds for more points.
  return {min_sphere<CGAL::Exact_predicates_exact_constructions_kernel>("CGAL, Min_sphere_d, EPECK",
                                                                        100000),
          min_sphere<Fractions>("CGAL, Min_sphere_d, Gmpq", 10000),
          min_sphere_of_spheres<Fractions, CGAL::LP_algorithm>("CGAL, Min_sphere_of_spheres, Gmpq",
                                                               10000),
          min_sphere<Doubles>("CGAL, Min_sphere_d, double", 100000),
          min_sphere_of_spheres<Doubles, CGAL::Farthest_first_heuristic>(
              "CGAL, Min_sphere_of_spheres, double", 100000)};
}

std::vector<peers::Fit<peers::Box>> peers::cgal_boxes() {
  return {fit<Box>("CGAL, oriented_bounding_box", points_of<Plain>, box_of)};
}
