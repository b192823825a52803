/// @file
/// The contacts of two meshes with whole coordinates, in integers, by way of all pairs of triangles
/// and by how many triangles contain a point: unlike the solution. Also with the mistakes that
/// people make, and bodies that touch. For the tests of the exercise.
#pragma once

#include <05_meshes/solids.hpp>
#include <06_triangle_pairs/whole_edges.hpp>

namespace whole_contacts {

using solids::Mesh;
using solids::Point;
using solids::Triangle;
using whole_edges::Segment;
using Name = std::vector<int>;

struct Contact {
  Name of_a, of_b;
  Point position;
};
using Contacts = std::vector<Contact>;

inline Name sorted(Name name) {
  std::sort(name.begin(), name.end());
  return name;
}
inline Contacts sorted(Contacts all) {
  std::stable_sort(all.begin(), all.end(), [](const Contact& x, const Contact& y) {
    return std::tie(x.of_a, x.of_b) < std::tie(y.of_a, y.of_b);
  });
  return all;
}

/// What counts as an edge.
enum class Edges { of_body, of_mesh, convex, with_other_normals, with_other_unit_normals };

inline std::array<Name, 3> edges_of_triangle(const Mesh& mesh, std::size_t i) {
  const auto& [a, b, c] = mesh.triangles[i];
  return {Name{a, b}, Name{b, c}, Name{c, a}};
}
inline Segment segment(const Mesh& mesh, const Name& edge) {
  const auto at = [&](int v) { return mesh.vertices[static_cast<std::size_t>(v)]; };
  return {at(edge[0]), at(edge[1])};
}
inline Point normal(const Mesh& mesh, std::size_t i) {
  return whole_edges::in_double(solids::normal(triangle_of(mesh, i)));
}

/// Whether an edge with these two triangles counts.
inline bool counts(const Mesh& mesh, std::size_t i, std::size_t j, Edges kind) {
  const auto m = solids::normal(triangle_of(mesh, i)), n = solids::normal(triangle_of(mesh, j));
  if (kind == Edges::of_mesh) return true;
  if (kind == Edges::with_other_normals) return m.at != n.at;
  if (kind == Edges::with_other_unit_normals)
    return normal(mesh, i).normalized() != normal(mesh, j).normalized();
  if (whole_edges::is_zero(solids::cross(m, n))) return false;
  if (kind == Edges::of_body) return true;
  const auto& second = mesh.triangles[j];
  return std::all_of(second.begin(), second.end(), [&](int v) {
    const Point& p = mesh.vertices[static_cast<std::size_t>(v)];
    return solids::ahead(triangle_of(mesh, i), p) <= 0;
  });
}

/// An edge with its two triangles.
struct EdgeOfTwo {
  Name edge;
  std::size_t first, second;
};
inline std::vector<EdgeOfTwo> edges_of_two(const Mesh& mesh) {
  std::vector<std::pair<Name, std::size_t>> all;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (const Name& edge : edges_of_triangle(mesh, i)) all.emplace_back(sorted(edge), i);
  }
  std::sort(all.begin(), all.end());
  std::vector<EdgeOfTwo> paired;
  for (std::size_t i = 0; i + 1 < all.size(); i += 2)
    paired.push_back({all[i].first, all[i].second, all[i + 1].second});
  return paired;
}

inline std::vector<Name> edges(const Mesh& mesh, Edges kind = Edges::of_body) {
  std::vector<Name> all;
  for (const auto& [edge, first, second] : edges_of_two(mesh)) {
    if (counts(mesh, first, second, kind)) all.push_back(edge);
  }
  return all;
}
/// Edges whose triangles have unit normals with a dot product of more than this are left out.
inline std::vector<Name> edges_with_tolerance(const Mesh& mesh, double cosine) {
  std::vector<Name> all;
  for (const auto& [edge, first, second] : edges_of_two(mesh)) {
    const Point m = normal(mesh, first), n = normal(mesh, second);
    if (m.normalized().dot(n.normalized()) < cosine) all.push_back(edge);
  }
  return all;
}

/// All triangles that contain the point, in the order of the list.
inline std::vector<std::size_t> triangles_at(const Mesh& mesh, const Point& p) {
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (solids::on_triangle(triangle_of(mesh, i), p)) all.push_back(i);
  }
  return all;
}

inline Name face(const Mesh& mesh, std::size_t i) {
  const auto& [a, b, c] = mesh.triangles[i];
  return sorted(Name{a, b, c});
}
/// What two triangles have in common.
inline Name common(const Name& x, const Name& y) {
  Name both;
  std::set_intersection(x.begin(), x.end(), y.begin(), y.end(), std::back_inserter(both));
  return both;
}

