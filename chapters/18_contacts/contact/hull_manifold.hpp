/// @file
/// The contact manifold of convex hulls, triangles and lozenges with each other, with boxes,
/// capsules, spheres and half-spaces: face clipping, parallel edges, closest points.
#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

#include <contact/close_points.hpp>
#include <contact/contact_manifold.hpp>
#include <contact/convex_bodies.hpp>
#include <contact/face_overlap.hpp>
#include <contact/facing_part.hpp>
#include <contact/manifold_point.hpp>
#include <contact/signed_distance.hpp>
#include <contact/support.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace detail {

template <class Body>
struct IsFaceted : std::false_type {};
template <Ring S>
struct IsFaceted<ConvexHull<S>> : std::true_type {};
template <Ring S>
struct IsFaceted<Triangle<S>> : std::true_type {};
template <Ring S>
struct IsFaceted<Lozenge<S>> : std::true_type {};

/// By how much a part of a body may fall, as a fraction of its length, to be clipped by a face of
/// the other: a body that rocks still has all points that are within the margin.
template <std::floating_point S>
inline constexpr S steepest_part = S(0x1p-3);

/// The largest extent of a core along a coordinate axis, m.
template <PolytopeCore Body>
ScalarOf<Body> core_extent(const Body& body) {
  using S = ScalarOf<Body>;
  Vector3<S> low = vertex(body, 0), high = low;
  for (int i = 1; i < vertex_count(body); ++i) {
    low = low.cwiseMin(Vector3<S>(vertex(body, i)));
    high = high.cwiseMax(Vector3<S>(vertex(body, i)));
  }
  return (high - low).maxCoeff();
}

/// How far the cores of two bodies are separated by the plane of a face of the first, m; −∞ if the
/// part is no face.
template <PolytopeCore Body, PolytopeCore Other>
ScalarOf<Body> separation_by_face(const Body& body, const FacingPart<ScalarOf<Body>>& face,
                                  const Other& other) {
  using S = ScalarOf<Body>;
  if (face.vertices.size() < 3) return -std::numeric_limits<S>::infinity();
  const Vector3<S> top = vertex(body, support_vertex(body, face.normal));
  const Vector3<S> lowest = vertex(other, support_vertex(other, Vector3<S>(-face.normal)));
  return face.normal.dot(Vector3<S>(lowest - top));
}

// [hull-faces]
/// The points of the other body's facing part over a face of the reference body, with the face's
/// normal. Positions are relative to a point nearby, so that bodies far from the origin lose
/// nothing.
template <PolytopeCore Reference, PolytopeCore Incident, std::floating_point S>
ContactManifold<S> points_over_face(const Reference& reference, const FacingPart<S>& face,
                                    const Incident& incident, const FacingPart<S>& part,
                                    const Vector3<S>& origin, const S& margin) {
  const auto relative = [&origin](const auto& body, int i) {
    return Vector3<S>(vertex(body, i) - origin);
  };
  std::vector<ReferenceSide<S>> sides;
  for (std::size_t i = 0; i < face.vertices.size(); ++i) {
    const int from = face.vertices[i], to = face.vertices[(i + 1) % face.vertices.size()];
    const Vector3<S> start = relative(reference, from);
    const Vector3<S> out = Vector3<S>(relative(reference, to) - start).cross(face.normal);
    sides.push_back({out, out.dot(start), edge_feature(from, to)});
  }
  std::vector<Vector3<S>> points, corners;
  for (const int i : face.vertices) corners.push_back(relative(reference, i));
  for (const int i : part.vertices) points.push_back(relative(incident, i));
  const Vector3<S> top = relative(reference, support_vertex(reference, face.normal));
  // From the incident body to the reference body: as seen from A if that is the reference.
  ContactManifold<S> manifold{Vector3<S>(Vector3<S>::Zero() - face.normal), {}};
  for (const OverlapVertex<S>& v : face_overlap<S>(points, part.vertices, sides)) {
    const S distance =
        face.normal.dot(Vector3<S>(v.point - top)) - (radius_of(reference) + radius_of(incident));
    if (!(distance <= margin)) continue;
    const S beyond = radius_of(incident) + distance / S(2);
    manifold.points.push_back({Vector3<S>(origin + (v.point - face.normal * beyond)), distance,
                               PointFeatures{v.reference, v.incident}});
  }
  keep_outline(manifold, std::min(face_size(corners), face_size(points)));
  return manifold;
}
// [/hull-faces]

