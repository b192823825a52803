/// @file
/// The smallest rectangle around points in the plane, by rotating callipers.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include <contact/box_around.hpp>
#include <contact/difference_determinant.hpp>
#include <contact/exact.hpp>
#include <contact/exact_ray_triangle.hpp>
#include <contact/hull_2d.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/outward.hpp>
#include <contact/running_error.hpp>
#include <contact/tolerance.hpp>
#include <contact/vector.hpp>

namespace contact {

// [rectangle]
/// A rectangle in the plane: all points centre + x axis + y n with |x| and |y| at most half lengths
/// 0 and 1, where n = (−axis.y, axis.x) is the axis turned left by 90°.
///
/// The axis is a unit vector, rounded. n is exactly perpendicular and as long, so the stored body
/// is a rectangle, with half lengths in units of |axis|.
template <Ring S>
struct Rectangle {
  Vector2<S> centre = Vector2<S>::Zero();        ///< m
  Vector2<S> axis = Vector2<S>(S(1), S(0));      ///< of length 1, no unit of measure
  Vector2<S> half_lengths = Vector2<S>::Zero();  ///< along axis and n, m, not negative
};
// [/rectangle]

namespace rectangle_detail {

using Point = Vector2<double>;

/// The sign of (b − a) × (d − c), exactly; its filter is that of bounded_orientation().
inline int cross_sign(const Point& a, const Point& b, const Point& c, const Point& d) {
  constexpr double five_u = 2.5 * std::numeric_limits<double>::epsilon();
  const double left = (b.x() - a.x()) * (d.y() - c.y());
  const double right = (b.y() - a.y()) * (d.x() - c.x());
  const double bound = five_u * (std::abs(left) + std::abs(right)) + 0x1p-1000;
  if (left - right > bound) return 1;
  if (left - right < -bound) return -1;
  difference_detail::Differences<4> numbers;
  for (int i = 0; i < 2; ++i) {
    const auto k = static_cast<std::size_t>(i);
    numbers.set(k, b[i], a[i]);
    numbers.set(2 + k, d[i], c[i]);
  }
  const std::optional<int> sign = difference_detail::determinant_sign(numbers);
  if (sign) return *sign;
  const auto difference = [](double x, double y) { return Exact(x) - Exact(y); };
  return (difference(b.x(), a.x()) * difference(d.y(), c.y()) -
          difference(b.y(), a.y()) * difference(d.x(), c.x()))
      .sign();
}

/// The sign of (b − a) · (d − c), exactly: a cross product with the second turned left.
inline int dot_sign(const Point& a, const Point& b, const Point& c, const Point& d) {
  return cross_sign(a, b, Point(d.y(), c.x()), Point(c.y(), d.x()));
}

/// An edge of the hull, and the vertices that the other sides of its rectangle touch; by position
/// in the hull.
struct Touching {
  int edge;   ///< from this vertex to the next
  int first;  ///< the one that is least far along the edge
  int last;   ///< the one that is farthest along the edge
  int top;    ///< the one that is farthest from the edge
};

/// The rectangle of an edge, not normalised: width |e| w, height |e| h, and |e|².
template <class T>
struct Extents {
  T width, height, squared_edge;
};

/// In the arithmetic of T. @param scale a power of two
template <class T>
Extents<T> extents(const std::vector<Point>& hull, const Touching& t, double scale) {
  const auto at = [&hull](int i) { return hull[static_cast<std::size_t>(i) % hull.size()]; };
  const auto step = [scale](const Point& from, const Point& to, int i) {
    return (T(to[i]) - T(from[i])) * T(scale);
  };
  const Point a = at(t.edge), b = at(t.edge + 1), low = at(t.first), high = at(t.last),
              top = at(t.top);
  const T x = step(a, b, 0), y = step(a, b, 1);
  return {x * step(low, high, 0) + y * step(low, high, 1),
          x * step(a, top, 1) - y * step(a, top, 0), x * x + y * y};
}

/// The sign of the first area minus the second: areas w h / |e|² with the divisors multiplied
/// across.
template <class T>
T area_difference(const Extents<T>& x, const Extents<T>& y) {
  return x.width * x.height * y.squared_edge - y.width * y.height * x.squared_edge;
}

/// A power of two that makes numbers up to `size` about 1, as far as both are normal.
inline double scale_for(double size) {
  int exponent = 0;
  std::frexp(size, &exponent);
  return std::ldexp(1.0, std::clamp(-exponent, -1000, 1000));
}

// [callipers]
/// The edge of a convex polygon whose rectangle has the smallest area, exactly; of equal ones the
/// first. The three other vertices only move on, all round once (rotating callipers).
/// @param hull at least three vertices, counter-clockwise, no three collinear
inline Touching smallest_touching(const std::vector<Point>& hull, double scale) {
  const int n = static_cast<int>(hull.size());
  const auto at = [&hull](int i) { return hull[static_cast<std::size_t>(i) % hull.size()]; };
  Touching now{0, 0, 1, 1}, best{};
  Extents<RunningError> least;
  for (; now.edge < n; ++now.edge) {
    const Point a = at(now.edge), b = at(now.edge + 1);
    now.last = std::max(now.last, now.edge + 1);
    while (dot_sign(a, b, at(now.last), at(now.last + 1)) > 0) ++now.last;
    now.top = std::max(now.top, now.last);
    while (cross_sign(a, b, at(now.top), at(now.top + 1)) > 0) ++now.top;
    now.first = std::max(now.first, now.top);
    while (dot_sign(a, b, at(now.first), at(now.first + 1)) < 0) ++now.first;
    const auto found = extents<RunningError>(hull, now, scale);
    if (now.edge > 0) {
      int sign = area_difference(found, least).certain_sign();
      if (sign == 0) {
        sign = area_difference(extents<Exact>(hull, now, 1), extents<Exact>(hull, best, 1)).sign();
      }
      if (sign >= 0) continue;
    }
    best = now;
    least = found;
  }
  return best;
}
// [/callipers]

/// The unit vector along b − a, rounded.
inline Point direction(const Point& a, const Point& b) {
  const Point difference = b - a;  // halves of subnormal numbers round, so only if it overflows
  const Point e = all_finite(difference) ? difference : Point(b / 2 - a / 2);
  int exponent = 0;
  std::frexp(e.cwiseAbs().maxCoeff(), &exponent);
  const Point near_one(std::ldexp(e.x(), -exponent), std::ldexp(e.y(), -exponent));
  return near_one / std::sqrt(near_one.dot(near_one));
}

}  // namespace rectangle_detail

// [rectangle-with-axis]
/// A rectangle with the given axis that contains all points as it is stored, by the argument of
/// box_with_axes(); since its axes are exactly perpendicular, only their length matters.
///
/// Along the axes of the world, of length exactly 1, a half length is the smallest for the centre
/// as stored, otherwise at most 100 u of the largest distance from the centre larger than it must
/// be.
/// @param axis of length 1 to within 10 u
/// @param points n ≥ 1 points, m, finite
/// @throws std::invalid_argument if an argument does not satisfy this, or the rectangle overflows
template <FloatOrDouble S>
Rectangle<S> rectangle_with_axis(const Vector2<S>& axis, std::span<const Vector2<S>> points) {
  using box_around_detail::rounded_up;
  constexpr double eta = tolerance::underflow_unit<double>;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (points.empty()) throw_invalid_argument("points", "{}", "a rectangle needs a point");
  const Vector2<double> u = axis.template cast<double>(), n(-u.y(), u.x());
  const double off = std::abs(u.dot(u) - 1) + tolerance::gamma<double>(8);
  if (!(off <= 32 * static_cast<double>(tolerance::unit_roundoff<S>))) {
    throw_invalid_argument("axis", vector_text(axis), "must have length 1");
  }
  Vector2<double> low = Vector2<double>::Constant(infinity), high = -low;
  for (const Vector2<S>& p : points) {
    require_finite("points", p);
    low = low.cwiseMin(p.template cast<double>());
    high = high.cwiseMax(p.template cast<double>());
  }
  const Vector2<double> from = low == high ? low : Vector2<double>(low / 2 + high / 2);
  const Vector2<double> size = (high - from).cwiseMax(from - low);
  Vector2<double> least = Vector2<double>::Constant(infinity), most = -least;
  for (const Vector2<S>& p : points) {
    const Vector2<double> d = p.template cast<double>() - from;
    const Vector2<double> y(u.dot(d), n.dot(d));
    least = least.cwiseMin(y);
    most = most.cwiseMax(y);
  }
  const Vector2<double> middle = least / 2 + most / 2;
  Rectangle<S> result;
  result.axis = axis;
  const bool with_world = u.x() == 0 || u.y() == 0;
  for (int k = 0; k < 2; ++k) {
    const double shift = with_world ? 0 : u[k] * middle[0] + n[k] * middle[1];
    result.centre[k] = static_cast<S>(low[k] == high[k] ? low[k] : from[k] + shift);
  }
  const Vector2<double> c = result.centre.template cast<double>(), moved = c - from;
  const auto bound = [](const Vector2<double>& along, const Vector2<double>& of) {
    const double sum = std::abs(along.x()) * of.x() + std::abs(along.y()) * of.y();
    return tolerance::gamma<double>(8) * sum + 4 * eta;
  };
  for (int i = 0; i < 2; ++i) {
    const Vector2<double>& along = i == 0 ? u : n;
    double half_length = 0;
    if (with_world) {
      const int k = along.x() == 0 ? 1 : 0;
      half_length = std::max(sum_up(high[k], -c[k]), sum_up(c[k], -low[k]));
      if (off > tolerance::gamma<double>(8) && half_length > 0)
        half_length += 2 * off * half_length + eta;
    } else if (low != high) {
      const double at = along.dot(moved);
      half_length = std::max(most[i] - at, at - least[i]) + bound(along, size) +
                    bound(along, moved.cwiseAbs());
      half_length += (2 * off + tolerance::gamma<double>(12)) * half_length + eta;
    }
    result.half_lengths[i] = rounded_up<S>(half_length);
  }
  if (!all_finite(result.centre) || !all_finite(result.half_lengths)) {
    throw_invalid_argument("points", vector_text(high), "their rectangle overflows");
  }
  return result;
}
// [/rectangle-with-axis]

// [smallest-rectangle]
/// The rectangle of the smallest area that contains all points.
///
/// One side of it is flush with an edge of the convex hull (Freeman and Shapira): between two such
/// directions the extremes stay the same and the area, as a function of the angle, has no minimum.
/// Which edge it is, is decided exactly, as is which vertices touch the other sides; of equal areas
/// the first edge counts, from the vertex with the least x. The result is rounded outwards
/// (rectangle_with_axis()), so it contains all points, and its area is not exactly that minimum.
/// @param points n ≥ 1 points, m, finite, in any order, equal or collinear ones too
/// @return along the segment for collinear points; of half lengths 0 for equal points
/// @throws std::invalid_argument if there is no point, an entry is not finite, or it overflows
///
/// Scales: all whose rectangle does not overflow. O(n log n).
///
/// Source: Toussaint, *Solving Geometric Problems with the Rotating Calipers*, 1983.
template <FloatOrDouble S>
Rectangle<S> smallest_rectangle(std::span<const Vector2<S>> points) {
  if (points.empty()) throw_invalid_argument("points", "{}", "a rectangle needs a point");
  std::vector<Vector2<double>> stored;
  stored.reserve(points.size());
  for (const Vector2<S>& p : points) stored.push_back(p.template cast<double>());
  std::vector<Vector2<double>> hull;
  std::vector<Vector2<S>> vertices;
  for (const int i : convex_hull_2d(stored)) {
    hull.push_back(stored[static_cast<std::size_t>(i)]);
    vertices.push_back(points[static_cast<std::size_t>(i)]);
  }
  Vector2<S> axis(S(1), S(0));
  if (hull.size() > 1) {
    std::size_t edge = 0;
    if (hull.size() > 2) {
      Vector2<double> low = hull[0], high = hull[0];
      for (const Vector2<double>& p : hull) low = low.cwiseMin(p), high = high.cwiseMax(p);
      const double scale = rectangle_detail::scale_for((high / 2 - low / 2).maxCoeff());
      edge = static_cast<std::size_t>(rectangle_detail::smallest_touching(hull, scale).edge);
    }
    const Vector2<double> along =
        rectangle_detail::direction(hull[edge], hull[(edge + 1) % hull.size()]);
    axis = along.template cast<S>();
  }
  return rectangle_with_axis<S>(axis, std::span<const Vector2<S>>(vertices));
}
// [/smallest-rectangle]

/// Whether a point is in a rectangle, exactly, for the stored numbers. Touching counts.
/// @return false if a number is not finite, a half length is negative, or the axis is 0
template <FloatOrDouble S>
bool contains(const Rectangle<S>& rectangle, const Vector2<S>& point) {
  if (!all_finite(point) || !all_finite(rectangle.centre) || !all_finite(rectangle.axis) ||
      !all_finite(rectangle.half_lengths) || rectangle.half_lengths.minCoeff() < S(0) ||
      rectangle.axis == Vector2<S>::Zero()) {
    return false;
  }
  const auto exact = [](S x) { return Exact(static_cast<double>(x)); };
  const Exact u = exact(rectangle.axis.x()), v = exact(rectangle.axis.y());
  const Exact x = exact(point.x()) - exact(rectangle.centre.x());
  const Exact y = exact(point.y()) - exact(rectangle.centre.y());
  const Exact squared = u * u + v * v;
  return abs(u * x + v * y) <= exact(rectangle.half_lengths[0]) * squared &&
         abs(u * y - v * x) <= exact(rectangle.half_lengths[1]) * squared;
}

}  // namespace contact
