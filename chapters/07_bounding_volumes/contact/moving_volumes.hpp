/// @file
/// Bounding volumes of moving bodies: over a displacement, in any orientation, and over a motion
/// that also turns.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <contact/aabb.hpp>
#include <contact/capsule.hpp>
#include <contact/carried_volumes.hpp>
#include <contact/error_free.hpp>
#include <contact/exact.hpp>
#include <contact/exact_outward.hpp>
#include <contact/frame.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/outward.hpp>
#include <contact/quaternion.hpp>
#include <contact/ray_kdop.hpp>
#include <contact/running_error.hpp>
#include <contact/shapes.hpp>
#include <contact/vector.hpp>

namespace contact {

// [swept-sphere]
/// A capsule that contains a sphere throughout a straight displacement.
///
/// The end of its core, centre + displacement, is rounded. The core moves by at most the length of
/// that error, which two_sum() gives exactly; the radius grows by the sum of its magnitudes.
/// @param sphere at the start, m, finite, with a radius that is not negative
/// @param displacement m, finite
/// @throws std::invalid_argument if an argument does not satisfy this, or the result overflows
template <FloatOrDouble S>
Capsule<S> swept(const Sphere<S>& sphere, const Vector3<S>& displacement) {
  detail::require_sphere(sphere);
  require_finite("displacement", displacement);
  Capsule<S> result{{sphere.centre, sphere.centre}, sphere.radius};
  for (int k = 0; k < 3; ++k) {
    const auto [end, error] = two_sum(S(sphere.centre[k]), S(displacement[k]));
    if (!std::isfinite(end) || !std::isfinite(error)) {
      throw_invalid_argument("displacement", vector_text(displacement), "its capsule overflows");
    }
    result.core.end[k] = end;
    result.radius = sum_up(result.radius, std::abs(error));
  }
  require_finite("radius", result.radius);
  return result;
}
// [/swept-sphere]

namespace detail {

/// The numbers low and high of a slab whose body moves by `along` times the length of its normal,
/// rounded outwards; infinite ones stay.
template <FloatOrDouble S>
std::array<S, 2> swept_slab(S low, S high, const Exact& along) {
  if (std::isnan(low) || std::isnan(high)) {
    throw_invalid_argument("dop", "nan", "must be a number");
  }
  if (along.sign() < 0 && std::isfinite(low)) low = downward<S>(Exact(double(low)) + along);
  if (along.sign() > 0 && std::isfinite(high)) high = upward<S>(Exact(double(high)) + along);
  return {low, high};
}

}  // namespace detail

// [swept-kdop]
/// The smallest k-DOP with these normals, of representable numbers, that contains a k-DOP
/// throughout a straight displacement: low + min(0, n · d) and high + max(0, n · d), computed
/// exactly and rounded outwards.
///
/// An offset beyond the largest number becomes infinite. A normal that is 0 keeps its slab. An
/// empty k-DOP (low > high) is extended like any other, and may become one that is not empty.
/// @param dop m; infinite bounds stay
/// @param displacement m, finite
/// @throws std::invalid_argument if a number is NaN, or the displacement or a normal is not finite
template <FloatOrDouble S>
Kdop<S> swept(const Kdop<S>& dop, const Vector3<S>& displacement) {
  require_finite("displacement", displacement);
  Kdop<S> result = dop;
  const auto d = detail::triple<Exact>(displacement.template cast<double>());
  for (std::size_t k = 0; k < dop.normals.size(); ++k) {
    require_finite("normals", dop.normals[k]);
    const auto n = detail::triple<Exact>(dop.normals[k].template cast<double>());
    const auto [low, high] = detail::swept_slab(dop.low[k], dop.high[k], detail::dot(n, d));
    result.low[k] = low;
    result.high[k] = high;
  }
  return result;
}
// [/swept-kdop]

// [any-orientation]
/// An axis-aligned box that contains a body in every orientation: that of the sphere about the
/// point that the body turns about.
/// @param centre the point that the body turns about, m, finite
/// @param bounding_radius at least the distance from it of each point of the body, m:
/// enclosing_radius()
/// @throws std::invalid_argument if the radius is negative, a number is not finite or overflows
template <FloatOrDouble S>
Aabb<S> aabb_in_any_orientation(const Vector3<S>& centre, S bounding_radius) {
  return aabb_of_sphere<S>({centre, bounding_radius});
}
// [/any-orientation]

/// An upper bound on r (1 − cos θ/2), the sagitta of an arc of radius r: how far a point that turns
/// by θ is from its chord. θ is the angle between two orientations, from 0 to π.
///
/// cos θ/2 is |a · b| / |a||b|. 1 − cos θ/2 would be off by u; sin² θ/2 / (1 + cos θ/2) is the same
/// and off by a few u sin θ/2, with sin² θ/2 from the six products aᵢ bⱼ − aⱼ bᵢ. The error bound
/// of each operation is added. No sine or cosine is called.
/// @param from, to of a length from 1e-70 to 1e70 (of floats any but 0); q and −q are one
/// orientation
/// @param bounding_radius r, m, not negative
/// @throws std::invalid_argument if a quaternion is 0, or so far beyond that range that a product
/// over- or underflows, the radius negative, a number not finite, or the bound overflows
template <FloatOrDouble S>
S sagitta(const Quaternion<S>& from, const Quaternion<S>& to, S bounding_radius) {
  require_finite("bounding_radius", bounding_radius);
  if (bounding_radius < S(0))
    throw_invalid_argument("bounding_radius", number_text(bounding_radius), "must not be negative");
  using E = RunningError;
  const auto four = [](const Quaternion<S>& q) {
    return std::array<E, 4>{E(double(q.w)), E(double(q.v.x())), E(double(q.v.y())),
                            E(double(q.v.z()))};
  };
  const std::array<E, 4> a = four(from), b = four(to);
  E inner, wedge, aa, bb;
  for (std::size_t i = 0; i < 4; ++i) {
    inner = inner + a[i] * b[i];
    aa = aa + a[i] * a[i];
    bb = bb + b[i] * b[i];
    for (std::size_t j = i + 1; j < 4; ++j) {
      const E x = a[i] * b[j] - a[j] * b[i];
      wedge = wedge + x * x;
    }
  }
  const E lengths = sqrt(aa * bb);
  const E cosine = inner.value < 0 ? -inner : inner;
  const E height = E(double(bounding_radius)) * wedge / (lengths * (lengths + cosine));
  const double bound = height.value + height.bound;
  if (!std::isfinite(bound)) {
    throw_invalid_argument("from", number_text(from.w), "must be an orientation, as must `to`");
  }
  return upward<S>(std::min(bound * (1 + 4 * E::u), static_cast<double>(bounding_radius)));
}

namespace detail {

/// How far stored axes may be from those of the rotation that they stand for: from the closest
/// rotation at most ε, the largest row sum of |AᵀA − I| (a singular value σ has |σ − 1| ≤ |σ² −
/// 1|), and 16 u of their type for the rounding of the rotation itself.
template <FloatOrDouble S>
double distance_from_rotation(const Matrix3<S>& axes) {
  return inverse_stretch(axes) - 1 + 16 * static_cast<double>(tolerance::unit_roundoff<S>);
}

}  // namespace detail

// [sagitta-of-axes]
/// The same from the axes of two frames: sin² θ/2 is ‖A − B‖² / 8 in the Frobenius norm, for
/// rotations. Stored axes are rounded rotations: the result includes how far they can be from the
/// rotations that they stand for, at both ends, some 100 u of the radius; near half a turn, where
/// the cosine comes from the root of a difference, it may exceed the sagitta by √u of the radius.
/// @return 0 if the axes are equal: then nothing turns; ∞ if the result overflows
/// @throws std::invalid_argument if axes are not nearly orthonormal, or the radius is negative or
/// not finite
template <FloatOrDouble S>
S sagitta(const Matrix3<S>& from, const Matrix3<S>& to, S bounding_radius) {
  require_finite("bounding_radius", bounding_radius);
  if (bounding_radius < S(0))
    throw_invalid_argument("bounding_radius", number_text(bounding_radius), "must not be negative");
  const double off_from = detail::distance_from_rotation(from);
  const double off_to = detail::distance_from_rotation(to);
  if (from == to) return S(0);
  const Matrix3<double> change = from.template cast<double>() - to.template cast<double>();
  const double length = std::sqrt(change.squaredNorm()) * (1 + 16 * detail::carry_u);
  const double apart = length + 1.8 * (off_from + off_to);
  const double sine_squared = std::min(1.0, apart * apart / 8 * (1 + 8 * detail::carry_u));
  const double height = sine_squared / (1 + std::sqrt(1 - sine_squared));
  const double all = (height + std::max(off_from, off_to)) * (1 + 16 * detail::carry_u);
  return upward<S>(static_cast<double>(bounding_radius) * all + detail::carry_floor);
}
// [/sagitta-of-axes]

// [aabb-of-motion]
/// An axis-aligned box that contains a body throughout a motion, from its boxes at both ends.
///
/// Hypotheses: the reference point of the body moves straight at constant velocity, while the body
/// turns about a fixed axis through it at a constant rate, by θ ≤ π; `margin` is at least the
/// sagitta r (1 − cos θ/2), where no point of the body is further than r from the reference point.
///
/// Proof that the margin suffices. Let h = θ/2, k = sin h / h, and φ from −h to h the angle turned
/// since the middle. A point on a unit circle is (cos φ, sin φ) and its chord at that time
/// (cos h, k φ). Half the derivative of their squared distance is −sin φ (k − cos h) −
/// k φ (cos φ − k), which is not above 0 for 0 ≤ φ ≤ h ≤ π/2, since sin φ / φ ≥ k ≥ cos h and
/// cos φ ≥ cos h. So the distance is greatest in the middle, 1 − cos h; and the chord is in the box
/// of both ends, which is convex.
/// @param start, end boxes of the body at both ends, m; that they are boxes (NaN, low > high) is
/// not checked
/// @param margin m, not negative: sagitta()
/// @throws std::invalid_argument if the margin is negative or not finite, or the box overflows
template <FloatOrDouble S>
Aabb<S> aabb_of_motion(const Aabb<S>& start, const Aabb<S>& end, S margin) {
  return aabb_of_swept_box<S>(enclosing_box(start, end), Vector3<S>::Zero(), margin);
}
// [/aabb-of-motion]

/// The same for a body in a box of its own frame, whose origin is the reference point, from one
/// frame to another, the shorter way around.
///
/// At both ends the body's rotation is one that the stored axes stand for: within 16 u of the
/// closest rotation. If both axes are equal, nothing turns, and what the box contains is the image
/// under the stored axes.
/// @param body m, in the body's frame
/// @param from, to with nearly orthonormal axes
/// @throws std::invalid_argument if an argument does not satisfy this, or a number overflows
template <FloatOrDouble S>
Aabb<S> aabb_of_motion(const Aabb<S>& body, const CoordinateFrame<S>& from,
                       const CoordinateFrame<S>& to) {
  const Aabb<S> start = aabb_of_carried(body, from), end = aabb_of_carried(body, to);
  const Vector3<double> furthest =
      body.low.cwiseAbs().cwiseMax(body.high.cwiseAbs()).template cast<double>();
  const S bounding_radius =
      upward<S>(furthest.stableNorm() * (1 + 8 * detail::carry_u) + detail::carry_floor);
  return aabb_of_motion(start, end, sagitta<S>(from.axes, to.axes, bounding_radius));
}

}  // namespace contact
