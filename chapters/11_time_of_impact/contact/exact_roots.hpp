/// @file
/// Polynomials with exact coefficients: their roots from 0 to 1, and the sign of another polynomial
/// at a root, without rounding.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include <contact/exact.hpp>

namespace contact {

// [exact-polynomial]
/// A polynomial with exact coefficients.
struct ExactPolynomial {
  std::vector<Exact> coefficients;  ///< that of tᵏ at k; the last one is not 0; empty for 0

  ExactPolynomial() = default;
  /// A constant.
  ExactPolynomial(const Exact& constant) {
    if (constant.sign() != 0) coefficients.push_back(constant);
  }
  /// The polynomial that is `at_0` at t = 0 and `at_1` at t = 1, of degree 1 at most.
  static ExactPolynomial between(const Exact& at_0, const Exact& at_1) {
    ExactPolynomial line;
    line.coefficients = {at_0, at_1 - at_0};
    line.strip();
    return line;
  }

  /// Whether it is 0 for all t.
  bool is_zero() const { return coefficients.empty(); }
  /// −1 for the polynomial 0.
  int degree() const { return static_cast<int>(coefficients.size()) - 1; }
  /// The value at t, by Horner's rule.
  Exact at(const Exact& t) const {
    Exact value;
    for (std::size_t k = coefficients.size(); k-- > 0;) value = value * t + coefficients[k];
    return value;
  }

  friend ExactPolynomial operator+(const ExactPolynomial& p, const ExactPolynomial& q) {
    ExactPolynomial sum = p;
    sum.coefficients.resize(std::max(p.coefficients.size(), q.coefficients.size()));
    for (std::size_t k = 0; k < q.coefficients.size(); ++k)
      sum.coefficients[k] += q.coefficients[k];
    sum.strip();
    return sum;
  }
  friend ExactPolynomial operator-(const ExactPolynomial& p) { return p * ExactPolynomial(-1.0); }
  friend ExactPolynomial operator-(const ExactPolynomial& p, const ExactPolynomial& q) {
    return p + -q;
  }
  friend ExactPolynomial operator*(const ExactPolynomial& p, const ExactPolynomial& q) {
    ExactPolynomial product;
    if (p.is_zero() || q.is_zero()) return product;
    product.coefficients.resize(p.coefficients.size() + q.coefficients.size() - 1);
    for (std::size_t i = 0; i < p.coefficients.size(); ++i) {
      for (std::size_t k = 0; k < q.coefficients.size(); ++k) {
        product.coefficients[i + k] += p.coefficients[i] * q.coefficients[k];
      }
    }
    return product;
  }

