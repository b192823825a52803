/// @file
/// The point of a simplex of at most four vertices that is closest to the origin: the step from
/// which GJK is made, in floating point and without error.
#pragma once

#include <array>
#include <cmath>
#include <concepts>
#include <contact/exact.hpp>
#include <contact/exact_ray_triangle.hpp>
#include <contact/products.hpp>
#include <contact/running_error.hpp>
#include <contact/support.hpp>
#include <contact/vector.hpp>
#include <cstddef>

namespace contact {

/// Up to four points; how many of them count is said beside it.
template <Ring S>
using FourPoints = std::array<Vector3<S>, 4>;

/// Which of four vertices belong to a set: bit i for vertex i.
using VertexSet = unsigned;

/// The point of a simplex that is closest to the origin.
template <Ring S>
struct SimplexPoint {
  Vector3<S> point = Vector3<S>::Zero();  ///< m; 0 if the origin is inside a tetrahedron
  std::array<S, 4> weights{};  ///< of the vertices, not negative, of sum 1; 0 outside `face`
  VertexSet face = 0;  ///< the vertices of the smallest face with the point, whose weights are > 0
};

namespace gjk_detail {

using detail::dot3;

/// x + s y, x − y and s x, written out as dot3().
template <Ring S>
Vector3<S> plus(const Vector3<S>& x, const S& s, const Vector3<S>& y) {
  return {x[0] + s * y[0], x[1] + s * y[1], x[2] + s * y[2]};
}
template <Ring S>
Vector3<S> minus(const Vector3<S>& x, const Vector3<S>& y) {
  return {x[0] - y[0], x[1] - y[1], x[2] - y[2]};
}
template <Ring S>
Vector3<S> times(const S& s, const Vector3<S>& x) {
  return {s * x[0], s * x[1], s * x[2]};
}

/// The smaller of two candidates: that with the closer point.
template <FloatOrDouble S>
const SimplexPoint<S>& closer(const SimplexPoint<S>& p, const SimplexPoint<S>& q) {
  return dot3(q.point, q.point) < dot3(p.point, p.point) ? q : p;
}

template <FloatOrDouble S>
SimplexPoint<S> vertex_point(const FourPoints<S>& w, std::size_t i) {
  SimplexPoint<S> found{w[i], {}, 1U << i};
  found.weights[i] = S(1);
  return found;
}

// [closest-on-edge]
/// The point of the edge from vertex i to vertex j that is closest to the origin.
///
/// w + t A cancels where the point is much closer to the origin than the vertices are. Then A × (wᵢ
/// × wⱼ)/|A|² is the same point, and accurate to a few u of its own length, because each product of
/// the inner cross product keeps its rounding error.
template <FloatOrDouble S>
SimplexPoint<S> closest_on_edge(const FourPoints<S>& w, std::size_t i, std::size_t j) {
  const Vector3<S> edge = minus(w[j], w[i]);
  const S along = -dot3(w[i], edge), whole = dot3(edge, edge);
  if (!(along > S(0))) return vertex_point(w, i);
  if (!(along < whole)) return vertex_point(w, j);
  const S t = along / whole;
  SimplexPoint<S> found{plus(w[i], t, edge), {}, 1U << i | 1U << j};
  found.weights[i] = S(1) - t;
  found.weights[j] = t;
  if (dot3(found.point, found.point) * S(64) < dot3(w[i], w[i])) {
    const Vector3<S>&p = w[i], &q = w[j];
    const Vector3<S> moment(difference_of_products<S>(p.y(), q.z(), p.z(), q.y()),
                            difference_of_products<S>(p.z(), q.x(), p.x(), q.z()),
                            difference_of_products<S>(p.x(), q.y(), p.y(), q.x()));
    found.point = cross_plain(edge, moment) / whole;
  }
  return found;
}
// [/closest-on-edge]

// [closest-on-triangle]
/// The point of the triangle of vertices i, j and k that is closest to the origin: in its interior
/// if the three weights are positive, else on an edge whose weight opposite to it is not.
///
/// In the interior the point is N (N · w)/|N|², so its direction is as accurate as the normal N,
/// however close to the origin it is.
template <FloatOrDouble S>
SimplexPoint<S> closest_on_triangle(const FourPoints<S>& w, std::size_t i, std::size_t j,
                                    std::size_t k) {
  const Vector3<S> to_j = minus(w[j], w[i]), to_k = minus(w[k], w[i]);
  const Vector3<S> normal = cross_plain(to_j, to_k), moment = cross_plain(normal, w[i]);
  const S whole = dot3(normal, normal);
  const S of_j = -dot3(moment, to_k), of_k = dot3(moment, to_j), of_i = whole - of_j - of_k;
  if (of_i > S(0) && of_j > S(0) && of_k > S(0)) {
    SimplexPoint<S> found{
        times<S>(dot3(normal, w[i]) / whole, normal), {}, 1U << i | 1U << j | 1U << k};
    const S share = S(1) / whole;
    found.weights[i] = of_i * share;
    found.weights[j] = of_j * share;
    found.weights[k] = of_k * share;
    return found;
  }
  const bool degenerate = !(whole > S(0));
  SimplexPoint<S> best;
  const auto consider = [&best, &w](std::size_t p, std::size_t q) {
    const SimplexPoint<S> found = closest_on_edge(w, p, q);
    best = best.face == 0 ? found : closer(best, found);
  };
  if (degenerate || !(of_k > S(0))) consider(i, j);
  if (degenerate || !(of_j > S(0))) consider(i, k);
  if (degenerate || !(of_i > S(0))) consider(j, k);
  return best;
}
// [/closest-on-triangle]

// [closest-on-tetrahedron]
/// The point of a tetrahedron that is closest to the origin: the origin itself if the four weights
/// are positive, else on a face whose weight opposite to it is not. The closest point is always on
/// such a face: the vector to the origin is a sum of multiples ≥ 0 of the outer normals of the
/// faces with the point, so the origin is outside at least one of these.
template <FloatOrDouble S>
SimplexPoint<S> closest_on_tetrahedron(const FourPoints<S>& w) {
  const Vector3<S> a = minus(w[0], w[3]), b = minus(w[1], w[3]), c = minus(w[2], w[3]);
  const Vector3<S> bc = cross_plain(b, c);
  const S volume = dot3(a, bc), sign = volume < S(0) ? S(1) : S(-1), whole = -volume * sign;
  const S of_a = dot3(w[3], bc) * sign, of_b = dot3(w[3], cross_plain(c, a)) * sign,
          of_c = dot3(w[3], cross_plain(a, b)) * sign, of_d = whole - of_a - of_b - of_c;
  if (of_a > S(0) && of_b > S(0) && of_c > S(0) && of_d > S(0)) {
    return {Vector3<S>::Zero(), {of_a / whole, of_b / whole, of_c / whole, of_d / whole}, 15U};
  }
  const bool degenerate = !(whole > S(0));
  SimplexPoint<S> best;
  const auto consider = [&best, &w](std::size_t i, std::size_t j, std::size_t k) {
    const SimplexPoint<S> found = closest_on_triangle(w, i, j, k);
    best = best.face == 0 ? found : closer(best, found);
  };
  if (degenerate || !(of_c > S(0))) consider(3, 0, 1);
  if (degenerate || !(of_a > S(0))) consider(3, 1, 2);
  if (degenerate || !(of_b > S(0))) consider(3, 2, 0);
  if (degenerate || !(of_d > S(0))) consider(0, 1, 2);
  return best;
}
// [/closest-on-tetrahedron]

}  // namespace gjk_detail

// [closest-of-simplex]
/// The point closest to the origin of the hull of up to four points, in floating point.
///
/// Limits: rounded. Where the points are fat (no sine of an angle is small), the point is off by a
/// few u of the largest coordinate. In a thin triangle or a flat tetrahedron it can be any point:
/// the weights are wrong by u over the square of the sine. Check it: |Σ weights w| is at least the
/// distance up to rounding. Products of four coordinates must neither over- nor underflow; if they
/// do, faces are left out.
/// @param w points, m; the first `count` count
/// @param count from 1 to 4
template <FloatOrDouble S>
SimplexPoint<S> closest_of_simplex(const FourPoints<S>& w, int count) {
  if (count == 1) return gjk_detail::vertex_point(w, 0);
  if (count == 2) return gjk_detail::closest_on_edge(w, 1, 0);
  if (count == 3) return gjk_detail::closest_on_triangle(w, 2, 0, 1);
  return gjk_detail::closest_on_tetrahedron(w);
}
// [/closest-of-simplex]

namespace gjk_detail {

/// The points of a simplex in a number type, for exact decisions.
template <class T>
class SimplexTerms {
 public:
  SimplexTerms(const FourPoints<double>& w, int count) : count_(static_cast<std::size_t>(count)) {
    for (std::size_t i = 0; i < count_; ++i) w_[i] = detail::triple<T>(w[i]);
  }
  SimplexTerms(const std::array<detail::Triple<T>, 4>& w, int count)
      : w_(w), count_(static_cast<std::size_t>(count)) {}

