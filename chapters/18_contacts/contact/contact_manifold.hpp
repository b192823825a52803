/// @file
/// The contact manifold of spheres, capsules, boxes and half-spaces: one normal, and enough points
/// to support one body on the other.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <vector>

#include <contact/close_points.hpp>
#include <contact/convex_shapes.hpp>
#include <contact/face_clipping.hpp>
#include <contact/face_overlap.hpp>
#include <contact/facing_part.hpp>
#include <contact/gjk_cores.hpp>
#include <contact/manifold_point.hpp>
#include <contact/signed_distance.hpp>
#include <contact/support.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace detail {

/// Adds a point of A's surface at the given distance from B's, unless it exceeds the margin.
template <std::floating_point S>
void add_manifold_point(ContactManifold<S>& manifold, const Vector3<S>& on_a, const S& distance,
                        const S& margin, const PointFeatures& features) {
  if (!(distance <= margin)) return;
  manifold.points.push_back(
      {Vector3<S>(on_a - manifold.normal * (distance / S(2))), distance, features});
}

/// The closest points as the only contact.
template <class A, class B, std::floating_point S>
ContactManifold<S> single_point(const A& a, const B& b, const SignedDistance<S>& between,
                                const S& margin) {
  ContactManifold<S> manifold{between.normal, {}};
  if (!(between.distance <= margin)) return manifold;
  const PointFeatures features{facing_feature(a, Vector3<S>(-between.normal)),
                               facing_feature(b, between.normal)};
  add_manifold_point<S>(manifold, between.on_a, between.distance, margin, features);
  return manifold;
}
template <class A, class B, std::floating_point S>
ContactManifold<S> single_point(const A& a, const B& b, const S& margin) {
  return single_point(a, b, signed_distance(a, b), margin);
}

/// The manifold of two bodies of any size by a method for those of an ordinary size: bodies that
/// are very large or small are multiplied by a power of two. Without points if a number is not
/// finite.
template <class A, class B, std::floating_point S, class Method>
ContactManifold<S> manifold_of_any_size(const A& a, const B& b, const S& margin,
                                        const Method& method) {
  const S of_a = gjk_detail::largest_number(a), of_b = gjk_detail::largest_number(b);
  if (!std::isfinite(of_a) || !std::isfinite(of_b)) return {};
  const int power = scale_power(std::max(of_a, of_b));
  if (power == 0) return method(a, b, margin);
  ContactManifold<S> manifold =
      method(gjk_detail::times_power_of_two(a, -power), gjk_detail::times_power_of_two(b, -power),
             S(std::ldexp(margin, -power)));
  for (ManifoldPoint<S>& p : manifold.points) {
    p.point = times_power_of_two(p.point, power);
    p.distance = std::ldexp(p.distance, power);
  }
  return manifold;
}

// [order-of-bodies]
/// Whether B is taken before A: it comes first along the coordinate in which their centres differ
/// most, or, if the centres are equal, in the order of the stored numbers.
///
/// The order depends on the two bodies alone, and not on which of them is called A. While one rests
/// on the other it does not change: an order of the stored numbers would, with the last digit of a
/// coordinate in which two stacked boxes agree.
template <class Body>
bool is_second(const Body& a, const Body& b) {
  const auto between = (inner_point(b) - inner_point(a)).eval();
  int largest = 0;
  for (int i = 1; i < 3; ++i) {
    if (std::abs(between(i)) > std::abs(between(largest))) largest = i;
  }
  return between(largest) != 0 ? between(largest) < 0 : precedes(b, a);
}
// [/order-of-bodies]

/// The manifold of two bodies of one kind, in an order that depends on them alone.
template <class Body, std::floating_point S, class Method>
ContactManifold<S> ordered_manifold(const Body& a, const Body& b, const S& margin,
                                    const Method& method) {
  if (is_second(a, b)) return exchanged(manifold_of_any_size(b, a, margin, method));
  return manifold_of_any_size(a, b, margin, method);
}

}  // namespace detail

// [single]
/// Two spheres: one point.
/// @param margin bodies at most this far apart are in contact, m; not negative. With 0, touching
/// and overlapping bodies have points, up to rounding
template <std::floating_point S>
ContactManifold<S> contact_manifold(const Sphere<S>& a, const Sphere<S>& b, const S& margin) {
  return detail::single_point(a, b, margin);
}
/// A sphere and a capsule: one point.
template <std::floating_point S>
ContactManifold<S> contact_manifold(const Sphere<S>& a, const Capsule<S>& b, const S& margin) {
  return detail::single_point(a, b, margin);
}
/// A sphere and a box: one point.
template <std::floating_point S>
ContactManifold<S> contact_manifold(const Sphere<S>& a, const OrientedBox<S>& b, const S& margin) {
  return detail::single_point(a, b, margin);
}
/// A sphere and a half-space: one point.
template <std::floating_point S>
ContactManifold<S> contact_manifold(const Sphere<S>& a, const HalfSpace<S>& b, const S& margin) {
  return detail::single_point(a, b, margin);
}
// [/single]

