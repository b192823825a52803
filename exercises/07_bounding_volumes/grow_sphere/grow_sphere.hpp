/// @file
/// Exercise: a bounding sphere that grows from the most distant extreme pair, as in the lecture.
///
/// All coordinates are multiples of 1/8 from -1000 to 1000, in m, so that a double holds every
/// difference of two positions and its square without rounding. Centres and radii are rounded: each
/// number may be off by 1e-9. All the same, the sphere of grow_sphere must contain every point.
#pragma once

#include <contact/prelude.hpp>

#include <contact/shapes.hpp>

namespace exercise {

/// Two points that are extreme along an axis, by index. The two may be one point.
struct ExtremePair {
  int low;   ///< of a point with the smallest coordinate along the axis
  int high;  ///< of a point with the largest one
};

/// Of the three extreme pairs, along x, y and z, the one whose points are farthest from each other.
///
/// Of several points with the smallest or the largest coordinate, the first in the list counts, and
/// of pairs with the same distance, that of the earlier axis.
///
/// @param points at least one, perhaps several equal ones
ExtremePair most_distant_extremes(const std::vector<Eigen::Vector3d>& points);

/// The smallest sphere around two points.
///
/// @param low, high perhaps equal: then the radius is 0
contact::Sphere<double> start_sphere(const Eigen::Vector3d& low, const Eigen::Vector3d& high);

/// The smallest sphere around a sphere and a point: the sphere itself, if it contains the point.
///
/// @param sphere its radius is a multiple of 1/8 from 0 to 1000
/// @param point anywhere
contact::Sphere<double> grown_by(const contact::Sphere<double>& sphere,
                                 const Eigen::Vector3d& point);

/// The lecture's sphere: the start sphere of the most distant extremes, grown by each point in the
/// order of the list.
///
/// It contains every point: with the centre c and the radius r as they are returned, |p - c| <= r
/// holds exactly, for each point p. For this, r may be up to 1e-9 larger than that of the recipe.
///
/// @param points at least one; they may be equal, on one line or in one plane
contact::Sphere<double> grow_sphere(const std::vector<Eigen::Vector3d>& points);

}  // namespace exercise
