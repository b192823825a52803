/// @file
/// Ray and segment against every triangle of a mesh: the first hit, any hit, all hits. Decisions
/// and the order of hits are exact.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <contact/error_free.hpp>
#include <contact/exact.hpp>
#include <contact/exact_ray_triangle.hpp>
#include <contact/filter.hpp>
#include <contact/mesh.hpp>
#include <contact/mesh_times.hpp>
#include <contact/passage.hpp>
#include <contact/ray_triangle.hpp>
#include <contact/shapes.hpp>
#include <contact/vector.hpp>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace contact {

// [mesh-hit]
/// What of a triangle a line meets.
enum class MeshFeature { face, edge, vertex };

/// A point in which a line meets a mesh.
///
/// If several triangles have this point, the one with the lowest index is named: at an edge, at a
/// vertex, or where parts of the mesh touch, cross or coincide.
template <Ring S>
struct MeshHit {
  int triangle = -1;  ///< index in the mesh
  /// t within 2^-40 max(1, |t|) of the exact one, and in its range; weights within 2^-30, from 0 to
  /// 1, and 0 wherever the exact one is 0. Float: rounded once more. A ray's t may be beyond the
  /// largest number of S; then it is infinite.
  TriangleHit<S> hit;
  /// m. At a vertex the stored vertex; else origin + t direction as rounded, moved into the
  /// bounding box of the triangle.
  Vector3<S> point = Vector3<S>::Zero();
  MeshFeature feature = MeshFeature::face;  ///< of the named triangle; exact
  /// The vertices of the edge in increasing order, or the vertex and −1; −1 twice for a face.
  std::array<int, 2> feature_vertices{-1, -1};
};
// [/mesh-hit]

namespace detail {

// [mesh-line]
/// A line prepared for many triangles: for most of them double decides, with one bound for all
/// determinants of a triangle.
template <class Line>
class MeshLine {
 public:
  explicit MeshLine(const Line& line)
      : line_(line), start_(start_of(line)), direction_(ray_of(line).direction) {
    meets_any_ = is_finite(line) && !is_point(line);
    size_ = sum_of_sizes(direction_);
  }

  /// Whether it can meet anything: finite, with a direction.
  bool meets_any() const { return meets_any_; }
  const Line& line() const { return line_; }

  /// Whether the line meets a triangle, exactly; the index is left to the caller.
  ///
  /// With r = a − start and q = direction × r, of_c = ab·q, of_b = −ac·q, denominator = direction·n
  /// and start = r·n with n = ab × ac; of_a is the rest of the denominator. As in bounded_volume
  /// each of the six terms of a determinant has at most eight roundings, and the terms' magnitudes
  /// sum to at most the product of the 1-norms of its three rows. These are rounded too, six times
  /// each at most: 12 u covers 8 u/(1 − 8u) and that. of_a adds the errors of three determinants
  /// and two roundings of numbers that are at most the same products: 16 u.
  ///
  /// Underflow of a product of two is at most 2^-1074, and is multiplied by the third row: far
  /// below 2^-1000 times 1 + that row. The products of the norms are formed in an order for which
  /// the same holds. Only if all products are below 2^1000, so that nothing overflows, they are
  /// used.
  std::optional<MeshMeeting> meet(const Triangle<double>& triangle) const {
    const Vector3<double> ab = triangle.b - triangle.a, ac = triangle.c - triangle.a;
    const Vector3<double> r = triangle.a - start_;
    const Vector3<double> q = cross_of(direction_, r);
    const Vector3<double> n = cross_of(ab, ac);
    const double of_c = dot_of(ab, q), of_b = -dot_of(ac, q);
    const double denominator = dot_of(direction_, n);
    const double of_a = denominator - of_b - of_c;
    const double edges = std::max(sum_of_sizes(ab), sum_of_sizes(ac));
    const double far = sum_of_sizes(r);
    const double squares = (edges + far) * (edges + far + size_);
    if (!(squares < 0x1p1000 && edges * squares < 0x1p1000)) return meet_closely(triangle);
    const double room =
        16 * mesh_u * (edges * (size_ * (edges + 2 * far))) + 0x1p-1000 * (1 + edges + size_);
    const double least = std::min(std::min(of_a, of_b), of_c);
    const double most = std::max(std::max(of_a, of_b), of_c);
    if (least < -room && most > room) return std::nullopt;

    // Inside all edges or outside all, and far enough from parallel: t with its bound.
    if (least > room || most < -room) {
      const double above = dot_of(r, n);
      const double above_room =
          16 * mesh_u * (far * (edges * edges)) + 0x1p-1000 * (1 + edges + far);
      // The denominator's own, which does not grow with the distance of the start.
      const double below_room =
          16 * mesh_u * (size_ * (edges * edges)) + 0x1p-1000 * (1 + edges + size_);
      const double sign = denominator < 0 ? -1 : 1;
      if (sign * above < -above_room) return std::nullopt;
      const bool starts = sign * above > above_room;
      const double beyond = sign * (above - denominator);
      if (has_end<Line> && beyond > above_room + below_room) return std::nullopt;
      const bool ends = !has_end<Line> || beyond < -(above_room + below_room);
      if (starts && ends) {
        const double t = above / denominator;
        const double error = (above_room + t * below_room) / (std::abs(denominator) - below_room);
        return MeshMeeting{-1, t, 2 * error + 8 * mesh_u * t + 0x1p-1000};
      }
    }
    return meet_closely(triangle);
  }