// [capsules]
/// The sine of the angle below which a capsule counts as parallel to another body: 1/64. It decides
/// only whether there are one or two points; each point has its own distance.
template <std::floating_point S>
inline constexpr S parallel_sine = S(0x1p-6);

namespace detail {

/// The manifold of two bodies that overlap or are near, of an ordinary size.
template <std::floating_point S>
ContactManifold<S> capsules_manifold(const Capsule<S>& a, const Capsule<S>& b, const S& margin) {
  const SignedDistance<S> near = signed_distance(a, b);
  const Vector3<S> d = a.core.end - a.core.start;
  const Vector3<S> e = b.core.end - b.core.start;
  const S whole = d.dot(d);
  const S sine = length<S>(d.cross(e));
  if (!(sine <= parallel_sine<S> * length<S>(d) * length<S>(e)) || !(whole > S(0)) ||
      !(e.dot(e) > S(0))) {
    return single_point(a, b, near, margin);
  }
  const S one = d.dot(Vector3<S>(b.core.start - a.core.start)) / whole;
  const S other = d.dot(Vector3<S>(b.core.end - a.core.start)) / whole;
  const S low = std::min(one, other), high = std::max(one, other);
  const S first = std::max(S(0), low), last = std::min(S(1), high);
  if (!(first < last)) return single_point(a, b, near, margin);
  // An end of A over B's side, or an end of B over A's.
  const SurfaceFeature side = edge_feature(0, 1);
  const int start_of_b = one <= other ? 0 : 1;
  const std::array<PointFeatures, 2> features{
      low <= S(0) ? PointFeatures{vertex_feature(0), side}
                  : PointFeatures{side, vertex_feature(start_of_b)},
      high >= S(1) ? PointFeatures{vertex_feature(1), side}
                   : PointFeatures{side, vertex_feature(1 - start_of_b)}};
  ContactManifold<S> manifold{near.normal, {}};
  for (std::size_t i = 0; i < 2; ++i) {
    const Vector3<S> on_a = point_at<S>(a.core, i == 0 ? first : last);
    const Vector3<S> on_b = closest_point<S>(on_a, b.core);
    const S distance = near.normal.dot(Vector3<S>(on_a - on_b)) - (a.radius + b.radius);
    add_manifold_point<S>(manifold, Vector3<S>(on_a - near.normal * a.radius), distance, margin,
                          features[i]);
  }
  merge_close_points(manifold, std::min(length<S>(d), length<S>(e)));
  return manifold;
}

/// Half of the shorter side of a box's face, which is its face_size() to within a factor of 2.
template <std::floating_point S>
S size_of_face(const OrientedBox<S>& box, int axis) {
  return std::min(box.half_lengths((axis + 1) % 3), box.half_lengths((axis + 2) % 3));
}

/// The features of a point of a capsule's core over a face of a box: an end and the face, or the
/// side and the edge of the face at which it was clipped.
template <std::floating_point S>
PointFeatures features_over_face(const Vector3<S>& p, const Capsule<S>& capsule,
                                 const OrientedBox<S>& box, int axis, bool positive) {
  if (p == capsule.core.start) return {vertex_feature(0), {}};
  if (p == capsule.core.end) return {vertex_feature(1), {}};
  const Vector3<S> local = in_box_axes(box, p);
  const int i = (axis + 1) % 3, k = (axis + 2) % 3;
  const bool at_i = std::abs(std::abs(local(i)) - box.half_lengths(i)) <=
                    std::abs(std::abs(local(k)) - box.half_lengths(k));
  const int clipped = at_i ? i : k, along = at_i ? k : i;
  const int corner = (positive ? 1 << axis : 0) | (local(clipped) > S(0) ? 1 << clipped : 0);
  return {edge_feature(0, 1), edge_feature(corner, corner | (1 << along))};
}

template <std::floating_point S>
ContactManifold<S> capsule_box_manifold(const Capsule<S>& a, const OrientedBox<S>& b,
                                        const S& margin) {
  const SignedDistance<S> near = signed_distance(a, b);
  const Vector3<S>& n = near.normal;
  const Vector3<S> d = a.core.end - a.core.start;
  int axis = 0;
  for (int i = 1; i < 3; ++i) {
    if (std::abs(n.dot(Vector3<S>(b.axes.col(i)))) >
        std::abs(n.dot(Vector3<S>(b.axes.col(axis))))) {
      axis = i;
    }
  }
  const S facing = n.dot(Vector3<S>(b.axes.col(axis)));
  const bool on_face = std::abs(facing) >= S(1) - parallel_sine<S> * parallel_sine<S>;
  const bool lies = std::abs(n.dot(d)) <= parallel_sine<S> * length<S>(d);
  if (d == Vector3<S>::Zero() || !on_face || !lies) return single_point(a, b, near, margin);
  const Vector3<S> first = lowest_over_face<S>(a.core, b, axis);
  const Vector3<S> last = lowest_over_face<S>(Segment<S>{a.core.end, a.core.start}, b, axis);
  ContactManifold<S> manifold{n, {}};
  const S top = n.dot(b.centre) + projected_radius(b, n);
  for (const Vector3<S>& p : {first, last}) {
    add_manifold_point<S>(manifold, Vector3<S>(p - n * a.radius), S(n.dot(p) - top - a.radius),
                          margin, features_over_face<S>(p, a, b, axis, facing > S(0)));
  }
  merge_close_points(manifold, std::min(length<S>(d), size_of_face(b, axis)));
  if (manifold.points.empty()) return single_point(a, b, near, margin);
  return manifold;
}

}  // namespace detail

