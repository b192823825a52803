/// @file
/// Line, ray and segment against a k-DOP: a box with more pairs of parallel faces.
#pragma once

#include <algorithm>
#include <concepts>

#include <contact/exact.hpp>
#include <contact/exact_outward.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/passage.hpp>
#include <contact/running_error.hpp>
#include <contact/shapes.hpp>
#include <contact/slabs.hpp>
#include <contact/vector.hpp>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace contact {

// [kdop]
/// A discrete oriented polytope: all x with low ≤ normal · x ≤ high for each of k/2 normals.
///
/// Normals need not be unit vectors; those of kdop_normals are whole numbers. low and high are in m
/// times the length of their normal.
template <Ring S>
struct Kdop {
  std::vector<Vector3<S>> normals;  ///< k/2, none 0
  std::vector<S> low;               ///< k/2
  std::vector<S> high;              ///< k/2, not below low
};

/// The normals of the usual k-DOPs, in this order: three axes; with k = 14 and 26 the four
/// diagonals of a cube; with 18 and 26 the six diagonals of its faces.
/// @param k 6, 14, 18 or 26
/// @throws std::invalid_argument for another k
template <Ring S>
std::vector<Vector3<S>> kdop_normals(int k) {
  if (k != 6 && k != 14 && k != 18 && k != 26) {
    throw_invalid_argument("k", std::to_string(k), "must be 6, 14, 18 or 26");
  }
  const auto v = [](int x, int y, int z) { return Vector3<S>(S(x), S(y), S(z)); };
  std::vector<Vector3<S>> normals{v(1, 0, 0), v(0, 1, 0), v(0, 0, 1)};
  if (k == 14 || k == 26) {
    for (const auto& n : {v(1, 1, 1), v(1, 1, -1), v(1, -1, 1), v(-1, 1, 1)}) normals.push_back(n);
  }
  if (k == 18 || k == 26) {
    for (const auto& n :
         {v(1, 1, 0), v(1, 0, 1), v(0, 1, 1), v(1, -1, 0), v(1, 0, -1), v(0, 1, -1)}) {
      normals.push_back(n);
    }
  }
  return normals;
}
// [/kdop]

namespace detail {

/// Throws unless slabs along the normals can be put around the points.
template <FloatOrDouble S>
void require_slabs_of(const std::vector<Vector3<S>>& normals, std::span<const Vector3<S>> points) {
  if (points.empty()) throw_invalid_argument("points", "{}", "a k-DOP needs at least one point");
  if (normals.empty()) throw_invalid_argument("normals", "{}", "a k-DOP needs at least one normal");
  for (const Vector3<S>& point : points) require_finite("points", point);
  for (const Vector3<S>& normal : normals) {
    require_finite("normals", normal);
    if (normal == Vector3<S>::Zero()) {
      throw_invalid_argument("normals", vector_text(normal), "must not be 0");
    }
  }
}

/// The smallest and the largest n · p of points, without rounding.
///
/// A product of three terms has at most five roundings, so 8 u times the sum of their magnitudes
/// bounds its error and that of the bound. A point beyond which another one certainly is need not
/// be computed exactly; if a product overflows, its bound is infinite, and it is.
template <FloatOrDouble S>
std::pair<Exact, Exact> exact_extremes(const Vector3<S>& normal,
                                       std::span<const Vector3<S>> points) {
  const auto along = [&normal](const Vector3<S>& point) {
    const Vector3<double> terms =
        normal.template cast<double>().cwiseProduct(point.template cast<double>());
    return RunningError(terms.sum(),
                        8 * RunningError::u * terms.cwiseAbs().sum() + RunningError::floor);
  };
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  for (const Vector3<S>& point : points) {
    const RunningError at = along(point);
    lowest = std::min(lowest, at.value + at.bound);
    highest = std::max(highest, at.value - at.bound);
  }
  std::optional<Exact> low, high;
  for (const Vector3<S>& point : points) {
    const RunningError at = along(point);
    const bool may_be_low = !(at.value - at.bound > lowest);
    const bool may_be_high = !(at.value + at.bound < highest);
    if (!may_be_low && !may_be_high) continue;
    const Exact exact = exact_vector(normal).dot(exact_vector(point));
    if (may_be_low && (!low || exact < *low)) low = exact;
    if (may_be_high && (!high || *high < exact)) high = exact;
  }
  return {*low, *high};
}

}  // namespace detail

