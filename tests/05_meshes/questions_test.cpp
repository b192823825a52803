#include "support/questions.hpp"

#define CONTACT_FIGURE_NO_MAIN
#include <algorithm>
#include <array>
#include <cmath>
#include <contact/convex_pieces.hpp>
#include <contact/exact_ray_triangle.hpp>
#include <contact/figure.hpp>
#include <contact/locate_in_mesh.hpp>
#include <contact/mesh_check.hpp>
#include <contact/mesh_hits.hpp>
#include <contact/mesh_shapes.hpp>
#include <contact/moving_mesh.hpp>
#include <contact/point_in_polyhedron.hpp>
#include <contact/polyhedra_meet.hpp>
#include <contact/triangulate.hpp>
#include <numbers>

namespace inside_figure {
#include "figures/inside.cpp"
}

namespace questions_test {

namespace {

using contact::Mesh;
using contact::Ray;
using contact::Segment;
using contact::Vector2;
using contact::Vector3;
using contact::Where;

Vector3<double> at(double x, double y, double z) { return {x, y, z}; }

/// How many triangles a line meets, touching included, decided exactly.
template <class Line>
int triangles_met(const Line& line, const Mesh<double>& mesh) {
  int count = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (contact::intersect_exact(line, contact::triangle_of(mesh, i))) ++count;
  }
  return count;
}

/// A pose for column vectors: rotated about z, and shifted.
contact::Matrix4<double> matrix(double angle, const Vector3<double>& origin) {
  const double c = std::cos(angle), s = std::sin(angle);
  contact::CoordinateFrame<double> frame;
  frame.origin = origin;
  frame.axes << c, -s, 0, s, c, 0, 0, 0, 1;
  return contact::homogeneous_matrix(frame);
}

}  // namespace

KEY("triangles-of-a-closed-mesh") {
  const Mesh<double> icosahedron = contact::ball_mesh(1.0, 0);
  const auto report = contact::check_mesh(icosahedron);
  CHECK(icosahedron.vertices.size() == 12);
  CHECK(report.ok());
  CHECK(report.euler_characteristic == 2);
  return static_cast<double>(icosahedron.triangles.size());
}

KEY("which-fault") {
  Mesh<double> mesh;
  mesh.vertices = {at(0, 0, 0), at(1, 0, 0), at(0, 1, 0), at(0, 0, 1)};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  CHECK(contact::check_mesh(mesh).ok());
  mesh.triangles.back() = {0, 2, 3};
  const auto report = contact::check_mesh(mesh);
  return !report.closed ? 0 : !report.oriented ? 1 : !report.manifold ? 2 : 3;
}

KEY("hits-at-a-vertex") {
  Mesh<double> mesh;
  mesh.vertices = {at(2, 0, 0),   at(1, 2, 0),  at(-1, 2, 0), at(-2, 0, 0),
                   at(-1, -2, 0), at(1, -2, 0), at(0, 0, 1),  at(0, 0, -1)};
  for (int i = 0; i < 6; ++i) {
    mesh.triangles.push_back({i, (i + 1) % 6, 6});
    mesh.triangles.push_back({(i + 1) % 6, i, 7});
  }
  CHECK(contact::check_mesh(mesh).ok());
  const Segment<double> entering{at(0, 0, 3), at(0, 0, 0)};
  CHECK(contact::locate_in_mesh(entering.end, mesh).where == Where::inside);
  CHECK(contact::all_mesh_hits(entering, mesh).size() == 1);
  return static_cast<double>(triangles_met(entering, mesh));
}

KEY("order-of-the-search") {
  return questions::only_order({{"nearer searched", {"skipped"}},
                                {"skipped", {"entries"}},
                                {"entries", {}},
                                {"other searched", {"nearer searched"}}});
}

KEY("start-carried-along") {
  const auto before = matrix(0, at(0, 0, 0)), after = matrix(0, at(2, 0, 0));
  return contact::carried_column(contact::delta_matrix(before, after), at(3, 0, 0)).x();
}

KEY("rows-or-columns") {
  // How far the wrong product carries a point from where it belongs.
  const auto off = [](const contact::Matrix4<double>& before,
                      const contact::Matrix4<double>& after) {
    const contact::Matrix4<double> wrong = contact::inverse_of_frame_matrix(before) * after;
    const Vector3<double> a = at(1, 2, 3);
    const Vector3<double> right = contact::carried_column(contact::delta_matrix(before, after), a);
    return (right - contact::carried_column(wrong, a)).norm();
  };
  const bool shifts = off(matrix(0, at(1, 2, 3)), matrix(0, at(4, 0, 1))) == 0;
  const bool turns = off(matrix(0, at(10, 0, 0)), matrix(1, at(10, 0, 0))) < 0.1;
  return shifts && turns ? 2 : shifts ? 0 : turns ? 1 : 3;
}

KEY("chord-of-a-door") {
  const double r = 0.8, angle = std::numbers::pi / 3;
  CHECK(std::abs(angle * angle * r / 8 - 0.110) < 0.0005);
  const auto sagitta = [r](double turn) { return r * (1 - std::cos(turn / 2)); };
  CHECK(std::abs(sagitta(angle / 4) - 0.0068) < 0.00005);
  return sagitta(angle);
}

KEY("on-the-plane") {
  const Mesh<double> cube = contact::box_mesh(at(0, 0, 0), at(1, 1, 1));
  const Where where = contact::in_convex(at(3, 0.5, 1), cube);
  return where == Where::inside ? 0 : where == Where::on ? 1 : 2;
}

