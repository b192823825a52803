/// @file
/// Pairs of convex bodies of two kinds that translate, with what is right, and as other programs
/// take them.
#pragma once

#include <array>
#include <cmath>
#include <contact/convex_bodies.hpp>
#include <contact/vector.hpp>
#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "09_separating_planes/pair_cores.hpp"
#include "09_separating_planes/pair_truth.hpp"
#include "11_time_of_impact/moving_bodies.hpp"
#include "peers.hpp"

namespace body_scenes {

using moving_bodies::Body;
using moving_bodies::Family;
using moving_bodies::Pair;
using moving_bodies::V;
using oracle::Rational;

inline peers::Numbers plain(const V& v) { return {v.x(), v.y(), v.z()}; }

/// A frame whose third axis is along d.
inline std::array<peers::Numbers, 3> frame_along(const V& d) {
  const V z = d.norm() > 0 ? V(d.normalized()) : V(V::UnitZ());
  const V least = std::abs(z.x()) < 0.6 ? V(V::UnitX()) : V(V::UnitY());
  const V x = least.cross(z).normalized();
  return {plain(x), plain(V(z.cross(x))), plain(z)};
}

struct Plain {
  peers::Body& to;

  void operator()(const contact::Sphere<double>& b) const {
    to.kind = peers::Kind::sphere;
    to.centre = plain(b.centre);
    to.radius = b.radius;
  }
  void operator()(const contact::Capsule<double>& b) const {
    const V d = b.core.end - b.core.start;
    to.kind = peers::Kind::capsule;
    to.centre = plain(V(b.core.start + d / 2));
    to.axes = frame_along(d);
    to.half_lengths = {0, 0, d.norm() / 2};
    to.radius = b.radius;
  }
  void operator()(const contact::OrientedBox<double>& b) const {
    to.kind = peers::Kind::box;
    to.centre = plain(b.centre);
    to.axes = {plain(V(b.axes.col(0))), plain(V(b.axes.col(1))), plain(V(b.axes.col(2)))};
    to.half_lengths = plain(b.half_lengths);
  }
  void operator()(const contact::Triangle<double>& b) const {
    to.kind = peers::Kind::triangle;
    to.points = {plain(b.a), plain(b.b), plain(b.c)};
  }
  void operator()(const contact::ConvexHull<double>& b) const {
    to.kind = peers::Kind::hull;
    for (const V& v : b.vertices) to.points.push_back(plain(v));
    to.radius = b.radius;
  }
  void operator()(const contact::Lozenge<double>&) const {}
};

inline peers::Body plain(const Body& body, const V& displacement) {
  peers::Body made;
  std::visit(Plain{made}, body);
  made.displacement = plain(displacement);
  return made;
}

/// Bodies of two kinds, with exact answers.
class Scene {
 public:
  std::string title;
  std::vector<Pair> pairs;
  peers::BodyPairs plain_pairs;
  std::vector<char> right;  ///< whether they touch in the step

  /// Whether pair i has a common point from 0 to t, exactly.
  bool touch_by(std::size_t i, const Rational& t) const {
    const pair_truth::Core& a = cores_[i][0];
    std::vector<oracle::Vector> points = a.vertices;
    for (const oracle::Vector& v : a.vertices)
      points.push_back(oracle::Vector(v + relative_[i] * t));
    return pair_truth::truth(pair_truth::core_of_points(points, a.radius), cores_[i][1]).sign <= 0;
  }
  /// The distance of pair i at t, m.
  double distance_at(std::size_t i, const Rational& t) const {
    pair_truth::Core moved = cores_[i][0];
    for (oracle::Vector& v : moved.vertices) v = v + relative_[i] * t;
    return oracle::nearest(pair_truth::truth(moved, cores_[i][1]).distance);
  }
  void add(const Pair& pair) {
    const auto core = [](const Body& body) {
      return std::visit([](const auto& b) { return pair_truth::core_of(b); }, body);
    };
    pairs.push_back(pair);
    plain_pairs.push_back({plain(pair.a, pair.displacement_a), plain(pair.b, pair.displacement_b)});
    cores_.push_back({core(pair.a), core(pair.b)});
    relative_.push_back(oracle::exact(pair.displacement_a) - oracle::exact(pair.displacement_b));
    right.push_back(touch_by(pairs.size() - 1, 1) ? 1 : 0);
  }

 private:
  std::vector<std::array<pair_truth::Core, 2>> cores_;
  std::vector<oracle::Vector> relative_;
};

inline Scene scene(const char* title, Family family, int kind_a, int kind_b, std::size_t count) {
  moving_bodies::Random random(9);
  Scene made;
  made.title = title;
  for (std::size_t i = 0; i < count; ++i)
    made.add(moving_bodies::make(random, family, kind_a, kind_b));
  return made;
}

}  // namespace body_scenes
