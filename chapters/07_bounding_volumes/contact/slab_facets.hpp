/// @file
/// The facets, vertices and volume of a k-DOP, rounded: to draw and to measure it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include <contact/exact.hpp>
#include <contact/frame.hpp>
#include <contact/ray_kdop.hpp>
#include <contact/running_error.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace detail {

/// All x with normal · x ≤ offset.
struct UnitHalfSpace {
  Vector3<double> normal;  ///< of length 1
  double offset;           ///< m
};

/// A vector divided by its length, and the length; for entries of any size.
inline std::optional<UnitHalfSpace> unit_half_space(const Vector3<double>& normal, double offset) {
  const double largest = normal.cwiseAbs().maxCoeff();
  if (!(largest > 0) || !std::isfinite(largest) || !std::isfinite(offset)) return std::nullopt;
  int power = 0;
  std::frexp(largest, &power);
  Vector3<double> n;
  for (int k = 0; k < 3; ++k) n[k] = std::ldexp(normal[k], -power);
  const double length = std::sqrt(n.dot(n));
  return UnitHalfSpace{n / length, std::ldexp(offset / length, -power)};
}

/// Whether b excludes no point that a keeps: parallel normals of one direction, compared exactly.
inline bool is_implied(const Vector3<double>& a, double at_a, const Vector3<double>& b,
                       double at_b) {
  for (const RunningError& x : cross(triple<RunningError>(a), triple<RunningError>(b))) {
    if (x.certain_sign() != 0) return false;
  }
  const Triple<Exact> n = triple<Exact>(a), m = triple<Exact>(b);
  for (const Exact& x : cross(n, m)) {
    if (x.sign() != 0) return false;
  }
  if (dot(n, m).sign() < 0) return false;
  int k = 0;
  a.cwiseAbs().maxCoeff(&k);
  const Exact size = abs(n[std::size_t(k)]), other = abs(m[std::size_t(k)]);
  return Exact(at_a) * other <= Exact(at_b) * size;
}

/// The half-spaces of a k-DOP, without those that a parallel one implies; of equal ones the first
/// stays. Infinite bounds give none.
template <FloatOrDouble S>
std::vector<UnitHalfSpace> half_spaces_of(const Kdop<S>& dop) {
  struct Side {
    Vector3<double> normal;
    double offset;
  };
  std::vector<Side> sides;
  for (std::size_t k = 0; k < dop.normals.size(); ++k) {
    const Vector3<double> n = dop.normals[k].template cast<double>();
    for (const Side& side : {Side{Vector3<double>(-n), -static_cast<double>(dop.low[k])},
                             Side{n, static_cast<double>(dop.high[k])}}) {
      if (all_finite(n) && n != Vector3<double>::Zero() && std::isfinite(side.offset)) {
        sides.push_back(side);
      }
    }
  }
  std::vector<UnitHalfSpace> kept;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    bool implied = false;
    for (std::size_t j = 0; j < sides.size() && !implied; ++j) {
      if (i == j) continue;
      const bool by_j =
          is_implied(sides[j].normal, sides[j].offset, sides[i].normal, sides[i].offset);
      const bool equal =
          by_j && is_implied(sides[i].normal, sides[i].offset, sides[j].normal, sides[j].offset);
      implied = by_j && (!equal || j < i);
    }
    if (implied) continue;
    if (const auto made = unit_half_space(sides[i].normal, sides[i].offset)) kept.push_back(*made);
  }
  return kept;
}

/// Whether a slab has no point, since its low > high, an end is NaN, or all of it is at infinity.
template <FloatOrDouble S>
bool has_empty_slab(const Kdop<S>& dop) {
  constexpr S infinity = std::numeric_limits<S>::infinity();
  for (std::size_t k = 0; k < dop.normals.size(); ++k) {
    const S low = dop.low[k], high = dop.high[k];
    if (!(low <= high) || low == infinity || high == -infinity) return true;
  }
  return false;
}

/// Whether coordinates up to a bound are so large that facets would overflow, or endless.
inline bool is_endless(double bound) { return !std::isfinite(16 * bound); }

