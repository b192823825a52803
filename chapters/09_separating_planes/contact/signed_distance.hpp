/// @file
/// The signed distance of two convex bodies of any kinds, its direction and the points that attain
/// it.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <type_traits>

#include <contact/bounded_differences.hpp>
#include <contact/gjk.hpp>
#include <contact/gjk_cores.hpp>
#include <contact/penetration.hpp>
#include <contact/signed_distance_boxes.hpp>
#include <contact/signed_distance_capsules.hpp>
#include <contact/signed_distance_cylinder.hpp>
#include <contact/signed_distance_half_space.hpp>
#include <contact/signed_distance_result.hpp>
#include <contact/support.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace detail {

/// The position of a kind of body in the order in which closed forms take two bodies.
template <ConvexBody Body>
consteval int kind_rank() {
  using S = ScalarOf<Body>;
  if (std::same_as<Body, Sphere<S>>) return 0;
  if (std::same_as<Body, Capsule<S>>) return 1;
  if (std::same_as<Body, OrientedBox<S>>) return 2;
  if (std::same_as<Body, Triangle<S>>) return 3;
  if (std::same_as<Body, Lozenge<S>>) return 4;
  if (std::same_as<Body, ConvexHull<S>>) return 5;
  if (std::same_as<Body, Cylinder<S>>) return 6;
  return 7;
}

/// The sum of the extents of a body, or of its core, along the three axes of the world, m.
template <ConvexBody Body>
ScalarOf<Body> extent_of(const Body& body) {
  using S = ScalarOf<Body>;
  S sum(0);
  for (int i = 0; i < 3; ++i) {
    const Vector3<S> n = Vector3<S>::Unit(i);
    sum += support(body, n)(i) - support(body, Vector3<S>(-n))(i);
  }
  return sum;
}

/// Whether bounds prove that two cores meet, by the tetrahedron of GJK: then core_direction() would
/// find the direction 0.
template <PolytopeCore A, PolytopeCore B>
bool certainly_meet(const GjkResult<ScalarOf<A>>& near, const A& a, const B& b) {
  if constexpr (std::same_as<ScalarOf<A>, double>) {
    if (near.count != 4) return false;
    BoundedDifferences differences(offset_size(a) + offset_size(b));
    for (const GjkVertex<double>& v : near.simplex) {
      differences.add(vertex_from_position(a, v.a), vertex_from_position(b, v.b));
    }
    return differences.certainly_surround();
  } else {
    return false;
  }
}

// [general-distance]
/// The signed distance of two bodies of any kinds: by GJK if their cores are apart, by EPA if they
/// meet. Cores of polytopes that almost meet are decided and measured exactly, unless bounds prove
/// that GJK's tetrahedron has the origin inside. Smooth bodies that almost meet are left to EPA,
/// too: GJK's difference of two points is then too short for a direction.
/// @param size at least the largest coordinate of both, m
template <ConvexBody A, ConvexBody B>
SignedDistance<ScalarOf<A>> general_distance(const A& a, const B& b, const ScalarOf<A>& size) {
  using S = ScalarOf<A>;
  const GjkResult<S> near = gjk(a, b);
  const auto along = [&](const S& distance, const Vector3<S>& normal) {
    return signed_distance_of_cores<S>(near.on_a, radius_of(a), near.on_b, radius_of(b), distance,
                                       normal);
  };
  if constexpr (PolytopeCore<A> && PolytopeCore<B>) {
    if (!is_near(near.distance, size)) return along(near.distance, normalised<S>(near.between));
    if (!certainly_meet(near, a, b)) {
      const CoreDirection<S> exact = core_direction(a, b);
      if (exact.normal != Vector3<S>::Zero()) return along(exact.distance, exact.normal);
    }
  } else {
    constexpr S root = std::same_as<S, double> ? S(0x1p-33) : S(0x1p-14);
    if (near.distance > root * (extent_of(a) + extent_of(b))) {
      return along(near.distance, normalised<S>(near.between));
    }
  }
  const Penetration<S> deep = penetration(a, b);
  return signed_distance_of_cores<S>(deep.on_a, radius_of(a), deep.on_b, radius_of(b), -deep.depth,
                                     deep.normal);
}
// [/general-distance]

/// The signed distance by the closed form if there is one, else in general.
template <ConvexBody A, ConvexBody B>
SignedDistance<ScalarOf<A>> distance_of(const A& a, const B& b, const ScalarOf<A>& size) {
  if constexpr (requires { closed_distance(a, b); }) {
    return closed_distance(a, b);
  } else {
    return general_distance(a, b, size);
  }
}

/// The same with the bodies in an order that depends on them alone.
template <ConvexBody A, ConvexBody B>
SignedDistance<ScalarOf<A>> ordered_distance(const A& a, const B& b, const ScalarOf<A>& size) {
  if constexpr (std::same_as<A, B>) {
    return precedes(b, a) ? exchanged(distance_of(b, a, size)) : distance_of(a, b, size);
  } else if constexpr (kind_rank<A>() < kind_rank<B>()) {
    return distance_of(a, b, size);
  } else {
    return exchanged(distance_of(b, a, size));
  }
}

}  // namespace detail

// [signed-distance-of-bodies]
/// The signed distance of two convex bodies of any kinds.
///
/// Exchanging the bodies gives exactly the opposite normal and exchanged points, because the order
/// of the computation depends on the bodies alone, unless all their numbers are equal: then nothing
/// tells which of the two the normal should lead to. No number of the answer is −0.
/// @param a, b of any size: bodies that are very large or small are multiplied by a power of two
/// @return error of the distance: a few u of the coordinates, radii included, if no body is smooth;
/// for a cylinder or an ellipsoid that is apart from the other body 2^-40 of them (float: 2^-20).
/// These are measured, not proved. Not bounded are: normal and points of bodies that are thin
/// (1:10⁶) or of very different sizes (10⁸:1), and all of a smooth body that overlaps the other or
/// almost touches it. There the points have differed from distance · normal by a thousandth of the
/// size, and the depth was not always the least. If a number is not finite, the distance is NaN and
/// all vectors are 0
template <ConvexBody A, ConvexBody B>
requires std::same_as<ScalarOf<A>, ScalarOf<B>> SignedDistance<ScalarOf<A>> signed_distance(
    const A& a, const B& b) {
  using S = ScalarOf<A>;
  const S of_a = gjk_detail::largest_number(a), of_b = gjk_detail::largest_number(b);
  if (!std::isfinite(of_a) || !std::isfinite(of_b)) {
    SignedDistance<S> nothing;
    nothing.distance = std::numeric_limits<S>::quiet_NaN();
    return nothing;
  }
  const S size = std::max(of_a, of_b);
  const int power = detail::scale_power(size);
  if (power == 0) return detail::without_negative_zero(detail::ordered_distance(a, b, size));
  SignedDistance<S> found = detail::ordered_distance(
      gjk_detail::times_power_of_two(a, -power), gjk_detail::times_power_of_two(b, -power), S(1));
  found.distance = std::ldexp(found.distance, power);
  found.on_a = detail::times_power_of_two(found.on_a, power);
  found.on_b = detail::times_power_of_two(found.on_b, power);
  return detail::without_negative_zero(found);
}
// [/signed-distance-of-bodies]

}  // namespace contact
