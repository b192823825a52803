/// @file
/// A ray cast at the Minkowski difference of two convex bodies by GJK, rounded: candidates for the
/// time of impact, its normal and the vertices that meet.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>

#include <contact/bounded_differences.hpp>
#include <contact/gjk_cores.hpp>
#include <contact/gjk_simplex.hpp>
#include <contact/impact_proof.hpp>
#include <contact/outward.hpp>
#include <contact/running_error.hpp>
#include <contact/support.hpp>
#include <contact/tolerance.hpp>
#include <contact/vector.hpp>

namespace contact::detail {

/// What a ray cast has found; nothing of it is proved.
struct CastCandidate {
  enum class End {
    unsure,  ///< nothing is known
    passes,  ///< the plane separates the bodies throughout the step
    meets    ///< they meet at about t
  } end = End::unsure;
  double t = 0;                                      ///< fraction of the step
  Vector3<double> normal = Vector3<double>::Zero();  ///< of the last plane; 0: none separated them
};

/// A GJK ray cast, rounded.
///
/// Relative to B, A translates by w. They meet when the difference A − B, translated by t w, has
/// the origin within the sum of the radii of its core. Each step takes the difference d farthest
/// towards the origin along the direction v from B to A. If v · (d + t w) > r |v|, a plane
/// perpendicular to v separates them, until it has closed: t advances to that time, which is not
/// after the impact. Then d joins the simplex, and v becomes the point of the simplex, moved to the
/// time t, that is closest to the origin. For polytopes the last plane is that of the face or the
/// edges that meet, and t is the time of impact up to rounding; with a radius it is Newton's method
/// from the left on a convex function.
///
/// Source: van den Bergen, *Ray Casting against General Convex Objects with Application to
/// Continuous Collision Detection* (2004).
template <PolytopeCore A, PolytopeCore B>
class RayCast {
 public:
  /// @param w relative displacement, m; rounded
  RayCast(const A& a, const B& b, const Vector3<double>& w)
      : a_(a), b_(b), w_(w), radius_(radius_of(a) + radius_of(b)) {
    direction_ = inner_point(a) - inner_point(b);
  }

  /// Casts from the time 0.
  CastCandidate cast() {
    CastCandidate found;
    for (int i = 0; i < max_steps; ++i) {
      const Vector3<double>& v = direction_;
      const double squared = dot3(v, v);
      const double length = std::sqrt(squared);
      if (!(length > size_ * 0x1p-46)) return ended(found, size_ > 0);
      const int p = a_.farthest(Vector3<double>(-v)), q = b_.farthest(v);
      const Vector3<double> d = difference(p, q);
      const double along = dot3(v, d) + found.t * dot3(v, w_);
      size_ = std::max({size_, d.cwiseAbs().maxCoeff(), (d + w_ * found.t).cwiseAbs().maxCoeff()});
      if (!(size_ < 0x1p150)) return {};
      // [ray-cast]
      const double gap = along - radius_ * length;
      bool advanced = false;
      if (gap > 0) {
        const double closing = -dot3(v, w_);
        const double t = found.t + gap / closing;
        if (!(closing > 0) || t > 1) {
          found.normal = closing < 0 && found.t > 0 ? at_rest(found.normal, v) : v;
          found.end = CastCandidate::End::passes;
          return found;
        }
        advanced = t > found.t;
        if (advanced) {
          found.t = t;
          found.normal = v;
        }
      }
      const bool known = has(p, q);
      if (known && !advanced) return ended(found, true);
      if (!known && count_ < 4) append(p, q, d);
      solve(found.t);
      if (inside_) return ended(found, true);
      // [/ray-cast]
    }
    return found;
  }

  /// Looks for vertices that prove a meeting at the time t, from the simplex of the last search.
  /// @return without vertices if it finds none
  CommonPointInMotion meeting_at(double t) {
    if (count_ == 0) {
      const int p = a_.farthest(Vector3<double>(-direction_)), q = b_.farthest(direction_);
      append(p, q, difference(p, q));
    }
    for (int i = 0; i < max_steps; ++i) {
      solve(t);
      const double squared = dot3(direction_, direction_);
      if (inside_ || squared < radius_ * radius_ * (1 - 0x1p-40)) return vertices_at(t);
      const int p = a_.farthest(Vector3<double>(-direction_)), q = b_.farthest(direction_);
      if (count_ == 4 || has(p, q)) break;
      append(p, q, difference(p, q));
    }
    return {};
  }

 private:
  static constexpr int max_steps = 64;
  gjk_detail::GjkCore<A> a_;
  gjk_detail::GjkCore<B> b_;
  Vector3<double> w_;
  double radius_;
  Vector3<double> direction_;  // from B to A
  FourPoints<double> d_;       // the simplex, at the start of the step
  std::array<int, 4> of_a_{}, of_b_{};
  int count_ = 0;
  bool inside_ = false;  // whether the simplex has the origin, up to rounding
  double size_ = 0;      // the largest coordinate of a difference

