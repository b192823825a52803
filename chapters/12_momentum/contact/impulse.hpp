/// @file
/// Impulse: the area under a force–time curve, average force times time, and the change of velocity
/// that it causes.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <contact/exact.hpp>
#include <contact/impulse_sum.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/vector.hpp>

namespace contact {

/// A sampled force: piecewise linear between the samples, zero before the first and after the last.
/// Make it with force_curve(), which checks its arguments.
template <Ring S>
struct ForceCurve {
  std::vector<S> time;            ///< s, increasing, at least two
  std::vector<Vector3<S>> force;  ///< N, one for each time
};

/// A force–time curve from its samples.
/// @param time n times, s, each later than the one before
/// @param force n forces, N
/// @throws std::invalid_argument if there are fewer than two samples, not as many forces as times,
/// a time that is not later than the one before, or a number that is not finite
template <Ring S>
ForceCurve<S> force_curve(std::vector<S> time, std::vector<Vector3<S>> force) {
  if (time.size() < 2) {
    throw_invalid_argument("time", std::to_string(time.size()) + " samples",
                           "a curve needs at least two");
  }
  if (force.size() != time.size()) {
    throw_invalid_argument("force", std::to_string(force.size()) + " samples",
                           "there must be as many as there are times");
  }
  for (std::size_t i = 0; i < time.size(); ++i) {
    const std::string index = "[" + std::to_string(i) + "]";
    require_finite(("time" + index).c_str(), time[i]);
    require_finite(("force" + index).c_str(), force[i]);
    if (i > 0 && !(time[i] > time[i - 1])) {
      throw_invalid_argument("time" + index, number_text(time[i]),
                             "must be later than the one before");
    }
  }
  return {std::move(time), std::move(force)};
}

/// The velocity of a body after an impulse, v + J / m, for one coordinate.
/// @param mass kg, greater than 0
/// @param velocity before, m/s
/// @param impulse of all forces on the body, N·s
/// @return m/s; off by at most u of itself and u |J| / m
/// @see *Interaction and Normals*, slide "Impulse"
// [velocity-after]
template <Scalar S>
S velocity_after(const S& mass, const S& velocity, const S& impulse) {
  return velocity + impulse / mass;
}
// [/velocity-after]
/// The same for all three coordinates.
template <Scalar S>
Vector3<S> velocity_after(const S& mass, const Vector3<S>& velocity, const Vector3<S>& impulse) {
  return velocity + impulse / mass;
}

// [impulse-of-change]
/// The impulse that changes a velocity, m (v' − v): a difference of vectors, so a bounce straight
/// back needs more than a stop.
/// @param mass kg, greater than 0
/// @param before, after m/s
/// @return N·s; each entry off by at most 2 u of itself (if the difference does not overflow)
/// @see *Interaction and Normals*, slide "Impulse and Bouncing"
template <Ring S>
Vector3<S> impulse_of_change(const S& mass, const Vector3<S>& before, const Vector3<S>& after) {
  return (after - before) * mass;
}
// [/impulse-of-change]

namespace detail {

/// One coordinate of the impulse in rounded arithmetic: the sum of the trapezoids.
template <std::floating_point S>
S trapezoids(const ForceCurve<S>& curve, std::size_t pieces, int k) {
  std::vector<S> areas(pieces);
  for (std::size_t i = 0; i < pieces; ++i) {
    const S mean = S(0.5) * (curve.force[i](k) + curve.force[i + 1](k));
    areas[i] = (curve.time[i + 1] - curve.time[i]) * mean;
  }
  return compensated(areas.data(), areas.size());
}

/// Twice the same without rounding.
template <std::floating_point S>
Exact exact_trapezoids_twice(const ForceCurve<S>& curve, std::size_t pieces, int k) {
  static_assert(std::numeric_limits<S>::digits <= 53, "Exact holds floats and doubles");
  Exact sum;
  for (std::size_t i = 0; i < pieces; ++i) {
    const Exact width = Exact(double(curve.time[i + 1])) - Exact(double(curve.time[i]));
    sum += width * (Exact(double(curve.force[i](k))) + Exact(double(curve.force[i + 1](k))));
  }
  return sum;
}

template <Ring S>
std::size_t pieces_of(const ForceCurve<S>& curve) {
  assert(curve.time.size() >= 2 && curve.force.size() == curve.time.size());
  return curve.time.size() - 1;
}

}  // namespace detail

// [impulse]
/// The impulse of a force, ∫F dt: the area between the curve and the time axis, counted negative
/// where the force is.
///
/// Each linear piece makes a trapezoid, width times mean height, so the area under this curve is
/// exact except for rounding. For a force that is *not* linear between samples it is the
/// trapezoidal rule, with an error of at most T h² max|F″| / 12 for a step h and a duration T.
/// @param curve of a force_curve()
/// @return N·s. In a floating-point type the error of each entry is at most 5 u + γ(n − 1)² of the
/// sum of the absolute values of the n trapezoids, if nothing underflows and n u < 1/4; if a sum
/// overflows it is computed again without rounding
/// @see *Interaction and Normals*, slide "More About Impulse: F-t The Graph"
template <Scalar S>
Vector3<S> impulse(const ForceCurve<S>& curve) {
  const std::size_t pieces = detail::pieces_of(curve);
  Vector3<S> area = Vector3<S>::Zero();
  for (int k = 0; k < 3; ++k) {
    if constexpr (std::floating_point<S>) {
      area(k) = detail::trapezoids(curve, pieces, k);
      if (!std::isfinite(area(k))) {
        area(k) = quotient<S>(detail::exact_trapezoids_twice(curve, pieces, k), Exact(2.0));
      }
    } else {
      for (std::size_t i = 0; i < pieces; ++i) {
        area(k) = area(k) + (curve.time[i + 1] - curve.time[i]) *
                                (curve.force[i](k) + curve.force[i + 1](k)) / S(2);
      }
    }
  }
  return area;
}
// [/impulse]

// [impulse-exactly]
/// The same area, rounded once: right also if positive and negative areas cancel almost completely.
/// @return N·s; each entry the nearest number to the area under the stored curve
template <std::floating_point S>
Vector3<S> impulse_exactly(const ForceCurve<S>& curve) {
  const std::size_t pieces = detail::pieces_of(curve);
  Vector3<S> area = Vector3<S>::Zero();
  for (int k = 0; k < 3; ++k) {
    area(k) = quotient<S>(detail::exact_trapezoids_twice(curve, pieces, k), Exact(2.0));
  }
  return area;
}
// [/impulse-exactly]

// [average-force]
/// The constant force with the same impulse in the same time, ∫F dt / T. It is the mean over *time*
/// and not the mean of the samples, even if they are equally spaced: the first and the last sample
/// count half.
/// @return N; the error is at most 8 u + γ(n − 1)² of the sum of the absolute values of the n
/// trapezoids over the time, if nothing underflows and n u < 1/4. Finite for finite input
/// @see *Interaction and Normals*, slide "Impulse", the time-averaged force
template <Scalar S>
Vector3<S> average_force(const ForceCurve<S>& curve) {
  const S duration = curve.time.back() - curve.time.front();
  if constexpr (std::floating_point<S>) {
    const Vector3<S> mean = impulse(curve) / duration;
    if (all_finite(mean) && std::isfinite(duration)) return mean;
    const std::size_t pieces = detail::pieces_of(curve);
    const Exact twice =
        Exact(2.0) * (Exact(double(curve.time.back())) - Exact(double(curve.time.front())));
    Vector3<S> exact = Vector3<S>::Zero();
    for (int k = 0; k < 3; ++k) {
      exact(k) = quotient<S>(detail::exact_trapezoids_twice(curve, pieces, k), twice);
    }
    return exact;
  } else {
    return impulse(curve) / duration;
  }
}
// [/average-force]

// [impulse-until]
/// The impulse up to the time t: 0 before the curve begins, all of it once it has ended. Divided by
/// the mass it is the change of velocity so far.
/// @param curve of a force_curve(); its forces and times far from overflow
/// @param t s
/// @return N·s; errors as in impulse(), plus at most γ(6) (t − tᵢ)/2 (|Fᵢ| + |Fᵢ₊₁|) in each
/// coordinate for the force interpolated at t between the samples i and i + 1: three roundings in
/// its share, three more in the sum. This bound needs products that do not underflow.
template <std::floating_point S>
Vector3<S> impulse_until(const ForceCurve<S>& curve, const S& t) {
  if (!(t > curve.time.front())) return Vector3<S>::Zero();
  if (t >= curve.time.back()) return impulse(curve);
  ForceCurve<S> part;
  std::size_t i = 0;
  for (; curve.time[i] < t; ++i) {
    part.time.push_back(curve.time[i]);
    part.force.push_back(curve.force[i]);
  }
  const S share = (t - curve.time[i - 1]) / (curve.time[i] - curve.time[i - 1]);
  part.time.push_back(t);
  part.force.push_back((S(1) - share) * curve.force[i - 1] + share * curve.force[i]);
  return impulse(part);
}
// [/impulse-until]

}  // namespace contact
