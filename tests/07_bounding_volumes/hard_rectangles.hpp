/// @file
/// The hard cases of the smallest rectangle around points in the plane: question and methods.
#pragma once

#include <07_bounding_volumes/box_truth.hpp>
#include <07_bounding_volumes/hard_common.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <contact/hull_2d.hpp>
#include <contact/smallest_rectangle.hpp>
#include <contact/vector.hpp>
#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <support/hard_cases.hpp>
#include <support/oracle.hpp>
#include <vector>

namespace hard_rectangles {

using contact::Rectangle;
using contact::Vector2;
using hard_cases::Case;
using hard_cases::Json;
using oracle::Rational;

template <std::floating_point S>
using Flat = std::vector<Vector2<S>>;

/// A field with two numbers for each point.
template <std::floating_point S>
Flat<S> points_of(const Case& c) {
  const std::vector<double> numbers = c.numbers("flat_points");
  Flat<S> points;
  for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) {
    points.push_back({static_cast<S>(numbers[i]), static_cast<S>(numbers[i + 1])});
  }
  return points;
}

// ---------------------------------------------------------------- methods as they are often
// written

/// The extent of points along a direction, which need not have length 1, and perpendicular to it.
template <std::floating_point S>
Rectangle<S> around(const Vector2<S>& direction, const Flat<S>& points) {
  constexpr S infinity = std::numeric_limits<S>::infinity();
  const Vector2<S> u = direction / std::sqrt(direction.dot(direction)), n(-u.y(), u.x());
  Vector2<S> low = Vector2<S>::Constant(infinity), high = -low;
  for (const Vector2<S>& p : points) {
    const Vector2<S> y(u.dot(p), n.dot(p));
    low = low.cwiseMin(y);
    high = high.cwiseMax(y);
  }
  const Vector2<S> middle = (low + high) / S(2);
  return {Vector2<S>(middle.x() * u + middle.y() * n), u, Vector2<S>((high - low) / S(2))};
}
template <std::floating_point S>
Rectangle<S> along_axes(const Flat<S>& points) {
  return around<S>(Vector2<S>(1, 0), points);
}
/// Along the eigenvector of the covariance of all points.
template <std::floating_point S>
Rectangle<S> along_principal_axis(const Flat<S>& points) {
  Vector2<S> mean = Vector2<S>::Zero();
  for (const auto& p : points) mean += p / static_cast<S>(points.size());
  S xx = 0, xy = 0, yy = 0;
  for (const auto& p : points) {
    const Vector2<S> d = p - mean;
    xx += d.x() * d.x(), xy += d.x() * d.y(), yy += d.y() * d.y();
  }
  const S half = (xx - yy) / 2, root = std::sqrt(half * half + xy * xy);
  return around<S>(half < 0 ? Vector2<S>(xy, root - half) : Vector2<S>(root + half, xy), points);
}
template <std::floating_point S>
S area(const Rectangle<S>& r) {
  return r.half_lengths.x() * r.half_lengths.y();
}
/// The best of the rectangles along the edges of a polygon, by the given measure.
template <std::floating_point S, class Measure>
Rectangle<S> best_edge(const Flat<S>& polygon, const Flat<S>& points, const Measure& measure) {
  Rectangle<S> best{};
  bool first = true;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Rectangle<S> r =
        around<S>(Vector2<S>(polygon[(i + 1) % polygon.size()] - polygon[i]), points);
    if (first || measure(r) < measure(best)) best = r;
    first = false;
  }
  return best;
}
template <std::floating_point S>
Flat<S> hull_of(const Flat<S>& points, S epsilon) {
  Flat<S> hull;
  for (const int i : contact::convex_hull_2d_rounded(points, epsilon)) {
    hull.push_back(points[static_cast<std::size_t>(i)]);
  }
  return hull;
}
/// The narrowest rectangle (the minimum diameter), which need not have the smallest area.
template <std::floating_point S>
Rectangle<S> narrowest(const Flat<S>& points) {
  return best_edge<S>(hull_of<S>(points, S(0)), points,
                      [](const Rectangle<S>& r) { return r.half_lengths.minCoeff(); });
}
/// Along the edges of the polygon that the points form in their order, as if it were convex.
template <std::floating_point S>
Rectangle<S> edges_as_given(const Flat<S>& points) {
  return best_edge<S>(points, points, area<S>);
}
/// The callipers stay on four vertices and turn by the smallest angle to an edge, whose cosine is
/// compared; areas from the current vertices only.
template <std::floating_point S>
Rectangle<S> callipers_by_cosines(const Flat<S>& points) {
  const Flat<S> hull = hull_of<S>(points, S(0));
  const std::size_t n = hull.size();
  if (n < 3) return around<S>(Vector2<S>(hull.back() - hull.front()), points);
  std::array<std::size_t, 4> at{0, 0, 0, 0};  // lowest, rightmost, highest, leftmost
  for (std::size_t i = 0; i < n; ++i) {
    if (hull[i].y() < hull[at[0]].y()) at[0] = i;
    if (hull[i].x() > hull[at[1]].x()) at[1] = i;
    if (hull[i].y() > hull[at[2]].y()) at[2] = i;
    if (hull[i].x() < hull[at[3]].x()) at[3] = i;
  }
  Vector2<S> base(1, 0);
  Rectangle<S> best{};
  S least = std::numeric_limits<S>::infinity();
  for (std::size_t step = 0; step < n; ++step) {
    std::size_t chosen = 0;
    S largest = -2;
    Vector2<S> turned = base;
    for (std::size_t k = 0; k < 4; ++k) {
      const Vector2<S> e = hull[(at[k] + 1) % n] - hull[at[k]];
      const Vector2<S> unit = e / std::sqrt(e.dot(e));
      const std::array<Vector2<S>, 4> sides{base, Vector2<S>(-base.y(), base.x()), -base,
                                            Vector2<S>(base.y(), -base.x())};
      const S cosine = unit.dot(sides[k]);
      if (cosine <= largest) continue;
      largest = cosine;
      chosen = k;
      const std::array<Vector2<S>, 4> back{unit, Vector2<S>(unit.y(), -unit.x()), -unit,
                                           Vector2<S>(-unit.y(), unit.x())};
      turned = back[k];
    }
    at[chosen] = (at[chosen] + 1) % n;
    base = turned;
    const Vector2<S> up(-base.y(), base.x());
    const S width = base.dot(Vector2<S>(hull[at[1]] - hull[at[3]]));
    const S height = up.dot(Vector2<S>(hull[at[2]] - hull[at[0]]));
    if (!(width * height < least)) continue;
    least = width * height;
    const S x = base.dot(hull[at[1]] + hull[at[3]]) / 2, y = up.dot(hull[at[2]] + hull[at[0]]) / 2;
    best = {Vector2<S>(x * base + y * up), base, Vector2<S>(width / 2, height / 2)};
  }
  return best;
}