  static CastCandidate ended(CastCandidate found, bool known) {
    if (known) found.end = CastCandidate::End::meets;
    return found;
  }
  Vector3<double> difference(int p, int q) const {
    return (a_.base(p) - b_.base(q)) + (a_.offset(p) - b_.offset(q));
  }
  bool has(int p, int q) const {
    for (std::size_t i = 0; i < std::size_t(count_); ++i) {
      if (of_a_[i] == p && of_b_[i] == q) return true;
    }
    return false;
  }
  void append(int p, int q, const Vector3<double>& d) {
    const auto at = std::size_t(count_++);
    of_a_[at] = p;
    of_b_[at] = q;
    d_[at] = d;
  }
  /// A plane that separates the bodies at all times, from one that closes at t and one that opens
  /// and separates them at t: the positive combination whose separation does not change.
  ///
  /// The separation along n is a concave function of n, so that of x n + y m is at least x times
  /// that along n and y times that along m; at t the first is 0 and the second is not.
  Vector3<double> at_rest(const Vector3<double>& closing, const Vector3<double>& opening) const {
    return closing * dot3(opening, w_) - opening * dot3(closing, w_);
  }
  /// The point of the simplex closest to the origin at the time t; leaves the vertices of its face.
  void solve(double t) {
    FourPoints<double> moved;
    moved.fill(Vector3<double>::Zero());
    for (std::size_t i = 0; i < std::size_t(count_); ++i) moved[i] = d_[i] + w_ * t;
    const SimplexPoint<double> closest = closest_of_simplex(moved, count_);
    direction_ = closest.point;
    inside_ = closest.face == 15U || direction_ == Vector3<double>::Zero();
    int kept = 0;
    for (std::size_t i = 0; i < std::size_t(count_); ++i) {
      if ((closest.face >> i & 1U) == 0) continue;
      const auto at = std::size_t(kept++);
      d_[at] = d_[i];
      of_a_[at] = of_a_[i];
      of_b_[at] = of_b_[i];
    }
    count_ = kept;
  }
  CommonPointInMotion vertices_at(double t) const {
    CommonPointInMotion common{count_, of_a_, of_b_, {}};
    common.times.fill(t);
    return common;
  }
};

/// The stored position from which vertices of a core are offset: see vertex_from_position().
template <PolytopeCore Body>
const Vector3<double>& position_of_vertex(const Body& body, int i) {
  if constexpr (std::same_as<Body, OrientedBox<double>>) {
    return body.centre;
  } else if constexpr (std::same_as<Body, Lozenge<double>>) {
    return body.corner;
  } else {
    return vertex(body, i);
  }
}

/// The offset of vertex i from its position, in a number type with + − ×; 0 where it is stored.
template <class T, PolytopeCore Body>
Triple<T> offset_in(const Body& body, int i) {
  Triple<T> offset{};
  const auto add = [&offset](const Vector3<double>& edge, const T& times) {
    const Triple<T> e = triple<T>(edge);
    for (std::size_t k = 0; k < 3; ++k) offset[k] = offset[k] + e[k] * times;
  };
  if constexpr (std::same_as<Body, OrientedBox<double>>) {
    for (int k = 0; k < 3; ++k)
      add(body.axes.col(k), T((i >> k & 1) != 0 ? body.half_lengths(k) : -body.half_lengths(k)));
  } else if constexpr (std::same_as<Body, Lozenge<double>>) {
    if ((i & 1) != 0) add(body.first_edge, T(1.0));
    if ((i & 2) != 0) add(body.second_edge, T(1.0));
  }
  return offset;
}

// [certainly-meet]
/// Whether differences at one time certainly prove a meeting, by running error bounds: false means
/// nothing.
///
/// One to three with a mean closer to the origin than the sum of the radii, with the weights of the
/// rounded closest point; or four that surround the origin, whose four determinants have the same
/// sign.
template <PolytopeCore A, PolytopeCore B>
bool certainly_meet(const CommonPointInMotion& common, const A& a,
                    const Vector3<double>& displacement_a, const B& b,
                    const Vector3<double>& displacement_b) {
  using T = RunningError;
  const Triple<T> w = minus(triple<T>(displacement_a), triple<T>(displacement_b));
  std::array<Triple<T>, 4> d;
  FourPoints<double> rounded;
  rounded.fill(Vector3<double>::Zero());
  const auto count = std::size_t(common.count);
  for (std::size_t i = 0; i < count; ++i) {
    const int p = common.of_a[i], q = common.of_b[i];
    d[i] = minus(triple<T>(position_of_vertex(a, p)), triple<T>(position_of_vertex(b, q)));
    const Triple<T> offset = minus(offset_in<T>(a, p), offset_in<T>(b, q));
    for (std::size_t k = 0; k < 3; ++k) {
      d[i][k] = (d[i][k] + w[k] * T(common.times[i])) + offset[k];
      rounded[i](int(k)) = d[i][k].value;
    }
  }
  if (count == 0) return false;
  const double radius = sum_down(radius_of(a), radius_of(b));
  const auto weights = closest_of_simplex(rounded, common.count).weights;
  Triple<T> mean;
  T whole;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < 3; ++k) mean[k] = mean[k] + d[i][k] * T(weights[i]);
    whole = whole + T(weights[i]);
  }
  const T reach = whole * T(radius);
  if ((reach * reach - dot(mean, mean)).certain_sign() > 0) return true;
  if (count != 4) return false;
  const auto volume = [&](std::size_t i, std::size_t j, std::size_t k) {
    return dot(d[i], cross(d[j], d[k])).certain_sign();
  };
  const int sign = volume(1, 2, 3);
  return sign != 0 && volume(0, 2, 3) == -sign && volume(0, 1, 3) == sign &&
         volume(0, 1, 2) == -sign;
}
// [/certainly-meet]

