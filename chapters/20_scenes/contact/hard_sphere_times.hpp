/// @file
/// When a hard ball touches another or a wall: roots of polynomials, without cancellation and
/// without a case that has no answer.
///
/// A contact is a moment at which there is no gap and the gap does not open: what touches and parts
/// is no contact, what touches and closes is one now.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace contact {

/// A column of as many coordinates as a motion needs: one on a line, two in a plane, three.
template <int Dimension>
using Column = Eigen::Matrix<double, Dimension, 1>;

/// The time of what never happens, s.
inline constexpr double never = std::numeric_limits<double>::infinity();

/// When something is reached, and how fast it is approached then.
struct Arrival {
  double after = never;  ///< s, not negative
  double speed = 0;      ///< of approach, along the normal, m/s, not negative
};

namespace detail {

// What follows is written out, and not left to Eigen or to a loop, since it is asked for more often
// than anything else: at -O2 compilers call Eigen's functions for columns of three, and count to
// three.

/// x + v t.
template <int Dimension>
[[gnu::always_inline]] inline Column<Dimension> along(const Column<Dimension>& x,
                                                      const Column<Dimension>& v, double t) {
  Column<Dimension> to;
  to(0) = x(0) + v(0) * t;
  if constexpr (Dimension > 1) to(1) = x(1) + v(1) * t;
  if constexpr (Dimension > 2) to(2) = x(2) + v(2) * t;
  return to;
}

/// x + (v t + a s).
template <int Dimension>
[[gnu::always_inline]] inline Column<Dimension> along(const Column<Dimension>& x,
                                                      const Column<Dimension>& v, double t,
                                                      const Column<Dimension>& a, double s) {
  Column<Dimension> to;
  to(0) = x(0) + (v(0) * t + a(0) * s);
  if constexpr (Dimension > 1) to(1) = x(1) + (v(1) * t + a(1) * s);
  if constexpr (Dimension > 2) to(2) = x(2) + (v(2) * t + a(2) * s);
  return to;
}

/// The way from x to y.
template <int Dimension>
[[gnu::always_inline]] inline Column<Dimension> between(const Column<Dimension>& x,
                                                        const Column<Dimension>& y) {
  Column<Dimension> way;
  way(0) = y(0) - x(0);
  if constexpr (Dimension > 1) way(1) = y(1) - x(1);
  if constexpr (Dimension > 2) way(2) = y(2) - x(2);
  return way;
}

/// d · w, in the order in which Eigen adds.
template <int Dimension>
[[gnu::always_inline]] inline double dot(const Column<Dimension>& d, const Column<Dimension>& w) {
  if constexpr (Dimension == 1) return d(0) * w(0);
  if constexpr (Dimension == 2) return d(0) * w(0) + d(1) * w(1);
  if constexpr (Dimension == 3) return d(0) * w(0) + (d(1) * w(1) + d(2) * w(2));
}

/// |d × w|², in as many dimensions as there are: R² w² − |d × w|² is the discriminant of a meeting,
/// and no difference of two large squares of distances.
template <int Dimension>
[[gnu::always_inline]] inline double cross_squared(const Column<Dimension>& d,
                                                   const Column<Dimension>& w) {
  if constexpr (Dimension == 1) return 0;
  const double first = d(0) * w(1) - d(1) * w(0);
  if constexpr (Dimension == 2) return first * first;
  const double second = d(0) * w(2) - d(2) * w(0);
  const double third = d(1) * w(2) - d(2) * w(1);
  return first * first + second * second + third * third;
}

}  // namespace detail

// [meeting]
/// What decides whether two balls that move evenly as seen from each other touch, and when: a root
/// is taken only where they do. Under a common gravity they move so: it bends both paths alike.
struct Encounter {
  double approach = 0;  ///< d · w: below 0 while they come closer, m²/s
  double gap = 0;       ///< d² − R², m²
  double depth = 0;     ///< R² w² − |d × w|²: below 0 if they pass each other by, m⁴/s²

  /// Whether they touch, now or later. One question, mostly answered no, and not three that a
  /// processor cannot foresee.
  bool meets() const { return (approach < 0) & ((depth >= 0) | (gap <= 0)); }
  /// How long until they do, if they do: the first t ≥ 0 with |d + w t| = R, s.
  double after() const { return gap <= 0 ? 0 : gap / (std::sqrt(depth) - approach); }
};

/// @param d from one centre to the other, m
/// @param w relative velocity, the rate of d, m/s
/// @param reach R, the sum of the radii, m
template <int Dimension>
[[gnu::always_inline]] inline Encounter encounter(const Column<Dimension>& d,
                                                  const Column<Dimension>& w, double reach) {
  return {detail::dot<Dimension>(d, w), detail::dot<Dimension>(d, d) - reach * reach,
          reach * reach * detail::dot<Dimension>(w, w) - detail::cross_squared<Dimension>(d, w)};
}

/// How long until two balls touch.
/// @return s; 0 if they touch or overlap and approach; `never` if they part, or pass each other by.
/// Off by a few u of itself, times R² w² / (R² w² − |d × w|²) at most: close to grazing, rounding
/// decides whether they touch, and then the push is small too
/// @note Fourth powers of lengths and of √(length × speed) must neither overflow nor underflow:
/// sizes from 1e-70 to 1e70.
template <int Dimension>
double meeting(const Column<Dimension>& d, const Column<Dimension>& w, double reach) {
  const Encounter met = encounter<Dimension>(d, w, reach);
  return met.meets() ? met.after() : never;
}
// [/meeting]

