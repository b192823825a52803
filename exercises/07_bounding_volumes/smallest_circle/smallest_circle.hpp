/// @file
/// Exercise: the smallest circle around points in the plane.
///
/// All coordinates are multiples of 1/8 from -100 to 100, in m, so that a double holds every
/// difference of two positions, every product of two differences and every sum of products of four
/// without rounding: decisions about points must be right for every input. Centres and radii are
/// rounded: each number may be off by 1e-9.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// All points of the plane at most radius from centre.
struct Circle {
  Eigen::Vector2d centre;  ///< m
  double radius;           ///< m, not negative
};

/// Whether a point is inside the circle through three others, or on it.
///
/// @param a, b, c not on one line; clockwise or counter-clockwise
/// @param p anywhere
bool in_circle_through(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
                       const Eigen::Vector2d& p);

/// The smallest circle that contains all points. Two of them are the ends of a diameter of it, or
/// it is the circle through three of them; with one point, or equal points, its radius is 0.
///
/// It contains every point: with the centre c and the radius r as they are returned, |p - c| <= r
/// holds exactly, for each point p. For this, r may be up to 1e-9 larger than the smallest.
///
/// @param points from 1 to 50; they may be equal, on one line or on one circle. Trying all pairs
///   and all triples is fast enough
Circle smallest_circle(const std::vector<Eigen::Vector2d>& points);

}  // namespace exercise
