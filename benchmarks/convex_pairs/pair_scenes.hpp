/// @file
/// Pairs of convex bodies to ask of, with what is right, and as other programs take them.
#pragma once

#include <array>
#include <cmath>
#include <contact/vector.hpp>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "09_separating_planes/pair_bodies.hpp"
#include "09_separating_planes/pair_families.hpp"
#include "09_separating_planes/pair_proofs.hpp"
#include "09_separating_planes/pair_truth.hpp"
#include "peers.hpp"

namespace pair_scenes {

using pair_bodies::Body;
using pair_bodies::Kind;
using pair_bodies::V;
using pair_families::Family;
using pair_families::Pair;

inline peers::Numbers plain(const V& v) { return {v.x(), v.y(), v.z()}; }

namespace detail {

inline std::array<peers::Numbers, 3> plain(const contact::Matrix3<double>& axes) {
  return {pair_scenes::plain(V(axes.col(0))), pair_scenes::plain(V(axes.col(1))),
          pair_scenes::plain(V(axes.col(2)))};
}
/// A frame whose third axis is along d.
inline std::array<peers::Numbers, 3> frame_along(const V& d) {
  const V z = d.norm() > 0 ? V(d.normalized()) : V(V::UnitZ());
  int least = 0;
  for (int i = 1; i < 3; ++i) {
    if (std::abs(z(i)) < std::abs(z(least))) least = i;
  }
  const V x = V(V::Unit(least).cross(z)).normalized();
  return {pair_scenes::plain(x), pair_scenes::plain(V(z.cross(x))), pair_scenes::plain(z)};
}
inline void place(peers::Shape& to, const contact::Segment<double>& core) {
  const V d = core.end - core.start;
  to.centre = pair_scenes::plain(V(core.start + d / 2));
  to.axes = frame_along(d);
  to.half_lengths = {0, 0, d.norm() / 2};
}

struct Plain {
  peers::Shape& to;

  void operator()(const contact::Sphere<double>& b) const {
    to.centre = pair_scenes::plain(b.centre);
    to.radius = b.radius;
  }
  void operator()(const contact::Capsule<double>& b) const {
    place(to, b.core);
    to.radius = b.radius;
  }
  void operator()(const contact::Cylinder<double>& b) const {
    place(to, b.core);
    to.radius = b.radius;
  }
  void operator()(const contact::Lozenge<double>& b) const {
    to.centre = pair_scenes::plain(V(b.corner + b.first_edge / 2 + b.second_edge / 2));
    const V x = b.first_edge.normalized(), y = b.second_edge.normalized();
    to.axes = {pair_scenes::plain(x), pair_scenes::plain(y), pair_scenes::plain(V(x.cross(y)))};
    to.half_lengths = {b.first_edge.norm() / 2, b.second_edge.norm() / 2, 0};
    to.radius = b.radius;
  }
  void operator()(const contact::Triangle<double>& b) const {
    to.points = {pair_scenes::plain(b.a), pair_scenes::plain(b.b), pair_scenes::plain(b.c)};
  }
  void operator()(const contact::ConvexHull<double>& b) const {
    for (const V& v : b.vertices) to.points.push_back(pair_scenes::plain(v));
    to.radius = b.radius;
  }
  template <class Framed>
  void operator()(const Framed& b) const {
    to.centre = pair_scenes::plain(b.centre);
    to.axes = plain(b.axes);
    to.half_lengths = pair_scenes::plain(b.half_lengths);
  }
};

}  // namespace detail

/// A body as other programs take it: those with a frame of their own round it.
inline peers::Shape plain(const Body& body) {
  peers::Shape made;
  made.kind = static_cast<peers::Kind>(body.index());
  std::visit(detail::Plain{made}, body);
  return made;
}

/// 1: disjoint, 0: touching, −1: overlapping; nothing where no direction and point at hand prove
/// one of them, which happens for cylinders and ellipsoids.
inline std::optional<int> right_sign(const Pair& pair) {
  std::optional<int> sign;
  if (pair_bodies::is_smooth(pair_bodies::kind_of(pair.a)) ||
      pair_bodies::is_smooth(pair_bodies::kind_of(pair.b))) {
    return pair_proofs::proved(pair.a, pair.b, oracle::exact(pair.normal),
                               oracle::exact(pair.point));
  }
  pair_bodies::with_polytopes(
      pair.a, pair.b, [&](const auto& a, const auto& b) { sign = pair_truth::truth(a, b).sign; });
  return sign;
}

/// Pairs of one question.
struct Scene {
  std::string title;
  std::vector<Pair> pairs;
  peers::Pairs plain;
  std::vector<int> right;  ///< signs
};

/// What a scene is about.
struct Group {
  const char* title;
  std::vector<Family> families;
  std::optional<int> sign;  ///< the only one taken
};
inline std::vector<Group> groups() {
  return {{"random or near, apart", {Family::random, Family::near}, 1},
          {"random or near, overlapping", {Family::random, Family::near}, -1},
          {"touching but for an ulp",
           {Family::touching, Family::grid, Family::grid_step, Family::parallel},
           {}},
          {"deep", {Family::deep}, {}},
          {"nearly parallel", {Family::nearly_parallel}, {}},
          {"thin, 1:10^6", {Family::thin}, {}},
          {"large, 10^8:1, or far", {Family::large, Family::far}, {}},
          {"equal poses", {Family::equal}, {}}};
}

inline Scene scene(Kind a, Kind b, const Group& group, std::size_t count) {
  generators::Random random(100 * static_cast<std::uint64_t>(a) + static_cast<std::uint64_t>(b));
  Scene made{std::string(pair_bodies::name(a)) + " and " + std::string(pair_bodies::name(b)) +
                 ", " + group.title,
             {},
             {},
             {}};
  std::size_t drawn = 0;
  while (made.pairs.size() < count && drawn < 20 * count) {
    const Family family = group.families[drawn++ % group.families.size()];
    const Pair pair = pair_families::pair(random, a, b, family);
    const std::optional<int> sign = right_sign(pair);
    if (!sign || (group.sign && *group.sign != *sign)) continue;
    made.pairs.push_back(pair);
    made.plain.push_back({plain(pair.a), plain(pair.b)});
    made.right.push_back(*sign);
  }
  return made;
}

/// Whether moving the first body by a signed distance against its direction does not make the two
/// touch, by more than a millionth of their sizes. For smooth bodies: whether they are not apart by
/// that distance along that direction.
inline bool is_inconsistent(const Pair& pair, const peers::Witness& witness) {
  const double size = pair_bodies::size_of(pair.a) + pair_bodies::size_of(pair.b);
  const V n(witness.normal[0], witness.normal[1], witness.normal[2]);
  if (!n.allFinite() || !std::isfinite(witness.distance)) return true;
  if (!(std::abs(n.norm() - 1) <= 1e-6)) return true;
  const double room = 1e-6 * size;
  if (pair_bodies::is_smooth(pair_bodies::kind_of(pair.a)) ||
      pair_bodies::is_smooth(pair_bodies::kind_of(pair.b))) {
    return pair_proofs::gap_along(pair.a, pair.b, n) < witness.distance - room;
  }
  double left = 0;
  const Body moved = pair_bodies::moved(pair.a, V(n * -witness.distance));
  pair_bodies::with_polytopes(moved, pair.b, [&](const auto& a, const auto& b) {
    left = oracle::nearest(pair_truth::truth(a, b).distance);
  });
  return !(std::abs(left) <= room);
}

}  // namespace pair_scenes
