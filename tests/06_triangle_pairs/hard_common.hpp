/// @file
/// The hard cases of what two triangles have in common: question and methods.
#pragma once

#include <06_triangle_pairs/common_points_truth.hpp>
#include <06_triangle_pairs/hard_pairs.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <contact/pair_methods.hpp>
#include <contact/triangle_intersection.hpp>
#include <string>
#include <support/hard_cases.hpp>
#include <vector>

namespace hard_common {

using contact::Triangle;
using contact::Vector3;
using hard_cases::Case;
using hard_cases::Json;
using hard_pairs::Pair;
using hard_pairs::pair_of;
using oracle::Rational;
using oracle::Vector;

template <std::floating_point S>
using Points = std::vector<Vector3<S>>;

// ---------------------------------------------------------------- answers

inline const char* kind_name(std::size_t count) {
  constexpr std::array<const char*, 4> names{"none", "point", "segment", "area"};
  return names[std::min<std::size_t>(count, 3)];
}
inline std::vector<Vector> exact_points(const Case& c) {
  std::vector<Vector> points;
  for (const auto& point :
       common_points_truth::common_vertices(common_points_truth::vertices(c.triangle("first")),
                                            common_points_truth::vertices(c.triangle("second")))) {
    points.push_back(point.position);
  }
  return points;
}
inline Rational distance(const Vector& u, const Vector& v) {
  Rational largest = 0;
  for (int k = 0; k < 3; ++k) largest = std::max(largest, Rational(abs(u[k] - v[k])));
  return largest;
}
/// Whether there is one point for each of the exact ones, at most `room` away.
template <std::floating_point S>
bool same_points(Points<S> points, const std::vector<Vector>& exact, const Rational& room) {
  if (points.size() != exact.size()) return false;
  for (const Vector& x : exact) {
    const auto found = std::find_if(points.begin(), points.end(), [&](const Vector3<S>& p) {
      return p.allFinite() && distance(oracle::exact(p), x) <= room;
    });
    if (found == points.end()) return false;
    points.erase(found);
  }
  return true;
}
/// A millionth of the larger triangle's longest edge, along an axis.
inline Rational room(const Case& c) {
  Rational longest = 0;
  for (const char* name : {"first", "second"}) {
    const auto t = common_points_truth::vertices(c.triangle(name));
    for (int i = 0; i < 3; ++i) {
      longest = std::max(
          longest, distance(common_points_truth::at(t, i), common_points_truth::at(t, i + 1)));
    }
  }
  return longest / 1000000;
}

// ---------------------------------------------------------------- methods as they are often
// written

/// The points p and q of the lecture's step 3, if step 4 says that the triangles meet.
template <std::floating_point S>
Points<S> by_steps(const Triangle<S>& first, const Triangle<S>& second) {
  const contact::PairBySteps<S> steps = contact::meet_by_steps(first, second);
  if (!steps.meet) return {};
  if (steps.p == steps.q) return {steps.p};
  return {steps.p, steps.q};
}

/// Points without those that are within epsilon of one before them.
template <std::floating_point S>
Points<S> merged(const Points<S>& points, S epsilon) {
  Points<S> kept;
  for (const Vector3<S>& p : points) {
    const bool is_new = std::none_of(kept.begin(), kept.end(), [&](const Vector3<S>& q) {
      return (p - q).cwiseAbs().maxCoeff() <= epsilon;
    });
    if (is_new) kept.push_back(p);
  }
  return kept;
}

/// Sutherland and Hodgman: what of a polygon is in front of the plane (x − on) · normal = 0, border
/// included.
template <std::floating_point S>
Points<S> clipped(const Points<S>& polygon, const Vector3<S>& on, const Vector3<S>& normal) {
  Points<S> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector3<S>&p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const S at_p = normal.dot(p - on), at_q = normal.dot(q - on);
    if (at_p >= 0) kept.push_back(p);
    if ((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0)) {
      kept.push_back(p + at_p / (at_p - at_q) * (q - p));
    }
  }
  return kept;
}

