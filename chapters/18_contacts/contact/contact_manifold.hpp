/// @file
/// The contact manifold of two bodies: one normal, and enough points to support one body on the
/// other.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <vector>

#include <contact/convex_shapes.hpp>
#include <contact/face_clipping.hpp>
#include <contact/signed_distance.hpp>
#include <contact/vector.hpp>

namespace contact {

// [manifold]
/// A point of a contact manifold.
template <Ring S>
struct ManifoldPoint {
  Vector3<S> point = Vector3<S>::Zero();  ///< midway between the two surfaces, m
  S distance = S(0);  ///< of the surfaces along the normal, m; negative: penetration
};

/// The contact manifold of two bodies A and B. Without points there is no contact.
template <Ring S>
struct ContactManifold {
  Vector3<S> normal = Vector3<S>::Zero();  ///< unit vector, from B to A
  std::vector<ManifoldPoint<S>> points;    ///< in an order that depends only on the bodies
};
// [/manifold]

/// The same manifold with the two bodies exchanged.
template <Ring S>
ContactManifold<S> exchanged(ContactManifold<S> manifold) {
  manifold.normal = -manifold.normal;
  return manifold;
}

namespace detail {

/// Adds a point of A's surface at the given distance from B's, unless it exceeds the margin.
template <std::floating_point S>
void add_manifold_point(ContactManifold<S>& manifold, const Vector3<S>& on_a, const S& distance,
                        const S& margin) {
  if (!(distance <= margin)) return;
  manifold.points.push_back({Vector3<S>(on_a - manifold.normal * (distance / S(2))), distance});
}

template <std::floating_point S>
ContactManifold<S> single_point(const SignedDistance<S>& between, const S& margin) {
  ContactManifold<S> manifold{between.normal, {}};
  add_manifold_point<S>(manifold, between.on_a, between.distance, margin);
  return manifold;
}

}  // namespace detail

// [single]
/// Two spheres: one point.
/// @param margin bodies at most this far apart are in contact, m; not negative. With 0, touching
/// and overlapping bodies have points, up to rounding
template <std::floating_point S>
ContactManifold<S> contact_manifold(const Sphere<S>& a, const Sphere<S>& b, const S& margin) {
  return detail::single_point(signed_distance(a, b), margin);
}
/// A sphere and a capsule: one point.
template <std::floating_point S>
ContactManifold<S> contact_manifold(const Sphere<S>& a, const Capsule<S>& b, const S& margin) {
  return detail::single_point(signed_distance(a, b), margin);
}
/// A sphere and a box: one point.
template <std::floating_point S>
ContactManifold<S> contact_manifold(const Sphere<S>& a, const OrientedBox<S>& b, const S& margin) {
  return detail::single_point(signed_distance(a, b), margin);
}
/// A sphere and a half-space: one point.
template <std::floating_point S>
ContactManifold<S> contact_manifold(const Sphere<S>& a, const HalfSpace<S>& b, const S& margin) {
  return detail::single_point(signed_distance(a, b), margin);
}
// [/single]

// [capsules]
/// The sine of the angle below which a capsule counts as parallel to another body: 1/64. It decides
/// only whether there are one or two points; each point has its own distance.
template <std::floating_point S>
inline constexpr S parallel_sine = S(0x1p-6);

/// Two capsules: one point, or two if they are parallel. Then the points are the ends of the
/// overlap of their cores.
template <std::floating_point S>
ContactManifold<S> contact_manifold(const Capsule<S>& a, const Capsule<S>& b, const S& margin) {
  const SignedDistance<S> near = signed_distance(a, b);
  const Vector3<S> d = a.core.end - a.core.start;
  const Vector3<S> e = b.core.end - b.core.start;
  const S whole = d.dot(d);
  const S sine = detail::length<S>(d.cross(e));
  if (!(sine <= parallel_sine<S> * detail::length<S>(d) * detail::length<S>(e)) ||
      !(whole > S(0)) || !(e.dot(e) > S(0))) {
    return detail::single_point(near, margin);
  }
  const S one = d.dot(Vector3<S>(b.core.start - a.core.start)) / whole;
  const S other = d.dot(Vector3<S>(b.core.end - a.core.start)) / whole;
  const S first = std::max(S(0), std::min(one, other));
  const S last = std::min(S(1), std::max(one, other));
  if (!(first < last)) return detail::single_point(near, margin);
  ContactManifold<S> manifold{near.normal, {}};
  for (const S& t : {first, last}) {
    const Vector3<S> on_a = detail::point_at<S>(a.core, t);
    const Vector3<S> on_b = closest_point<S>(on_a, b.core);
    const S distance = near.normal.dot(Vector3<S>(on_a - on_b)) - (a.radius + b.radius);
    detail::add_manifold_point<S>(manifold, Vector3<S>(on_a - near.normal * a.radius), distance,
                                  margin);
  }
  return manifold;
}

/// A capsule and a half-space: each end of the core within the margin.
template <std::floating_point S>
ContactManifold<S> contact_manifold(const Capsule<S>& a, const HalfSpace<S>& b, const S& margin) {
  ContactManifold<S> manifold{b.boundary.normal, {}};
  const auto add = [&](const Vector3<S>& end) {
    detail::add_manifold_point<S>(manifold, Vector3<S>(end - b.boundary.normal * a.radius),
                                  S(signed_distance(b.boundary, end) - a.radius), margin);
  };
  add(a.core.start);
  if (a.core.end != a.core.start) add(a.core.end);
  return manifold;
}

/// A capsule and a box: one point, or two if the capsule is parallel to a face. Then the points are
/// the ends of the part of its core above the face.
template <std::floating_point S>
ContactManifold<S> contact_manifold(const Capsule<S>& a, const OrientedBox<S>& b, const S& margin) {
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
  const bool lies = std::abs(n.dot(d)) <= parallel_sine<S> * detail::length<S>(d);
  if (d == Vector3<S>::Zero() || !on_face || !lies) return detail::single_point(near, margin);
  const Vector3<S> first = detail::lowest_over_face<S>(a.core, b, axis);
  const Vector3<S> last =
      detail::lowest_over_face<S>(Segment<S>{a.core.end, a.core.start}, b, axis);
  ContactManifold<S> manifold{n, {}};
  const S top = n.dot(b.centre) + projected_radius(b, n);
  for (const Vector3<S>& p : {first, last}) {
    detail::add_manifold_point<S>(manifold, Vector3<S>(p - n * a.radius),
                                  S(n.dot(p) - top - a.radius), margin);
    if (first == last) break;
  }
  if (manifold.points.empty()) return detail::single_point(near, margin);
  return manifold;
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
    detail::add_manifold_point<S>(manifold, box_corner(a, k), at(k), margin);
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

/// Two boxes.
///
/// If a face normal is the axis of largest separation, its face is the reference face, and the
/// incident face of the other box is clipped against its sides. The points of the clipped polygon
/// within the margin, at most eight, are the manifold, in the order of box_face(). If an edge–edge
/// axis separates clearly more, the contact is the one point between the two edges.
///
/// Where corners meet, many directions are possible normals. The first of the fifteen axes with the
/// largest separation is taken, so the choice is the same in every run. If the clipped polygon has
/// no point within the margin, the closest points are the contact.
template <std::floating_point S>
ContactManifold<S> contact_manifold(const OrientedBox<S>& a, const OrientedBox<S>& b,
                                    const S& margin) {
  const detail::AxisSeparation<S> face = detail::max_separation<S>(a, b, 0, 5);
  if (face.separation > margin) return {face.normal, {}};
  const detail::AxisSeparation<S> edges = detail::max_separation<S>(a, b, 6, box_axis_count - 1);
  if (edges.axis >= 0 && edges.separation > margin) return {edges.normal, {}};
  const S slack =
      face_preference<S> * std::min(a.half_lengths.minCoeff(), b.half_lengths.minCoeff());
  if (edges.axis >= 0 && edges.separation > face.separation + slack) {
    return detail::single_point(signed_distance(a, b), margin);
  }
  const bool of_a = face.axis < 3;
  const int axis = face.axis % 3;
  const OrientedBox<S>& reference = of_a ? a : b;
  const OrientedBox<S>& incident = of_a ? b : a;
  const Vector3<S> outward = of_a ? Vector3<S>(-face.normal) : face.normal;
  const BoxFace<S> looking = face_towards<S>(incident, Vector3<S>(-outward));
  const std::vector<Vector3<S>> polygon = polygon_over_face<S>(
      std::vector<Vector3<S>>(looking.corners.begin(), looking.corners.end()), reference, axis);
  const Vector3<S> top = reference.centre + outward * reference.half_lengths(axis);
  ContactManifold<S> manifold{face.normal, {}};
  for (const Vector3<S>& p : polygon) {
    const S distance = outward.dot(Vector3<S>(p - top));
    const Vector3<S> on_a = of_a ? Vector3<S>(p - outward * distance) : p;
    detail::add_manifold_point<S>(manifold, on_a, distance, margin);
  }
  if (manifold.points.empty()) return detail::single_point(signed_distance(a, b), margin);
  return manifold;
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
