/// @file
/// The exact distance of two polytopes: the GJK algorithm (Gilbert, Johnson and Keerthi) without
/// rounding, started from the simplex that rounded GJK has found.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include <contact/exact.hpp>
#include <contact/exact_support.hpp>
#include <contact/plane.hpp>
#include <contact/sign_with_root.hpp>
#include <contact/support.hpp>
#include <contact/vector.hpp>

namespace contact {

/// A difference of two vertices: vertex a of A's core minus vertex b of B's, as indices.
struct DifferenceIndex {
  int a = 0;  ///< vertex of A
  int b = 0;  ///< vertex of B
  friend bool operator==(const DifferenceIndex&, const DifferenceIndex&) = default;
};

/// A difference of two vertices, without rounding.
struct ExactDifference {
  DifferenceIndex of;  ///< which vertices
  Vector3<Exact> w;    ///< m
};

/// The point of a simplex of differences that is closest to the origin, without division.
struct ExactClosest {
  int count = 0;                          ///< of its vertices: 1 to 4
  std::array<ExactDifference, 4> vertex;  ///< affinely independent
  std::array<Exact, 4> weights;           ///< λᵢ > 0; the point is Σ λᵢ wᵢ / Σ λᵢ
  Vector3<Exact> direction;  ///< V, a positive multiple of the point; 0 if that is the origin
  Exact offset;              ///< h = V · wᵢ, the same for each: the distance is h/|V|
};

namespace detail {

/// n divided by the magnitude of its largest coordinate, each rounded once; 0 for 0.
inline Vector3<double> rounded_direction(const Vector3<Exact>& n) {
  const Exact largest = std::max({abs(n.x()), abs(n.y()), abs(n.z())});
  if (largest.sign() == 0) return Vector3<double>::Zero();
  return {quotient<double>(n.x(), largest), quotient<double>(n.y(), largest),
          quotient<double>(n.z(), largest)};
}

// [exact-farthest]
/// A vertex of the core that is farthest along n, without rounding.
///
/// Of a hull of many vertices only those are compared exactly that rounding leaves in doubt. With m
/// = n / max |nₖ| rounded to double, a computed m · v is off by at most u Σ|mₖ vₖ| for the rounding
/// of m and γ(3) Σ|mₖ vₖ| for its own, Σ|mₖ vₖ| ≤ Σ|vₖ|; 8 u Σ|vₖ| + 2^-1000 is more than twice
/// half of that. So a vertex is not the farthest if its value is below the largest by more than the
/// sum of both bounds.
template <PolytopeCore Body>
int farthest_vertex(const Body& body, const Vector3<Exact>& n) {
  const int count = vertex_count(body);
  if (count <= 8) return exact_support_vertex(body, n);
  constexpr double u = std::numeric_limits<double>::epsilon() / 2;
  const Vector3<double> m = rounded_direction(n);
  const auto value = [&](int i) { return m.dot(vertex(body, i).template cast<double>()); };
  double best = -std::numeric_limits<double>::infinity(), size = 0;
  for (int i = 0; i < count; ++i) {
    best = std::max(best, value(i));
    size = std::max(size, double(vertex(body, i).template cast<double>().cwiseAbs().sum()));
  }
  const double least = best - (16 * u * size + 0x1p-1000 * (1 + size));
  int farthest = -1;
  Exact most;
  for (int i = 0; i < count; ++i) {
    if (value(i) < least) continue;  // false for NaN: then it is compared
    const Exact along = n.dot(exact_vertex(body, i));
    if (farthest < 0 || most < along) {
      most = along;
      farthest = i;
    }
  }
  return farthest;
}
// [/exact-farthest]

/// The exact difference of two vertices.
template <PolytopeCore A, PolytopeCore B>
ExactDifference exact_difference(const A& a, const B& b, const DifferenceIndex& of) {
  return {of, exact_vertex(a, of.a) - exact_vertex(b, of.b)};
}

/// A difference with the least n · w.
template <PolytopeCore A, PolytopeCore B>
ExactDifference min_difference(const A& a, const B& b, const Vector3<Exact>& n) {
  return exact_difference(a, b, {farthest_vertex(a, Vector3<Exact>(-n)), farthest_vertex(b, n)});
}

// [closest-of-simplex]
/// The point closest to the origin of the affine hull of one to four points, if it is a mean of
/// them with weights that are all positive; nothing otherwise, or if they are affinely dependent.
///
/// The weights are areas and volumes with the origin in the position of one point. For two points V
/// = d × (p × d) with d = q − p; for three V = ±(q − p) × (s − p); four contain the origin.
inline std::optional<ExactClosest> closest_inside(std::span<const ExactDifference> points) {
  ExactClosest c;
  c.count = static_cast<int>(points.size());
  std::copy(points.begin(), points.end(), c.vertex.begin());
  const auto positive = [&c](int sign) {
    return std::all_of(c.weights.begin(), c.weights.begin() + c.count,
                       [sign](const Exact& x) { return x.sign() == sign; });
  };
  const Vector3<Exact>& p = points[0].w;
  if (c.count == 1) {
    c.weights[0] = Exact(1);
    c.direction = p;
  } else if (c.count == 2) {
    const Vector3<Exact>& q = points[1].w;
    const Vector3<Exact> d = q - p;
    c.weights = {q.dot(d), -p.dot(d), Exact(), Exact()};
    if (!positive(1)) return std::nullopt;
    c.direction = d.cross(Vector3<Exact>(p.cross(d)));
  } else if (c.count == 3) {
    const Vector3<Exact>& q = points[1].w;
    const Vector3<Exact>& s = points[2].w;
    const Vector3<Exact> n = Vector3<Exact>(q - p).cross(Vector3<Exact>(s - p));
    c.weights = {n.dot(Vector3<Exact>(q.cross(s))), n.dot(Vector3<Exact>(s.cross(p))),
                 n.dot(Vector3<Exact>(p.cross(q))), Exact()};
    if (!positive(1)) return std::nullopt;
    const int side = n.dot(p).sign();
    c.direction = n * Exact(side);
  } else {
    const Vector3<Exact>& q = points[1].w;
    const Vector3<Exact> st = points[2].w.cross(points[3].w), pq = p.cross(q);
    c.weights = {q.dot(st), -p.dot(st), pq.dot(points[3].w), -pq.dot(points[2].w)};
    if (positive(-1)) {
      for (Exact& weight : c.weights) weight = -weight;
    }
    if (!positive(1)) return std::nullopt;
    c.direction = Vector3<Exact>::Zero();
  }
  c.offset = c.direction.dot(p);
  return c;
}
// [/closest-of-simplex]

/// Whether no difference of the list is closer to the origin along V than the point.
inline bool is_closest_of(const ExactClosest& c, std::span<const ExactDifference> points) {
  return std::none_of(points.begin(), points.end(),
                      [&c](const ExactDifference& x) { return c.direction.dot(x.w) < c.offset; });
}

// [closest-of-hull]
/// The point of the hull of one to four points that is closest to the origin, as that of a simplex
/// of them: all subsets are tried, the whole set first.
///
/// There is one: the closest point v is in the relative interior of a face of the hull, by
/// Carathéodory's theorem in that of an affinely independent subset of its vertices, which has v as
/// the closest point of its affine hull; and v · w ≥ v · v for all w.
inline ExactClosest closest_of_hull(std::span<const ExactDifference> points) {
  const unsigned all = (1U << points.size()) - 1;
  for (unsigned subset = all; subset > 0; --subset) {
    std::vector<ExactDifference> chosen;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (((subset >> i) & 1U) != 0) chosen.push_back(points[i]);
    }
    const std::optional<ExactClosest> c = closest_inside(chosen);
    if (c && is_closest_of(*c, points)) return *c;
  }
  return {};  // not reached
}
// [/closest-of-hull]

}  // namespace detail

