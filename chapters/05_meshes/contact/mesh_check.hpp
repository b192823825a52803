/// @file
/// Whether a mesh bounds a solid: closed, oriented, manifold, with an answer that says what is
/// wrong where.
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <contact/exact.hpp>
#include <contact/mesh.hpp>
#include <contact/mesh_edges.hpp>
#include <contact/mesh_fault.hpp>
#include <contact/orientation.hpp>
#include <cstddef>
#include <cstdlib>
#include <numeric>
#include <utility>
#include <vector>

namespace contact {

/// Triangles that are joined by edges.
struct MeshComponent {
  std::vector<int> triangles;    ///< in increasing order
  bool closed = true;            ///< no edge ends the surface, see MeshReport
  bool oriented = true;          ///< see MeshReport
  int euler_characteristic = 0;  ///< vertices − edges + triangles: 2 for a sphere, 0 for a torus
  int volume_sign = 0;           ///< the exact sign of the volume if closed and oriented, else 0
};

/// What `check_mesh` found.
///
/// Triangles with an index out of range or a repeated one are left out of all but their own faults:
/// an edge between a vertex and itself separates nothing. An empty mesh is `ok()`, has a count of 0
/// for every kind, and bounds no solid.
struct MeshReport {
  bool closed = true;    ///< every edge has an even number of triangles
  bool oriented = true;  ///< at each edge as many triangles run one way as the other; if their
                         ///< number is odd, but for one
  bool manifold = true;  ///< no edge has more than two triangles, the triangles at each vertex form
                         ///< one fan, and no two triangles have the same three vertices
  int euler_characteristic = 0;           ///< used vertices − edges + triangles
  std::vector<MeshComponent> components;  ///< in the order of their first triangles
  std::vector<MeshFault> faults;          ///< by kind; edges by their vertices, others by index

  /// Whether nothing was found.
  bool ok() const { return faults.empty(); }
  /// Whether the mesh bounds a solid, provided that the surface does not cross itself, that what is
  /// taken for a cavity is one, and that no component lies inside another with the same side
  /// outwards (a box in a box, both with the front outside, is accepted): it is closed, oriented
  /// and manifold, every component has a volume and none is inside out. Triangles without area,
  /// unused finite vertices and equal vertices do not matter here.
  bool bounds_solid() const {
    return closed && oriented && manifold && !components.empty() &&
           std::none_of(faults.begin(), faults.end(), [](const MeshFault& f) {
             return f.kind == MeshFaultKind::index_out_of_range ||
                    f.kind == MeshFaultKind::vertex_not_finite ||
                    f.kind == MeshFaultKind::component_inside_out ||
                    f.kind == MeshFaultKind::component_no_volume;
           });
  }
  /// How many faults of a kind there are.
  int count(MeshFaultKind kind) const {
    return static_cast<int>(std::count_if(faults.begin(), faults.end(),
                                          [kind](const MeshFault& f) { return f.kind == kind; }));
  }
};

namespace mesh_check_detail {

/// The groups of finite vertices with equal coordinates, each in increasing order.
template <std::floating_point S>
std::vector<std::vector<int>> equal_vertices(const Mesh<S>& mesh) {
  std::vector<int> order;
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    if (all_finite(mesh.vertices[v])) order.push_back(static_cast<int>(v));
  }
  const auto key = [&mesh](int v) {
    const Vector3<S>& p = mesh.vertices[static_cast<std::size_t>(v)];
    return std::array<S, 3>{p.x(), p.y(), p.z()};
  };
  std::sort(order.begin(), order.end(),
            [&key](int v, int w) { return key(v) != key(w) ? key(v) < key(w) : v < w; });
  std::vector<std::vector<int>> groups;
  for_each_group(
      order.begin(), order.end(), [&key](int v, int w) { return key(v) == key(w); },
      [&groups](auto begin, auto end) {
        if (end - begin > 1) groups.emplace_back(begin, end);
      });
  std::sort(groups.begin(), groups.end());
  return groups;
}

/// The search for faults, one kind after the other.
template <std::floating_point S>
class MeshCheck {
 public:
  explicit MeshCheck(const Mesh<S>& mesh)
      : mesh_(mesh),
        usable_(mesh.triangles.size()),
        sides_(sorted_half_edges(mesh)),
        joined_(mesh.triangles.size()),
        corners_(3 * mesh.triangles.size()) {
    for (std::size_t i = 0; i < usable_.size(); ++i) {
      usable_[i] = in_range(mesh, mesh.triangles[i]) && !repeats(mesh.triangles[i]);
    }
  }

