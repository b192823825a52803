/// @file
/// The four steps for two triangles that are not in one plane, each time with one mistake that
/// people make: what a test recognises.
#pragma once

#include <06_triangle_pairs/exercise_pairs.hpp>
#include <cmath>

namespace exercise_pairs::steps_with_mistakes {

using Distances = std::array<std::int64_t, 3>;

/// What differs from the right steps.
struct Steps {
  std::size_t edges = 3;        ///< how many edges of a triangle are asked
  bool ends_may_be_on = true;   ///< an edge meets a plane also if an end is in it
  bool border_counts = true;    ///< a point on an edge is in the triangle
  bool all_crossings = true;    ///< not only the first edge that meets the plane
  bool from_the_start = true;   ///< the fraction is measured from the edge's start
  bool largest_dropped = true;  ///< not always z
  bool first_in_second = true;  ///< points of the first triangle's border are asked
  bool second_in_first = true;  ///< and those of the second's
};

/// Whether at/over is in the triangle, given that it is in its plane; `over` is positive.
template <class S>
bool is_in(const Eigen::Matrix<S, 3, 1>& at, S over, const Triangle& t, const Steps& steps) {
  const Vector n = normal(t);
  std::size_t axis = 2;
  for (std::size_t i = 0; i < 3 && steps.largest_dropped; ++i)
    if (std::abs(n.at[i]) > std::abs(n.at[axis])) axis = i;
  const int x = static_cast<int>((axis + 1) % 3), y = static_cast<int>((axis + 2) % 3);
  bool some_left = false, some_right = false;
  for (const auto& [from, to] : edges(t)) {
    const Eigen::Matrix<S, 3, 1> a = from.template cast<S>(), b = to.template cast<S>();
    const S left = (b[x] - a[x]) * (at[y] - over * a[y]) - (b[y] - a[y]) * (at[x] - over * a[x]);
    some_left = some_left || left > 0 || (left == 0 && !steps.border_counts);
    some_right = some_right || left < 0 || (left == 0 && !steps.border_counts);
  }
  return !(some_left && some_right);
}

/// Whether a point of the border of `first` in the plane of `second` is in `second`, with whole
/// numbers.
inline bool border_meets(const Triangle& first, const Triangle& second, const Steps& steps) {
  using Whole = Eigen::Matrix<std::int64_t, 3, 1>;
  const Distances d = distances(first, second);
  const std::array<Point, 3> u = vertices(first);
  for (std::size_t i = 0; i < steps.edges; ++i) {
    const std::size_t j = (i + 1) % 3;
    if (d[i] * d[j] > 0 || (d[i] == 0 && d[j] == 0)) continue;
    if (d[i] * d[j] == 0 && !steps.ends_may_be_on) continue;
    std::int64_t of_i = std::abs(d[j]), of_j = std::abs(d[i]);
    if (!steps.from_the_start) std::swap(of_i, of_j);
    const Whole at = of_i * u[i].cast<std::int64_t>() + of_j * u[j].cast<std::int64_t>();
    if (is_in<std::int64_t>(at, of_i + of_j, second, steps)) return true;
    if (!steps.all_crossings) return false;
  }
  return false;
}

inline bool meet(const Triangle& first, const Triangle& second, const Steps& steps = {}) {
  if (one_side(distances(first, second)) || one_side(distances(second, first))) return false;
  return (steps.first_in_second && border_meets(first, second, steps)) ||
         (steps.second_in_first && border_meets(second, first, steps));
}

/// The points as the lecture computes them, rounded to S.
template <class S>
bool border_meets_rounded(const Triangle& first, const Triangle& second) {
  const Distances whole = distances(first, second);
  const std::array<Point, 3> vertex = vertices(first);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    if (whole[i] * whole[j] > 0 || (whole[i] == 0 && whole[j] == 0)) continue;
    const Eigen::Matrix<S, 3, 1> a = vertex[i].template cast<S>(), b = vertex[j].template cast<S>();
    const S d = static_cast<S>(whole[i]), e = static_cast<S>(whole[j]);
    const Eigen::Matrix<S, 3, 1> p = a + (b - a) * (d / (d - e));
    if (is_in<S>(p, S(1), second, {})) return true;
  }
  return false;
}
template <class S>
bool meet_rounded(const Triangle& first, const Triangle& second) {
  if (one_side(distances(first, second)) || one_side(distances(second, first))) return false;
  return border_meets_rounded<S>(first, second) || border_meets_rounded<S>(second, first);
}

/// What differs from the right intervals on the common line of the planes.
struct Intervals {
  double epsilon = 0;           ///< how far the intervals may be apart
  bool sorted = true;           ///< the ends are in order
  bool zero_is_no_side = true;  ///< a vertex in the plane is not taken for the one that is alone
  int coordinate = -1;          ///< the coordinate along the line; the best one, if negative
};

/// The interval of a triangle with these distances from the other's plane; the numbers are its
/// vertices along the line.
inline std::pair<double, double> interval(const std::array<double, 3>& along, const Distances& d,
                                          const Intervals& how) {
  std::size_t alone = 0;
  if (d[0] * d[1] > 0)
    alone = 2;
  else if (d[0] * d[2] > 0)
    alone = 1;
  else if (how.zero_is_no_side && d[0] == 0 && d[1] * d[2] <= 0)
    alone = d[1] != 0 ? 1 : 2;
  const auto end = [&](std::size_t other) {
    const double from = static_cast<double>(d[alone]), to = static_cast<double>(d[other]);
    return along[alone] + (along[other] - along[alone]) * from / (from - to);
  };
  const std::pair<double, double> ends{end((alone + 1) % 3), end((alone + 2) % 3)};
  return how.sorted && ends.first > ends.second ? std::pair{ends.second, ends.first} : ends;
}

inline bool intervals_overlap(const Triangle& first, const Triangle& second, const Intervals& how) {
  const Distances d = distances(first, second), e = distances(second, first);
  if (one_side(d) || one_side(e)) return false;
  const Vector line = cross(normal(first), normal(second));
  std::size_t best = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (std::abs(line.at[i]) > std::abs(line.at[best])) best = i;
  const int axis = how.coordinate < 0 ? static_cast<int>(best) : how.coordinate;
  const auto along = [&](const Triangle& t) { return std::array{t.a[axis], t.b[axis], t.c[axis]}; };
  const auto [low, high] = interval(along(first), d, how);
  const auto [low2, high2] = interval(along(second), e, how);
  return !(high + how.epsilon < low2) && !(high2 + how.epsilon < low);
}

inline bool planes_reached(const Triangle& first, const Triangle& second) {
  return !one_side(distances(first, second)) && !one_side(distances(second, first));
}

/// Whether each has vertices on both sides of the other's plane.
inline bool planes_crossed(const Triangle& first, const Triangle& second) {
  const auto crossed = [](const Distances& d) {
    const auto [low, high] = std::minmax_element(d.begin(), d.end());
    return *low < 0 && *high > 0;
  };
  return crossed(distances(first, second)) && crossed(distances(second, first));
}

inline bool boxes_meet(const Triangle& first, const Triangle& second) {
  for (int i = 0; i < 3; ++i) {
    const auto range = [&](const Triangle& t) { return std::minmax({t.a[i], t.b[i], t.c[i]}); };
    if (range(first).second < range(second).first || range(second).second < range(first).first)
      return false;
  }
  return true;
}

}  // namespace exercise_pairs::steps_with_mistakes
