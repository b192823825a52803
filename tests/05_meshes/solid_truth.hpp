/// @file
/// What tests of solids compare with: the winding number by fractions, and meshes to cut.
#pragma once

#include <array>
#include <contact/mesh.hpp>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <support/generators.hpp>
#include <support/oracle.hpp>
#include <utility>
#include <vector>

namespace solid_truth {

using contact::Mesh;
using contact::Vector3;
using oracle::Rational;
using oracle::Vector;

/// How often the surface encloses a point: the signed crossings of a ray. Nothing if the point is
/// on the surface.
///
/// A ray that meets an edge, or that runs in a triangle's plane, is replaced by another; this ends
/// because the directions are drawn.
inline std::optional<int> winding(const Vector& p, const Mesh<double>& mesh,
                                  generators::Random& random) {
  for (;;) {
    const int x = random.integer(-1000, 1000), y = random.integer(-1000, 1000);
    const Vector d(Rational(x), Rational(y), Rational(random.integer(1, 1000)));
    int count = 0;
    bool clear = true;
    for (std::size_t i = 0; i < mesh.triangles.size() && clear; ++i) {
      const auto t = oracle::exact(contact::triangle_of(mesh, i));
      const Vector a = t.a - p, b = t.b - p, c = t.c - p;
      const Vector n = (t.b - t.a).cross(Vector(t.c - t.a));
      const std::array<int, 3> side{oracle::sign(d.dot(Vector(b.cross(c)))),
                                    oracle::sign(d.dot(Vector(c.cross(a)))),
                                    oracle::sign(d.dot(Vector(a.cross(b))))};
      const bool some_minus = side[0] < 0 || side[1] < 0 || side[2] < 0;
      const bool some_plus = side[0] > 0 || side[1] > 0 || side[2] > 0;
      if (some_minus && some_plus) continue;
      const int height = oracle::sign(a.dot(n));
      if (height == 0 && oracle::sign(n.dot(n)) > 0 && side[0] * side[1] * side[2] == 0) {
        // In the plane: on the triangle if no edge has p outside.
        const auto edge = [&](const Vector& u, const Vector& v) {
          return oracle::sign(n.dot(Vector(u.cross(v))));
        };
        if (edge(a, b) >= 0 && edge(b, c) >= 0 && edge(c, a) >= 0) return std::nullopt;
      }
      if (side[0] == 0 || side[1] == 0 || side[2] == 0) {
        clear = false;
      } else if (height == 0) {
        return std::nullopt;
      } else if ((height > 0) == (side[0] > 0)) {
        count += side[0];
      }
    }
    if (clear) return count;
  }
}

/// The surface of a set of unit cubes, each given by its low corner: closed and oriented, with two
/// triangles for each square. Where cubes touch at an edge or a vertex only it is not manifold.
inline Mesh<double> of_cubes(const std::set<std::array<int, 3>>& cubes) {
  Mesh<double> mesh;
  std::map<std::array<int, 3>, int> numbers;
  const auto number = [&](const std::array<int, 3>& corner) {
    const auto [entry, added] = numbers.insert({corner, int(mesh.vertices.size())});
    if (added) mesh.vertices.push_back(Vector3<double>(corner[0], corner[1], corner[2]));
    return entry->second;
  };
  for (const auto& cube : cubes) {
    for (std::size_t k = 0; k < 3; ++k) {
      for (const int end : {0, 1}) {
        std::array<int, 3> beside = cube;
        beside[k] += end == 0 ? -1 : 1;
        if (cubes.count(beside) > 0) continue;
        std::array<int, 4> corners{};
        for (std::size_t i = 0; i < 4; ++i) {  // counter-clockwise from the positive side
          std::array<int, 3> corner = cube;
          corner[k] += end;
          corner[(k + 1) % 3] += i == 1 || i == 2 ? 1 : 0;
          corner[(k + 2) % 3] += i >= 2 ? 1 : 0;
          corners[end == 1 ? i : 3 - i] = number(corner);
        }
        mesh.triangles.push_back({corners[0], corners[1], corners[2]});
        mesh.triangles.push_back({corners[0], corners[2], corners[3]});
      }
    }
  }
  return mesh;
}

/// All unit cubes of a box of cubes.
inline std::set<std::array<int, 3>> block(std::array<int, 3> low, std::array<int, 3> high) {
  std::set<std::array<int, 3>> cubes;
  for (int x = low[0]; x < high[0]; ++x) {
    for (int y = low[1]; y < high[1]; ++y) {
      for (int z = low[2]; z < high[2]; ++z) cubes.insert({x, y, z});
    }
  }
  return cubes;
}

}  // namespace solid_truth
