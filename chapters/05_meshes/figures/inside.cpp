// A point and a concave mesh: where parity, the winding number and the exact method put the point,
// what the ray of the chosen method meets, and at which points of a section it is wrong.
#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <contact/figure.hpp>
#include <contact/mesh_edges.hpp>
#include <contact/mesh_shapes.hpp>
#include <contact/orientation.hpp>
#include <contact/point_in_polyhedron.hpp>
#include <contact/ray_triangle.hpp>
#include <contact/solid_angle.hpp>
#include <numbers>
#include <vector>

using Vector = contact::Vector3<double>;
using contact::Where;

struct Input {
  Vector p;          // the point, m
  Vector direction;  // of the ray by which parity decides
  double method;     // 0 and 1 parity in double and in float, 2 and 3 the winding number, 4 exact
  double divided;    // 10: all coordinates are divided by it before they are stored
};

constexpr int methods = 5;
constexpr std::size_t corners = 11;  // of the profile
constexpr std::size_t vertices = 2 * corners, triangles = 4 * corners - 4, edges = 6 * corners - 6;
// The section at the y of p: points a quarter of a metre apart, in rows an eighth apart.
constexpr int columns = 31, rows = 37;
constexpr double first_x = -3.75, first_z = -2.375;

struct Output {
  double problem;
  std::array<Vector, vertices> vertex;
  std::array<std::array<double, 3>, triangles> triangle;
  std::array<std::array<double, 2>, edges> edge;
  std::array<double, edges> flat;          // 1 for an edge whose two triangles are in one plane
  double where;                            // exactly: 0 outside, 1 on, 2 inside
  std::array<double, methods> says;        // of each method, as `where`
  std::array<double, methods> wrong;       // 1 if it is; of points on the surface only the exact
                                           // method has to say so
  std::array<double, methods> decided_by;  // number of crossings, or winding number
  // What the ray of the chosen method meets: along `direction` for parity, along z for the exact
  // method, which counts +1 where the ray leaves and -1 where it enters.
  double hits;
  std::array<Vector, triangles> at;
  std::array<double, triangles> hit_triangle, step;
  std::array<double, triangles> share;  // of the sphere about p; positive from behind
  std::array<double, std::size_t(columns* rows)> missed;  // 1 where the chosen method is wrong
  double missed_points;
  double parity_wrong;  // goal of a question
  // For a reader's function that takes whole numbers: everything in eighths of a metre.
  std::array<Vector, vertices> eighths;
  double whole;  // 1 if p is in whole eighths, too
};

