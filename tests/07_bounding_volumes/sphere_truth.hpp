/// @file
/// Smallest spheres in fractions: by trying every support, and by the conditions that only the
/// smallest one meets.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <contact/vector.hpp>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <support/oracle.hpp>
#include <vector>

namespace sphere_truth {

using oracle::Rational;
using oracle::Vector;

/// A sphere with its radius squared, and the weights with which points on it give its centre.
struct Ball {
  Vector centre;
  Rational radius_squared;
  std::vector<Rational> weights;  ///< of the points in their order; their sum is 1
};

inline Rational distance_squared(const Vector& p, const Vector& q) {
  const Vector d = p - q;
  return d.dot(d);
}
inline bool contains(const Ball& ball, const Vector& p) {
  return distance_squared(p, ball.centre) <= ball.radius_squared;
}

/// Points of floats or doubles, unchanged.
template <std::floating_point S>
std::vector<Vector> exact(const std::vector<contact::Vector3<S>>& points) {
  std::vector<Vector> all;
  all.reserve(points.size());
  for (const auto& p : points) all.push_back(oracle::exact(p));
  return all;
}

/// The smallest sphere with one to four points on its surface; nothing if they are affinely
/// dependent. Its centre is p + Σ wᵢ vᵢ with 2 vᵢ · Σ wⱼ vⱼ = vᵢ · vᵢ, where the vᵢ lead from the
/// first point p to the others: Gaussian elimination. The matrix is positive definite or singular,
/// so no rows are exchanged.
inline std::optional<Ball> through(const std::vector<Vector>& points) {
  const std::size_t n = points.size() - 1;
  std::vector<Vector> v;
  for (std::size_t i = 0; i < n; ++i) v.push_back(points[i + 1] - points[0]);
  std::vector<std::vector<Rational>> rows(n, std::vector<Rational>(n + 1));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) rows[i][j] = 2 * v[i].dot(v[j]);
    rows[i][n] = v[i].dot(v[i]);
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (rows[i][i] == 0) return std::nullopt;
    for (std::size_t k = 0; k < n; ++k) {
      if (k == i || rows[k][i] == 0) continue;
      const Rational factor = rows[k][i] / rows[i][i];
      for (std::size_t j = i; j <= n; ++j) rows[k][j] -= factor * rows[i][j];
    }
  }
  Ball ball{points[0], 0, {Rational(1)}};
  for (std::size_t i = 0; i < n; ++i) {
    ball.weights.push_back(rows[i][n] / rows[i][i]);
    ball.weights[0] -= ball.weights.back();
    ball.centre += ball.weights.back() * v[i];
  }
  ball.radius_squared = distance_squared(points[0], ball.centre);
  return ball;
}

/// The smallest sphere around all points: the smallest of those through one to four of them that
/// contain the others. For few points.
inline Ball smallest(const std::vector<Vector>& points) {
  std::optional<Ball> best;
  std::vector<Vector> chosen;
  const std::function<void(std::size_t)> choose = [&](std::size_t from) {
    for (std::size_t i = from; i < points.size(); ++i) {
      chosen.push_back(points[i]);
      const std::optional<Ball> ball = through(chosen);
      if (ball && (!best || ball->radius_squared < best->radius_squared) &&
          std::all_of(points.begin(), points.end(),
                      [&](const Vector& p) { return contains(*ball, p); })) {
        best = ball;
      }
      if (ball && chosen.size() < 4) choose(i + 1);
      chosen.pop_back();
    }
  };
  choose(0);
  return *best;
}

/// The smallest sphere around all points, if some of them are a support that cannot be reduced: the
/// sphere through these has its centre strictly inside their convex hull, so no smaller sphere
/// contains them, and it contains all points.
inline std::optional<Ball> certified(const std::vector<Vector>& points,
                                     std::span<const int> support) {
  std::vector<Vector> chosen;
  for (const int i : support) {
    if (i < 0 || i >= static_cast<int>(points.size())) return std::nullopt;
    chosen.push_back(points[static_cast<std::size_t>(i)]);
  }
  const std::optional<Ball> ball = through(chosen);
  if (!ball) return std::nullopt;
  for (const Rational& weight : ball->weights) {
    if (weight <= 0) return std::nullopt;
  }
  for (const Vector& p : points) {
    if (!contains(*ball, p)) return std::nullopt;
  }
  return ball;
}

/// The largest squared distance of the points from a centre.
inline Rational largest_distance_squared(const std::vector<Vector>& points, const Vector& centre) {
  Rational largest = 0;
  for (const Vector& p : points) largest = std::max(largest, distance_squared(p, centre));
  return largest;
}

/// Whether x ≥ 0 is the smallest number of its type whose square is at least `square`.
template <std::floating_point S>
bool is_root_rounded_up(S x, const Rational& square) {
  if (!std::isfinite(x) || x < 0) return false;
  const Rational r = oracle::exact(x);
  if (r * r < square) return false;
  if (x == 0) return true;
  const Rational below = oracle::exact(std::nextafter(x, S(0)));
  return below * below < square;
}

/// The float or double nearest to x.
template <std::floating_point S>
S nearest(const Rational& x) {
  if constexpr (std::same_as<S, float>) {
    return oracle::nearest_float(x);
  } else {
    return oracle::nearest(x);
  }
}

}  // namespace sphere_truth
