/// @file
/// A contact manifold: its normal, its points, and the features of both bodies that make each
/// point.
#pragma once

#include <algorithm>
#include <compare>
#include <vector>

#include <contact/vector.hpp>

namespace contact {

// [features]
/// A feature of a body's surface, by the vertices of its core (vertex() of chapter 9): a vertex, an
/// edge, or what is neither: a face, or the surface of a half-space.
struct SurfaceFeature {
  int first = -1;   ///< the vertex, or the edge's vertex of smaller index; −1: neither
  int second = -1;  ///< the edge's other vertex; of a vertex the same as `first`
  /// Features are equal if they have the same vertices; the order has no meaning of its own.
  friend auto operator<=>(const SurfaceFeature&, const SurfaceFeature&) = default;
};

/// A vertex.
constexpr SurfaceFeature vertex_feature(int vertex) { return {vertex, vertex}; }

/// The edge of two vertices, in either order.
constexpr SurfaceFeature edge_feature(int one, int other) {
  return {std::min(one, other), std::max(one, other)};
}

/// The features that make a contact point: a vertex and a face, two edges, or, where the closest
/// points lie so, others. They are an id of the point that does not depend on which body has the
/// reference face.
struct PointFeatures {
  SurfaceFeature of_a;  ///< of A
  SurfaceFeature of_b;  ///< of B
  /// Equal if both features are.
  friend auto operator<=>(const PointFeatures&, const PointFeatures&) = default;
};
// [/features]

/// The same features with the two bodies exchanged.
constexpr PointFeatures exchanged(const PointFeatures& features) {
  return {features.of_b, features.of_a};
}

// [manifold]
/// A point of a contact manifold.
template <Ring S>
struct ManifoldPoint {
  Vector3<S> point = Vector3<S>::Zero();  ///< midway between the two surfaces, m
  S distance = S(0);         ///< of the surfaces along the normal, m; negative: penetration
  PointFeatures features{};  ///< which make the point
};

/// The contact manifold of two bodies A and B. Without points there is no contact.
template <Ring S>
struct ContactManifold {
  Vector3<S> normal = Vector3<S>::Zero();  ///< unit vector, from B to A
  std::vector<ManifoldPoint<S>> points;    ///< in an order that depends only on the bodies
};
// [/manifold]

/// The same manifold with the two bodies exchanged. A coordinate 0 of the normal stays 0 and does
/// not become −0.
template <Ring S>
ContactManifold<S> exchanged(ContactManifold<S> manifold) {
  manifold.normal = Vector3<S>(Vector3<S>::Zero() - manifold.normal);
  for (ManifoldPoint<S>& p : manifold.points) p.features = exchanged(p.features);
  return manifold;
}

}  // namespace contact