/// A bound on the length of all x in a k-DOP; ∞ if no three of its slabs with two finite bounds
/// have independent normals, so that nothing is known.
///
/// If x is in three slabs with unit normals p, q and r, then det(p, q, r) x = (p·x) q × r + … has
/// length at most the sum of the three |offsets|.
template <FloatOrDouble S>
double bound_on_length(const Kdop<S>& dop) {
  std::vector<UnitHalfSpace> slabs;  // with the larger |offset|
  for (std::size_t k = 0; k < dop.normals.size(); ++k) {
    const double low = static_cast<double>(dop.low[k]), high = static_cast<double>(dop.high[k]);
    const auto made = unit_half_space(dop.normals[k].template cast<double>(),
                                      std::max(std::abs(low), std::abs(high)));
    if (made) slabs.push_back(*made);
  }
  double bound = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < slabs.size(); ++i) {
    for (std::size_t j = i + 1; j < slabs.size(); ++j) {
      const Vector3<double> line = slabs[i].normal.cross(slabs[j].normal);
      for (std::size_t k = j + 1; k < slabs.size(); ++k) {
        const double volume = std::abs(line.dot(slabs[k].normal));
        if (volume < 0x1p-40) continue;
        bound = std::min(bound, (slabs[i].offset + slabs[j].offset + slabs[k].offset) / volume);
      }
    }
  }
  return bound;
}

/// The part of a polygon in a half-space.
inline std::vector<Vector3<double>> clipped(const std::vector<Vector3<double>>& polygon,
                                            const UnitHalfSpace& side) {
  std::vector<Vector3<double>> kept;
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vector3<double>&p = polygon[i], &q = polygon[(i + 1) % n];
    const double here = side.normal.dot(p) - side.offset, next = side.normal.dot(q) - side.offset;
    if (here <= 0) kept.push_back(p);
    if ((here < 0 && next > 0) || (here > 0 && next < 0)) {
      const double t = here / (here - next);
      kept.push_back(Vector3<double>(p + t * (q - p)));
    }
  }
  return kept;
}

/// A square of the facet's plane that contains every point of the plane at most `reach` from the
/// origin, counter-clockwise from outside.
inline std::vector<Vector3<double>> square_on(const UnitHalfSpace& side, double reach) {
  const CoordinateFrame<double> frame =
      frame_on_normal<double>(Vector3<double>::Zero(), side.normal);
  const Vector3<double> middle = side.normal * side.offset;
  const Vector3<double> x = frame.axes.col(0) * reach, y = frame.axes.col(1) * reach;
  return {middle + x + y, middle - x + y, middle - x - y, middle + x - y};
}

/// A convex polygon without vertices that are closer than `room` to the one before or to the line
/// from that to the next; nothing if it is no wider than that.
inline std::vector<Vector3<double>> cleaned(std::vector<Vector3<double>> polygon, double room) {
  for (std::size_t i = 0; i < polygon.size() && polygon.size() > 2;) {
    const std::size_t n = polygon.size();
    const Vector3<double> in = polygon[i] - polygon[(i + n - 1) % n];
    const Vector3<double> through = polygon[(i + 1) % n] - polygon[(i + n - 1) % n];
    const double length = through.cwiseAbs().maxCoeff();
    // Divided first, so that no product over- or underflows.
    const Vector3<double> beside = in.cross(Vector3<double>(through / length));
    const bool needed =
        length > 0 && in.cwiseAbs().maxCoeff() > room && beside.cwiseAbs().maxCoeff() > 2 * room;
    if (needed) {
      ++i;
    } else {
      polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(i));
      i = i > 0 ? i - 1 : 0;
    }
  }
  if (polygon.size() < 3) polygon.clear();
  return polygon;
}

}  // namespace detail

// [kdop-facets]
/// The facets of a k-DOP as polygons, counter-clockwise from outside. Planes that it only touches
/// at a vertex or an edge have none.
///
/// Rounded: each facet is a large square of its plane, clipped by the other half-spaces, so a
/// vertex is a few u of the size of the k-DOP and of its distance from the origin off, times the
/// inverse of the sine between nearly parallel planes. To draw and to measure, not to decide.
///
/// A slab whose normal is 0 or not finite counts as none, and so does the infinite end of one.
/// @return nothing for an empty k-DOP, or one with a NaN in low or high; for one without an end
/// (see plane_dop_vertices() for a prism), and where that is not known because coordinates may
/// exceed 1e307
template <FloatOrDouble S>
std::vector<std::vector<Vector3<double>>> kdop_facets(const Kdop<S>& dop) {
  const double reach = detail::bound_on_length(dop);
  std::vector<std::vector<Vector3<double>>> facets;
  if (detail::is_endless(reach) || detail::has_empty_slab(dop)) return facets;
  const std::vector<detail::UnitHalfSpace> sides = detail::half_spaces_of(dop);
  for (std::size_t i = 0; i < sides.size(); ++i) {
    std::vector<Vector3<double>> facet = detail::square_on(sides[i], 2 * reach);
    for (std::size_t j = 0; j < sides.size() && !facet.empty(); ++j) {
      if (j != i) facet = detail::clipped(facet, sides[j]);
    }
    facet = detail::cleaned(facet, 0x1p-44 * reach);
    if (!facet.empty()) facets.push_back(facet);
  }
  return facets;
}
// [/kdop-facets]