 private:
  Line line_;
  Vector3<double> start_, direction_;
  double size_ = 0;
  bool meets_any_ = false;
  /// A vertex that is exactly on the line, once one was met: the fan around it needs exact
  /// arithmetic only once.
  mutable std::optional<Vector3<double>> on_line_;

  static double dot_of(const Vector3<double>& x, const Vector3<double>& y) {
    return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
  }
  static Vector3<double> cross_of(const Vector3<double>& x, const Vector3<double>& y) {
    return {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
  }

  /// Decides in doubt: as ExactQuery does, and with the same signs it says which weights are 0.
  [[gnu::noinline]] std::optional<MeshMeeting> meet_closely(
      const Triangle<double>& triangle) const {
    if (!all_finite(triangle.a) || !all_finite(triangle.b) || !all_finite(triangle.c)) {
      return std::nullopt;
    }
    const LineAndTriangle<double> x = differences_of<double>(line_, triangle);
    std::optional<LineAndTriangle<Exact>> exact;
    const auto exactly = [&](Determinant which) {
      if (!exact) exact = differences_of<Exact>(line_, triangle);
      return exact_determinant(*exact, which);
    };
    const auto sign = [&](Determinant which) {
      const int certain = evaluate(x, which, bounded_volume).certain_sign();
      if (certain != 0) return certain;
      const std::optional<int> quick = quick_sign(line_, triangle, which);
      return quick ? *quick : exactly(which).sign();
    };
    MeshMeeting met;
    int side = 0;
    constexpr std::array edges{Determinant::of_a, Determinant::of_b, Determinant::of_c};
    const std::array<const Vector3<double>*, 3> vertices{&triangle.a, &triangle.b, &triangle.c};
    const auto on_line = [&](std::size_t k) { return on_line_ && *on_line_ == *vertices[k]; };
    for (std::size_t k = 0; k < 3; ++k) {
      // An edge from a vertex on the line has no volume with the line.
      const bool touches = on_line((k + 1) % 3) || on_line((k + 2) % 3);
      const int s = touches ? 0 : sign(edges[k]);
      if (s * side < 0) return std::nullopt;
      if (s != 0) side = s;
      met.zero[k] = s == 0;
    }
    if (side == 0) return std::nullopt;
    for (std::size_t k = 0; k < 3; ++k) {
      if (met.zero[(k + 1) % 3] && met.zero[(k + 2) % 3]) on_line_ = *vertices[k];
    }
    if (sign(Determinant::start) * side < 0) return std::nullopt;
    if (has_end<Line> && sign(Determinant::end) * side > 0) return std::nullopt;

    const Bounded above = evaluate(x, Determinant::start, bounded_volume);
    const Bounded below = evaluate(x, Determinant::denominator, bounded_volume);
    met.t = above.value / below.value;
    const double least = std::abs(below.value) - below.bound;
    if (least > 0 && std::isfinite(met.t)) {
      const double error = (above.bound + std::abs(met.t) * below.bound) / least;
      met.bound = 2 * error + 8 * mesh_u * std::abs(met.t) + 0x1p-1000;
    } else {
      met.t = quotient<double>(exactly(Determinant::start), exactly(Determinant::denominator));
      met.bound = 8 * mesh_u * met.t + 0x1p-1000;
    }
    return met;
  }
};
// [/mesh-line]

// [mesh-feature]
/// Sets the feature: the line meets a face if none of the three weights is exactly 0, an edge if
/// one is, a vertex if two are. Weights that are 0 become 0.
/// @param zero which weights are exactly 0
template <FloatOrDouble S>
void name_feature(MeshHit<S>& answer, const std::array<bool, 3>& zero, const Triangle<S>& triangle,
                  const std::array<int, 3>& vertices) {
  const std::array<const Vector3<S>*, 3> corners{&triangle.a, &triangle.b, &triangle.c};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3, last = (k + 2) % 3;
    if (zero[k]) answer.hit.barycentric[int(k)] = S(0);
    if (zero[next] && zero[last]) {
      answer.feature = MeshFeature::vertex;
      answer.feature_vertices = {vertices[k], -1};
      answer.point = *corners[k];
      answer.hit.barycentric = Vector3<S>::Unit(int(k));
      return;
    }
    if (zero[k] && !zero[next] && !zero[last]) {
      answer.feature = MeshFeature::edge;
      answer.feature_vertices = {std::min(vertices[next], vertices[last]),
                                 std::max(vertices[next], vertices[last])};
    }
  }
}
// [/mesh-feature]

/// numerator/denominator, which is between 0 and `high`, if it is certain to within `room`.
inline std::optional<double> certain_ratio(const Bounded& numerator, const Bounded& denominator,
                                           double high, double room) {
  const double value = numerator.value / denominator.value;
  const double error = numerator.bound + std::abs(value) * denominator.bound;
  const double least = std::abs(denominator.value) - denominator.bound;
  if (!(error < room / 2 * least * std::max(1.0, std::abs(value)))) return std::nullopt;
  return std::clamp(value, 0.0, high) + 0.0;  // not −0
}

/// a − (start + t direction), to within 3 u of itself and 8 u² (|a − start| + |t direction|) in
/// each coordinate, and 2^-1072 where a product underflows: differences and product are taken with
/// their errors, so that neither the position of a distant start nor the direction of a segment is
/// rounded.
template <class Line>
Vector3<double> vertex_from_line(const Line& line, const Vector3<double>& a, double t) {
  Vector3<double> r;
  for (int k = 0; k < 3; ++k) {
    const WithError<double> apart = two_sum(a[k], -start_of(line)[k]);
    WithError<double> along{ray_of(line).direction[k], 0};
    if constexpr (has_end<Line>) along = two_sum(line.end[k], -line.start[k]);
    const WithError<double> offset = two_product(t, along.value);
    r[k] = (apart.value - offset.value) + ((apart.error - offset.error) - t * along.error);
  }
  return r;
}

// [mesh-answer]
/// t and the weights of a line that meets a triangle.
///
/// t = start/denominator. For the weights the line is taken to start at t, next to the triangle:
/// r = a − (start + t direction) is off by at most 4 u (|a − start| + |t direction|), and the error
/// of t has no effect, because r only occurs in direction × r. Far from the start this is much
/// better than the determinants of the decision. In doubt r is computed again, as if with twice the
/// digits; then exact quotients, rounded once.
template <FloatOrDouble S, class Line>
TriangleHit<S> mesh_triangle_hit(const Line& line, const Triangle<double>& triangle) {
  const LineAndTriangle<double> x = differences_of<double>(line, triangle);
  const Bounded above = evaluate(x, Determinant::start, bounded_volume);
  const Bounded below = evaluate(x, Determinant::denominator, bounded_volume);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::optional<double> t =
      certain_ratio(above, below, has_end<Line> ? 1.0 : infinity, 0x1p-40);
  if (t) {
    const Vector3<double> offset = *t * x.direction;
    const double edges = std::max(sum_of_sizes(x.ab), sum_of_sizes(x.ac));
    const double size = sum_of_sizes(x.direction);
    const double far = sum_of_sizes(x.a) + sum_of_sizes(offset);
    // r is off by 4 u of its 1-norm and of `error`.
    const auto weights = [&](const Vector3<double>& r,
                             double error) -> std::optional<TriangleHit<S>> {
      const Vector3<double> q = x.direction.cross(r);
      const double reach = sum_of_sizes(r) + error;
      const double room =
          16 * mesh_u * (edges * (2 * size * reach)) + 0x1p-1000 * (1 + edges + size);
      const std::optional<double> of_b = certain_ratio({-x.ac.dot(q), room}, below, 1.0, 0x1p-32);
      if (!of_b) return std::nullopt;
      const std::optional<double> of_c = certain_ratio({x.ab.dot(q), room}, below, 1.0, 0x1p-32);
      if (!of_c) return std::nullopt;
      const double of_a = std::max(1 - *of_b - *of_c, 0.0);
      return TriangleHit<S>{static_cast<S>(*t),
                            {static_cast<S>(of_a), static_cast<S>(*of_b), static_cast<S>(*of_c)}};
    };
    std::optional<TriangleHit<S>> hit = weights(x.a - offset, far);
    if (!hit) hit = weights(vertex_from_line(line, triangle.a, *t), 4 * mesh_u * far + 0x1p-1000);
    if (hit) return *hit;
  }
  const LineAndTriangle<Exact> exact = differences_of<Exact>(line, triangle);
  const Exact denominator = exact_determinant(exact, Determinant::denominator);
  const auto ratio = [&](Determinant numerator) {
    return quotient<S>(exact_determinant(exact, numerator), denominator);
  };
  const S at = t ? static_cast<S>(*t) : ratio(Determinant::start);
  const S of_a = ratio(Determinant::of_a), of_b = ratio(Determinant::of_b);
  return {at, {of_a, of_b, ratio(Determinant::of_c)}};
}

/// The hit of a meeting with a triangle of a mesh.
template <FloatOrDouble S, class Line, class DoubleLine>
MeshHit<S> mesh_answer(const Line& line, const DoubleLine& in_doubles, const MeshMeeting& met,
                       const Triangle<S>& triangle, const Mesh<S>& mesh) {
  const TriangleHit<double> hit =
      mesh_triangle_hit<double>(in_doubles, contact::in_double(triangle));
  MeshHit<S> answer;
  answer.triangle = met.triangle;
  answer.hit = {static_cast<S>(hit.t), hit.barycentric.template cast<S>()};
  answer.point = point_of_line(line, hit.t)
                     .cwiseMax(triangle.a.cwiseMin(triangle.b).cwiseMin(triangle.c))
                     .cwiseMin(triangle.a.cwiseMax(triangle.b).cwiseMax(triangle.c));
  name_feature(answer, met.zero, triangle, mesh.triangles[static_cast<std::size_t>(met.triangle)]);
  return answer;
}
// [/mesh-answer]

/// Triangle i of a mesh, in double.
template <FloatOrDouble S>
Triangle<double> double_triangle(const Mesh<S>& mesh, int i) {
  return contact::in_double(triangle_of(mesh, static_cast<std::size_t>(i)));
}

/// The sign of t_x − t_y for two triangles of a mesh.
template <FloatOrDouble S, class Line>
int compare_meetings(const Line& line, const MeshMeeting& x, const MeshMeeting& y,
                     const Mesh<S>& mesh) {
  return compare_meetings(line, x, y, double_triangle(mesh, x.triangle),
                          double_triangle(mesh, y.triangle));
}
/// Whether x is before y: by t, then by index.
template <FloatOrDouble S, class Line>
bool meets_earlier(const Line& line, const MeshMeeting& x, const MeshMeeting& y,
                   const Mesh<S>& mesh) {
  const int order = compare_meetings(line, x, y, mesh);
  return order < 0 || (order == 0 && x.triangle < y.triangle);
}

/// Calls each(meeting) for each triangle that the line meets; stops if it returns true.
template <FloatOrDouble S, class Line, class Each>
void each_meeting(const MeshLine<Line>& line, const Mesh<S>& mesh, const Each& each) {
  if (!line.meets_any()) return;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    std::optional<MeshMeeting> met = line.meet(contact::in_double(triangle_of(mesh, i)));
    if (!met) continue;
    met->triangle = static_cast<int>(i);
    if (each(*met)) return;
  }
}

}  // namespace detail

