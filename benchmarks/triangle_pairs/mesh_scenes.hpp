/// @file
/// The pairs of meshes of the comparison with other programs, and which of their triangles meet.
/// Each coordinate is a multiple of 2^-20 and a float.
#pragma once

#include <06_triangle_pairs/pair_truth.hpp>
#include <support/generators.hpp>

#include <algorithm>
#include <cmath>
#include <contact/aabb.hpp>
#include <contact/mesh.hpp>
#include <contact/mesh_shapes.hpp>
#include <contact/shapes.hpp>
#include <contact/sine_cosine.hpp>
#include <contact/vector.hpp>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "../number_files.hpp"
#include "peers.hpp"

namespace mesh_scenes {

using contact::Mesh;
using generators::Random;
using Point = contact::Vector3<double>;

/// Two meshes. The right answer is found without a tree and without the chapter's code.
struct Scene {
  std::string name, title;
  Mesh<double> first, second;
  peers::MeshOfNumbers plain_first, plain_second;
  peers::Found right;  ///< sorted
};

inline Mesh<double> on_lattice(Mesh<double> mesh) {
  for (Point& v : mesh.vertices) {
    for (double& x : v) x = std::ldexp(std::round(std::ldexp(x, 20)), -20);
  }
  return mesh;
}
/// Coordinates as whole numbers of 2^-20.
inline Mesh<double> in_steps(Mesh<double> mesh) {
  for (Point& v : mesh.vertices) v *= 0x1p20;
  return mesh;
}
/// Each vertex moved by up to `by` in each coordinate.
inline Mesh<double> rough(Mesh<double> mesh, double by, std::uint64_t seed) {
  Random random(seed);
  for (Point& v : mesh.vertices) {
    v += by * Point{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
  }
  return mesh;
}
/// The y and the z axis exchanged; the triangles reversed, so that their fronts stay outside.
inline Mesh<double> upright(Mesh<double> mesh) {
  for (Point& v : mesh.vertices) std::swap(v.y(), v.z());
  for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  return mesh;
}

/// 50,000 triangles.
inline Mesh<double> torus() { return contact::torus_mesh(1, 0.4, 250, 100); }

/// A ball of circles of latitude: 2·m·(n − 1) triangles, here 50,000.
inline Mesh<double> ball() {
  constexpr int m = 250, n = 101;
  constexpr double half_turn = 3.141592653589793;
  Mesh<double> mesh;
  mesh.vertices = {Point(0, 0, 1), Point(0, 0, -1)};
  const auto vertex = [](int circle, int i) { return 2 + (circle - 1) * m + i % m; };
  for (int circle = 1; circle < n; ++circle) {
    const auto down = contact::sine_cosine(half_turn * circle / n);
    for (int i = 0; i < m; ++i) {
      const auto around = contact::sine_cosine(2 * half_turn * i / m);
      mesh.vertices.push_back({down.sine * around.cosine, down.sine * around.sine, down.cosine});
    }
  }
  for (int i = 0; i < m; ++i) {
    mesh.triangles.push_back({0, vertex(1, i), vertex(1, i + 1)});
    mesh.triangles.push_back({1, vertex(n - 1, i + 1), vertex(n - 1, i)});
    for (int circle = 1; circle + 1 < n; ++circle) {
      const int a = vertex(circle, i), b = vertex(circle + 1, i);
      const int c = vertex(circle + 1, i + 1), d = vertex(circle, i + 1);
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
    }
  }
  return mesh;
}

/// The box from low to low + (n, n, n)·cell with each face divided into n × n squares of two
/// triangles: 12·n² triangles.
inline Mesh<double> divided_box(const Point& low, double cell, int n) {
  Mesh<double> mesh;
  std::map<std::array<int, 3>, int> vertices;
  const auto vertex = [&](const std::array<int, 3>& at) {
    const auto [found, is_new] = vertices.try_emplace(at, static_cast<int>(vertices.size()));
    if (is_new) mesh.vertices.push_back(low + cell * Point(at[0], at[1], at[2]));
    return found->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const int side : {0, n}) {
      for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
          const auto at = [&](int u, int v) {
            std::array<int, 3> p{};
            p[axis] = side;
            p[(axis + 1) % 3] = i + u;
            p[(axis + 2) % 3] = j + v;
            return vertex(p);
          };
          const int a = at(0, 0), c = at(1, 1);
          const int b = side == 0 ? at(0, 1) : at(1, 0), d = side == 0 ? at(1, 0) : at(0, 1);
          mesh.triangles.push_back({a, b, c});
          mesh.triangles.push_back({a, c, d});
        }
      }
    }
  }
  return mesh;
}

// The right answers ---------------------------------------------------------------------------

struct Boxed {
  contact::Aabb<double> box;
  int triangle;
};
inline std::vector<Boxed> by_low_x(const Mesh<double>& mesh) {
  std::vector<Boxed> all;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const contact::Triangle<double> t = contact::triangle_of(mesh, i);
    all.push_back(
        {{t.a.cwiseMin(t.b).cwiseMin(t.c), t.a.cwiseMax(t.b).cwiseMax(t.c)}, static_cast<int>(i)});
  }
  std::sort(all.begin(), all.end(),
            [](const Boxed& x, const Boxed& y) { return x.box.low.x() < y.box.low.x(); });
  return all;
}