/// Two capsules: one point, or two if they are parallel. Then the points are the ends of the
/// overlap of their cores.
template <std::floating_point S>
ContactManifold<S> contact_manifold(const Capsule<S>& a, const Capsule<S>& b, const S& margin) {
  return detail::ordered_manifold(a, b, margin, detail::capsules_manifold<S>);
}

/// A capsule and a half-space: each end of the core within the margin.
template <std::floating_point S>
ContactManifold<S> contact_manifold(const Capsule<S>& a, const HalfSpace<S>& b, const S& margin) {
  ContactManifold<S> manifold{b.boundary.normal, {}};
  const auto add = [&](const Vector3<S>& end, int vertex) {
    detail::add_manifold_point<S>(manifold, Vector3<S>(end - b.boundary.normal * a.radius),
                                  S(signed_distance(b.boundary, end) - a.radius), margin,
                                  {vertex_feature(vertex), {}});
  };
  add(a.core.start, 0);
  if (a.core.end != a.core.start) add(a.core.end, 1);
  return manifold;
}

/// A capsule and a box: one point, or two if the capsule is parallel to a face. Then the points are
/// the ends of the part of its core above the face.
template <std::floating_point S>
ContactManifold<S> contact_manifold(const Capsule<S>& a, const OrientedBox<S>& b, const S& margin) {
  return detail::manifold_of_any_size(a, b, margin, detail::capsule_box_manifold<S>);
}
// [/capsules]

// [box-half-space]
/// A box and a half-space: the corners within the margin, at most the four lowest, in the order of
/// box_corner(). Of equally low corners the first are taken.
template <std::floating_point S>
ContactManifold<S> contact_manifold(const OrientedBox<S>& a, const HalfSpace<S>& b,
                                    const S& margin) {
  std::vector<int> order{0, 1, 2, 3, 4, 5, 6, 7};
  std::vector<S> distance;
  distance.reserve(8);
  for (const int k : order) distance.push_back(signed_distance(b.boundary, box_corner(a, k)));
  const auto at = [&distance](int k) { return distance[static_cast<std::size_t>(k)]; };
  std::stable_sort(order.begin(), order.end(), [&at](int i, int k) { return at(i) < at(k); });
  order.resize(4);
  std::sort(order.begin(), order.end());
  ContactManifold<S> manifold{b.boundary.normal, {}};
  for (const int k : order) {
    detail::add_manifold_point<S>(manifold, box_corner(a, k), at(k), margin,
                                  {vertex_feature(k), {}});
  }
  return manifold;
}
// [/box-half-space]

// [boxes]
/// By how much an edge–edge axis must separate the boxes more than the face axes before it is
/// chosen, as a fraction of the smallest half length: 2^-10. A box that rests on another is rotated
/// slightly by rounding; one point in place of four would let it rock.
template <std::floating_point S>
inline constexpr S face_preference = S(0x1p-10);

