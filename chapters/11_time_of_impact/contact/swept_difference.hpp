/// @file
/// Whether two translating bodies meet between two times, without rounding: the distance of the
/// origin from the volume that their difference sweeps.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <vector>

#include <contact/certificates.hpp>
#include <contact/exact.hpp>
#include <contact/exact_gjk.hpp>
#include <contact/exact_support.hpp>
#include <contact/impact_proof.hpp>
#include <contact/support.hpp>
#include <contact/vector.hpp>

namespace contact::detail {

/// The answer about an interval of times: a plane that separates the bodies, or a common point.
struct SweptAnswer {
  bool meets = false;
  CommonPointInMotion common;  ///< if they meet
  Vector3<Exact> normal;       ///< if not: separates them throughout, both ends included
};

// [swept-difference]
/// The difference of two bodies, swept between two times by the relative displacement.
///
/// The bodies meet at some time from t₀ to t₁ if and only if the origin is within the sum of their
/// radii of the hull of all aᵢ − bᵢ + t₀ w and aᵢ − bᵢ + t₁ w: a point of this hull is a difference
/// of points of both cores at a time between. The hull is convex, so GJK decides, without rounding:
/// see exact_gjk().
template <PolytopeCore A, PolytopeCore B>
class SweptDifference {
 public:
  /// @param a, b as is_convex_body() requires; w without rounding
  SweptDifference(const A& a, const B& b, const Vector3<Exact>& w)
      : a_(a), b_(b), w_(w), reach_(radius_sum(a, b)) {}

  /// Whether they meet at a time between two.
  /// @param start differences from which the search starts; those of four vertices at most
  SweptAnswer between(double from, double to, const CommonPointInMotion& start) const {
    const Ends ends{from, to, w_ * Exact(from), w_ * Exact(to)};
    std::vector<ExactDifference> points;
    for (std::size_t i = 0; i < std::size_t(std::clamp(start.count, 0, 4)); ++i) {
      points.push_back(difference(start.of_a[i], start.of_b[i], start.times[i] > from, ends));
    }
    if (points.empty()) points.push_back(difference(0, 0, false, ends));
    for (;;) {
      const ExactClosest closest = closest_of_hull(points);
      if (is_within(closest, reach_)) return meeting(closest, ends);
      const Vector3<Exact>& n = closest.direction;
      const ExactDifference least = difference(farthest_vertex(a_, Vector3<Exact>(-n)),
                                               farthest_vertex(b_, n), n.dot(w_).sign() < 0, ends);
      const Exact lowest = n.dot(least.w);
      // The plane separates as soon as its lower bound on the distance exceeds the radii.
      if (lowest.sign() > 0 && reach_ * reach_ * n.dot(n) < lowest * lowest) return {false, {}, n};
      points.assign(closest.vertex.begin(), closest.vertex.begin() + closest.count);
      points.push_back(least);
    }
  }
  // [/swept-difference]

  // [plane-closes]
  /// A lower bound on the time at which a plane closes, close to it: (h − r |n|) / closing, written
  /// as (h² − r² n²) / (closing h) / (1 + r |n| / h), in which nothing cancels.
  ///
  /// The quotients and the root are off by at most u and 2 u, sum and quotient by u each: less than
  /// 6 u together, for which 1 − 2^-49 is room.
  /// @param n separates the bodies at the start
  /// @return fraction of the step; 0 below 2^-1000; ∞ if the plane never closes
  double closes(const Vector3<Exact>& n) const {
    const Exact closing = -n.dot(w_);
    if (closing.sign() <= 0) return std::numeric_limits<double>::infinity();
    const int p = farthest_vertex(a_, Vector3<Exact>(-n)), q = farthest_vertex(b_, n);
    const Exact h = n.dot(Vector3<Exact>(exact_vertex(a_, p) - exact_vertex(b_, q)));
    const Exact squared = reach_ * reach_ * n.dot(n);
    const double ratio = std::sqrt(quotient<double>(squared, h * h));
    const double t = quotient<double>(h * h - squared, closing * h) / (1 + ratio);
    return t > 0x1p-1000 && std::isfinite(t) ? t * (1 - 0x1p-49) : 0;
  }
  // [/plane-closes]

 private:
  const A& a_;
  const B& b_;
  Vector3<Exact> w_;
  Exact reach_;

  /// The two times, and how far A has moved relative to B at each.
  struct Ends {
    double from, to;
    Vector3<Exact> moved_from, moved_to;
  };

  /// An index of A's vertex from its number of vertices on says that it is taken at the later time.
  ExactDifference difference(int p, int q, bool late, const Ends& ends) const {
    const Vector3<Exact> d = exact_vertex(a_, p) - exact_vertex(b_, q);
    return {{late ? p + vertex_count(a_) : p, q}, d + (late ? ends.moved_to : ends.moved_from)};
  }
  SweptAnswer meeting(const ExactClosest& closest, const Ends& ends) const {
    SweptAnswer answer{true, {}, Vector3<Exact>::Zero()};
    answer.common.count = closest.count;
    const int count = vertex_count(a_);
    for (std::size_t i = 0; i < std::size_t(closest.count); ++i) {
      const DifferenceIndex& of = closest.vertex[i].of;
      answer.common.of_a[i] = of.a % count;
      answer.common.of_b[i] = of.b;
      answer.common.times[i] = of.a >= count ? ends.to : ends.from;
    }
    return answer;
  }
};

}  // namespace contact::detail
