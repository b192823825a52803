/// @file
/// The features of a triangle, its vertices, edges and face, and the kinds of contact that they
/// make.
///
/// Nothing here reads a coordinate: a triangle without area, or one that is not finite, has the
/// same features as any other. An index that is not 0, 1 or 2 is an error of the program.
#pragma once

namespace contact {

// [features]
/// The kinds of features of a triangle or a mesh. A face is a triangle with its border, an edge has
/// its ends; the smallest feature that contains a point has the point in its relative interior.
enum class FeatureKind {
  vertex,  ///< a point
  edge,    ///< a segment
  face     ///< a triangle
};

/// A feature of a triangle.
struct Feature {
  FeatureKind kind = FeatureKind::face;  ///< which of the three
  /// Of a vertex 0, 1 or 2, for a, b and c; edge i runs from vertex i to vertex (i + 1) mod 3; of
  /// the face 0.
  int index = 0;

  friend bool operator==(const Feature&, const Feature&) = default;
};

/// What two triangles have in common.
enum class CommonPoints {
  none,     ///< nothing
  point,    ///< a single point
  segment,  ///< a segment that is longer than a point
  area      ///< a convex polygon, of two triangles in one plane
};

/// The kinds of contact of two features, in either order.
enum class ContactKind {
  point_point,  ///< p2p: a vertex and a vertex
  point_edge,   ///< p2e: a vertex and an edge
  point_face,   ///< p2f: a vertex and a face
  edge_edge,    ///< e2e: two edges
  edge_face,    ///< e2f: an edge and a face
  face_face     ///< f2f: two faces
};
// [/features]

/// The kind of contact of two features of these kinds.
constexpr ContactKind contact_kind(FeatureKind f, FeatureKind g) {
  if (g < f) return contact_kind(g, f);
  if (f == FeatureKind::face) return ContactKind::face_face;
  const ContactKind with_edge =
      f == FeatureKind::vertex ? ContactKind::point_edge : ContactKind::edge_edge;
  const ContactKind with_face =
      f == FeatureKind::vertex ? ContactKind::point_face : ContactKind::edge_face;
  if (g == FeatureKind::vertex) return ContactKind::point_point;
  return g == FeatureKind::edge ? with_edge : with_face;
}

/// The edge of a triangle between two of its vertices, 0 to 2. Of a vertex and itself, the edge
/// that starts there.
constexpr int edge_between(int vertex, int other) {
  return (vertex + 1) % 3 == other ? vertex : other;
}

/// Whether a feature of a triangle, with its border, contains all of another one.
constexpr bool contains(const Feature& large, const Feature& small) {
  if (large.kind == FeatureKind::face) return true;
  if (large.kind == small.kind) return large.index == small.index;
  return large.kind == FeatureKind::edge && small.kind == FeatureKind::vertex &&
         (small.index == large.index || small.index == (large.index + 1) % 3);
}

/// The smallest feature of a triangle that contains two of its features. It is the one that has the
/// interior of the segment between a point of the one and a point of the other.
constexpr Feature smallest_with(const Feature& f, const Feature& g) {
  if (contains(f, g)) return f;
  if (contains(g, f)) return g;
  if (f.kind == FeatureKind::vertex && g.kind == FeatureKind::vertex) {
    return {FeatureKind::edge, edge_between(f.index, g.index)};
  }
  return {};
}

}  // namespace contact
