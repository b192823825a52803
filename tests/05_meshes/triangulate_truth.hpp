/// @file
/// Which rings bound a region and which triangles are a triangulation of it: by brute force in
/// numbers that do not round, and with none of the chapter's code.
#pragma once

#include <algorithm>
#include <array>
#include <contact/polygon.hpp>
#include <map>
#include <string>
#include <support/oracle.hpp>
#include <type_traits>
#include <utility>
#include <vector>

namespace triangulate_truth {

using oracle::Rational;
using Rings = std::vector<contact::Polygon<double>>;  ///< the outer ring first
using Triangles = std::vector<std::array<int, 3>>;

/// The rings in the arithmetic of N: fractions, or double for whole numbers below 2^20, of which
/// every product here is exact.
template <class N>
class Region {
 public:
  explicit Region(const Rings& rings) {
    for (const contact::Polygon<double>& ring : rings) {
      starts_.push_back(points_.size());
      for (const contact::Vector2<double>& v : ring) {
        points_.push_back({number(v.x()), number(v.y())});
      }
    }
    starts_.push_back(points_.size());
  }

  /// Whether the rings bound a region: simple, without common points, the holes beside each other
  /// in the outer ring. Coordinates are finite.
  bool valid() const {
    std::vector<std::array<std::size_t, 2>> edges;
    for (std::size_t r = 0; r + 1 < starts_.size(); ++r) {
      if (size(r) < 3) return false;
      for (std::size_t i = 0; i < size(r); ++i) edges.push_back({at(r, i), at(r, i + 1)});
    }
    for (const auto& [a, b] : edges) {
      if (points_[a] == points_[b]) return false;
    }
    for (std::size_t i = 0; i < edges.size(); ++i) {
      for (std::size_t j = i + 1; j < edges.size(); ++j) {
        if (!allowed(edges[i], edges[j])) return false;
      }
    }
    for (std::size_t r = 1; r + 1 < starts_.size(); ++r) {
      for (std::size_t other = 0; other + 1 < starts_.size(); ++other) {
        if (other != r && contains(other, points_[starts_[r]]) != (other == 0)) return false;
      }
    }
    return true;
  }

  /// Twice the area of the outer ring without the holes.
  Rational doubled_area() const {
    Rational sum(0);
    for (std::size_t r = 0; r + 1 < starts_.size(); ++r) {
      Rational of_ring = doubled_ring(r);
      if (of_ring < 0) of_ring = -of_ring;
      sum += r == 0 ? of_ring : Rational(-of_ring);
    }
    return sum;
  }

  /// How many triangles there have to be.
  std::size_t triangle_count() const { return points_.size() + 2 * (starts_.size() - 2) - 2; }

  /// What is wrong with a triangulation, or nothing.
  ///
  /// All triangles are counter-clockwise, and their edges cancel in pairs but for the rings' edges.
  /// So around every point the triangles wind as often as the rings: that is a proof that they
  /// cover the region once. The area and the pairs are asked all the same, so that an error in this
  /// argument would show.
  std::string fault(const Triangles& triangles) const {
    if (triangles.size() != triangle_count()) return "their number";
    std::map<std::pair<std::size_t, std::size_t>, int> edges;
    Rational sum(0);
    for (const std::array<int, 3>& t : triangles) {
      for (const int v : t) {
        if (v < 0 || static_cast<std::size_t>(v) >= points_.size()) return "an index";
      }
      const N area = cross(point(t[0]), point(t[1]), point(t[2]));
      if (!(area > N(0))) return "a triangle without area, or clockwise";
      sum += exact(area);
      for (std::size_t k = 0; k < 3; ++k) {
        const auto from = static_cast<std::size_t>(t[k]);
        const auto to = static_cast<std::size_t>(t[(k + 1) % 3]);
        if (++edges[{from, to}] > 1) return "an edge that is passed twice";
      }
    }
    for (std::size_t r = 0; r + 1 < starts_.size(); ++r) {
      const bool forward = (doubled_ring(r) > 0) == (r == 0);
      for (std::size_t i = 0; i < size(r); ++i) {
        std::size_t a = at(r, i), b = at(r, i + 1);
        if (!forward) std::swap(a, b);
        const auto found = edges.find({a, b});
        if (found == edges.end()) return "an edge of a ring that is missing";
        edges.erase(found);
      }
    }
    for (const auto& [edge, count] : edges) {
      if (edges.count({edge.second, edge.first}) != std::size_t(count))
        return "an edge without a neighbour";
    }
    if (sum != doubled_area()) return "the sum of the areas";
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      for (std::size_t j = i + 1; j < triangles.size(); ++j) {
        if (!separated(triangles[i], triangles[j]) && !separated(triangles[j], triangles[i])) {
          return "two triangles that overlap";
        }
      }
    }
    return {};
  }

