// The five bodies of the figure `tightness`: coarser than those that the chapter measures, and each
// along the axes of its own frame.
#pragma once

#include <array>
#include <cmath>
#include <contact/mesh.hpp>
#include <contact/sine_cosine.hpp>
#include <contact/vector.hpp>
#include <cstddef>
#include <initializer_list>
#include <utility>
#include <vector>

namespace bodies_in_space {

using Vector = contact::Vector3<double>;
using Mesh = contact::Mesh<double>;

constexpr double turn = 6.283185307179586;

/// Two triangles for each cell of a grid of m × n vertices, numbered row by row, whose rows close
/// up; from the last row the first one follows if `closed`.
inline void add_grid(Mesh& mesh, int m, int n, bool closed) {
  for (int i = 0; i < (closed ? m : m - 1); ++i) {
    for (int j = 0; j < n; ++j) {
      const auto at = [m, n](int k, int l) { return k % m * n + l % n; };
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
}

/// A body of revolution about x: radii at positions along x, closed by a point at each end.
inline Mesh revolved(const std::vector<std::pair<double, double>>& profile, int n) {
  Mesh mesh;
  for (const auto& [x, radius] : profile) {
    for (int j = 0; j < n; ++j) {
      const auto [sine, cosine] = contact::sine_cosine(-turn * j / n);
      mesh.vertices.push_back({x, radius * cosine, radius * sine});
    }
  }
  const int rows = static_cast<int>(profile.size());
  add_grid(mesh, rows, n, false);
  const int first = rows * n, last = (rows - 1) * n;
  mesh.vertices.push_back({profile.front().first, 0, 0});
  mesh.vertices.push_back({profile.back().first, 0, 0});
  for (int j = 0; j < n; ++j) {
    mesh.triangles.push_back({first, j, (j + 1) % n});
    mesh.triangles.push_back({first + 1, last + (j + 1) % n, last + j});
  }
  return mesh;
}

inline Mesh ball() {
  std::vector<std::pair<double, double>> profile;
  for (int i = 1; i < 8; ++i) {
    const auto [sine, cosine] = contact::sine_cosine(turn * i / 16);
    profile.emplace_back(-cosine, sine);
  }
  Mesh mesh = revolved(profile, 16);
  mesh.vertices[mesh.vertices.size() - 2].x() = -1;
  mesh.vertices.back().x() = 1;
  return mesh;
}

inline Mesh rod() { return revolved({{-1.5, 0.125}, {1.5, 0.125}}, 12); }

inline Mesh plate() {
  Mesh mesh = revolved({{-0.0625, 1.25}, {0.0625, 1.25}}, 4);
  // A square, with its edges along the axes, thin along z.
  for (Vector& v : mesh.vertices) v = Vector(v.y() - v.z(), v.y() + v.z(), v.x());
  return mesh;
}

/// Six points along the axes, and eight between them that are further in.
inline Mesh star() {
  Mesh mesh;
  for (const double sign : {-1.0, 1.0}) {
    for (int k = 0; k < 3; ++k) mesh.vertices.push_back(1.375 * sign * Vector::Unit(k));
  }
  for (int k = 0; k < 8; ++k)
    mesh.vertices.push_back(0.25 * Vector(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1));
  // Around each point four of the eight, in the order in which they are seen from outside.
  for (int k = 0; k < 6; ++k) {
    const int axis = k % 3, side = k / 3;
    const int u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3, on = 6 + (side << axis);
    const std::array<int, 4> around{on, on + u, on + u + v, on + v};
    for (std::size_t i = 0; i < 4; ++i) {
      const int p = around[i], q = around[(i + 1) % 4];
      mesh.triangles.push_back(side == 1 ? std::array{k, p, q} : std::array{k, q, p});
    }
  }
  return mesh;
}

/// A tube along a trefoil knot.
inline Mesh knot() {
  constexpr int m = 42, n = 4;
  constexpr double radius = 0.2;
  const auto at = [](int i) -> Vector {
    const auto [s2, c2] = contact::sine_cosine(2 * turn * i / m);
    const auto [s3, c3] = contact::sine_cosine(3 * turn * i / m);
    const double from_axis = 0.8 + 0.4 * c3;
    return {from_axis * c2, from_axis * s2, 0.55 * s3};
  };
  const auto unit = [](const Vector& v) -> Vector { return v / std::sqrt(v.squaredNorm()); };
  Mesh mesh;
  for (int i = 0; i < m; ++i) {
    const Vector along = at(i + 1) - at(i - 1);
    const Vector x = unit(along.cross(Vector::UnitZ())), y = unit(x.cross(along));
    for (int j = 0; j < n; ++j) {
      const auto [sine, cosine] = contact::sine_cosine(turn * j / n);
      mesh.vertices.push_back(at(i) + radius * (cosine * x + sine * y));
    }
  }
  add_grid(mesh, m, n, true);
  return mesh;
}

inline double volume_of(const std::vector<Vector>& vertices,
                        const std::vector<std::array<int, 3>>& triangles) {
  double six_volumes = 0;
  for (const auto& [i, j, k] : triangles) {
    const auto at = [&vertices](int index) { return vertices[static_cast<std::size_t>(index)]; };
    six_volumes += at(i).dot(at(j).cross(at(k)));
  }
  return six_volumes / 6;
}

}  // namespace bodies_in_space
