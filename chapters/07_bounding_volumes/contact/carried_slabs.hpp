/// @file
/// A k-DOP carried along with its object: slabs of the same normals about the image of the stored
/// ones.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include <contact/exact_outward.hpp>
#include <contact/frame.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/outward.hpp>
#include <contact/ray_kdop.hpp>
#include <contact/running_error.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace detail {

/// Three normals of a k-DOP that are independent, with the cross products that solve for them.
struct SlabTriple {
  std::array<std::size_t, 3> slabs;
  std::array<Vector3<double>, 3> solve;  ///< weight i of m is solve[i] · m
};

/// All triples of independent normals, rounded.
inline std::vector<SlabTriple> slab_triples(const std::vector<Vector3<double>>& normals) {
  std::vector<SlabTriple> triples;
  const std::size_t n = normals.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      const Vector3<double> ij = normals[i].cross(normals[j]);
      for (std::size_t k = j + 1; k < n; ++k) {
        const double volume = ij.dot(normals[k]);
        const double size = ij.cwiseAbs().maxCoeff() * normals[k].cwiseAbs().maxCoeff();
        if (!(std::abs(volume) > 0x1p-40 * size)) continue;
        triples.push_back({{i, j, k},
                           {normals[j].cross(normals[k]) / volume,
                            normals[k].cross(normals[i]) / volume, ij / volume}});
      }
    }
  }
  return triples;
}

/// A bound on the coordinates of all points of a k-DOP. With R the computed inverse of three
/// normals N and |I − R N| ≤ 1/4 in its row sums, x = R N x + (I − R N) x gives |x| ≤ 4/3 |R||N x|;
/// the factor 2 covers all roundings.
inline double coordinate_bound(const Kdop<double>& dop, const std::vector<SlabTriple>& triples) {
  double best = std::numeric_limits<double>::infinity();
  for (const SlabTriple& triple : triples) {
    Matrix3<double> inverse, normals;
    Vector3<double> offsets;
    for (int i = 0; i < 3; ++i) {
      const std::size_t slab = triple.slabs[std::size_t(i)];
      inverse.col(i) = triple.solve[std::size_t(i)];
      normals.row(i) = dop.normals[slab].transpose();
      offsets[i] = std::max(std::abs(dop.low[slab]), std::abs(dop.high[slab]));
    }
    const Matrix3<double> off = inverse * normals - Matrix3<double>::Identity();
    if (!(off.cwiseAbs().rowwise().sum().maxCoeff() <= 0.125)) continue;
    const double bound = 2 * Vector3<double>(inverse.cwiseAbs() * offsets).maxCoeff();
    if (bound < best) best = bound;
  }
  return best;
}

/// The direction m = Aᵀ n that becomes n, with bounds on its errors.
inline Triple<RunningError> direction_before(const Matrix3<double>& axes,
                                             const Vector3<double>& n) {
  const auto column = [&axes](int j) { return triple<RunningError>(Vector3<double>(axes.col(j))); };
  const Triple<RunningError> exact = triple<RunningError>(n);
  return {dot(column(0), exact), dot(column(1), exact), dot(column(2), exact)};
}

/// The end of a slab at which weight × (normal · x) is largest.
inline double slab_end(const Kdop<double>& dop, std::size_t slab, double weight) {
  return weight < 0 ? dop.low[slab] : dop.high[slab];
}

/// The triples whose weights bound −m · x and m · x best, rounded; none if no bound is finite.
inline std::array<const SlabTriple*, 2> best_triples(const Kdop<double>& dop,
                                                     const std::vector<SlabTriple>& triples,
                                                     const Vector3<double>& m) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::array<double, 2> best{infinity, infinity};
  std::array<const SlabTriple*, 2> chosen{nullptr, nullptr};
  for (const SlabTriple& triple : triples) {
    std::array<double, 2> sum{0, 0};
    for (std::size_t i = 0; i < 3; ++i) {
      const double weight = triple.solve[i].dot(m);
      if (weight == 0) continue;
      sum[0] -= weight * slab_end(dop, triple.slabs[i], -weight);
      sum[1] += weight * slab_end(dop, triple.slabs[i], weight);
    }
    for (std::size_t side = 0; side < 2; ++side) {
      if (sum[side] < best[side]) {
        best[side] = sum[side];
        chosen[side] = &triple;
      }
    }
  }
  return chosen;
}

