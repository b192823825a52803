/// @file
/// How a figure draws a ball that overlaps a surface: squashed. A drawing only: a penalty force
/// knows a penetration and no shape.
#pragma once

#include <cmath>
#include <concepts>

#include <contact/invalid_argument.hpp>
#include <contact/vector.hpp>

namespace contact {

/// What a squash keeps.
enum class SquashKeeps {
  area,   ///< of a disc in the plane
  volume  ///< of a ball in space
};

/// The half axes of a squashed disc or ball.
template <std::floating_point S>
struct Squash {
  S along = S(1);     ///< along the normal of the contact, m
  S across = S(1);    ///< perpendicular to it, m
  bool held = false;  ///< the drawing stops at the flattest shape, though the ball overlaps more
};

// [squash]
/// The half axes with which a ball of radius r is drawn that overlaps a surface by d. It keeps its
/// centre and, unless `held`, touches the surface: r − d along the normal. Across, r² / (r − d)
/// keeps the area of the disc, and √(r³ / (r − d)) the volume of the ball.
///
/// The picture suggests a deformation that the model does not compute. Between two balls each is
/// drawn with its own part of the penetration, such as half.
/// @param radius r, m, greater than 0
/// @param penetration d, m; a gap, or a number that is not finite, leaves the ball round
/// @param flattest the least r − d that is drawn, as a fraction of r, greater than 0, at most 1: no
/// shape is flatter, whatever the penetration
/// @return m; each axis with a relative error of at most 6 u plus that of r − d, which is rounded
/// once; ∞ if the axis overflows; without underflow of r flattest
/// @throws std::invalid_argument if radius or flattest is out of its range or not finite
template <std::floating_point S>
Squash<S> squash(const S& radius, const S& penetration, SquashKeeps keeps,
                 const S& flattest = S(0.25)) {
  require_finite("radius", radius);
  require_finite("flattest", flattest);
  if (!(radius > S(0))) throw_invalid_argument("radius", number_text(radius), "must be above 0");
  if (!(flattest > S(0)) || flattest > S(1)) {
    throw_invalid_argument("flattest", number_text(flattest), "must be above 0 and at most 1");
  }
  if (!(penetration > S(0)) || !std::isfinite(penetration)) return {radius, radius, false};
  const S ratio = (radius - penetration) / radius;
  const bool held = ratio < flattest;
  const S part = held ? flattest : ratio;
  const S across = keeps == SquashKeeps::area ? S(radius / part) : S(radius / std::sqrt(part));
  return {held ? S(radius * flattest) : S(radius - penetration), across, held};
}
// [/squash]

}  // namespace contact
