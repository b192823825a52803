/// @file
/// Orientation predicates: the orientation of three points in the plane and of four points in
/// space, with the right sign for every finite input.
#pragma once

#include <cmath>
#include <contact/difference_determinant.hpp>
#include <contact/drop_dimension.hpp>
#include <contact/exact.hpp>
#include <contact/filter.hpp>
#include <contact/vector.hpp>
#include <cstddef>
#include <limits>
#include <optional>

namespace contact {

/// The orientation of a, b and c from products of the coordinates themselves: twice the signed area
/// of the triangle a, b, c, positive if the path from a over b to c turns left, that is, if c is to
/// the left of the line from a to b.
///
/// Limits: six products as large as |a||b|. Far from the origin they are much larger than the area,
/// and the sign of the rounded result is not reliable. Exact if S is exact.
// [line-side]
template <Ring S>
S orientation_expanded(const Vector2<S>& a, const Vector2<S>& b, const Vector2<S>& c) {
  return (a.x() * b.y() - a.y() * b.x()) + (b.x() * c.y() - b.y() * c.x()) +
         (c.x() * a.y() - c.y() * a.x());
}

/// The same, with the differences taken first: (b − a) × (c − a).
///
/// Limits: the differences of near points have little or no error. The result, a difference of two
/// products, is off by at most γ(5) times the sum of their magnitudes. Exact if S is exact.
template <Ring S>
S orientation(const Vector2<S>& a, const Vector2<S>& b, const Vector2<S>& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}
// [/line-side]

/// Six times the signed volume of the tetrahedron a, b, c, d, as the scalar rounds it: positive if
/// d is in front of the triangle a, b, c, where its vertices run counter-clockwise.
///
/// Limits: rounded, the sign may be wrong if the four points are nearly in a plane. Exact if S is
/// exact.
// [rounded-3d]
template <Ring S>
S signed_volume(const Vector3<S>& a, const Vector3<S>& b, const Vector3<S>& c,
                const Vector3<S>& d) {
  const Vector3<S> ab = b - a, ac = c - a, ad = d - a;
  return ad.dot(ab.cross(ac));
}
// [/rounded-3d]

namespace orientation_detail {

using difference_detail::sign_of;

/// Whether products of three such numbers and their errors neither overflow nor underflow: each is
/// a whole multiple of 2^-352 below 2^300.
inline bool moderate(double x) {
  const double size = std::abs(x);
  return x == 0 || (size >= 0x1p-300 && size <= 0x1p300);
}

}  // namespace orientation_detail

/// The same sign as `orient_2d`, in exact arithmetic from the start: slow. It shows what the
/// filter saves.
inline int orient_2d_exactly(const Vector2<double>& a, const Vector2<double>& b,
                             const Vector2<double>& c) {
  const auto exact = [](const Vector2<double>& v) {
    return Vector2<Exact>(Exact(v.x()), Exact(v.y()));
  };
  return orientation<Exact>(exact(a), exact(b), exact(c)).sign();
}

/// The same sign as `orient_3d`, in exact arithmetic from the start.
inline int orient_3d_exactly(const Vector3<double>& a, const Vector3<double>& b,
                             const Vector3<double>& c, const Vector3<double>& d) {
  const auto exact = [](const Vector3<double>& v) {
    return Vector3<Exact>(Exact(v.x()), Exact(v.y()), Exact(v.z()));
  };
  return signed_volume<Exact>(exact(a), exact(b), exact(c), exact(d)).sign();
}

// [filter-bound]
/// `orientation` in double with its error bound.
///
/// The bound: each product has two rounded differences and its own rounding, and the difference of
/// the products is rounded once. These are four roundings a term, so |value − exact| ≤
/// γ₄ (|left| + |right|) for exact products. The computed magnitudes are at most γ₃ smaller, and
/// their sum is rounded: 5u covers 4u/(1 − 4u)/(1 − γ₃)·(1 + u)². Underflow adds at most 2^-1074
/// for each product, far less than the constant 2^-1000. Overflow makes the bound infinite or NaN,
/// and then no sign is certain.
inline Bounded bounded_orientation(const Vector2<double>& a, const Vector2<double>& b,
                                   const Vector2<double>& c) {
  constexpr double five_u = 2.5 * std::numeric_limits<double>::epsilon();
  const double left = (b.x() - a.x()) * (c.y() - a.y());
  const double right = (b.y() - a.y()) * (c.x() - a.x());
  return {left - right, five_u * (std::abs(left) + std::abs(right)) + 0x1p-1000};
}
// [/filter-bound]

/// Decides what the filter could not: the orientation of three points, right for every finite
/// input.
///
/// The differences are exact as pairs of doubles, and these are scaled to integers, of which the
/// determinant is computed without error. `Exact` decides about numbers that span more than 112
/// bits and those at the ends of the range of double.
[[gnu::noinline]] inline int orient_2d_in_doubt(const Vector2<double>& a, const Vector2<double>& b,
                                                const Vector2<double>& c) {
  difference_detail::Differences<4> numbers;
  for (int i = 0; i < 2; ++i) {
    const auto k = static_cast<std::size_t>(i);
    numbers.set(k, b[i], a[i]);
    numbers.set(2 + k, c[i], a[i]);
  }
  const std::optional<int> sign = determinant_sign(numbers);
  return sign ? *sign : orient_2d_exactly(a, b, c);
}

/// The orientation of three points: +1 if c is left of the line from a to b, −1 if it is right of
/// it, 0 if it is exactly on it (or a = b).
///
/// The sign is right for every finite input: a floating-point filter decides most cases, and exact
/// arithmetic the rest.
///
/// @param a,b,c m, any scale; coordinates must be finite
///
/// Source: Shewchuk, Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric
/// Predicates, 1997, with the bound derived at `bounded_orientation`.
// [filter-2d]
inline int orient_2d(const Vector2<double>& a, const Vector2<double>& b, const Vector2<double>& c) {
  const int certain = bounded_orientation(a, b, c).certain_sign();
  return certain != 0 ? certain : orient_2d_in_doubt(a, b, c);
}
// [/filter-2d]

/// Decides what the filter could not: on which side of the plane a, b, c the point d is. As
/// `orient_2d_in_doubt`, after an attempt with whole multiples of a unit, which is faster.
[[gnu::noinline]] inline int orient_3d_in_doubt(const Vector3<double>& a, const Vector3<double>& b,
                                                const Vector3<double>& c,
                                                const Vector3<double>& d) {
  const std::optional<int> of_whole = difference_detail::whole_volume_sign(a, b, c, d);
  if (of_whole) return *of_whole;
  difference_detail::Differences<9> numbers;
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    numbers.set(k, d[i], a[i]);
    numbers.set(3 + k, b[i], a[i]);
    numbers.set(6 + k, c[i], a[i]);
  }
  const std::optional<int> sign = determinant_sign(numbers);
  return sign ? *sign : orient_3d_exactly(a, b, c, d);
}