/// The vertices of a k-DOP, rounded as kdop_facets(): of vertices that are closer to each other
/// than 2^-40 of the k-DOP's distance from the origin one is returned.
/// @return nothing where kdop_facets() is
template <FloatOrDouble S>
std::vector<Vector3<double>> kdop_vertices(const Kdop<S>& dop) {
  std::vector<Vector3<double>> vertices;
  double size = 0;
  for (const auto& facet : kdop_facets(dop)) {
    for (const Vector3<double>& v : facet) size = std::max(size, v.cwiseAbs().maxCoeff());
  }
  for (const auto& facet : kdop_facets(dop)) {
    for (const Vector3<double>& v : facet) {
      const bool known = std::any_of(vertices.begin(), vertices.end(), [&](const auto& w) {
        return (v - w).cwiseAbs().maxCoeff() <= 0x1p-40 * size;
      });
      if (!known) vertices.push_back(v);
    }
  }
  return vertices;
}

/// The volume of a k-DOP in m³, rounded as kdop_facets(): the sum of the cones from one of its
/// points to its facets.
///
/// Slabs that kdop_facets() does not count are not counted here.
/// @return 0 if it is empty or flat, or a number in low or high is NaN; ∞ if it has no end, or the
/// result or a product on the way to it overflows (lengths beyond 1e102)
template <FloatOrDouble S>
double volume(const Kdop<S>& dop) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (detail::has_empty_slab(dop)) return 0;
  if (detail::is_endless(detail::bound_on_length(dop))) return infinity;
  const auto facets = kdop_facets(dop);
  double six_volumes = 0;
  for (const auto& facet : facets) {
    const Vector3<double> apex = facet.front() - facets.front().front();
    for (std::size_t i = 2; i < facet.size(); ++i) {
      const Vector3<double> u = facet[i - 1] - facet.front(), v = facet[i] - facet.front();
      six_volumes += apex.dot(Vector3<double>(u.cross(v)));
    }
  }
  return std::isfinite(six_volumes) ? std::max(six_volumes, 0.0) / 6 : infinity;
}

/// The vertices of a prism's base, counter-clockwise: of a k-DOP whose normals have z = 0, such as
/// those of plane_dop_normals(). Rounded as kdop_facets().
/// @return nothing if the base is empty, without area or without an end, or as kdop_facets() for
/// NaN and for coordinates that may exceed 1e307
template <FloatOrDouble S>
std::vector<Vector2<double>> plane_dop_vertices(const Kdop<S>& dop) {
  // The top of the prism that two horizontal planes make of it, as high as it is wide.
  Kdop<double> body = detail::in_double(dop);
  double size = 0;
  for (std::size_t k = 0; k < body.normals.size(); ++k) {
    body.normals[k].z() = 0;
    for (const double end : {body.low[k], body.high[k]}) {
      if (std::isfinite(end)) size = std::max(size, std::abs(end));
    }
  }
  body.normals.push_back(Vector3<double>::UnitZ());
  body.low.push_back(0);
  body.high.push_back(size);
  std::vector<Vector2<double>> vertices;
  const double reach = detail::bound_on_length(body);
  if (!(size > 0) || detail::is_endless(reach) || detail::has_empty_slab(body)) return vertices;
  std::vector<Vector3<double>> top = detail::square_on({Vector3<double>::UnitZ(), 0}, 2 * reach);
  for (const detail::UnitHalfSpace& side : detail::half_spaces_of(body)) {
    if (side.normal.z() == 0) top = detail::clipped(top, side);
  }
  top = detail::cleaned(top, 0x1p-44 * reach);
  for (const Vector3<double>& v : top) vertices.push_back(v.head<2>());
  return vertices;
}

}  // namespace contact
