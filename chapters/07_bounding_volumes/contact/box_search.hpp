/// @file
/// The search for axes along which the box of some points is small: turns to the smallest rectangle
/// about one axis after the other, and Nelder and Mead's simplex. Rounded throughout; a box along
/// what it finds is made by box_with_axes().
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include <contact/frame.hpp>
#include <contact/orientation.hpp>
#include <contact/principal_axes.hpp>
#include <contact/vector.hpp>

namespace contact::box_search_detail {

using Point = Vector3<double>;
using Flat = Vector2<double>;

/// Axes, and the volume of the box along them.
struct Candidate {
  Matrix3<double> axes = Matrix3<double>::Identity();       ///< right-handed, orthonormal
  double volume = std::numeric_limits<double>::infinity();  ///< in the unit of the points, cubed
};

/// Where points are along three axes.
struct Extent {
  Point low, high;          ///< coordinates along the axes
  std::array<int, 6> at{};  ///< the points that have them: low of each axis, then high

  /// The volume of the box.
  double volume() const { return (high[0] - low[0]) * (high[1] - low[1]) * (high[2] - low[2]); }
};

/// Of the points along the axes.
inline Extent extent_along(const std::vector<Point>& points, const Matrix3<double>& axes) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Extent extent{Point::Constant(infinity), Point::Constant(-infinity)};
  for (std::size_t n = 0; n < points.size(); ++n) {
    const Point& p = points[n];
    for (int i = 0; i < 3; ++i) {
      const double y = axes(0, i) * p[0] + axes(1, i) * p[1] + axes(2, i) * p[2];
      if (y < extent.low[i]) {
        extent.low[i] = y;
        extent.at[static_cast<std::size_t>(i)] = static_cast<int>(n);
      }
      if (y > extent.high[i]) {
        extent.high[i] = y;
        extent.at[static_cast<std::size_t>(i) + 3] = static_cast<int>(n);
      }
    }
  }
  return extent;
}

/// The hull of points in the plane, counter-clockwise, with rounded decisions: vertices may be
/// lost that are nearly on an edge.
/// @param points are sorted
/// @param hull receives the vertices
inline void rounded_hull(std::vector<Flat>& points, std::vector<Flat>& hull) {
  std::sort(points.begin(), points.end(), [](const Flat& a, const Flat& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  });
  hull.clear();
  const auto add = [&hull](const Flat& p, std::size_t start) {
    while (hull.size() >= start + 2 &&
           !(orientation<double>(hull[hull.size() - 2], hull.back(), p) > 0)) {
      hull.pop_back();
    }
    hull.push_back(p);
  };
  for (const Flat& p : points) add(p, 0);
  const std::size_t lower = hull.size() - 1;
  hull.pop_back();
  for (std::size_t i = points.size(); i-- > 0;) add(points[i], lower);
  hull.pop_back();
}

/// The direction of the smallest rectangle around a convex polygon, of those along its edges.
///
/// The extremes are searched in steps from those of the edge before, so a polygon that is convex
/// only up to rounding may give a direction that is not the best one.
inline Flat smallest_direction(const std::vector<Flat>& hull) {
  Flat best(1, 0);
  double least = std::numeric_limits<double>::infinity();
  const std::size_t n = hull.size();
  const auto next = [n](std::size_t i) { return i + 1 < n ? i + 1 : 0; };
  std::size_t first = 0, last = 0, top = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Flat a = hull[i], e = hull[next(i)] - a, left(-e.y(), e.x());
    const double squared = e.dot(e);
    if (!(squared > 0)) continue;
    const auto move = [&](std::size_t& vertex, const Flat& direction) {
      for (std::size_t steps = 0; steps < n; ++steps) {
        if (!(direction.dot(hull[next(vertex)] - hull[vertex]) > 0)) return;
        vertex = next(vertex);
      }
    };
    if (i == 0) last = next(i);
    move(last, e);
    if (i == 0) top = last;
    move(top, left);
    if (i == 0) first = top;
    move(first, -e);
    const double area = e.dot(hull[last] - hull[first]) * left.dot(hull[top] - a) / squared;
    if (area < least) {
      least = area;
      best = e / std::sqrt(squared);
    }
  }
  return best;
}

/// The axes turned by the vector `turn` (for small ones: by an angle of its length about it).
inline Matrix3<double> turned(const Matrix3<double>& axes, const Point& turn) {
  const Point x = axes.col(0), y = axes.col(1), z = axes.col(2);
  return principal_axes_detail::orthonormal<double>(x + turn[2] * y - turn[1] * z,
                                                    y + turn[0] * z - turn[2] * x);
}

