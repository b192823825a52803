/// @file
/// Exact answers about two polytopes with radii, independent of the book's methods: three cases and
/// the signed distance.
///
/// The book walks from simplex to simplex; here all features are listed. Two polytopes with a
/// difference of full dimension have a separating plane exactly if one is parallel to a face of
/// either or to an edge of each. Disjoint ones are closest at a vertex and a vertex, edge or face,
/// or at two edges. A closest pair is believed only if the plane perpendicular to it separates the
/// two: v · w ≥ v · v for all differences w. All coordinates are whole multiples of one power of
/// two, so everything is decided in integers. Doubles only say in which order candidates are tried,
/// or that one is worse than the best by more than any rounding.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "pair_cores.hpp"
#include "support/oracle.hpp"

namespace pair_truth {

/// What is true of two bodies.
struct Truth {
  int sign = 0;                ///< 1: disjoint, 0: touching, −1: overlapping
  oracle::Surd distance;       ///< signed, m
  Near normal = Near::Zero();  ///< a direction that attains it, from B to A, rounded
};

namespace detail {

/// Both cores in integers.
class Pair {
 public:
  Pair(const Core& a, const Core& b) : first_(a), second_(b) {
    std::vector<Vector> all = a.vertices;
    all.insert(all.end(), b.vertices.begin(), b.vertices.end());
    scale_ = common_denominator(all);
    for (const Vector& v : a.vertices) a_.push_back(whole(v, all[0], scale_));
    for (const Vector& v : b.vertices) b_.push_back(whole(v, all[0], scale_));
    long power = -100000;
    for (const auto* side : {&a_, &b_}) {
      for (const Whole& v : *side) power = std::max(power, power_of(v));
    }
    for (const Whole& v : a_) near_a_.push_back(near(v, power));
    for (const Whole& v : b_) near_b_.push_back(near(v, power));
  }

  Truth truth() {
    const Rational radii = first_.radius + second_.radius;
    Truth result;
    const bool full = is_full();
    if (full) {
      best_axis();
      result.normal = unit(axis_);
      result.distance =
          oracle::divided_by_root(Rational(room_, scale_), Rational(dot(axis_, axis_)));
      result.sign = room_.sign();
    }
    if (!full || room_ > 0) {
      closest();
      result.distance = {0, Rational(1, scale_), squared()};
      result.sign = is_zero(v_) ? 0 : 1;
      result.normal = is_zero(v_) ? flat_normal() : unit(v_);
    }
    if (radii != 0) {
      result.distance = result.distance + Rational(-radii);
      result.sign = oracle::sign(result.distance);
    }
    return result;
  }

 private:
  static Integer lowest(const std::vector<Whole>& points, const Whole& n) {
    Integer least = dot(n, points[0]);
    for (std::size_t i = 1; i < points.size(); ++i)
      least = std::min<Integer>(least, dot(n, points[i]));
    return least;
  }
  static Integer highest(const std::vector<Whole>& points, const Whole& n) {
    return -lowest(points, -n);
  }
  static double lowest(const std::vector<Near>& points, const Near& n) {
    double least = n.dot(points[0]);
    for (const Near& p : points) least = std::min(least, n.dot(p));
    return least;
  }
  const Whole& a(int i) const { return a_[static_cast<std::size_t>(i)]; }
  const Whole& b(int i) const { return b_[static_cast<std::size_t>(i)]; }
  const Near& near_a(int i) const { return near_a_[static_cast<std::size_t>(i)]; }
  const Near& near_b(int i) const { return near_b_[static_cast<std::size_t>(i)]; }

  /// Whether the difference of the cores has a volume: three edges of either that are independent.
  bool is_full() {
    for (const auto* side : {&a_, &b_}) {
      for (const Whole& v : *side) {
        const Whole d = v - (*side)[0];
        if (is_zero(d)) continue;
        if (is_zero(line_)) {
          line_ = d;
        } else if (is_zero(plane_)) {
          plane_ = cross(line_, d);
        } else if (dot(plane_, d) != 0) {
          return true;
        }
      }
    }
    return false;
  }
  /// Of a difference without volume that has the origin.
  Near flat_normal() const {
    if (!is_zero(plane_)) return unit(plane_);
    if (is_zero(line_)) return Near::UnitZ();
    const Near along = unit(line_);
    int least = 0;
    for (int i = 1; i < 3; ++i) {
      if (std::abs(along(i)) < std::abs(along(least))) least = i;
    }
    return along.cross(Near::Unit(least)).normalized();
  }

  std::vector<Whole> axes() const {
    std::vector<Whole> all, of_a, of_b;
    const auto add = [](std::vector<Whole>& to, const Whole& n) {
      if (is_zero(n)) return;
      for (const Whole& known : to) {
        if (known == n || known == -n) return;
      }
      to.push_back(n);
    };
    for (const auto& f : first_.faces) add(all, cross(a(f[1]) - a(f[0]), a(f[2]) - a(f[0])));
    for (const auto& f : second_.faces) add(all, cross(b(f[1]) - b(f[0]), b(f[2]) - b(f[0])));
    for (const auto& e : first_.edges) add(of_a, a(e[1]) - a(e[0]));
    for (const auto& e : second_.edges) add(of_b, b(e[1]) - b(e[0]));
    for (const Whole& d : of_a) {
      for (const Whole& e : of_b) {
        Whole n = cross(d, e);
        if (!is_zero(n)) all.push_back(std::move(n));
      }
    }
    return all;
  }

