/// @file
/// Meshes to try things on: boxes, balls, tori, prisms, stars. All are closed and oriented, with
/// the front of every triangle outside.
///
/// The functions that change a given mesh take every mesh: of an empty one they make an empty one,
/// and where they only copy, coordinates that are not finite and indices that are out of range
/// stay.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <contact/frame.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/mesh.hpp>
#include <contact/polygon.hpp>
#include <contact/sine_cosine.hpp>
#include <contact/triangulate.hpp>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace contact {

namespace mesh_shapes_detail {

/// Throws std::invalid_argument unless x is finite and greater than 0.
inline void require_positive(const char* argument, double x) {
  require_finite(argument, x);
  if (!(x > 0)) throw_invalid_argument(argument, number_text(x), "must be greater than 0");
}

/// Throws std::invalid_argument unless a whole number is in its range.
inline void require_in_range(const char* argument, int x, int low, int high) {
  if (x < low || x > high) {
    throw_invalid_argument(argument, std::to_string(x),
                           "must be from " + std::to_string(low) + " to " + std::to_string(high));
  }
}

/// A vector of length 1 in the direction of v.
inline Vector3<double> on_unit_sphere(const Vector3<double>& v) { return v / std::sqrt(v.dot(v)); }

/// The ball of radius 1.
inline Mesh<double> unit_ball(int subdivisions) {
  // Twelve vertices at (0, ±1, ±g) and its cyclic permutations, g the golden ratio.
  const double g = (1 + std::sqrt(5.0)) / 2;
  Mesh<double> mesh;
  for (const double s : {1.0, -1.0}) {
    for (const double t : {g, -g}) {
      mesh.vertices.push_back(on_unit_sphere({0, s, t}));
      mesh.vertices.push_back(on_unit_sphere({t, 0, s}));
      mesh.vertices.push_back(on_unit_sphere({s, t, 0}));
    }
  }
  // Three vertices are a face if each two are neighbours: at a distance of about 1.05, where the
  // next larger one is 1.7.
  const auto near = [&mesh](int i, int j) {
    const Vector3<double> between =
        mesh.vertices[static_cast<std::size_t>(i)] - mesh.vertices[static_cast<std::size_t>(j)];
    return between.dot(between) < 2;
  };
  for (int i = 0; i < 12; ++i) {
    for (int j = i + 1; j < 12; ++j) {
      for (int k = j + 1; k < 12; ++k) {
        if (!near(i, j) || !near(j, k) || !near(k, i)) continue;
        mesh.triangles.push_back({i, j, k});
        const Triangle<double> t = triangle_of(mesh, mesh.triangles.size() - 1);
        if (t.a.dot(t.b.cross(t.c)) < 0) mesh.triangles.back() = {i, k, j};
      }
    }
  }
  for (int step = 0; step < subdivisions; ++step) {
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&mesh, &middles](int i, int j) {
      const auto [found, is_new] = middles.try_emplace({std::min(i, j), std::max(i, j)},
                                                       static_cast<int>(mesh.vertices.size()));
      if (is_new) {
        mesh.vertices.push_back(on_unit_sphere(mesh.vertices[static_cast<std::size_t>(i)] +
                                               mesh.vertices[static_cast<std::size_t>(j)]));
      }
      return found->second;
    };
    std::vector<std::array<int, 3>> finer;
    finer.reserve(4 * mesh.triangles.size());
    for (const auto& [a, b, c] : mesh.triangles) {
      const int ab = middle(a, b);
      const int bc = middle(b, c);
      const int ca = middle(c, a);
      finer.push_back({a, ab, ca});
      finer.push_back({ab, b, bc});
      finer.push_back({ca, bc, c});
      finer.push_back({ab, bc, ca});
    }
    mesh.triangles = std::move(finer);
  }
  return mesh;
}

}  // namespace mesh_shapes_detail

// [box-mesh]
/// The box from low to high: 8 vertices and 12 triangles, two for each face. Vertex i has the high
/// x if bit 0 of i is set, the high y if bit 1 is, and the high z if bit 2 is.
/// @param low,high m
/// @throws std::invalid_argument unless both are finite and low < high in each coordinate
inline Mesh<double> box_mesh(const Vector3<double>& low, const Vector3<double>& high) {
  require_finite("low", low);
  require_finite("high", high);
  for (int k = 0; k < 3; ++k) {
    if (!(low[k] < high[k])) {
      throw_invalid_argument("high", vector_text(high),
                             "must be greater than low in every coordinate");
    }
  }
  Mesh<double> mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.vertices.push_back({(i & 1) != 0 ? high.x() : low.x(), (i & 2) != 0 ? high.y() : low.y(),
                             (i & 4) != 0 ? high.z() : low.z()});
  }
  constexpr std::array<std::array<int, 4>, 6> faces{
      {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
  for (const auto& [a, b, c, d] : faces) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  }
  return mesh;
}
// [/box-mesh]