  MeshReport run() {
    check_triangles();
    check_edges();
    check_vertices();
    check_components();
    std::stable_sort(report_.faults.begin(), report_.faults.end(),
                     [](const MeshFault& f, const MeshFault& g) { return f.kind < g.kind; });
    return std::move(report_);
  }

 private:
  using Kind = MeshFaultKind;
  const Mesh<S>& mesh_;
  std::vector<bool> usable_;
  std::vector<HalfEdge> sides_;
  Sets joined_;   // triangles by edges
  Sets corners_;  // 3 i + k: vertex k of triangle i; joined by edges at the same vertex
  MeshReport report_;

  const std::array<int, 3>& triangle(int i) const {
    return mesh_.triangles[static_cast<std::size_t>(i)];
  }
  Vector3<double> position(int v) const {
    return mesh_.vertices[static_cast<std::size_t>(v)].template cast<double>();
  }
  bool finite(int v) const { return all_finite(mesh_.vertices[static_cast<std::size_t>(v)]); }
  int count() const { return static_cast<int>(mesh_.triangles.size()); }
  void add(Kind kind, std::vector<int> triangles, std::vector<int> vertices) {
    report_.faults.push_back({kind, std::move(triangles), std::move(vertices)});
  }

  void check_triangles() {
    std::vector<std::pair<std::array<int, 3>, int>> sorted;
    for (int i = 0; i < count(); ++i) {
      const std::array<int, 3>& t = triangle(i);
      if (!in_range(mesh_, t)) {
        add(Kind::index_out_of_range, {i}, {});
        continue;
      }
      if (repeats(t)) {
        add(Kind::repeated_index, {i}, {});
        continue;
      }
      if (finite(t[0]) && finite(t[1]) && finite(t[2]) &&
          are_collinear(position(t[0]), position(t[1]), position(t[2]))) {
        add(Kind::no_area, {i}, {});
      }
      std::array<int, 3> vertices = t;
      std::sort(vertices.begin(), vertices.end());
      sorted.push_back({vertices, i});
    }
    std::sort(sorted.begin(), sorted.end());
    for_each_group(
        sorted.begin(), sorted.end(),
        [](const auto& s, const auto& t) { return s.first == t.first; },
        [this](auto begin, auto end) {
          if (end - begin < 2) return;
          std::vector<int> same;
          for (auto k = begin; k != end; ++k) same.push_back(k->second);
          report_.manifold = false;
          add(Kind::same_triangle, same, {begin->first.begin(), begin->first.end()});
        });
  }

  /// Which element of corners_ belongs to vertex v in triangle i.
  int corner(int i, int v) const {
    const std::array<int, 3>& t = triangle(i);
    return 3 * i + (t[0] == v ? 0 : t[1] == v ? 1 : 2);
  }

  // [check-edges]
  void check_edges() {
    int edges = 0;
    for_each_group(
        sides_.begin(), sides_.end(),
        [](const HalfEdge& g, const HalfEdge& h) { return g.same_edge(h); },
        [this, &edges](auto begin, auto end) {
          ++edges;
          const auto all = static_cast<int>(end - begin);
          const auto up =
              static_cast<int>(std::count_if(begin, end, [](const HalfEdge& h) { return h.up; }));
          std::vector<int> triangles;
          for (auto k = begin; k != end; ++k) {
            triangles.push_back(k->triangle);
            joined_.unite(begin->triangle, k->triangle);
            for (const int v : {k->low, k->high}) {
              corners_.unite(corner(begin->triangle, v), corner(k->triangle, v));
            }
          }
          const std::vector<int> edge{begin->low, begin->high};
          if (all == 1) add(Kind::boundary_edge, triangles, edge);
          if (all > 2) add(Kind::crowded_edge, triangles, edge);
          if (std::abs(2 * up - all) > all % 2) add(Kind::same_direction, triangles, edge);
          if (all > 2) report_.manifold = false;
        });
    report_.euler_characteristic -= edges;
  }
  // [/check-edges]

