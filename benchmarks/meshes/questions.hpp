/// @file
/// The meshes of the comparison with other programs, and rays and points that are hard to decide,
/// with the right answers.
#pragma once

#include <05_meshes/families.hpp>
#include <05_meshes/mesh_truth.hpp>

#include <contact/shapes.hpp>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "../number_files.hpp"
#include "peers.hpp"

namespace questions {

using contact::Mesh;
using generators::Random;
using mesh_families::Body;
using Point = contact::Vector3<double>;

struct Scene {
  std::string name, title;
  Body body;
  peers::MeshOfFloats plain;
};
struct Rays {
  std::string name, title;
  std::vector<contact::Ray<double>> in_double;
  std::vector<contact::Ray<float>> in_float;
  std::vector<contact::Segment<double>> segments;  ///< along the rays, to beyond the mesh
  peers::RaysOfFloats plain;
  std::vector<mesh_truth::First> right, right_for_segment;
};
struct Points {
  std::string name, title;
  std::vector<Point> in_double;
  std::vector<peers::Floats> plain;
  std::vector<int> right;  ///< −1, 0 or 1: outside, on the surface, inside
};

inline peers::Floats numbers(const contact::Vector3<float>& v) { return {v.x(), v.y(), v.z()}; }

inline Scene scene_of(std::string name, std::string title, const Mesh<double>& mesh) {
  Scene scene{std::move(name), std::move(title), mesh_families::rounded(mesh), {}};
  for (const auto& v : scene.body.in_float.vertices) scene.plain.vertices.push_back(numbers(v));
  scene.plain.triangles = mesh.triangles;
  return scene;
}

/// A torus with each vertex moved a little.
inline Mesh<double> rough_torus() {
  Random random(1);
  Mesh<double> mesh = contact::torus_mesh(1, 0.4, 250, 200);
  for (Point& v : mesh.vertices) {
    const Point moved{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    v += 0.002 * moved;
  }
  return mesh;
}
/// 80 balls on a lattice that do not touch each other.
inline Mesh<double> balls() {
  Mesh<double> all;
  const Mesh<double> ball = contact::ball_mesh(0.4, 3);
  for (int i = 0; i < 80; ++i) {
    const Point centre(i % 5, i / 5 % 4, i / 20);
    const int first = static_cast<int>(all.vertices.size());
    for (const Point& v : ball.vertices) all.vertices.push_back(v + centre);
    for (const auto& [a, b, c] : ball.triangles) {
      all.triangles.push_back({first + a, first + b, first + c});
    }
  }
  return all;
}
inline std::vector<Scene> scenes() {
  return {scene_of("torus", "a rough torus", mesh_families::on_lattice(rough_torus())),
          scene_of("balls", "80 balls", mesh_families::on_lattice(balls()))};
}

/// Rays through the targets that `draw` gives. In each, the second point is exact in double.
template <class Draw>
Rays rays_of(const Scene& scene, std::string name, std::string title, std::size_t count,
             std::uint64_t seed, const Draw& draw) {
  Random random(seed);
  Rays rays{std::move(name), std::move(title), {}, {}, {}, {}, {}, {}};
  const auto spheres = mesh_truth::around_triangles(scene.body.in_double);
  while (rays.in_double.size() < count) {
    const auto [origin, target] = draw(random);
    const contact::Ray<float> in_float{mesh_families::in_float(origin),
                                       mesh_families::in_float(target - origin)};
    const contact::Ray<double> ray{in_float.origin.cast<double>(),
                                   in_float.direction.cast<double>()};
    if (Point(Point(ray.origin + ray.direction) - ray.origin) != ray.direction) continue;
    const contact::Vector3<float> end = mesh_families::in_float(ray.origin + 2 * ray.direction);
    const contact::Segment<double> segment{ray.origin, end.cast<double>()};
    rays.in_double.push_back(ray);
    rays.in_float.push_back(in_float);
    rays.segments.push_back(segment);
    rays.plain.origins.push_back(numbers(in_float.origin));
    rays.plain.directions.push_back(numbers(in_float.direction));
    rays.plain.ends.push_back(numbers(end));
    rays.right.push_back(mesh_truth::first(ray, scene.body.in_double, spheres));
    rays.right_for_segment.push_back(mesh_truth::first(segment, scene.body.in_double, spheres));
  }
  return rays;
}

/// Calls with the rays of each family, one after the other.
template <class Call>
void each_family_of_rays(const Scene& scene, std::size_t count, const Call& call) {
  const Body& body = scene.body;
  const Mesh<double>& mesh = body.in_double;
  using Two = std::pair<Point, Point>;
  std::uint64_t seed = 0;
  const auto family = [&](const char* name, const char* title, auto draw) {
    call(rays_of(scene, name, title, count, ++seed, draw));
  };
  family("rays_random", "random", [&](Random& random) {
    const Point origin = mesh_families::around(random, body);
    return Two(origin, mesh_families::near_body(random, body, 1));
  });
  family("rays_edges", "at edges", [&](Random& random) {
    const Point origin = mesh_families::around(random, body);
    return Two(origin, mesh_families::on_edge(random, mesh));
  });
  family("rays_vertices", "at vertices", [&](Random& random) {
    const Point origin = mesh_families::around(random, body);
    return Two(origin, mesh_families::any_vertex(random, mesh));
  });
  family("rays_far", "at edges, from far away", [&](Random& random) {
    const Point target = mesh_families::on_edge(random, mesh);
    const Point origin{random.magnitude(10, 19), random.magnitude(10, 19),
                       random.magnitude(10, 19)};
    return Two(origin, target);
  });
}

template <class Draw>
Points points_of(const Scene& scene, std::string name, std::string title, std::size_t count,
                 std::uint64_t seed, const Draw& draw) {
  Random random(seed);
  Points points{std::move(name), std::move(title), {}, {}, {}};
  while (points.in_double.size() < count) {
    const contact::Vector3<float> p = mesh_families::in_float(draw(random));
    points.in_double.push_back(p.cast<double>());
    points.plain.push_back(numbers(p));
    points.right.push_back(mesh_truth::where(points.in_double.back(), scene.body.in_double));
  }
  return points;
}

/// The same for points.
template <class Call>
void each_family_of_points(const Scene& scene, std::size_t count, const Call& call) {
  const Body& body = scene.body;
  const Mesh<double>& mesh = body.in_double;
  std::uint64_t seed = 100;
  const auto family = [&](const char* name, const char* title, auto draw) {
    call(points_of(scene, name, title, count, ++seed, draw));
  };
  family("points_random", "random",
         [&](Random& random) { return mesh_families::near_body(random, body, 1); });
  // On a line through the target along x, y or z.
  const auto level = [&](Random& random, const Point& target) {
    Point p = target;
    const int axis = random.integer(0, 2);
    p(axis) = mesh_families::near_body(random, body, 1)(axis);
    return p;
  };
  family("points_level", "level with a vertex", [&](Random& random) {
    const Point target = mesh_families::any_vertex(random, mesh);
    return level(random, target);
  });
  family("points_under", "under an edge", [&](Random& random) {
    const Point target = mesh_families::on_edge(random, mesh);
    return level(random, target);
  });
  const auto on_surface = [&](Random& random) {
    switch (random.integer(0, 2)) {
      case 0:
        return mesh_families::any_vertex(random, mesh);
      case 1:
        return mesh_families::on_edge(random, mesh);
      default:
        return mesh_families::on_face(random, mesh);
    }
  };
  family("points_on", "on the surface, rounded", on_surface);
  family("points_near", "one float from that", [&](Random& random) {
    Point p = on_surface(random);
    const int axis = random.integer(0, 2);
    p(axis) = double(mesh_families::beside(random, static_cast<float>(p(axis))));
    return p;
  });
}

// Files for other programs: numbers as they are in memory, one after the other.

/// Writes FOLDER/SCENE: vertices.f32, triangles.i32, for each family NAME its NAME.f32 (rays:
/// origins and directions in turn) and NAME.right.i32 (of each ray the first triangle, or −1), and
/// families.tsv with names and titles.
inline bool write(const std::filesystem::path& folder, std::size_t count) {
  for (const Scene& scene : scenes()) {
    const std::filesystem::path to = folder / scene.name;
    std::filesystem::create_directories(to);
    write_numbers(to / "vertices.f32", scene.plain.vertices);
    write_numbers(to / "triangles.i32", scene.plain.triangles);
    std::ofstream list(to / "families.tsv");
    each_family_of_rays(scene, count, [&](const Rays& rays) {
      std::vector<peers::Floats> both;
      std::vector<int> right;
      for (std::size_t i = 0; i < rays.right.size(); ++i) {
        both.push_back(rays.plain.origins[i]);
        both.push_back(rays.plain.directions[i]);
        right.push_back(rays.right[i].triangle);
      }
      write_numbers(to / (rays.name + ".f32"), both);
      write_numbers(to / (rays.name + ".right.i32"), right);
      list << rays.name << "\t" << scene.title << ", " << rays.title << "\n";
    });
    each_family_of_points(scene, count, [&](const Points& points) {
      write_numbers(to / (points.name + ".f32"), points.plain);
      write_numbers(to / (points.name + ".right.i32"), points.right);
      list << points.name << "\t" << scene.title << ", " << points.title << "\n";
    });
    if (!list.flush()) return false;
  }
  return true;
}

inline Scene read_scene(const std::filesystem::path& folder) {
  Mesh<double> mesh;
  for (const peers::Floats& v : read_numbers<peers::Floats>(folder / "vertices.f32")) {
    mesh.vertices.emplace_back(v[0], v[1], v[2]);
  }
  mesh.triangles = read_numbers<std::array<int, 3>>(folder / "triangles.i32");
  return scene_of(folder.filename().string(), "", mesh);
}
inline std::vector<contact::Ray<double>> read_rays(const std::filesystem::path& folder,
                                                   const std::string& family) {
  std::vector<contact::Ray<double>> rays;
  for (const auto& r : read_numbers<std::array<float, 6>>(folder / (family + ".f32"))) {
    rays.push_back({Point(r[0], r[1], r[2]), Point(r[3], r[4], r[5])});
  }
  return rays;
}
inline std::vector<Point> read_points(const std::filesystem::path& folder,
                                      const std::string& family) {
  std::vector<Point> points;
  for (const peers::Floats& p : read_numbers<peers::Floats>(folder / (family + ".f32"))) {
    points.emplace_back(p[0], p[1], p[2]);
  }
  return points;
}

}  // namespace questions