// [first-mesh-hit]
/// The first point in which a ray or a segment meets a mesh; every triangle is tested.
///
/// Right for every finite input, as intersect_exact is, and so is which of two triangles comes
/// first. Touching counts, from either side. A triangle without area, or with a coordinate that is
/// not finite, is not met; nor is anything by a line that is not finite or has no direction. A
/// triangle in whose plane the line lies is not met either, but its neighbours across an edge are,
/// if they lie in another plane: such a line enters and leaves a flat region of a closed mesh at
/// the region's edges. A segment that ends inside the region has no hit there.
/// @param line a Ray or a Segment; t as in TriangleHit
template <FloatOrDouble S, LineOf<S> Line>
std::optional<MeshHit<S>> first_mesh_hit(const Line& line, const Mesh<S>& mesh) {
  const detail::MeshLine prepared(in_double(line));
  std::optional<detail::MeshMeeting> first;
  detail::each_meeting(prepared, mesh, [&](const detail::MeshMeeting& met) {
    if (!first || detail::meets_earlier(prepared.line(), met, *first, mesh)) first = met;
    return false;
  });
  if (!first) return std::nullopt;
  return detail::mesh_answer<S>(line, prepared.line(), *first,
                                triangle_of(mesh, static_cast<std::size_t>(first->triangle)), mesh);
}
// [/first-mesh-hit]