/// Whether two boxes have about the same axes, up to order and sign: to within 8°.
inline bool about_equal(const Matrix3<double>& a, const Matrix3<double>& b) {
  for (int i = 0; i < 3; ++i) {
    double most = 0;
    for (int j = 0; j < 3; ++j) most = std::max(most, std::abs(a.col(i).dot(b.col(j))));
    if (most < 0.99) return false;
  }
  return true;
}

/// The search on some points.
class Search {
 public:
  /// The points of the box.
  std::vector<Point> points;

  /// The candidate with these axes.
  Candidate along(const Matrix3<double>& axes) const {
    return {axes, extent_along(points, axes).volume()};
  }

  /// Of all boxes with the third of the axes, the one with the smallest rectangle.
  Candidate about(const Matrix3<double>& axes) {
    flat_.clear();
    const Point x = axes.col(0), y = axes.col(1);
    // + 0: equal points, which a sort may put in any order, are then the same bits.
    for (const Point& p : points) flat_.push_back({x.dot(p) + 0.0, y.dot(p) + 0.0});
    rounded_hull(flat_, hull_);
    const Flat turn = smallest_direction(hull_);
    return along(principal_axes_detail::orthonormal<double>(Point(turn.x() * x + turn.y() * y),
                                                            Point(turn.x() * y - turn.y() * x)));
  }
  /// Of all boxes with this axis.
  Candidate about(const Point& axis) {
    return about(frame_on_normal<double>(Point::Zero(), axis).axes);
  }

  // [descend]
  /// Turns to the smallest rectangle about one axis after the other, as long as the volume falls.
  Candidate descend(Candidate candidate) {
    for (int step = 0, failed = 0; step < 60 && failed < 3; ++step) {
      Matrix3<double> axes;  // the next axis becomes the third
      for (int i = 0; i < 3; ++i) axes.col(i) = candidate.axes.col((i + 1) % 3);
      const Candidate found = about(axes);
      failed = found.volume < candidate.volume * (1 - 1e-9) ? 0 : failed + 1;
      candidate = failed == 0 ? found : Candidate{axes, candidate.volume};
    }
    return candidate;
  }
  // [/descend]

  // [simplex]
  /// Nelder and Mead's simplex in the three coordinates of a turn: a tetrahedron whose worst vertex
  /// is reflected in the others, further or less far, or which shrinks towards the best one.
  /// @param size of the first tetrahedron, rad
  Candidate simplex(const Candidate& start, double size, int steps) const {
    struct Vertex {
      Point turn;
      Candidate at;
    };
    const auto vertex = [&](const Point& turn) {
      return Vertex{turn, along(turned(start.axes, turn))};
    };
    std::array<Vertex, 4> v{Vertex{Point::Zero(), start}, vertex({size, 0, 0}),
                            vertex({0, size, 0}), vertex({0, 0, size})};
    for (int step = 0; step < steps; ++step) {
      // By insertion: std::stable_sort would be 4 kB of a figure, for four vertices.
      for (std::size_t i = 1; i < v.size(); ++i) {
        for (std::size_t j = i; j > 0 && v[j].at.volume < v[j - 1].at.volume; --j) {
          std::swap(v[j], v[j - 1]);
        }
      }
      const Point middle = (v[0].turn + v[1].turn + v[2].turn) / 3, away = middle - v[3].turn;
      const Vertex reflected = vertex(middle + away);
      if (reflected.at.volume < v[0].at.volume) {
        const Vertex further = vertex(middle + 2 * away);
        v[3] = further.at.volume < reflected.at.volume ? further : reflected;
      } else if (reflected.at.volume < v[2].at.volume) {
        v[3] = reflected;
      } else {
        const double side = reflected.at.volume < v[3].at.volume ? 0.5 : -0.5;
        const Vertex nearer = vertex(middle + side * away);
        if (nearer.at.volume < std::min(reflected.at.volume, v[3].at.volume)) {
          v[3] = nearer;
        } else {
          for (std::size_t i = 1; i < 4; ++i) v[i] = vertex((v[0].turn + v[i].turn) / 2);
        }
      }
    }
    return std::min_element(
               v.begin(), v.end(),
               [](const Vertex& a, const Vertex& b) { return a.at.volume < b.at.volume; })
        ->at;
  }
  // [/simplex]

 private:
  std::vector<Flat> flat_, hull_;
};

}  // namespace contact::box_search_detail
