/// @file
/// The hard cases of a mesh that crosses or touches itself: question and methods.
#pragma once

#include <05_meshes/hard_mesh.hpp>
#include <06_triangle_pairs/common_points_truth.hpp>
#include <algorithm>
#include <concepts>
#include <contact/mesh.hpp>
#include <contact/mesh_pairs.hpp>
#include <contact/mesh_shapes.hpp>
#include <contact/mesh_tree.hpp>
#include <contact/pair_orientations.hpp>
#include <contact/triangles_meet.hpp>
#include <string>
#include <support/hard_cases.hpp>
#include <vector>

namespace hard_self_pairs {

using contact::Mesh;
using contact::Triangle;
using contact::Vector3;
using hard_cases::Case;
using hard_cases::Json;
using hard_mesh::mesh_of;
using Pairs = std::vector<contact::TrianglePair>;

// ---------------------------------------------------------------- answers

/// Whether two triangles have a point in common besides the vertices and edges that they share:
/// positions that both have.
inline bool meet_elsewhere(const Triangle<double>& first, const Triangle<double>& second) {
  const auto t = common_points_truth::vertices(first), u = common_points_truth::vertices(second);
  const auto is_shared = [&](const oracle::Vector& x) {
    return std::find(t.begin(), t.end(), x) != t.end() &&
           std::find(u.begin(), u.end(), x) != u.end();
  };
  const auto common = common_points_truth::common_vertices(t, u);
  return common.size() >= 3 || std::any_of(common.begin(), common.end(), [&](const auto& point) {
           return !is_shared(point.position);
         });
}

/// The pairs i < j of a mesh for which choose(i, j) holds.
template <class Choose>
Pairs pairs_by(const Mesh<double>& mesh, const Choose& choose) {
  Pairs pairs;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (std::size_t j = i + 1; j < mesh.triangles.size(); ++j) {
      if (choose(i, j)) pairs.push_back({static_cast<int>(i), static_cast<int>(j)});
    }
  }
  return pairs;
}
inline Pairs true_pairs(const Mesh<double>& mesh) {
  return pairs_by(mesh, [&mesh](std::size_t i, std::size_t j) {
    return meet_elsewhere(triangle_of(mesh, i), triangle_of(mesh, j));
  });
}

// ---------------------------------------------------------------- methods as they are often
// written

/// How many indices two triangles share.
inline int shared_indices(const Mesh<double>& mesh, std::size_t i, std::size_t j) {
  int shared = 0;
  for (const int v : mesh.triangles[i]) {
    const auto& t = mesh.triangles[j];
    shared += std::find(t.begin(), t.end(), v) != t.end() ? 1 : 0;
  }
  return shared;
}
/// The pairs that meet, without those that share `allowed` indices or more.
template <class Meet>
Pairs without_neighbours(const Mesh<double>& mesh, int allowed, const Meet& meet) {
  return pairs_by(mesh, [&](std::size_t i, std::size_t j) {
    return shared_indices(mesh, i, j) < allowed && meet(triangle_of(mesh, i), triangle_of(mesh, j));
  });
}
/// Each vertex moved towards the centre of its triangle by a millionth.
inline Triangle<double> shrunk(const Triangle<double>& t) {
  const Vector3<double> centre = (t.a + t.b + t.c) / 3;
  const auto moved = [&centre](const Vector3<double>& v) -> Vector3<double> {
    return v + 1e-6 * (centre - v);
  };
  return {moved(t.a), moved(t.b), moved(t.c)};
}

// ---------------------------------------------------------------- question

/// Adds it to a runner.
inline void add_questions(hard_cases::Runner& runner) {
  runner.question("self_pairs", [](const Case& c) -> Json {
    return {{"class", "a"}, {"pairs", true_pairs(mesh_of(c)).size()}};
  });
  const auto add = [&runner](const char* name, const auto& find) {
    runner.method("self_pairs", name, [find](const Case& c, const Json&) {
      return find(mesh_of(c)) == true_pairs(mesh_of(c));
    });
  };
  using T = Triangle<double>;
  const auto exact = [](const T& t, const T& u) { return contact::triangles_meet(t, u); };
  const auto rounded = [](const T& t, const T& u) { return contact::meet_by_orientations(t, u); };
  add("no shared vertex, exact",
      [exact](const Mesh<double>& mesh) { return without_neighbours(mesh, 1, exact); });
  add("no shared edge, exact",
      [exact](const Mesh<double>& mesh) { return without_neighbours(mesh, 2, exact); });
  add("no shared vertex, orientations, double",
      [rounded](const Mesh<double>& mesh) { return without_neighbours(mesh, 1, rounded); });
  add("shrunk by a millionth, double", [rounded](const Mesh<double>& mesh) {
    return without_neighbours(
        mesh, 4, [&](const T& t, const T& u) { return rounded(shrunk(t), shrunk(u)); });
  });
  runner.method("self_pairs", "the book, exact", [](const Case& c, const Json&) {
    const Mesh<double> mesh = mesh_of(c);
    const Pairs pairs = true_pairs(mesh);
    if (contact::self_meeting_triangles(mesh) != pairs) return false;
    return c.type() == "double" ||
           contact::self_meeting_triangles(contact::rounded_mesh<float>(mesh)) == pairs;
  });
}

}  // namespace hard_self_pairs