  /// Removes coefficients 0 of the highest powers.
  void strip() {
    while (!coefficients.empty() && coefficients.back().sign() == 0) coefficients.pop_back();
  }
};
// [/exact-polynomial]

/// The derivative.
inline ExactPolynomial derivative(const ExactPolynomial& p) {
  ExactPolynomial result;
  for (int k = 1; k <= p.degree(); ++k) {
    result.coefficients.push_back(p.coefficients[static_cast<std::size_t>(k)] * Exact(k));
  }
  return result;
}

namespace detail {

/// The remainder of p divided by q, and the quotient, both times the same positive number: so no
/// division is needed, and no sign changes.
/// @param q not 0
inline std::pair<ExactPolynomial, ExactPolynomial> divided(ExactPolynomial p,
                                                           const ExactPolynomial& q) {
  ExactPolynomial quotient;
  const Exact leading = q.coefficients.back();
  const ExactPolynomial factor(abs(leading));
  while (p.degree() >= q.degree()) {
    ExactPolynomial term;
    term.coefficients.resize(static_cast<std::size_t>(p.degree() - q.degree()) + 1);
    const Exact top = p.coefficients.back();
    term.coefficients.back() = leading.sign() > 0 ? top : -top;
    quotient = quotient * factor + term;
    p = p * factor - term * q;
  }
  return {quotient, p};
}

/// The remainders of p and q as Euclid's algorithm gives them, each with its sign reversed: Sturm's
/// sequence if q is the derivative of p. The last is their greatest common divisor.
inline std::vector<ExactPolynomial> signed_remainders(const ExactPolynomial& p,
                                                      const ExactPolynomial& q) {
  std::vector<ExactPolynomial> sequence{p};
  if (!q.is_zero()) sequence.push_back(q);
  while (sequence.size() > 1) {
    const ExactPolynomial rest = divided(sequence[sequence.size() - 2], sequence.back()).second;
    if (rest.is_zero()) break;
    sequence.push_back(-rest);
  }
  return sequence;
}

/// How often the sign changes along the sequence at t; values of 0 do not count.
inline int sign_changes(const std::vector<ExactPolynomial>& sequence, const Exact& t) {
  int changes = 0, last = 0;
  for (const ExactPolynomial& p : sequence) {
    const int sign = p.at(t).sign();
    if (sign == 0) continue;
    if (last != 0 && sign != last) ++changes;
    last = sign;
  }
  return changes;
}

}  // namespace detail

// [exact-root]
/// A root of a polynomial: the only one from `low` to `high`. Both are equal if the root is
/// rational with a power of two as denominator and was met; otherwise neither is a root.
struct ExactRoot {
  Exact low;   ///< lower bound of the root, or the root
  Exact high;  ///< upper bound of the root, or the root
};

/// The sign of q at a root of p.
///
/// If the value of q at `low` is farther from 0 than q can change up to `high`, that sign.
/// Otherwise by Sturm's theorem in Tarski's form: of the signed remainders of p and p′ q, the
/// number of sign changes at `low` less that at `high` is the sum of the signs of q at the roots
/// between.
/// @param p not 0 at the ends of the root, unless they are equal
/// @param root of p, from 0 to 1
inline int sign_at_root(const ExactPolynomial& q, const ExactPolynomial& p, const ExactRoot& root) {
  const Exact value = q.at(root.low);
  if (root.low == root.high || q.is_zero()) return value.sign();
  Exact steepest;
  for (int k = 1; k <= q.degree(); ++k) {
    steepest += abs(q.coefficients[static_cast<std::size_t>(k)]) * Exact(k);
  }
  if (abs(value) > steepest * (root.high - root.low)) return value.sign();
  const auto sequence = detail::signed_remainders(p, derivative(p) * q);
  return detail::sign_changes(sequence, root.low) - detail::sign_changes(sequence, root.high);
}
// [/exact-root]

namespace detail {

/// Adds the roots in the open interval, in ascending order. Parts to come are kept in a list: roots
/// close to 0 take thousands of halvings, too many for a recursion.
/// @param p without a multiple root
/// @param sequence Sturm's, of p
/// @param count of roots inside the interval
inline void isolate(const ExactPolynomial& p, const std::vector<ExactPolynomial>& sequence,
                    const ExactRoot& interval, int count, std::vector<ExactRoot>& roots) {
  struct Part {
    ExactRoot interval;
    int count;
  };
  std::vector<Part> parts{{interval, count}};  // the next is the last
  while (!parts.empty()) {
    const Part part = parts.back();
    const auto& [low, high] = part.interval;
    parts.pop_back();
    if (part.count == 0) continue;
    if (low == high || (part.count == 1 && p.at(low).sign() * p.at(high).sign() != 0)) {
      roots.push_back(part.interval);
      continue;
    }
    const Exact middle = (low + high) * Exact(0.5);
    const int met = p.at(middle).sign() == 0 ? 1 : 0;
    const int to_middle = sign_changes(sequence, low) - sign_changes(sequence, middle) - met;
    parts.push_back({{middle, high}, part.count - to_middle - met});
    parts.push_back({{middle, middle}, met});
    parts.push_back({{low, middle}, to_middle});
  }
}

}  // namespace detail

// [exact-roots]
/// The different real roots of a polynomial from 0 to 1, in ascending order.
struct ExactRoots {
  ExactPolynomial polynomial;    ///< with the same roots, each of them once
  std::vector<ExactRoot> roots;  ///< each alone in its interval; refined() narrows it
};

/// Finds all roots from 0 to 1: the interval is halved until Sturm's sequence counts at most one
/// root in each part.
///
/// Multiple roots are first made simple: p is divided by its greatest common divisor with p′.
/// Nothing is rounded, so no root is missed and none is invented. Roots that are very close to each
/// other take many halvings.
/// @param p not 0
inline ExactRoots exact_roots(const ExactPolynomial& p) {
  ExactRoots found{p, {}};
  const ExactPolynomial& simple = found.polynomial;
  auto sequence = detail::signed_remainders(p, derivative(p));
  if (sequence.back().degree() > 0) {
    found.polynomial = detail::divided(p, sequence.back()).first;
    sequence = detail::signed_remainders(simple, derivative(simple));
  }
  const Exact zero(0.0), one(1.0);
  if (simple.at(zero).sign() == 0) found.roots.push_back({zero, zero});
  const bool ends = simple.at(one).sign() == 0;
  // For simple roots the sequence counts those that are above the lower end and up to the upper.
  const int count = detail::sign_changes(sequence, zero) - detail::sign_changes(sequence, one);
  detail::isolate(simple, sequence, {zero, one}, count - (ends ? 1 : 0), found.roots);
  if (ends) found.roots.push_back({one, one});
  return found;
}

/// The root in an interval of at most 2^-60 of its upper end, or exactly; a root below 2^-1140 in
/// one of at most 2^-1200, after which it stops.
/// @param p not 0 at the ends of the root, unless they are equal
inline ExactRoot refined(ExactRoot root, const ExactPolynomial& p) {
  if (root.low == root.high) return root;
  const Exact half(0.5), fine(0x1p-60);
  const int before = p.at(root.low).sign();
  for (int k = 0; k < 1200 && root.high - root.low > fine * root.high; ++k) {
    const Exact middle = (root.low + root.high) * half;
    const int sign = p.at(middle).sign();
    if (sign == 0) return {middle, middle};
    (sign == before ? root.low : root.high) = middle;
  }
  return root;
}
// [/exact-roots]

namespace detail {

/// The largest floating-point number that is at most x, for x from 0 to 1.
template <class S>
S time_down(const Exact& x) {
  const S near = rounded<S>(x);
  if (!(x < Exact(static_cast<double>(near)))) return near;
  return std::nextafter(near, -std::numeric_limits<S>::infinity());
}

/// The smallest floating-point number that is at least x, for x from 0 to 1.
template <class S>
S time_up(const Exact& x) {
  const S near = rounded<S>(x);
  if (!(Exact(static_cast<double>(near)) < x)) return near;
  return std::nextafter(near, std::numeric_limits<S>::infinity());
}

}  // namespace detail

}  // namespace contact
