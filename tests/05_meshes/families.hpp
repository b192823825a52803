/// @file
/// Meshes, and segments and points that are hard to decide about them, for the ladder and for the
/// comparison with other programs. Every coordinate is a float, so that every method in every
/// scalar gets the same input; most are multiples of 2^-20, so that many segments go exactly
/// through an edge or a vertex. Eigen only: the ladder uses them in the page.
#pragma once

#include <support/generators.hpp>

#include <array>
#include <cmath>
#include <contact/aabb.hpp>
#include <contact/mesh.hpp>
#include <contact/mesh_shapes.hpp>
#include <contact/shapes.hpp>
#include <contact/vector.hpp>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace mesh_families {

using contact::Mesh;
using contact::Segment;
using generators::Random;
using Point = contact::Vector3<double>;
using Numbers = contact::Vector3<float>;

/// Rounded to floats. Not inlined: GCC 12.2 with -O2 takes two doubles that are rounded to float
/// and converted back for the same doubles, and so leaves the rounding out.
[[gnu::noinline]] inline Numbers in_float(const Point& v) { return v.cast<float>(); }

/// A closed mesh, oriented outwards, in both types.
struct Body {
  Mesh<float> in_float;
  Mesh<double> in_double;
  contact::Aabb<double> box;
};
using Bodies = std::vector<Body>;

/// A segment at a body, and a point near one.
struct SegmentAt {
  const Body* body = nullptr;
  Segment<float> segment;
};
struct PointAt {
  const Body* body = nullptr;
  Numbers point;
};

// Bodies -------------------------------------------------------------------------------------

/// A body whose coordinates are floats.
inline Body rounded(const Mesh<double>& mesh) {
  Body body;
  body.in_float.triangles = body.in_double.triangles = mesh.triangles;
  for (const Point& v : mesh.vertices) {
    body.in_float.vertices.push_back(in_float(v));
    body.in_double.vertices.push_back(body.in_float.vertices.back().cast<double>());
  }
  body.box = contact::aabb_of_points<double>(body.in_double.vertices);
  return body;
}

/// Vertices at multiples of 2^-20.
inline Mesh<double> on_lattice(Mesh<double> mesh) {
  for (Point& v : mesh.vertices) {
    for (double& x : v) x = std::ldexp(std::round(std::ldexp(x, 20)), -20);
  }
  return mesh;
}

/// A ball of 80 triangles with each vertex moved to a random distance: concave, without crossing
/// itself.
inline Mesh<double> bumpy(Random& random) {
  Mesh<double> mesh = contact::ball_mesh(1, 1);
  for (Point& v : mesh.vertices) v *= random.uniform(0.4, 1);
  return mesh;
}

namespace detail {

inline std::vector<Mesh<double>> usual_meshes() {
  Random random(1);
  std::vector<Mesh<double>> meshes;
  for (int i = 0; i < 6; ++i) meshes.push_back(on_lattice(bumpy(random)));
  meshes.push_back(on_lattice(contact::torus_mesh(0.7, 0.3, 8, 6)));
  meshes.push_back(on_lattice(contact::torus_mesh(0.6, 0.15, 10, 4)));
  return meshes;
}

inline Bodies all_rounded(const std::vector<Mesh<double>>& meshes) {
  Bodies bodies;
  for (const Mesh<double>& mesh : meshes) bodies.push_back(rounded(mesh));
  return bodies;
}

}  // namespace detail

/// Concave bodies, two of them tori.
inline const Bodies& usual() {
  static const Bodies bodies = detail::all_rounded(detail::usual_meshes());
  return bodies;
}

/// Balls of 80 triangles, as if cut from a sphere.
inline const Bodies& convex() {
  static const Bodies bodies = [] {
    Random random(2);
    std::vector<Mesh<double>> meshes;
    for (int i = 0; i < 4; ++i) {
      Mesh<double> mesh = contact::ball_mesh(1, 1);
      const Point size{random.uniform(0.4, 1), random.uniform(0.4, 1), random.uniform(0.4, 1)};
      for (Point& v : mesh.vertices) v = v.cwiseProduct(size);
      meshes.push_back(on_lattice(mesh));
    }
    return detail::all_rounded(meshes);
  }();
  return bodies;
}

/// Whole numbers: boxes, octahedra, prisms over polygons with edges along the axes and others.
inline const Bodies& whole() {
  static const Bodies bodies = [] {
    using P = contact::Vector2<double>;
    return detail::all_rounded(
        {contact::box_mesh(Point(-1, -1, -1), Point(1, 1, 1)),
         contact::box_mesh(Point(-2, -1, 0), Point(1, 1, 1)), contact::octahedron_mesh(1),
         contact::octahedron_mesh(2),
         contact::prism_mesh({P(-2, -2), P(2, -2), P(2, 0), P(0, 0), P(0, 2), P(-2, 2)}, -1, 1),
         contact::prism_mesh({P(-2, -1), P(0, -2), P(2, -1), P(1, 0), P(2, 2), P(0, 1), P(-2, 2)},
                             -1, 2)});
  }();
  return bodies;
}