// [filter-3d]
/// The orientation of four points: +1 if d is in front of the plane through a, b and c, on the side
/// from which they run counter-clockwise, −1 if it is behind, 0 if it is exactly on the plane (or
/// a, b, c are collinear).
///
/// The sign is right for every finite input.
///
/// @param a,b,c,d m, any scale; coordinates must be finite
///
/// Source: the filter is `bounded_volume`, as in Shewchuk 1997.
inline int orient_3d(const Vector3<double>& a, const Vector3<double>& b, const Vector3<double>& c,
                     const Vector3<double>& d) {
  const int certain = bounded_volume(d - a, b - a, c - a).certain_sign();
  return certain != 0 ? certain : orient_3d_in_doubt(a, b, c, d);
}
// [/filter-3d]

/// Whether three points are exactly collinear (or two of them are equal).
inline bool are_collinear(const Vector3<double>& a, const Vector3<double>& b,
                          const Vector3<double>& c) {
  for (int k = 0; k < 3; ++k) {
    if (orient_2d(drop_dimension<double>(a, k), drop_dimension<double>(b, k),
                  drop_dimension<double>(c, k)) != 0) {
      return false;
    }
  }
  return true;
}

/// A coordinate that can be dropped so that the projection of the plane a, b, c stays injective,
/// and the orientation of the projected triangle; {0, 0} if the points are collinear.
struct FlatView {
  int dropped = 0;      ///< 0, 1 or 2
  int orientation = 0;  ///< +1 if a, b, c turn left in the projection, −1 if right
};
/// Finds that coordinate, exactly.
inline FlatView flat_view(const Vector3<double>& a, const Vector3<double>& b,
                          const Vector3<double>& c) {
  for (int k = 0; k < 3; ++k) {
    const int side = orient_2d(drop_dimension<double>(a, k), drop_dimension<double>(b, k),
                               drop_dimension<double>(c, k));
    if (side != 0) return {k, side};
  }
  return {};
}

}  // namespace contact
