/// @file
/// What is wrong with a mesh, by brute force in fractions and with none of the chapter's code.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <contact/mesh.hpp>
#include <map>
#include <set>
#include <string>
#include <support/oracle.hpp>
#include <utility>
#include <vector>

namespace mesh_check_truth {

using contact::Mesh;
using oracle::Rational;

/// A fault: its kind's name, triangles and vertices.
struct Fault {
  std::string kind;
  std::vector<int> triangles, vertices;
  friend auto operator<=>(const Fault&, const Fault&) = default;
};

/// What there is to say of a mesh.
struct Truth {
  bool closed = true, oriented = true, manifold = true, solid = true;
  int euler_characteristic = 0;
  std::vector<std::vector<int>> components;
  std::vector<int> volume_signs;  // of each component, 0 unless closed and oriented
  std::multiset<Fault> faults;
};

/// The sign of a sum of determinants.
inline Rational six_volumes(const Mesh<double>& mesh, const std::vector<int>& triangles) {
  Rational sum(0);
  for (const int i : triangles) {
    const contact::Triangle<Rational> t =
        oracle::exact(triangle_of(mesh, static_cast<std::size_t>(i)));
    sum += t.a.dot(t.b.cross(t.c));
  }
  return sum;
}

inline Truth truth(const Mesh<double>& mesh) {
  Truth right;
  const int count = static_cast<int>(mesh.triangles.size());
  const int vertices = static_cast<int>(mesh.vertices.size());
  const auto triangle = [&](int i) { return mesh.triangles[static_cast<std::size_t>(i)]; };
  const auto vertex = [&](int v) { return mesh.vertices[static_cast<std::size_t>(v)]; };
  const auto finite = [&](int v) {
    const auto p = vertex(v);
    return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z());
  };
  const auto add = [&](const char* kind, std::vector<int> t, std::vector<int> v) {
    right.faults.insert({kind, std::move(t), std::move(v)});
  };

  std::vector<int> usable;
  std::map<std::set<int>, std::vector<int>> by_vertices;
  std::map<std::set<int>, std::vector<int>> by_edge;
  std::map<std::set<int>, int> balance;
  for (int i = 0; i < count; ++i) {
    const auto t = triangle(i);
    const std::set<int> all(t.begin(), t.end());
    if (*all.begin() < 0 || *all.rbegin() >= vertices) {
      add("index_out_of_range", {i}, {});
      right.solid = false;
      continue;
    }
    if (all.size() < 3) {
      add("repeated_index", {i}, {});
      continue;
    }
    usable.push_back(i);
    by_vertices[all].push_back(i);
    if (finite(t[0]) && finite(t[1]) && finite(t[2])) {
      const auto e = oracle::exact(triangle_of(mesh, static_cast<std::size_t>(i)));
      const oracle::Vector n = oracle::Vector(e.b - e.a).cross(oracle::Vector(e.c - e.a));
      if (n.x() == 0 && n.y() == 0 && n.z() == 0) add("no_area", {i}, {});
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const int from = t[k], to = t[(k + 1) % 3];
      by_edge[{from, to}].push_back(i);
      balance[{from, to}] += from < to ? 1 : -1;
    }
  }
  for (const auto& [set, list] : by_vertices) {
    if (list.size() > 1) {
      add("same_triangle", list, {set.begin(), set.end()});
      right.manifold = false;
    }
  }
  const auto tilted = [&](const std::set<int>& edge) {
    return std::abs(balance[edge]) > int(by_edge[edge].size() % 2);
  };
  for (const auto& [edge, list] : by_edge) {
    const std::vector<int> ends(edge.begin(), edge.end());
    if (list.size() == 1) add("boundary_edge", list, ends);
    if (list.size() > 2) add("crowded_edge", list, ends);
    if (list.size() > 2) right.manifold = false;
    if (list.size() % 2 != 0) right.closed = false;
    if (tilted(edge)) add("same_direction", list, ends);
    if (tilted(edge)) right.oriented = false;
  }

