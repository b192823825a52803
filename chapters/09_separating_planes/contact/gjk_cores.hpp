/// @file
/// Convex bodies as GJK sees them: terms that all supports of a body share, computed once, and the
/// body times a power of two.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <contact/gjk_simplex.hpp>
#include <contact/support.hpp>
#include <contact/vector.hpp>
#include <limits>
#include <type_traits>

namespace contact::gjk_detail {

/// A point of a body as base + offset. The base is a stored point, the offset short: so differences
/// of far bodies lose no digits.
template <class S>
struct BaseAndOffset {
  Vector3<S> base, offset;
};

/// A core whose vertices are stored: a sphere, capsule, triangle or hull. Its points have no
/// offset.
template <ConvexBody Body>
class GjkCore {
 public:
  using S = ScalarOf<Body>;
  using Key = int;
  static constexpr bool has_offset = false;
  explicit GjkCore(const Body& body) : body_(body) {}
  Key farthest(const Vector3<S>& n) const { return support_vertex(body_, n); }
  const Vector3<S>& base(Key key) const { return vertex(body_, key); }
  Vector3<S> offset(Key) const { return Vector3<S>::Zero(); }

 private:
  const Body& body_;
};

// [box-core]
/// A box: its centre, and its half edges, each rounded once.
template <FloatOrDouble Scalar>
class GjkCore<OrientedBox<Scalar>> {
 public:
  using S = Scalar;
  using Key = int;
  static constexpr bool has_offset = true;
  explicit GjkCore(const OrientedBox<S>& box) : centre_(box.centre) {
    for (int i = 0; i < 3; ++i) {
      half_edges_[static_cast<std::size_t>(i)] = box.axes.col(i) * box.half_lengths(i);
    }
  }
  Key farthest(const Vector3<S>& n) const {
    return (dot3(n, half_edges_[0]) > S(0) ? 1 : 0) | (dot3(n, half_edges_[1]) > S(0) ? 2 : 0) |
           (dot3(n, half_edges_[2]) > S(0) ? 4 : 0);
  }
  const Vector3<S>& base(Key) const { return centre_; }
  Vector3<S> offset(Key key) const {
    const S x = (key & 1) != 0 ? S(1) : S(-1), y = (key & 2) != 0 ? S(1) : S(-1),
            z = (key & 4) != 0 ? S(1) : S(-1);
    return plus(plus(times(x, half_edges_[0]), y, half_edges_[1]), z, half_edges_[2]);
  }

 private:
  Vector3<S> centre_;
  std::array<Vector3<S>, 3> half_edges_;
};
// [/box-core]

/// A lozenge: its corner and its edges.
template <FloatOrDouble Scalar>
class GjkCore<Lozenge<Scalar>> {
 public:
  using S = Scalar;
  using Key = int;
  static constexpr bool has_offset = true;
  explicit GjkCore(const Lozenge<S>& body) : body_(body) {}
  Key farthest(const Vector3<S>& n) const { return support_vertex(body_, n); }
  const Vector3<S>& base(Key) const { return body_.corner; }
  Vector3<S> offset(Key key) const {
    return plus(times(S(key & 1), body_.first_edge), S(key >> 1), body_.second_edge);
  }

 private:
  const Lozenge<S>& body_;
};

/// A cylinder: an end of its core, and a vector of a radius perpendicular to it.
template <FloatOrDouble Scalar>
class GjkCore<Cylinder<Scalar>> {
 public:
  using S = Scalar;
  using Key = BaseAndOffset<S>;
  static constexpr bool has_offset = true;
  explicit GjkCore(const Cylinder<S>& body)
      : body_(body),
        axis_(detail::unit_of_any_size<S>(Vector3<S>(body.core.end - body.core.start))) {}
  Key farthest(const Vector3<S>& n) const {
    const S along = dot3(axis_, n);
    // Twice, because rounding leaves a component along the core; what is left below 4 u is
    // rounding.
    const Vector3<S> once = plus<S>(n, -along, axis_);
    const Vector3<S> across = plus<S>(once, -dot3(axis_, once), axis_);
    const S length = std::sqrt(dot3(across, across));
    const bool aside = length > S(2) * std::numeric_limits<S>::epsilon() * std::abs(along);
    return {along > S(0) ? body_.core.end : body_.core.start,
            aside ? times<S>(body_.radius / length, across) : Vector3<S>(Vector3<S>::Zero())};
  }
  const Vector3<S>& base(const Key& key) const { return key.base; }
  const Vector3<S>& offset(const Key& key) const { return key.offset; }