/// The usual ones, 256 times as long as they are thick: so are many of their triangles.
inline const Bodies& thin() {
  static const Bodies bodies = [] {
    std::vector<Mesh<double>> meshes = detail::usual_meshes();
    for (Mesh<double>& mesh : meshes) {
      for (Point& v : mesh.vertices) v = {v.x(), std::ldexp(v.y(), -8), std::ldexp(v.z(), -8)};
      mesh = on_lattice(mesh);
    }
    return detail::all_rounded(meshes);
  }();
  return bodies;
}

/// The usual ones, in the same order, 512 times as small: about 4 mm in size.
inline const Bodies& small() {
  static const Bodies bodies = [] {
    std::vector<Mesh<double>> meshes = detail::usual_meshes();
    for (Mesh<double>& mesh : meshes) {
      for (Point& v : mesh.vertices) v *= 0x1p-9;
    }
    return detail::all_rounded(meshes);
  }();
  return bodies;
}

/// The usual ones, 8 times as large and half a million metres from the origin, where floats are a
/// thirty-second apart.
inline const Bodies& far_away() {
  static const Bodies bodies = [] {
    Random random(3);
    std::vector<Mesh<double>> meshes = detail::usual_meshes();
    for (Mesh<double>& mesh : meshes) {
      const Point offset{random.magnitude(18, 18), random.magnitude(18, 18),
                         random.magnitude(18, 18)};
      for (Point& v : mesh.vertices) v = 8 * v + offset;
    }
    return detail::all_rounded(meshes);
  }();
  return bodies;
}

// Parts of a body ----------------------------------------------------------------------------