/// The smallest k-DOP of representable numbers that contains all points: low and high are computed
/// exactly and rounded outward. Beyond the largest number, low stays that number and high is ∞:
/// then hits_kdop says no.
/// @param normals k/2, finite, none 0
/// @param points n ≥ 1, m, finite
/// @throws std::invalid_argument if there is no point or normal, or a number is not finite, or a
/// normal is 0
template <FloatOrDouble S>
Kdop<S> kdop_of_points(const std::vector<Vector3<S>>& normals, std::span<const Vector3<S>> points) {
  detail::require_slabs_of(normals, points);
  Kdop<S> dop;
  dop.normals = normals;
  for (const Vector3<S>& normal : normals) {
    const auto [low, high] = detail::exact_extremes<S>(normal, points);
    dop.low.push_back(downward<S>(low));
    dop.high.push_back(upward<S>(high));
  }
  return dop;
}

/// A k-DOP of doubles as slabs of a line, in bounded or exact numbers. A normal of 0 makes a slab
/// of speed 0; no normal, no slab. For T = Exact all numbers must be finite.
template <class T, class Line>
std::vector<Slab<T>> slabs_of(const Line& line, const Kdop<double>& dop) {
  using namespace detail;
  std::vector<Slab<T>> slabs;
  slabs.reserve(dop.normals.size());
  const Triple<T> start = triple<T>(start_of(line));
  const Triple<T> direction = direction_of<T>(line);
  for (std::size_t k = 0; k < dop.normals.size(); ++k) {
    const Triple<T> n = triple<T>(dop.normals[k]);
    const T at = dot(n, start);
    slabs.push_back({T(dop.low[k]) - at, T(dop.high[k]) - at, dot(n, direction)});
  }
  return slabs;
}

namespace detail {

template <FloatOrDouble S>
Kdop<double> in_double(const Kdop<S>& dop) {
  Kdop<double> result;
  for (std::size_t k = 0; k < dop.normals.size(); ++k) {
    result.normals.push_back(dop.normals[k].template cast<double>());
    result.low.push_back(static_cast<double>(dop.low[k]));
    result.high.push_back(static_cast<double>(dop.high[k]));
  }
  return result;
}

template <FloatOrDouble S>
bool dop_is_finite(const Kdop<S>& dop) {
  for (std::size_t k = 0; k < dop.normals.size(); ++k) {
    if (!all_finite(dop.normals[k]) || !contact::is_finite(dop.low[k]) ||
        !contact::is_finite(dop.high[k])) {
      return false;
    }
  }
  return true;
}

/// The unit outward normals of a k-DOP's faces.
template <FloatOrDouble S>
auto normals_of(const Kdop<S>& dop) {
  return [&dop](int face) {
    const Vector3<S> n = dop.normals[static_cast<std::size_t>(face / 2)].stableNormalized();
    return face % 2 == 1 ? n : Vector3<S>(-n);
  };
}

}  // namespace detail

// [hits-kdop]
/// Whether a ray or a segment meets a solid k-DOP. Touching counts.
///
/// Right for every finite input: the slabs' signs from bounded numbers, else from exact ones. A
/// k-DOP with low > high is empty: no. One without normals is all of space. A number that is not
/// finite: no.
template <FloatOrDouble S, LineOf<S> Line>
bool hits_kdop(const Line& line, const Kdop<S>& dop) {
  if (!is_finite(line) || !detail::dop_is_finite(dop)) return false;
  return detail::hits_slabs(in_double(line), detail::in_double(dop));
}
// [/hits-kdop]

/// Where the unbounded line through a ray or a segment enters and leaves a k-DOP.
///
/// The decision is right for every finite input. Face 2 j is the lower one of normal j, 2 j + 1 the
/// upper one; of faces that are entered at the same t the lowest j, decided exactly. Unit normals.
/// Each t is within 2^-40 of the larger magnitude of both; beyond the largest number it is
/// infinite. A direction of 0 in the k-DOP has entry −∞, exit ∞ and normals 0. Nothing for low >
/// high and numbers that are not finite.
template <FloatOrDouble S, LineOf<S> Line>
std::optional<Passage<S>> passage(const Line& line, const Kdop<S>& dop) {
  if (!is_finite(line) || !detail::dop_is_finite(dop)) return std::nullopt;
  const auto found = detail::slabs_passage(in_double(line), detail::in_double(dop));
  if (!found) return std::nullopt;
  return detail::with_normals<S>(found->passage, detail::normals_of(dop));
}

/// What a ray or a segment meets first of a solid k-DOP. Decision, face and `inside` are exact; t
/// as in passage, and the point off by that times the direction and by 6 u of its terms, so
/// infinite with t. Nothing where hits_kdop says no; without normals, every start is inside.
template <FloatOrDouble S, LineOf<S> Line>
std::optional<BodyHit<S>> first_hit(const Line& line, const Kdop<S>& dop) {
  if (!is_finite(line) || !detail::dop_is_finite(dop)) return std::nullopt;
  const auto found = detail::slabs_passage(in_double(line), detail::in_double(dop));
  return detail::first_of_slabs<S>(line, found, detail::normals_of(dop));
}

}  // namespace contact
