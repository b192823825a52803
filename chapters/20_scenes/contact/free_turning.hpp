/// @file
/// How fast a body may come to spin that nothing pushes, and how finely such a turn is cut.
#pragma once

#include <algorithm>

#include <contact/vector.hpp>

namespace contact {

/// The largest angle that a body turns by between two looks at its spin: 2^-7 rad. A free body's
/// turn is then off by less than 2^-28/120 of itself: the fifth-order term of an exponential.
inline constexpr double gyroscopic_angle = 0x1p-7;

/// The square of the largest spin that a body comes to by itself, rad²/s². Its energy bounds that,
/// Σ I ω² ≤ 2 E; so do its energy and momentum together: with the moments I₁ ≤ I₂ ≤ I₃, what
/// 2 E I₃ − L² leaves for the axis of I₁, and 2 E for the others. A needle that turns across its
/// axis never comes to turn about it.
/// @param moments about its principal axes, kg·m²
/// @param spin along these axes, rad/s
inline double largest_free_square(const Vector3<double>& moments, const Vector3<double>& spin) {
  const Vector3<double> square = spin.cwiseProduct(spin);
  Vector3<double> sorted = moments;
  std::sort(sorted.data(), sorted.data() + 3);
  const double energy = moments.dot(square);  // twice
  const double by_energy = energy / sorted(0);
  const double apart = sorted(2) - sorted(0);
  if (!(apart > 0)) return by_energy;
  const Vector3<double> less = Vector3<double>::Constant(sorted(2)) - moments;
  const double left = moments.cwiseProduct(less).dot(square);
  return std::min(by_energy, left / (sorted(0) * apart) + energy / sorted(1));
}

}  // namespace contact
