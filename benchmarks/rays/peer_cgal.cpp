// CGAL's do_intersect with exact predicates.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Intersections_3/Bbox_3_Ray_3.h>
#include <CGAL/Intersections_3/Iso_cuboid_3_Ray_3.h>
#include <CGAL/Intersections_3/Ray_3_Sphere_3.h>

#include "peers.hpp"

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;

static Point point(const std::array<float, 3>& p) { return {p[0], p[1], p[2]}; }

static std::vector<Kernel::Ray_3> rays_of(const std::vector<peers::RayOfFloats>& rays) {
  std::vector<Kernel::Ray_3> all;
  for (const peers::RayOfFloats& ray : rays) {
    const Kernel::Vector_3 direction(ray.direction[0], ray.direction[1], ray.direction[2]);
    all.emplace_back(point(ray.origin), point(ray.origin) + direction);
  }
  return all;
}

template <class Rays, class Bodies>
static peers::Ask ask(Rays rays, Bodies bodies) {
  return [rays = std::move(rays), bodies = std::move(bodies)](std::vector<char>& answers) {
    peers::in_turn(rays, bodies, answers,
                   [](const auto& ray, const auto& body) { return CGAL::do_intersect(ray, body); });
  };
}

peers::Ask peers::cgal(const Questions<BallOfFloats>& questions) {
  std::vector<Kernel::Sphere_3> balls;
  for (const BallOfFloats& ball : questions.bodies) {
    // The square of a float is exact.
    balls.emplace_back(point(ball.centre), double(ball.radius) * double(ball.radius));
  }
  return ask(rays_of(questions.rays), std::move(balls));
}

peers::Ask peers::cgal(const Questions<BoxOfFloats>& questions) {
  std::vector<Kernel::Iso_cuboid_3> boxes;
  for (const BoxOfFloats& box : questions.bodies)
    boxes.emplace_back(point(box.low), point(box.high));
  return ask(rays_of(questions.rays), std::move(boxes));
}

peers::Ask peers::cgal_bbox(const Questions<BoxOfFloats>& questions) {
  std::vector<CGAL::Bbox_3> boxes;
  for (const BoxOfFloats& box : questions.bodies) {
    boxes.emplace_back(box.low[0], box.low[1], box.low[2], box.high[0], box.high[1], box.high[2]);
  }
  return ask(rays_of(questions.rays), std::move(boxes));
}
