/// @file
/// Exercise: the box with an object's axes around its vertices.
///
/// The axes of a box are the columns of a matrix, as unit vectors in world coordinates. They are
/// perpendicular to each other, except for rounding. Half lengths go from the centre to a face, and
/// may be 0 here. Each number of an answer may be off by 1e-9. All the same, a box must contain
/// what it was made for.
#pragma once

#include <contact/prelude.hpp>

#include <contact/oriented_box.hpp>
#include <contact/shapes.hpp>

namespace exercise {

/// The smallest box with these axes that contains all vertices.
///
/// It contains every vertex: with the centre c and the half lengths h as they are returned,
/// |axis · (p - c)| <= h holds exactly, for each vertex p and each column of axes. For this, each
/// half length may be up to 1e-9 larger than the smallest.
///
/// @param axes the columns are the box's axes
/// @param vertices at least one, in world coordinates: whole numbers from -1000 to 1000, m. They
/// may
///   be equal, on one line or in one plane
contact::OrientedBox<double> fit_box(const Eigen::Matrix3d& axes,
                                     const std::vector<Eigen::Vector3d>& vertices);

/// The planes of the six faces. Normals point out of the box.
///
/// @param box its centre and half lengths are whole numbers, at most 1000 from 0, m
/// @return first the face to which the first axis points, then the opposite one, then those of the
///   second axis and those of the third
std::array<contact::Plane<double>, 6> face_planes(const contact::OrientedBox<double>& box);

/// Whether a point is in the box. The faces belong to it.
///
/// If the axes of the box are those of the world, in any order and of any sign, the decision must
/// be right for every point. The contract does not ask about points that are less than 1e-9 from
/// the plane of a face of any other box.
///
/// @param box as for face_planes
/// @param point each coordinate is a multiple of 2^-30 from -2000 to 2000, m
bool is_inside(const contact::OrientedBox<double>& box, const Eigen::Vector3d& point);

}  // namespace exercise
