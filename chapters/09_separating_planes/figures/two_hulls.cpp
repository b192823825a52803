// Two convex polygons in the plane, one of which may be rounded by a radius: how they lie to each
// other, with the proof, and a line of the reader's own that is to separate them.
#include <algorithm>
#include <array>
#include <cmath>
#include <contact/convex_bodies.hpp>
#include <contact/exact.hpp>
#include <contact/figure.hpp>
#include <contact/orientation.hpp>
#include <contact/proximity.hpp>
#include <contact/support.hpp>
#include <cstddef>
#include <utility>
#include <vector>

using Point = contact::Vector2<double>;
using Vector = contact::Vector3<double>;
using Hull = contact::ConvexHull<double>;

struct Input {
  Point a, b;            // positions of the bodies, m
  Point turn_a, turn_b;  // the direction of each body's y axis, of any length
  Point p, q;            // two points of the reader's own line
  double radius;         // of body B beyond its polygon, m
  double shown;          // 1: the proof is drawn
};

constexpr std::size_t of_a = 5, of_b = 4;

struct Output {
  double problem;
  Point a0, a1, a2, a3, a4;  // vertices of A, as seen from a: multiples of 1/64 m
  Point b0, b1, b2, b3;      // those of B, as seen from b
  double state;              // 0 disjoint, 1 touching, 2 overlapping: exact
  double checked;            // 1 if the proof holds, which is checked apart from the search
  double gap;                // of bodies that are disjoint, m
  // The proof of bodies that do not overlap: a line between them, given by its normal from B to A,
  // of length 1; the lines parallel to it on which A and B end; and the points where they do.
  Point normal;
  std::array<Point, 2> between, end_of_a, end_of_b;
  Point support_a, support_b;
  Point common;  // the proof of bodies that meet: close to a common point
  // The reader's line, with A on the side that leaves fewer vertices on the wrong side. A rounded
  // vertex is on the wrong side if part of its disc is.
  double a_on_left;
  double wrong, on_line;                   // vertices on the wrong side, and touched by the line
  std::array<double, of_a> wrong_a, on_a;  // 1 for each of these
  std::array<double, of_b> wrong_b, on_b;
  // For a reader's function that takes whole numbers: 1 if 64 times each vertex is one and no
  // vertex is rounded; 1 if the bodies are disjoint; and 1 if both hold.
  double whole, apart, whole_and_apart;
  // Goals of questions.
  double line_found;       // the reader's line separates bodies that are less than 0.2 m apart
  double weak_line_found;  // they touch, and no vertex is on the wrong side
  double one_wrong;        // they overlap, and one vertex is on the wrong side
};