// [any-mesh-hit]
/// Whether a ray or a segment meets a mesh anywhere: stops at the first triangle that is met. What
/// is degenerate or not finite is not met, as in `first_mesh_hit`.
template <FloatOrDouble S, LineOf<S> Line>
bool any_mesh_hit(const Line& line, const Mesh<S>& mesh) {
  bool found = false;
  detail::each_meeting(detail::MeshLine(in_double(line)), mesh,
                       [&found](const detail::MeshMeeting&) { return found = true; });
  return found;
}
// [/any-mesh-hit]

// [all-mesh-hits]
/// All points in which a ray or a segment meets a mesh, by increasing t.
///
/// A point on an edge or at a vertex counts once, however many triangles have it: triangles with
/// exactly the same t are one hit. So the number of hits of a closed mesh can be odd where the line
/// only touches an edge or a vertex, and it says nothing of inside and outside. What is degenerate
/// or not finite is not met, as in `first_mesh_hit`.
template <FloatOrDouble S, LineOf<S> Line>
std::vector<MeshHit<S>> all_mesh_hits(const Line& line, const Mesh<S>& mesh) {
  const detail::MeshLine prepared(in_double(line));
  std::vector<detail::MeshMeeting> all;
  detail::each_meeting(prepared, mesh, [&](const detail::MeshMeeting& met) {
    all.push_back(met);
    return false;
  });
  std::sort(all.begin(), all.end(), [&](const auto& x, const auto& y) {
    return detail::meets_earlier(prepared.line(), x, y, mesh);
  });
  std::vector<MeshHit<S>> hits;
  hits.reserve(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i > 0 && detail::compare_meetings(prepared.line(), all[i - 1], all[i], mesh) == 0) continue;
    const auto at = static_cast<std::size_t>(all[i].triangle);
    hits.push_back(
        detail::mesh_answer<S>(line, prepared.line(), all[i], triangle_of(mesh, at), mesh));
  }
  return hits;
}
// [/all-mesh-hits]

