/// @file
/// The hard cases of two oriented boxes: whether they meet as they are stored.
#pragma once

#include <07_bounding_volumes/carried_truth.hpp>
#include <07_bounding_volumes/hard_common.hpp>
#include <07_bounding_volumes/hard_moving.hpp>
#include <algorithm>
#include <cmath>
#include <concepts>
#include <contact/oriented_box.hpp>
#include <contact/volumes_meet.hpp>
#include <string>
#include <support/hard_cases.hpp>
#include <support/oracle.hpp>
#include <vector>

namespace hard_oriented {

using contact::Matrix3;
using contact::OrientedBox;
using contact::Vector3;
using hard_cases::Case;
using hard_cases::Json;
using hard_common::applies;
using oracle::Rational;
using oracle::Vector;

/// Fields centre_1, axes_1 (row by row) and half_1; and 2.
template <std::floating_point S>
OrientedBox<S> box_of(const Case& c, const std::string& number) {
  return {generators::rounded<S>(c.vector("centre_" + number)),
          hard_moving::matrix_of<S>(c, "axes_" + number),
          generators::rounded<S>(c.vector("half_" + number))};
}

/// Whether the projections on n overlap, with each axis as it is stored.
template <class T>
bool overlap_along(const contact::Vector3<T>& d, const Matrix3<T>& a, const Vector3<T>& half_a,
                   const Matrix3<T>& b, const Vector3<T>& half_b, const Vector3<T>& n,
                   const T& room) {
  using std::abs;
  T reach = room;
  for (int i = 0; i < 3; ++i) {
    reach += half_a[i] * T(abs(T(n.dot(a.col(i)))));
    reach += half_b[i] * T(abs(T(n.dot(b.col(i)))));
  }
  return T(abs(T(n.dot(d)))) <= reach;
}

/// How the fifteen axes are taken.
enum class Axes { all, faces_only, of_one_box, without_short, unit };

template <std::floating_point S>
bool overlap(const OrientedBox<S>& a, const OrientedBox<S>& b, Axes axes, S room) {
  const Vector3<S> d = a.centre - b.centre;
  const auto along = [&](const Vector3<S>& n) {
    return overlap_along<S>(d, a.axes, a.half_lengths, b.axes, b.half_lengths, n, room);
  };
  for (int i = 0; i < 3; ++i) {
    if (!along(a.axes.col(i)) || !along(b.axes.col(i))) return false;
    if (axes == Axes::faces_only) continue;
    for (int j = 0; j < 3; ++j) {
      const Matrix3<S>& other = axes == Axes::of_one_box ? a.axes : b.axes;
      Vector3<S> n = Vector3<S>(a.axes.col(i)).cross(Vector3<S>(other.col(j)));
      const S length_squared = n.dot(n);
      if (axes == Axes::without_short && length_squared < S(1e-4)) continue;
      if (axes == Axes::unit) n /= std::sqrt(length_squared);
      if (!along(n)) return false;
    }
  }
  return true;
}
/// The lecture: bodies collide if their bounding spheres do.
inline bool spheres_meet(const OrientedBox<double>& a, const OrientedBox<double>& b) {
  const Vector3<double> d = a.centre - b.centre;
  return std::sqrt(d.dot(d)) <= std::sqrt(a.half_lengths.dot(a.half_lengths)) +
                                    std::sqrt(b.half_lengths.dot(b.half_lengths));
}
/// A corner of one is in the other.
inline bool corner_inside(const OrientedBox<double>& a, const OrientedBox<double>& b) {
  const auto any = [](const OrientedBox<double>& in, const OrientedBox<double>& of) {
    for (int k = 0; k < 8; ++k) {
      const Vector3<double> x =
          in.axes.transpose() * Vector3<double>(contact::box_corner(of, k) - in.centre);
      if ((x.cwiseAbs().array() <= in.half_lengths.array()).all()) return true;
    }
    return false;
  };
  return any(a, b) || any(b, a);
}

inline bool meet_exactly(const Case& c) {
  const OrientedBox<double> a = box_of<double>(c, "1"), b = box_of<double>(c, "2");
  const carried_truth::ExactMatrix u = carried_truth::exact(a.axes),
                                   v = carried_truth::exact(b.axes);
  const Vector d = oracle::exact(a.centre) - oracle::exact(b.centre);
  const Vector half_a = oracle::exact(a.half_lengths), half_b = oracle::exact(b.half_lengths);
  const auto along = [&](const Vector& n) {
    return overlap_along<Rational>(d, u, half_a, v, half_b, n, Rational(0));
  };
  for (int i = 0; i < 3; ++i) {
    if (!along(u.col((i + 1) % 3).cross(u.col((i + 2) % 3)))) return false;
    if (!along(v.col((i + 1) % 3).cross(v.col((i + 2) % 3)))) return false;
    for (int j = 0; j < 3; ++j) {
      if (!along(u.col(i).cross(v.col(j)))) return false;
    }
  }
  return true;
}

template <std::floating_point S, class Decide>
void add_method(hard_cases::Runner& runner, const std::string& name, const Decide& decide) {
  runner.method("boxes_meet", name, applies<S>, [decide](const Case& c, const Json& answer) {
    return decide(box_of<S>(c, "1"), box_of<S>(c, "2")) == answer.at("meet").get<bool>();
  });
}

/// Adds them to a runner.
inline void add_questions(hard_cases::Runner& runner) {
  using F = OrientedBox<float>;
  using D = OrientedBox<double>;
  runner.question("boxes_meet", [](const Case& c) -> Json {
    return {{"class", "a"}, {"meet", meet_exactly(c)}};
  });
  add_method<double>(runner, "bounding spheres", spheres_meet);
  add_method<double>(runner, "a corner inside", corner_inside);
  add_method<double>(runner, "six face normals",
                     [](const D& a, const D& b) { return overlap(a, b, Axes::faces_only, 0.0); });
  add_method<double>(runner, "edges of one box crossed",
                     [](const D& a, const D& b) { return overlap(a, b, Axes::of_one_box, 0.0); });
  add_method<double>(runner, "short cross products left out", [](const D& a, const D& b) {
    return overlap(a, b, Axes::without_short, 0.0);
  });
  add_method<double>(runner, "unit cross products",
                     [](const D& a, const D& b) { return overlap(a, b, Axes::unit, 0.0); });
  add_method<float>(runner, "fifteen axes, float",
                    [](const F& a, const F& b) { return overlap(a, b, Axes::all, 0.0F); });
  add_method<double>(runner, "fifteen axes, double",
                     [](const D& a, const D& b) { return overlap(a, b, Axes::all, 0.0); });
  add_method<double>(runner, "fifteen axes and 1e-6",
                     [](const D& a, const D& b) { return overlap(a, b, Axes::all, 1e-6); });
  add_method<double>(runner, "the book, conservative",
                     [](const D& a, const D& b) { return contact::may_meet(a, b); });
}

}  // namespace hard_oriented
