/// @file
/// Bounds on the support of convex bodies that hold whatever rounds: with them a plane is proved to
/// separate two bodies.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <contact/gjk_cores.hpp>
#include <contact/outward.hpp>
#include <contact/support.hpp>
#include <contact/tolerance.hpp>
#include <contact/vector.hpp>
#include <limits>

namespace contact {

/// Two numbers with max n · x over a body between them.
struct SupportBounds {
  double down = 0;  ///< at most the support, m times |n|
  double up = 0;    ///< at least the support, m times |n|
};

namespace support_detail {

/// A computed sum and the sum of the magnitudes of its terms.
struct Terms {
  double value = 0;
  double size = 0;
};

/// n · p with its terms; each has at most 3 roundings.
inline Terms along(const Vector3<double>& n, const Vector3<double>& p) {
  const double x = n[0] * p[0], y = n[1] * p[1], z = n[2] * p[2];
  return {x + y + z, std::abs(x) + std::abs(y) + std::abs(z)};
}
inline Terms operator+(const Terms& x, const Terms& y) {
  return {x.value + y.value, x.size + y.size};
}

template <FloatOrDouble S>
Vector3<double> in_double(const Vector3<S>& v) {
  return v.template cast<double>();
}

// [support-terms]
/// What is added to the support for a ball: r |n|, for |n| from 2^-101 to 2^102. It has at most
/// four roundings.
inline Terms of_radius(double radius, const Vector3<double>& n) {
  const double term = std::abs(radius) * std::sqrt(detail::dot3(n, n));
  return {term, term};
}

/// |v| for a v of any size.
inline double length(const Vector3<double>& v) {
  const double squared = detail::dot3(v, v);
  if (squared > 0x1p-900 && squared < 0x1p1000) return std::sqrt(squared);
  const double scale = squared > 1 ? 0x1p-600 : 0x1p600;
  const Vector3<double> near_one(v[0] * scale, v[1] * scale, v[2] * scale);
  return std::sqrt(detail::dot3(near_one, near_one)) / scale;
}

/// The terms of the supports of the candidates of a core, one by one.
template <PolytopeCore Body, class See>
void for_each_support(const Body& body, const Vector3<double>& n, const See& see) {
  using S = ScalarOf<Body>;
  if constexpr (std::same_as<Body, OrientedBox<S>>) {
    Terms sum = along(n, in_double<S>(body.centre));
    for (int i = 0; i < 3; ++i) {
      const Terms axis = along(n, in_double<S>(body.axes.col(i)));
      const double half = std::abs(static_cast<double>(body.half_lengths(i)));
      sum = sum + Terms{half * std::abs(axis.value), half * axis.size};
    }
    see(sum);
  } else if constexpr (std::same_as<Body, Lozenge<S>>) {
    Terms sum = along(n, in_double<S>(body.corner));
    for (const Vector3<S>* edge : {&body.first_edge, &body.second_edge}) {
      const Terms term = along(n, in_double<S>(*edge));
      sum = sum + Terms{std::max(term.value, 0.0), term.size};
    }
    see(sum);
  } else {
    for (int i = 0; i < vertex_count(body); ++i) see(along(n, in_double<S>(vertex(body, i))));
  }
}
template <FloatOrDouble S, class See>
void for_each_support(const Ellipsoid<S>& body, const Vector3<double>& n, const See& see) {
  Vector3<double> image;
  double size = 0;
  for (int i = 0; i < 3; ++i) {
    const Terms axis = along(n, in_double<S>(body.axes.col(i)));
    const double half = std::abs(static_cast<double>(body.half_lengths(i)));
    image[i] = half * axis.value;
    size += half * axis.size;
  }
  see(along(n, in_double<S>(body.centre)) + Terms{length(image), size});
}
template <FloatOrDouble S, class See>
void for_each_support(const Cylinder<S>& body, const Vector3<double>& n, const See& see) {
  const Vector3<double> start = in_double<S>(body.core.start), end = in_double<S>(body.core.end);
  const double radius = std::abs(static_cast<double>(body.radius)), of_n = length(n);
  Vector3<double> core = end - start;
  const double most = core.cwiseAbs().maxCoeff();
  if (!(most > 0x1p-400 && most < 0x1p400)) core = core * (most > 1 ? 0x1p-600 : 0x1p600);
  const double sine = length(cross_plain(n, core)) / length(core);
  // A NaN, of a core that overflows or has no length, makes both bounds infinite.
  const Terms round{radius * sine, radius * of_n + (std::isnan(sine) ? sine : 0)};
  see(along(n, start) + round);
  see(along(n, end) + round);
}
// [/support-terms]

/// The sum of the magnitudes of all lengths of a body, by which an underflow may be multiplied.
template <ConvexBody Body>
double sum_of_lengths(const Body& body) {
  using S = ScalarOf<Body>;
  double sum = std::abs(static_cast<double>(radius_of(body)));
  if constexpr (requires { body.half_lengths; }) {
    sum += in_double<S>(body.half_lengths).cwiseAbs().sum();
  }
  if constexpr (std::same_as<Body, Cylinder<S>>) sum += std::abs(static_cast<double>(body.radius));
  return sum;
}

// [bounds-near-one]
/// The bounds for an n whose largest entry is from 2^-101 to 2^101.
///
/// No term has more than 16 roundings. A product of n and a position has three, with its sum four;
/// a term of a box has one more for each half length and three for sums. The length of an image or
/// of n has at most seven, since |x| + … bounds a root of squares. For a cylinder let e be the
/// core: the cross product n × e is off by at most γ(3) √2 |n||e|, as a vector, and |n × e|/|e| by
/// as much over |e| and by eight more roundings of at most |n|. So γ(24) of the magnitudes, which
/// are themselves rounded, is above the error. An underflow adds at most η/2 to a product, times an
/// entry of n or a length.
template <ConvexBody Body>
SupportBounds bounds_near_one(const Body& body, const Vector3<double>& n) {
  using Limits = std::numeric_limits<double>;
  const double underflow = 32 * tolerance::underflow_unit<double> * (1 + sum_of_lengths(body));
  Terms round;
  if constexpr (PolytopeCore<Body>) {
    round = of_radius(static_cast<double>(radius_of(body)), n);
  }
  SupportBounds bounds{-Limits::infinity(), -Limits::infinity()};
  for_each_support(body, n, [&](const Terms& core) {
    const Terms all = core + round;
    const double room = tolerance::gamma<double>(24) * all.size + underflow;
    const double down = all.value - room, up = all.value + room;
    bounds.down = std::max(bounds.down, down);
    // Written so that NaN and ∞ − ∞ become ∞.
    if (!(up <= bounds.up)) bounds.up = std::isfinite(up) ? up : Limits::infinity();
  });
  if (!(std::isfinite(bounds.down) && std::isfinite(bounds.up))) {
    return {-Limits::infinity(), Limits::infinity()};
  }
  return bounds;
}
// [/bounds-near-one]

/// x 2^power, rounded up.
inline double times_power_up(double x, int power) {
  const double product = std::ldexp(x, power);
  if (std::ldexp(product, -power) == x) return product;
  return std::nextafter(product, std::numeric_limits<double>::infinity());
}

}  // namespace support_detail

// [support-bounds]
/// A lower and an upper bound on max n · x over a whole body, its radius included, for the stored
/// numbers.
///
/// They are at most 2^-47 s + 2^-1067 (1 + l) apart, for an n near unit length, with s the sum of
/// the magnitudes of all terms, at most 3 |n| (|x| + l), and l that of half lengths and radius. The
/// direction need not be a unit vector.
/// @param n finite; for 0 both bounds are 0
/// @return −∞ and ∞ if a number is not finite, n · x may overflow, or a cylinder's core has no
/// length
template <ConvexBody Body>
SupportBounds support_bounds(const Body& body, const Vector3<double>& n) {
  using Limits = std::numeric_limits<double>;
  const double largest = std::max({std::abs(n[0]), std::abs(n[1]), std::abs(n[2])});
  if (largest > 0x1p-100 && largest < 0x1p100) return support_detail::bounds_near_one(body, n);
  if (!all_finite(n)) return {-Limits::infinity(), Limits::infinity()};
  if (largest == 0) return {};
  int power = 0;
  std::frexp(largest, &power);
  const Vector3<double> near_one(std::ldexp(n[0], -power), std::ldexp(n[1], -power),
                                 std::ldexp(n[2], -power));
  // An entry that has become subnormal is off by at most η/2, times a coordinate.
  const double room =
      8 * tolerance::underflow_unit<double> * static_cast<double>(gjk_detail::largest_number(body));
  const SupportBounds bounds = support_detail::bounds_near_one(body, near_one);
  return {-support_detail::times_power_up(sum_up(-bounds.down, room), power),
          support_detail::times_power_up(sum_up(bounds.up, room), power)};
}
// [/support-bounds]

/// At least max n · x over a body: the upper of support_bounds().
template <ConvexBody Body>
double support_up(const Body& body, const Vector3<double>& n) {
  return support_bounds(body, n).up;
}

/// At most max n · x over a body: the lower of support_bounds().
template <ConvexBody Body>
double support_down(const Body& body, const Vector3<double>& n) {
  return support_bounds(body, n).down;
}

}  // namespace contact