  /// A multiple > 0 of the point closest to the origin of the affine hull of a face, the numerators
  /// of its weights, and their common denominator.
  struct Foot {
    detail::Triple<T> direction;  ///< whole times the point, or 0
    std::array<T, 4> weights{};
    T whole;
  };

  // [foot]
  /// That of a face of one, two or three vertices; of four, whose direction is 0, only the weights.
  Foot foot(VertexSet face) const {
    std::array<std::size_t, 4> at{};
    std::size_t size = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      if ((face >> i & 1U) != 0) at[size++] = i;
    }
    const detail::Triple<T>& w = w_[at[0]];
    Foot found{w, {}, T(1.0)};
    found.weights[at[0]] = T(1.0);
    if (size == 1) return found;
    const detail::Triple<T> a = detail::minus(w_[at[1]], w);
    if (size == 2) {
      found.whole = detail::dot(a, a);
      found.weights[at[1]] = -detail::dot(w, a);
      found.direction = detail::cross(a, detail::cross(w, a));
    } else if (size == 3) {
      const detail::Triple<T> b = detail::minus(w_[at[2]], w), n = detail::cross(a, b);
      const detail::Triple<T> moment = detail::cross(n, w);
      const T height = detail::dot(n, w);
      found.whole = detail::dot(n, n);
      found.weights[at[1]] = -detail::dot(moment, b);
      found.weights[at[2]] = detail::dot(moment, a);
      found.direction = {n[0] * height, n[1] * height, n[2] * height};
    } else {
      const detail::Triple<T> b = detail::minus(w_[at[2]], w), c = detail::minus(w_[at[3]], w);
      const detail::Triple<T> bc = detail::cross(b, c);
      const T volume = detail::dot(a, bc);
      found.whole = volume * volume;
      found.weights[at[1]] = -detail::dot(w, bc) * volume;
      found.weights[at[2]] = -detail::dot(w, detail::cross(c, a)) * volume;
      found.weights[at[3]] = -detail::dot(w, detail::cross(a, b)) * volume;
      found.direction = {T(0.0), T(0.0), T(0.0)};
    }
    T rest = found.whole;
    for (std::size_t i = 1; i < size; ++i) rest = rest - found.weights[at[i]];
    found.weights[at[0]] = rest;
    return found;
  }
  // [/foot]

