// Two triangles in space: the line of both planes and what each triangle has on it, what the
// lecture's steps and other methods answer, and what they answer if the first triangle is moved by
// a few ulps.
#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <contact/figure.hpp>
#include <contact/orientation.hpp>
#include <contact/pair_methods.hpp>
#include <contact/pair_orientations.hpp>
#include <contact/triangle_intersection.hpp>
#include <contact/triangles_meet.hpp>
#include <limits>

using Vector = contact::Vector3<double>;
using Signs = std::array<int, 3>;

struct Input {
  Vector u0, u1, u2;  // T1, m
  Vector v0, v1, v2;  // T2, m
  double single;      // 1: coordinates are stored and methods compute in float
  double divided;     // 10 or 1,000: all coordinates are divided by it before they are stored
};

constexpr int methods = 6;  // steps, intervals, edges, axes, orientations, exact
constexpr int max_ulps = 12;
constexpr std::size_t shifts = 2 * max_ulps + 1;

struct Output {
  double problem;
  Vector d_of_u, d_of_v;  // of the vertices of each triangle in the plane of the other, rounded
  Vector side_of_u, side_of_v;  // their exact signs
  // What each triangle has on the line of both planes: 0, 1 or 2 ends.
  double ends_of_u, ends_of_v;
  std::array<Vector, 2> on_line_u, on_line_v;
  double crossing_planes;  // 1 if both triangles have areas and are not in parallel planes
  Vector line_at, line_along;
  double decided_in;                 // the lecture's step that decides; 0 if all d are zero
  std::array<double, methods> says;  // 1: meet
  std::array<double, methods> wrong;
  double common;  // 0 nothing, 1 a point, 2 a segment, 3 an area
  double points;
  std::array<Vector, 6> point;
  // With T1 moved along y by -12 to 12 ulps: what each method says, and whether it is wrong.
  std::array<std::array<double, shifts>, methods> moved_says, moved_wrong;
  std::array<double, methods> moved_wrong_in_all;
  double steps_wrong;  // for a question
  // For readers' functions that take whole numbers: everything in eighths of a metre.
  double meet;
  double steps_clear;  // 1 if all are whole, and the triangles have areas and two planes
  double plane_clear;  // 1 if all are whole, and the triangles have areas and one plane
  double edges_touch;  // 1 if u0 u1 and v0 v1 meet and are not parallel
  double edges_clear;  // 1 if all are whole, and v2 is not in the plane of the two edges
  double edges_touch_clear;
  Vector edges_at, edges_normal;
};