/// The octahedron with its vertices on the axes: 6 vertices (x, −x, y, −y, z, −z) and 8 triangles.
/// @param radius m, from the origin to a vertex
/// @throws std::invalid_argument unless the radius is finite and greater than 0
inline Mesh<double> octahedron_mesh(double radius) {
  mesh_shapes_detail::require_positive("radius", radius);
  Mesh<double> mesh;
  for (int k = 0; k < 3; ++k) {
    for (const double sign : {1.0, -1.0}) {
      Vector3<double> v(0, 0, 0);
      v[k] = sign * radius;
      mesh.vertices.push_back(v);
    }
  }
  mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                    {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  return mesh;
}

/// A ball: an icosahedron whose triangles are divided into four, with new vertices moved out to the
/// sphere. 20·4^subdivisions triangles, half as many vertices and 2 more. Of additions, products,
/// quotients and square roots, so the same on every machine.
///
/// Limits: vertices are rounded. For a radius below 1e-290 the coordinates are so coarse that
/// triangles may have no area.
/// @param radius m
/// @param subdivisions from 0 to 9
/// @throws std::invalid_argument unless the radius is finite and greater than 0 and subdivisions is
/// in its range
inline Mesh<double> ball_mesh(double radius, int subdivisions) {
  mesh_shapes_detail::require_positive("radius", radius);
  mesh_shapes_detail::require_in_range("subdivisions", subdivisions, 0, 9);
  Mesh<double> mesh = mesh_shapes_detail::unit_ball(subdivisions);
  for (Vector3<double>& v : mesh.vertices) v *= radius;
  return mesh;
}

/// A star: `ball_mesh` with a spike on every triangle, a vertex above its centre at the distance
/// `outer` from the origin. 60·4^subdivisions triangles. The origin sees all of it, so it never
/// crosses itself. With outer ≥ inner it is concave along every edge of the ball; if outer is less
/// than the distance of the triangles from the origin, the spikes are dents.
/// @param inner,outer m, from the origin
/// @param subdivisions from 0 to 8
/// @throws std::invalid_argument unless inner and outer are finite and greater than 0 and
/// subdivisions is in its range
inline Mesh<double> star_mesh(double inner, double outer, int subdivisions) {
  mesh_shapes_detail::require_positive("inner", inner);
  mesh_shapes_detail::require_positive("outer", outer);
  mesh_shapes_detail::require_in_range("subdivisions", subdivisions, 0, 8);
  Mesh<double> mesh = mesh_shapes_detail::unit_ball(subdivisions);
  const std::size_t count = mesh.vertices.size();
  std::vector<std::array<int, 3>> spikes;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle<double> t = triangle_of(mesh, i);
    const int tip = static_cast<int>(mesh.vertices.size());
    mesh.vertices.push_back(mesh_shapes_detail::on_unit_sphere(t.a + t.b + t.c));
    const auto& [a, b, c] = mesh.triangles[i];
    spikes.push_back({a, b, tip});
    spikes.push_back({b, c, tip});
    spikes.push_back({c, a, tip});
  }
  mesh.triangles = std::move(spikes);
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    mesh.vertices[i] *= i < count ? inner : outer;
  }
  return mesh;
}

// [torus-mesh]
/// A torus around the z axis: m·n vertices and 2·m·n triangles. Vertex i·n + j is at the i-th angle
/// around the axis and the j-th around the tube.
///
/// Limits: vertices are rounded, so the four of a quadrilateral are in one plane only nearly.
/// @param ring m, from the axis to the middle of the tube
/// @param tube m, the tube's radius, less than ring
/// @param m,n vertices around the axis and around the tube, from 3 to 10,000
/// @throws std::invalid_argument unless 0 < tube < ring, both finite and their sum too, and m and n
/// are in their range
inline Mesh<double> torus_mesh(double ring, double tube, int m, int n) {
  mesh_shapes_detail::require_positive("tube", tube);
  require_finite("ring", ring);
  if (!(ring > tube)) {
    throw_invalid_argument("ring", number_text(ring), "must be greater than tube");
  }
  require_finite("ring + tube", ring + tube);
  mesh_shapes_detail::require_in_range("m", m, 3, 10000);
  mesh_shapes_detail::require_in_range("n", n, 3, 10000);
  constexpr double turn = 6.283185307179586;
  Mesh<double> mesh;
  for (int i = 0; i < m; ++i) {
    const auto around = sine_cosine(turn * i / m);
    for (int j = 0; j < n; ++j) {
      const auto across = sine_cosine(turn * j / n);
      const double from_axis = ring + tube * across.cosine;
      mesh.vertices.push_back(
          {from_axis * around.cosine, from_axis * around.sine, tube * across.sine});
      const int i1 = (i + 1) % m, j1 = (j + 1) % n;
      mesh.triangles.push_back({i * n + j, i1 * n + j, i1 * n + j1});
      mesh.triangles.push_back({i * n + j, i1 * n + j1, i * n + j1});
    }
  }
  return mesh;
}
// [/torus-mesh]