inline const Body& any(Random& random, const Bodies& bodies) {
  return bodies[static_cast<std::size_t>(random.integer(0, static_cast<int>(bodies.size()) - 1))];
}
inline std::size_t any_triangle(Random& random, const Mesh<double>& mesh) {
  return static_cast<std::size_t>(random.integer(0, static_cast<int>(mesh.triangles.size()) - 1));
}
inline const Point& corner(const Mesh<double>& mesh, std::size_t triangle, int i) {
  const int vertex = mesh.triangles[triangle][static_cast<std::size_t>(i % 3)];
  return mesh.vertices[static_cast<std::size_t>(vertex)];
}
inline const Point& any_vertex(Random& random, const Mesh<double>& mesh) {
  const std::size_t triangle = any_triangle(random, mesh);
  return corner(mesh, triangle, random.integer(0, 2));
}
/// A point of an edge: every second one at a quarter of it, which is a float if the vertices are
/// multiples of 2^-20.
inline Point on_edge(Random& random, const Mesh<double>& mesh) {
  const std::size_t triangle = any_triangle(random, mesh);
  const int i = random.integer(0, 2);
  const Point &a = corner(mesh, triangle, i), &b = corner(mesh, triangle, i + 1);
  const double share = random.chance(0.5) ? random.integer(1, 3) / 4.0 : random.uniform();
  return in_float(a + share * (b - a)).cast<double>();
}
/// A point of a triangle, as rounded.
inline Point on_face(Random& random, const Mesh<double>& mesh) {
  const std::size_t triangle = any_triangle(random, mesh);
  const Point &a = corner(mesh, triangle, 0), &b = corner(mesh, triangle, 1),
              &c = corner(mesh, triangle, 2);
  const double u = random.uniform(), v = random.uniform();
  const Point p = u + v <= 1 ? Point(a + u * (b - a) + v * (c - a))
                             : Point(a + (1 - u) * (b - a) + (1 - v) * (c - a));
  return in_float(p).cast<double>();
}
/// A point of the body's box, or of one that is larger by this factor. Coordinates are multiples of
/// 2^-20 if the box is near the origin.
inline Point near_body(Random& random, const Body& body, double factor) {
  const Point middle = (body.box.low + body.box.high) / 2;
  const Point half = (body.box.high - body.box.low) / 2 * factor;
  Point p{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
  p = middle + half.cwiseProduct(p);
  for (double& x : p) x = std::ldexp(std::round(std::ldexp(x, 20)), -20);
  return in_float(p).cast<double>();
}
/// A point around the body, at most three of its half lengths away, thin bodies included.
inline Point around(Random& random, const Body& body) {
  const double size = (body.box.high - body.box.low).maxCoeff();
  const Point middle = (body.box.low + body.box.high) / 2;
  Point p{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
  p = middle + size * p;
  for (double& x : p) x = std::ldexp(std::round(std::ldexp(x, 20)), -20);
  return in_float(p).cast<double>();
}
inline float beside(Random& random, float x) {
  return std::nextafter(x, random.chance(0.5) ? 4.0f * std::abs(x) + 1 : -4.0f * std::abs(x) - 1);
}

// Segments -----------------------------------------------------------------------------------

inline SegmentAt between(const Body& body, const Point& start, const Point& end) {
  return {&body, {in_float(start), in_float(end)}};
}
/// From a point around the body through the target, and as far again beyond it: exactly, if the
/// numbers are multiples of 2^-22.
inline SegmentAt through(Random& random, const Body& body, const Point& target) {
  const Point start = around(random, body);
  return between(body, start, target + (target - start));
}

inline SegmentAt segment_random(Random& random) {
  const Body& body = any(random, usual());
  const Point start = around(random, body);
  return between(body, start, near_body(random, body, 1.2));
}
inline SegmentAt segment_at_edge(Random& random) {
  const Body& body = any(random, random.chance(0.25) ? whole() : usual());
  const Point target = on_edge(random, body.in_double);
  return through(random, body, target);
}
inline SegmentAt segment_at_vertex(Random& random) {
  const Body& body = any(random, random.chance(0.25) ? whole() : usual());
  const Point target = any_vertex(random, body.in_double);
  return through(random, body, target);
}
/// Both ends in the plane of one triangle, exactly: at halves of its edges.
inline SegmentAt segment_in_face(Random& random) {
  const Body& body = any(random, random.chance(0.5) ? whole() : usual());
  const std::size_t triangle = any_triangle(random, body.in_double);
  const Point& a = corner(body.in_double, triangle, 0);
  const Point ab = corner(body.in_double, triangle, 1) - a;
  const Point ac = corner(body.in_double, triangle, 2) - a;
  const auto in_plane = [&] {
    const int u = random.integer(-3, 4), v = random.integer(-3, 4);
    return Point(a + u / 2.0 * ab + v / 2.0 * ac);
  };
  const Point start = in_plane();
  return between(body, start, in_plane());
}
/// From a thousand to a million metres away through a point of an edge, as rounded, and on by up to
/// a metre.
inline SegmentAt segment_far(Random& random) {
  const Body& body = any(random, usual());
  const Point target = on_edge(random, body.in_double);
  const Point start{random.magnitude(10, 19), random.magnitude(10, 19), random.magnitude(10, 19)};
  const double beyond = random.uniform() / std::sqrt((target - start).squaredNorm());
  return between(body, start, target + beyond * (target - start));
}
inline SegmentAt segment_thin(Random& random) {
  const Body& body = any(random, thin());
  const Point target =
      random.chance(0.5) ? on_edge(random, body.in_double) : near_body(random, body, 1);
  return through(random, body, target);
}

/// As at random, 512 times as small.
inline SegmentAt segment_small(Random& random) {
  SegmentAt aimed = segment_random(random);
  aimed.body = &small()[static_cast<std::size_t>(aimed.body - usual().data())];
  aimed.segment.start *= 0x1p-9f;
  aimed.segment.end *= 0x1p-9f;
  return aimed;
}

// Points -------------------------------------------------------------------------------------

inline PointAt at(const Body& body, const Point& point) { return {&body, in_float(point)}; }

inline PointAt point_random(Random& random) {
  const Body& body = any(random, usual());
  return at(body, near_body(random, body, 1));
}
inline PointAt point_convex(Random& random) {
  const Body& body = any(random, convex());
  return at(body, near_body(random, body, 1));
}
/// On the line through a vertex along x, y or z, so that a ray along it meets the vertex.
inline PointAt point_level(Random& random) {
  const Body& body = any(random, random.chance(0.25) ? whole() : usual());
  Point p = any_vertex(random, body.in_double);
  const int axis = random.integer(0, 2);
  p(axis) = near_body(random, body, 1)(axis);
  return at(body, p);
}
/// The same with a point of an edge.
inline PointAt point_under_edge(Random& random) {
  const Body& body = any(random, random.chance(0.25) ? whole() : usual());
  Point p = on_edge(random, body.in_double);
  const int axis = random.integer(0, 2);
  p(axis) = near_body(random, body, 1)(axis);
  return at(body, p);
}
/// A vertex, or a point of an edge or of a face as rounded.
inline PointAt point_on_surface(Random& random) {
  const Body& body = any(random, random.chance(0.25) ? whole() : usual());
  switch (random.integer(0, 2)) {
    case 0:
      return at(body, any_vertex(random, body.in_double));
    case 1:
      return at(body, on_edge(random, body.in_double));
    default:
      return at(body, on_face(random, body.in_double));
  }
}
/// The same with one coordinate moved by one float.
inline PointAt point_near_surface(Random& random) {
  PointAt found = point_on_surface(random);
  const int axis = random.integer(0, 2);
  found.point(axis) = beside(random, found.point(axis));
  return found;
}
inline PointAt point_far(Random& random) {
  const Body& body = any(random, far_away());
  if (random.chance(0.5)) return at(body, near_body(random, body, 1));
  return at(body, on_face(random, body.in_double));
}

}  // namespace mesh_families