/// Two triangles contain a point inside an edge, and more a vertex.
inline Name feature_at(const Mesh& mesh, const Point& p, Edges kind = Edges::of_body) {
  const std::vector<std::size_t> all = triangles_at(mesh, p);
  if (all.empty()) return {};
  Name smallest = face(mesh, all[0]);
  for (std::size_t i : all) smallest = common(smallest, face(mesh, i));
  const bool is_edge = smallest.size() == 2;
  return is_edge && !counts(mesh, all[0], all[1], kind) ? face(mesh, all[0]) : smallest;
}

/// Where edges cross between their ends.
inline std::optional<Point> crossing(const Segment& a, const Segment& b) {
  if (whole_edges::is_parallel(a, b) || whole_edges::meeting(a, b) < 1) return std::nullopt;
  return whole_edges::position(a, b);
}

/// All contacts of all pairs of triangles, each as often as it comes.
inline Contacts of_pairs(const Mesh& a, const Mesh& b, Edges kind = Edges::of_body) {
  const std::vector<Name> edges_a = edges(a, kind), edges_b = edges(b, kind);
  const auto is_edge = [](const std::vector<Name>& all, const Name& edge) {
    return std::binary_search(all.begin(), all.end(), edge);
  };
  Contacts all;
  for (std::size_t i = 0; i < a.triangles.size(); ++i) {
    for (std::size_t j = 0; j < b.triangles.size(); ++j) {
      for (int v : a.triangles[i]) {
        const Point p = a.vertices[static_cast<std::size_t>(v)];
        if (solids::on_triangle(triangle_of(b, j), p))
          all.push_back({{v}, feature_at(b, p, kind), p});
      }
      for (int v : b.triangles[j]) {
        const Point p = b.vertices[static_cast<std::size_t>(v)];
        if (solids::on_triangle(triangle_of(a, i), p))
          all.push_back({feature_at(a, p, kind), {v}, p});
      }
      for (const Name& of_a : edges_of_triangle(a, i)) {
        for (const Name& of_b : edges_of_triangle(b, j)) {
          const Name x = sorted(of_a), y = sorted(of_b);
          const auto p = crossing(segment(a, x), segment(b, y));
          if (p && is_edge(edges_a, x) && is_edge(edges_b, y)) all.push_back({x, y, *p});
        }
      }
    }
  }
  return sorted(std::move(all));
}

/// Each name once.
inline Contacts contacts(const Mesh& a, const Mesh& b, Edges kind = Edges::of_body) {
  Contacts all = of_pairs(a, b, kind);
  const auto last = std::unique(all.begin(), all.end(), [](const Contact& x, const Contact& y) {
    return x.of_a == y.of_a && x.of_b == y.of_b;
  });
  all.erase(last, all.end());
  return all;
}

inline bool is_vertex(const Name& name) { return name.size() == 1; }

/// Without those that a mistake leaves out.
template <class Keep>
Contacts those(const Contacts& all, Keep&& keep) {
  Contacts kept;
  std::copy_if(all.begin(), all.end(), std::back_inserter(kept), keep);
  return kept;
}

/// With some of them again.
template <class Again>
Contacts twice(Contacts all, Again&& again) {
  const Contacts more = those(all, again);
  all.insert(all.end(), more.begin(), more.end());
  return sorted(std::move(all));
}

/// A vertex with each triangle of the other mesh that contains it.
inline Contacts with_each_triangle(const Mesh& a, const Mesh& b) {
  Contacts all;
  for (const Contact& one : contacts(a, b)) {
    const auto of_a = triangles_at(a, one.position), of_b = triangles_at(b, one.position);
    if (is_vertex(one.of_a)) {
      for (std::size_t j : of_b) all.push_back({one.of_a, face(b, j), one.position});
    }
    if (is_vertex(one.of_b)) {
      for (std::size_t i : of_a) all.push_back({face(a, i), one.of_b, one.position});
    }
    if (!is_vertex(one.of_a) && !is_vertex(one.of_b)) all.push_back(one);
  }
  return sorted(std::move(all));
}

/// Also each two edges that meet at an end.
inline Contacts with_ends(const Mesh& a, const Mesh& b) {
  Contacts all = contacts(a, b);
  for (const Name& x : edges(a)) {
    for (const Name& y : edges(b)) {
      const Segment s = segment(a, x), t = segment(b, y);
      if (!whole_edges::is_parallel(s, t) && whole_edges::meeting(s, t) == 0)
        all.push_back({x, y, whole_edges::position(s, t)});
    }
  }
  return sorted(std::move(all));
}

/// In the order of the list, without those that are nearer than this to one that is kept.
inline Contacts merged(const Contacts& all, double distance) {
  Contacts kept;
  for (const Contact& one : all) {
    const bool is_near = std::any_of(kept.begin(), kept.end(), [&](const Contact& other) {
      return (one.position - other.position).norm() < distance;
    });
    if (!is_near) kept.push_back(one);
  }
  return kept;
}

}  // namespace whole_contacts