// [prism-mesh]
/// The prism over a polygon of the plane, from z = low to z = high. 2n vertices (the polygon's at
/// low, in counter-clockwise order, then the same at high) and 4n − 4 triangles: two for each side,
/// and the triangulation of the polygon twice.
/// @param polygon m, simple; either orientation; concave and with vertices on straight edges if
/// need be
/// @param low,high m
/// @throws std::invalid_argument unless low < high, both finite, and for a polygon that
/// `triangulate` refuses
inline Mesh<double> prism_mesh(const Polygon<double>& polygon, double low, double high) {
  require_finite("low", low);
  require_finite("high", high);
  if (!(low < high)) throw_invalid_argument("high", number_text(high), "must be greater than low");
  const Polygon<double> ring = area_sign(polygon) < 0 ? reversed(polygon) : polygon;
  const std::vector<std::array<int, 3>> cap = triangulate(ring);
  Mesh<double> mesh;
  for (const double z : {low, high}) {
    for (const Vector2<double>& v : ring) mesh.vertices.push_back({v.x(), v.y(), z});
  }
  const int n = static_cast<int>(ring.size());
  for (int i = 0; i < n; ++i) {
    const int next = (i + 1) % n;
    mesh.triangles.push_back({i, next, next + n});
    mesh.triangles.push_back({i, next + n, i + n});
  }
  for (const auto& [a, b, c] : cap) {
    mesh.triangles.push_back({a, c, b});
    mesh.triangles.push_back({a + n, b + n, c + n});
  }
  return mesh;
}
// [/prism-mesh]

/// World coordinates of a mesh given in the frame. A vertex or frame with a number that is not
/// finite gives coordinates that are NaN or infinite, and so does an overflow.
template <Ring S>
Mesh<S> transformed(Mesh<S> mesh, const CoordinateFrame<S>& frame) {
  for (Vector3<S>& v : mesh.vertices) v = Vector3<S>(position_in_world(frame, v));
  return mesh;
}

/// The mesh moved by a vector, in m; each coordinate is rounded once, and infinite if it overflows.
/// NaN in the vector makes this coordinate of all vertices NaN.
template <Ring S>
Mesh<S> translated(Mesh<S> mesh, const Vector3<S>& by) {
  for (Vector3<S>& v : mesh.vertices) v += by;
  return mesh;
}

/// The same triangles as a soup: each with three vertices of its own. Vertices that no triangle
/// uses are left out; an index out of range is an error of the program.
template <Ring S>
Mesh<S> triangle_soup(const Mesh<S>& mesh) {
  Mesh<S> soup;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle<S> t = triangle_of(mesh, i);
    const int n = static_cast<int>(soup.vertices.size());
    soup.vertices.insert(soup.vertices.end(), {t.a, t.b, t.c});
    soup.triangles.push_back({n, n + 1, n + 2});
  }
  return soup;
}

/// Both meshes as one: the vertices and triangles of the second after those of the first. Nothing
/// is cut or merged. An index of the second that is out of range may then name another vertex.
template <Ring S>
Mesh<S> joined(Mesh<S> first, const Mesh<S>& second) {
  const int offset = static_cast<int>(first.vertices.size());
  first.vertices.insert(first.vertices.end(), second.vertices.begin(), second.vertices.end());
  for (const auto& [a, b, c] : second.triangles) {
    first.triangles.push_back({a + offset, b + offset, c + offset});
  }
  return first;
}

/// The mesh with every triangle reversed: what was outside is inside. `joined` with a larger mesh
/// around it, it bounds a cavity.
template <Ring S>
Mesh<S> inside_out(Mesh<S> mesh) {
  for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  return mesh;
}

/// The mesh with its coordinates rounded to another type. Those beyond its largest number become
/// infinite, and those too close to 0 become 0, so that triangles may lose their area.
template <std::floating_point To, std::floating_point From>
Mesh<To> rounded_mesh(const Mesh<From>& mesh) {
  Mesh<To> result;
  result.triangles = mesh.triangles;
  result.vertices.reserve(mesh.vertices.size());
  for (const Vector3<From>& v : mesh.vertices) {
    result.vertices.push_back(v.template cast<To>());
  }
  return result;
}

}  // namespace contact
