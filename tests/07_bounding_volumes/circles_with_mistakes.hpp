/// @file
/// The smallest circle around points of the plane whose coordinates are multiples of 1/8, at most
/// 100 from 0, by trying all circles across two points and through three, in integers. And with the
/// mistakes that the tests of the exercise recognise.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <07_bounding_volumes/contained.hpp>

namespace circles_with_mistakes {

using contact::Exact;
using Point = Eigen::Vector2d;
using Points = std::vector<Point>;

inline constexpr double kParts = 8;
inline constexpr double kLimit = 100;

/// The same fields as those of the exercise.
struct Round {
  Point centre = Point::Zero();
  double radius = 0;
};

/// In units of 1/8 m.
struct Whole {
  std::int64_t x, y;
};
inline Whole whole(const Point& from, const Point& to) {
  const auto eighths = [](double v) { return static_cast<std::int64_t>(v * kParts); };
  return {eighths(to.x()) - eighths(from.x()), eighths(to.y()) - eighths(from.y())};
}
inline std::int64_t cross(const Whole& u, const Whole& v) { return u.x * v.y - u.y * v.x; }
inline std::int64_t dot(const Whole& u, const Whole& v) { return u.x * v.x + u.y * v.y; }

/// Twice the signed area of the triangle.
inline std::int64_t whole_cross(const Point& a, const Point& b, const Point& c) {
  return cross(whole(a, b), whole(a, c));
}

/// The circle through `origin` whose centre is at origin + centre / divisor. The divisor is
/// positive, the centre up to about 2^34, the divisor up to 2^24.
struct Candidate {
  Point origin;
  Whole centre{};
  std::int64_t divisor = 1;

  /// Positive if p is inside, 0 if it is on the circle: (2 w · centre − w · w divisor), for w from
  /// the origin to p.
  int side(const Point& p) const {
    const Whole w = whole(origin, p);
    const std::int64_t power = 2 * dot(w, centre) - dot(w, w) * divisor;
    return power > 0 ? 1 : (power < 0 ? -1 : 0);
  }
  bool contains(const Points& points) const {
    return std::all_of(points.begin(), points.end(), [&](const Point& p) { return side(p) >= 0; });
  }
  Exact square() const {
    const Exact x{double(centre.x)}, y{double(centre.y)};
    return x * x + y * y;
  }
  bool is_smaller_than(const Candidate& other) const {
    const Exact mine{double(divisor)}, its{double(other.divisor)};
    return square() * its * its < other.square() * mine * mine;
  }
  Round round() const {
    const Point centre_from(double(centre.x) / double(divisor), double(centre.y) / double(divisor));
    return {origin + centre_from / kParts, centre_from.norm() / kParts};
  }
};

inline Candidate across(const Point& a, const Point& b) { return {a, whole(a, b), 2}; }

/// Nothing for points on one line.
inline std::optional<Candidate> through(const Point& a, const Point& b, const Point& c) {
  const Whole u = whole(a, b), v = whole(a, c);
  std::int64_t divisor = 2 * cross(u, v);
  if (divisor == 0) return std::nullopt;
  const std::int64_t uu = dot(u, u), vv = dot(v, v), sign = divisor > 0 ? 1 : -1;
  return Candidate{a, {sign * (uu * v.y - vv * u.y), sign * (vv * u.x - uu * v.x)}, sign * divisor};
}

/// 1 inside the circle through a, b and c, 0 on it, -1 outside.
inline int side_of_circle(const Point& a, const Point& b, const Point& c, const Point& p) {
  return through(a, b, c)->side(p);
}

template <class Use>
void for_each_triple(const Points& points, const Use& use) {
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = i + 1; j < points.size(); ++j)
      for (std::size_t k = j + 1; k < points.size(); ++k)
        if (const auto candidate = through(points[i], points[j], points[k])) use(*candidate);
}

/// Of circles that contain all points, the smallest one that was offered.
class Smallest {
 public:
  explicit Smallest(const Points& points) : points_(points) {}
  void offer(const Candidate& candidate) {
    if (best_ && !candidate.is_smaller_than(*best_)) return;
    if (candidate.contains(points_)) best_ = candidate;
  }
  bool is_found() const { return best_.has_value(); }
  Round round() const { return best_ ? best_->round() : Round{}; }

 private:
  const Points& points_;
  std::optional<Candidate> best_;
};

/// The smallest circle around points is across two of them or through three.
inline Round smallest(const Points& points) {
  Smallest best(points);
  for (const Point& a : points)
    for (const Point& b : points) best.offer(across(a, b));
  if (best.is_found()) return best.round();
  for_each_triple(points, [&](const Candidate& candidate) { best.offer(candidate); });
  return best.round();
}

// ---------------------------------------------------------------- mistakes

inline Round smallest_through_three(const Points& points) {
  Smallest best(points);
  for_each_triple(points, [&](const Candidate& candidate) { best.offer(candidate); });
  return best.round();
}