// [hull-edges]
/// The ends of the overlap of two edges, if they are parallel; else no points.
template <PolytopeCore A, PolytopeCore B, std::floating_point S>
ContactManifold<S> points_of_edges(const A& a, const FacingPart<S>& of_a, const B& b,
                                   const FacingPart<S>& of_b, const Vector3<S>& normal,
                                   const S& margin) {
  ContactManifold<S> manifold{normal, {}};
  if (of_a.vertices.size() != 2 || of_b.vertices.size() != 2) return manifold;
  const int a0 = of_a.vertices[0], a1 = of_a.vertices[1];
  int b0 = of_b.vertices[0], b1 = of_b.vertices[1];
  const Segment<S> edge_a{vertex(a, a0), vertex(a, a1)};
  const Vector3<S> d = edge_a.end - edge_a.start;
  if (d.dot(Vector3<S>(vertex(b, b1) - vertex(b, b0))) < S(0)) std::swap(b0, b1);
  const Segment<S> edge_b{vertex(b, b0), vertex(b, b1)};
  const Vector3<S> e = edge_b.end - edge_b.start;
  if (!(length<S>(d.cross(e)) <= parallel_sine<S> * length<S>(d) * length<S>(e))) return manifold;
  const S low = d.dot(Vector3<S>(edge_b.start - edge_a.start)) / d.dot(d);
  const S high = d.dot(Vector3<S>(edge_b.end - edge_a.start)) / d.dot(d);
  const S first = std::max(S(0), low), last = std::min(S(1), high);
  if (!(first < last)) return manifold;
  const SurfaceFeature side_a = edge_feature(a0, a1), side_b = edge_feature(b0, b1);
  const auto add = [&](const S& t, const PointFeatures& features) {
    const Vector3<S> on_a = point_at<S>(edge_a, t), on_b = closest_point<S>(on_a, edge_b);
    const S distance = normal.dot(Vector3<S>(on_a - on_b)) - (radius_of(a) + radius_of(b));
    add_manifold_point<S>(manifold, Vector3<S>(on_a - normal * radius_of(a)), distance, margin,
                          features);
  };
  add(first, low <= S(0) ? PointFeatures{vertex_feature(a0), side_b}
                         : PointFeatures{side_a, vertex_feature(b0)});
  add(last, high >= S(1) ? PointFeatures{vertex_feature(a1), side_b}
                         : PointFeatures{side_a, vertex_feature(b1)});
  merge_close_points(manifold, std::min(length<S>(d), length<S>(e)));
  return manifold;
}
// [/hull-edges]

/// Whether some point is at most this far.
template <Ring S>
bool has_point_within(const ContactManifold<S>& manifold, const S& distance) {
  return std::any_of(manifold.points.begin(), manifold.points.end(),
                     [&distance](const auto& p) { return p.distance <= distance; });
}

// [hull-manifold]
/// The manifold of two polytopes with radii, of an ordinary size.
template <PolytopeCore A, PolytopeCore B, std::floating_point S>
ContactManifold<S> polytopes_manifold(const A& a, const B& b, const S& margin) {
  const SignedDistance<S> near = signed_distance(a, b);
  if (!(near.distance <= margin)) return {near.normal, {}};
  const S slack = face_preference<S> * std::min(core_extent(a), core_extent(b));
  const Vector3<S> down = -near.normal;
  const FacingPart<S> of_a = facing_part(a, down, steepest_part<S>);
  const FacingPart<S> of_b = facing_part(b, near.normal, steepest_part<S>);
  const S by_a = separation_by_face(a, of_a, b), by_b = separation_by_face(b, of_b, a);
  const S least = near.distance + (radius_of(a) + radius_of(b)) - slack;  // of the cores
  if (std::min(of_a.vertices.size(), of_b.vertices.size()) > 1 && std::max(by_a, by_b) >= least) {
    const ContactManifold<S> found =
        by_a >= by_b ? points_over_face(a, of_a, b, of_b, near.on_a, margin)
                     : exchanged(points_over_face(b, of_b, a, of_a, near.on_a, margin));
    if (has_point_within(found, S(near.distance + slack))) return found;
  }
  const ContactManifold<S> edges =
      points_of_edges(a, facing_part(a, down, flatness<S>), b,
                      facing_part(b, near.normal, flatness<S>), near.normal, margin);
  if (has_point_within(edges, S(near.distance + slack))) return edges;
  return single_point(a, b, near, margin);
}
// [/hull-manifold]

}  // namespace detail

