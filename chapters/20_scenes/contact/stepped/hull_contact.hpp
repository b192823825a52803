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

/// The core of a ball, its centre. The radius of a body does not count.
inline std::vector<Vector3<double>> core_vertices(const Sphere<double>& body) {
  return {body.centre};
}
/// The two ends of a capsule's core.
inline std::vector<Vector3<double>> core_vertices(const Capsule<double>& body) {
  return {body.core.start, body.core.end};
}
/// The vertices of a hull.
inline std::vector<Vector3<double>> core_vertices(const ConvexHull<double>& body) {
  return body.vertices;
}
/// The eight corners of a box.
std::vector<Vector3<double>> core_vertices(const OrientedBox<double>& body);

// [face-contact]
/// The points at which two convex bodies are at most the margin apart, in the direction in which
/// they are closest.
///
/// A face of one body that is perpendicular to this direction, to 2^-20 of its size, is the window.
/// The face of the other that looks most against it, if it rises by at most an eighth of its length
/// (else such an edge), is projected onto the window and clipped by its edges; the vertices of the
/// clipped part within the margin are the points. The pair of closest points is added if it is
/// deeper than all of them. It is the only one if neither body has such a face, or no vertex is
/// left. Behind the face the other may be thin, or wider than the face.
/// @param a, b the vertices of the cores, m; not empty
/// @param radius sum of the radii, m
/// @param gap the signed distance of the bodies
/// @param margin m
/// @return no points if the distance exceeds the margin or is NaN; only then signed_distance() has
/// no normal
ContactManifold<double> face_contact(const std::vector<Vector3<double>>& a,
                                     const std::vector<Vector3<double>>& b, double radius,
                                     const SignedDistance<double>& gap, double margin);
// [/face-contact]

}  // namespace contact

#ifndef CONTACT_SCENES_COMPILED
#include "../../src/hull_contact.cpp"
#endif
