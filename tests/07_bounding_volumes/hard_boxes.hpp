/// @file
/// The hard cases of an oriented box around points, and of a point in one: questions and methods.
#pragma once

#include <07_bounding_volumes/box_truth.hpp>
#include <07_bounding_volumes/hard_common.hpp>
#include <07_bounding_volumes/volume_families.hpp>
#include <algorithm>
#include <cmath>
#include <concepts>
#include <contact/box_around.hpp>
#include <contact/convex_hull.hpp>
#include <contact/principal_axes.hpp>
#include <contact/smallest_box.hpp>
#include <contact/smallest_rectangle.hpp>
#include <contact/vector.hpp>
#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <support/hard_cases.hpp>
#include <support/oracle.hpp>
#include <vector>

namespace hard_boxes {

using contact::Matrix3;
using contact::OrientedBox;
using contact::Vector3;
using hard_cases::Case;
using hard_cases::Json;
using hard_common::Points;
using hard_common::points_of;
using oracle::Rational;
using oracle::Vector;

/// A field of nine numbers, row by row.
template <std::floating_point S>
Matrix3<S> matrix_of(const Case& c, const std::string& field) {
  const std::vector<double> numbers = c.numbers(field);
  Matrix3<S> m;
  for (int i = 0; i < 9; ++i) {
    m(i / 3, i % 3) = static_cast<S>(numbers[static_cast<std::size_t>(i)]);
  }
  return m;
}
using volume_families::span_of;

// ---------------------------------------------------------------- a box around points

/// The volume of the box along the given axes, exactly: a parallelepiped, since they are rounded.
inline Rational volume_along(const Case& c) {
  const Matrix3<double> axes = matrix_of<double>(c, "axes");
  const auto column = [&axes](int i) { return oracle::exact(Vector3<double>(axes.col(i))); };
  const Rational volume = box_truth::determinant(column(0), column(1), column(2));
  Rational product = abs(volume);
  OrientedBox<double> frame;
  frame.axes = axes;
  for (int i = 0; i < 3; ++i) {
    Rational low = 0, high = 0;
    bool first = true;
    for (const auto& p : points_of<double>(c)) {
      const Rational x = (*box_truth::coordinates(frame, p))[i];
      if (first || x < low) low = x;
      if (first || x > high) high = x;
      first = false;
    }
    product *= high - low;
  }
  return product;
}

/// Along the eigenvectors of the covariance, with rounded extents.
template <std::floating_point S>
OrientedBox<S> principal_rounded(const Points<S>& points) {
  OrientedBox<S> box{Vector3<S>::Zero(), contact::principal_axes<S>(span_of<S>(points)),
                     Vector3<S>::Zero()};
  constexpr S infinity = std::numeric_limits<S>::infinity();
  Vector3<S> low = Vector3<S>::Constant(infinity), high = -low;
  for (const auto& p : points) {
    const Vector3<S> y = box.axes.transpose() * p;
    low = low.cwiseMin(y);
    high = high.cwiseMax(y);
  }
  box.centre = box.axes * Vector3<S>((low + high) / S(2));
  box.half_lengths = (high - low) / S(2);
  return box;
}
/// With the mean of the points as its centre, and half of the extents.
inline OrientedBox<double> centred_at_mean(const Points<double>& points) {
  OrientedBox<double> box = contact::principal_box<double>(span_of<double>(points));
  box.centre = Vector3<double>::Zero();
  for (const auto& p : points) box.centre += p / double(points.size());
  return box;
}
/// The best of the boxes that have a face of the hull in a face.
inline OrientedBox<double> along_a_face(const Points<double>& points) {
  const contact::Hull hull = contact::convex_hull(points);
  OrientedBox<double> best;
  double least = std::numeric_limits<double>::infinity();
  for (int f = 0; f < hull.face_count(); ++f) {
    const Vector3<double> normal = contact::smallest_box_detail::area_vector(hull.face(f), points);
    const auto frame = contact::frame_on_normal<double>(Vector3<double>::Zero(), normal);
    std::vector<contact::Vector2<double>> flat;
    for (const auto& p : points)
      flat.push_back({frame.axes.col(0).dot(p), frame.axes.col(1).dot(p)});
    const auto r = contact::smallest_rectangle<double>(flat);
    const Vector3<double> x = frame.axes.col(0), y = frame.axes.col(1);
    const auto axes = contact::principal_axes_detail::orthonormal<double>(
        r.axis.x() * x + r.axis.y() * y, r.axis.x() * y - r.axis.y() * x);
    const auto box = contact::box_with_axes<double>(axes, span_of<double>(points));
    if (box_truth::meant_volume(box) < least) least = box_truth::meant_volume(box), best = box;
  }
  return best;
}

/// The longest side of the axis-aligned box.
template <std::floating_point S>
Rational size_of(const Points<S>& points) {
  const auto bounds = contact::aabb_of_points<S>(span_of<S>(points));
  return oracle::exact((bounds.high - bounds.low).maxCoeff());
}
/// Whether a box contains all points as it is stored and is at most 0.1 % larger than the one along
/// the axes that the case gives (for flat sets, by a millionth of the size cubed).
template <std::floating_point S>
bool is_small(const OrientedBox<S>& box, const Case& c) {
  const Points<S> points = points_of<S>(c);
  const Rational size = size_of(points);
  Rational volume = 8;
  for (int k = 0; k < 3; ++k) {
    if (!std::isfinite(box.half_lengths[k])) return false;
    volume *= oracle::exact(box.half_lengths[k]);
  }
  return volume <= volume_along(c) * Rational(1001, 1000) + size * size * size / 1000000 &&
         box_truth::all_inside(box, points);
}
template <std::floating_point S, class Make>
void add_box_method(hard_cases::Runner& runner, const std::string& name, const Make& make) {
  runner.method("box", name, hard_common::applies<S>, [make](const Case& c, const Json&) {
    return is_small<S>(make(points_of<S>(c)), c);
  });
}
inline void add_box_question(hard_cases::Runner& runner) {
  runner.question("box", [](const Case& c) -> Json {
    // As a share of the size cubed, since the volume of some cases overflows or underflows.
    const Rational size = size_of(points_of<double>(c));
    return {{"class", "a"},
            {"share", hard_cases::hex(Rational(volume_along(c) / size / size / size))}};
  });
  add_box_method<double>(runner, "along the axes", [](const Points<double>& points) {
    return contact::box_with_axes<double>(Matrix3<double>::Identity(), span_of<double>(points));
  });
  add_box_method<double>(runner, "principal axes, outwards", [](const Points<double>& points) {
    return contact::principal_box<double>(span_of<double>(points));
  });
  add_box_method<float>(runner, "principal axes, rounded, float", principal_rounded<float>);
  add_box_method<double>(runner, "principal axes, rounded, double", principal_rounded<double>);
  add_box_method<double>(runner, "centred at the mean", centred_at_mean);
  add_box_method<double>(runner, "along a face of the hull", along_a_face);
  runner.method("box", "the book, outwards", [](const Case& c, const Json&) {
    const Points<double> points = points_of<double>(c);
    if (!is_small<double>(contact::smallest_box<double>(span_of<double>(points)), c)) return false;
    if (c.type() == "double") return true;
    const Points<float> rounded = points_of<float>(c);
    return is_small<float>(contact::smallest_box<float>(span_of<float>(rounded)), c);
  });
}

// ---------------------------------------------------------------- a point in a box

template <std::floating_point S>
OrientedBox<S> box_of(const Case& c) {
  return {generators::rounded<S>(c.vector("centre")), matrix_of<S>(c, "axes"),
          generators::rounded<S>(c.vector("half_lengths"))};
}
/// As if the box were centred at the origin.
inline bool without_the_centre(const OrientedBox<double>& box, const Vector3<double>& p) {
  return contact::between_each_pair(
      OrientedBox<double>{Vector3<double>::Zero(), box.axes, box.half_lengths}, p);
}
/// In the bounding box of the corners.
inline bool in_box_of_corners(const OrientedBox<double>& box, const Vector3<double>& p) {
  Vector3<double> low = contact::box_corner(box, 0), high = low;
  for (int k = 1; k < 8; ++k) {
    low = low.cwiseMin(contact::box_corner(box, k));
    high = high.cwiseMax(contact::box_corner(box, k));
  }
  return (p - low).minCoeff() >= 0 && (high - p).minCoeff() >= 0;
}
/// Three slabs, wider by epsilon.
inline bool within_epsilon(const OrientedBox<double>& box, const Vector3<double>& p) {
  OrientedBox<double> wider = box;
  wider.half_lengths.array() += 1e-9;
  return contact::between_each_pair(wider, p);
}
/// As a box that is stored as a corner and a size: is p between corner and corner + size?
inline bool from_a_corner(const OrientedBox<double>& box, const Vector3<double>& p) {
  const Vector3<double> corner = contact::box_corner(box, 0);
  for (int k = 0; k < 3; ++k) {
    const Vector3<double> axis = box.axes.col(k);
    const double low = axis.dot(corner), y = axis.dot(p);
    if (!(low <= y && y <= low + 2 * box.half_lengths[k])) return false;
  }
  return true;
}
template <std::floating_point S, class Inside>
void add_point_method(hard_cases::Runner& runner, const std::string& name, const Inside& inside) {
  runner.method("point_in_box", name, hard_common::applies<S>,
                [inside](const Case& c, const Json& answer) {
                  return inside(box_of<S>(c), generators::rounded<S>(c.vector("point"))) ==
                         answer.at("inside").get<bool>();
                });
}
inline void add_point_question(hard_cases::Runner& runner) {
  runner.question("point_in_box", [](const Case& c) -> Json {
    return {{"class", "a"}, {"inside", box_truth::inside(box_of<double>(c), c.vector("point"))}};
  });
  add_point_method<float>(runner, "six planes, float", contact::inside_six_planes<float>);
  add_point_method<double>(runner, "six planes, double", contact::inside_six_planes<double>);
  add_point_method<float>(runner, "three slabs, float", contact::between_each_pair<float>);
  add_point_method<double>(runner, "three slabs, double", contact::between_each_pair<double>);
  add_point_method<double>(runner, "three slabs, epsilon 1e-9", within_epsilon);
  add_point_method<double>(runner, "corner and size, double", from_a_corner);
  add_point_method<double>(runner, "without the centre", without_the_centre);
  add_point_method<double>(runner, "box of the corners", in_box_of_corners);
  runner.method("point_in_box", "the book, exact", [](const Case& c, const Json& answer) {
    const bool inside = answer.at("inside").get<bool>();
    return contact::contains(box_of<double>(c), c.vector("point")) == inside &&
           (c.type() == "double" ||
            contact::contains(box_of<float>(c), generators::rounded<float>(c.vector("point"))) ==
                inside);
  });
}

/// Adds them to a runner.
inline void add_questions(hard_cases::Runner& runner) {
  add_box_question(runner);
  add_point_question(runner);
}

}  // namespace hard_boxes