  /// The axis of largest gap. A rounded gap is off by less than 10⁻¹² of the coordinates, of which
  /// the largest is 1.
  void best_axis() {
    const std::vector<Whole> all = axes();
    std::vector<double> gaps(2 * all.size());
    double best = -INFINITY;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Near n = unit(all[i]);
      gaps[2 * i] = lowest(near_a_, n) + lowest(near_b_, -n);
      gaps[2 * i + 1] = lowest(near_a_, -n) + lowest(near_b_, n);
      best = std::max({best, gaps[2 * i], gaps[2 * i + 1]});
    }
    bool found = false;
    for (std::size_t i = 0; i < gaps.size(); ++i) {
      if (gaps[i] < best - 1e-12) continue;
      const Whole n = i % 2 == 0 ? all[i / 2] : Whole(-all[i / 2]);
      const Integer room = lowest(a_, n) - highest(b_, n);
      if (!found || oracle::compare(oracle::divided_by_root(room, dot(n, n)),
                                    oracle::divided_by_root(room_, dot(axis_, axis_))) > 0) {
        axis_ = n;
        room_ = room;
        found = true;
      }
    }
  }

  // Closest features ---------------------------------------------------------------------------

  /// Two features, of A and of B, by their vertices: of one to three, and one; or of two and two.
  struct Features {
    double distance;  ///< rounded, of their lines or planes
    std::array<int, 3> of_a, of_b;
    int count_a, count_b;
  };

  Rational squared() const { return Rational(dot(v_, v_), Integer(over_ * over_)); }
  /// Whether the plane perpendicular to v separates the bodies by |v|.
  bool is_closest() const {
    const Integer room = lowest(a_, v_) - highest(b_, v_);
    return room * over_ >= dot(v_, v_);
  }
  void keep(const Whole& v, const Integer& over) {
    if (known_ && dot(v, v) * over_ * over_ >= dot(v_, v_) * over * over) return;
    known_ = true;
    v_ = v;
    over_ = over;
  }

  /// From the feature of the other body to the vertex; `sign` is −1 if the vertex is B's.
  void try_vertex(const Whole& p, const std::array<const Whole*, 3>& f, int count, int sign) {
    const Whole w = p - *f[0];
    if (count == 1) return keep(w * Integer(sign), 1);
    const Whole d = *f[1] - *f[0];
    if (count == 2) {
      const Integer along = dot(w, d), length = dot(d, d);
      if (length == 0 || along < 0 || along > length) return;
      return keep((w * length - d * along) * Integer(sign), length);
    }
    const Whole e = *f[2] - *f[0];
    const Whole n = cross(d, e);
    const Integer length = dot(n, n);
    if (length == 0) return;
    const Integer x = dot(cross(w, e), n), y = dot(cross(d, w), n);
    if (x < 0 || y < 0 || x + y > length) return;
    keep(n * Integer(dot(n, w) * sign), length);
  }
  void try_edges(const Whole& p, const Whole& d, const Whole& q, const Whole& e) {
    const Whole n = cross(d, e), w = q - p;
    const Integer length = dot(n, n);
    if (length == 0) return;
    const Integer s = dot(cross(w, e), n), t = dot(cross(w, d), n);
    if (s < 0 || t < 0 || s > length || t > length) return;
    keep(n * Integer(-dot(n, w)), length);
  }
  void try_features(const Features& f) {
    if (f.count_a == 2 && f.count_b == 2) {
      return try_edges(a(f.of_a[0]), a(f.of_a[1]) - a(f.of_a[0]), b(f.of_b[0]),
                       b(f.of_b[1]) - b(f.of_b[0]));
    }
    std::array<const Whole*, 3> other{};
    for (std::size_t i = 0; i < 3; ++i) other[i] = f.count_a == 1 ? &b(f.of_b[i]) : &a(f.of_a[i]);
    if (f.count_a == 1) {
      try_vertex(a(f.of_a[0]), other, f.count_b, 1);
    } else {
      try_vertex(b(f.of_b[0]), other, f.count_a, -1);
    }
  }

