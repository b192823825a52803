/// @file
/// Exercise: how a moving body sees a vertex of another one.
#pragma once

#include <contact/prelude.hpp>

#include <contact/shapes.hpp>

namespace exercise {

/// The poses of a body at the beginning and at the end of a step of a simulation.
///
/// A pose is a rigid matrix: a rotation and a translation in m, with the last row (0, 0, 0, 1). It
/// takes points from the body's own frame to the world, as columns: (x, y, z, 1) stands on the
/// right of the matrix.
struct Motion {
  Eigen::Matrix4d before;
  Eigen::Matrix4d after;
};

/// The delta matrix of a body: it takes a point of the world that is attached to the body from
/// where it is at the beginning of the step to where it is at the end.
///
/// With it the body can be taken to be at its later pose all the time: seen from the body, a point
/// that goes from p to q is at both ends of the step where a point that goes from delta p to q is.
Eigen::Matrix4d delta_matrix(const Motion& body);

/// The segment from where B sees a vertex of A at the beginning of the step to where B sees it at
/// the end, both in B's own frame, to which the triangles of B belong.
/// @param vertex in A's own frame, m
contact::Segment<double> segment_seen(const Motion& a, const Motion& b,
                                      const Eigen::Vector3d& vertex);

/// How far from that segment B may see the vertex during the step, in m.
///
/// In the step the origin of each body moves along a straight line at a constant speed. Meanwhile
/// the body rotates about an axis through its origin, at a constant rate, by the angle between its
/// two orientations. It is α for A and β for B, less than π.
///
/// If the acceleration of a path is at most K (in m, with the step as the unit of time), the path
/// is at most K / 8 from the segment between its ends. As B sees it, the acceleration of the vertex
/// is at most the sum of three terms:
///
/// - that of the rotation of A, α² times the distance of the vertex from A's origin;
/// - Coriolis, 2 β times the speed of the vertex relative to B's origin. That is at most the length
///   of the difference of the displacements of the two origins, plus α times the distance of the
///   vertex from A's origin;
/// - centrifugal, β² times the distance of the vertex from B's origin. That is at most the larger
///   one of its values at the beginning and at the end, plus an eighth of the first term.
///
/// @return K / 8 with K the sum of these, within rounding: 0 if no body rotates, and accurate for
///   small angles too
double chord_bound(const Motion& a, const Motion& b, const Eigen::Vector3d& vertex);

}  // namespace exercise