namespace {

constexpr double per_metre = 64;
constexpr double half_length = 32;  // of a line as drawn, m

/// Convex, counter-clockwise.
const std::array<Point, of_a> outline_a{Point(-1, -0.25), Point(-0.25, -0.875), Point(0.5, -0.625),
                                        Point(0.875, 0.125), Point(-0.375, 0.75)};
const std::array<Point, of_b> outline_b{Point(-0.625, -0.625), Point(0.625, -0.5),
                                        Point(0.875, 0.375), Point(-0.625, 0.5)};

/// The vertices of an outline that is turned, rounded to multiples of 1/64 m.
template <std::size_t Size>
std::array<Point, Size> turned(const std::array<Point, Size>& outline, const Point& up) {
  const double length = std::sqrt(up.squaredNorm());
  const Point along(up.y() / length, -up.x() / length);
  const auto rounded = [](double x) { return std::round(per_metre * x) / per_metre; };
  std::array<Point, Size> result;
  for (std::size_t i = 0; i < Size; ++i) {
    const Point& v = outline[i];
    result[i] = {rounded(v.x() * along.x() - v.y() * along.y()),
                 rounded(v.x() * along.y() + v.y() * along.x())};
  }
  return result;
}

template <std::size_t Size>
std::vector<Point> moved(const std::array<Point, Size>& vertices, const Point& to) {
  std::vector<Point> result;
  for (const Point& v : vertices) result.push_back(to + v);
  return result;
}

/// In space the bodies are prisms from z = −1 to 1. Closest points of two prisms can be chosen at
/// the same height, so they lie to each other as the polygons do, and so do the rounded ones. A
/// normal that separates them still does without its z: both prisms reach equally far along z.
Hull prism(const std::vector<Point>& polygon, double radius) {
  Hull body;
  body.radius = radius;
  for (const double z : {-1.0, 1.0}) {
    for (const Point& v : polygon) body.vertices.push_back({v.x(), v.y(), z});
  }
  return body;
}

/// The line through a point perpendicular to n, as drawn.
std::array<Point, 2> line(const Point& through, const Point& n) {
  const Point along(-n.y() * half_length, n.x() * half_length);
  return {Point(through - along), Point(through + along)};
}

/// Draws the proof that the bodies do not overlap.
void draw_plane(const Hull& a, const Hull& b, const Vector& normal, Output& out) {
  const double length = std::sqrt(normal.head<2>().squaredNorm());
  if (!(length > 0)) return;
  const Point n = normal.head<2>() / length;
  const Vector direction(n.x(), n.y(), 0);
  out.normal = n;
  out.support_a = contact::support(a, -direction).head<2>();
  out.support_b = contact::support(b, direction).head<2>() + b.radius * n;
  out.end_of_a = line(out.support_a, n);
  out.end_of_b = line(out.support_b, n);
  out.between = line((out.support_a + out.support_b) / 2, n);
}

/// Where a vertex with a disc around it is: 1 on the left of the line from p to q, −1 on its wrong
/// side, at least in part, and 0 if it ends on the line. Exact.
int on_left(const Point& p, const Point& q, const Point& v, double radius, int sign) {
  if (radius == 0) return sign * contact::orient_2d(p, q, v);
  using contact::Exact;
  const auto minus = [](double x, double y) { return Exact(x) - Exact(y); };
  const contact::Vector3<Exact> along(minus(q.x(), p.x()), minus(q.y(), p.y()), Exact(0));
  const Exact area = along.x() * minus(v.y(), p.y()) - along.y() * minus(v.x(), p.x());
  return contact::detail::sign_beyond(Exact(sign) * area, radius, along);
}

/// Which vertices are on the wrong side if A is to be on the left of the line (sign 1) or on its
/// right (−1).
struct Sides {
  std::array<double, of_a> wrong_a{}, on_a{};
  std::array<double, of_b> wrong_b{}, on_b{};
  double wrong = 0, on_line = 0;
};

Sides sides(const Input& in, const std::vector<Point>& a, const std::vector<Point>& b,
            double radius, int sign) {
  Sides found;
  const auto count = [&found](int side, double& wrong, double& on) {
    wrong = side < 0 ? 1 : 0;
    on = side == 0 ? 1 : 0;
    found.wrong += wrong;
    found.on_line += on;
  };
  for (std::size_t i = 0; i < of_a; ++i)
    count(on_left(in.p, in.q, a[i], 0, sign), found.wrong_a[i], found.on_a[i]);
  for (std::size_t i = 0; i < of_b; ++i)
    count(on_left(in.p, in.q, b[i], radius, -sign), found.wrong_b[i], found.on_b[i]);
  return found;
}

void judge_line(const Input& in, const std::vector<Point>& a, const std::vector<Point>& b,
                double radius, Output& out) {
  const Sides left = sides(in, a, b, radius, 1), right = sides(in, a, b, radius, -1);
  const bool a_on_left =
      std::pair(left.wrong, left.on_line) <= std::pair(right.wrong, right.on_line);
  const Sides& better = a_on_left ? left : right;
  out.a_on_left = a_on_left ? 1 : 0;
  out.wrong = better.wrong;
  out.on_line = better.on_line;
  out.wrong_a = better.wrong_a;
  out.on_a = better.on_a;
  out.wrong_b = better.wrong_b;
  out.on_b = better.on_b;
}

bool whole(const std::vector<Point>& polygon) {
  return std::all_of(polygon.begin(), polygon.end(), [](const Point& v) {
    const Point x = per_metre * v;
    return x == x.array().round().matrix() && x.cwiseAbs().maxCoeff() <= 1e6;
  });
}

}  // namespace