namespace {

using Said = std::array<bool, methods>;

template <class S>
contact::Triangle<double> in_double(const contact::Triangle<S>& t) {
  return {t.a.template cast<double>(), t.b.template cast<double>(), t.c.template cast<double>()};
}

template <class S>
Said ask_all(const contact::Triangle<S>& t1, const contact::Triangle<S>& t2) {
  return {contact::meet_by_steps(t1, t2).meet,   contact::meet_by_intervals(t1, t2, S(1e-6)),
          contact::meet_by_edges(t1, t2),        contact::meet_by_axes(t1, t2),
          contact::meet_by_orientations(t1, t2), contact::triangles_meet(t1, t2)};
}

std::array<Vector, 3> vertices(const contact::Triangle<double>& t) { return {t.a, t.b, t.c}; }

/// On which side of the plane of `plane` each vertex of `of` is.
Signs sides(const contact::Triangle<double>& of, const contact::Triangle<double>& plane) {
  Signs result;
  const std::array<Vector, 3> v = vertices(of);
  for (std::size_t i = 0; i < 3; ++i)
    result[i] = contact::orient_3d(plane.a, plane.b, plane.c, v[i]);
  return result;
}

/// Step 3: where the border of `of` is in the plane of `plane`. Returns how many points.
double ends_on_line(const contact::Triangle<double>& of, const contact::Triangle<double>& plane,
                    const Signs& side, std::array<Vector, 2>& ends) {
  if (side == Signs{}) return 0;
  const Vector n = (plane.b - plane.a).cross(plane.c - plane.a);
  const std::array<Vector, 3> v = vertices(of);
  std::size_t count = 0;
  for (std::size_t i = 0; i < 3 && count < 2; ++i) {
    if (side[i] == 0) ends[count++] = v[i];
  }
  for (std::size_t i = 0; i < 3 && count < 2; ++i) {
    const std::size_t j = (i + 1) % 3;
    if (side[i] * side[j] >= 0) continue;
    const double di = n.dot(v[i] - plane.a), dj = n.dot(v[j] - plane.a);
    ends[count++] = v[i] + std::clamp(di / (di - dj), 0.0, 1.0) * (v[j] - v[i]);
  }
  return double(count);
}

/// The line of both planes, for drawing: the point of it that is nearest to T2's first vertex.
void find_line(const contact::Triangle<double>& t1, const contact::Triangle<double>& t2,
               Output& out) {
  const Vector n1 = (t1.b - t1.a).cross(t1.c - t1.a), n2 = (t2.b - t2.a).cross(t2.c - t2.a);
  const Vector along = n1.cross(n2);
  const double square = along.squaredNorm();
  if (!(square > 1e-12 * n1.squaredNorm() * n2.squaredNorm())) return;
  out.crossing_planes = 1;
  out.line_along = along / std::sqrt(square);
  out.line_at = t2.a + n1.dot(t1.a - t2.a) / square * n2.cross(along);
}

/// The distance of neighbouring numbers of S at the largest coordinate.
template <class S>
S ulp(const contact::Triangle<S>& t1, const contact::Triangle<S>& t2) {
  S largest = std::numeric_limits<S>::min();
  for (const auto* v : {&t1.a, &t1.b, &t1.c, &t2.a, &t2.b, &t2.c})
    largest = std::max(largest, v->cwiseAbs().maxCoeff());
  return std::ldexp(S(1), std::ilogb(largest)) * std::numeric_limits<S>::epsilon();
}

template <class S>
void ask_near(const contact::Triangle<S>& t1, const contact::Triangle<S>& t2, Output& out) {
  const S step = ulp(t1, t2);
  for (std::size_t k = 0; k < shifts; ++k) {
    const contact::Vector3<S> by(0, S(static_cast<int>(k) - max_ulps) * step, 0);
    const contact::Triangle<S> moved{t1.a + by, t1.b + by, t1.c + by};
    const Said said = ask_all<S>(moved, t2);
    for (std::size_t m = 0; m < methods; ++m) {
      out.moved_says[m][k] = said[m] ? 1 : 0;
      out.moved_wrong[m][k] = said[m] != said.back() ? 1 : 0;
      out.moved_wrong_in_all[m] += out.moved_wrong[m][k];
    }
  }
}

template <class S>
void compute_in(const Input& in, double divided, Output& out) {
  const auto stored = [divided](const Vector& v) -> contact::Vector3<S> {
    return (v / divided).template cast<S>();
  };
  const contact::Triangle<S> t1{stored(in.u0), stored(in.u1), stored(in.u2)};
  const contact::Triangle<S> t2{stored(in.v0), stored(in.v1), stored(in.v2)};
  const contact::Triangle<double> t1_exactly = in_double(t1), t2_exactly = in_double(t2);

  const auto steps = contact::meet_by_steps(t1, t2);
  out.decided_in = steps.coplanar ? 0 : steps.decided_in;
  const Said said = ask_all<S>(t1, t2);
  for (std::size_t m = 0; m < methods; ++m) {
    out.says[m] = said[m] ? 1 : 0;
    out.wrong[m] = said[m] != said.back() ? 1 : 0;
  }
  ask_near(t1, t2, out);

  const Signs of_u = sides(t1_exactly, t2_exactly), of_v = sides(t2_exactly, t1_exactly);
  const contact::Vector3<S> n1 = (t1.b - t1.a).cross(t1.c - t1.a);
  const contact::Vector3<S> n2 = (t2.b - t2.a).cross(t2.c - t2.a);
  const S d1 = -n1.dot(t1.a), d2 = -n2.dot(t2.a);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    out.side_of_u[k] = of_u[i];
    out.side_of_v[k] = of_v[i];
    out.d_of_u[k] = double(n2.dot(std::array{t1.a, t1.b, t1.c}[i]) + d2);
    out.d_of_v[k] = double(n1.dot(std::array{t2.a, t2.b, t2.c}[i]) + d1);
  }

