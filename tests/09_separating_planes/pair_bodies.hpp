/// @file
/// Convex bodies of every kind, drawn in a frame: the bodies of pair_families.hpp.
#pragma once

#include <support/generators.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <contact/convex_bodies.hpp>
#include <contact/support.hpp>
#include <contact/vector.hpp>
#include <cstddef>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "random_poses.hpp"

namespace pair_bodies {

using generators::Random;
using V = contact::Vector3<double>;

/// The kinds of convex body.
enum class Kind { sphere, capsule, lozenge, box, triangle, hull, cylinder, ellipsoid };
inline constexpr std::array<Kind, 8> all_kinds{Kind::sphere,   Kind::capsule,  Kind::lozenge,
                                               Kind::box,      Kind::triangle, Kind::hull,
                                               Kind::cylinder, Kind::ellipsoid};
/// Those whose core is a polytope.
inline constexpr std::array<Kind, 6> polytope_kinds{Kind::sphere, Kind::capsule,  Kind::lozenge,
                                                    Kind::box,    Kind::triangle, Kind::hull};
inline constexpr std::string_view name(Kind kind) {
  constexpr std::array<std::string_view, all_kinds.size()> names{
      "sphere", "capsule", "lozenge", "box", "triangle", "hull", "cylinder", "ellipsoid"};
  return names[static_cast<std::size_t>(kind)];
}
inline constexpr bool is_smooth(Kind kind) {
  return kind == Kind::cylinder || kind == Kind::ellipsoid;
}

/// A body of any kind; the index is that of its Kind.
using Body = std::variant<contact::Sphere<double>, contact::Capsule<double>,
                          contact::Lozenge<double>, contact::OrientedBox<double>,
                          contact::Triangle<double>, contact::ConvexHull<double>,
                          contact::Cylinder<double>, contact::Ellipsoid<double>>;
inline Kind kind_of(const Body& body) { return static_cast<Kind>(body.index()); }

/// Where a body is and how large it is along three axes.
struct Frame {
  V centre = V::Zero();
  contact::Matrix3<double> axes = contact::Matrix3<double>::Identity();
  V half = V::Ones();

  /// Half of an axis of the body.
  V half_axis(int i) const { return axes.col(i) * half(i); }
  V at(double x, double y, double z) const {
    return centre + half_axis(0) * x + half_axis(1) * y + half_axis(2) * z;
  }
};

namespace detail {

/// An octahedron; with `corners`, random points of the frame besides.
inline contact::ConvexHull<double> hull(Random& random, const Frame& f, int corners) {
  contact::ConvexHull<double> made;
  for (int i = 0; i < 3; ++i) {
    made.vertices.push_back(f.centre + f.half_axis(i));
    made.vertices.push_back(f.centre - f.half_axis(i));
  }
  for (int i = 0; i < corners; ++i) {
    const double x = random.uniform(-1, 1);
    const double y = random.uniform(-1, 1);
    made.vertices.push_back(f.at(x, y, random.uniform(-1, 1)));
  }
  return made;
}

}  // namespace detail

/// The body of a kind that fills a frame. With whole numbers and axes of 0 and ±1, all its stored
/// numbers are whole.
/// @param corners more vertices of a hull than six
inline Body body_in(Random& random, Kind kind, const Frame& f, int corners = 0) {
  switch (kind) {
    case Kind::sphere:
      return contact::Sphere<double>{f.centre, f.half(0)};
    case Kind::capsule:
      return contact::Capsule<double>{{V(f.centre - f.half_axis(0)), V(f.centre + f.half_axis(0))},
                                      f.half(1)};
    case Kind::lozenge:
      return contact::Lozenge<double>{f.at(-1, -1, 0), V(2 * f.half_axis(0)), V(2 * f.half_axis(1)),
                                      f.half(2)};
    case Kind::box:
      return contact::OrientedBox<double>{f.centre, f.axes, f.half};
    case Kind::triangle:
      return contact::Triangle<double>{f.at(1, 0, 0), f.at(-1, 1, 0), f.at(-1, -1, 0)};
    case Kind::hull:
      return detail::hull(random, f, corners);
    case Kind::cylinder:
      return contact::Cylinder<double>{{V(f.centre - f.half_axis(2)), V(f.centre + f.half_axis(2))},
                                       f.half(0)};
    default:
      return contact::Ellipsoid<double>{f.centre, f.axes, f.half};
  }
}

namespace detail {

/// Calls `point` with every stored position, `vector` with every edge and `length` with every
/// radius or half length.
template <class Point, class Edge, class Length>
struct Visit {
  const Point& point;
  const Edge& edge;
  const Length& length;

  void operator()(contact::Sphere<double>& b) const { point(b.centre), length(b.radius); }
  void operator()(contact::Capsule<double>& b) const {
    point(b.core.start), point(b.core.end), length(b.radius);
  }
  void operator()(contact::Cylinder<double>& b) const {
    point(b.core.start), point(b.core.end), length(b.radius);
  }
  void operator()(contact::Lozenge<double>& b) const {
    point(b.corner), edge(b.first_edge), edge(b.second_edge), length(b.radius);
  }
  void operator()(contact::Triangle<double>& b) const { point(b.a), point(b.b), point(b.c); }
  void operator()(contact::ConvexHull<double>& b) const {
    for (V& v : b.vertices) point(v);
    length(b.radius);
  }
  void operator()(contact::OrientedBox<double>& b) const { point(b.centre), edge(b.half_lengths); }
  void operator()(contact::Ellipsoid<double>& b) const { point(b.centre), edge(b.half_lengths); }
};
template <class Point, class Edge, class Length>
void visit(Body& body, const Point& point, const Edge& edge, const Length& length) {
  std::visit(Visit<Point, Edge, Length>{point, edge, length}, body);
}

}  // namespace detail

/// The body moved by t. Each stored position is rounded.
inline Body moved(Body body, const V& t) {
  detail::visit(
      body, [&](V& p) { p += t; }, [](V&) {}, [](double&) {});
  return body;
}
/// All stored lengths times a power of two, which is exact unless it underflows.
inline Body scaled(Body body, int power) {
  const auto scale = [power](V& v) {
    for (int i = 0; i < 3; ++i) v(i) = std::ldexp(v(i), power);
  };
  detail::visit(body, scale, scale, [power](double& x) { x = std::ldexp(x, power); });
  return body;
}
/// The sum of the sizes of all stored lengths of a body: errors are in u of it.
inline double size_of(Body body) {
  double size = 0;
  const auto add = [&](const V& v) { size = std::max(size, v.cwiseAbs().sum()); };
  double extent = 0;
  detail::visit(
      body, add, [&](const V& v) { extent += v.cwiseAbs().sum(); }, [&](double x) { extent += x; });
  return size + extent;
}

/// Calls f with the two bodies in their own types.
template <class F>
auto with(const Body& a, const Body& b, const F& f) {
  return std::visit([&](const auto& x, const auto& y) { return f(x, y); }, a, b);
}
/// The same for polytope cores: f is not compiled for others.
template <class F>
void with_polytopes(const Body& a, const Body& b, const F& f) {
  std::visit(
      [&](const auto& x, const auto& y) {
        if constexpr (contact::PolytopeCore<std::decay_t<decltype(x)>> &&
                      contact::PolytopeCore<std::decay_t<decltype(y)>>) {
          f(x, y);
        }
      },
      a, b);
}

}  // namespace pair_bodies
