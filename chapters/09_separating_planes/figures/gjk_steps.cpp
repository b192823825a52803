// GJK in the plane: two bodies, the differences of their points, and the simplex of each step.
#include <algorithm>
#include <array>
#include <cmath>
#include <contact/convex_bodies.hpp>
#include <contact/figure.hpp>
#include <contact/gjk.hpp>
#include <contact/hull_2d.hpp>
#include <contact/sine_cosine.hpp>
#include <contact/support.hpp>
#include <cstddef>
#include <vector>

using Point = contact::Vector2<double>;
using Vector = contact::Vector3<double>;
using Hull = contact::ConvexHull<double>;
using Ellipse = contact::Ellipsoid<double>;

struct Input {
  Point a, b;    // positions of the bodies, m
  Point turn_a;  // the direction of A's y axis, of any length
  double shape;  // of B: 0 a polygon, 1 an ellipse
  double step;   // which step is shown, from 1 on; after the last one the answer
};

constexpr std::size_t of_a = 7, of_b = 5, samples = 48;

struct Output {
  double problem;
  std::array<Point, of_a> vertex_a;
  double corners_b;                     // vertices of B as drawn
  std::array<Point, samples> vertex_b;  // of the polygon, or points of the ellipse
  double corners;                       // of the set of differences as drawn
  std::array<Point, samples> difference;
  double steps;     // how often GJK asks for supports after the first vertex
  double shown;     // the step that is shown, from 1 to steps; steps + 1: the answer
  double finished;  // 1 if that is the answer
  double count;     // vertices of the simplex: at most three in the plane
  std::array<Point, 3> simplex;
  Point closest;    // the simplex's point closest to the origin
  double distance;  // of that, m: an upper bound of the distance of the bodies
  // Of a step: the direction that is asked for, towards the origin, of length 1; the supports of A
  // along it and of B along its reverse; and their difference.
  Point direction, support_a, support_b, next;
  double lower;  // the lower bound that this gives, m; 0 if there is none
  // Of the answer.
  double contains;      // 1 if the simplex contains the origin, up to rounding
  Point on_a, on_b;     // closest points
  double converged;     // 1 if both bounds agree up to rounding
  double all_distance;  // the distance of the bodies as GJK finds it in the end, m
  // Goals of questions.
  double five_steps;    // B is a polygon, and GJK needs five steps
  double triangle;      // the answer is shown, and the origin is in the interior of a triangle
  double two_vertices;  // the answer is shown, and the closest points are two vertices
};

namespace {

/// Convex, counter-clockwise.
const std::array<Point, of_a> outline_a{Point(-1, -0.25),   Point(-0.5, -0.5),  Point(0.5, -0.5),
                                        Point(1, -0.125),   Point(0.875, 0.25), Point(0.25, 0.5),
                                        Point(-0.75, 0.375)};
const std::array<Point, of_b> outline_b{Point(-0.875, -0.125), Point(-0.25, -0.5),
                                        Point(0.5, -0.375), Point(0.75, 0.125), Point(0, 0.375)};

Point plane(const Vector& v) { return v.head<2>(); }

/// The bodies lie in the plane z = 0, and so do all differences.
Hull polygon(const std::vector<Point>& vertices) {
  Hull body;
  for (const Point& v : vertices) body.vertices.push_back({v.x(), v.y(), 0});
  return body;
}

/// An ellipsoid whose section by the plane has half lengths of 0.75 and 0.375 m. Its supports along
/// directions of the plane are in the plane.
Ellipse ellipse(const Point& at) {
  Ellipse body;
  body.centre = {at.x(), at.y(), 0};
  body.axes << 0.8, -0.6, 0, 0.6, 0.8, 0, 0, 0, 1;
  body.half_lengths = {0.75, 0.375, 0.375};
  return body;
}

Vector sample_direction(std::size_t i) {
  const auto [sine, cosine] = contact::sine_cosine(6.283185307179586 * double(i) / samples);
  return {cosine, sine, 0};
}

/// Points of a body that are farthest along some directions, in order.
template <class Body>
std::vector<Point> sampled(const Body& body) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < samples; ++i)
    points.push_back(plane(contact::support(body, sample_direction(i))));
  return points;
}