  // Sets of triangles that are joined by edges; with a vertex, by edges at that vertex.
  const auto joined = [&](std::vector<int> rest, int at) {
    std::vector<std::vector<int>> groups;
    while (!rest.empty()) {
      std::vector<int> group{rest.front()};
      rest.erase(rest.begin());
      for (std::size_t g = 0; g < group.size(); ++g) {
        for (std::size_t r = 0; r < rest.size();) {
          const auto s = triangle(group[g]), t = triangle(rest[r]);
          int common = 0;
          bool has = at < 0;
          for (const int v : s) {
            if (std::find(t.begin(), t.end(), v) == t.end()) continue;
            ++common;
            if (v == at) has = true;
          }
          if (common >= 2 && has) {
            group.push_back(rest[r]);
            rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(r));
          } else {
            ++r;
          }
        }
      }
      std::sort(group.begin(), group.end());
      groups.push_back(group);
    }
    return groups;
  };
  int used = 0;
  for (int v = 0; v < vertices; ++v) {
    std::vector<int> around;
    for (const int i : usable) {
      const auto t = triangle(i);
      if (std::find(t.begin(), t.end(), v) != t.end()) around.push_back(i);
    }
    if (!finite(v)) {
      add("vertex_not_finite", {}, {v});
      right.solid = false;
    }
    if (around.empty()) {
      add("unused_vertex", {}, {v});
      continue;
    }
    ++used;
    const auto fans = joined(around, v);
    if (fans.size() > 1) {
      std::vector<int> first;
      for (const auto& fan : fans) first.push_back(fan.front());
      add("several_fans", first, {v});
      right.manifold = false;
    }
  }
  std::vector<bool> told(static_cast<std::size_t>(vertices), false);
  for (int v = 0; v < vertices; ++v) {
    std::vector<int> equal{v};
    for (int w = v + 1; w < vertices; ++w) {
      if (vertex(v) == vertex(w)) equal.push_back(w);
    }
    if (equal.size() > 1 && finite(v) && !told[static_cast<std::size_t>(v)]) {
      add("equal_vertices", {}, equal);
      for (const int w : equal) told[static_cast<std::size_t>(w)] = true;
    }
  }
  right.euler_characteristic =
      used - static_cast<int>(by_edge.size()) + static_cast<int>(usable.size());

  right.components = joined(usable, -1);
  std::vector<bool> whole;  // closed, oriented and finite
  std::vector<std::array<double, 6>> boxes;
  for (const auto& component : right.components) {
    bool good = true;
    std::array<double, 6> box{1e300, 1e300, 1e300, -1e300, -1e300, -1e300};
    for (const int i : component) {
      const auto t = triangle(i);
      for (std::size_t k = 0; k < 3; ++k) {
        const std::set<int> edge{t[k], t[(k + 1) % 3]};
        good = good && by_edge[edge].size() % 2 == 0 && !tilted(edge) && finite(t[k]);
        for (std::size_t x = 0; x < 3; ++x) {
          box[x] = std::min(box[x], vertex(t[k])[static_cast<int>(x)]);
          box[3 + x] = std::max(box[3 + x], vertex(t[k])[static_cast<int>(x)]);
        }
      }
    }
    whole.push_back(good);
    boxes.push_back(box);
    right.volume_signs.push_back(good ? oracle::sign(six_volumes(mesh, component)) : 0);
  }
  for (std::size_t c = 0; c < right.components.size(); ++c) {
    if (!whole[c]) continue;
    if (right.volume_signs[c] == 0) {
      add("component_no_volume", right.components[c], {});
      right.solid = false;
    }
    if (right.volume_signs[c] >= 0) continue;
    bool cavity = false;
    for (std::size_t d = 0; d < right.components.size(); ++d) {
      if (right.volume_signs[d] <= 0) continue;
      bool in = true;
      for (std::size_t x = 0; x < 3; ++x) {
        in = in && boxes[d][x] <= boxes[c][x] && boxes[c][3 + x] <= boxes[d][3 + x];
      }
      cavity = cavity || in;
    }
    if (!cavity) {
      add("component_inside_out", right.components[c], {});
      right.solid = false;
    }
  }
  right.solid =
      right.solid && right.closed && right.oriented && right.manifold && !right.components.empty();
  return right;
}

/// The mesh with one vertex for each position.
inline Mesh<double> by_position(const Mesh<double>& mesh) {
  Mesh<double> result;
  std::map<std::array<double, 3>, int> names;
  for (const auto& t : mesh.triangles) {
    std::array<int, 3> triangle{};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& p = mesh.vertices[static_cast<std::size_t>(t[k])];
      const auto [found, is_new] = names.try_emplace({p.x() + 0.0, p.y() + 0.0, p.z() + 0.0},
                                                     static_cast<int>(result.vertices.size()));
      if (is_new) result.vertices.push_back(p);
      triangle[k] = found->second;
    }
    result.triangles.push_back(triangle);
  }
  return result;
}

}  // namespace mesh_check_truth
