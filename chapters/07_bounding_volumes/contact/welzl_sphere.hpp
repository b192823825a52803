/// @file
/// Welzl's algorithm for the smallest sphere as it is usually printed: with a list that is moved to
/// the front, and rounded. It may be wrong.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <contact/enclosing_radius.hpp>
#include <contact/exact_ray_triangle.hpp>
#include <contact/shapes.hpp>
#include <contact/vector.hpp>
#include <cstddef>
#include <list>
#include <span>

namespace contact {

namespace sphere_detail {

/// Up to four points that must be on the surface.
template <FloatOrDouble S>
struct Boundary {
  std::array<Vector3<S>, 4> points;
  std::size_t count = 0;
};

// [welzl-boundary]
/// The sphere with the given points on its surface, by a rounded quotient; none has radius −1.
/// Where a determinant is 0, its centre is not a number.
template <FloatOrDouble S>
Sphere<S> sphere_through(const Boundary<S>& boundary) {
  if (boundary.count == 0) return {Vector3<S>::Zero(), S(-1)};
  const Vector3<S>& p = boundary.points[0];
  Vector3<S> h = Vector3<S>::Zero();
  const Vector3<S> a = boundary.points[1] - p, b = boundary.points[2] - p,
                   c = boundary.points[3] - p;
  if (boundary.count == 2) h = a / 2;
  if (boundary.count == 3) {
    const Vector3<S> normal = a.cross(b);
    h = (a.dot(a) * b - b.dot(b) * a).cross(normal) / (2 * normal.dot(normal));
  }
  if (boundary.count == 4) {
    h = (a.dot(a) * b.cross(c) + b.dot(b) * c.cross(a) + c.dot(c) * a.cross(b)) /
        (2 * a.dot(b.cross(c)));
  }
  return {p + h, h.norm()};
}
// [/welzl-boundary]

// [welzl]
/// The smallest sphere of the points from the front of a list to `end`, with the boundary on its
/// surface. A point that was outside moves to the front.
template <FloatOrDouble S>
Sphere<S> welzl(std::list<Vector3<S>>& points, typename std::list<Vector3<S>>::iterator end,
                const Boundary<S>& boundary) {
  Sphere<S> sphere = sphere_through(boundary);
  if (boundary.count == 4) return sphere;
  for (auto next = points.begin(); next != end;) {
    const auto point = next++;
    const S distance = (*point - sphere.centre).norm();
    if (!(distance > sphere.radius)) continue;
    Boundary<S> with_point = boundary;
    with_point.points[with_point.count++] = *point;
    sphere = welzl(points, point, with_point);
    points.splice(points.begin(), points, point);
  }
  return sphere;
}
// [/welzl]

}  // namespace sphere_detail

/// The smallest sphere by Welzl's algorithm, as printed almost everywhere: move to front, every
/// decision and every sphere rounded. **It may miss points and be far too large or not a number**:
/// a point on the surface may be outside by an ulp, is then forced onto the surface together with
/// the points that hold the sphere already, and their determinant is 0 or noise. Use
/// smallest_sphere().
///
/// Limits: exact in exact arithmetic, if no four points of a boundary are in one plane. Products of
/// up to four differences overflow beyond 1e77 (float: 1e9) and underflow below 1e-81 (float:
/// 1e-11): the radius may then be infinite or 0, and radius and centre may be no numbers.
/// @param points n ≥ 1 points, m, finite
/// @throws std::invalid_argument if there is no point, or a coordinate is not finite
///
/// Source: Welzl, *Smallest enclosing disks (balls and ellipsoids)*, LNCS 555 (1991).
template <FloatOrDouble S>
Sphere<S> welzl_sphere(std::span<const Vector3<S>> points) {
  sphere_detail::require_points(points);
  std::list<Vector3<S>> list(points.begin(), points.end());
  return sphere_detail::welzl<S>(list, list.end(), {});
}

}  // namespace contact