/// A convex hull, a triangle or a lozenge: a body whose faces are found for each query.
template <class Body>
concept FacetedBody = detail::IsFaceted<Body>::value;

// [contact-manifold-of-hulls]
/// Two bodies of which at least one is a convex hull, a triangle or a lozenge.
///
/// The direction in which they are closest, or overlap least, selects a part of each: a face that
/// falls by at most an eighth of its length, else such an edge, else a vertex. A face separates the
/// bodies by its plane; of two faces, that which separates more is the reference face, and the
/// other body's part is clipped by its sides. The normal is the reference face's, and each point of
/// the clipped part within the margin is a point. The face must separate as much as the bodies are
/// apart, and some point must be as close, both to within 2^-10 of the smaller core: else the
/// bodies do not meet on the face. Then two parallel edges give the ends of their overlap, and all
/// others the closest points. Of points that coincide the first stays, and of a face's points
/// those between others are left out, both to within 2^-20 (float: 2^-12) of the smaller of the two
/// faces or edges, so that rounding does not change their number.
///
/// So the normal is a face's where a body lies on a face, also if rounding has tilted it; that of
/// signed_distance() at edges and vertices. Where vertices or edges meet, many directions separate
/// the bodies. signed_distance() selects one from the stored numbers alone, in an order of the
/// bodies that depends on them alone: so the choice is the same in every run, and exchanging the
/// bodies gives exactly the opposite normal and the same points, unless all numbers of the two are
/// equal.
///
/// Moving A by −(least distance) along the normal makes the bodies touch, to within 2^-9 of the
/// smaller core, if signed_distance() is accurate (its limits for thin bodies apply).
/// @param a, b of any size
/// @param margin bodies at most this far apart are in contact, m; not negative. With 0, touching
/// and overlapping bodies have points, up to rounding
/// @return no points if a number is not finite or a hull has no vertices; as many as the smaller
/// face can have by clipping (reduced_manifold() takes four of them)
template <PolytopeCore A, PolytopeCore B>
requires std::same_as<ScalarOf<A>, ScalarOf<B>> &&
    (FacetedBody<A> ||
     FacetedBody<B>)ContactManifold<ScalarOf<A>> contact_manifold(const A& a, const B& b,
                                                                  const ScalarOf<A>& margin) {
  using S = ScalarOf<A>;
  if (vertex_count(a) == 0 || vertex_count(b) == 0) return {};
  if constexpr (std::same_as<A, B>) {
    return detail::ordered_manifold(a, b, margin, detail::polytopes_manifold<A, A, S>);
  } else if constexpr (detail::kind_rank<A>() < detail::kind_rank<B>()) {
    return detail::manifold_of_any_size(a, b, margin, detail::polytopes_manifold<A, B, S>);
  } else {
    return exchanged(contact_manifold(b, a, margin));
  }
}
// [/contact-manifold-of-hulls]

/// A convex hull, a triangle or a lozenge, and a half-space: each vertex within the margin, in
/// order. No point if a number is not finite.
template <PolytopeCore A>
requires FacetedBody<A> ContactManifold<ScalarOf<A>> contact_manifold(
    const A& a, const HalfSpace<ScalarOf<A>>& b, const ScalarOf<A>& margin) {
  using S = ScalarOf<A>;
  const Vector3<S>& n = b.boundary.normal;
  ContactManifold<S> manifold{n, {}};
  for (int i = 0; i < vertex_count(a); ++i) {
    const S distance = signed_distance(b.boundary, Vector3<S>(vertex(a, i))) - radius_of(a);
    detail::add_manifold_point<S>(manifold, Vector3<S>(vertex(a, i) - n * radius_of(a)), distance,
                                  margin, {vertex_feature(i), {}});
  }
  return manifold;
}

}  // namespace contact
