/// @file
/// The hard cases of points and polyhedra, of edges and faces, and of two polyhedra: questions and
/// methods.
#pragma once

#include <05_meshes/hard_mesh.hpp>
#include <05_meshes/polyhedra_truth.hpp>
#include <contact/mesh_columns.hpp>
#include <contact/mesh_shapes.hpp>
#include <contact/point_in_polyhedron.hpp>
#include <contact/polyhedra_meet.hpp>
#include <contact/ray_triangle.hpp>
#include <contact/watertight.hpp>
#include <optional>
#include <string>
#include <support/hard_cases.hpp>
#include <vector>

namespace hard_polyhedra {

using contact::Mesh;
using contact::Segment;
using contact::Triangle;
using contact::Vector3;
using contact::Where;
using hard_cases::Case;
using hard_cases::Json;
using hard_mesh::mesh_in;
using hard_mesh::mesh_of;

// ---------------------------------------------------------------- input

template <class S>
Vector3<S> point_of(const Case& c) {
  return generators::rounded<S>(c.vector("point"));
}
/// The direction in which a ray is cast: along x unless the case says otherwise.
template <class S>
Vector3<S> direction_of(const Case& c) {
  return c.has("direction") ? generators::rounded<S>(c.vector("direction"))
                            : Vector3<S>(S(1), S(0), S(0));
}

// ---------------------------------------------------------------- answers

inline const char* name(Where where) {
  return where == Where::inside ? "inside" : (where == Where::on ? "on" : "outside");
}
inline bool right(Where where, const Json& answer) { return answer.at("where") == name(where); }

inline Json location_answer(const Case& c) {
  generators::Random random(1);
  const std::optional<int> winding =
      polyhedra_truth::winding(random, c.vector("point"), mesh_of(c));
  const Where where = !winding ? Where::on : (*winding != 0 ? Where::inside : Where::outside);
  return {{"class", "a"}, {"where", name(where)}, {"winding", winding.value_or(0)}};
}

// ---------------------------------------------------------------- methods as they are often
// written

/// Inside if the ray leaves through the first triangle that it meets: of equal t the first is
/// taken.
inline Where by_side_of_first_hit(const Vector3<double>& point, const Mesh<double>& mesh,
                                  const Vector3<double>& direction) {
  std::optional<double> first;
  Where where = Where::outside;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle<double> t = triangle_of(mesh, i);
    const auto hit = contact::intersect_moller_trumbore(contact::Ray<double>{point, direction}, t);
    if (!hit || (first && *first <= hit->t)) continue;
    first = hit->t;
    const Vector3<double> normal = (t.b - t.a).cross(t.c - t.a);
    where = normal.dot(direction) > 0 ? Where::inside : Where::outside;
  }
  return where;
}

/// Vertices by the parity of a ray along x, and edges by Möller and Trumbore, all rounded.
inline bool polyhedra_meet_rounded(const Mesh<double>& a, const Mesh<double>& b) {
  const auto one_way = [](const Mesh<double>& one, const Mesh<double>& other) {
    for (std::size_t i = 0; i < one.triangles.size(); ++i) {
      const Triangle<double> t = triangle_of(one, i);
      for (const auto& edge : {Segment<double>{t.a, t.b}, {t.b, t.c}, {t.c, t.a}}) {
        if (contact::in_by_parity(edge.start, other) == Where::inside) return true;
        for (std::size_t j = 0; j < other.triangles.size(); ++j) {
          if (contact::intersect_moller_trumbore(edge, triangle_of(other, j))) return true;
        }
      }
    }
    return false;
  };
  return one_way(a, b) || one_way(b, a);
}

/// The boxes of all vertices.
inline bool boxes_meet(const Mesh<double>& a, const Mesh<double>& b) {
  return contact::boxes_touch(contact::aabb_of_points<double>(a.vertices),
                              contact::aabb_of_points<double>(b.vertices));
}

// ---------------------------------------------------------------- questions

template <class Locate>
void add_location(hard_cases::Runner& runner, const std::string& method, Locate locate) {
  runner.method("point_in_mesh", method,
                [locate](const Case& c, const Json& answer) { return right(locate(c), answer); });
}

