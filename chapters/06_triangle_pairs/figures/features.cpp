// A tetrahedron that moves down until it touches a body at rest: the features of both that touch,
// and their kinds.
#include <algorithm>
#include <array>
#include <cmath>
#include <contact/feature_contacts.hpp>
#include <contact/figure.hpp>
#include <contact/mesh.hpp>
#include <contact/mesh_features.hpp>
#include <contact/sine_cosine.hpp>
#include <cstddef>
#include <vector>

using Vector = contact::Vector3<double>;
using Mesh = contact::Mesh<double>;
using contact::FeatureKind;
using contact::NamedFeature;

struct Input {
  Vector position;  // of the tetrahedron's reference point at the start, m
  double pose;      // which of its features is at the bottom: 0 a vertex, 1 an edge, 2 a face
  double tilt;      // about y, degrees
  double turn;      // about z, after that
  double resting;   // 0 a box, 1 a roof, 2 a tetrahedron
  double time;      // drawn, from 0 to 1; the tetrahedron stops at the contact
};

constexpr std::size_t max_vertices = 8, max_triangles = 12, max_edges = 12, max_points = 24;
constexpr std::size_t moving = 0, resting = 1;
constexpr double depth = 4;  // by which it would move down until time 1, m

/// Of both bodies, the moving one first.
template <class T, std::size_t n>
using OfBoth = std::array<std::array<T, n>, 2>;

struct Output {
  double problem;
  std::array<double, 2> vertices, triangles, edges;
  std::array<Vector, 4> start;          // vertices of the moving body at the start
  OfBoth<Vector, max_vertices> vertex;  // at the time that is drawn
  OfBoth<std::array<double, 3>, max_triangles> triangle;
  OfBoth<std::array<double, 2>, max_edges> edge;
  double apart;                  // 1 if the bodies are apart at the start
  double touches;                // 1 if they touch until time 1
  double t;                      // of the first contact
  double arrived;                // 1 if the time that is drawn is not before it
  std::array<double, 6> kinds;   // contacts: p2p, p2e, p2f, e2e, e2f, f2f
  double point_face, edge_edge;  // pairs of a vertex and a closed face, and of two closed edges
  // 1 for a feature that touches.
  OfBoth<double, max_vertices> vertex_touches;
  OfBoth<double, max_edges> edge_touches;
  OfBoth<double, max_triangles> face_touches;
  double points;  // of the contacts that are a single point
  std::array<Vector, max_points> point;
  double edge_edge_only;  // for a question
};

namespace {

/// With the wanted feature at the bottom, in z = 0.
std::array<Vector, 4> tetrahedron(double pose) {
  if (pose == 1) return {{{-0.75, 0, 0}, {0.75, 0, 0}, {0, 0.75, 1}, {0, -0.75, 1}}};
  if (pose == 2) return {{{-0.5, 0.75, 0}, {0.875, 0, 0}, {-0.5, -0.75, 0}, {0, 0, 1.125}}};
  return {{{0, 0, 0}, {0.875, 0, 1.125}, {-0.5, 0.75, 1.125}, {-0.5, -0.75, 1.125}}};
}
const std::vector<std::array<int, 3>> faces_of_tetrahedron{
    {0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};

/// Its highest point is at most at z = 0.25. Written out, because contact/mesh_shapes.hpp would
/// double what the page loads.
Mesh body_at_rest(double number) {
  if (number == 1) {
    return {
        {{-0.875, -1, -0.75},
         {0.875, -1, -0.75},
         {0.875, 1, -0.75},
         {-0.875, 1, -0.75},
         {0, -1, 0.25},
         {0, 1, 0.25}},
        {{0, 2, 1}, {0, 3, 2}, {0, 1, 4}, {2, 3, 5}, {1, 2, 5}, {1, 5, 4}, {3, 0, 4}, {3, 4, 5}}};
  }
  if (number == 2) {
    return {{{0, 0, 0.25}, {1, 0, -0.75}, {-0.5, 1, -0.75}, {-0.5, -1, -0.75}},
            faces_of_tetrahedron};
  }
  Mesh box;
  for (int i = 0; i < 8; ++i)
    box.vertices.push_back({i & 1 ? 1.0 : -1.0, i & 2 ? 0.75 : -0.75, i & 4 ? 0.0 : -0.75});
  for (const auto& [a, b, c, d] :
       {std::array{0, 2, 3, 1}, std::array{4, 5, 7, 6}, std::array{0, 1, 5, 4},
        std::array{2, 6, 7, 3}, std::array{0, 4, 6, 2}, std::array{1, 3, 7, 5}}) {
    box.triangles.push_back({a, b, c});
    box.triangles.push_back({a, c, d});
  }
  return box;
}

/// To whole 1,024ths, so that all that follows is exact for what is drawn.
double stored(double x) { return std::round(x * 1024) / 1024; }

Mesh moving_body(const Input& in) {
  constexpr double degree = 0.017453292519943295;
  const auto [sin_tilt, cos_tilt] = contact::sine_cosine(in.tilt * degree);
  const auto [sin_turn, cos_turn] = contact::sine_cosine(in.turn * degree);
  Mesh mesh{{}, faces_of_tetrahedron};
  for (const Vector& v : tetrahedron(in.pose)) {
    const double x = cos_tilt * v.x() + sin_tilt * v.z(), z = cos_tilt * v.z() - sin_tilt * v.x();
    const Vector turned(cos_turn * x - sin_turn * v.y(), sin_turn * x + cos_turn * v.y(), z);
    mesh.vertices.push_back((turned + in.position).unaryExpr(&stored));
  }
  return mesh;
}

void list_body(const Mesh& mesh, std::size_t which, Output& out) {
  out.vertices[which] = double(mesh.vertices.size());
  out.triangles[which] = double(mesh.triangles.size());
  std::copy(mesh.vertices.begin(), mesh.vertices.end(), out.vertex[which].begin());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) out.triangle[which][i][k] = mesh.triangles[i][k];
  }
  const contact::FeatureNames names(mesh);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double from = out.triangle[which][i][k], to = out.triangle[which][i][(k + 1) % 3];
      if (from > to || names.is_flat(i, static_cast<int>(k))) continue;
      out.edge[which][static_cast<std::size_t>(out.edges[which])] = {from, to};
      ++out.edges[which];
    }
  }
}