/// Calls each(i, j) for the triangles of two meshes whose boxes meet: sorted along x.
template <class Each>
void each_with_boxes_that_meet(const Mesh<double>& first, const Mesh<double>& second,
                               const Each& each) {
  const std::vector<Boxed> a = by_low_x(first), b = by_low_x(second);
  const auto sweep = [](const std::vector<Boxed>& starts, const std::vector<Boxed>& others,
                        bool with_equal, const auto& report) {
    std::size_t from = 0;
    for (const Boxed& start : starts) {
      const double low = start.box.low.x();
      while (from < others.size() &&
             (others[from].box.low.x() < low || (!with_equal && others[from].box.low.x() == low))) {
        ++from;
      }
      for (std::size_t k = from; k < others.size(); ++k) {
        const contact::Aabb<double>& box = others[k].box;
        if (box.low.x() > start.box.high.x()) break;
        if ((box.low.array() <= start.box.high.array()).all() &&
            (box.high.array() >= start.box.low.array()).all()) {
          report(start.triangle, others[k].triangle);
        }
      }
    }
  };
  sweep(a, b, true, [&](int i, int j) { each(i, j); });
  sweep(b, a, false, [&](int j, int i) { each(i, j); });
}

inline peers::MeshOfNumbers plain(const Mesh<double>& mesh) {
  peers::MeshOfNumbers numbers;
  for (const Point& v : mesh.vertices) numbers.vertices.push_back({v.x(), v.y(), v.z()});
  numbers.triangles = mesh.triangles;
  return numbers;
}

inline Scene scene_of(std::string name, std::string title, const Mesh<double>& first,
                      const Mesh<double>& second) {
  Scene scene{std::move(name), std::move(title), on_lattice(first), on_lattice(second), {}, {}, {}};
  scene.plain_first = plain(scene.first);
  scene.plain_second = plain(scene.second);
  const Mesh<double> whole_first = in_steps(scene.first), whole_second = in_steps(scene.second);
  each_with_boxes_that_meet(whole_first, whole_second, [&](int i, int j) {
    if (pair_truth::meet_in_integers(
            contact::triangle_of(whole_first, static_cast<std::size_t>(i)),
            contact::triangle_of(whole_second, static_cast<std::size_t>(j)))) {
      scene.right.emplace_back(i, j);
    }
  });
  std::sort(scene.right.begin(), scene.right.end());
  return scene;
}

/// Calls with each scene, one after the other.
template <class Call>
void each_scene(const Call& call) {
  constexpr double little = 0.002;
  const Mesh<double> ring = rough(torus(), little, 1);
  const Mesh<double> other_ring = rough(upright(torus()), little, 2);
  const Mesh<double> round = rough(ball(), little, 3);
  call(scene_of("tori", "two rough tori that cross", ring,
                contact::translated<double>(other_ring, Point(0.7, 0, 0.1))));
  call(scene_of("balls", "two rough balls that cross", round,
                contact::translated<double>(rough(ball(), little, 4), Point(0.9, 0.3, 0.2))));
  call(scene_of("close", "a rough ball and itself 1 mm beside", round,
                contact::translated<double>(round, Point(0.0007, 0.0005, 0.0005))));
  call(scene_of("boxes", "a box on a box", divided_box(Point(0, 0, 0), 0x1p-6, 64),
                divided_box(Point(0.25, 0.125, 1), 0x1p-6, 64)));
  call(scene_of("linked", "two rough tori that are linked, apart", ring,
                contact::translated<double>(other_ring, Point(1, 0, 0))));
}

// Files for other programs --------------------------------------------------------------------

/// Writes FOLDER/meshes/SCENE: vertices and triangles of both meshes, the pairs that meet, and the
/// title.
inline bool write(const std::filesystem::path& folder) {
  bool written = true;
  each_scene([&](const Scene& scene) {
    const std::filesystem::path to = folder / "meshes" / scene.name;
    std::filesystem::create_directories(to);
    write_numbers(to / "first.f64", scene.plain_first.vertices);
    write_numbers(to / "first.i32", scene.plain_first.triangles);
    write_numbers(to / "second.f64", scene.plain_second.vertices);
    write_numbers(to / "second.i32", scene.plain_second.triangles);
    std::vector<std::array<int, 2>> right;
    for (const auto& [i, j] : scene.right) right.push_back({i, j});
    write_numbers(to / "right.i32", right);
    std::ofstream title(to / "title.txt");
    title << scene.title << "\n";
    written = written && title.flush().good();
  });
  return written;
}

inline Mesh<double> read_mesh(const std::filesystem::path& folder, const std::string& name) {
  Mesh<double> mesh;
  for (const auto& v : read_numbers<peers::Numbers>(folder / (name + ".f64"))) {
    mesh.vertices.emplace_back(v[0], v[1], v[2]);
  }
  mesh.triangles = read_numbers<std::array<int, 3>>(folder / (name + ".i32"));
  return mesh;
}

}  // namespace mesh_scenes
