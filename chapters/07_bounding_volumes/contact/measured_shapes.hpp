/// @file
/// Five bodies on which bounding volumes are measured: ball, rod, plate, star and an irregular
/// mesh.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <contact/mesh.hpp>
#include <contact/mesh_shapes.hpp>
#include <contact/sine_cosine.hpp>
#include <contact/vector.hpp>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace contact {

/// A body with its name.
struct MeasuredShape {
  const char* name = "";  ///< one word
  Mesh<double> mesh;      ///< m; closed and oriented, one component, without crossings
};

namespace measured_shapes_detail {

/// Coordinates of shapes and entries of frames are multiples of this.
inline constexpr double grid = 0x1p-20;

/// The multiple of 2^-20 that is nearest to x.
inline double on_grid(double x) { return std::floor(x / grid + 0.5) * grid; }

/// Turned so that each axis of a shape makes angles of at least 26° with the axes of the world and
/// the normals of the k-DOPs: by the quaternion (1, −6, −1, −1), whose matrix is whole numbers over
/// 39. Then rounded to the grid.
inline Mesh<double> turned(Mesh<double> mesh) {
  Matrix3<double> whole;
  whole << 35, 14, 10, 10, -35, 14, 14, -10, -35;
  for (Vector3<double>& v : mesh.vertices) {
    const Vector3<double> image = whole * v / 39;
    v = Vector3<double>(on_grid(image.x()), on_grid(image.y()), on_grid(image.z()));
  }
  return mesh;
}

/// A cylinder of 24 sides along z, divided into 10 rings, with a vertex in the middle of each end.
inline Mesh<double> rod(double length, double radius) {
  constexpr int sides = 24, rings = 10;
  Mesh<double> mesh;
  for (int i = 0; i <= rings; ++i) {
    for (int j = 0; j < sides; ++j) {
      const auto around = sine_cosine(6.283185307179586 * j / sides);
      mesh.vertices.push_back(
          {radius * around.cosine, radius * around.sine, length * i / rings - length / 2});
    }
  }
  const int bottom = sides * (rings + 1), top = bottom + 1;
  mesh.vertices.push_back({0, 0, -length / 2});
  mesh.vertices.push_back({0, 0, length / 2});
  for (int j = 0; j < sides; ++j) {
    const int next = (j + 1) % sides;
    for (int i = 0; i < rings; ++i) {
      const int low = i * sides, high = low + sides;
      mesh.triangles.push_back({low + j, low + next, high + next});
      mesh.triangles.push_back({low + j, high + next, high + j});
    }
    mesh.triangles.push_back({next, j, bottom});
    mesh.triangles.push_back({rings * sides + j, rings * sides + next, top});
  }
  return mesh;
}

/// A box with its middle in the origin whose faces are divided into squares: `cells` along x and y,
/// one along z.
inline Mesh<double> plate(double side, double thickness, int cells) {
  Mesh<double> mesh;
  std::map<std::array<int, 3>, int> numbers;
  const auto vertex = [&](int i, int j, int k) {
    const auto [found, is_new] =
        numbers.try_emplace({i, j, k}, static_cast<int>(mesh.vertices.size()));
    if (is_new) {
      mesh.vertices.push_back({side * i / cells - side / 2, side * j / cells - side / 2,
                               thickness * k - thickness / 2});
    }
    return found->second;
  };
  const auto quadrilateral = [&mesh](int a, int b, int c, int d) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  };
  for (int i = 0; i < cells; ++i) {
    for (int j = 0; j < cells; ++j) {
      quadrilateral(vertex(i, j, 1), vertex(i + 1, j, 1), vertex(i + 1, j + 1, 1),
                    vertex(i, j + 1, 1));
      quadrilateral(vertex(i, j, 0), vertex(i, j + 1, 0), vertex(i + 1, j + 1, 0),
                    vertex(i + 1, j, 0));
    }
    quadrilateral(vertex(i, 0, 0), vertex(i + 1, 0, 0), vertex(i + 1, 0, 1), vertex(i, 0, 1));
    quadrilateral(vertex(i + 1, cells, 0), vertex(i, cells, 0), vertex(i, cells, 1),
                  vertex(i + 1, cells, 1));
    quadrilateral(vertex(0, i + 1, 0), vertex(0, i, 0), vertex(0, i, 1), vertex(0, i + 1, 1));
    quadrilateral(vertex(cells, i, 0), vertex(cells, i + 1, 0), vertex(cells, i + 1, 1),
                  vertex(cells, i, 1));
  }
  return mesh;
}

/// A bump of a ball, or a dent: how far it moves the surface in which direction, and the cosine of
/// the angle from there at which it ends.
struct Bump {
  Vector3<double> towards;  ///< need not be a unit vector
  double height;            ///< of the radius; negative: a dent
  double edge;
};

/// A ball with two ears, a nose, a tail and three dents, longer than wide. The origin sees all of
/// it, so it does not cross itself.
inline Mesh<double> animal(double size) {
  const std::array<Bump, 7> bumps{{{{0.5, 0.4, 1}, 1.1, 0.8},
                                   {{0.4, -0.5, 1}, 1.3, 0.82},
                                   {{1, 0.1, 0.3}, 0.6, 0.7},
                                   {{-1, 0.2, 0.2}, 0.9, 0.85},
                                   {{0.2, 1, -0.3}, -0.5, 0.6},
                                   {{-0.3, -1, 0.2}, -0.45, 0.65},
                                   {{-0.2, 0.1, -1}, -0.35, 0.5}}};
  Mesh<double> mesh = ball_mesh(1, 3);
  for (Vector3<double>& v : mesh.vertices) {
    double radius = 1;
    for (const Bump& bump : bumps) {
      const double cosine = v.dot(bump.towards) / std::sqrt(bump.towards.dot(bump.towards));
      const double share = std::max(0.0, (cosine - bump.edge) / (1 - bump.edge));
      radius += bump.height * share * share;
    }
    v = size * radius * Vector3<double>(1.25 * v.x(), 0.9 * v.y(), 0.8 * v.z());
  }
  return mesh;
}

}  // namespace measured_shapes_detail

// [measured-shapes]
/// A ball of radius 5, a rod of length 10 and diameter 1, a plate of 10 × 10 × 0.5, a star with 320
/// spikes between the radii 2.5 and 5, and an irregular body with bumps and dents ("mesh"), each of
/// 500 to 1,300 triangles.
///
/// All are oblique to the axes in the same way. Their coordinates are multiples of 2^-20 below 16,
/// so frames with such entries carry them without rounding (`scattered_bodies`). Made of sums,
/// products, quotients and roots, and so the same on every machine.
inline std::vector<MeasuredShape> measured_shapes() {
  using namespace measured_shapes_detail;
  std::vector<MeasuredShape> shapes;
  shapes.push_back({"ball", turned(ball_mesh(5, 3))});
  shapes.push_back({"rod", turned(rod(10, 0.5))});
  shapes.push_back({"plate", turned(plate(10, 0.5, 12))});
  shapes.push_back({"star", turned(star_mesh(2.5, 5, 2))});
  shapes.push_back({"mesh", turned(animal(2.75))});
  return shapes;
}
// [/measured-shapes]

}  // namespace contact