 private:
  using Point = std::array<N, 2>;
  std::vector<Point> points_;
  std::vector<std::size_t> starts_;  // of each ring, and the end

  static N number(double x) {
    if constexpr (std::is_same_v<N, double>) {
      return x;
    } else {
      return oracle::exact(x);
    }
  }
  static Rational exact(const N& x) {
    if constexpr (std::is_same_v<N, double>) {
      return oracle::exact(x);
    } else {
      return x;
    }
  }
  std::size_t size(std::size_t r) const { return starts_[r + 1] - starts_[r]; }
  std::size_t at(std::size_t r, std::size_t i) const { return starts_[r] + i % size(r); }
  const Point& point(int v) const { return points_[static_cast<std::size_t>(v)]; }

  static N cross(const Point& a, const Point& b, const Point& c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  }
  static int side(const Point& a, const Point& b, const Point& c) {
    const N x = cross(a, b, c);
    return x > N(0) ? 1 : x < N(0) ? -1 : 0;
  }
  /// p is on the segment, ends included.
  static bool on(const Point& a, const Point& b, const Point& p) {
    if (side(a, b, p) != 0) return false;
    for (std::size_t k = 0; k < 2; ++k) {
      if (p[k] < std::min(a[k], b[k]) || p[k] > std::max(a[k], b[k])) return false;
    }
    return true;
  }
  /// Edges with a common end have nothing else in common, others nothing at all.
  bool allowed(const std::array<std::size_t, 2>& e, const std::array<std::size_t, 2>& f) const {
    const Point &a = points_[e[0]], &b = points_[e[1]], &c = points_[f[0]], &d = points_[f[1]];
    for (std::size_t k = 0; k < 2; ++k) {
      if (std::max(a[k], b[k]) < std::min(c[k], d[k])) return true;
      if (std::max(c[k], d[k]) < std::min(a[k], b[k])) return true;
    }
    if (e[1] == f[0] || e[0] == f[1]) {
      const bool forward = e[1] == f[0];
      const Point& start = forward ? a : b;
      const Point& end = forward ? d : c;
      const Point& middle = forward ? b : a;
      if (e[1] == f[0] && e[0] == f[1]) return false;
      return !on(start, middle, end) && !on(middle, end, start);
    }
    if (on(a, b, c) || on(a, b, d) || on(c, d, a) || on(c, d, b)) return false;
    return side(a, b, c) * side(a, b, d) >= 0 || side(c, d, a) * side(c, d, b) >= 0;
  }
  Rational doubled_ring(std::size_t r) const {
    Rational sum(0);
    for (std::size_t i = 0; i < size(r); ++i) {
      sum += exact(cross(points_[starts_[r]], points_[at(r, i)], points_[at(r, i + 1)]));
    }
    return sum;
  }
  bool contains(std::size_t r, const Point& p) const {
    bool inside = false;
    for (std::size_t i = 0; i < size(r); ++i) {
      const Point &a = points_[at(r, i)], &b = points_[at(r, i + 1)];
      if ((a[1] > p[1]) == (b[1] > p[1])) continue;
      if ((side(a, b, p) > 0) == (b[1] > a[1])) inside = !inside;
    }
    return inside;
  }
  /// All of t is on the outer side of an edge of s, or on it.
  bool separated(const std::array<int, 3>& s, const std::array<int, 3>& t) const {
    for (std::size_t k = 0; k < 3; ++k) {
      const Point &a = point(s[k]), &b = point(s[(k + 1) % 3]);
      if (std::all_of(t.begin(), t.end(), [&](int v) { return side(a, b, point(v)) <= 0; })) {
        return true;
      }
    }
    return false;
  }
};

}  // namespace triangulate_truth