/// The first triple whose circle contains all, if no pair has such a circle.
inline Round first_through_three(const Points& points) {
  std::optional<Candidate> first;
  for (const Point& a : points)
    for (const Point& b : points)
      if (!first && across(a, b).contains(points)) first = across(a, b);
  for_each_triple(points, [&](const Candidate& candidate) {
    if (!first && candidate.contains(points)) first = candidate;
  });
  return first ? first->round() : Round{};
}

inline std::pair<Point, Point> farthest_pair(const Points& points) {
  std::pair<Point, Point> best{points[0], points[0]};
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = i + 1; j < points.size(); ++j)
      if ((points[i] - points[j]).squaredNorm() > (best.first - best.second).squaredNorm())
        best = {points[i], points[j]};
  return best;
}
inline Round across_farthest_pair(const Points& points) {
  const auto [a, b] = farthest_pair(points);
  return across(a, b).round();
}
/// The smallest circle through both points of the farthest pair that contains all, if there is one;
/// else that with the point farthest from the midpoint.
inline Round through_farthest_pair(const Points& points) {
  const auto [a, b] = farthest_pair(points);
  if (across(a, b).contains(points)) return across(a, b).round();
  const Point middle = (a + b) / 2;
  const auto nearer = [&](const Point& p, const Point& q) {
    return (p - middle).squaredNorm() < (q - middle).squaredNorm();
  };
  const auto circle = through(a, b, *std::max_element(points.begin(), points.end(), nearer));
  return circle ? circle->round() : Round{};
}

inline Round around(const Point& centre, const Points& points) {
  double radius = 0;
  for (const Point& p : points) radius = std::max(radius, (p - centre).norm());
  return {centre, radius};
}
inline Point mean(const Points& points) {
  Point sum = Point::Zero();
  for (const Point& p : points) sum += p;
  return sum / double(points.size());
}
inline Point box_centre(const Points& points) {
  Point low = points[0], high = points[0];
  for (const Point& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return (low + high) / 2;
}

/// The circle that grows from the most distant extremes, as the lesson's sphere does.
inline Round grown(const Points& points) {
  std::pair<Point, Point> start{points[0], points[0]};
  for (int axis = 0; axis < 2; ++axis) {
    const auto less = [axis](const Point& a, const Point& b) { return a[axis] < b[axis]; };
    const Point low = *std::min_element(points.begin(), points.end(), less);
    const Point high = *std::max_element(points.begin(), points.end(), less);
    if ((high - low).squaredNorm() > (start.second - start.first).squaredNorm())
      start = {low, high};
  }
  Round circle = across(start.first, start.second).round();
  for (const Point& p : points) {
    const Point from_p = circle.centre - p;
    const double distance = from_p.norm(), radius = (circle.radius + distance) / 2;
    if (distance > circle.radius) circle = {p + from_p * (radius / distance), radius};
  }
  return circle;
}

/// One pass: a point outside replaces the circle by the one with the point before it.
inline Round without_restart(const Points& points) {
  Candidate circle = across(points[0], points[0]);
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (circle.side(points[i]) >= 0) continue;
    circle = across(points[0], points[i]);
    for (std::size_t j = 1; j < i; ++j)
      if (circle.side(points[j]) < 0) circle = across(points[j], points[i]);
  }
  return circle.round();
}

/// Compares the rounded distance from the rounded centre with the rounded radius.
template <class S>
bool in_rounded_circle(const Point& a, const Point& b, const Point& c, const Point& p, S epsilon) {
  using Rounded = Eigen::Matrix<S, 2, 1>;
  const Rounded u = (b - a).cast<S>(), v = (c - a).cast<S>(), w = (p - a).cast<S>();
  const S uu = u.dot(u), vv = v.dot(v), det = 2 * (u.x() * v.y() - u.y() * v.x());
  const Rounded centre = Rounded(uu * v.y() - vv * u.y(), vv * u.x() - uu * v.x()) / det;
  return (w - centre).norm() <= centre.norm() + epsilon;
}

/// The first circle that contains all points, as far as rounded distances and radii tell: perhaps
/// none, as those on the circle may seem to be outside.
inline Round by_rounded_distances(const Points& points) {
  const auto contains = [&](const Point& centre, double radius) {
    return std::all_of(points.begin(), points.end(),
                       [&](const Point& p) { return (p - centre).norm() <= radius; });
  };
  for (const Point& a : points)
    for (const Point& b : points)
      if (contains((a + b) / 2, (b - a).norm() / 2)) return around((a + b) / 2, points);
  for (const Point& a : points)
    for (const Point& b : points)
      for (const Point& c : points) {
        const Point u = b - a, v = c - a;
        const double uu = u.dot(u), vv = v.dot(v), det = 2 * (u.x() * v.y() - u.y() * v.x());
        if (det == 0 || u.dot(v) < 0 || u.dot(c - b) > 0 || v.dot(b - c) > 0) continue;
        const Point centre = a + Point(uu * v.y() - vv * u.y(), vv * u.x() - uu * v.x()) / det;
        if (contains(centre, (centre - a).norm())) return around(centre, points);
      }
  return {};
}

}  // namespace circles_with_mistakes