 private:
  const Cylinder<S>& body_;
  Vector3<S> axis_;
};

/// An ellipsoid: its centre, and M (Mᵀn)/|Mᵀn|.
template <FloatOrDouble Scalar>
class GjkCore<Ellipsoid<Scalar>> {
 public:
  using S = Scalar;
  using Key = BaseAndOffset<S>;
  static constexpr bool has_offset = true;
  explicit GjkCore(const Ellipsoid<S>& body) : centre_(body.centre) {
    for (int i = 0; i < 3; ++i) {
      image_[static_cast<std::size_t>(i)] = body.axes.col(i) * body.half_lengths(i);
    }
  }
  Key farthest(const Vector3<S>& n) const {
    const Vector3<S> turned(dot3(image_[0], n), dot3(image_[1], n), dot3(image_[2], n));
    const S length = std::sqrt(dot3(turned, turned));
    if (!(length > S(0))) return {centre_, Vector3<S>::Zero()};
    const Vector3<S> on_ball = times<S>(S(1) / length, turned);
    return {centre_, plus(plus(times<S>(on_ball[0], image_[0]), S(on_ball[1]), image_[1]),
                          S(on_ball[2]), image_[2])};
  }
  const Vector3<S>& base(const Key& key) const { return key.base; }
  const Vector3<S>& offset(const Key& key) const { return key.offset; }

 private:
  Vector3<S> centre_;
  std::array<Vector3<S>, 3> image_;  // of the axes of the ball
};

/// The larger of a number ≥ 0 and the magnitude of every entry of a vector; NaN if one is.
template <class S, class Derived>
S largest_entry(S largest, const Eigen::MatrixBase<Derived>& v) {
  for (int i = 0; i < v.cols(); ++i) {
    for (int k = 0; k < v.rows(); ++k) {
      const S x = std::abs(S(v.derived().coeff(k, i)));
      if (!(x <= largest)) largest = x;
      if (std::isnan(x)) return x;
    }
  }
  return largest;
}

/// The largest magnitude of the numbers of a body, m; infinite or NaN if one of them is. Of a box
/// and an ellipsoid products of axes and half lengths count: ∞ if one overflows.
template <ConvexBody Body>
ScalarOf<Body> largest_number(const Body& body) {
  using S = ScalarOf<Body>;
  S largest(0);
  const auto see = [&largest](const auto&... vectors) {
    ((largest = std::isnan(largest) ? largest : largest_entry<S>(largest, vectors)), ...);
  };
  if constexpr (requires { body.radius; }) largest = std::abs(body.radius);
  if constexpr (requires { body.core; }) {
    see(body.core.start, body.core.end);
  } else if constexpr (requires { body.vertices; }) {
    for (const Vector3<S>& v : body.vertices) see(v);
  } else if constexpr (requires { body.corner; }) {
    see(body.corner, body.first_edge, body.second_edge);
  } else if constexpr (requires { body.a; }) {
    see(body.a, body.b, body.c);
  } else if constexpr (requires { body.half_lengths; }) {
    see(body.centre, body.half_lengths);
    see(Matrix3<S>(body.axes * body.half_lengths.asDiagonal()));
  } else {
    see(body.centre);
  }
  return largest;
}

/// A body whose lengths are multiplied by 2^power; coordinates that become subnormal are rounded.
template <ConvexBody Body>
Body times_power_of_two(const Body& body, int power) {
  using S = ScalarOf<Body>;
  const auto times = [power](const Vector3<S>& v) {
    return Vector3<S>(std::ldexp(v.x(), power), std::ldexp(v.y(), power), std::ldexp(v.z(), power));
  };
  Body result = body;
  if constexpr (requires { body.radius; }) result.radius = std::ldexp(body.radius, power);
  if constexpr (requires { body.core; }) {
    result.core = {times(body.core.start), times(body.core.end)};
  } else if constexpr (requires { body.vertices; }) {
    for (Vector3<S>& v : result.vertices) v = times(v);
  } else if constexpr (requires { body.corner; }) {
    result.corner = times(body.corner);
    result.first_edge = times(body.first_edge);
    result.second_edge = times(body.second_edge);
  } else if constexpr (requires { body.a; }) {
    result = {times(body.a), times(body.b), times(body.c)};
  } else {
    result.centre = times(body.centre);
    if constexpr (requires { body.half_lengths; }) result.half_lengths = times(body.half_lengths);
  }
  return result;
}

}  // namespace contact::gjk_detail
