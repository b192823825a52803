/// @file
/// Meshes of every kind and lines aimed at their vertices, their edges and along their faces, for
/// the tests of hits. Small meshes: the exact answers take long.
#pragma once

#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/mesh_hits.hpp>
#include <contact/mesh_shapes.hpp>
#include <support/generators.hpp>

namespace lines_at_meshes {

using contact::Mesh;
using contact::MeshHit;
using contact::Ray;
using contact::Segment;
using contact::Triangle;
using contact::Vector3;
using generators::Random;
using Point = Vector3<double>;

inline Point in_cube(Random& random) {
  const double x = random.uniform(-1, 1);
  const double y = random.uniform(-1, 1);
  const double z = random.uniform(-1, 1);
  return {x, y, z};
}
inline Point whole(Random& random, int size) {
  const int x = random.integer(-size, size);
  const int y = random.integer(-size, size);
  const int z = random.integer(-size, size);
  return {double(x), double(y), double(z)};
}

inline Mesh<double> scaled(Mesh<double> mesh, double factor) {
  for (Point& v : mesh.vertices) v *= factor;
  return mesh;
}

/// Any three of a few points: triangles that cross, coincide, lie in one plane or have no area.
template <class Draw>
Mesh<double> soup(Random& random, int vertices, int triangles, const Draw& draw) {
  Mesh<double> mesh;
  for (int i = 0; i < vertices; ++i) mesh.vertices.push_back(draw(i));
  for (int i = 0; i < triangles; ++i) {
    const int a = random.integer(0, vertices - 1);
    const int b = random.integer(0, vertices - 1);
    const int c = random.integer(0, vertices - 1);
    mesh.triangles.push_back({a, b, c});
  }
  return mesh;
}

/// A square of 2 n² triangles in the plane x_axis = 1.
inline Mesh<double> flat_square(int n, int axis) {
  Mesh<double> mesh;
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= n; ++j) {
      Point v = Point::Ones();
      v[(axis + 1) % 3] = i;
      v[(axis + 2) % 3] = j;
      mesh.vertices.push_back(v);
    }
  }
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const int at = i * (n + 1) + j;
      mesh.triangles.push_back({at, at + n + 1, at + n + 2});
      mesh.triangles.push_back({at, at + n + 2, at + 1});
    }
  }
  return mesh;
}

inline constexpr int mesh_kinds = 14;

inline Mesh<double> mesh_of_kind(Random& random, int kind) {
  switch (kind) {
    case 0:
      return contact::ball_mesh(1.0, random.integer(0, 2));
    case 1:
      return contact::torus_mesh(1.0, 0.4, random.integer(3, 12), random.integer(3, 8));
    case 2:
      return contact::star_mesh(0.5, 1.5, random.integer(0, 1));
    case 3:
      return soup(random, 12, 40, [&random](int) { return whole(random, 3); });
    case 4: {  // boxes that share a face
      const Mesh<double> box = contact::box_mesh({0, 0, 0}, {1, 1, 1});
      return contact::joined(box, contact::box_mesh({1, 0, 0}, {2, 1, 1}));
    }
    case 5:
      return scaled(mesh_of_kind(random, random.integer(0, 4)),
                    std::ldexp(1.0, random.integer(20, 510)));
    case 6:
      return scaled(mesh_of_kind(random, random.integer(0, 4)),
                    std::ldexp(1.0, -random.integer(20, 510)));
    case 7: {  // huge and tiny at once
      const int spread = random.integer(0, 1) == 0 ? 30 : 300;
      return soup(random, 30, 60, [&](int) {
        const double size = std::ldexp(1.0, random.integer(-spread, spread));
        return Point(size * in_cube(random));
      });
    }
    case 8:
      return flat_square(random.integer(1, 6), random.integer(0, 2));
    case 9: {
      Mesh<double> mesh = mesh_of_kind(random, random.integer(0, 4));
      const Point away = std::ldexp(1.0, random.integer(4, 40)) * in_cube(random);
      for (Point& v : mesh.vertices) v += away;
      return mesh;
    }
    case 10: {  // small triangles far apart
      Mesh<double> mesh;
      for (int i = 0; i < 60; ++i) {
        const Point at = in_cube(random);
        for (int k = 0; k < 3; ++k) mesh.vertices.push_back(at + 0x1p-18 * in_cube(random));
        mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
      }
      return mesh;
    }
    case 11:  // slivers: nearly on one line
      return soup(random, 20, 40, [&random](int) {
        const double t = random.uniform(-1, 1);
        return Point(Point(1, 2, 3) * t + 0x1p-48 * in_cube(random));
      });
    case 12: {  // not finite here and there
      Mesh<double> mesh = contact::ball_mesh(1.0, 1);
      constexpr double infinity = std::numeric_limits<double>::infinity();
      mesh.vertices[3].x() = std::numeric_limits<double>::quiet_NaN();
      mesh.vertices[8].y() = random.chance(0.5) ? infinity : -infinity;
      return mesh;
    }
    default:
      return soup(random, 15, 20, [&random](int) { return generators::any_vector(random); });
  }
}

