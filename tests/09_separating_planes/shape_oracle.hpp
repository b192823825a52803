/// @file
/// Exact answers about convex bodies, independent of the book's methods: the smallest distance by
/// testing every set of active bounds.
#pragma once

#include <contact/convex_shapes.hpp>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "support/generators.hpp"
#include "support/oracle.hpp"

namespace shape_oracle {

using oracle::Rational;
using oracle::Vector;
using ExactBox = contact::OrientedBox<Rational>;
using ExactCapsule = contact::Capsule<Rational>;

inline contact::Matrix3<Rational> exact(const contact::Matrix3<double>& m) {
  contact::Matrix3<Rational> e;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) e(i, k) = oracle::exact(m(i, k));
  }
  return e;
}
inline ExactBox exact(const contact::OrientedBox<double>& b) {
  return {oracle::exact(b.centre), exact(b.axes), oracle::exact(b.half_lengths)};
}

/// All points origin + Σ xᵢ spanᵢ with −1 ≤ xᵢ ≤ 1: a segment, a box, or the Minkowski difference
/// of two of them.
struct Zonotope {
  Vector origin;
  std::vector<Vector> spans;
};
inline Zonotope zonotope(const contact::Segment<Rational>& s) {
  return {(s.start + s.end) / Rational(2), {(s.end - s.start) / Rational(2)}};
}
inline Zonotope zonotope(const ExactBox& b) {
  Zonotope z{b.centre, {}};
  for (int i = 0; i < 3; ++i) z.spans.push_back(b.axes.col(i) * b.half_lengths(i));
  return z;
}
/// All differences a − b.
inline Zonotope difference(Zonotope a, const Zonotope& b) {
  a.origin = a.origin - b.origin;
  a.spans.insert(a.spans.end(), b.spans.begin(), b.spans.end());
  return a;
}

/// Solves the normal equations of the free spans; nothing if they are dependent.
inline std::optional<std::vector<Rational>> solved(std::vector<std::vector<Rational>> m) {
  const std::size_t n = m.size();
  for (std::size_t c = 0; c < n; ++c) {
    std::size_t pivot = c;
    while (pivot < n && m[pivot][c] == 0) ++pivot;
    if (pivot == n) return std::nullopt;
    std::swap(m[pivot], m[c]);
    for (std::size_t r = 0; r < n; ++r) {
      if (r == c || m[r][c] == 0) continue;
      const Rational f = m[r][c] / m[c][c];
      for (std::size_t k = c; k <= n; ++k) m[r][k] -= f * m[c][k];
    }
  }
  std::vector<Rational> x;
  for (std::size_t i = 0; i < n; ++i) x.push_back(m[i][n] / m[i][i]);
  return x;
}

/// The squared distance of the origin from a zonotope: every coordinate is −1, 1 or free, the free
/// ones minimise the distance, and the smallest of all admissible distances is the result.
inline Rational min_squared(const Zonotope& z) {
  std::optional<Rational> best;
  const std::size_t n = z.spans.size();
  std::size_t sets = 1;
  for (std::size_t i = 0; i < n; ++i) sets *= 3;
  for (std::size_t set = 0; set < sets; ++set) {
    Vector p = z.origin;
    std::vector<std::size_t> free;
    std::size_t rest = set;
    for (std::size_t i = 0; i < n; ++i, rest /= 3) {
      if (rest % 3 == 0) p = p - z.spans[i];
      if (rest % 3 == 1) p = p + z.spans[i];
      if (rest % 3 == 2) free.push_back(i);
    }
    if (free.size() > 3) continue;  // dependent: fewer free ones give an equally good answer
    std::vector<std::vector<Rational>> m;
    for (const std::size_t i : free) {
      m.emplace_back();
      for (const std::size_t k : free) m.back().push_back(z.spans[i].dot(z.spans[k]));
      m.back().push_back(-z.spans[i].dot(p));
    }
    const auto x = solved(m);
    if (!x) continue;
    bool allowed = true;
    for (std::size_t i = 0; i < free.size(); ++i) {
      allowed = allowed && -1 <= (*x)[i] && (*x)[i] <= 1;
      p = p + z.spans[free[i]] * (*x)[i];
    }
    const Rational squared = p.dot(p);
    if (allowed && (!best || squared < *best)) best = squared;
  }
  return *best;
}

/// A rotation by an integer quaternion, divided by its squared length.
inline contact::Matrix3<Rational> rotation(int w, int x, int y, int z) {
  const Rational s = w * w + x * x + y * y + z * z;
  contact::Matrix3<Rational> m;
  m << w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y),  //
      2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x),   //
      2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z;
  return m / s;
}
inline contact::Matrix3<double> rounded(const contact::Matrix3<Rational>& m) {
  contact::Matrix3<double> r;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) r(i, k) = oracle::nearest(m(i, k));
  }
  return r;
}

/// A rotation by an integer quaternion; on a grid, one that permutes the axes.
inline contact::Matrix3<Rational> rotation(generators::Random& random, bool grid) {
  for (;;) {
    const int most = grid ? 1 : 6;
    const int w = random.integer(-most, most);
    const int x = random.integer(-most, most);
    const int y = random.integer(-most, most);
    const int z = random.integer(-most, most);
    const int size = w * w + x * x + y * y + z * z;
    if (size == 0 || (grid && size == 3)) continue;
    return rotation(w, x, y, z);
  }
}

}  // namespace shape_oracle
