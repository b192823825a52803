/// @file
/// Which of two triangles a line meets first, decided exactly.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <contact/difference_determinant.hpp>
#include <contact/exact.hpp>
#include <contact/exact_ray_triangle.hpp>
#include <contact/passage.hpp>
#include <contact/ray_triangle.hpp>
#include <contact/shapes.hpp>
#include <contact/vector.hpp>
#include <cstddef>
#include <limits>
#include <optional>

namespace contact::detail {

/// The unit roundoff of double.
inline constexpr double mesh_u = std::numeric_limits<double>::epsilon() / 2;

/// The 1-norm.
inline double sum_of_sizes(const Vector3<double>& v) {
  return std::abs(v[0]) + std::abs(v[1]) + std::abs(v[2]);
}

/// The differences of a query in double or without error: those of ExactQuery.
template <Ring T, class Line>
LineAndTriangle<T> differences_of(const Line& line, const Triangle<double>& triangle) {
  const auto as = [](const Vector3<double>& v) { return Vector3<T>(T(v.x()), T(v.y()), T(v.z())); };
  const Vector3<T> start = as(start_of(line));
  const Vector3<T> a = as(triangle.a), b = as(triangle.b), c = as(triangle.c);
  LineAndTriangle<T> x;
  x.a = a - start;
  x.b = b - start;
  x.c = c - start;
  x.ab = b - a;
  x.ac = c - a;
  if constexpr (has_end<Line>) {
    x.direction = as(line.end) - start;
    x.end_a = a - as(line.end);
  } else {
    x.direction = as(line.direction);
  }
  return x;
}

/// The sign of a determinant of a query, in integers of fixed size: much faster than `Exact`.
/// Nothing if its numbers span too many bits.
template <class Line>
std::optional<int> quick_sign(const Line& line, const Triangle<double>& triangle,
                              Determinant which) {
  difference_detail::Differences<9> rows;
  const auto set = [&rows](std::size_t row, const Vector3<double>& to,
                           const Vector3<double>& from) {
    for (int k = 0; k < 3; ++k) {
      rows.set(3 * row + static_cast<std::size_t>(k), to[k], from[k]);
    }
  };
  const Vector3<double> start = start_of(line);
  const auto& [a, b, c] = triangle;
  const auto direction = [&] {
    if constexpr (has_end<Line>) {
      set(0, line.end, start);
    } else {
      set(0, line.direction, Vector3<double>::Zero());
    }
  };
  const auto edge = [&](const Vector3<double>& second, const Vector3<double>& third) {
    direction();
    set(1, second, start);
    set(2, third, start);
  };
  const auto plane = [&] {
    set(1, b, a);
    set(2, c, a);
  };
  switch (which) {
    case Determinant::of_a:
      edge(b, c);
      break;
    case Determinant::of_b:
      edge(c, a);
      break;
    case Determinant::of_c:
      edge(a, b);
      break;
    case Determinant::start:
      set(0, a, start);
      plane();
      break;
    case Determinant::end:
      if constexpr (has_end<Line>) set(0, a, line.end);
      plane();
      break;
    case Determinant::denominator:
      direction();
      plane();
      break;
  }
  return difference_detail::determinant_sign(rows);
}

/// A determinant without error.
inline Exact exact_determinant(const LineAndTriangle<Exact>& x, Determinant which) {
  return evaluate(x, which, [](const auto& p, const auto& q, const auto& r) {
    return Exact(p.dot(Vector3<Exact>(q.cross(r))));
  });
}

// [mesh-time]
/// A triangle that a line meets, and its t as far as double gives it.
struct MeshMeeting {
  int triangle = -1;
  double t = 0;
  double bound = 0;  ///< the exact t differs by at most this; infinite or NaN: unknown
  /// Which weights, of vertex a, b and c, are exactly 0: none inside, one on an edge, two at a
  /// vertex.
  std::array<bool, 3> zero{};

  /// An upper bound of the exact t; infinite or NaN if there is none.
  double latest() const { return t + bound; }
};

/// The sign of t_x − t_y, where a line meets both triangles: t is a quotient of two determinants.
template <class Line>
[[gnu::noinline]] int compare_times(const Line& line, const Triangle<double>& x,
                                    const Triangle<double>& y) {
  const LineAndTriangle<Exact> at_x = differences_of<Exact>(line, x);
  const LineAndTriangle<Exact> at_y = differences_of<Exact>(line, y);
  const Exact below_x = exact_determinant(at_x, Determinant::denominator);
  const Exact below_y = exact_determinant(at_y, Determinant::denominator);
  const Exact above_x = exact_determinant(at_x, Determinant::start);
  const Exact above_y = exact_determinant(at_y, Determinant::start);
  return (above_x * below_y - above_y * below_x).sign() * below_x.sign() * below_y.sign();
}

/// Whether a line meets two triangles at one vertex that they share, or inside one edge that they
/// share. Their t is then the same: a line that meets a triangle is not in its plane, so it has one
/// point in common with each of its edges. False for every other pair, also of the same t.
inline bool meet_at_shared_feature(const MeshMeeting& x, const MeshMeeting& y,
                                   const Triangle<double>& triangle_x,
                                   const Triangle<double>& triangle_y) {
  const auto count = [](const MeshMeeting& met) {
    return std::count(met.zero.begin(), met.zero.end(), true);
  };
  const auto zeros = count(x);
  if (zeros == 0 || zeros != count(y)) return false;
  // A vertex whose weight is not 0 must be one of the other triangle's, again with such a weight.
  const std::array<const Vector3<double>*, 3> of_x{&triangle_x.a, &triangle_x.b, &triangle_x.c};
  const std::array<const Vector3<double>*, 3> of_y{&triangle_y.a, &triangle_y.b, &triangle_y.c};
  for (std::size_t i = 0; i < 3; ++i) {
    if (x.zero[i]) continue;
    bool shared = false;
    for (std::size_t k = 0; k < 3; ++k) shared |= !y.zero[k] && *of_x[i] == *of_y[k];
    if (!shared) return false;
  }
  return true;
}

/// The same as compare_times for two meetings: exact arithmetic only if the intervals of t overlap
/// and the triangles do not share the vertex or the edge that is met.
template <class Line>
int compare_meetings(const Line& line, const MeshMeeting& x, const MeshMeeting& y,
                     const Triangle<double>& triangle_x, const Triangle<double>& triangle_y) {
  if (x.t + x.bound < y.t - y.bound) return -1;
  if (x.t - x.bound > y.t + y.bound) return 1;
  if (meet_at_shared_feature(x, y, triangle_x, triangle_y)) return 0;
  return compare_times(line, triangle_x, triangle_y);
}
// [/mesh-time]

}  // namespace contact::detail
