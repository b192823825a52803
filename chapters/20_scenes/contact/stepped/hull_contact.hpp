/// @file
/// Contact points of a convex hull with a ball, a capsule, a box or another hull.
#pragma once

#include <vector>

#include <contact/capsule.hpp>
#include <contact/contact_manifold.hpp>
#include <contact/convex_bodies.hpp>
#include <contact/oriented_box.hpp>
#include <contact/shapes.hpp>
#include <contact/signed_distance.hpp>
#include <contact/vector.hpp>

namespace contact {

/// The vertices of a body's core, whose radius does not count.
inline std::vector<Vector3<double>> core_vertices(const Sphere<double>& body) {
  return {body.centre};
}
inline std::vector<Vector3<double>> core_vertices(const Capsule<double>& body) {
  return {body.core.start, body.core.end};
}
inline std::vector<Vector3<double>> core_vertices(const ConvexHull<double>& body) {
  return body.vertices;
}
std::vector<Vector3<double>> core_vertices(const OrientedBox<double>& body);

// [face-contact]
/// The points at which two convex bodies are at most the margin apart, in the direction in which
/// they are closest.
///
/// A face of one body that is perpendicular to this direction, to 2^-20 of its size, is the window.
/// The part of the other that is farthest against it, to an eighth of its size, is projected onto
/// it and clipped by its edges; the vertices of the clipped part within the margin are the points.
/// If neither has such a face, or no vertex is left, the pair of closest points is the only one.
/// @param a, b the vertices of the cores, m
/// @param radius sum of the radii, m
/// @param gap the signed distance of the bodies
/// @param margin m
ContactManifold<double> face_contact(const std::vector<Vector3<double>>& a,
                                     const std::vector<Vector3<double>>& b, double radius,
                                     const SignedDistance<double>& gap, double margin);
// [/face-contact]

}  // namespace contact

#ifndef CONTACT_SCENES_COMPILED
#include "../../src/hull_contact.cpp"
#endif