  /// About how far the features are apart if they face each other; nothing if they surely do not.
  static std::optional<double> about(const Near& p, const std::array<const Near*, 3>& f,
                                     int count) {
    constexpr double room = 1e-6;
    const Near w = p - *f[0];
    if (count == 1) return w.norm();
    const Near d = *f[1] - *f[0];
    if (count == 2) {
      const double t = w.dot(d) / d.squaredNorm();
      if (t < -room || t > 1 + room) return std::nullopt;
      return (w - d * t).norm();
    }
    const Near e = *f[2] - *f[0], n = d.cross(e);
    const double length = n.squaredNorm();
    const double x = w.cross(e).dot(n) / length, y = d.cross(w).dot(n) / length;
    if (x < -room || y < -room || x + y > 1 + room) return std::nullopt;
    return std::abs(n.dot(w)) / std::sqrt(length);
  }
  static std::optional<double> about(const Near& p, const Near& d, const Near& q, const Near& e) {
    constexpr double room = 1e-6;
    const Near n = d.cross(e), w = q - p;
    const double length = n.squaredNorm();
    const double s = w.cross(e).dot(n) / length, t = w.cross(d).dot(n) / length;
    if (s < -room || t < -room || s > 1 + room || t > 1 + room) return std::nullopt;
    return std::abs(n.dot(w)) / std::sqrt(length);
  }

  std::vector<Features> features() const {
    std::vector<Features> all;
    const auto add = [&](std::optional<double> distance, const std::array<int, 3>& x, int n,
                         const std::array<int, 3>& y, int m) {
      if (distance) all.push_back({std::isfinite(*distance) ? *distance : 0.0, x, y, n, m});
    };
    const auto one_way = [&](const Core& of, const std::vector<Near>& to,
                             const std::vector<Near>& from, bool turned) {
      const auto other = [&](const std::array<int, 3>& f, int count) {
        for (std::size_t i = 0; i < from.size(); ++i) {
          const std::array<int, 3> p{static_cast<int>(i), 0, 0};
          const auto at = [&to](int k) { return &to[static_cast<std::size_t>(k)]; };
          const auto distance = about(from[i], {at(f[0]), at(f[1]), at(f[2])}, count);
          if (turned) {
            add(distance, f, count, p, 1);
          } else {
            add(distance, p, 1, f, count);
          }
        }
      };
      for (const auto& e : of.edges) other({e[0], e[1], e[1]}, 2);
      for (const auto& f : of.faces) other(f, 3);
      if (turned) return;
      for (int i = 0; i < static_cast<int>(to.size()); ++i) other({i, i, i}, 1);
    };
    one_way(second_, near_b_, near_a_, false);
    one_way(first_, near_a_, near_b_, true);
    for (const auto& e : first_.edges) {
      for (const auto& f : second_.edges) {
        add(about(near_a(e[0]), near_a(e[1]) - near_a(e[0]), near_b(f[0]),
                  near_b(f[1]) - near_b(f[0])),
            {e[0], e[1], e[1]}, 2, {f[0], f[1], f[1]}, 2);
      }
    }
    std::sort(all.begin(), all.end(),
              [](const Features& x, const Features& y) { return x.distance < y.distance; });
    return all;
  }

  /// v_ / over_ becomes the smallest difference of points of A and B; 0 if they meet.
  void closest() {
    constexpr std::size_t max_tried = 24;
    const std::vector<Features> likely = features();
    for (std::size_t i = 0; i < likely.size() && i < max_tried; ++i) {
      try_features(likely[i]);
      if (known_ && (is_zero(v_) || is_closest())) return;
    }
    // Rounding has hidden it: all of them.
    for (std::size_t i = 0; i < a_.size(); ++i) {
      for (std::size_t k = 0; k < b_.size(); ++k) keep(a_[i] - b_[k], 1);
    }
    const auto faces = [&](const Core& of, const std::vector<Whole>& to,
                           const std::vector<Whole>& from, int sign) {
      const auto at = [&to](int k) { return &to[static_cast<std::size_t>(k)]; };
      for (const Whole& p : from) {
        for (const auto& e : of.edges) try_vertex(p, {at(e[0]), at(e[1]), at(e[1])}, 2, sign);
        for (const auto& f : of.faces) try_vertex(p, {at(f[0]), at(f[1]), at(f[2])}, 3, sign);
      }
    };
    faces(second_, b_, a_, 1);
    faces(first_, a_, b_, -1);
    for (const auto& e : first_.edges) {
      for (const auto& f : second_.edges) {
        try_edges(a(e[0]), a(e[1]) - a(e[0]), b(f[0]), b(f[1]) - b(f[0]));
      }
    }
    if (!is_zero(v_) && !is_closest()) keep(Whole(0, 0, 0), 1);  // one is in the other
  }

  const Core& first_;
  const Core& second_;
  Integer scale_;  ///< units in a metre
  std::vector<Whole> a_, b_;
  std::vector<Near> near_a_, near_b_;  ///< the largest coordinate is 1
  Whole line_{0, 0, 0}, plane_{0, 0, 0};
  Whole axis_{0, 0, 0};
  Integer room_{0};
  bool known_ = false;
  Whole v_{0, 0, 0};
  Integer over_{1};
};

}  // namespace detail

/// Of two cores with their radii.
inline Truth truth(const Core& a, const Core& b) { return detail::Pair(a, b).truth(); }
/// Of two bodies with polytopes as cores.
template <class A, class B>
Truth truth(const A& a, const B& b) {
  const Core first = core_of(a), second = core_of(b);
  return truth(first, second);
}

}  // namespace pair_truth