// [wall]
/// When something with a gap to a plane arrives there, and how fast.
///
/// The speed is a root of the energy, √(v² + 2 p · gap), and never a velocity that was advanced in
/// time: so a ball that leaves a floor comes back exactly as fast, as often as it likes.
/// @param gap to the plane, m; below 0 is inside
/// @param velocity of the gap, m/s
/// @param acceleration of the gap, m/s²; below 0 pulls towards the plane
/// @return `never` if the plane is not reached. If it is touched or passed already: now if the gap
/// closes, else when it next begins to close while the plane is touched
inline Arrival arrival_at_plane(double gap, double velocity, double acceleration) {
  if (gap <= 0 && velocity < 0) return {0, -velocity};
  if (acceleration == 0) {
    if (!(velocity < 0)) return {};
    return {gap / -velocity, -velocity};
  }
  const double energy = velocity * velocity - 2 * acceleration * gap;
  if (acceleration > 0) {
    if (!(velocity < 0) || energy < 0) return {};
    const double speed = std::sqrt(energy);
    return {2 * gap / (speed - velocity), speed};
  }
  if (!(energy > 0))
    return {std::max(0.0, velocity / -acceleration), 0};  // still inside at the top
  const double speed = std::sqrt(energy);
  if (velocity < 0) return {2 * gap / (speed - velocity), speed};
  return {(speed + velocity) / -acceleration, speed};
}
// [/wall]

namespace detail {

/// A polynomial of the fourth degree, the constant first.
using Quartic = std::array<double, 5>;

inline double value_at(const Quartic& p, double t) {
  return (((p[4] * t + p[3]) * t + p[2]) * t + p[1]) * t + p[0];
}

inline Quartic derivative_of(const Quartic& p) { return {p[1], 2 * p[2], 3 * p[3], 4 * p[4], 0}; }

/// The last number of [low, high] on whose near side a monotone polynomial has the sign that it has
/// at low: halved until no number lies between.
inline double sign_change(const Quartic& p, double low, double high) {
  const bool positive = value_at(p, low) > 0;
  for (;;) {
    const double middle = low + (high - low) / 2;
    if (!(low < middle && middle < high)) return high;
    ((value_at(p, middle) > 0) == positive ? low : high) = middle;
  }
}

/// Ends of the pieces of [0, end] on which a polynomial is monotone: 0, its turns in order, end.
struct Pieces {
  std::array<double, 6> ends{};  ///< s
  std::size_t count = 0;         ///< how many of them
};

/// Between the turns of the derivative there is at most one root of it, so a polynomial's pieces
/// follow from those of its derivative; a constant has one piece.
inline Pieces monotone_pieces(const Quartic& p, double end, int degree) {
  Pieces pieces;
  pieces.ends[pieces.count++] = 0;
  if (degree > 1) {
    const Quartic slope = derivative_of(p);
    const Pieces of_slope = monotone_pieces(slope, end, degree - 1);
    for (std::size_t i = 0; i + 1 < of_slope.count; ++i) {
      const double low = of_slope.ends[i];
      const double high = of_slope.ends[i + 1];
      if ((value_at(slope, low) > 0) != (value_at(slope, high) > 0))
        pieces.ends[pieces.count++] = sign_change(slope, low, high);
    }
  }
  pieces.ends[pieces.count++] = end;
  return pieces;
}

}  // namespace detail

// [bent]
/// How long until two balls touch of which gravity bends one path only, as when the other lies on a
/// floor or never moves: the first t ≥ 0 at which f(t) = |d + w t + a t²/2|² − R² is not positive
/// and falls.
///
/// f is cut where it turns; on a falling piece its zero is found by halving, down to the last bit.
/// @param d from one centre to the other, m
/// @param w rate of d, m/s
/// @param a rate of w, m/s², not 0
/// @param reach R, the sum of the radii, m
/// @param parting whether the two have just pushed each other apart, so that they do not approach
/// now, whatever rounding says
/// @return s, or `never`
template <int Dimension>
double bent_meeting(const Column<Dimension>& d, const Column<Dimension>& w,
                    const Column<Dimension>& a, double reach, bool parting) {
  const double pull = a.norm();
  const double speed = w.norm();
  // From here on the bent path alone keeps them apart.
  const double end = 2 * (speed + std::sqrt(speed * speed + 2 * pull * (d.norm() + reach))) / pull;
  detail::Quartic f{d.dot(d) - reach * reach, 2 * d.dot(w), w.dot(w) + d.dot(a), w.dot(a),
                    a.dot(a) / 4};
  if (parting) f[1] = std::max(f[1], 0.0);
  const detail::Pieces pieces = detail::monotone_pieces(f, end, 4);
  for (std::size_t i = 0; i + 1 < pieces.count; ++i) {
    const double low = pieces.ends[i];
    const double high = pieces.ends[i + 1];
    const double at_low = detail::value_at(f, low);
    const double at_high = detail::value_at(f, high);
    if (!(at_high < at_low) || at_high > 0) continue;
    return at_low <= 0 ? low : detail::sign_change(f, low, high);
  }
  return never;
}
// [/bent]

}  // namespace contact
