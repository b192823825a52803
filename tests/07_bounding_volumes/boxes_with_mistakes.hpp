/// @file
/// Boxes with given axes around points, their faces and the points in them, and the same with the
/// mistakes that the tests of the exercise recognise.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <contact/oriented_box.hpp>
#include <contact/shapes.hpp>

#include <07_bounding_volumes/contained.hpp>

namespace boxes_with_mistakes {

using contact::Exact;
using Point = Eigen::Vector3d;
using Points = std::vector<Point>;
using Axes = Eigen::Matrix3d;
using Box = contact::OrientedBox<double>;
using Faces = std::array<contact::Plane<double>, 6>;

/// The rotation by a quaternion of whole numbers.
inline Axes rotation(int w, int x, int y, int z) {
  Axes whole;
  whole << w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y),
      2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x), 2 * (x * z - w * y),
      2 * (y * z + w * x), w * w - x * x - y * y + z * z;
  return whole / (w * w + x * x + y * y + z * z);
}

/// The columns are unit vectors, perpendicular and right-handed, up to rounding.
inline bool is_rotation(const Axes& axes) {
  return axes.allFinite() &&
         (axes.transpose() * axes - Axes::Identity()).cwiseAbs().maxCoeff() < 1e-14 &&
         axes.determinant() > 0;
}
/// The axes of the world in some order, of any sign.
inline bool is_of_the_world(const Axes& axes) {
  return axes.cwiseAbs().cwiseEqual(1).count() == 3 && axes.cwiseEqual(0).count() == 6;
}

struct Range {
  Point low, high;
};

/// How the smallest and the largest coordinate are searched for.
enum class Search { right, high_from_zero, both_from_zero, by_else };

inline Range range(const Axes& axes, const Points& points, Search search = Search::right) {
  const double infinity = std::numeric_limits<double>::infinity();
  Range found{Point::Constant(infinity), Point::Constant(-infinity)};
  if (search == Search::both_from_zero) found.low.setZero();
  if (search == Search::both_from_zero || search == Search::high_from_zero) found.high.setZero();
  for (const Point& p : points) {
    for (int k = 0; k < 3; ++k) {
      const double along = axes.col(k).dot(p);
      const bool is_lower = along < found.low[k];
      if (is_lower) found.low[k] = along;
      if (along > found.high[k] && !(search == Search::by_else && is_lower)) found.high[k] = along;
    }
  }
  return found;
}

/// The box of a range along the axes.
inline Box box_of(const Axes& axes, const Range& range) {
  return {axes * ((range.low + range.high) / 2), axes, (range.high - range.low) / 2};
}
inline Box fit_box(const Axes& axes, const Points& points, Search search = Search::right) {
  return box_of(axes, range(axes, points, search));
}

/// The box around this centre that contains the points.
inline Box around(const Axes& axes, const Point& centre, const Points& points) {
  Point half_lengths = Point::Zero();
  for (const Point& p : points)
    half_lengths = half_lengths.cwiseMax((axes.transpose() * (p - centre)).cwiseAbs());
  return {centre, axes, half_lengths};
}
inline Point mean(const Points& points) {
  Point sum = Point::Zero();
  for (const Point& p : points) sum += p;
  return sum / double(points.size());
}

/// The same numbers with other axes.
inline Box with_axes(Box box, const Axes& axes) {
  box.axes = axes;
  return box;
}
inline Box with_centre(Box box, const Point& centre) {
  box.centre = centre;
  return box;
}

// ---------------------------------------------------------------- faces

/// First and second axis of three, each with the face to which it points and the opposite one.
/// @param plane gives the plane of a face for its outward normal, its axis and its half length
template <class Face>
Faces faces(const Box& box, const Face& face) {
  Faces all;
  for (int k = 0; k < 3; ++k) {
    const Point axis = box.axes.col(k);
    const auto first = static_cast<std::size_t>(2 * k);
    all[first] = face(axis, axis, box.half_lengths[k]);
    all[first + 1] = face(Point(-axis), axis, box.half_lengths[k]);
  }
  return all;
}
inline Faces faces(const Box& box) {
  return faces(box, [&](const Point& normal, const Point&, double half_length) {
    return contact::Plane<double>{normal, normal.dot(box.centre + half_length * normal)};
  });
}

// ---------------------------------------------------------------- inside

/// |axis · (point − centre)| − half length, for each axis, as the numbers are stored.
inline std::array<Exact, 3> beyond(const Box& box, const Point& point) {
  std::array<Exact, 3> result;
  for (int k = 0; k < 3; ++k) {
    Exact along;
    for (int i = 0; i < 3; ++i)
      along += Exact(box.axes(i, k)) * (Exact(point[i]) - Exact(box.centre[i]));
    result[static_cast<std::size_t>(k)] = abs(along) - Exact(box.half_lengths[k]);
  }
  return result;
}
inline bool is_inside(const Box& box, const Point& point) {
  const auto all = beyond(box, point);
  return std::all_of(all.begin(), all.end(), [](const Exact& x) { return x.sign() <= 0; });
}
/// Whether the contract asks about the point.
inline bool is_clear(const Box& box, const Point& point) {
  if (is_of_the_world(box.axes)) return true;
  const auto all = beyond(box, point);
  return std::all_of(all.begin(), all.end(), [](const Exact& x) { return abs(x) > Exact(1e-8); });
}

}  // namespace boxes_with_mistakes