  // [decide-face]
  /// Whether the closest point of the simplex is in the interior of a face: its weights are
  /// positive, and no vertex is beyond the plane through it. 1 or −1 if that is certain, else 0.
  int decide(VertexSet face) const {
    bool sure = true;
    const Foot at = foot(face);
    const auto sign_of = [&sure](const T& x) { return detail::sign_of(x, sure); };
    if (sign_of(at.whole) <= 0) return sure ? -1 : 0;
    std::size_t inside = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      if ((face >> i & 1U) == 0) continue;
      inside = i;
      bool certain = true;
      const int sign = detail::sign_of(at.weights[i], certain);
      if (certain && sign <= 0) return -1;
      sure = sure && certain;
    }
    for (std::size_t i = 0; i < count_; ++i) {
      if ((face >> i & 1U) != 0) continue;
      bool certain = true;
      const T beyond = detail::dot(at.direction, detail::minus(w_[i], w_[inside]));
      if (detail::sign_of(beyond, certain) < 0 && certain) return -1;
      sure = sure && certain;
    }
    return sure ? 1 : 0;
  }
  // [/decide-face]

 private:
  std::array<detail::Triple<T>, 4> w_;
  std::size_t count_;
};

/// The faces of four vertices, small ones first: they cost less to decide.
inline constexpr std::array<VertexSet, 15> faces{1, 2, 4, 8, 3, 5, 6, 9, 10, 12, 7, 11, 13, 14, 15};

}  // namespace gjk_detail

// [closest-exactly]
/// The point closest to the origin of the hull of up to four points: the face is decided without
/// error, and each coordinate and weight is rounded once.
///
/// Exactly one point of the hull is closest. The first face is taken that has it in its interior
/// and whose vertices are affinely independent; there is one, because a point of a hull is in the
/// interior of the hull of independent ones (Carathéodory). So of degenerate points no face is
/// missed.
/// @param w points, finite, m; the first `count` count
/// @param count from 1 to 4
template <FloatOrDouble S>
SimplexPoint<S> closest_of_simplex_exactly(const FourPoints<S>& w, int count) {
  FourPoints<double> points;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    points[i] = w[i].template cast<double>();
  }
  const gjk_detail::SimplexTerms<RunningError> bounded(points, count);
  const gjk_detail::SimplexTerms<Exact> exact(points, count);
  for (const VertexSet face : gjk_detail::faces) {
    if (face >= 1U << count) continue;
    int decision = bounded.decide(face);
    if (decision == 0) decision = exact.decide(face);
    if (decision < 0) continue;
    const auto foot = exact.foot(face);
    SimplexPoint<S> found;
    found.face = face;
    for (std::size_t i = 0; i < 3; ++i) {
      found.point(static_cast<int>(i)) = quotient<S>(foot.direction[i], foot.whole);
    }
    for (std::size_t i = 0; i < 4; ++i) {
      if ((face >> i & 1U) != 0) found.weights[i] = quotient<S>(foot.weights[i], foot.whole);
    }
    return found;
  }
  return gjk_detail::vertex_point(w, 0);  // not reached for finite points
}
// [/closest-exactly]

}  // namespace contact
