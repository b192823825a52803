/// @file
/// The part of an incident face over a reference face, with the features that make each of its
/// vertices.
#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <vector>

#include <contact/manifold_point.hpp>
#include <contact/vector.hpp>

namespace contact {

// [overlap-vertex]
/// A side of the reference face: the plane through an edge, perpendicular to the face.
template <Ring S>
struct ReferenceSide {
  Vector3<S> normal;    ///< out of the face, of any length
  S offset;             ///< n · x on the side
  SurfaceFeature edge;  ///< of the reference body
};

/// A vertex of the part of the incident face over the reference face. It is a vertex of the
/// incident face, a crossing of one of its edges with a side, or a vertex of the reference face
/// projected onto the incident face.
template <Ring S>
struct OverlapVertex {
  Vector3<S> point;              ///< in the plane of the incident face, m
  SurfaceFeature incident;       ///< its vertex or edge; nothing: the face
  SurfaceFeature reference;      ///< its edge or vertex; nothing: the face
  SurfaceFeature leaving;        ///< the edge that leads to the next vertex
  bool leaving_incident = true;  ///< whether that is an edge of the incident face
};
// [/overlap-vertex]

namespace detail {

/// The vertex of two edges, if they have one in common; else nothing.
constexpr SurfaceFeature common_vertex(const SurfaceFeature& one, const SurfaceFeature& other) {
  for (const int v : {one.first, one.second}) {
    if (v == other.first || v == other.second) return vertex_feature(v);
  }
  return {};
}

// [clip-features]
/// The part of the polygon on the inner side of a side of the reference face. The arithmetic is
/// that of clipped_polygon() of chapter 9; the features of new vertices are recorded with it.
template <std::floating_point S>
std::vector<OverlapVertex<S>> clipped(const std::vector<OverlapVertex<S>>& polygon,
                                      const ReferenceSide<S>& side) {
  std::vector<OverlapVertex<S>> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const OverlapVertex<S>& here = polygon[i];
    const OverlapVertex<S>& next = polygon[(i + 1) % polygon.size()];
    const S at_here = side.normal.dot(here.point) - side.offset;
    const S at_next = side.normal.dot(next.point) - side.offset;
    const bool leaves = at_here <= S(0) && S(0) < at_next;
    if (!(S(0) < at_here)) kept.push_back(here);
    if ((at_here < S(0) && S(0) < at_next) || (S(0) < at_here && at_next < S(0))) {
      const Vector3<S> edge = next.point - here.point;
      OverlapVertex<S> cut{Vector3<S>(here.point + edge * S(at_here / (at_here - at_next))),
                           {},
                           common_vertex(here.leaving, side.edge),
                           here.leaving,
                           here.leaving_incident};
      if (here.leaving_incident) {
        cut.incident = here.leaving;
        cut.reference = side.edge;
      }
      kept.push_back(cut);
    }
    if (leaves) {
      kept.back().leaving = side.edge;
      kept.back().leaving_incident = false;
    }
  }
  return kept;
}
// [/clip-features]

}  // namespace detail

// [face-overlap]
/// The part of an incident face, edge or vertex over a reference face: clipped by the sides of the
/// reference face in their order. Each vertex appears once.
/// @param points of the incident part, m, with their indices as vertices of its body
/// @return no vertex if no point is over the face
template <std::floating_point S>
std::vector<OverlapVertex<S>> face_overlap(const std::vector<Vector3<S>>& points,
                                           const std::vector<int>& indices,
                                           const std::vector<ReferenceSide<S>>& sides) {
  std::vector<OverlapVertex<S>> part;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const int next = indices[(i + 1) % points.size()];
    part.push_back(
        {points[i], vertex_feature(indices[i]), {}, edge_feature(indices[i], next), true});
  }
  for (const ReferenceSide<S>& side : sides) part = detail::clipped(part, side);
  // An edge is clipped once in each direction, which gives its ends twice.
  std::vector<OverlapVertex<S>> once;
  for (const OverlapVertex<S>& v : part) {
    const bool known = std::any_of(once.begin(), once.end(), [&v](const OverlapVertex<S>& w) {
      const bool is_named = v.incident.first >= 0 || v.reference.first >= 0;
      return is_named && v.incident == w.incident && v.reference == w.reference;
    });
    if (!known) once.push_back(v);
  }
  return once;
}
// [/face-overlap]

}  // namespace contact
