/// @file
/// The contacts of two meshes in fractions and by definition: each feature of one with each feature
/// of the other. Slow; for meshes that do not cross or touch themselves.
#pragma once

#include <06_triangle_pairs/common_points_truth.hpp>
#include <algorithm>
#include <array>
#include <contact/mesh.hpp>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <support/oracle.hpp>
#include <utility>
#include <vector>

namespace mesh_contacts_truth {

using common_points_truth::cross;
using common_points_truth::feature_at;
using common_points_truth::is_zero;
using common_points_truth::Vertices;
using contact::FeatureKind;
using oracle::Rational;
using oracle::Vector;

struct Edge {
  Vector from, to;
};
/// The triangles of a face.
using Face = std::vector<Vertices>;

/// The features of a mesh. Vertices at equal positions are one.
struct Features {
  std::vector<Vector> vertices;  ///< those of triangles
  std::vector<Edge> edges;       ///< those that are not flat
  std::vector<Face> faces;       ///< triangles across flat edges are in one
};

namespace detail {

/// Whether exactly two triangles have this edge, in one plane and on different sides of it.
inline bool is_flat(const Edge& e, const std::vector<Vector>& thirds) {
  if (thirds.size() != 2) return false;
  const Vector along = e.to - e.from;
  const Vector left = cross(along, thirds[0] - e.from), right = cross(along, thirds[1] - e.from);
  return is_zero(cross(left, right)) && left.dot(right) < 0;
}

}  // namespace detail

/// @param mesh m; triangles without area have no feature but their vertices
inline Features features_of(const contact::Mesh<double>& mesh) {
  Features found;
  std::vector<int> index;  // of each vertex, that of the first at its position
  for (const auto& v : mesh.vertices) {
    const Vector x = oracle::exact(v);
    const auto at = std::find(found.vertices.begin(), found.vertices.end(), x);
    index.push_back(static_cast<int>(at - found.vertices.begin()));
    if (at == found.vertices.end()) found.vertices.push_back(x);
  }
  const auto position = [&](int v) { return found.vertices[static_cast<std::size_t>(v)]; };

  std::map<std::pair<int, int>, std::vector<std::pair<std::size_t, int>>> edges;
  std::vector<std::array<int, 3>> triangles;
  for (const auto& t : mesh.triangles) {
    std::array<int, 3> named{};
    for (std::size_t k = 0; k < 3; ++k) named[k] = index[static_cast<std::size_t>(t[k])];
    triangles.push_back(named);
    for (std::size_t k = 0; k < 3; ++k) {
      edges[std::minmax(named[k], named[(k + 1) % 3])].push_back(
          {triangles.size() - 1, named[(k + 2) % 3]});
    }
  }
  std::vector<std::size_t> face(triangles.size());
  for (std::size_t i = 0; i < face.size(); ++i) face[i] = i;
  for (const auto& [ends, uses] : edges) {
    const Edge edge{position(ends.first), position(ends.second)};
    std::vector<Vector> thirds;
    for (const auto& use : uses) thirds.push_back(position(use.second));
    if (!detail::is_flat(edge, thirds)) {
      found.edges.push_back(edge);
      continue;
    }
    const std::size_t from = face[uses[0].first], to = face[uses[1].first];
    std::replace(face.begin(), face.end(), from, to);
  }
  for (std::size_t i = 0; i < face.size(); ++i) {
    Face triangles_of_face;
    for (std::size_t j = 0; j < face.size(); ++j) {
      const auto& t = triangles[j];
      if (face[j] == i)
        triangles_of_face.push_back({position(t[0]), position(t[1]), position(t[2])});
    }
    if (!triangles_of_face.empty()) found.faces.push_back(triangles_of_face);
  }
  return found;
}

/// Whether a point is inside an edge.
inline bool inside(const Vector& x, const Edge& e) {
  const Vector along = e.to - e.from, to = x - e.from;
  const Rational at = along.dot(to);
  return is_zero(cross(along, to)) && at > 0 && at < along.dot(along);
}
/// Whether a point is in a face of a mesh, and neither a vertex nor on an edge.
inline bool inside(const Vector& x, const Face& face, const Features& of) {
  if (std::find(of.vertices.begin(), of.vertices.end(), x) != of.vertices.end()) return false;
  for (const Edge& e : of.edges) {
    if (inside(x, e)) return false;
  }
  return std::any_of(face.begin(), face.end(),
                     [&](const Vertices& t) { return feature_at(x, t).has_value(); });
}
/// The single point inside of two edges.
inline std::optional<Vector> crossing(const Edge& e, const Edge& f) {
  const Vector u = e.to - e.from, v = f.to - f.from;
  const Vector normal = cross(u, v);
  if (is_zero(normal)) return std::nullopt;
  const Rational t = normal.dot(cross(f.from - e.from, v)) / normal.dot(normal);
  const Vector x = e.from + u * t;
  if (inside(x, e) && inside(x, f)) return x;
  return std::nullopt;
}
/// The point inside of an edge and of a face that it crosses.
inline std::optional<Vector> crossing(const Edge& e, const Face& face, const Features& of) {
  const Vertices& t = face.front();
  const Vector normal = cross(t[1] - t[0], t[2] - t[0]), along = e.to - e.from;
  const Rational rate = normal.dot(along);
  if (rate == 0) return std::nullopt;
  const Vector x = e.from + along * Rational(normal.dot(t[0] - e.from) / rate);
  if (inside(x, e) && inside(x, face, of)) return x;
  return std::nullopt;
}

/// The positions of all contacts, one for each pair of features.
inline std::vector<Vector> contacts(const Features& a, const Features& b) {
  std::vector<Vector> found;
  const auto add = [&found](const std::optional<Vector>& x) {
    if (x) found.push_back(*x);
  };
  const auto add_one_way = [&](const Features& s, const Features& t, bool first) {
    for (const Vector& x : s.vertices) {
      const auto same = std::count(t.vertices.begin(), t.vertices.end(), x);
      if (first && same > 0) found.push_back(x);
      for (const Edge& e : t.edges) {
        if (inside(x, e)) found.push_back(x);
      }
      for (const Face& f : t.faces) {
        if (inside(x, f, t)) found.push_back(x);
      }
    }
    for (const Edge& e : s.edges) {
      for (const Edge& f : t.edges) {
        if (first) add(crossing(e, f));
      }
      for (const Face& f : t.faces) add(crossing(e, f, t));
    }
  };
  add_one_way(a, b, true);
  add_one_way(b, a, false);
  return found;
}

}  // namespace mesh_contacts_truth