// [hits-by-triangles]
/// All hits as the triangles give them one by one: sorted by the rounded t, then by index.
///
/// An edge that the line meets may appear for both of its triangles, for one, or for none: the
/// answer is as good as the method. The feature is that of the rounded weights. Whether there is a
/// hit with input that is degenerate or not finite, or after an overflow, the method decides; hits
/// with t = NaN are in no order.
/// @param method called with the line and a triangle; returns an optional `TriangleHit<S>`, as
/// intersect_moller_trumbore and intersect_watertight do
template <Scalar S, LineOf<S> Line, class Method>
std::vector<MeshHit<S>> all_hits_by_triangles(const Line& line, const Mesh<S>& mesh,
                                              const Method& method) {
  std::vector<MeshHit<S>> hits;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const std::optional<TriangleHit<S>> hit = method(line, triangle_of(mesh, i));
    if (!hit) continue;
    const auto& vertices = mesh.triangles[i];
    MeshHit<S> found;
    found.triangle = static_cast<int>(i);
    found.hit = *hit;
    found.point = start_of(line) + hit->t * ray_of(line).direction;
    for (std::size_t k = 0; k < 3; ++k) {
      if (hit->barycentric[int(k)] != S(0)) continue;
      const int next = vertices[(k + 1) % 3], last = vertices[(k + 2) % 3];
      found.feature = MeshFeature::edge;
      found.feature_vertices = {std::min(next, last), std::max(next, last)};
    }
    for (std::size_t k = 0; k < 3; ++k) {
      if (hit->barycentric[int(k)] != S(1)) continue;
      found.feature = MeshFeature::vertex;
      found.feature_vertices = {vertices[k], -1};
    }
    hits.push_back(found);
  }
  std::stable_sort(hits.begin(), hits.end(),
                   [](const MeshHit<S>& x, const MeshHit<S>& y) { return x.hit.t < y.hit.t; });
  return hits;
}
// [/hits-by-triangles]

}  // namespace contact