/// The first triangle clipped to the plane of the second, from both sides, and then by its edges;
/// equal points, or those within epsilon, once.
template <std::floating_point S>
Points<S> by_clipping(const Triangle<S>& first, const Triangle<S>& second, S epsilon = S(0)) {
  const Vector3<S> ab = second.b - second.a, ac = second.c - second.a;
  const Vector3<S> normal = ab.cross(ac);
  Points<S> polygon{first.a, first.b, first.c};
  polygon = clipped<S>(polygon, second.a, normal);
  polygon = clipped<S>(polygon, second.a, -normal);
  const std::array<Vector3<S>, 3> at{second.a, second.b, second.c};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3<S> edge = at[(i + 1) % 3] - at[i];
    polygon = clipped<S>(polygon, at[i], normal.cross(edge));
  }
  return merged<S>(polygon, epsilon);
}

/// Where the edges of each meet the other by Möller and Trumbore; equal points once.
template <std::floating_point S>
Points<S> by_edges(const Triangle<S>& first, const Triangle<S>& second) {
  Points<S> points;
  const auto add = [&points](const Triangle<S>& edges, const Triangle<S>& face) {
    for (const auto& edge :
         {contact::Segment<S>{edges.a, edges.b}, {edges.b, edges.c}, {edges.c, edges.a}}) {
      const auto hit = contact::intersect_moller_trumbore(edge, face);
      if (hit) points.push_back(edge.start + hit->t * (edge.end - edge.start));
    }
  };
  add(first, second);
  add(second, first);
  return merged<S>(points, S(0));
}

// ---------------------------------------------------------------- the book

template <std::floating_point S>
Points<S> points_of(const contact::TriangleIntersection<S>& found) {
  Points<S> points;
  for (int i = 0; i < found.count; ++i) {
    points.push_back(found.points[static_cast<std::size_t>(i)].position);
  }
  return points;
}
/// Kind, number, and the positions within the bound and to the last place.
template <std::floating_point S>
bool book_is_right(const Case& c, const std::vector<Vector>& exact) {
  const Pair<S> pair = pair_of<S>(c);
  const auto found = contact::intersect_triangles(pair.first, pair.second);
  const auto sharp = contact::intersect_triangles_to_last_place(pair.first, pair.second);
  const auto kind = static_cast<contact::CommonPoints>(std::min<std::size_t>(exact.size(), 3));
  if (found.kind != kind || sharp.kind != kind) return false;
  if (contact::common_points(pair.first, pair.second) != kind) return false;
  return same_points(points_of(found), exact, oracle::exact(found.bound)) &&
         same_points(points_of(sharp), exact, oracle::exact(sharp.bound));
}

// ---------------------------------------------------------------- question

template <std::floating_point S, class Find>
void add_method(hard_cases::Runner& runner, const std::string& name, const Find& find) {
  runner.method("common", name, hard_pairs::applies<S>, [find](const Case& c, const Json&) {
    const Pair<S> pair = pair_of<S>(c);
    return same_points<S>(find(pair.first, pair.second), exact_points(c), room(c));
  });
}

/// Adds it to a runner. A method is right if it finds the points to a millionth of the triangles'
/// size.
inline void add_questions(hard_cases::Runner& runner) {
  runner.question("common", [](const Case& c) -> Json {
    const std::size_t count = exact_points(c).size();
    return {{"class", "a"}, {"kind", kind_name(count)}, {"points", count}};
  });
  add_method<double>(runner, "p and q of the steps, double", by_steps<double>);
  add_method<double>(runner, "edges and faces, double", by_edges<double>);
  add_method<float>(runner, "clipping, float",
                    [](const auto& t, const auto& u) { return by_clipping<float>(t, u); });
  add_method<double>(runner, "clipping, double",
                     [](const auto& t, const auto& u) { return by_clipping<double>(t, u); });
  add_method<double>(runner, "clipping, merged within 1e-9",
                     [](const auto& t, const auto& u) { return by_clipping<double>(t, u, 1e-9); });
  runner.method("common", "the book, exact", [](const Case& c, const Json&) {
    const std::vector<Vector> exact = exact_points(c);
    return book_is_right<double>(c, exact) &&
           (c.type() == "double" || book_is_right<float>(c, exact));
  });
}

}  // namespace hard_common
