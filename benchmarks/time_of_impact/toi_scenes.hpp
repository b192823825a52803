/// @file
/// Pairs of moving boxes and of moving points to ask of, with what is right, and as other programs
/// take them.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <contact/box_sweep.hpp>
#include <contact/conservative_advancement.hpp>
#include <contact/quaternion.hpp>
#include <contact/vector.hpp>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "11_time_of_impact/boxes.hpp"
#include "11_time_of_impact/families_points.hpp"
#include "11_time_of_impact/families_turning.hpp"
#include "11_time_of_impact/moving_truth.hpp"
#include "peers.hpp"

namespace toi_scenes {

using families::V;
using generators::Random;
using peers::Motion;
using Axes = contact::Matrix3<double>;

inline peers::Numbers plain(const V& v) { return {v.x(), v.y(), v.z()}; }
inline V vector(const peers::Numbers& p) { return {p[0], p[1], p[2]}; }
inline std::array<peers::Numbers, 3> plain(const Axes& axes) {
  return {plain(V(axes.col(0))), plain(V(axes.col(1))), plain(V(axes.col(2)))};
}
inline Axes matrix(const std::array<peers::Numbers, 3>& axes) {
  Axes made;
  for (int k = 0; k < 3; ++k) made.col(k) = vector(axes[static_cast<std::size_t>(k)]);
  return made;
}

// ------------------------------------------------------------------------ boxes that translate

/// Boxes that translate, with the exact times.
struct Translating {
  std::string title;
  bool in_plane = false;
  std::vector<std::array<boxes::Box, 2>> pairs;
  peers::Pairs plain;
  std::vector<std::optional<double>> right;
};

inline peers::Box plain(const boxes::Box& box) {
  peers::Box made;
  made.centre = plain(box.frame.origin);
  made.axes = made.end_axes = plain(box.frame.axes);
  made.half_lengths = plain(box.half_lengths);
  made.displacement = plain(box.displacement);
  made.angle = std::atan2(box.frame.axes(1, 0), box.frame.axes(0, 0));
  return made;
}

/// The same pair in the plane: turned about z only, at the same height and equally thick there.
inline std::array<boxes::Box, 2> flattened(Random& random, std::array<boxes::Box, 2> pair) {
  for (boxes::Box& box : pair) {
    box.frame.origin.z() = box.displacement.z() = 0;
    box.half_lengths.z() = 1;
    const V turn = V{0, 0, random.uniform(-3, 3)};
    box.frame.axes = contact::matrix_of(contact::normalised(contact::exponential<double>(turn)));
  }
  return pair;
}

/// A bullet and a wall in the plane.
inline std::array<boxes::Box, 2> bullet_in_plane(Random& random) {
  std::array<boxes::Box, 2> pair;
  pair[0].half_lengths = V{5, 0.02, 1};
  pair[1].half_lengths = V{0.02, 0.01, 1};
  pair[1].frame.origin = V{random.uniform(-4, 4), random.uniform(1, 20), 0};
  pair[1].displacement = V{random.uniform(-3, 3), -random.uniform(5, 900), 0};
  return pair;
}

/// @param kind nothing: a bullet and a wall in the plane
inline Translating translating(const char* title, std::optional<boxes::Kind> kind, bool in_plane,
                               std::size_t count) {
  Random random(6);
  Translating made{title, in_plane, {}, {}, {}};
  for (std::size_t i = 0; i < count; ++i) {
    auto pair = kind ? boxes::make(random, *kind) : bullet_in_plane(random);
    if (in_plane && kind) pair = flattened(random, pair);
    made.pairs.push_back(pair);
    made.plain.push_back({plain(pair[0]), plain(pair[1])});
    const auto t = boxes::first_touch(pair[0], pair[1]);
    made.right.push_back(t ? std::optional<double>(oracle::nearest(*t)) : std::nullopt);
  }
  return made;
}

// ----------------------------------------------------------------------------- boxes that turn

inline peers::Box plain(const families::TurningBoxes& pair, std::size_t k) {
  peers::Box made;
  const auto start = contact::exponential<double>(pair.rotation[k]);
  const auto turn = contact::exponential<double>(pair.angular_displacement[k]);
  made.centre = plain(pair.position[k]);
  made.half_lengths = plain(pair.half_lengths[k]);
  made.displacement = plain(pair.displacement[k]);
  made.turn = plain(pair.angular_displacement[k]);
  made.axes = plain(contact::matrix_of(contact::normalised(start)));
  made.end_axes = plain(contact::matrix_of(contact::normalised(turn * start)));
  made.angle = pair.rotation[k].z();
  return made;
}

/// A box at a time.
struct Placed {
  V centre;
  Axes axes;
};
inline Placed placed(const peers::Box& box, Motion motion, double t) {
  const V centre = vector(box.centre) + vector(box.displacement) * t;
  const V turn = vector(box.turn);
  const double angle = turn.norm();
  const Axes start = matrix(box.axes), end = matrix(box.end_axes);
  if (angle == 0) return {centre, start};
  if (motion == Motion::constant_rate)
    return {centre, Axes(Eigen::AngleAxisd(angle * t, turn / angle).toRotationMatrix() * start)};
  if (motion == Motion::between_directions) {
    const double last = box.angle + turn.z();
    const double at = std::atan2((1 - t) * std::sin(box.angle) + t * std::sin(last),
                                 (1 - t) * std::cos(box.angle) + t * std::cos(last));
    return {centre, Axes(Eigen::AngleAxisd(at, V::UnitZ()).toRotationMatrix())};
  }
  Eigen::Quaterniond p(start);
  const Eigen::Quaterniond q(end);
  if (p.dot(q) < 0) p.coeffs() = -p.coeffs();
  Eigen::Quaterniond between;
  between.coeffs() = p.coeffs() * (1 - t) + q.coeffs() * t;
  return {centre, Axes(between.normalized().toRotationMatrix())};
}

/// The largest gap of two boxes on one of their fifteen axes: a lower bound of their distance, and
/// below 0 if they overlap.
inline double gap(const peers::Box& a, const peers::Box& b, Motion motion, double t) {
  const Placed at_a = placed(a, motion, t), at_b = placed(b, motion, t);
  const V d = at_b.centre - at_a.centre, ha = vector(a.half_lengths), hb = vector(b.half_lengths);
  double widest = -std::numeric_limits<double>::infinity();
  const auto note = [&](const V& axis) {
    const double length = axis.norm();
    if (!(length > 1e-6)) return;
    const double reach = (at_a.axes.transpose() * axis).cwiseAbs().dot(ha) +
                         (at_b.axes.transpose() * axis).cwiseAbs().dot(hb);
    widest = std::max(widest, (std::abs(axis.dot(d)) - reach) / length);
  };
  for (int i = 0; i < 3; ++i) {
    note(at_a.axes.col(i));
    note(at_b.axes.col(i));
    for (int j = 0; j < 3; ++j) note(V(at_a.axes.col(i)).cross(V(at_b.axes.col(j))));
  }
  return widest;
}

/// What samples of a motion prove.
struct Sampled {
  bool touches = false;  ///< they overlap by a micrometre at the time `by`
  double by = 1;         ///< so they first touch at this time or before
  bool clear = false;    ///< they are more than a centimetre apart throughout
};
inline Sampled sampled(const std::array<peers::Box, 2>& pair, Motion motion) {
  constexpr int samples = 512;
  const auto& [a, b] = pair;
  // Points of the boxes approach at most so fast; between directions the rate is not constant.
  const double faster = motion == Motion::constant_rate         ? 1
                        : motion == Motion::between_quaternions ? 1.3
                                                                : 6;
  const double rate = vector(a.displacement).norm() + vector(b.displacement).norm() +
                      faster * (vector(a.turn).norm() * vector(a.half_lengths).norm() +
                                vector(b.turn).norm() * vector(b.half_lengths).norm());
  Sampled found{false, 1, true};
  for (int i = 0; i <= samples; ++i) {
    const double t = double(i) / samples, here = gap(a, b, motion, t);
    if (!(here > 0.01 + rate / samples / 2)) found.clear = false;
    if (!(here < -1e-6)) continue;
    double free = i > 0 ? double(i - 1) / samples : 0, hit = t;
    for (int k = 0; k < 40 && i > 0; ++k) {
      const double middle = (free + hit) / 2;
      (gap(a, b, motion, middle) < -1e-6 ? hit : free) = middle;
    }
    return {true, hit, false};
  }
  return found;
}

/// Boxes that turn.
struct Turning {
  std::string title;
  bool in_plane = false;
  std::vector<std::array<contact::RotatingBox<double>, 2>> pairs;
  peers::Pairs plain;
};
inline Turning turning(families::Turning family, std::size_t count) {
  Random random(7);
  Turning made{std::string(families::name(family)), family == families::Turning::in_plane, {}, {}};
  for (std::size_t i = 0; i < count; ++i) {
    const auto pair = families::turning_boxes(random, family);
    std::array<contact::RotatingBox<double>, 2> kept;
    for (std::size_t k = 0; k < 2; ++k) {
      const auto start = contact::normalised(contact::exponential<double>(pair.rotation[k]));
      kept[k] = {pair.position[k], start, pair.half_lengths[k], pair.displacement[k],
                 pair.angular_displacement[k]};
    }
    made.pairs.push_back(kept);
    made.plain.push_back({plain(pair, 0), plain(pair, 1)});
  }
  return made;
}

// --------------------------------------------------------------------------------- moving points

/// Vertices and faces or edges that move, with the exact times.
struct Points {
  std::string title;
  std::string name;  ///< of its file
  bool edges = false;
  std::vector<families::MovingPoints> all;
  std::vector<std::optional<double>> right;
};
inline Points points(families::Points family, bool edges, std::size_t count) {
  Random random(8);
  Points made;
  made.title = (edges ? "edge and edge, " : "vertex and face, ") + std::string(name(family));
  made.name = (edges ? "ee_" : "vf_") + std::to_string(static_cast<int>(family));
  made.edges = edges;
  for (std::size_t i = 0; i < count; ++i) {
    const auto p = families::points(random, family, edges);
    made.all.push_back(p);
    moving_truth::Four four;
    for (std::size_t k = 0; k < 4; ++k) {
      four.start[k] = oracle::exact(p.start[k]);
      four.displacement[k] = oracle::exact(p.end[k]) - four.start[k];
    }
    auto t = edges ? moving_truth::edge_edge(four) : moving_truth::vertex_face(four);
    made.right.push_back(t ? std::optional<double>(t->nearest()) : std::nullopt);
  }
  return made;
}

}  // namespace toi_scenes