template <class S>
void add_rounded_locations(hard_cases::Runner& runner, const std::string& type) {
  add_location(runner, "parity, " + type, [](const Case& c) {
    return contact::in_by_parity<S>(point_of<S>(c), mesh_in<S>(c), direction_of<S>(c));
  });
  add_location(runner, "planes, " + type, [](const Case& c) {
    return contact::in_convex_by_planes<S>(point_of<S>(c), mesh_in<S>(c));
  });
  add_location(runner, "solid angles, " + type, [](const Case& c) {
    return contact::where_by_solid_angles<S>(point_of<S>(c), mesh_in<S>(c));
  });
}

inline void add_edges_and_faces(hard_cases::Runner& runner) {
  const auto edge = [](const Case& c) { return c.segment("segment"); };
  const auto face = [](const Case& c) { return c.triangle("triangle"); };
  runner.question("edge_meets_face", [edge, face](const Case& c) -> Json {
    return {{"class", "a"}, {"meet", polyhedra_truth::edge_meets_face(edge(c), face(c))}};
  });
  const auto add = [&](const std::string& name, auto method) {
    runner.method("edge_meets_face", name, [=](const Case& c, const Json& answer) {
      return answer.at("meet") == bool(method(edge(c), face(c)));
    });
  };
  add("edge tests, double",
      [](const auto& s, const auto& t) { return contact::intersect_by_edges(s, t); });
  add("Möller–Trumbore, double",
      [](const auto& s, const auto& t) { return contact::intersect_moller_trumbore(s, t); });
  add("watertight, double",
      [](const auto& s, const auto& t) { return contact::intersect_watertight(s, t); });
  add("the book, exact",
      [](const auto& s, const auto& t) { return contact::edge_meets_face(s, t); });
}

inline void add_polyhedra(hard_cases::Runner& runner) {
  runner.question("polyhedra", [](const Case& c) -> Json {
    return {{"class", "a"},
            {"meet", polyhedra_truth::solids_meet(mesh_of(c, "_a"), mesh_of(c, "_b"))}};
  });
  const auto add = [&](const std::string& name, auto method) {
    runner.method("polyhedra", name, [=](const Case& c, const Json& answer) {
      return answer.at("meet") == method(mesh_of(c, "_a"), mesh_of(c, "_b"));
    });
  };
  using contact::PolyhedraOrder;
  add("boxes alone", boxes_meet);
  add("vertices alone", [](const auto& a, const auto& b) {
    return contact::polyhedra_meet(a, b, PolyhedraOrder::vertices).meet;
  });
  add("edges alone", [](const auto& a, const auto& b) {
    return contact::polyhedra_meet(a, b, PolyhedraOrder::edges).meet;
  });
  add("all tests, rounded", polyhedra_meet_rounded);
  runner.method("polyhedra", "the book, exact", [](const Case& c, const Json& answer) {
    const Mesh<double> a = mesh_of(c, "_a"), b = mesh_of(c, "_b");
    const bool meet = answer.at("meet").get<bool>();
    return contact::polyhedra_meet(a, b).meet == meet &&
           contact::polyhedra_meet(b, a).meet == meet &&
           contact::polyhedra_meet(a, b, PolyhedraOrder::edges_first).meet == meet;
  });
}

inline void add_questions(hard_cases::Runner& runner) {
  runner.question("point_in_mesh", location_answer);
  add_rounded_locations<float>(runner, "float");
  add_rounded_locations<double>(runner, "double");
  add_location(runner, "side of the first hit, double", [](const Case& c) {
    return by_side_of_first_hit(point_of<double>(c), mesh_of(c), direction_of<double>(c));
  });
  add_location(runner, "random rays, double", [](const Case& c) {
    return contact::in_by_random_rays<double>(point_of<double>(c), mesh_of(c)).where;
  });
  runner.method("point_in_mesh", "the book, exact", [](const Case& c, const Json& answer) {
    const auto p = point_of<double>(c);
    const Mesh<double> mesh = mesh_of(c);
    const contact::MeshColumns<double> columns(mesh);
    const contact::MeshLocation found = contact::locate_in_mesh(p, mesh);
    return right(found.where, answer) && answer.at("winding") == found.winding &&
           contact::locate_in_mesh(p, columns) == found &&
           contact::locate_in_mesh(p, columns.tree()) == found;
  });
  add_edges_and_faces(runner);
  add_polyhedra(runner);
}

}  // namespace hard_polyhedra
