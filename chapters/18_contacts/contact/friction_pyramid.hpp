/// @file
/// The friction pyramid, which replaces Coulomb's cone by bounds on two tangents, and its errors.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>

#include <contact/shapes.hpp>
#include <contact/vector.hpp>

namespace contact {

/// The set to which the friction of a contact is limited.
enum class FrictionBound {
  cone,  ///< Coulomb's law: a disc of radius μ times the normal impulse, the same in all directions
  pyramid  ///< a square: each of two tangential components at most μ times the normal impulse
};

namespace detail {

/// √(x² + y²), also where the squares overflow or underflow; ∞ if it is too large itself.
template <std::floating_point S>
S disc_length(const S& x, const S& y) {
  const S square = x * x + y * y;
  const S low = std::numeric_limits<S>::min() / std::numeric_limits<S>::epsilon();
  if (square >= low && square <= std::numeric_limits<S>::max()) return std::sqrt(square);
  const S large = std::max(std::abs(x), std::abs(y));
  if (!(large > S(0)) || !std::isfinite(large)) return large;
  const S ratio = std::min(std::abs(x), std::abs(y)) / large;
  return large * std::sqrt(S(1) + ratio * ratio);
}

/// The direction of a vector other than 0, also of one whose length overflows or is subnormal.
template <std::floating_point S>
Vector2<S> direction_of(const Vector2<S>& v) {
  int power = 0;
  std::frexp(std::max(std::abs(v.x()), std::abs(v.y())), &power);
  const S x = std::ldexp(v.x(), -power), y = std::ldexp(v.y(), -power);
  const S length = disc_length<S>(x, y);
  return {x / length, y / length};
}

/// Whether a length has all its digits and has not overflowed.
template <std::floating_point S>
bool is_normal_length(const S& length) {
  return length >= std::numeric_limits<S>::min() && length <= std::numeric_limits<S>::max();
}

}  // namespace detail

// [friction-bound]
/// The friction nearest to a given one that the bound allows: scaled down to the disc, or each
/// component cut to the square. Up to rounding: it may be longer than `most` by a few u.
/// @param friction components along two perpendicular tangents, N·s
/// @param most μ times the normal impulse, N·s, not negative
template <std::floating_point S>
Vector2<S> bounded_friction(FrictionBound bound, const Vector2<S>& friction, const S& most) {
  if (bound == FrictionBound::pyramid)
    return {std::clamp(friction.x(), -most, most), std::clamp(friction.y(), -most, most)};
  const S length = detail::disc_length<S>(friction.x(), friction.y());
  if (!(length > most)) return friction;
  if (!detail::is_normal_length(length)) return detail::direction_of(friction) * most;
  const S share = most / length;
  return {friction.x() * share, friction.y() * share};
}
// [/friction-bound]

// [pyramid-friction]
/// The friction of a sliding contact: of all that the bound allows, the one that dissipates most.
///
/// On the disc it is opposite to the slip, of length `most`. On the square it is the corner
/// opposite to the slip, whichever direction in that quadrant the slip has, or the middle of an
/// edge if the slip is along a tangent.
/// @param slip along the two tangents, m/s; zeros give zeros
template <std::floating_point S>
Vector2<S> sliding_friction(FrictionBound bound, const Vector2<S>& slip, const S& most) {
  if (bound == FrictionBound::pyramid) {
    const auto against = [&](const S& s) { return s > S(0) ? -most : s < S(0) ? most : S(0); };
    return {against(slip.x()), against(slip.y())};
  }
  const S length = detail::disc_length<S>(slip.x(), slip.y());
  if (!(length > S(0))) return Vector2<S>::Zero();
  if (!detail::is_normal_length(length)) return detail::direction_of(slip) * -most;
  return {-(slip.x() / length) * most, -(slip.y() / length) * most};
}
// [/pyramid-friction]

// [pyramid-error]
/// How the pyramid's friction differs from the cone's for a direction of slip.
template <Ring S>
struct PyramidError {
  S magnitude = S(1);  ///< pyramid's friction over the cone's: 1 along a tangent, else √2
  S cosine = S(1);  ///< of the angle between them: from √½ (45°) to 1 (on a diagonal or a tangent)
};

/// The error of the pyramid, with |s| the length of the slip: its friction is ±(1, 1) μ N, so it is
/// √2 times too large unless the slip is along a tangent, and the cosine of its angle with the slip
/// is (|s₁| + |s₂|)/(√2 |s|). Next to a tangent the angle is almost 45°: the sideways component
/// pushes a sliding box off its line, until the slip is along the tangent. So the smallest error of
/// both is along the tangents, and a box stops after 1/√2 of the distance on a diagonal.
/// @param slip along the two tangents, not both 0
/// @return off by a few u
template <std::floating_point S>
PyramidError<S> pyramid_error(const Vector2<S>& slip) {
  const Vector2<S> square = sliding_friction<S>(FrictionBound::pyramid, slip, S(1));
  const Vector2<S> disc = sliding_friction<S>(FrictionBound::cone, slip, S(1));
  const S length = std::sqrt(square.dot(square));
  if (!(length > S(0))) return {};
  return {length, std::min(S(1), square.dot(disc) / length)};
}
// [/pyramid-error]

}  // namespace contact
