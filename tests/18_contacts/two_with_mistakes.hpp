/// @file
/// The impulses of two contacts with one mistake that people make: what the test of the exercise
/// recognises.
#pragma once

#include <algorithm>
#include <cmath>

#include "two_contacts.hpp"

namespace two_with_mistakes {

using Matrix = Eigen::Matrix2d;
using Vector = Eigen::Vector2d;

/// What is done wrong with the matrix.
enum class MatrixWay {
  no_rotation,    ///< 1/m everywhere
  not_coupled,    ///< the entries beside the diagonal are 0
  no_sign,        ///< the lever arms count by their lengths
  subtracted,     ///< the rotation is subtracted beside the diagonal
  own_arm_only,   ///< beside the diagonal the rotation is left out
  between,        ///< the distance between the contacts in place of the lever arms
  inertia_above,  ///< the product of the lever arms is multiplied by the inertia
  mass,           ///< the mass in place of its inverse
  inverted,       ///< 1 over each entry
};

inline Matrix inverse_effective_masses(double mass, double inertia, const Vector& lever_arms,
                                       MatrixWay way) {
  const double moved = way == MatrixWay::mass ? mass : 1 / mass;
  Matrix a;
  for (int i = 0; i < 2; ++i) {
    for (int k = 0; k < 2; ++k) {
      double turned = lever_arms(i) * lever_arms(k) / inertia;
      if (way == MatrixWay::no_rotation) turned = 0;
      if (way == MatrixWay::no_sign) turned = std::abs(turned);
      if (way == MatrixWay::inertia_above) turned = lever_arms(i) * lever_arms(k) * inertia;
      const bool beside = i != k;
      if (way == MatrixWay::subtracted && beside) turned = -turned;
      if (way == MatrixWay::own_arm_only && beside) turned = 0;
      const double apart = lever_arms(0) - lever_arms(1);
      if (way == MatrixWay::between && beside) turned = apart * apart / inertia;
      a(i, k) = way == MatrixWay::not_coupled && beside ? 0 : moved + turned;
      if (way == MatrixWay::inverted) a(i, k) = 1 / a(i, k);
    }
  }
  return a;
}

/// What is done wrong with the impulses.
enum class Way {
  alone,            ///< each contact as if it were the only one
  second_after,     ///< the first contact, then the second with what the first did
  first_after,      ///< the same from the second to the first
  shared,           ///< half of what each would get alone
  fastest,          ///< the contact that approaches faster, alone
  mean,             ///< both get the same, from the mean velocity
  pulls,            ///< a x = −b, whatever the signs
  cut,              ///< a x = −b, and negative impulses become 0
  separating_left,  ///< a contact with b ≥ 0 gets nothing
  not_verified,     ///< the first contact alone, whatever the second does
  coupling_sign,    ///< in the two equations a₁₂ has the wrong sign
  determinant_sum,  ///< a₁₁ a₂₂ + a₁₂²
  plus_b,           ///< a x = b
  multiplied,       ///< one contact alone: −a b
};

inline Vector both(const Matrix& a, const Vector& b, double determinant) {
  return {(a(0, 1) * b(1) - a(1, 1) * b(0)) / determinant,
          (a(1, 0) * b(0) - a(0, 0) * b(1)) / determinant};
}

/// The four cases, with one mistake in one of them.
inline Vector by_cases(const Matrix& a, const Vector& b, Way way) {
  if (b(0) >= 0 && b(1) >= 0) return {0, 0};
  const bool times = way == Way::multiplied;
  const double first = times ? -b(0) * a(0, 0) : -b(0) / a(0, 0);
  const double second = times ? -b(1) * a(1, 1) : -b(1) / a(1, 1);
  if (way == Way::separating_left && b(1) >= 0) return {first, 0};
  if (way == Way::separating_left && b(0) >= 0) return {0, second};
  const bool alone = -b(0) / a(0, 0) * a(1, 0) + b(1) >= 0 || way == Way::not_verified;
  if (first >= 0 && alone) return {first, 0};
  const bool other = -b(1) / a(1, 1) * a(0, 1) + b(0) >= 0 || way == Way::not_verified;
  if (second >= 0 && other) return {0, second};
  Matrix c = a;
  if (way == Way::coupling_sign) c(0, 1) = c(1, 0) = -a(0, 1);
  const double product = c(0, 1) * c(1, 0);
  const double sign = way == Way::determinant_sum ? 1 : -1;
  return both(c, b, c(0, 0) * c(1, 1) + sign * product);
}

inline Vector impulses(const Matrix& a, const Vector& b, Way way) {
  const auto push = [](double x) { return std::max(x, 0.0); };
  const Vector alone{push(-b(0) / a(0, 0)), push(-b(1) / a(1, 1))};
  const Vector solved = both(a, b, a(0, 0) * a(1, 1) - a(0, 1) * a(1, 0));
  switch (way) {
    case Way::alone:
      return alone;
    case Way::second_after:
      return {alone(0), push(-(b(1) + a(1, 0) * alone(0)) / a(1, 1))};
    case Way::first_after:
      return {push(-(b(0) + a(0, 1) * alone(1)) / a(0, 0)), alone(1)};
    case Way::shared:
      return alone / 2;
    case Way::fastest:
      return b(0) <= b(1) ? Vector(alone(0), 0) : Vector(0, alone(1));
    case Way::mean: {
      const double x = push(-(b(0) + b(1)) / a.sum());
      return {x, x};
    }
    case Way::pulls:
      return solved;
    case Way::cut:
      return {push(solved(0)), push(solved(1))};
    case Way::plus_b:
      return by_cases(a, -b, way);
    default:
      return by_cases(a, b, way);
  }
}

}  // namespace two_with_mistakes
