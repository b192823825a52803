/// @file
/// Touching or overlapping: for two polytopes that meet, either a plane that has them on its two
/// sides, or differences of their vertices that surround the origin.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <contact/certificates.hpp>
#include <contact/exact.hpp>
#include <contact/exact_gjk.hpp>
#include <contact/support.hpp>
#include <contact/vector.hpp>

namespace contact {

/// What two polytopes that meet have: a plane between them or differences around the origin.
struct PlaneOrSurrounding {
  /// n ≠ 0 with n · w ≥ 0 for all differences w: they touch. 0: there is none.
  Vector3<Exact> normal;
  /// Without such n, 4 to 6 differences whose hull has the origin as an interior point.
  std::vector<ExactDifference> surrounding;
  int steps = 0;  ///< how many normals were tried
};

namespace detail {

// [supporting-normals]
/// All n ≠ 0 with n · w ≥ 0 for each of some points w, given by the edges of their cone.
///
/// If the points span space, the cone is pointed, or 0 alone, and each of its edges is
/// perpendicular to two independent points: ±wᵢ × wⱼ. If they span a plane, both ±wᵢ × wⱼ are
/// perpendicular to all of them; if they span less, so is any vector perpendicular to the line. So
/// there is such an n if and only if one of these satisfies n · w ≥ 0 for all w. The list holds
/// those that do.
///
/// Three or more edges are those of a cone with interior points. Such a cone is the intersection of
/// the half-spaces of its faces, each with two of the edges: points that are perpendicular to none
/// are left out.
class SupportingNormals {
 public:
  /// Adds a point: normals that violate it are dropped, and those perpendicular to it tried.
  void add(const ExactDifference& point) {
    points_.push_back(point);
    if (span_plane_) {
      std::erase_if(edges_, [&](const Vector3<Exact>& n) { return n.dot(point.w).sign() < 0; });
      try_pairs(points_.size() - 1);
      if (edges_.size() >= 3) leave_out_unneeded();
      return;
    }
    edges_.clear();
    for (std::size_t j = 1; j < points_.size(); ++j) try_pairs(j);
    if (!span_plane_) edges_.push_back(perpendicular_to_line());
  }

  /// Whether no n is left: then the hull of the points has the origin as an interior point, because
  /// otherwise a plane through the origin would have all of them on one side.
  bool empty() const { return edges_.empty(); }

  /// The points that are needed: the normals are those that satisfy them.
  const std::vector<ExactDifference>& points() const { return points_; }

  /// An n of the cone, well inside it: the sum of its edges, each divided by a power of two close
  /// to its length. The first edge if that is 0, or a length is out of a double's range.
  Vector3<Exact> middle() const {
    Vector3<Exact> sum = Vector3<Exact>::Zero();
    for (const Vector3<Exact>& n : edges_) {
      const double size = rounded<double>(std::max({abs(n.x()), abs(n.y()), abs(n.z())}));
      if (!(size > 0x1p-1000 && size < 0x1p1000)) return edges_.front();
      sum += n * Exact(std::ldexp(1.0, -std::ilogb(size)));
    }
    return is_zero(sum) ? edges_.front() : sum;
  }

 private:
  std::vector<ExactDifference> points_;
  std::vector<Vector3<Exact>> edges_;
  bool span_plane_ = false;  // whether two of the points are independent

  void try_pairs(std::size_t j) {
    for (std::size_t i = 0; i < j; ++i) {
      const Vector3<Exact> n = points_[i].w.cross(points_[j].w);
      if (is_zero(n)) continue;
      span_plane_ = true;
      try_edge(n);
      try_edge(Vector3<Exact>(-n));
    }
  }
  void try_edge(const Vector3<Exact>& n) {
    for (const ExactDifference& point : points_) {
      if (n.dot(point.w).sign() < 0) return;
    }
    for (const Vector3<Exact>& known : edges_) {
      if (n.dot(known).sign() > 0 && is_zero(n.cross(known))) return;
    }
    edges_.push_back(n);
  }
  void leave_out_unneeded() {
    std::erase_if(points_, [this](const ExactDifference& point) {
      return std::none_of(edges_.begin(), edges_.end(),
                          [&point](const Vector3<Exact>& n) { return n.dot(point.w).sign() == 0; });
    });
  }
  Vector3<Exact> perpendicular_to_line() const {
    for (const ExactDifference& point : points_) {
      const Vector3<Exact>& w = point.w;
      if (w.x().sign() != 0 || w.y().sign() != 0) return {-w.y(), w.x(), Exact()};
      if (w.z().sign() != 0) break;
    }
    return {Exact(1), Exact(), Exact()};
  }
};
// [/supporting-normals]

/// Points that surround the origin, without those that are not needed: at most six remain, because
/// a set from which none can be left out has at most 2 · 3 points (Steinitz).
inline std::vector<ExactDifference> fewest_surrounding(std::vector<ExactDifference> points) {
  const std::size_t count = points.size();
  std::vector<std::int8_t> signs(count * count * count, 0);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 1; j < count; ++j) {
      const Vector3<Exact> n = points[i].w.cross(points[j].w);
      for (std::size_t k = j + 1; k < count; ++k) {
        const auto sign = static_cast<std::int8_t>(n.dot(points[k].w).sign());
        signs[(i * count + j) * count + k] = sign;
        signs[(i * count + k) * count + j] = static_cast<std::int8_t>(-sign);
        signs[(j * count + k) * count + i] = sign;
      }
    }
  }
  std::vector<std::size_t> kept(count);
  for (std::size_t i = 0; i < count; ++i) kept[i] = i;
  for (std::size_t i = count; i-- > 0;) {
    std::vector<std::size_t> fewer = kept;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
    // surrounds_origin() asks for i < j only.
    const auto sign = [&](std::size_t p, std::size_t q, std::size_t r) {
      return int{signs[(fewer[p] * count + fewer[q]) * count + fewer[r]]};
    };
    if (surrounds_origin(fewer.size(), sign)) kept = std::move(fewer);
  }
  std::vector<ExactDifference> few;
  for (const std::size_t i : kept) few.push_back(points[i]);
  return few;
}

}  // namespace detail

// [plane-or-surrounding]
/// For two cores that meet: a plane that has A in front of it or on it and B behind it or on it, if
/// there is one, and otherwise differences of their vertices around the origin, which prove that
/// there is none.
///
/// A set S of differences is kept, and a normal n that satisfies n · w ≥ 0 on S. The difference
/// with the least n · w decides: if it is not negative, n satisfies all of them and separates the
/// cores weakly; otherwise it joins S. Then the set of normals that satisfy S has lost n, so no S
/// comes twice; and there are finitely many, so the search ends.
/// @param a, b as is_convex_body() requires; their radii are not used
/// @param start some differences: best a simplex that contains the origin, which n must be
/// perpendicular to
template <PolytopeCore A, PolytopeCore B>
PlaneOrSurrounding plane_or_surrounding(const A& a, const B& b,
                                        std::span<const ExactDifference> start) {
  PlaneOrSurrounding found;
  detail::SupportingNormals normals;
  if (start.empty()) normals.add(detail::exact_difference(a, b, {0, 0}));
  for (const ExactDifference& point : start) normals.add(point);
  while (!normals.empty()) {
    const Vector3<Exact> n = normals.middle();
    const ExactDifference w = detail::min_difference(a, b, n);
    ++found.steps;
    if (n.dot(w.w).sign() >= 0) {
      found.normal = n;
      return found;
    }
    normals.add(w);
  }
  found.surrounding = detail::fewest_surrounding(normals.points());
  return found;
}
// [/plane-or-surrounding]

}  // namespace contact