  void check_vertices() {
    std::vector<std::pair<int, int>> fans;  // vertex, set of corners
    for (int i = 0; i < count(); ++i) {
      if (!usable_[static_cast<std::size_t>(i)]) continue;
      ++report_.euler_characteristic;
      for (int k = 0; k < 3; ++k) {
        fans.push_back({triangle(i)[static_cast<std::size_t>(k)], corners_.find(3 * i + k)});
      }
    }
    std::sort(fans.begin(), fans.end());
    fans.erase(std::unique(fans.begin(), fans.end()), fans.end());
    std::vector<bool> used(mesh_.vertices.size(), false);
    for_each_group(
        fans.begin(), fans.end(), [](const auto& f, const auto& g) { return f.first == g.first; },
        [this, &used](auto begin, auto end) {
          used[static_cast<std::size_t>(begin->first)] = true;
          ++report_.euler_characteristic;
          if (end - begin < 2) return;
          std::vector<int> one_of_each;
          for (auto k = begin; k != end; ++k) one_of_each.push_back(k->second / 3);
          report_.manifold = false;
          add(Kind::several_fans, one_of_each, {begin->first});
        });
    for (std::size_t v = 0; v < used.size(); ++v) {
      const int index = static_cast<int>(v);
      if (!finite(index)) add(Kind::vertex_not_finite, {}, {index});
      if (!used[v]) add(Kind::unused_vertex, {}, {index});
    }
    for (std::vector<int>& group : equal_vertices(mesh_))
      add(Kind::equal_vertices, {}, std::move(group));
  }

  void check_components() {
    std::vector<int> name(mesh_.triangles.size(), -1);
    std::vector<MeshComponent>& components = report_.components;
    const auto component_of = [&](int i) -> MeshComponent& {
      return components[static_cast<std::size_t>(name[static_cast<std::size_t>(i)])];
    };
    std::vector<std::pair<int, int>> used;  // component, vertex
    for (int i = 0; i < count(); ++i) {
      if (!usable_[static_cast<std::size_t>(i)]) continue;
      const int first = joined_.find(i);
      int& number = name[static_cast<std::size_t>(first)];
      if (number < 0) {
        number = static_cast<int>(components.size());
        components.emplace_back();
      }
      name[static_cast<std::size_t>(i)] = number;
      component_of(i).triangles.push_back(i);
      ++component_of(i).euler_characteristic;
      for (const int v : triangle(i)) used.push_back({number, v});
    }
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    for (const auto& [number, v] : used) {
      ++components[static_cast<std::size_t>(number)].euler_characteristic;
    }
    for_each_group(
        sides_.begin(), sides_.end(),
        [](const HalfEdge& g, const HalfEdge& h) { return g.same_edge(h); },
        [&component_of](auto begin, auto end) {
          MeshComponent& component = component_of(begin->triangle);
          const auto all = static_cast<int>(end - begin);
          const auto up =
              static_cast<int>(std::count_if(begin, end, [](const HalfEdge& h) { return h.up; }));
          --component.euler_characteristic;
          if (all % 2 != 0) component.closed = false;
          if (std::abs(2 * up - all) > all % 2) component.oriented = false;
        });
    for (MeshComponent& component : components) {
      report_.closed = report_.closed && component.closed;
      report_.oriented = report_.oriented && component.oriented;
      if (component.closed && component.oriented) component.volume_sign = volume_sign(component);
    }
    for (const MeshComponent& component : components) {
      if (!component.closed || !component.oriented || !all_vertices_finite(component)) continue;
      if (component.volume_sign == 0) add(Kind::component_no_volume, component.triangles, {});
      if (component.volume_sign < 0 && !may_be_cavity(component)) {
        add(Kind::component_inside_out, component.triangles, {});
      }
    }
  }

