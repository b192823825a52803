/// @file
/// What is true of a mesh, for the ladder and for the comparison with other programs: exact numbers
/// without a filter, and none of the chapter's code. Triangles that a line misses by more than a
/// rounding error could make up are left out first. Eigen only: the ladder uses it in the page.
#pragma once

#include <algorithm>
#include <cmath>
#include <contact/exact.hpp>
#include <contact/mesh.hpp>
#include <contact/orientation.hpp>
#include <contact/ray_triangle.hpp>
#include <contact/shapes.hpp>
#include <contact/vector.hpp>
#include <cstddef>
#include <optional>
#include <vector>

namespace mesh_truth {

using contact::Exact;
using contact::Mesh;
using Point = contact::Vector3<double>;

inline contact::Vector3<Exact> in_exact(const Point& v) {
  return {Exact(v.x()), Exact(v.y()), Exact(v.z())};
}
inline contact::Triangle<Exact> in_exact(const contact::Triangle<double>& t) {
  return {in_exact(t.a), in_exact(t.b), in_exact(t.c)};
}

/// A sphere around a triangle, larger than the smallest one.
struct Around {
  Point centre;
  double radius;
};
inline std::vector<Around> around_triangles(const Mesh<double>& mesh) {
  std::vector<Around> all;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto [a, b, c] = contact::triangle_of(mesh, i);
    const Point centre = (a + b + c) / 3;
    const double square = std::max(
        {(a - centre).squaredNorm(), (b - centre).squaredNorm(), (c - centre).squaredNorm()});
    all.push_back({centre, 1.001 * std::sqrt(square)});
  }
  return all;
}

/// The first triangle that a line meets, and where.
struct First {
  int triangle = -1;  ///< the one with the lowest index of those that are met there; −1: none
  double t = std::nan("");
};

/// A triangle in whose plane the line runs is not met, nor is one without area.
/// @param last the largest t that counts; nothing for a ray
inline First first(const Point& origin, const contact::Vector3<Exact>& direction,
                   const std::optional<Exact>& last, const Mesh<double>& mesh,
                   const std::vector<Around>& around) {
  const Point d{rounded<double>(direction.x()), rounded<double>(direction.y()),
                rounded<double>(direction.z())};
  const double square = d.squaredNorm();
  const contact::Vector3<Exact> start = in_exact(origin);
  First found;
  Exact best, by(1.0);
  for (std::size_t i = 0; i < around.size(); ++i) {
    const Point to_centre = around[i].centre - origin;
    const double far = to_centre.squaredNorm();
    const double reach = around[i].radius + 1e-9 * std::sqrt(far);
    if (to_centre.cross(d).squaredNorm() > reach * reach * square * (1 + 1e-9)) continue;
    const auto hit = contact::moller_trumbore_fractions<Exact>(
        start, direction, last, in_exact(contact::triangle_of(mesh, i)));
    if (!hit) continue;
    // t = hit->t / hit->denominator against best / by; of equal ones the first triangle stays.
    if (found.triangle >= 0 && !(hit->t * by < best * hit->denominator)) continue;
    found.triangle = static_cast<int>(i);
    best = hit->t;
    by = hit->denominator;
  }
  if (found.triangle >= 0) found.t = quotient<double>(best, by);
  return found;
}
inline First first(const contact::Ray<double>& ray, const Mesh<double>& mesh,
                   const std::vector<Around>& around) {
  return first(ray.origin, in_exact(ray.direction), std::nullopt, mesh, around);
}
inline First first(const contact::Segment<double>& segment, const Mesh<double>& mesh,
                   const std::vector<Around>& around) {
  return first(segment.start, in_exact(segment.end) - in_exact(segment.start), Exact(1.0), mesh,
               around);
}

/// Whether two triangles have a vertex in common.
inline bool share_a_vertex(const Mesh<double>& mesh, int one, int other) {
  const auto& a = mesh.triangles[static_cast<std::size_t>(one)];
  const auto& b = mesh.triangles[static_cast<std::size_t>(other)];
  return std::find_first_of(a.begin(), a.end(), b.begin(), b.end()) != a.end();
}

/// −1, 0 or 1: outside, on the surface, inside. The winding number of a closed mesh around p: how
/// often the ray from p along x leaves less how often it enters.
inline int where(const Point& p, const Mesh<double>& mesh) {
  using Flat = contact::Vector2<Exact>;
  const contact::Vector3<Exact> e = in_exact(p);
  int winding = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const contact::Triangle<double> t = contact::triangle_of(mesh, i);
    const auto [low_y, high_y] = std::minmax({t.a.y(), t.b.y(), t.c.y()});
    if (p.y() < low_y || p.y() > high_y) continue;
    const auto [low_z, high_z] = std::minmax({t.a.z(), t.b.z(), t.c.z()});
    if (p.z() < low_z || p.z() > high_z) continue;
    if (p.x() > std::max({t.a.x(), t.b.x(), t.c.x()})) continue;

    // Half-open edges in the plane of y and z: of the triangles around an edge or a vertex through
    // which the ray passes, those are crossed that a ray a little further along y and z would
    // cross.
    const auto flat = [](const contact::Vector3<Exact>& v) { return Flat(v.y(), v.z()); };
    const contact::Triangle<Exact> x = in_exact(t);
    const contact::Vector3<Exact>* const corners[] = {&x.a, &x.b, &x.c};
    int turns = 0, positive = 0, negative = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const contact::Vector3<Exact>&from = *corners[k], &to = *corners[(k + 1) % 3];
      const int side = contact::orientation<Exact>(flat(from), flat(to), flat(e)).sign();
      positive += side > 0;
      negative += side < 0;
      if (from.z() <= e.z() && e.z() < to.z() && side > 0) ++turns;
      if (to.z() <= e.z() && e.z() < from.z() && side < 0) --turns;
    }
    const int beyond = contact::signed_volume<Exact>(x.a, x.b, x.c, e).sign();
    if (beyond == 0) {
      // In the plane; in the triangle if so in one of its projections that has an area.
      const contact::Vector3<Exact> normal = (x.b - x.a).cross(x.c - x.a);
      if (normal.x().sign() != 0) {
        if (positive == 0 || negative == 0) return 0;
        continue;
      }
      const int drop = normal.y().sign() != 0 ? 1 : 2;
      if (normal(drop).sign() == 0) continue;  // without area: its edges are those of others
      bool plus = false, minus = false;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto onto = [drop](const contact::Vector3<Exact>& v) {
          return Flat(v((drop + 1) % 3), v((drop + 2) % 3));
        };
        const int side =
            contact::orientation<Exact>(onto(*corners[k]), onto(*corners[(k + 1) % 3]), onto(e))
                .sign();
        plus = plus || side > 0;
        minus = minus || side < 0;
      }
      if (!plus || !minus) return 0;
      continue;
    }
    // Counter-clockwise in y and z is a triangle seen from large x: the ray leaves through it. p is
    // behind it if it is on the other side than x → ∞.
    if (turns > 0 && beyond < 0) ++winding;
    if (turns < 0 && beyond > 0) --winding;
  }
  return winding != 0 ? 1 : -1;
}

}  // namespace mesh_truth