// ---------------------------------------------------------------- question

/// The longest side of the axis-aligned rectangle.
template <std::floating_point S>
Rational size_of(const Flat<S>& points) {
  Vector2<S> low = points.front(), high = low;
  for (const auto& p : points) low = low.cwiseMin(p), high = high.cwiseMax(p);
  return oracle::exact((high - low).maxCoeff());
}
/// Whether a rectangle contains all points and has the smallest area, both to a millionth of the
/// size of the points and to what rounding its centre costs.
template <std::floating_point S>
bool is_smallest(Rectangle<S> r, const Flat<S>& points) {
  if (!r.centre.allFinite() || !r.axis.allFinite() || !r.half_lengths.allFinite()) return false;
  const Rational size = size_of(points);
  const Rational room = size / 1000000 + oracle::exact(r.centre.cwiseAbs().maxCoeff()) *
                                             oracle::exact(std::numeric_limits<S>::epsilon());
  if (Rational(box_truth::area(r)) > box_truth::smallest_area(points) + 8 * room * size) {
    return false;
  }
  for (int k = 0; k < 2; ++k) r.half_lengths[k] += static_cast<S>(oracle::nearest(room));
  return box_truth::all_inside(r, points);
}

template <std::floating_point S, class Make>
void add_method(hard_cases::Runner& runner, const std::string& name, const Make& make) {
  runner.method("rectangle", name, hard_common::applies<S>, [make](const Case& c, const Json&) {
    const Flat<S> points = points_of<S>(c);
    return is_smallest<S>(make(points), points);
  });
}
/// It contains all points exactly.
template <std::floating_point S>
bool book_is_right(const Case& c) {
  const Flat<S> points = points_of<S>(c);
  const auto r = contact::smallest_rectangle<S>(std::span<const Vector2<S>>(points));
  return box_truth::all_inside(r, points) && is_smallest<S>(r, points);
}

/// Adds it to a runner.
inline void add_questions(hard_cases::Runner& runner) {
  runner.question("rectangle", [](const Case& c) -> Json {
    // As a share of the size squared, since the area of some cases overflows or underflows.
    const Flat<double> points = points_of<double>(c);
    const Rational size = size_of(points);
    return {{"class", "a"},
            {"share", hard_cases::hex(Rational(box_truth::smallest_area(points) / size / size))}};
  });
  add_method<double>(runner, "rectangle along the axes", along_axes<double>);
  add_method<double>(runner, "along the principal axis", along_principal_axis<double>);
  add_method<double>(runner, "the narrowest", narrowest<double>);
  add_method<double>(runner, "edges in the given order", edges_as_given<double>);
  add_method<float>(runner, "callipers by cosines, float", callipers_by_cosines<float>);
  add_method<double>(runner, "callipers by cosines, double", callipers_by_cosines<double>);
  runner.method("rectangle", "the book, exact", [](const Case& c, const Json&) {
    return book_is_right<double>(c) && (c.type() == "double" || book_is_right<float>(c));
  });
}

}  // namespace hard_rectangles
