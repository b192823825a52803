/// @file
/// A stack of bodies on contact springs: how far each contact sags, the natural frequencies, the
/// longest stable step, and steps of semi-implicit and of implicit Euler.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include <contact/invalid_argument.hpp>
#include <contact/momentum.hpp>
#include <contact/spring_damper.hpp>

namespace contact {

/// Bodies above each other, from the bottom up, with a spring below each: the first on the ground,
/// the others on the body below. Make it with spring_stack(), which checks its arguments.
template <Ring S>
struct SpringStack {
  std::vector<S> masses;     ///< kg, each greater than 0
  std::vector<S> stiffness;  ///< of the contact below each body, N/m, each greater than 0

  /// The number of bodies.
  std::size_t size() const { return masses.size(); }
};

/// A stack.
/// @param masses kg, each greater than 0, from the bottom up
/// @param stiffness of the contact below each body, N/m, each greater than 0
/// @throws std::invalid_argument if there is no body, the numbers of masses and springs differ, or
/// a number is out of its range or not finite
template <Ring S>
SpringStack<S> spring_stack(const std::vector<S>& masses, const std::vector<S>& stiffness) {
  if (masses.empty()) throw_invalid_argument("masses", "{}", "a stack needs at least one body");
  if (masses.size() != stiffness.size()) {
    throw_invalid_argument("stiffness", std::to_string(stiffness.size()) + " springs",
                           "must be as many as there are masses");
  }
  for (const S& mass : masses) require_mass("masses", mass);
  for (const S& k : stiffness) spring_damper(k, S(0));
  return {masses, stiffness};
}

/// Displacements and velocities of a stack's bodies, downwards, each from where no contact
/// overlaps.
template <Ring S>
struct StackState {
  std::vector<S> displacement;  ///< m
  std::vector<S> velocity;      ///< m/s
};

/// The state in which every contact just touches and nothing moves.
template <Ring S>
StackState<S> unloaded(const SpringStack<S>& stack) {
  return {std::vector<S>(stack.size(), S(0)), std::vector<S>(stack.size(), S(0))};
}

// [stack-sag]
/// The penetration of each contact of a stack at rest: the weight of all bodies above it, over its
/// stiffness. So with equal bodies and springs the lowest of n contacts sags n times as far as the
/// highest, and the top sinks by n (n + 1) / 2 times as much.
/// @param gravity m/s², 0 or more
/// @return m, from the bottom up; relative error at most (n + 2) u, without overflow and underflow
template <Scalar S>
std::vector<S> stack_sag(const SpringStack<S>& stack, const S& gravity) {
  std::vector<S> sag(stack.size(), S(0));
  S above(0);
  for (std::size_t i = stack.size(); i-- > 0;) {
    above = above + stack.masses[i];
    sag[i] = above * gravity / stack.stiffness[i];
  }
  return sag;
}

/// The stack at rest: the displacement of each body is the sum of the sags below it.
/// @param gravity m/s², 0 or more
/// @return relative error of each at most (2 n + 2) u, without overflow and underflow
template <Scalar S>
StackState<S> stack_at_rest(const SpringStack<S>& stack, const S& gravity) {
  StackState<S> state = unloaded(stack);
  state.displacement = stack_sag(stack, gravity);
  for (std::size_t i = 1; i < stack.size(); ++i) {
    state.displacement[i] = state.displacement[i] + state.displacement[i - 1];
  }
  return state;
}
// [/stack-sag]

// [frequencies-below]
/// How many natural frequencies ω of the stack, all springs attached, have ω² < `square`. Exact for
/// the stored numbers.
///
/// The ω² are the eigenvalues of K x = ω² M x, with K tridiagonal: k_i + k_(i+1) on the diagonal,
/// −k_(i+1) beside it. The leading minors of K − λ M are a Sturm sequence: their number of changes
/// of sign is the number of eigenvalues below λ. A minor of 0 gets the sign of the one before: the
/// next one has the opposite sign, so inside the sequence any sign would do, and at its end λ is an
/// eigenvalue itself and does not count.
/// @param square λ, 1/s², finite
template <Ring S>
std::size_t frequencies_below(const SpringStack<S>& stack, const S& square) {
  using T = decltype(detail::unrounded(square));
  const T zero(0);
  T before(0);
  T minor(1);
  T below(0);  // the spring below the body
  std::size_t changes = 0;
  bool positive = true;
  for (std::size_t i = 0; i < stack.size(); ++i) {
    const T k = detail::unrounded(stack.stiffness[i]);
    const T above = i + 1 < stack.size() ? detail::unrounded(stack.stiffness[i + 1]) : zero;
    const T diagonal = k + above - detail::unrounded(square) * detail::unrounded(stack.masses[i]);
    const T next = diagonal * minor - below * below * before;
    const bool sign = next == zero ? positive : next > zero;
    changes += sign != positive ? 1 : 0;
    positive = sign;
    before = minor;
    minor = next;
    below = above;
  }
  return changes;
}
// [/frequencies-below]

/// Two neighbouring numbers of the type with a square of a natural frequency between them.
template <std::floating_point S>
struct FrequencyBounds {
  S below = S(0);  ///< 1/s²; less than the square, or equal to it
  S above = S(0);  ///< 1/s²; greater than the square
};

// [frequency-bounds]
/// Bounds on the square of the j-th lowest natural frequency, by bisection with exact counts until
/// no number lies between.
///
/// All squares are at most twice the largest (k_i + k_(i+1)) / m_i: a sum of a row over its mass
/// bounds them (Gershgorin).
/// @param j 0 for the lowest, n − 1 for the highest
/// @return the square is in [below, above), and no number of the type lies between the two; a
/// number n times as long as the input decides each of some 60 steps, so keep n below 100. `below`
/// is 0 if the square is below the smallest positive number
/// @throws std::invalid_argument if there are not so many, or the bound above overflows
template <std::floating_point S>
FrequencyBounds<S> frequency_bounds(const SpringStack<S>& stack, std::size_t j) {
  if (j >= stack.size()) {
    throw_invalid_argument("j", std::to_string(j), "must be less than the number of bodies");
  }
  S high(0);
  for (std::size_t i = 0; i < stack.size(); ++i) {
    const S above = i + 1 < stack.size() ? stack.stiffness[i + 1] : S(0);
    const S row = (stack.stiffness[i] + above) / stack.masses[i];
    if (!(row <= high)) high = row;
  }
  // A row that underflows has lost its digits: then twice its exact value is below this.
  high = std::max(S(S(2.5) * high), std::numeric_limits<S>::min());
  if (!std::isfinite(high)) {
    throw_invalid_argument("stiffness", number_text(high), "a natural frequency overflows");
  }
  S low(0);
  for (;;) {
    // By powers of two while the two are far apart.
    S middle = low > S(0) && high <= S(4) * low ? S(low + (high - low) / S(2)) : S(high / S(4));
    if (!(middle > S(0))) middle = std::numeric_limits<S>::denorm_min();
    if (low > S(0) && middle <= low) middle = std::sqrt(low) * std::sqrt(high);
    if (!(middle > low && middle < high)) return {low, high};
    (frequencies_below(stack, middle) > j ? high : low) = middle;
  }
}
// [/frequency-bounds]

// [stack-step-limit]
/// A step below the stability limit 2 / ω of semi-implicit Euler for an undamped stack, ω the
/// highest natural frequency: each mode is a spring of its own, and the highest one needs the
/// shortest step.
///
/// A stack needs shorter steps than one of its bodies alone. With n equal bodies
/// ω = 2 √(k / m) cos(π / (2 n + 1)), so the limit tends to half of 2 √(m / k).
/// @return s, below the limit; by at most 8 u of itself if ω² is a normal number
/// @throws std::invalid_argument as frequency_bounds()
template <std::floating_point S>
S stack_step_limit(const SpringStack<S>& stack) {
  const S square = frequency_bounds(stack, stack.size() - 1).above;
  return S(2) / std::sqrt(square) * (S(1) - S(2) * std::numeric_limits<S>::epsilon());
}
// [/stack-step-limit]

namespace detail {

/// The acceleration that the springs give a body, downwards, m/s².
template <Scalar S>
S spring_acceleration(const SpringStack<S>& stack, const std::vector<S>& x, std::size_t i) {
  const S below = i > 0 ? S(x[i] - x[i - 1]) : x[i];
  S force = -(stack.stiffness[i] * below);
  if (i + 1 < stack.size()) force = force + stack.stiffness[i + 1] * (x[i + 1] - x[i]);
  return force / stack.masses[i];
}

}  // namespace detail

// [stack-step]
/// One step of semi-implicit Euler of a stack whose springs stay attached: velocities with the old
/// forces, displacements with the new velocities.
/// @param h s, greater than 0
/// @param gravity m/s²
template <Scalar S>
StackState<S> semi_implicit_stack_step(const SpringStack<S>& stack, const StackState<S>& now,
                                       const S& h, const S& gravity) {
  StackState<S> next = now;
  for (std::size_t i = 0; i < stack.size(); ++i) {
    const S a = gravity + detail::spring_acceleration(stack, now.displacement, i);
    next.velocity[i] = now.velocity[i] + h * a;
    next.displacement[i] = now.displacement[i] + h * next.velocity[i];
  }
  return next;
}
// [/stack-step]

// [implicit-stack-step]
/// One step of implicit Euler of a stack whose springs stay attached: the forces are those of the
/// new displacements. (M + h² K) v' = M (v + h g) − h K x, a tridiagonal system, solved from the
/// bottom up and back, in a time proportional to n.
///
/// The matrix has a positive diagonal, nothing positive beside it, and each diagonal entry exceeds
/// the sum of the others in its row by m_i at least: an M-matrix. The elimination needs no
/// difference: of the spring below a body its pivot keeps the part that the body below does not
/// follow. So where all bodies start down from an unloaded stack, velocities and displacements have
/// a relative error of at most 16 n u for every h, as long as nothing overflows or underflows, h² k
/// least of all.
///
/// Without rounding, the energy E of springs and motion about the stack at rest falls in every
/// step, for every h and every stack: E − E' is the energy of the differences,
/// ½ (v' − v)·M (v' − v) + ½ (x' − x)·K (x' − x).
/// @param h s, greater than 0
/// @param gravity m/s²
template <Scalar S>
StackState<S> implicit_stack_step(const SpringStack<S>& stack, const StackState<S>& now, const S& h,
                                  const S& gravity) {
  const std::size_t n = stack.size();
  StackState<S> next = now;
  std::vector<S> follows(n, S(0));  // the part of the velocity above that a body takes
  std::vector<S>& v = next.velocity;
  S below = h * h * stack.stiffness[0];
  S held = below;
  for (std::size_t i = 0; i < n; ++i) {
    const S a = gravity + detail::spring_acceleration(stack, now.displacement, i);
    const S above = i + 1 < n ? S(h * h * stack.stiffness[i + 1]) : S(0);
    const S pivot = stack.masses[i] + held + above;
    const S carried = stack.masses[i] * (now.velocity[i] + h * a);
    v[i] = (i > 0 ? S(carried + below * v[i - 1]) : carried) / pivot;
    follows[i] = above / pivot;
    held = above * ((stack.masses[i] + held) / pivot);
    below = above;
  }
  for (std::size_t i = n; i-- > 0;) {
    if (i + 1 < n) v[i] = v[i] + follows[i] * v[i + 1];
    next.displacement[i] = now.displacement[i] + h * v[i];
  }
  return next;
}
// [/implicit-stack-step]

// [stack-energy]
/// The energy of a stack's springs and motion, without its weight: Σ m v² / 2 + Σ k d² / 2.
/// @return J; every term is 0 or more
template <Scalar S>
S stack_energy(const SpringStack<S>& stack, const StackState<S>& state) {
  S twice(0);
  for (std::size_t i = 0; i < stack.size(); ++i) {
    const S d =
        i > 0 ? S(state.displacement[i] - state.displacement[i - 1]) : state.displacement[i];
    twice = twice + stack.masses[i] * state.velocity[i] * state.velocity[i] +
            stack.stiffness[i] * d * d;
  }
  return twice / S(2);
}
// [/stack-energy]

}  // namespace contact