namespace detail {

/// The four sides of a box's face, in the order of polygon_over_face() of chapter 9.
template <std::floating_point S>
std::vector<ReferenceSide<S>> sides_of_face(const OrientedBox<S>& box, int axis, bool positive) {
  std::vector<ReferenceSide<S>> sides;
  for (int k = 1; k < 3; ++k) {
    const int side = (axis + k) % 3, along = (axis + 3 - k) % 3;
    const Vector3<S> n = box.axes.col(side);
    const S middle = n.dot(box.centre);
    const int corner = positive ? 1 << axis : 0, beyond = corner | (1 << side);
    sides.push_back(
        {n, S(middle + box.half_lengths(side)), edge_feature(beyond, beyond | (1 << along))});
    sides.push_back({Vector3<S>(-n), S(box.half_lengths(side) - middle),
                     edge_feature(corner, corner | (1 << along))});
  }
  return sides;
}

template <std::floating_point S>
ContactManifold<S> boxes_manifold(const OrientedBox<S>& a, const OrientedBox<S>& b,
                                  const S& margin) {
  const AxisSeparation<S> face = max_separation<S>(a, b, 0, 5);
  if (face.separation > margin) return {face.normal, {}};
  const AxisSeparation<S> edges = max_separation<S>(a, b, 6, box_axis_count - 1);
  if (edges.axis >= 0 && edges.separation > margin) return {edges.normal, {}};
  const S slack =
      face_preference<S> * std::min(a.half_lengths.minCoeff(), b.half_lengths.minCoeff());
  if (edges.axis >= 0 && edges.separation > face.separation + slack) {
    return single_point(a, b, margin);
  }
  const bool of_a = face.axis < 3;
  const int axis = face.axis % 3;
  const OrientedBox<S>& reference = of_a ? a : b;
  const OrientedBox<S>& incident = of_a ? b : a;
  const Vector3<S> outward = of_a ? Vector3<S>(-face.normal) : face.normal;
  const BoxFace<S> looking = face_towards<S>(incident, Vector3<S>(-outward));
  const bool positive = outward.dot(Vector3<S>(reference.axes.col(axis))) > S(0);
  const std::vector<OverlapVertex<S>> overlap = face_overlap<S>(
      {looking.corners.begin(), looking.corners.end()},
      {looking.indices.begin(), looking.indices.end()}, sides_of_face(reference, axis, positive));
  const Vector3<S> top = reference.centre + outward * reference.half_lengths(axis);
  ContactManifold<S> manifold{face.normal, {}};
  for (const OverlapVertex<S>& v : overlap) {
    const S distance = outward.dot(Vector3<S>(v.point - top));
    const Vector3<S> on_a = of_a ? Vector3<S>(v.point - outward * distance) : v.point;
    const PointFeatures features{v.reference, v.incident};
    add_manifold_point<S>(manifold, on_a, distance, margin, of_a ? features : exchanged(features));
  }
  keep_outline(manifold, std::min(size_of_face(reference, axis),
                                  face_size<S>({looking.corners.begin(), looking.corners.end()})));
  if (manifold.points.empty()) return single_point(a, b, margin);
  return manifold;
}

}  // namespace detail

/// Two boxes.
///
/// If a face normal is the axis of largest separation, its face is the reference face, and the
/// incident face of the other box is clipped against its sides. The points of the clipped polygon
/// within the margin, at most eight, are the manifold, in the order of box_face(). Of points that
/// coincide the first stays, and points between others are left out, both to within 2^-20 (float:
/// 2^-12) of the smaller face, so that rounding does not change their number. If an edge–edge axis
/// separates clearly more, the contact is the one point between the two edges.
///
/// Where corners meet, many directions are possible normals. The first of the fifteen axes with the
/// largest separation is taken, of the box that comes first along the coordinate in which the
/// centres differ most, so the choice is the same in every run and with the boxes exchanged. If the
/// clipped polygon has no point within the margin, the closest points are the contact.
template <std::floating_point S>
ContactManifold<S> contact_manifold(const OrientedBox<S>& a, const OrientedBox<S>& b,
                                    const S& margin) {
  return detail::ordered_manifold(a, b, margin, detail::boxes_manifold<S>);
}
// [/boxes]

/// A capsule and a sphere: one point.
template <std::floating_point S>
ContactManifold<S> contact_manifold(const Capsule<S>& a, const Sphere<S>& b, const S& margin) {
  return exchanged(contact_manifold(b, a, margin));
}
/// A box and a sphere: one point.
template <std::floating_point S>
ContactManifold<S> contact_manifold(const OrientedBox<S>& a, const Sphere<S>& b, const S& margin) {
  return exchanged(contact_manifold(b, a, margin));
}
/// A box and a capsule.
template <std::floating_point S>
ContactManifold<S> contact_manifold(const OrientedBox<S>& a, const Capsule<S>& b, const S& margin) {
  return exchanged(contact_manifold(b, a, margin));
}
/// A half-space and a sphere, a capsule or a box.
template <std::floating_point S, template <class> class Shape>
ContactManifold<S> contact_manifold(const HalfSpace<S>& a, const Shape<S>& b, const S& margin) {
  return exchanged(contact_manifold(b, a, margin));
}

}  // namespace contact
