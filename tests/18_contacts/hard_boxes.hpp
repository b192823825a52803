/// @file
/// Contact points and normals of boxes: right answers, and methods as they are often written.
#pragma once

#include <algorithm>
#include <cmath>
#include <contact/box_axes.hpp>
#include <contact/closed_proximity.hpp>
#include <contact/contact_manifold.hpp>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "09_separating_planes/shape_oracle.hpp"
#include "support/hard_cases.hpp"

namespace hard_boxes {

using hard_cases::Case;
using hard_cases::Json;
using oracle::Rational;
using oracle::Surd;
using oracle::Vector;
using V = contact::Vector3<double>;
using Box = contact::OrientedBox<double>;

inline Box box(const Case& c, const std::string& name) {
  Box b;
  b.centre = c.vector(name + "_centre");
  b.half_lengths = c.vector(name + "_half");
  if (c.has(name + "_axes")) {
    const std::vector<double> all = c.numbers(name + "_axes");
    for (int i = 0; i < 9; ++i) b.axes(i % 3, i / 3) = all.at(static_cast<std::size_t>(i));
  }
  return b;
}
inline contact::HalfSpace<double> half_space(const Case& c) {
  return {{c.vector("b_normal"), c.number("b_offset")}};
}

/// The largest separation of two boxes over the fifteen axes, and the first axis that has it.
struct ExactAxis {
  int axis = -1;
  Surd separation;
};
inline ExactAxis exact_axis(const Case& c) {
  const auto a = shape_oracle::exact(box(c, "a"));
  const auto b = shape_oracle::exact(box(c, "b"));
  ExactAxis best;
  for (int k = 0; k < contact::box_axis_count; ++k) {
    const Vector n = contact::box_axis<Rational>(a, b, k);
    const Rational square = n.dot(n);
    if (square == 0) continue;
    const Surd separation =
        oracle::divided_by_root(contact::separation_along<Rational>(a, b, n), square);
    if (best.axis < 0 || oracle::compare(separation, best.separation) > 0) best = {k, separation};
  }
  return best;
}

/// In fractions. On a half-space: corners within the margin, at most four. On a box: the part of
/// A's incident face over the face "axis" of B (1 to 3, negative for the lower side), with corners
/// that coincide counted once. Without an axis: one point, if two edges separate most.
inline int exact_points(const Case& c) {
  const auto a = shape_oracle::exact(box(c, "a"));
  const Rational margin = oracle::exact(c.number("margin"));
  if (c.has("b_normal")) {
    const auto h = half_space(c);
    int count = 0;
    for (int k = 0; k < 8; ++k) {
      const Rational height =
          oracle::exact(h.boundary.normal).dot(contact::box_corner<Rational>(a, k)) -
          oracle::exact(h.boundary.offset);
      count += height <= margin ? 1 : 0;
    }
    return std::min(count, 4);
  }
  if (!c.has("axis")) {
    const ExactAxis widest = exact_axis(c);
    if (widest.axis < 6) throw std::invalid_argument(c.name() + ": a face separates most");
    return oracle::compare(widest.separation, {margin, 0, 0}) <= 0 ? 1 : 0;
  }
  const auto b = shape_oracle::exact(box(c, "b"));
  const int axis = static_cast<int>(std::abs(c.number("axis"))) - 1;
  const Vector up = b.axes.col(axis) * Rational(c.number("axis") > 0 ? 1 : -1);
  const auto face = contact::face_towards<Rational>(a, Vector(-up));
  const auto polygon = contact::polygon_over_face<Rational>(
      std::vector<Vector>(face.corners.begin(), face.corners.end()), b, axis);
  std::vector<Vector> distinct;
  for (const Vector& p : polygon) {
    const Rational height = up.dot(Vector(p - b.centre)) - b.half_lengths(axis);
    if (height > margin) continue;
    bool known = false;
    for (const Vector& q : distinct) known = known || q == p;
    if (!known) distinct.push_back(p);
  }
  return static_cast<int>(distinct.size());
}

inline int distinct_points(const Case& c) {
  const double margin = c.number("margin");
  const auto manifold = c.has("b_normal")
                            ? contact::contact_manifold(box(c, "a"), half_space(c), margin)
                            : contact::contact_manifold(box(c, "a"), box(c, "b"), margin);
  std::vector<V> distinct;
  for (const auto& p : manifold.points) {
    bool known = false;
    for (const V& q : distinct) known = known || q == p.point;
    if (!known) distinct.push_back(p.point);
  }
  return static_cast<int>(distinct.size());
}

inline int corners_inside(const Case& c, const char* of, const char* in) {
  int count = 0;
  for (int k = 0; k < 8; ++k) {
    const contact::Sphere<double> p{contact::box_corner(box(c, of), k), 0};
    const double d = c.has("b_normal") ? contact::signed_distance(p, half_space(c)).distance
                                       : contact::signed_distance(p, box(c, in)).distance;
    count += d <= c.number("margin") ? 1 : 0;
  }
  return count;
}

inline void add_points(hard_cases::Runner& runner) {
  runner.question("points", [](const Case& c) {
    return Json{{"class", "a"}, {"points", exact_points(c)}};
  });
  const auto method = [&runner](const char* name, auto count) {
    runner.method("points", name, [count](const Case& c, const Json& answer) {
      return count(c) == answer.at("points").get<int>();
    });
  };
  method("the deepest point", [](const Case& c) {
    const double d = c.has("b_normal")
                         ? contact::signed_distance(box(c, "a"), half_space(c)).distance
                         : contact::signed_distance(box(c, "a"), box(c, "b")).distance;
    return d <= c.number("margin") ? 1 : 0;
  });
  method("A's corners inside B", [](const Case& c) { return corners_inside(c, "a", "b"); });
  method("corners of either inside the other", [](const Case& c) {
    return corners_inside(c, "a", "b") + (c.has("b_normal") ? 0 : corners_inside(c, "b", "a"));
  });
  method("the four deepest", [](const Case& c) { return std::min(distinct_points(c), 4); });
  method("book", distinct_points);
}

// ------------------------------------------------------------------------------------------ normal

/// A unit normal is right if it separates by at most 2^-10 of the smallest half length less than
/// the best of the fifteen axes, which is by how much faces are preferred.
inline bool separates_most(const Case& c, const V& normal, const Json& answer) {
  const Box a = box(c, "a");
  const Box b = box(c, "b");
  if (!(normal.norm() > 0.5)) return false;
  if (normal.dot(V(a.centre - b.centre)) < 0) return false;
  const double got = contact::separation_along<double>(a, b, normal) / normal.norm();
  const double slack =
      1.001 * 0x1p-10 * std::min(a.half_lengths.minCoeff(), b.half_lengths.minCoeff());
  return got >= hard_cases::unhex(answer, "separation") - slack;
}
/// The best of some of the fifteen axes, from B to A.
inline V best_of(const Case& c, int first, int last) {
  const auto found = contact::detail::max_separation<double>(box(c, "a"), box(c, "b"), first, last);
  return found.normal;
}
/// The mean of B's faces that a vertex near A belongs to.
inline V mean_of_faces(const Case& c) {
  const Box a = box(c, "a");
  const Box b = box(c, "b");
  V sum = V::Zero();
  for (int i = 0; i < 3; ++i) {
    const V n = b.axes.col(i);
    const double side = n.dot(V(a.centre - b.centre)) < 0 ? -1.0 : 1.0;
    if (contact::separation_along<double>(a, b, n) > -0.25 * b.half_lengths.minCoeff())
      sum += n * side;
  }
  return sum.norm() > 0 ? V(sum.normalized()) : sum;
}
/// The face of B nearest to the deepest corner of A inside it.
inline V face_of_deepest_corner(const Case& c) {
  const Box a = box(c, "a");
  const Box b = box(c, "b");
  V normal = V::Zero();
  double deepest = -std::numeric_limits<double>::infinity();
  for (int k = 0; k < 8; ++k) {
    const V p = contact::box_corner(a, k) - b.centre;
    double nearest = std::numeric_limits<double>::infinity();
    V face = V::Zero();
    for (int i = 0; i < 3; ++i) {
      const V n = b.axes.col(i);
      const double depth = b.half_lengths(i) - std::abs(n.dot(p));
      if (depth < nearest) {
        nearest = depth;
        face = n.dot(p) < 0 ? V(-n) : n;
      }
    }
    if (nearest >= 0 && nearest > deepest) {
      deepest = nearest;
      normal = face;
    }
  }
  return normal;
}

inline void add_normals(hard_cases::Runner& runner) {
  runner.question("normal", [](const Case& c) {
    return Json{{"class", "b"},
                {"separation", hard_cases::hex(oracle::nearest(exact_axis(c).separation))}};
  });
  const auto method = [&runner](const char* name, auto normal) {
    runner.method("normal", name, [normal](const Case& c, const Json& answer) {
      return separates_most(c, normal(c), answer);
    });
  };
  method("from centre to centre",
         [](const Case& c) { return V((box(c, "a").centre - box(c, "b").centre).normalized()); });
  method("the mean of the faces at a vertex", mean_of_faces);
  method("the face at the deepest corner", face_of_deepest_corner);
  method("B's faces only", [](const Case& c) { return best_of(c, 3, 5); });
  method("faces only", [](const Case& c) { return best_of(c, 0, 5); });
  method("book", [](const Case& c) {
    return V(contact::contact_manifold(box(c, "a"), box(c, "b"), 1.0).normal);
  });
}

inline void add(hard_cases::Runner& runner) {
  add_points(runner);
  add_normals(runner);
}

}  // namespace hard_boxes