  bool all_vertices_finite(const MeshComponent& component) const {
    return std::all_of(component.triangles.begin(), component.triangles.end(), [this](int i) {
      const std::array<int, 3>& t = triangle(i);
      return finite(t[0]) && finite(t[1]) && finite(t[2]);
    });
  }

  /// The exact sign of the volume; 0 if a vertex is not finite.
  int volume_sign(const MeshComponent& component) const {
    if (!all_vertices_finite(component)) return 0;
    std::vector<std::array<int, 3>> triangles;
    for (const int i : component.triangles) triangles.push_back(triangle(i));
    const int certain = volume_of(mesh_, triangles).certain_sign();
    if (certain != 0) return certain;
    Exact sum;
    const auto exact = [this](int v) {
      const Vector3<double> p = position(v);
      return Vector3<Exact>(Exact(p.x()), Exact(p.y()), Exact(p.z()));
    };
    for (const auto& [a, b, c] : triangles) sum += exact(a).dot(exact(b).cross(exact(c)));
    return sum.sign();
  }

  /// The least and largest coordinates of a component's vertices.
  std::pair<Vector3<double>, Vector3<double>> box(const MeshComponent& component) const {
    Vector3<double> low = position(triangle(component.triangles[0])[0]), high = low;
    for (const int i : component.triangles) {
      for (const int v : triangle(i)) {
        low = low.cwiseMin(position(v)).eval();
        high = high.cwiseMax(position(v)).eval();
      }
    }
    return {low, high};
  }
  /// Whether its box is in the box of a component with a volume greater than 0.
  bool may_be_cavity(const MeshComponent& inner) const {
    const auto [low, high] = box(inner);
    for (const MeshComponent& outer : report_.components) {
      if (outer.volume_sign <= 0) continue;
      const auto [from, to] = box(outer);
      bool in = true;
      for (int k = 0; k < 3; ++k) in = in && from[k] <= low[k] && high[k] <= to[k];
      if (in) return true;
    }
    return false;
  }
};

}  // namespace mesh_check_detail

/// Checks a mesh: whether it is closed, oriented and manifold, its components and its Euler
/// characteristic, and every fault with the triangles and vertices that take part.
///
/// All decisions are exact: areas and volumes by exact signs, equal vertices by comparing
/// coordinates (−0 equals 0). Right for every input, also one with indices out of range and with
/// coordinates that are not finite. O(n log n); the same list on every machine.
///
/// An empty mesh has no faults. Triangles that meet only at a vertex are different components. A
/// closed component with a negative volume is inside out, unless its box is in the box of a
/// component with a positive one: then it is taken for a cavity.
///
/// What it does not see: a surface that crosses itself (triangle pairs are chapter 06), and whether
/// a component is inside another (that needs a test of a point in a polyhedron). So a box inside of
/// a box, both with the front outside, passes; its inner region counts twice.
template <std::floating_point S>
MeshReport check_mesh(const Mesh<S>& mesh) {
  return mesh_check_detail::MeshCheck<S>(mesh).run();
}

/// The mesh with each group of equal vertices replaced by the first of them: what makes a triangle
/// soup, where each triangle has its own vertices, an indexed mesh. Nothing else changes; vertices
/// that are then unused stay. Exactly equal coordinates only: a tolerance could merge what is
/// apart, and is not transitive. −0 equals 0; a vertex that is not finite is equal to none, and an
/// index out of range stays.
template <std::floating_point S>
Mesh<S> merge_equal_vertices(Mesh<S> mesh) {
  std::vector<int> name(mesh.vertices.size());
  std::iota(name.begin(), name.end(), 0);
  for (const std::vector<int>& group : mesh_check_detail::equal_vertices(mesh)) {
    for (const int v : group) name[static_cast<std::size_t>(v)] = group[0];
  }
  for (auto& triangle : mesh.triangles) {
    for (int& v : triangle) {
      if (v >= 0 && static_cast<std::size_t>(v) < name.size())
        v = name[static_cast<std::size_t>(v)];
    }
  }
  return mesh;
}

}  // namespace contact
