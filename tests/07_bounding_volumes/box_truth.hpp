/// @file
/// Boxes and rectangles in fractions: whether a point is in one as it is stored, and how small one
/// can be. What the chapter's boxes are compared with; nothing here uses the methods
/// of their headers.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <contact/convex_hull.hpp>
#include <contact/oriented_box.hpp>
#include <contact/smallest_rectangle.hpp>
#include <contact/vector.hpp>
#include <cstddef>
#include <numbers>
#include <optional>
#include <support/oracle.hpp>
#include <utility>
#include <vector>

namespace box_truth {

using oracle::Rational;
using oracle::Vector;

template <std::floating_point S>
using Points = std::vector<contact::Vector3<S>>;
template <std::floating_point S>
using FlatPoints = std::vector<contact::Vector2<S>>;

// ---------------------------------------------------------------- boxes

inline Rational determinant(const Vector& a, const Vector& b, const Vector& c) {
  return a.dot(b.cross(c));
}

/// The coordinates of a point along the stored axes of a box, by Cramer's rule; nothing if the axes
/// are linearly dependent.
template <std::floating_point S>
std::optional<Vector> coordinates(const contact::OrientedBox<S>& box,
                                  const contact::Vector3<S>& p) {
  const auto column = [&](int i) { return oracle::exact(contact::Vector3<S>(box.axes.col(i))); };
  const Vector a = column(0), b = column(1), c = column(2);
  const Vector d = oracle::exact(p) - oracle::exact(box.centre);
  const Rational volume = determinant(a, b, c);
  if (volume == 0) return {};
  return Vector(Rational(determinant(d, b, c) / volume), Rational(determinant(a, d, c) / volume),
                Rational(determinant(a, b, d) / volume));
}
/// Whether a point is in the stored body. Touching counts.
template <std::floating_point S>
bool inside(const contact::OrientedBox<S>& box, const contact::Vector3<S>& p) {
  const auto x = coordinates(box, p);
  if (!x) return false;
  for (int i = 0; i < 3; ++i) {
    if (Rational(abs((*x)[i])) > oracle::exact(box.half_lengths[i])) return false;
  }
  return true;
}
template <std::floating_point S>
bool all_inside(const contact::OrientedBox<S>& box, const Points<S>& points) {
  return std::all_of(points.begin(), points.end(), [&](const auto& p) { return inside(box, p); });
}
/// The product of the edges of the box that is meant, as a double.
template <std::floating_point S>
double meant_volume(const contact::OrientedBox<S>& box) {
  return 8 * double{box.half_lengths[0]} * double{box.half_lengths[1]} *
         double{box.half_lengths[2]};
}

// ---------------------------------------------------------------- rectangles

struct ExactFlat {
  Rational x, y;
};
template <std::floating_point S>
ExactFlat exact(const contact::Vector2<S>& p) {
  return {oracle::exact(p.x()), oracle::exact(p.y())};
}
inline ExactFlat minus(const ExactFlat& p, const ExactFlat& q) { return {p.x - q.x, p.y - q.y}; }
inline Rational dot(const ExactFlat& p, const ExactFlat& q) { return p.x * q.x + p.y * q.y; }
inline Rational cross(const ExactFlat& p, const ExactFlat& q) { return p.x * q.y - p.y * q.x; }

/// Whether a point is in the stored rectangle. Touching counts.
template <std::floating_point S>
bool inside(const contact::Rectangle<S>& rectangle, const contact::Vector2<S>& p) {
  const ExactFlat u = exact(rectangle.axis), d = minus(exact(p), exact(rectangle.centre));
  return Rational(abs(dot(u, d))) <= oracle::exact(rectangle.half_lengths[0]) * dot(u, u) &&
         Rational(abs(cross(u, d))) <= oracle::exact(rectangle.half_lengths[1]) * dot(u, u);
}
template <std::floating_point S>
bool all_inside(const contact::Rectangle<S>& rectangle, const FlatPoints<S>& points) {
  return std::all_of(points.begin(), points.end(),
                     [&](const auto& p) { return inside(rectangle, p); });
}
/// The area of the stored rectangle.
template <std::floating_point S>
Rational area(const contact::Rectangle<S>& rectangle) {
  const ExactFlat u = exact(rectangle.axis);
  return 4 * oracle::exact(rectangle.half_lengths[0]) * oracle::exact(rectangle.half_lengths[1]) *
         dot(u, u);
}

/// The rectangle flush with a side from one point to another.
struct FlushRectangle {
  ExactFlat along;  ///< its side, not normalised
  Rational area;
};
/// Those of all edges of the hull, found by trying all pairs of points: an edge has all points on
/// its left or on its line.
template <std::floating_point S>
std::vector<FlushRectangle> flush_rectangles(const FlatPoints<S>& points) {
  std::vector<ExactFlat> at;
  for (const auto& p : points) at.push_back(exact(p));
  std::vector<FlushRectangle> found;
  for (const ExactFlat& a : at) {
    for (const ExactFlat& b : at) {
      const ExactFlat e = minus(b, a);
      const Rational squared = dot(e, e);
      if (squared == 0) continue;
      Rational least = 0, most = 0, height = 0;
      bool is_edge = true;
      for (const ExactFlat& p : at) {
        const Rational along = dot(e, minus(p, a)), left = cross(e, minus(p, a));
        is_edge = is_edge && left >= 0;
        least = std::min(least, along);
        most = std::max(most, along);
        height = std::max(height, left);
      }
      if (is_edge) found.push_back({e, Rational((most - least) * height / squared)});
    }
  }
  return found;
}
/// The smallest area of a rectangle around points, 0 if they are all equal.
template <std::floating_point S>
Rational smallest_area(const FlatPoints<S>& points) {
  Rational least = 0;
  bool first = true;
  for (const FlushRectangle& r : flush_rectangles(points)) {
    if (first || r.area < least) least = r.area;
    first = false;
  }
  return least;
}

// ---------------------------------------------------------------- the smallest box of few points

using Point = contact::Vector3<double>;

inline double extent(const Points<double>& points, const Point& along) {
  const auto [low, high] = std::minmax_element(
      points.begin(), points.end(),
      [&](const Point& p, const Point& q) { return along.dot(p) < along.dot(q); });
  return along.dot(*high) - along.dot(*low);
}

/// The edges of the hull, as vectors.
inline std::vector<Point> hull_edges(const Points<double>& points) {
  const contact::Hull hull = contact::convex_hull(points);
  std::vector<Point> edges;
  for (int f = 0; f < hull.face_count(); ++f) {
    const auto face = hull.face(f);
    for (std::size_t i = 0; i < face.size(); ++i) {
      const int from = face[i], to = face[(i + 1) % face.size()];
      if (from > to) continue;
      edges.push_back(points[static_cast<std::size_t>(to)] -
                      points[static_cast<std::size_t>(from)]);
    }
  }
  return edges;
}

/// The volume of the smallest box around points, by O'Rourke's condition: two adjacent faces each
/// contain an edge of the hull. For each two edges the normals of such faces depend on one angle;
/// it is sampled, and the best samples are refined. At least the minimum, and at most a little more
/// than it.
inline double smallest_volume(const Points<double>& points) {
  const std::vector<Point> edges = hull_edges(points);
  double best = 1e300;
  constexpr int samples = 180;
  for (const Point& e : edges) {
    const Point u = e / std::sqrt(e.dot(e));
    const Point x = u.unitOrthogonal(), y = u.cross(x);
    for (const Point& f : edges) {
      const auto at = [&](double angle) {
        const Point first = std::cos(angle) * x + std::sin(angle) * y;
        const Point second = first.cross(f);
        const double length = std::sqrt(second.dot(second));
        if (length < 1e-9 * std::sqrt(f.dot(f))) return 1e300;
        const Point n = second / length;
        return extent(points, first) * extent(points, n) * extent(points, first.cross(n));
      };
      std::array<double, samples> volumes{};
      const auto angle = [](int i) { return std::numbers::pi * i / samples; };
      for (int i = 0; i < samples; ++i) volumes[static_cast<std::size_t>(i)] = at(angle(i));
      for (int i = 0; i < samples; ++i) {
        const auto sampled = [&](int k) {
          return volumes[static_cast<std::size_t>((k + samples) % samples)];
        };
        best = std::min(best, sampled(i));
        if (sampled(i) > std::min(sampled(i - 1), sampled(i + 1)) || sampled(i) > 1.1 * best) {
          continue;
        }
        double low = angle(i - 1), high = angle(i + 1);
        for (int step = 0; step < 40; ++step) {
          const double p = low + (high - low) / 3, q = high - (high - low) / 3;
          const double at_p = at(p), at_q = at(q);
          best = std::min({best, at_p, at_q});
          (at_p < at_q ? high : low) = at_p < at_q ? q : p;
        }
      }
    }
  }
  return best;
}

}  // namespace box_truth
