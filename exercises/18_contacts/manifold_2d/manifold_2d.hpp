/// @file
/// Exercise: the contact points of two convex polygons.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// Vertices in m, counter-clockwise. The edge k goes from vertex k to the next one, the last edge
/// to vertex 0. No two edges have the same direction.
using Polygon = std::vector<Eigen::Vector2d>;

/// A point where the polygons touch.
struct ContactPoint {
  Eigen::Vector2d point;  ///< midway between the two surfaces, along the normal, m
  double distance;        ///< of the surfaces, along the normal, m; negative: they overlap
};

/// Where the polygons touch.
struct Manifold {
  Eigen::Vector2d normal;            ///< unit vector, from polygon b to polygon a
  std::vector<ContactPoint> points;  ///< none, one or two
};

/// The contact points of two convex polygons.
///
/// - The signed distance of a vertex from the line of an edge is positive outside of the edge's
///   polygon and negative inside. The separation of an edge is the smallest of the signed distances
///   of the other polygon's vertices. The edge with the largest separation is the reference edge.
///   Of equal ones that of polygon a counts, and then the one with the smaller index.
/// - The incident edge is the edge of the other polygon whose outward normal is most opposite to
///   that of the reference edge; of equal ones the one with the smaller index.
/// - The incident edge is clipped: what is left is its part between the two lines that are
///   perpendicular to the reference edge and go through its ends.
/// - Each end of this part that is at most the margin from the line of the reference edge, or
///   inside, gives a contact point. If the part is a single point, so is the contact.
///
/// The contact points are in the order in which they lie along the reference edge.
///
/// @param a, b with three or more vertices
/// @param margin m, 0 or more
Manifold contact_manifold(const Polygon& a, const Polygon& b, double margin);

}  // namespace exercise
