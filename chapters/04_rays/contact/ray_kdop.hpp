/// @file
/// Line, ray and segment against a k-DOP: a box with more pairs of parallel faces.
#pragma once

#include <cmath>
#include <concepts>

#include <contact/exact.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/passage.hpp>
#include <contact/shapes.hpp>
#include <contact/slabs.hpp>
#include <contact/vector.hpp>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
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

/// The smallest k-DOP of representable numbers that contains all points: low and high are computed
/// exactly and rounded outward.
/// @param normals k/2, finite, none 0
/// @param points n ≥ 1, m, finite
/// @throws std::invalid_argument if there is no point or normal, or a number is not finite, or a
/// normal is 0
template <FloatOrDouble S>
Kdop<S> kdop_of_points(const std::vector<Vector3<S>>& normals, std::span<const Vector3<S>> points) {
  if (points.empty()) throw_invalid_argument("points", "{}", "a k-DOP needs at least one point");
  if (normals.empty()) throw_invalid_argument("normals", "{}", "a k-DOP needs at least one normal");
  for (const Vector3<S>& point : points) require_finite("points", point);
  Kdop<S> dop;
  dop.normals = normals;
  for (const Vector3<S>& normal : normals) {
    require_finite("normals", normal);
    if (normal == Vector3<S>::Zero()) {
      throw_invalid_argument("normals", vector_text(normal), "must not be 0");
    }
    const Vector3<Exact> n = exact_vector(normal);
    Exact low = n.dot(exact_vector(points.front()));
    Exact high = low;
    for (const Vector3<S>& point : points) {
      const Exact at = n.dot(exact_vector(point));
      if (at < low) low = at;
      if (high < at) high = at;
    }
    constexpr S infinity = std::numeric_limits<S>::infinity();
    S below = rounded<S>(low), above = rounded<S>(high);
    if (is_finite(below) && low < Exact(double(below))) below = std::nextafter(below, -infinity);
    if (is_finite(above) && Exact(double(above)) < high) above = std::nextafter(above, infinity);
    dop.low.push_back(below);
    dop.high.push_back(above);
  }
  return dop;
}

namespace detail {

template <FloatOrDouble S>
std::vector<Slab<Exact>> exact_slabs(const Ray<Exact>& ray, const Kdop<S>& dop) {
  std::vector<Slab<Exact>> slabs;
  for (std::size_t k = 0; k < dop.normals.size(); ++k) {
    const Vector3<Exact> n = exact_vector(dop.normals[k]);
    const Exact start = n.dot(ray.origin);
    slabs.push_back({Exact(double(dop.low[k])) - start, Exact(double(dop.high[k])) - start,
                     n.dot(ray.direction)});
  }
  return slabs;
}

template <FloatOrDouble S>
bool is_finite(const Kdop<S>& dop) {
  for (std::size_t k = 0; k < dop.normals.size(); ++k) {
    if (!all_finite(dop.normals[k]) || !contact::is_finite(dop.low[k]) ||
        !contact::is_finite(dop.high[k])) {
      return false;
    }
  }
  return true;
}

}  // namespace detail

/// Whether a ray or a segment meets a solid k-DOP. Touching counts. Right for every finite input;
/// not finite: no.
template <FloatOrDouble S, LineOf<S> Line>
bool hits_kdop(const Line& line, const Kdop<S>& dop) {
  if (!is_finite(line) || !detail::is_finite(dop)) return false;
  return hits_slabs(detail::exact_slabs(exact_ray_of(line), dop), has_end<Line>);
}

/// Where the unbounded line through a ray or a segment enters and leaves a k-DOP.
///
/// Face 2 j is the lower one of normal j, 2 j + 1 the upper one; equal entries: the lowest j,
/// exactly.
template <FloatOrDouble S, LineOf<S> Line>
std::optional<Passage<S>> passage(const Line& line, const Kdop<S>& dop) {
  if (!is_finite(line) || !detail::is_finite(dop)) return std::nullopt;
  std::optional<Passage<S>> found = slabs_passage<S>(detail::exact_slabs(exact_ray_of(line), dop));
  if (!found) return found;
  const auto normal = [&](int face) {
    if (face < 0) return Vector3<S>(Vector3<S>::Zero());
    const Vector3<S> n = dop.normals[std::size_t(face / 2)].stableNormalized();
    return face % 2 == 1 ? n : Vector3<S>(-n);
  };
  found->entry_normal = normal(found->entry_face);
  found->exit_normal = normal(found->exit_face);
  return found;
}

/// What a ray or a segment meets first of a solid k-DOP.
template <FloatOrDouble S, LineOf<S> Line>
std::optional<BodyHit<S>> first_hit(const Line& line, const Kdop<S>& dop) {
  if (!hits_kdop(line, dop)) return std::nullopt;
  return first_hit(line, *passage(line, dop));
}

}  // namespace contact
