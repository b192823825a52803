/// @file
/// Exercise: the point of a body that is farthest along a direction.
///
/// Coordinates of positions are whole numbers from -1000 to 1000, radii and half lengths from 1 to
/// 1000, m. The two ends of a core differ. The axes of boxes and ellipsoids are the columns of a
/// matrix, as unit vectors in world coordinates, perpendicular to each other except for rounding.
#pragma once

#include <contact/prelude.hpp>

#include <contact/capsule.hpp>
#include <contact/oriented_box.hpp>
#include <contact/shapes.hpp>

namespace exercise {

/// A solid cylinder: all points at most radius from the line of the core, between the planes
/// through its ends and perpendicular to it.
struct Cylinder {
  contact::Segment<double> core;  ///< m
  double radius;                  ///< m
};

/// A solid ellipsoid: all points centre + x h₀ a₀ + y h₁ a₁ + z h₂ a₂ with x² + y² + z² ≤ 1, for
/// the axes a and the half lengths h.
struct Ellipsoid {
  Eigen::Vector3d centre;        ///< m
  Eigen::Matrix3d axes;          ///< columns in world coordinates
  Eigen::Vector3d half_lengths;  ///< along each axis, m
};

/// A convex body of one of five kinds.
struct Body {
  std::variant<contact::Sphere<double>, contact::Capsule<double>, contact::OrientedBox<double>,
               Cylinder, Ellipsoid>
      shape;
};

/// A point p of the body with the largest n · p, for the direction n.
///
/// Each coordinate may be off by 1e-9. If several points are farthest, any of them is right. No
/// point is farther than another along the zero direction, so any point of the body is right then.
///
/// @param direction of any length, perhaps zero; each coordinate is 0, or its magnitude is from
/// 1e-250 to 1e250
/// @return m
Eigen::Vector3d support(const Body& body, const Eigen::Vector3d& direction);

/// The same for the difference of two bodies: of all differences p - q of a point p of the first
/// and a point q of the second, one with the largest n · (p - q).
///
/// Each coordinate may be off by 1e-9.
///
/// @param direction as for support()
/// @return m
Eigen::Vector3d support_of_difference(const Body& first, const Body& second,
                                      const Eigen::Vector3d& direction);

}  // namespace exercise