Output compute(const Input& in) {
  Output out{};
  for (const Point* v : {&in.a, &in.b, &in.turn_a, &in.turn_b, &in.p, &in.q}) {
    if (v->cwiseAbs().maxCoeff() > 1e6) out.problem = contact::figure::too_large;
  }
  for (const Point* turn : {&in.turn_a, &in.turn_b}) {
    if (!(turn->cwiseAbs().maxCoeff() > 1e-100)) out.problem = contact::figure::zero_direction;
  }
  if (in.p == in.q) out.problem = contact::figure::coincident_points;
  if (out.problem != 0) return out;

  const double radius = std::clamp(in.radius, 0.0, 1e6);
  const auto at_a = turned(outline_a, in.turn_a);
  const auto at_b = turned(outline_b, in.turn_b);
  const std::array<Point*, of_a> to_a{&out.a0, &out.a1, &out.a2, &out.a3, &out.a4};
  const std::array<Point*, of_b> to_b{&out.b0, &out.b1, &out.b2, &out.b3};
  for (std::size_t i = 0; i < of_a; ++i) *to_a[i] = at_a[i];
  for (std::size_t i = 0; i < of_b; ++i) *to_b[i] = at_b[i];
  const std::vector<Point> polygon_a = moved(at_a, in.a), polygon_b = moved(at_b, in.b);
  const Hull a = prism(polygon_a, 0), b = prism(polygon_b, radius);

  // [state-and-proof]
  const contact::CertifiedProximity found = contact::certified_proximity(a, b);
  const bool disjoint = found.state == contact::Proximity::disjoint;
  const bool overlapping = found.state == contact::Proximity::overlapping;
  const bool proved = disjoint      ? contact::separates(found.plane, a, b)
                      : overlapping ? contact::overlap_proved(found.common, a, b)
                                    : contact::separates_weakly(found.plane, a, b) &&
                                          contact::meeting_proved(found.common, a, b);
  // [/state-and-proof]
  out.state = disjoint ? 0 : (overlapping ? 2 : 1);
  out.checked = proved ? 1 : 0;
  out.apart = disjoint ? 1 : 0;
  if (disjoint) out.gap = found.low / 2 + found.high / 2;
  if (!overlapping) draw_plane(a, b, found.plane.normal, out);
  if (!disjoint) out.common = contact::near_common_point(found.common, a, b).head<2>();

  judge_line(in, polygon_a, polygon_b, radius, out);
  out.whole = radius == 0 && whole(polygon_a) && whole(polygon_b) ? 1 : 0;
  out.whole_and_apart = out.whole * out.apart;
  out.line_found = disjoint && out.gap < 0.2 && out.wrong == 0 && out.on_line == 0 ? 1 : 0;
  out.weak_line_found = out.state == 1 && out.wrong == 0 ? 1 : 0;
  out.one_wrong = overlapping && out.wrong == 1 ? 1 : 0;
  return out;
}

FIGURE(Input, FIELDS(a, b, turn_a, turn_b, p, q, radius, shown), Output,
       FIELDS(problem, a0, a1, a2, a3, a4, b0, b1, b2, b3, state, checked, gap, normal, between,
              end_of_a, end_of_b, support_a, support_b, common, a_on_left, wrong, on_line, wrong_a,
              on_a, wrong_b, on_b, whole, apart, whole_and_apart, line_found, weak_line_found,
              one_wrong))