  // What is drawn, in the coordinates as they are given.
  const contact::Triangle<double> drawn1{in.u0, in.u1, in.u2}, drawn2{in.v0, in.v1, in.v2};
  out.ends_of_u = ends_on_line(drawn1, drawn2, of_u, out.on_line_u);
  out.ends_of_v = ends_on_line(drawn2, drawn1, of_v, out.on_line_v);
  find_line(drawn1, drawn2, out);
  const auto common = contact::intersect_triangles(t1, t2);
  out.common = double(static_cast<int>(common.kind));
  out.points = common.count;
  for (std::size_t i = 0; i < std::size_t(common.count); ++i)
    out.point[i] = divided * common.points[i].position.template cast<double>();
}

bool is_whole(const Vector& eighths) {
  return eighths == eighths.array().round().matrix() && eighths.cwiseAbs().maxCoeff() <= 30;
}

/// The contact of the edges u0 u1 of A and v0 v1 of B, for whole numbers without rounding but for
/// the quotients.
void touch_edges(const contact::Triangle<double>& a, const contact::Triangle<double>& b,
                 Output& out) {
  const Vector e = a.b - a.a, f = b.b - b.a, w = b.a - a.a, n = e.cross(f);
  const double square = n.squaredNorm(), of_e = w.cross(f).dot(n), of_f = w.cross(e).dot(n);
  const double inside = n.dot(b.c - b.a);
  out.edges_clear = e != Vector::Zero() && f != Vector::Zero() && (square == 0 || inside != 0);
  if (square == 0 || n.dot(w) != 0 || std::min(of_e, of_f) < 0 || std::max(of_e, of_f) > square)
    return;
  out.edges_touch = 1;
  out.edges_touch_clear = out.edges_clear;
  out.edges_at = a.a + of_e / square * e;
  out.edges_normal = (inside > 0 ? -1 : 1) / std::sqrt(square) * n;
}

/// What readers' functions are compared with, if all is in whole eighths.
void compute_whole(const Input& in, Output& out) {
  const contact::Triangle<double> a{8 * in.u0, 8 * in.u1, 8 * in.u2};
  const contact::Triangle<double> b{8 * in.v0, 8 * in.v1, 8 * in.v2};
  for (const auto* v : {&a.a, &a.b, &a.c, &b.a, &b.b, &b.c}) {
    if (!is_whole(*v)) return;
  }
  const bool have_areas = (a.b - a.a).cross(a.c - a.a) != Vector::Zero() &&
                          (b.b - b.a).cross(b.c - b.a) != Vector::Zero();
  const bool in_one_plane = sides(a, b) == Signs{};
  out.steps_clear = have_areas && !in_one_plane ? 1 : 0;
  out.plane_clear = have_areas && in_one_plane ? 1 : 0;
  touch_edges(a, b, out);
}

}  // namespace

Output compute(const Input& in) {
  Output out{};
  for (const Vector* v : {&in.u0, &in.u1, &in.u2, &in.v0, &in.v1, &in.v2}) {
    if (v->cwiseAbs().maxCoeff() > 1e6) out.problem = contact::figure::too_large;
  }
  if (out.problem != 0) return out;
  const double divided = in.divided == 10 || in.divided == 1000 ? in.divided : 1;
  if (in.single != 0)
    compute_in<float>(in, divided, out);
  else
    compute_in<double>(in, divided, out);
  out.steps_wrong = out.wrong[0];
  out.meet = out.says.back();
  if (divided == 1) compute_whole(in, out);
  return out;
}

FIGURE(Input, FIELDS(u0, u1, u2, v0, v1, v2, single, divided), Output,
       FIELDS(problem, d_of_u, d_of_v, side_of_u, side_of_v, ends_of_u, ends_of_v, on_line_u,
              on_line_v, crossing_planes, line_at, line_along, decided_in, says, wrong, common,
              points, point, moved_says, moved_wrong, moved_wrong_in_all, steps_wrong, meet,
              steps_clear, plane_clear, edges_touch, edges_clear, edges_touch_clear, edges_at,
              edges_normal))
