// CGAL's tree of boxes and its test of a point in a mesh, with exact predicates.
#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>

#include "peers.hpp"

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Primitive = CGAL::AABB_face_graph_triangle_primitive<Mesh>;
using BoxTree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;
using Side = CGAL::Side_of_triangle_mesh<Mesh, Kernel>;

struct All {
  Mesh mesh;
  std::unique_ptr<BoxTree> tree;
  std::unique_ptr<Side> side;
};

Point point(const peers::Floats& p) { return {p[0], p[1], p[2]}; }

Kernel::Ray_3 ray_of(const peers::RaysOfFloats& rays, std::size_t i) {
  const peers::Floats& d = rays.directions[i];
  return {point(rays.origins[i]), Kernel::Vector_3(d[0], d[1], d[2])};
}

volatile double kept = 0;

}  // namespace

peers::Tree peers::cgal(const MeshOfFloats& mesh) {
  auto all = std::make_shared<All>();
  std::vector<Mesh::Vertex_index> vertices;
  for (const Floats& v : mesh.vertices) vertices.push_back(all->mesh.add_vertex(point(v)));
  const auto vertex = [&vertices](int i) { return vertices[static_cast<std::size_t>(i)]; };
  for (const auto& [a, b, c] : mesh.triangles) {
    all->mesh.add_face(vertex(a), vertex(b), vertex(c));
  }
  Tree tree;
  tree.build = [all] {
    all->tree =
        std::make_unique<BoxTree>(faces(all->mesh).first, faces(all->mesh).second, all->mesh);
    all->tree->build();
    all->side = std::make_unique<Side>(*all->tree);
  };
  tree.first = [all](const RaysOfFloats& rays, Answers& answers) {
    double sum = 0;
    in_turn(rays.origins.size(), answers, [&](std::size_t i) {
      const auto hit = all->tree->first_intersection(ray_of(rays, i));
      if (!hit) return -1;
      if (const Point* at = boost::get<Point>(&hit->first)) sum += at->x();
      return static_cast<int>(hit->second.idx());
    });
    kept = sum;
  };
  tree.any = [all](const RaysOfFloats& rays, Answers& answers) {
    in_turn(rays.origins.size(), answers,
            [&](std::size_t i) { return all->tree->do_intersect(ray_of(rays, i)); });
  };
  tree.segment = [all](const RaysOfFloats& rays, Answers& answers) {
    in_turn(rays.origins.size(), answers, [&](std::size_t i) {
      return all->tree->do_intersect(
          Kernel::Segment_3(point(rays.origins[i]), point(rays.ends[i])));
    });
  };
  tree.locate = [all](const std::vector<Floats>& points, Answers& answers) {
    in_turn(points.size(), answers, [&](std::size_t i) {
      static_assert(CGAL::ON_UNBOUNDED_SIDE == -1 && CGAL::ON_BOUNDED_SIDE == 1);
      return (*all->side)(point(points[i]));
    });
  };
  return tree;
}