// [projected-bounds]
/// Bounds of n · (x − c) over the core of a body.
struct ProjectedBounds {
  double low = std::numeric_limits<double>::infinity();    ///< at most the least
  double high = -std::numeric_limits<double>::infinity();  ///< at least the largest
};

/// The bounds for an n whose largest entry is from 1 to 2, and a c close to the body.
///
/// Let E be the absolute terms of the offsets. A term of n · ((position − c) + offset) has one
/// rounding for the difference, or three for the offset; one for their sum, one for the product and
/// two for the sum of three: at most seven, of terms of at most |n| · (|position − c| + E). That
/// sum is rounded as often, so γ(16) of it is more. A product that underflows is off by at most
/// half the smallest number, times 2: 2^-1000 covers all.
template <PolytopeCore Body>
ProjectedBounds projected_bounds(const Body& body, const Vector3<double>& n,
                                 const Vector3<double>& c) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  ProjectedBounds bounds;
  const double offsets = offset_size(body);
  for (int i = 0; i < vertex_count(body); ++i) {
    const PositionAndOffset v = vertex_from_position(body, i);
    const Vector3<double> from = v.position - c;
    const Vector3<double> d = from + v.offset;
    const double size = std::abs(n[0]) * (std::abs(from[0]) + offsets) +
                        std::abs(n[1]) * (std::abs(from[1]) + offsets) +
                        std::abs(n[2]) * (std::abs(from[2]) + offsets);
    const double room = tolerance::gamma<double>(16) * size + 0x1p-1000;
    const double along = dot3(n, d);
    bounds.low = std::min(bounds.low, along - room);
    bounds.high = std::max(bounds.high, along + room);
    if (!std::isfinite(along + room)) return {-infinity, infinity};
  }
  return bounds;
}
// [/projected-bounds]

/// v times a power of two, so that its largest entry is from 1 to 2; 0 if it is 0 or not finite.
inline Vector3<double> near_one(const Vector3<double>& v) {
  const double largest = v.cwiseAbs().maxCoeff();
  if (!(largest > 0) || !std::isfinite(largest)) return Vector3<double>::Zero();
  const int power = -std::ilogb(largest);
  return {std::ldexp(v.x(), power), std::ldexp(v.y(), power), std::ldexp(v.z(), power)};
}

// [closes-not-before]
/// A time before which a plane perpendicular to n separates the bodies for certain: the separation
/// at the start, rounded down, by what it loses in the step, rounded up.
///
/// Positions are taken relative to a vertex of A, so bodies far from the origin lose no digits.
/// The radii take r |n|, at most five roundings and with (1 + 8 u) an upper bound.
/// @param n largest entry from 1 to 2
/// @return fraction of the step, not below 0; ∞ if it separates them throughout
template <PolytopeCore A, PolytopeCore B>
double closes_not_before(const Vector3<double>& n, const A& a,
                         const Vector3<double>& displacement_a, const B& b,
                         const Vector3<double>& displacement_b) {
  const Vector3<double> c = vertex_from_position(a, 0).position;
  const double radius = sum_up(double(radius_of(a)), double(radius_of(b)));
  const double of_radius = radius * std::sqrt(dot3(n, n)) * (1 + 8 * RunningError::u) + 0x1p-1000;
  const double in_front = projected_bounds(a, n, c).low, behind = projected_bounds(b, n, c).high;
  const double separation = sum_down(sum_down(in_front, -behind), -of_radius);
  if (!(separation > 0) || !std::isfinite(separation)) return 0;
  using T = RunningError;
  const T closing = dot(triple<T>(n), minus(triple<T>(displacement_b), triple<T>(displacement_a)));
  const double most = sum_up(closing.value, closing.bound);
  if (most <= 0) return std::numeric_limits<double>::infinity();
  const double t = separation / most;
  return t > 0 ? std::nextafter(t, 0) : 0;  // 0 also for NaN
}
// [/closes-not-before]

}  // namespace contact::detail