/// A point of a triangle: a vertex, on an edge, inside, or in its plane.
inline Point point_at(Random& random, const Triangle<double>& t) {
  const std::array<Point, 3> corners{t.a, t.b, t.c};
  const auto k = static_cast<std::size_t>(random.integer(0, 2));
  const Point a = corners[k], b = corners[(k + 1) % 3], c = corners[(k + 2) % 3];
  switch (random.integer(0, 5)) {
    case 0:
    case 1:
      return a;
    case 2:
      return (a + b) / 2;
    case 3:
      return a + random.uniform() * (b - a);
    case 4: {
      const double u = random.uniform(-0.5, 1);
      const double v = random.uniform(-0.5, 1);
      return a + u * (b - a) + v * (c - a);
    }
    default:
      return (a + b + c) / 3;
  }
}

/// From where to where, and whether the second is a direction.
struct Aimed {
  Point start, end;
  bool is_ray = true;
};

inline Aimed line_at(Random& random, const Mesh<double>& mesh) {
  const auto any = [&] {
    const int last = static_cast<int>(mesh.triangles.size()) - 1;
    return contact::triangle_of(mesh, static_cast<std::size_t>(random.integer(0, last)));
  };
  const Triangle<double> t = any();
  const Point target = point_at(random, t);
  const double size = (t.b - t.a).cwiseAbs().maxCoeff() + (t.c - t.a).cwiseAbs().maxCoeff();
  Point start = target;
  const int from = random.integer(0, 7);
  const int axis = random.integer(0, 2);
  if (from == 0) start = point_at(random, any());
  if (from == 1) start = point_at(random, t);  // in the plane, or nearly
  if (from == 2) start[axis] += size * random.integer(-4, 4);
  if (from == 3) start[axis] += size * random.uniform(-4, 4);
  if (from == 4) start += size * in_cube(random) * 4;
  if (from == 5) start += size * whole(random, 3);
  if (from == 6) start += std::ldexp(size, random.integer(0, 60)) * in_cube(random);
  if (from == 7) {
    start[axis] += std::ldexp(size, random.integer(-60, 60));
    start[(axis + 1) % 3] += std::ldexp(size, random.integer(-100, 20));
  }
  Aimed line{start, target - start, true};
  const int how = random.integer(0, 9);
  if (how == 0) line.end *= std::ldexp(1.0, random.integer(-1000, 1000));
  if (how == 1) line.end = -line.end;
  if (how == 2) line.end[axis] = random.chance(0.5) ? 0.0 : -0.0;
  if (how == 3) line.end[axis] *= std::ldexp(1.0, -random.integer(50, 400));
  if (how == 4) line.end = Point::Unit(axis) * (random.chance(0.5) ? 1 : -1);
  if (how == 5) line = {start, target, false};
  if (how == 6) line = {start, target + (target - start), false};
  if (how == 7) line = {target, start, false};
  if (how == 8) line = {start, start + (target - start) * random.uniform(0.9, 1.1), false};
  return line;
}

/// Asks with the ray or the segment, rounded to S.
template <class S, class Ask>
void with_line(const Aimed& line, const Ask& ask) {
  const Vector3<S> start = generators::rounded<S>(line.start);
  const Vector3<S> end = generators::rounded<S>(line.end);
  if (line.is_ray) {
    ask(Ray<S>{start, end});
  } else {
    ask(Segment<S>{start, end});
  }
}

template <class S>
Mesh<S> mesh_in(const Mesh<double>& mesh) {
  Mesh<S> made;
  for (const Point& v : mesh.vertices) made.vertices.push_back(generators::rounded<S>(v));
  made.triangles = mesh.triangles;
  return made;
}

/// Equal to the last bit, and not NaN.
template <class S>
bool same(const MeshHit<S>& x, const MeshHit<S>& y) {
  return x.triangle == y.triangle && x.hit.t == y.hit.t && x.hit.barycentric == y.hit.barycentric &&
         x.point == y.point && x.feature == y.feature && x.feature_vertices == y.feature_vertices;
}

}  // namespace lines_at_meshes