namespace {

// Two towers, the left one with a roof, a pit and a step between them; x and z.
const contact::Polygon<double> profile{{-3, -2},   {3, -2},    {3, 1},    {1.75, 1},
                                       {1.75, 0},  {0.5, 0},   {0.5, -1}, {-1, -1},
                                       {-1, 0.75}, {-2, 1.75}, {-3, 0.75}};

/// The profile, extruded along y from −1 to 1.
contact::Mesh<double> towers() {
  contact::CoordinateFrame<double> lying;
  lying.axes << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  return contact::transformed(contact::prism_mesh(profile, -1, 1), lying);
}

/// A mesh as stored in S: in S for the methods, in double for the exact one.
template <class S>
struct Stored {
  contact::Mesh<S> rounded;
  contact::Mesh<double> exact;
};

template <class S>
contact::Vector3<S> stored(const Vector& v, double divided) {
  return (v / divided).template cast<S>();
}

template <class S>
Stored<S> stored(const contact::Mesh<double>& mesh, double divided) {
  Stored<S> result{{{}, mesh.triangles}, {{}, mesh.triangles}};
  for (const Vector& v : mesh.vertices) {
    const contact::Vector3<S> rounded = stored<S>(v, divided);
    result.rounded.vertices.push_back(rounded);
    result.exact.vertices.push_back(rounded.template cast<double>());
  }
  return result;
}

template <class S>
Where locate(const Stored<S>& mesh, const contact::Vector3<S>& p) {
  return contact::locate_in_mesh(Vector(p.template cast<double>()), mesh.exact).where;
}

/// One of the summands of `contact::winding_by_solid_angles`.
template <class S>
double solid_angle(const contact::Vector3<S>& p, const contact::Triangle<S>& t) {
  return contact::solid_angle_detail::solid_angle<S>(t.a - p, t.b - p, t.c - p).value;
}

struct Answer {
  Where where;
  double decided_by;
};

template <class S>
Answer ask(bool parity, const contact::Vector3<S>& p, const contact::Vector3<S>& direction,
           const contact::Mesh<S>& mesh) {
  if (parity) {
    const int count = contact::crossings_by_triangles<S>(p, mesh, direction);
    return {count % 2 != 0 ? Where::inside : Where::outside, double(count)};
  }
  const double w = contact::winding_by_solid_angles<S>(p, mesh).winding;
  return {std::abs(w) > 0.5 ? Where::inside : Where::outside, w};
}

bool is_wrong(Where said, Where truth) { return truth != Where::on && said != truth; }

/// The two methods in S, and for the chosen one the section and what is drawn of it.
template <class S>
void compute_in(const Input& in, int method, const contact::Mesh<double>& mesh, Output& out) {
  const double divided = in.divided == 10 ? 10 : 1;
  const Stored<S> in_s = stored<S>(mesh, divided);
  const contact::Vector3<S> p = stored<S>(in.p, divided);
  const contact::Vector3<S> direction = stored<S>(in.direction, divided);
  const Where truth = locate(in_s, p);
  constexpr std::size_t first = std::same_as<S, float> ? 1 : 0;
  for (const std::size_t m : {first, first + 2}) {
    const Answer answer = ask<S>(m < 2, p, direction, in_s.rounded);
    out.says[m] = double(static_cast<int>(answer.where));
    out.decided_by[m] = answer.decided_by;
    out.wrong[m] = is_wrong(answer.where, truth) ? 1 : 0;
  }
  if (method == 4 || static_cast<std::size_t>(method % 2) != first) return;

  struct Hit {
    double t;
    std::size_t triangle;
  };
  std::vector<Hit> hits;
  for (std::size_t i = 0; i < triangles; ++i) {
    const auto triangle = contact::triangle_of(in_s.rounded, i);
    if (method >= 2)
      out.share[i] = solid_angle<S>(p, triangle) / (4 * std::numbers::pi);
    else if (const auto hit =
                 contact::intersect_moller_trumbore(contact::Ray<S>{p, direction}, triangle))
      hits.push_back({double(hit->t), i});
  }
  std::stable_sort(hits.begin(), hits.end(), [](const Hit& x, const Hit& y) { return x.t < y.t; });
  for (const Hit& hit : hits) {
    const auto k = static_cast<std::size_t>(out.hits);
    ++out.hits;
    out.hit_triangle[k] = double(hit.triangle);
    out.at[k] = in.p + hit.t * in.direction;
  }

  for (int cell = 0; cell < columns * rows; ++cell) {
    const Vector at(first_x + 0.25 * (cell % columns), in.p.y(),
                    first_z + 0.125 * (cell / columns));
    const contact::Vector3<S> q = stored<S>(at, divided);
    const Where said = ask<S>(method < 2, q, direction, in_s.rounded).where;
    out.missed[static_cast<std::size_t>(cell)] = is_wrong(said, locate(in_s, q)) ? 1 : 0;
    out.missed_points += out.missed[static_cast<std::size_t>(cell)];
  }
}

/// The exact method: its ray goes along +z.
void compute_exactly(const Input& in, int method, const contact::Mesh<double>& mesh, Output& out) {
  const double divided = in.divided == 10 ? 10 : 1;
  const contact::Mesh<double> exact = stored<double>(mesh, divided).exact;
  const Vector p = stored<double>(in.p, divided);
  const contact::MeshLocation location = contact::locate_in_mesh(p, exact);
  out.where = out.says[4] = double(static_cast<int>(location.where));
  out.decided_by[4] = location.winding;
  if (method != 4) return;
  struct Crossing {
    double t;
    std::size_t triangle;
    int step;
  };
  std::vector<Crossing> found;
  for (std::size_t i = 0; i < triangles; ++i) {
    const contact::Triangle<double> triangle = contact::triangle_of(exact, i);
    const int step = contact::mesh_location_detail::crossing(p, triangle).step;
    if (step == 0) continue;
    const auto hit = contact::intersect_exact(contact::Ray<double>{p, Vector(0, 0, 1)}, triangle);
    if (hit) found.push_back({hit->t * divided, i, step});
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Crossing& x, const Crossing& y) { return x.t < y.t; });
  for (const Crossing& crossing : found) {
    const auto k = static_cast<std::size_t>(out.hits);
    ++out.hits;
    out.hit_triangle[k] = double(crossing.triangle);
    out.step[k] = crossing.step;
    out.at[k] = in.p + Vector(0, 0, crossing.t);
  }
}

void list_edges(const contact::Mesh<double>& mesh, Output& out) {
  const std::vector<contact::MeshEdge> all = contact::mesh_edges(mesh);
  for (std::size_t i = 0; i < std::min(all.size(), edges); ++i) {
    const auto [a, b, c] = contact::triangle_of(mesh, std::size_t(all[i].triangles[0]));
    bool flat = true;
    for (const int v : mesh.triangles[std::size_t(all[i].triangles[1])])
      flat = flat && contact::orient_3d(a, b, c, mesh.vertices[std::size_t(v)]) == 0;
    for (std::size_t k = 0; k < 2; ++k) out.edge[i][k] = all[i].vertices[k];
    out.flat[i] = flat ? 1 : 0;
  }
}

}  // namespace

Output compute(const Input& in) {
  Output out{};
  for (const auto* v : {&in.p, &in.direction}) {
    if (v->cwiseAbs().maxCoeff() > 1e6) out.problem = contact::figure::too_large;
  }
  if (!(in.direction.cwiseAbs().maxCoeff() > 1e-6)) out.problem = contact::figure::zero_direction;
  if (out.problem != 0) return out;
  const int method = in.method >= 0 && in.method < methods ? static_cast<int>(in.method) : 0;
  const contact::Mesh<double> mesh = towers();
  std::copy(mesh.vertices.begin(), mesh.vertices.end(), out.vertex.begin());
  for (std::size_t i = 0; i < triangles; ++i) {
    for (std::size_t k = 0; k < 3; ++k) out.triangle[i][k] = mesh.triangles[i][k];
  }
  list_edges(mesh, out);
  compute_in<double>(in, method, mesh, out);
  compute_in<float>(in, method, mesh, out);
  compute_exactly(in, method, mesh, out);
  out.parity_wrong = out.wrong[0];
  std::transform(mesh.vertices.begin(), mesh.vertices.end(), out.eighths.begin(),
                 [](const Vector& v) { return Vector(8 * v); });
  const auto is_whole = [](double x) { return 8 * x == std::round(8 * x) && std::abs(x) <= 125; };
  out.whole = is_whole(in.p.x()) && is_whole(in.p.y()) && is_whole(in.p.z()) ? 1 : 0;
  return out;
}

FIGURE(Input, FIELDS(p, direction, method, divided), Output,
       FIELDS(problem, vertex, triangle, edge, flat, where, says, wrong, decided_by, hits, at,
              hit_triangle, step, share, missed, missed_points, parity_wrong, eighths, whole))