/// The direction from B's core to A's of the closest points, its largest coordinate ±1, each
/// coordinate rounded once: however close the cores are. 0 if they meet.
inline Vector3<double> rounded_direction(const ExactClosest& closest) {
  return detail::rounded_direction(closest.direction);
}

/// The closest difference of two points of the cores, from B to A, each coordinate rounded once, m:
/// h V/V². 0 if the cores meet; subnormal coordinates lose digits, which rounded_direction() keeps.
inline Vector3<double> rounded_difference(const ExactClosest& closest) {
  const Vector3<Exact>& v = closest.direction;
  const Exact squared = v.dot(v);
  if (squared.sign() == 0) return Vector3<double>::Zero();
  const auto coordinate = [&](int i) { return quotient<double>(closest.offset * v(i), squared); };
  return {coordinate(0), coordinate(1), coordinate(2)};
}

/// The distance of the cores, h/|V|, to two roundings, m.
inline double rounded_distance(const ExactClosest& closest) {
  if (detail::is_zero(closest.direction)) return 0;
  return detail::root_of_quotient(closest.offset * closest.offset,
                                  closest.direction.dot(closest.direction));
}

// [exact-gjk]
/// The point closest to the origin of all differences of two cores, and so their distance, without
/// rounding.
///
/// The closest point v of a simplex is that of all differences if v · w ≥ v · v for each, by
/// convexity. Otherwise the difference w with the least v · w is added: then the point v + t (w −
/// v) is closer for small t > 0. So the distance falls strictly from simplex to simplex, none comes
/// twice, and as there are finitely many the search ends. From a good start it takes one step.
///
/// Limits: memory only; any finite numbers.
/// @param a, b as is_convex_body() requires; their radii are not used
/// @param start at most four differences; any, also none
/// @see Gilbert, Johnson and Keerthi, *A Fast Procedure for Computing the Distance Between Complex
/// Objects in Three-Dimensional Space*, IEEE Journal on Robotics and Automation 4 (1988)
template <PolytopeCore A, PolytopeCore B>
ExactClosest exact_gjk(const A& a, const B& b, std::span<const DifferenceIndex> start = {}) {
  std::vector<ExactDifference> points;
  for (const DifferenceIndex& of : start.first(std::min<std::size_t>(start.size(), 4))) {
    points.push_back(detail::exact_difference(a, b, of));
  }
  if (points.empty()) points.push_back(detail::exact_difference(a, b, {0, 0}));
  for (;;) {
    const ExactClosest c = detail::closest_of_hull(points);
    if (detail::is_zero(c.direction)) return c;
    const ExactDifference w = detail::min_difference(a, b, c.direction);
    if (c.direction.dot(w.w) >= c.offset) return c;
    points.assign(c.vertex.begin(), c.vertex.begin() + c.count);
    points.push_back(w);
  }
}
// [/exact-gjk]

}  // namespace contact
