/// @file
/// Edges in space with whole coordinates up to 1000, in integers and by methods that share nothing
/// with the solutions: a point of one edge is on the other, or their ends are on different sides.
/// The tests of the exercises compare answers with these.
#pragma once

#include <contact/shapes.hpp>

#include <05_meshes/solids.hpp>

namespace whole_edges {

using Segment = contact::Segment<double>;
using solids::cross;
using solids::difference;
using solids::dot;
using solids::Point;
using Integers = solids::Vector;

inline Integers along(const Segment& edge) { return difference(edge.end, edge.start); }
inline Integers across(const Segment& a, const Segment& b) { return cross(along(a), along(b)); }
inline bool is_zero(const Integers& v) { return v.at == Integers{}.at; }
inline Point in_double(const Integers& v) {
  return {static_cast<double>(v.at[0]), static_cast<double>(v.at[1]), static_cast<double>(v.at[2])};
}
inline Segment reversed(const Segment& edge) { return {edge.end, edge.start}; }

inline bool is_parallel(const Segment& a, const Segment& b) { return is_zero(across(a, b)); }

/// Six times the volume of the tetrahedron of the four ends.
inline std::int64_t volume(const Segment& a, const Segment& b) {
  return dot(across(a, b), difference(b.start, a.start));
}

/// Whether p is on the line of the edge.
inline bool on_line(const Segment& edge, const Point& p) {
  return is_zero(cross(along(edge), difference(p, edge.start)));
}
inline bool on_one_line(const Segment& a, const Segment& b) {
  return on_line(a, b.start) && on_line(a, b.end);
}
/// Whether p is on the edge: 1 between the ends, 0 at an end, -1 elsewhere.
inline int on_edge(const Segment& edge, const Point& p) {
  if (!on_line(edge, p)) return -1;
  return -solids::sign(dot(difference(edge.start, p), difference(edge.end, p)));
}

/// On which sides of the line of `edge`, in the plane with the normal n, the ends of `other` are:
/// 1 on different ones, 0 if one is on the line, -1 on one side.
inline int crosses_line(const Segment& other, const Segment& edge, const Integers& n) {
  const auto side = [&](const Point& p) {
    return solids::sign(dot(n, cross(along(edge), difference(p, edge.start))));
  };
  return -side(other.start) * side(other.end);
}

/// How edges of one plane that are not parallel meet: 1 if they cross between their ends, 0 if an
/// end is on the other edge, -1 if they do not meet.
inline int crossing(const Segment& a, const Segment& b) {
  const Integers n = across(a, b);
  return std::min(crosses_line(a, b, n), crosses_line(b, a, n));
}

/// The same for all edges. Parallel ones that overlap have 1.
inline int meeting(const Segment& a, const Segment& b) {
  if (volume(a, b) != 0) return -1;
  if (!is_parallel(a, b)) return crossing(a, b);
  const bool is_same = a.start == b.start && a.end == b.end;
  if (is_same || (a.start == b.end && a.end == b.start)) return 1;
  return std::max({on_edge(a, b.start), on_edge(a, b.end), on_edge(b, a.start), on_edge(b, a.end)});
}

/// Where the lines of two edges of one plane cross that are not parallel: at this share of a.
inline double share_of(const Segment& a, const Segment& b) {
  const Integers n = across(a, b);
  const std::int64_t share = dot(cross(difference(b.start, a.start), along(b)), n);
  return static_cast<double>(share) / static_cast<double>(dot(n, n));
}
inline Point position(const Segment& a, const Segment& b) {
  return a.start + share_of(a, b) * in_double(along(a));
}

inline bool is_whole(const Point& p, double limit) {
  return p == p.array().round().matrix() && p.cwiseAbs().maxCoeff() <= limit;
}
inline bool is_whole(const Segment& edge, double limit) {
  return is_whole(edge.start, limit) && is_whole(edge.end, limit) && edge.start != edge.end;
}

}  // namespace whole_edges
