// Two meshes, one of which is moved: the pairs of triangles that meet, found by two trees of boxes,
// the curve in which the surfaces meet, and the contacts, each once.
#include <algorithm>
#include <array>
#include <cmath>
#include <contact/figure.hpp>
#include <contact/mesh_contacts.hpp>
#include <contact/mesh_pairs.hpp>
#include <contact/mesh_tree.hpp>
#include <contact/sine_cosine.hpp>
#include <contact/triangle_intersection.hpp>
#include <cstddef>
#include <utility>
#include <vector>

using Vector = contact::Vector3<double>;
using Mesh = contact::Mesh<double>;
using Tree = contact::MeshTree<double>;

struct Input {
  Vector shift;   // of the moving mesh, m
  double meshes;  // 0 tori, 1 crossing boxes, 2 a box on a box, 3 a ball and a star
};

constexpr std::size_t max_vertices = 160, max_triangles = 300, max_segments = 1024,
                      max_contacts = 512;

struct Output {
  double problem;
  // Both meshes: the resting one, and the moving one where it is now.
  std::array<double, 2> triangles;
  std::array<std::array<Vector, max_vertices>, 2> vertex;
  std::array<std::array<std::array<double, 3>, max_triangles>, 2> triangle;
  double pairs;          // each with each
  double boxes, tested;  // by two trees: pairs of boxes, pairs of triangles
  double meet;           // pairs of triangles that meet
  double in_one_plane;   // pairs that have an area in common
  double segments;       // of the curve, and borders of areas; drawn as there is room
  std::array<std::array<Vector, 2>, max_segments> segment;
  double points;    // of all pairs, each pair's counted
  double contacts;  // each once
  std::array<Vector, max_contacts> contact;
  // Contacts by kind: point on point, point on edge, point on face, edge on edge, edge on face,
  // face on face.
  std::array<double, 6> of_kind;
  // For a reader's function that takes whole numbers: the two boxes, in eighths of a metre, the
  // moving one before it is shifted.
  std::array<Vector, 8> resting_box, moving_box;
  std::array<std::array<double, 3>, 12> box_triangle;
  double boxes_clear;  // 1 if these are shown, whole, and not into one another
};

