/// @file
/// Code to break: whether two triangles have a point in common.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include <contact/prelude.hpp>

#include <contact/shapes.hpp>

namespace given {

using Triangle = contact::Triangle<double>;
using Vector = Eigen::Vector3d;

/// The terms are added from left to right.
inline double dot(const Vector& u, const Vector& v) {
  return u.x() * v.x() + u.y() * v.y() + u.z() * v.z();
}

/// The vertices' distances from the plane of the other triangle, times the length of its normal.
/// Small ones are set to zero: such a vertex counts as one in the plane.
inline Vector distances(const Triangle& triangle, const Triangle& other) {
  constexpr double epsilon = 1e-6;
  const Vector normal = (other.b - other.a).cross(other.c - other.a);
  const double offset = -dot(normal, other.a);
  Vector d(dot(normal, triangle.a) + offset, dot(normal, triangle.b) + offset,
           dot(normal, triangle.c) + offset);
  for (double& one : d) one = std::abs(one) < epsilon ? 0 : one;
  return d;
}

/// What a triangle has of the common line of the two planes, along one coordinate.
struct Interval {
  double low;
  double high;
};

/// The vertex that is alone on its side of the other plane; the two others are not on that side.
inline int alone(const Vector& d) {
  if (d[0] * d[1] > 0) return 2;
  if (d[0] * d[2] > 0) return 1;
  if (d[1] * d[2] > 0 || d[0] != 0) return 0;
  return d[1] != 0 ? 1 : 2;
}

/// The interval ends where two edges cross the other plane.
inline Interval interval(const Triangle& triangle, const Vector& d, int along) {
  const Vector at(triangle.a[along], triangle.b[along], triangle.c[along]);
  const int i = alone(d), j = (i + 1) % 3, k = (i + 2) % 3;
  const double p = at[i] + (at[j] - at[i]) * d[i] / (d[i] - d[j]);
  const double q = at[i] + (at[k] - at[i]) * d[i] / (d[i] - d[k]);
  return {std::min(p, q), std::max(p, q)};
}

/// In one plane: two coordinates of a vertex. The third is left out.
using Point = Eigen::Vector2d;

/// Positive if p is to the left of the line from a to b.
inline double left(const Point& a, const Point& b, const Point& p) {
  return (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x());
}

/// Whether all vertices of one triangle are to the right of an edge of the other, or all to the
/// left, while the triangle of that edge is not.
inline bool apart_at_an_edge(const std::array<Point, 3>& t, const std::array<Point, 3>& u) {
  for (std::size_t i = 0; i < 3; ++i) {
    const Point &a = t[i], &b = t[(i + 1) % 3], &c = t[(i + 2) % 3];
    const double side = left(a, b, c);
    if (left(a, b, u[0]) * side < 0 && left(a, b, u[1]) * side < 0 && left(a, b, u[2]) * side < 0)
      return true;
  }
  return false;
}

/// Whether triangles in one plane meet. The coordinate is dropped in which the normal is largest.
inline bool meet_in_plane(const Triangle& first, const Triangle& second) {
  int axis = 0;
  (first.b - first.a).cross(first.c - first.a).cwiseAbs().maxCoeff(&axis);
  const auto flat = [axis](const Vector& v) { return Point(v[(axis + 1) % 3], v[(axis + 2) % 3]); };
  const std::array<Point, 3> t{flat(first.a), flat(first.b), flat(first.c)};
  const std::array<Point, 3> u{flat(second.a), flat(second.b), flat(second.c)};
  return !apart_at_an_edge(t, u) && !apart_at_an_edge(u, t);
}

/// Whether all three distances have one sign, so that the triangle does not reach the plane.
inline bool on_one_side(const Vector& d) { return d[0] * d[1] > 0 && d[0] * d[2] > 0; }

/// Whether two triangles with areas meet, by the intervals in which they meet the common line of
/// their planes, as Möller published it in 1997. Touching should count.
inline bool triangles_meet(const Triangle& first, const Triangle& second) {
  const Vector d = distances(first, second), e = distances(second, first);
  if (on_one_side(d) || on_one_side(e)) return false;
  if (d.isZero(0) || e.isZero(0)) return meet_in_plane(first, second);
  const Vector line = (first.b - first.a)
                          .cross(first.c - first.a)
                          .cross((second.b - second.a).cross(second.c - second.a));
  int along = 0;
  line.cwiseAbs().maxCoeff(&along);
  const Interval one = interval(first, d, along), other = interval(second, e, along);
  return one.low <= other.high && other.low <= one.high;
}

}  // namespace given
