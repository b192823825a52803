#include "damping_for_restitution.hpp"

namespace exercise {

namespace {

double arc_over_sine(double ratio) {
  if (ratio < 1) return std::acos(ratio) / std::sqrt((1 - ratio) * (1 + ratio));
  if (ratio > 1) return std::acosh(ratio) / std::sqrt((ratio - 1) * (ratio + 1));
  return 1;
}

}  // namespace

double damping_to_zero_penetration(double restitution, double stiffness, double mass) {
  //? NaN is not from 0 to 1 either.
  //? gap: restitution >= 0 && restitution <= 1
  if (!(restitution >= 0 && restitution <= 1)) {
    throw std::invalid_argument("the restitution must be from 0 to 1");
  }
  //? Let L be −ln e.
  //? gap: -std::log(restitution)
  const double exponent = -std::log(restitution);
  //? π ζ = L √(1 − ζ²) is squared and solved for ζ. For 0 critical damping is the smallest.
  //? gap: restitution > 0
  //? gap: std::hypot(std::numbers::pi, exponent)
  const double ratio = restitution > 0 ? exponent / std::hypot(std::numbers::pi, exponent) : 1;
  //? From the ratio to the damping.
  //? gap: 2 * ratio * std::sqrt(stiffness * mass)
  return 2 * ratio * std::sqrt(stiffness * mass);
}

double damping_to_zero_force(double restitution, double stiffness, double mass) {
  //? However strong the damper is, the spring pushes the body out again: 0 is never reached.
  //? gap: restitution > 0 && restitution <= 1
  if (!(restitution > 0 && restitution <= 1)) {
    throw std::invalid_argument("the restitution must be greater than 0 and at most 1");
  }
  //? The function whose zero is sought grows with the ratio.
  //? gap: 2 * ratio * arc_over_sine(ratio)
  const double exponent = -std::log(restitution);
  const auto too_small = [&](double ratio) { return 2 * ratio * arc_over_sine(ratio) < exponent; };
  //? The ratio may be larger than 1, so the upper end is found first.
  //? gap: too_small(high)
  double low = 0;
  double high = 1;
  while (too_small(high)) high *= 2;
  //? Keep the half in which the ratio is, until no number is between the ends.
  //? gap: middle = (low + high) / 2
  //? gap: too_small(middle)
  for (double middle = high / 2; low < middle && middle < high; middle = (low + high) / 2) {
    (too_small(middle) ? low : high) = middle;
  }
  //? From the ratio to the damping.
  //? gap: 2 * high * std::sqrt(stiffness * mass)
  return 2 * high * std::sqrt(stiffness * mass);
}

}  // namespace exercise
