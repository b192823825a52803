/// @file
/// Pairs of bodies in float and in double for the ladder, with bounds of their true distance, and
/// how wrong an answer is.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <contact/box_axes.hpp>
#include <contact/certified_cores.hpp>
#include <contact/convex_bodies.hpp>
#include <contact/convex_hull.hpp>
#include <contact/exact_gjk.hpp>
#include <contact/gjk.hpp>
#include <contact/proximity.hpp>
#include <contact/support.hpp>
#include <contact/support_bounds.hpp>
#include <contact/vector.hpp>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "pair_bodies.hpp"
#include "pair_families.hpp"

namespace measured_pairs {

using V = contact::Vector3<double>;

/// Declared only: the kind of a body with numbers of another type.
template <class To, class From>
contact::Sphere<To> kind_in_type(const contact::Sphere<From>&);
template <class To, class From>
contact::Capsule<To> kind_in_type(const contact::Capsule<From>&);
template <class To, class From>
contact::OrientedBox<To> kind_in_type(const contact::OrientedBox<From>&);
template <class To, class From>
contact::ConvexHull<To> kind_in_type(const contact::ConvexHull<From>&);
template <class To, class From>
contact::Cylinder<To> kind_in_type(const contact::Cylinder<From>&);
template <class To, class From>
contact::Ellipsoid<To> kind_in_type(const contact::Ellipsoid<From>&);
template <class To, class Body>
using InType = decltype(kind_in_type<To>(std::declval<Body>()));

/// The body with each number in another type. In float it is another body, nearby.
template <class To, contact::ConvexBody Body>
InType<To, Body> in_type(const Body& body) {
  const auto cast = [](const auto& v) { return contact::Vector3<To>(v.template cast<To>()); };
  InType<To, Body> made;
  if constexpr (requires { body.radius; }) made.radius = static_cast<To>(body.radius);
  if constexpr (requires { body.core; }) {
    made.core = {cast(body.core.start), cast(body.core.end)};
  } else if constexpr (requires { body.vertices; }) {
    for (const auto& v : body.vertices) made.vertices.push_back(cast(v));
  } else {
    made.centre = cast(body.centre);
    if constexpr (requires { body.axes; }) {
      made.axes = body.axes.template cast<To>();
      made.half_lengths = cast(body.half_lengths);
    }
  }
  return made;
}

/// Two bodies in both types: each method is judged by the bodies that it was given.
template <class A, class B>
struct Pair {
  Pair(A first, B second)
      : a(std::move(first)),
        b(std::move(second)),
        a_in_float(in_type<float>(a)),
        b_in_float(in_type<float>(b)) {}
  A a;
  B b;
  InType<float, A> a_in_float;
  InType<float, B> b_in_float;
};

/// A pair of a family of pair_families.hpp.
template <class A, class B>
Pair<A, B> drawn(generators::Random& random, pair_families::Family family) {
  const auto kind_a = pair_bodies::kind_of(A()), kind_b = pair_bodies::kind_of(B());
  const pair_families::Pair made = pair_families::pair(random, kind_a, kind_b, family);
  return {std::get<A>(made.a), std::get<B>(made.b)};
}

/// A capsule whose core is 2^-46 to 2^-30 m from an edge or a vertex of a box.
inline Pair<contact::Capsule<double>, contact::OrientedBox<double>> almost_meeting_cores(
    generators::Random& random) {
  const auto made = drawn<contact::Capsule<double>, contact::OrientedBox<double>>(
      random, pair_families::Family::random);
  const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
  V along = made.b.axes.col(0) * x + made.b.axes.col(1) * y;
  if (random.chance(0.5)) along += made.b.axes.col(2) * random.uniform(-1, 1);
  const V n = along.normalized();
  const V across = n.cross(random_poses::direction(random));
  const V near = contact::support(made.b, n) + n * std::abs(random.magnitude(-46, -30));
  contact::Capsule<double> capsule{{}, made.a.radius};
  capsule.core.start = near - across * random.uniform(0.2, 2);
  capsule.core.end = near + across * random.uniform(0.2, 2);
  return {capsule, made.b};
}

/// Two numbers with a signed distance between them, m.
struct Bounds {
  double low = 0, high = 0;
};

/// The signed distance of two bodies whose cores are apart, to a few roundings, or of two of which
/// one is smooth and that are apart, as certified_proximity() bounds it. Nothing for other pairs.
template <contact::ConvexBody A, contact::ConvexBody B>
std::optional<Bounds> true_distance(const A& a, const B& b) {
  if constexpr (contact::PolytopeCore<A> && contact::PolytopeCore<B>) {
    const contact::GjkResult<double> near = contact::gjk(a, b);
    std::array<contact::DifferenceIndex, 4> start;
    for (std::size_t i = 0; i < 4; ++i) start[i] = {near.simplex[i].a, near.simplex[i].b};
    const auto known = std::span(start).first(static_cast<std::size_t>(near.count));
    const contact::ExactClosest exact = contact::exact_gjk(a, b, known);
    if (contact::rounded_direction(exact) == V::Zero()) return std::nullopt;
    const double distance =
        contact::rounded_distance(exact) - (contact::radius_of(a) + contact::radius_of(b));
    return Bounds{distance, distance};
  } else {
    const contact::CertifiedProximity certified = contact::certified_proximity(a, b);
    if (certified.state != contact::Proximity::disjoint) return std::nullopt;
    return Bounds{certified.low, certified.high};
  }
}

/// (Least n · x over A) − (largest n · x over B), to rounding.
template <contact::ConvexBody A, contact::ConvexBody B>
double separation(const A& a, const B& b, const V& n) {
  const contact::SupportBounds in_front = contact::support_bounds(a, V(-n));
  const contact::SupportBounds behind = contact::support_bounds(b, n);
  return -(in_front.down + in_front.up) / 2 - (behind.down + behind.up) / 2;
}

/// The vertices of a polytope that has a volume, its faces' normals, of length 1, and its edges'
/// directions.
struct Features {
  std::vector<V> vertices, normals, edges;
};
/// Of the stored axes of a box, since edges between rounded vertices of a thin one are off.
inline Features features(const contact::OrientedBox<double>& box) {
  Features found;
  for (int i = 0; i < 8; ++i) found.vertices.push_back(contact::vertex(box, i));
  for (int i = 0; i < 3; ++i) {
    found.edges.push_back(box.axes.col(i));
    const V normal = contact::box_axis(box, box, i).normalized();
    found.normals.insert(found.normals.end(), {normal, V(-normal)});
  }
  return found;
}
template <contact::PolytopeCore Body>
Features features(const Body& body) {
  Features found;
  std::vector<V>& v = found.vertices;
  for (int i = 0; i < contact::vertex_count(body); ++i) v.push_back(contact::vertex(body, i));
  const contact::Hull hull = contact::convex_hull(v);
  const auto at = [&v](int i) { return v[static_cast<std::size_t>(i)]; };
  for (int f = 0; f < hull.face_count(); ++f) {
    const std::span<const int> face = hull.face(f);
    const V edge = at(face[1]) - at(face[0]);
    found.normals.push_back(edge.cross(V(at(face[2]) - at(face[0]))).normalized());
    for (std::size_t i = 0; i < face.size(); ++i) {
      const int from = face[i], to = face[(i + 1) % face.size()];
      if (from < to) found.edges.push_back(V(at(to) - at(from)).normalized());
    }
  }
  return found;
}

/// A separation and the direction that it is along.
struct Along {
  double separation = -std::numeric_limits<double>::infinity();  ///< m
  V normal = V::Zero();                                          ///< unit vector, from B to A
};

/// The largest separation of two polytopes along a normal of a face of either, or of either and an
/// edge of each: for polytopes that meet minus their depth, because every face of the difference is
/// parallel to one of these planes. No direction can exceed it, so what it lacks is due to
/// rounding.
template <contact::PolytopeCore A, contact::PolytopeCore B>
Along by_features(const A& a, const B& b, bool with_edges = true) {
  const Features of_a = features(a), of_b = features(b);
  Along best;
  const auto lowest = [](const std::vector<V>& points, const V& n) {
    double least = std::numeric_limits<double>::infinity();
    for (const V& p : points) least = std::min(least, n.dot(p));
    return least;
  };
  const auto try_one = [&](const V& n) {
    const double separation = lowest(of_a.vertices, n) + lowest(of_b.vertices, V(-n));
    if (separation > best.separation) best = {separation, n};
  };
  for (const V& n : of_a.normals) try_one(V(-n));
  for (const V& n : of_b.normals) try_one(n);
  for (std::size_t i = 0; with_edges && i < of_a.edges.size(); ++i) {
    for (const V& e : of_b.edges) {
      // Of almost parallel edges the difference is short and accurate.
      const V& d = of_a.edges[i];
      const V n = d.cross(d.dot(e) < 0 ? V(e + d) : V(e - d));
      if (!(n.squaredNorm() > 0)) continue;
      try_one(n.normalized());
      try_one(-n.normalized());
    }
  }
  best.separation -= contact::radius_of(a) + contact::radius_of(b);
  return best;
}

/// How wrong a signed distance and a normal are, m: the larger of how far the distance is outside
/// of the bounds, and how far from touching the bodies are, along the normal, after A has been
/// moved by −distance along it.
/// @return infinite if a number is not finite or the normal is 0
template <contact::ConvexBody A, contact::ConvexBody B>
double error_of(const A& a, const B& b, const Bounds& right, double distance, const V& normal) {
  const double length = normal.norm();
  if (!std::isfinite(distance) || !(length > 0)) return std::numeric_limits<double>::infinity();
  const double outside = std::max({0.0, right.low - distance, distance - right.high});
  return std::max(outside, std::abs(separation(a, b, V(normal / length)) - distance));
}

}  // namespace measured_pairs
