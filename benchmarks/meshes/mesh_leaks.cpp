// Counts the rays that leave a closed mesh unseen: each starts inside and is aimed at an edge or a
// vertex, so it must hit. usage: mesh_leaks [rays]
//
// The starts are inside by exact numbers. A ray that misses everything has leaked. In the ball,
// which is convex, every ray meets the surface where it is aimed, so a triangle that has no vertex
// in common with the one aimed at is a leak, too.
#include "peers.hpp"

#include "questions.hpp"

#include <algorithm>
#include <contact/mesh_tree.hpp>
#include <contact/ray_box.hpp>
#include <contact/ray_triangle.hpp>
#include <contact/watertight.hpp>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>

namespace {

using contact::MeshTree;
using contact::Ray;
using questions::Body;
using questions::Point;
using questions::Random;
using questions::Scene;

/// Rays in portions, so that memory does not grow with their number.
constexpr std::size_t portion = 100000;
/// What is asked of the methods without a tree of their own, which are slow here.
constexpr std::size_t slow_rays = 5 * portion;

struct Portion {
  std::vector<Ray<double>> in_double;
  std::vector<Ray<float>> in_float;
  peers::RaysOfFloats plain;
  std::vector<int> targets;  ///< a triangle with the edge or vertex aimed at
};

std::vector<Point> starts_in(const Scene& scene) {
  Random random(1);
  std::vector<Point> starts;
  while (starts.size() < 1000) {
    const Point p = mesh_families::near_body(random, scene.body, 0.95);
    if (mesh_truth::where(p, scene.body.in_double) > 0) starts.push_back(p);
  }
  return starts;
}

Portion drawn(Random& random, const Scene& scene, const std::vector<Point>& starts) {
  const auto& mesh = scene.body.in_double;
  Portion rays;
  while (rays.targets.size() < portion) {
    const std::size_t triangle = mesh_families::any_triangle(random, mesh);
    const int corner = random.integer(0, 2);
    const Point &a = mesh_families::corner(mesh, triangle, corner),
                &b = mesh_families::corner(mesh, triangle, corner + 1);
    const double share = random.chance(0.5) ? 0 : random.uniform();
    const auto start = static_cast<std::size_t>(random.integer(0, 999));
    const Point& origin = starts[start];
    const Ray<float> ray{mesh_families::in_float(origin),
                         mesh_families::in_float(a + share * (b - a) - origin)};
    // CGAL takes a second point, which must be exact.
    const Point direction = ray.direction.cast<double>();
    if (Point(Point(origin + direction) - origin) != direction) continue;
    rays.in_double.push_back({origin, direction});
    rays.in_float.push_back(ray);
    rays.plain.origins.push_back(questions::numbers(ray.origin));
    rays.plain.directions.push_back(questions::numbers(ray.direction));
    rays.targets.push_back(static_cast<int>(triangle));
  }
  return rays;
}

struct Method {
  std::string name;
  std::function<void(const Portion&, peers::Answers&)> ask;
  std::size_t at_most = std::numeric_limits<std::size_t>::max();  ///< rays
  std::size_t asked = 0, leaked = 0;
};

template <class S>
const std::vector<Ray<S>>& rays_in(const Portion& rays) {
  if constexpr (std::is_same_v<S, float>) {
    return rays.in_float;
  } else {
    return rays.in_double;
  }
}

/// The least t of the triangles in boxes that the line meets, each asked on its own. The boxes are
/// decided exactly: what leaks, leaks between triangles.
template <class S, class Meet>
Method each_triangle(const char* name, const MeshTree<S>& tree, Meet meet) {
  return {name,
          [&tree, meet](const Portion& rays, peers::Answers& answers) {
            peers::in_turn(portion, answers, [&](std::size_t i) {
              const Ray<S>& ray = rays_in<S>(rays)[i];
              const Ray<double> line = rays.in_double[i];
              int first = -1;
              S least = std::numeric_limits<S>::infinity();
              tree.visit(
                  [&line](const contact::Aabb<S>& box) {
                    return contact::hits_box(line, contact::in_double(box));
                  },
                  [&](int triangle, const contact::Triangle<S>& corners) {
                    const auto hit = meet(ray, corners);
                    if (hit && hit->t < least) {
                      least = hit->t;
                      first = triangle;
                    }
                    return false;
                  });
              return first;
            });
          },
          slow_rays};
}

template <class S>
Method book(const char* name, const MeshTree<S>& tree) {
  return {name, [&tree](const Portion& rays, peers::Answers& answers) {
            peers::in_turn(portion, answers, [&](std::size_t i) {
              const auto hit = tree.first(rays_in<S>(rays)[i]);
              return hit ? hit->triangle : -1;
            });
          }};
}

void count(const Scene& scene, bool convex, std::size_t rays) {
  const MeshTree<double> in_double(scene.body.in_double);
  const MeshTree<float> in_float(scene.body.in_float);
  const auto moller_trumbore = [](const auto& ray, const auto& triangle) {
    return contact::intersect_moller_trumbore(ray, triangle);
  };
  const auto watertight = [](const auto& ray, const auto& triangle) {
    return contact::intersect_watertight(ray, triangle);
  };
  std::vector<Method> methods{
      book("Contact Hours, first", in_double),
      book("Contact Hours, first, float", in_float),
      each_triangle("Möller–Trumbore, float", in_float, moller_trumbore),
      each_triangle("Möller–Trumbore", in_double, moller_trumbore),
      each_triangle("watertight, float", in_float, watertight),
      each_triangle("watertight", in_double, watertight),
  };
  std::vector<peers::Tree> peers;
  const auto add = [&](const char* name, peers::Tree tree) {
    tree.build();
    methods.push_back(
        {name, [ask = tree.first](const Portion& portion_of, peers::Answers& answers) {
           ask(portion_of.plain, answers);
         }});
    peers.push_back(std::move(tree));
  };
#ifdef CONTACT_HAS_EMBREE
  add("Embree, sse2, robust", peers::embree(scene.plain, "threads=1,isa=sse2", true));
  add("Embree, its default", peers::embree(scene.plain, "threads=1", false));
#endif
#ifdef CONTACT_HAS_CGAL
  add("CGAL", peers::cgal(scene.plain));
#endif
  const std::vector<Point> starts = starts_in(scene);
  Random random(2);
  std::size_t asked = 0;
  peers::Answers answers(portion);
  for (; asked < rays; asked += portion) {
    const Portion next = drawn(random, scene, starts);
    for (Method& method : methods) {
      if (method.asked >= method.at_most) continue;
      method.ask(next, answers);
      method.asked += portion;
      for (std::size_t i = 0; i < portion; ++i) {
        const bool elsewhere =
            convex && answers[i] >= 0 &&
            !mesh_truth::share_a_vertex(scene.body.in_double, answers[i], next.targets[i]);
        method.leaked += answers[i] < 0 || elsewhere;
      }
    }
  }
  std::printf("%s, %zu triangles, %zu rays from inside at edges and vertices: leaked\n",
              scene.title.c_str(), scene.plain.triangles.size(), asked);
  for (const Method& method : methods) {
    std::printf("  %-34s %9zu of %9zu\n", method.name.c_str(), method.leaked, method.asked);
  }
  std::printf("\n");
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t rays =
      argc > 1 ? static_cast<std::size_t>(std::max(1L, std::atol(argv[1]))) : 10000000;
  count(questions::scene_of("ball", "a ball", mesh_families::on_lattice(contact::ball_mesh(1, 6))),
        true, rays / 2);
  count(questions::scene_of("torus", "a rough torus",
                            mesh_families::on_lattice(questions::rough_torus())),
        false, rays / 2);
}