/// Marks what belongs to a feature that touches.
void mark(const NamedFeature& feature, const Mesh& mesh, std::size_t which, Output& out) {
  const auto [first, second, third] = feature.vertices;
  if (feature.kind == FeatureKind::vertex) out.vertex_touches[which][std::size_t(first)] = 1;
  for (std::size_t i = 0; i < std::size_t(out.edges[which]); ++i) {
    if (feature.kind == FeatureKind::edge &&
        out.edge[which][i] == std::array{double(first), double(second)})
      out.edge_touches[which][i] = 1;
  }
  contact::FeatureNames names(mesh);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (names.of(i, {}) == feature) out.face_touches[which][i] = 1;
  }
}

void list_contact(const contact::FirstContact& found, const Mesh& moved, const Mesh& rest,
                  Output& out) {
  out.touches = 1;
  out.t = found.t;
  for (const contact::FeatureContact& contact : found.contacts) {
    const auto kind = static_cast<std::size_t>(contact.kind);
    ++out.kinds[kind];
    mark(contact.of_moving, moved, moving, out);
    mark(contact.of_resting, rest, resting, out);
    const auto k = static_cast<std::size_t>(out.points);
    if (contact.kind > contact::ContactKind::edge_edge || k == max_points) continue;
    out.point[k] = contact.position;
    ++out.points;
  }
  for (const contact::FeatureContact& pair : found.realised_by)
    ++(pair.kind == contact::ContactKind::edge_edge ? out.edge_edge : out.point_face);
}

}  // namespace

Output compute(const Input& in) {
  Output out{};
  if (in.position.cwiseAbs().maxCoeff() > 1e3 || std::abs(in.tilt) > 1e4 || std::abs(in.turn) > 1e4)
    out.problem = contact::figure::too_large;
  if (out.problem != 0) return out;
  const Mesh rest = body_at_rest(in.resting);
  Mesh moved = moving_body(in);
  std::copy(moved.vertices.begin(), moved.vertices.end(), out.start.begin());
  const Vector displacement(0, 0, -depth);
  list_body(rest, resting, out);
  list_body(moved, moving, out);

  const auto found = contact::first_contact(moved, displacement, rest);
  out.apart = found && !found->apart_at_start ? 0 : 1;
  double time = std::clamp(in.time, 0.0, 1.0);
  if (found) {
    list_contact(*found, moved, rest, out);
    out.arrived = time >= found->t ? 1 : 0;
    time = std::min(time, found->t);
    const bool single = found->contacts.size() == 1 && found->apart_at_start;
    out.edge_edge_only = single ? out.kinds[3] : 0;
  }
  for (std::size_t i = 0; i < out.start.size(); ++i)
    out.vertex[moving][i] = out.start[i] + time * displacement;
  return out;
}

FIGURE(Input, FIELDS(position, pose, tilt, turn, resting, time), Output,
       FIELDS(problem, vertices, triangles, edges, start, vertex, triangle, edge, apart, touches, t,
              arrived, kinds, point_face, edge_edge, vertex_touches, edge_touches, face_touches,
              points, point, edge_edge_only))
