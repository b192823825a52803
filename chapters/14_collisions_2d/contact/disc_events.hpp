/// @file
/// The time at which two moving discs touch, decided exactly and computed without cancellation.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <optional>

#include <contact/disc_collision.hpp>
#include <contact/exact.hpp>
#include <contact/tolerance.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace detail {

/// The three terms of the equation |d + w t| = R, for t > 0.
template <Ring T>
struct TouchTerms {
  T gap;       ///< d·d − R²: positive while they are apart
  T approach;  ///< −d·w: positive while they approach
  T depth;     ///< R² w·w − (d × w)²: negative if they miss each other
};

template <Ring T>
TouchTerms<T> touch_terms(const Vector2<T>& d, const Vector2<T>& w, const T& radius_sum) {
  const T cross = d.x() * w.y() - d.y() * w.x();
  return {d.x() * d.x() + d.y() * d.y() - radius_sum * radius_sum, -(d.x() * w.x() + d.y() * w.y()),
          radius_sum * radius_sum * (w.x() * w.x() + w.y() * w.y()) - cross * cross};
}

// [touch-filter]
/// The terms in rounded arithmetic, if each has enough digits: its magnitude is at least a
/// sixteenth of the sum of those of its own terms (a floating-point filter). Then gap is off by at
/// most 128 u of itself, approach by 64 u, and depth by 192 u.
template <std::floating_point S>
std::optional<TouchTerms<S>> sure_touch_terms(const Disc<S>& a, const Disc<S>& b) {
  const Vector2<S> d = a.centre - b.centre;
  const Vector2<S> w = a.velocity - b.velocity;
  const S radius_sum = a.radius + b.radius;
  const TouchTerms<S> t = touch_terms<S>(d, w, radius_sum);
  const S squares = d.x() * d.x() + d.y() * d.y() + radius_sum * radius_sum;
  const S products = std::abs(d.x() * w.x()) + std::abs(d.y() * w.y());
  const S crosses = std::abs(d.x() * w.y()) + std::abs(d.y() * w.x());
  const S radius_sum_squared = radius_sum * radius_sum;
  const S speed_squared = w.x() * w.x() + w.y() * w.y();
  const S fourth = radius_sum_squared * speed_squared + crosses * crosses;
  const S small =
      std::ldexp(S(1), std::numeric_limits<S>::min_exponent + 3 * std::numeric_limits<S>::digits);
  const auto sure = [small](const S& x, const S& size) {
    return std::isfinite(size) && size >= small && S(16) * std::abs(x) >= size;
  };
  // A square that underflows may be a factor of a product that does not.
  if (!(speed_squared >= small) || !(radius_sum_squared >= small || radius_sum == S(0)))
    return std::nullopt;
  if (sure(t.gap, squares) && sure(t.approach, products) && sure(t.depth, fourth)) return t;
  return std::nullopt;
}
// [/touch-filter]

}  // namespace detail

/// The time at which two discs on straight paths touch: the first t ≥ 0 at which the distance of
/// their centres is at most the sum of their radii, while they approach.
///
/// Discs that touch or overlap now give 0 if they approach, and nothing if they do not: discs that
/// have just collided do not collide again. Discs that graze, and touch at one moment only, do
/// touch.
/// @param a, b at time 0
/// @return s; nothing if they never touch, or later than the largest number. The decision is right
/// for every finite input; the time is off by at most 256 u of itself (if it does not underflow)
/// @see *Fundamentals of Computer Animation*, slides "How About 2 MOVING spheres?", which slice the
/// step instead
// [time-to-touch]
template <std::floating_point S>
std::optional<S> time_to_touch(const Disc<S>& a, const Disc<S>& b) {
  if (const auto t = detail::sure_touch_terms(a, b)) {
    if (!(t->approach > S(0))) return std::nullopt;
    if (!(t->gap > S(0))) return S(0);
    if (t->depth < S(0)) return std::nullopt;
    return t->gap / (t->approach + std::sqrt(t->depth));
  }
  // [/time-to-touch]
  const auto difference = [](const Vector2<S>& x, const Vector2<S>& y) {
    return Vector2<Exact>{Exact(double(x.x())) - Exact(double(y.x())),
                          Exact(double(x.y())) - Exact(double(y.y()))};
  };
  const auto t =
      detail::touch_terms<Exact>(difference(a.centre, b.centre), difference(a.velocity, b.velocity),
                                 Exact(double(a.radius)) + Exact(double(b.radius)));
  if (t.approach.sign() <= 0) return std::nullopt;
  if (t.gap.sign() <= 0) return S(0);
  if (t.depth.sign() < 0) return std::nullopt;
  // Divided by powers of a length and a speed of their own magnitude, all three are representable.
  const auto power = [](const Vector2<S>& x, const Vector2<S>& y) {
    const S half =
        std::max((x / S(2) - y / S(2)).cwiseAbs().maxCoeff(), std::numeric_limits<S>::min());
    return std::clamp(std::ilogb(half) + 1, std::numeric_limits<S>::min_exponent,
                      std::numeric_limits<S>::max_exponent - 1);
  };
  const int length = power(a.centre, b.centre);
  const int speed = power(a.velocity, b.velocity);
  const Exact metre(std::ldexp(1.0, length));
  const Exact metre_per_second(std::ldexp(1.0, speed));
  const S gap = quotient<S>(t.gap, metre * metre);
  const S approach = quotient<S>(t.approach, metre * metre_per_second);
  const S depth = quotient<S>(t.depth, metre * metre * metre_per_second * metre_per_second);
  const S time = std::ldexp(gap / (approach + std::sqrt(depth)), length - speed);
  if (!std::isfinite(time)) return std::nullopt;
  return time;
}

}  // namespace contact
