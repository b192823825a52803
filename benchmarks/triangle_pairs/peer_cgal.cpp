// CGAL: do_intersect of two triangles, and pairs of faces by sorted boxes and by a tree of boxes.
#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/intersection.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <iterator>

#include "peers.hpp"

namespace {

namespace Processing = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Face = Mesh::Face_index;
using Primitive = CGAL::AABB_face_graph_triangle_primitive<Mesh>;
using BoxTree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

template <class K>
peers::PairTest do_intersect(const char* name) {
  return peers::pair_test(
      name,
      [](const peers::Corners& corners) {
        const auto point = [](const peers::Numbers& p) {
          return typename K::Point_3(p[0], p[1], p[2]);
        };
        return typename K::Triangle_3(point(corners[0]), point(corners[1]), point(corners[2]));
      },
      [](const auto& first, const auto& second) { return CGAL::do_intersect(first, second); });
}

Mesh mesh_of(const peers::MeshOfNumbers& from) {
  Mesh mesh;
  std::vector<Mesh::Vertex_index> vertices;
  for (const peers::Numbers& v : from.vertices) {
    vertices.push_back(mesh.add_vertex(Point(v[0], v[1], v[2])));
  }
  const auto vertex = [&vertices](int i) { return vertices[static_cast<std::size_t>(i)]; };
  for (const auto& [a, b, c] : from.triangles) mesh.add_face(vertex(a), vertex(b), vertex(c));
  return mesh;
}

void keep(const std::vector<std::pair<Face, Face>>& faces, peers::Found& found) {
  found.clear();
  for (const auto& [f, g] : faces) {
    found.emplace_back(static_cast<int>(f.idx()), static_cast<int>(g.idx()));
  }
}

struct Both {
  Mesh first, second;
  std::unique_ptr<BoxTree> tree;
};

Kernel::Triangle_3 triangle(const Mesh& mesh, Face face) {
  const auto h = mesh.halfedge(face);
  return {mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
          mesh.point(mesh.target(mesh.next(h)))};
}

peers::MeshTest by_boxes(const std::shared_ptr<Both>& both) {
  peers::MeshTest test;
  test.name = "CGAL, PMP by sorted boxes";
  test.any = [both] { return Processing::do_intersect(both->first, both->second); };
  test.all = [both](peers::Found& found) {
    std::vector<std::pair<Face, Face>> faces;
    const auto& usual = CGAL::parameters::default_values();
    Processing::internal::compute_face_face_intersection(both->first, both->second,
                                                         std::back_inserter(faces), usual, usual);
    keep(faces, found);
  };
  return test;
}

/// The faces of the first mesh, one after the other, against a tree of the second.
peers::MeshTest by_tree(const std::shared_ptr<Both>& both) {
  peers::MeshTest test;
  test.name = "CGAL, AABB_tree";
  test.build = [both] {
    both->tree = std::make_unique<BoxTree>(faces(both->second).first, faces(both->second).second,
                                           both->second);
    both->tree->build();
  };
  test.any = [both] {
    for (const Face face : both->first.faces()) {
      if (both->tree->do_intersect(triangle(both->first, face))) return true;
    }
    return false;
  };
  test.all = [both](peers::Found& found) {
    std::vector<std::pair<Face, Face>> pairs;
    std::vector<Face> met;
    for (const Face face : both->first.faces()) {
      met.clear();
      both->tree->all_intersected_primitives(triangle(both->first, face), std::back_inserter(met));
      for (const Face other : met) pairs.emplace_back(face, other);
    }
    keep(pairs, found);
  };
  return test;
}

}  // namespace

std::vector<peers::PairTest> peers::cgal_pairs() {
  return {do_intersect<Kernel>("CGAL, EPICK"),
          do_intersect<CGAL::Exact_predicates_exact_constructions_kernel>("CGAL, EPECK")};
}

std::vector<peers::MeshTest> peers::cgal_meshes(const MeshOfNumbers& first,
                                                const MeshOfNumbers& second) {
  auto both = std::make_shared<Both>();
  both->first = mesh_of(first);
  both->second = mesh_of(second);
  return {by_boxes(both), by_tree(both)};
}

std::vector<peers::SelfTest> peers::cgal_self(const MeshOfNumbers& mesh) {
  return {{"CGAL, PMP::self_intersections",
           [kept = std::make_shared<Mesh>(mesh_of(mesh))](Found& found) {
             std::vector<std::pair<Face, Face>> faces;
             Processing::self_intersections(*kept, std::back_inserter(faces));
             keep(faces, found);
           }}};
}