/// The vertices of the hull of all differences of two lists of points.
std::vector<Point> differences(const std::vector<Point>& a, const std::vector<Point>& b) {
  std::vector<Point> all, hull;
  for (const Point& p : a) {
    for (const Point& q : b) all.push_back(p - q);
  }
  for (const int i : contact::convex_hull_2d(all)) hull.push_back(all[std::size_t(i)]);
  return hull;
}

/// What is drawn of one step.
template <class A, class B>
void draw_step(const A& a, const B& b, const contact::GjkStep<double>& step, Output& out) {
  out.count = std::min(step.count, 3);
  for (std::size_t i = 0; i < std::size_t(out.count); ++i) out.simplex[i] = plane(step.vertices[i]);
  out.closest = plane(step.closest);
  out.distance = std::sqrt(step.closest.squaredNorm());
  out.direction = -out.closest / out.distance;
  out.support_a = plane(contact::support(a, -step.closest));
  out.support_b = plane(contact::support(b, step.closest));
  out.next = plane(step.next);
  out.lower = std::max(0.0, step.next.dot(step.closest) / out.distance);
}

void draw_answer(const contact::GjkResult<double>& found, Output& out) {
  out.finished = 1;
  out.count = std::min(found.count, 3);
  for (std::size_t i = 0; i < std::size_t(out.count); ++i)
    out.simplex[i] = plane(found.simplex[i].difference);
  out.closest = plane(found.between);
  out.distance = found.distance;
  out.lower = found.lower;
  out.on_a = plane(found.on_a);
  out.on_b = plane(found.on_b);
}

template <class A, class B>
void walk(const A& a, const B& b, double wanted, Output& out) {
  // [recorded]
  const std::vector<contact::GjkStep<double>> steps = contact::gjk_steps(a, b);
  const contact::GjkResult<double> found = contact::gjk(a, b);
  // [/recorded]
  out.steps = double(steps.size());
  out.shown = std::clamp(std::floor(wanted), 1.0, out.steps + 1);
  const auto at = std::size_t(out.shown) - 1;
  if (at < steps.size())
    draw_step(a, b, steps[at], out);
  else
    draw_answer(found, out);
  out.all_distance = found.distance;
  out.contains = found.distance == 0 ? 1 : 0;
  out.converged = found.converged ? 1 : 0;
  out.triangle = out.finished == 1 && out.contains == 1 && found.count == 3 ? 1 : 0;
  out.two_vertices = out.finished == 1 && out.contains == 0 && found.count == 1 ? 1 : 0;
}

template <std::size_t Size>
double list(const std::vector<Point>& points, std::array<Point, Size>& to) {
  const std::size_t count = std::min(points.size(), Size);
  for (std::size_t i = 0; i < count; ++i) to[i] = points[i];
  return double(count);
}

}  // namespace

Output compute(const Input& in) {
  Output out{};
  for (const Point* v : {&in.a, &in.b, &in.turn_a}) {
    if (v->cwiseAbs().maxCoeff() > 1e6) out.problem = contact::figure::too_large;
  }
  const double length = std::sqrt(in.turn_a.squaredNorm());
  if (!(length > 1e-100)) out.problem = contact::figure::zero_direction;
  if (out.problem != 0) return out;

  const Point y = in.turn_a / length, x(y.y(), -y.x());
  std::vector<Point> a, b;
  for (const Point& v : outline_a) a.push_back(in.a + v.x() * x + v.y() * y);
  for (const Point& v : outline_b) b.push_back(in.b + v);
  const Hull body_a = polygon(a);
  list(a, out.vertex_a);
  if (in.shape == 1) {
    const Ellipse body_b = ellipse(in.b);
    b = sampled(body_b);
    walk(body_a, body_b, in.step, out);
  } else {
    walk(body_a, polygon(b), in.step, out);
    out.five_steps = out.steps >= 5 ? 1 : 0;
  }
  out.corners_b = list(b, out.vertex_b);
  out.corners = list(differences(a, b), out.difference);
  return out;
}

FIGURE(Input, FIELDS(a, b, turn_a, shape, step), Output,
       FIELDS(problem, vertex_a, corners_b, vertex_b, corners, difference, steps, shown, finished,
              count, simplex, closest, distance, direction, support_a, support_b, next, lower,
              contains, on_a, on_b, converged, all_distance, five_steps, triangle, two_vertices))