KEY("parity-through-a-vertex") {
  const Mesh<double> octahedron = contact::octahedron_mesh(1.0);
  CHECK(octahedron.triangles.size() == 8);
  CHECK(contact::locate_in_mesh(at(0, 0, 0), octahedron).where == Where::inside);
  return static_cast<double>(triangles_met(Ray<double>{at(0, 0, 0), at(1, 0, 0)}, octahedron));
}

KEY("each-edge-once") {
  Mesh<double> roof;
  roof.vertices = {at(0, -1, 0), at(4, -1, 0), at(4, 1, 0), at(0, 1, 0), at(0, 0, 1), at(4, 0, 1)};
  roof.triangles = {{0, 2, 1}, {0, 3, 2}, {0, 1, 5}, {0, 5, 4},
                    {2, 3, 4}, {2, 4, 5}, {1, 2, 5}, {3, 0, 4}};
  CHECK(contact::check_mesh(roof).ok());
  const Ray<double> above{at(2, -3, 1), at(0, 1, 0)};
  CHECK(contact::locate_in_mesh(above.origin, roof).where == Where::outside);
  CHECK(triangles_met(above, roof) == 2);
  const std::size_t once = contact::all_mesh_hits(above, roof).size();
  return once % 2 == 1 ? 0 : once == 2 ? 1 : 2;
}

KEY("two-shells") {
  const Mesh<double> boxes = contact::joined(contact::box_mesh(at(0, 0, 0), at(2, 2, 2)),
                                             contact::box_mesh(at(1, 1, 1), at(3, 3, 3)));
  const Vector3<double> point = at(1.5, 1.25, 1.75);
  const bool odd = triangles_met(Ray<double>{point, at(1, 0.125, 0.25)}, boxes) % 2 == 1;
  const int winding = contact::locate_in_mesh(point, boxes).winding;
  if (odd) return winding == 1 ? 0 : 2;
  return winding == 2 ? 1 : 3;
}

KEY("parity-wrong") {
  inside_figure::Input in{};
  in.direction = at(1, 0, 0);
  in.divided = 1;
  in.p = at(2, 0, -0.5);  // the ray leaves through the diagonal of a face
  const double winning = inside_figure::compute(in).parity_wrong;
  in.p = at(2, 0, -0.25);
  return questions::Construct{winning, inside_figure::compute(in).parity_wrong};
}

KEY("crossed-bars") {
  const auto box = [](double x, double y, double z) {
    return contact::box_mesh(at(-x, -y, -z), at(x, y, z));
  };
  const std::array pairs{
      std::array{box(1, 1, 1), box(4, 4, 4)}, std::array{box(4, 1, 1), box(1, 4, 0.5)},
      std::array{box(1, 1, 1), contact::box_mesh(at(0.5, 0.5, 0.5), at(3, 3, 3))}};
  int missed = -1;
  for (int i = 0; i < 3; ++i) {
    const auto& [a, b] = pairs.at(static_cast<std::size_t>(i));
    CHECK(contact::polyhedra_meet(a, b).meet);
    if (contact::polyhedra_meet(a, b, contact::PolyhedraOrder::vertices).meet) continue;
    CHECK(missed < 0);
    missed = i;
  }
  return missed;
}

KEY("edges-find-all") {
  // Bodies whose surfaces do not meet: are all vertices of the first on one side of the second?
  const Mesh<double> large = contact::box_mesh(at(-4, -4, -4), at(4, 4, 4));
  const auto agree = [&large](const Mesh<double>& a) {
    const auto first = contact::locate_in_mesh(a.vertices.front(), large).where;
    return std::all_of(a.vertices.begin(), a.vertices.end(), [&](const Vector3<double>& v) {
      return contact::locate_in_mesh(v, large).where == first;
    });
  };
  const Mesh<double> within = contact::ball_mesh(2.0, 2);
  const Mesh<double> across = contact::box_mesh(at(1, 1, 1), at(9, 9, 9));
  CHECK_FALSE(contact::edges_meet_faces(within, large));
  CHECK(contact::edges_meet_faces(across, large));
  return questions::Claim{agree(within), agree(across)};
}

KEY("triangles-with-a-hole") {
  contact::PolygonWithHoles<double> ring;
  ring.outer = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  ring.holes = {{{1, 1}, {3, 1}, {3, 3}, {1, 3}}};
  return static_cast<double>(contact::triangulate(ring).size());
}

KEY("notches-of-a-tray") {
  // The walls and the floor as a prism with a hole on a box, without the common face.
  contact::PolygonWithHoles<double> ring;
  ring.outer = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  ring.holes = {{{1, 1}, {3, 1}, {3, 3}, {1, 3}}};
  Mesh<double> tray;
  for (const double z : {0.0, 1.0, 3.0}) {
    for (const auto& p : ring.outer) tray.vertices.push_back(at(p.x(), p.y(), z));
    for (const auto& p : ring.holes.front()) tray.vertices.push_back(at(p.x(), p.y(), z));
  }
  const auto quad = [&tray](int a, int b, int c, int d) {
    tray.triangles.push_back({a, b, c});
    tray.triangles.push_back({a, c, d});
  };
  quad(0, 3, 2, 1);      // below
  quad(12, 13, 14, 15);  // the floor of the hollow
  for (int i = 0; i < 4; ++i) {
    const int j = (i + 1) % 4;
    quad(i, j, 16 + j, 16 + i);            // outside
    quad(12 + j, 12 + i, 20 + i, 20 + j);  // inside
    quad(16 + i, 16 + j, 20 + j, 20 + i);  // the rim
  }
  const auto report = contact::check_mesh(tray);
  CHECK(report.closed);
  CHECK(report.oriented);
  CHECK(contact::mesh_volume_exactly(tray) == contact::ExactFraction(40));
  return static_cast<double>(contact::notches(tray).size());
}

}  // namespace questions_test