namespace {

// contact/mesh_shapes.hpp has such meshes too, but would add to what the page loads.

/// A cube from -1 to 1 whose faces are divided into n × n squares, of two triangles each.
Mesh divided_cube(int n) {
  Mesh mesh;
  std::vector<int> numbers(static_cast<std::size_t>((n + 1) * (n + 1) * (n + 1)), -1);
  const auto vertex = [&](const std::array<int, 3>& at) {
    int& number = numbers[static_cast<std::size_t>((at[0] * (n + 1) + at[1]) * (n + 1) + at[2])];
    if (number < 0) {
      number = static_cast<int>(mesh.vertices.size());
      mesh.vertices.push_back(Vector(2 * at[0] - n, 2 * at[1] - n, 2 * at[2] - n) / n);
    }
    return number;
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (int cell = 0; cell < 2 * n * n; ++cell) {
      const bool upper = cell >= n * n;
      std::array<int, 4> square{};
      for (int k = 0; k < 4; ++k) {
        std::array<int, 3> at{};
        at[axis] = upper ? n : 0;
        at[u] = cell % n + (k == 1 || k == 2 ? 1 : 0);
        at[v] = cell / n % n + (k >= 2 ? 1 : 0);
        square[static_cast<std::size_t>(upper ? k : 3 - k)] = vertex(at);
      }
      mesh.triangles.push_back({square[0], square[1], square[2]});
      mesh.triangles.push_back({square[0], square[2], square[3]});
    }
  }
  return mesh;
}

/// A torus about z, m times n squares.
Mesh torus(double ring, double tube, int m, int n) {
  constexpr double turn = 6.283185307179586;
  Mesh mesh;
  for (int i = 0; i < m; ++i) {
    for (int j = 0; j < n; ++j) {
      const auto [sin_ring, cos_ring] = contact::sine_cosine(turn * i / m);
      const auto [sin_tube, cos_tube] = contact::sine_cosine(turn * j / n);
      const double from_axis = ring + tube * cos_tube;
      mesh.vertices.push_back({from_axis * cos_ring, from_axis * sin_ring, tube * sin_tube});
      const auto at = [m, n](int k, int l) { return k % m * n + l % n; };
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

template <class Map>
Mesh mapped(Mesh mesh, const Map& map) {
  for (Vector& v : mesh.vertices) v = map(v);
  return mesh;
}

Mesh box(const Vector& half, int n) {
  return mapped(divided_cube(n), [&](const Vector& v) -> Vector { return v.cwiseProduct(half); });
}
/// A turn by a quarter about x.
Mesh standing(Mesh mesh) {
  return mapped(std::move(mesh), [](const Vector& v) { return Vector(v.x(), -v.z(), v.y()); });
}
/// A turn by 45° about z, with x and y shortened by √2, so that nothing is rounded.
Mesh oblique(Mesh mesh) {
  return mapped(std::move(mesh), [](const Vector& v) {
    return Vector((v.x() - v.y()) / 2, (v.x() + v.y()) / 2, v.z());
  });
}
Mesh ball() {
  return mapped(divided_cube(5),
                [](const Vector& v) -> Vector { return v / std::sqrt(v.squaredNorm()); });
}
/// Four spikes on each face of the cube: the vertices with two odd numbers in its lattice.
Mesh star() {
  constexpr int n = 4;
  return mapped(divided_cube(n), [](const Vector& v) -> Vector {
    int odd = 0;
    for (int k = 0; k < 3; ++k) odd += std::lround((v[k] + 1) * n / 2) % 2 == 0 ? 0 : 1;
    return (odd == 2 ? 1.375 : 0.625) / std::sqrt(v.squaredNorm()) * v;
  });
}

struct Scene {
  Tree resting;
  Mesh moving;
};

const Scene& scene(double number) {
  static const std::array<Scene, 4> scenes{
      Scene{Tree(torus(1, 0.375, 14, 7)), standing(torus(1, 0.375, 14, 7))},
      Scene{Tree(box({1, 1, 0.75}, 4)), oblique(box({1.25, 0.75, 0.5}, 4))},
      Scene{Tree(box({1, 1, 0.5}, 1)), oblique(box({1.25, 1.25, 0.375}, 1))},
      Scene{Tree(ball()), star()}};
  return scenes[number >= 1 && number < 4 ? static_cast<std::size_t>(number) : 0];
}

void list_mesh(const Mesh& mesh, std::size_t which, Output& out) {
  std::copy(mesh.vertices.begin(), mesh.vertices.end(), out.vertex[which].begin());
  out.triangles[which] = double(mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) out.triangle[which][i][k] = mesh.triangles[i][k];
  }
}

/// The curve: for each pair a segment, or the border of an area.
void draw_pair(const contact::TriangleIntersection<double>& common, Output& out) {
  out.points += common.count;
  if (common.kind == contact::CommonPoints::area) ++out.in_one_plane;
  const int sides = common.count > 2 ? common.count : common.count - 1;
  for (int i = 0; i < sides; ++i) {
    const auto k = static_cast<std::size_t>(out.segments++);
    if (k >= max_segments) continue;
    out.segment[k] = {common.points[std::size_t(i)].position,
                      common.points[std::size_t((i + 1) % common.count)].position};
  }
}

/// The box on the box, for a reader's function.
void list_boxes(const Scene& boxes, const Vector& shift, Output& out) {
  for (std::size_t i = 0; i < 8; ++i) {
    out.resting_box[i] = 8 * boxes.resting.mesh().vertices[i];
    out.moving_box[i] = 8 * boxes.moving.vertices[i];
  }
  std::copy_n(out.triangle[0].begin(), 12, out.box_triangle.begin());
  const Vector whole = (8 * shift).array().round();
  const bool is_on_top = shift.z() >= 0.875;
  out.boxes_clear = whole == 8 * shift && whole.cwiseAbs().maxCoeff() <= 80 && is_on_top ? 1 : 0;
}

}  // namespace

Output compute(const Input& in) {
  Output out{};
  if (in.shift.cwiseAbs().maxCoeff() > 1e4) out.problem = contact::figure::too_large;
  if (out.problem != 0) return out;
  const Scene& shown = scene(in.meshes);
  const Mesh& resting = shown.resting.mesh();
  const Tree tree(mapped(shown.moving, [&](const Vector& v) -> Vector { return v + in.shift; }));
  const Mesh& moving = tree.mesh();
  list_mesh(resting, 0, out);
  list_mesh(moving, 1, out);

  if (in.meshes == 2) list_boxes(shown, in.shift, out);

  out.pairs = out.triangles[0] * out.triangles[1];
  contact::PairCounts counts;
  const auto meeting = contact::meeting_triangles(shown.resting, tree, &counts);
  out.boxes = double(counts.boxes);
  out.tested = double(counts.triangles);
  out.meet = double(meeting.size());
  for (const auto& [first, second] : meeting) {
    draw_pair(contact::intersect_triangles(
                  contact::triangle_of(resting, static_cast<std::size_t>(first)),
                  contact::triangle_of(moving, static_cast<std::size_t>(second))),
              out);
  }
  for (const auto& contact : contact::mesh_contacts(shown.resting, tree)) {
    const auto k = static_cast<std::size_t>(out.contacts++);
    if (k < max_contacts) out.contact[k] = contact.position;
    ++out.of_kind[static_cast<std::size_t>(contact.kind())];
  }
  return out;
}

FIGURE(Input, FIELDS(shift, meshes), Output,
       FIELDS(problem, triangles, vertex, triangle, pairs, boxes, tested, meet, in_one_plane,
              segments, segment, points, contacts, contact, of_kind, resting_box, moving_box,
              box_triangle, boxes_clear))
