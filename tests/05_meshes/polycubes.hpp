/// @file
/// Solids made of unit cubes, mapped by a matrix of whole numbers: closed meshes with flat parts,
/// cavities, tunnels, and shells that touch at edges and vertices. Where a point is follows from
/// the cubes around it, without any ray or orientation.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <contact/mesh.hpp>
#include <contact/polygon.hpp>
#include <cstdint>
#include <map>
#include <support/generators.hpp>
#include <vector>

namespace polycubes {

using contact::Mesh;
using contact::Where;
using generators::Random;
using Cell = std::array<int, 3>;
using Point = contact::Vector3<double>;
using Matrix = contact::Matrix3<double>;

/// A set of unit cubes [i, i+1] × [j, j+1] × [k, k+1] with 0 ≤ i, j, k < size.
struct Polycube {
  int size = 0;
  std::vector<bool> filled;

  bool at(int i, int j, int k) const {
    if (std::min({i, j, k}) < 0 || std::max({i, j, k}) >= size) return false;
    return filled[static_cast<std::size_t>((i * size + j) * size + k)];
  }
};

/// Each cube with this probability; at least one.
inline Polycube random_polycube(Random& random, int size, double probability) {
  Polycube cubes;
  cubes.size = size;
  for (int i = 0; i < size * size * size; ++i) cubes.filled.push_back(random.chance(probability));
  cubes.filled[static_cast<std::size_t>(random.integer(0, size * size * size - 1))] = true;
  return cubes;
}

/// A matrix of small whole numbers with a determinant that is not 0.
inline Matrix random_map(Random& random) {
  for (;;) {
    Matrix map;
    for (int i = 0; i < 9; ++i) map(i / 3, i % 3) = random.integer(-2, 2);
    if (map.determinant() != 0) return map;
  }
}

/// The surface between filled and empty cubes, in the map's image, oriented outwards; the diagonal
/// of each square is drawn at random, and so is the first vertex of each triangle.
inline Mesh<double> surface(Random& random, const Polycube& cubes, const Matrix& map,
                            const Point& offset) {
  Mesh<double> mesh;
  std::map<Cell, int> vertices;
  const bool mirrored = map.determinant() < 0;
  const auto vertex = [&](const Cell& at) {
    const auto [found, is_new] = vertices.try_emplace(at, static_cast<int>(vertices.size()));
    if (is_new) mesh.vertices.push_back(map * (Point(at[0], at[1], at[2]) + offset));
    return found->second;
  };
  const auto triangle = [&](int a, int b, int c) {
    std::array<int, 3> t{a, b, c};
    std::rotate(t.begin(), t.begin() + random.integer(0, 2), t.end());
    if (mirrored) std::swap(t[1], t[2]);
    mesh.triangles.push_back(t);
  };
  for (int i = 0; i < cubes.size; ++i) {
    for (int j = 0; j < cubes.size; ++j) {
      for (int k = 0; k < cubes.size; ++k) {
        if (!cubes.at(i, j, k)) continue;
        for (int axis = 0; axis < 3; ++axis) {
          for (const int side : {0, 1}) {
            Cell other{i, j, k};
            other[std::size_t(axis)] += side == 1 ? 1 : -1;
            if (cubes.at(other[0], other[1], other[2])) continue;
            // The square's corners, counter-clockwise as seen from outside.
            const auto u = std::size_t((axis + 1) % 3), v = std::size_t((axis + 2) % 3);
            std::array<int, 4> corner{};
            for (std::size_t c = 0; c < 4; ++c) {
              Cell at{i, j, k};
              at[std::size_t(axis)] += side;
              const std::size_t turn = side == 1 ? c : 3 - c;
              if (turn == 1 || turn == 2) ++at[u];
              if (turn == 2 || turn == 3) ++at[v];
              corner[c] = vertex(at);
            }
            const std::size_t s = random.chance(0.5) ? 1 : 0;
            triangle(corner[s], corner[s + 1], corner[s + 2]);
            triangle(corner[s + 2], corner[(s + 3) % 4], corner[s]);
          }
        }
      }
    }
  }
  return mesh;
}

/// Where q is, in the coordinates of the cubes: inside if all cubes that contain it are filled,
/// outside if none is, else on the surface.
inline Where where(const Polycube& cubes, const Point& q) {
  int filled = 0, around = 0;
  std::array<std::array<int, 2>, 3> range{};
  for (int k = 0; k < 3; ++k) {
    const double floor = std::floor(q(k));
    range[std::size_t(k)] = {static_cast<int>(floor) - (floor == q(k) ? 1 : 0),
                             static_cast<int>(floor)};
  }
  for (int i = range[0][0]; i <= range[0][1]; ++i) {
    for (int j = range[1][0]; j <= range[1][1]; ++j) {
      for (int k = range[2][0]; k <= range[2][1]; ++k) {
        ++around;
        filled += cubes.at(i, j, k) ? 1 : 0;
      }
    }
  }
  return filled == 0 ? Where::outside : (filled == around ? Where::inside : Where::on);
}

/// A point at a multiple of 1/4 in and around the cubes; three of eight coordinates are whole.
inline Point random_point(Random& random, int size) {
  Point q;
  for (int k = 0; k < 3; ++k) {
    q(k) = random.chance(0.2) ? random.integer(0, size) : random.integer(-2, 4 * size + 2) / 4.0;
  }
  return q;
}

}  // namespace polycubes
