/// @file
/// Orientation predicates: the orientation of three points in the plane and of four points in
/// space, with the right sign for every finite input.
#pragma once

#include <array>
#include <cmath>
#include <contact/drop_dimension.hpp>
#include <contact/error_free.hpp>
#include <contact/exact.hpp>
#include <contact/filter.hpp>
#include <contact/vector.hpp>
#include <cstddef>
#include <limits>

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

/// −1, 0 or +1.
inline int sign_of(double x) { return x > 0 ? 1 : (x < 0 ? -1 : 0); }

/// A floating-point expansion: a sum of doubles that do not overlap, in increasing order and
/// without zeros. Its sign is that of the last one.
template <std::size_t Capacity>
struct Expansion {
  std::array<double, Capacity> component{};  ///< the doubles
  std::size_t size = 0;                      ///< how many there are

  /// Appends one that is larger than all there are, unless it is zero.
  void push(double x) {
    if (x != 0) component[size++] = x;
  }
  /// −1, 0 or +1.
  int sign() const { return size == 0 ? 0 : sign_of(component[size - 1]); }
};

/// Adds one number (Shewchuk's GROW-EXPANSION, with the zeros left out).
template <std::size_t Capacity>
void grow(Expansion<Capacity>& e, double x) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < e.size; ++i) {
    const WithError<double> sum = two_sum(x, e.component[i]);
    x = sum.value;
    if (sum.error != 0) e.component[kept++] = sum.error;
  }
  e.size = kept;
  e.push(x);
}

/// Whether x − y has no rounding error, and its value.
inline bool exact_difference(double x, double y, double& difference) {
  const WithError<double> sum = two_sum(x, -y);
  difference = sum.value;
  return sum.error == 0;
}

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
  return certain != 0 ? certain : orient_2d_exactly(a, b, c);
}
// [/filter-2d]

/// Decides what the filter could not: on which side of the plane a, b, c the point d is.
///
/// If the nine differences have no rounding error (whole numbers, floats of similar size), the
/// determinant is summed as a floating-point expansion: two_product makes each product of two
/// numbers an exact pair, and each product of three at most four components, so there are at most
/// 24. Otherwise, or at extreme scales, the exact type decides.
inline int orient_3d_in_doubt(const Vector3<double>& a, const Vector3<double>& b,
                              const Vector3<double>& c, const Vector3<double>& d) {
  using namespace orientation_detail;
  Vector3<double> p(0, 0, 0), q(0, 0, 0), r(0, 0, 0);
  bool plain = true;
  for (int i = 0; i < 3; ++i) {
    plain = plain && exact_difference(d[i], a[i], p[i]) && exact_difference(b[i], a[i], q[i]) &&
            exact_difference(c[i], a[i], r[i]) && moderate(p[i]) && moderate(q[i]) &&
            moderate(r[i]);
  }
  if (!plain) return orient_3d_exactly(a, b, c, d);
  Expansion<24> sum;
  const auto add = [&sum](double x, double y, double z) {
    const WithError<double> yz = two_product(y, z);
    for (const double component : {yz.error, yz.value}) {
      const WithError<double> product = two_product(x, component);
      grow(sum, product.error);
      grow(sum, product.value);
    }
  };
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    add(p[i], q[j], r[k]);
    add(-p[i], q[k], r[j]);
  }
  return sum.sign();
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
/// Source: the filter is `bounded_volume`; Shewchuk 1997 for expansions.
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