/// An upper bound on m · x + shift for all x of a k-DOP whose coordinates are at most
/// `coordinates`; ∞ without a triple.
///
/// For any weights, m · x = Σ weightⱼ normalⱼ · x + ρ · x with ρ = m − Σ weightⱼ normalⱼ, which is
/// at most Σ max(weightⱼ lowⱼ, weightⱼ highⱼ) + Σ|ρₖ| × coordinates. The smallest such sum with
/// three weights and ρ = 0 is the maximum itself (duality of linear programs); rounded weights only
/// make ρ about u.
inline double slab_bound(const Kdop<double>& dop, const SlabTriple* triple,
                         const Triple<RunningError>& m, const RunningError& shift,
                         double coordinates) {
  if (triple == nullptr) return std::numeric_limits<double>::infinity();
  const Vector3<double> rough{m[0].value, m[1].value, m[2].value};
  RunningError sum = shift;
  Triple<RunningError> rest = m;
  for (std::size_t i = 0; i < 3; ++i) {
    const double weight = triple->solve[i].dot(rough);
    const std::size_t slab = triple->slabs[i];
    if (weight == 0) continue;
    sum = sum + RunningError(weight) * RunningError(slab_end(dop, slab, weight));
    for (std::size_t k = 0; k < 3; ++k) {
      rest[k] = rest[k] - RunningError(weight) * RunningError(dop.normals[slab][int(k)]);
    }
  }
  double error = sum.bound;
  for (const RunningError& r : rest) error += (std::abs(r.value) + r.bound) * coordinates;
  // What is not finite is no bound.
  if (!std::isfinite(sum.value + error)) return std::numeric_limits<double>::infinity();
  return sum_up(sum.value, error * (1 + 16 * RunningError::u) + RunningError::floor);
}

}  // namespace detail

/// A k-DOP carried along: slabs of the same normals that contain the image of the k-DOP.
///
/// But for rounding, the smallest ones: each offset is the maximum of n · (o + A x) over the k-DOP,
/// a linear program in three variables that is solved over all triples of its normals. Yet the
/// result grows at each turn: its normals do not turn with the object. A 6-DOP of a cube that turns
/// by 45° about an axis doubles its volume. Remake the k-DOP from the object's points where the
/// tightest one is wanted; carry the object's own k-DOP, never the one of the step before.
///
/// An infinite end of a slab bounds nothing; if the other slabs bound the body, the result is
/// finite all the same. An empty k-DOP (low > high) may get an image that is not empty. Without
/// normals the result has none.
/// @param dop m, in the frame; three of its normals are independent: the determinant is more than
/// 2^-40 of the product of their lengths, which are from 1e-90 to 1e90
/// @param frame taken as stored, also if its axes are no rotation
/// @throws std::invalid_argument if the k-DOP has no end (a prism), another number is not finite,
/// or twice a coordinate of the k-DOP or an offset of its image may overflow
template <FloatOrDouble S>
Kdop<S> carried(const Kdop<S>& dop, const CoordinateFrame<S>& frame) {
  require_finite("frame", frame.axes);
  require_finite("frame", frame.origin);
  const Kdop<double> body = detail::in_double(dop);
  for (std::size_t k = 0; k < body.normals.size(); ++k) {
    if (std::isnan(body.low[k]) || std::isnan(body.high[k])) {
      throw_invalid_argument("dop", "nan", "must be a number");
    }
  }
  const Matrix3<double> axes = frame.axes.template cast<double>();
  const auto origin = detail::triple<RunningError>(frame.origin.template cast<double>());
  const std::vector<detail::SlabTriple> triples = detail::slab_triples(body.normals);
  const double coordinates = detail::coordinate_bound(body, triples);
  Kdop<S> result;
  result.normals = dop.normals;
  for (const Vector3<double>& n : body.normals) {
    detail::Triple<RunningError> m = detail::direction_before(axes, n);
    const RunningError shift = detail::dot(detail::triple<RunningError>(n), origin);
    const auto [lower, upper] =
        detail::best_triples(body, triples, Vector3<double>(m[0].value, m[1].value, m[2].value));
    const double high = detail::slab_bound(body, upper, m, shift, coordinates);
    for (RunningError& x : m) x = -x;
    const double low = -detail::slab_bound(body, lower, m, -shift, coordinates);
    result.low.push_back(downward<S>(low));
    result.high.push_back(upward<S>(high));
    if (!std::isfinite(result.low.back()) || !std::isfinite(result.high.back())) {
      throw_invalid_argument("dop", std::to_string(dop.normals.size()) + " normals",
                             "must bound a body, and its image must not overflow");
    }
  }
  return result;
}

}  // namespace contact
