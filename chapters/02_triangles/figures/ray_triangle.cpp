// A ray or a segment against a triangle, by every method of the chapter, in float and in double.
#include <array>
#include <contact/barycentric.hpp>
#include <contact/exact_ray_triangle.hpp>
#include <contact/figure.hpp>
#include <contact/ray_triangle.hpp>
#include <contact/watertight.hpp>

struct Input {
  contact::Vector3<double> origin;   // start of the ray or segment
  contact::Vector3<double> through;  // the ray goes through it; the segment ends there
  contact::Vector3<double> a;
  contact::Vector3<double> b;
  contact::Vector3<double> c;
  double segment;  // 1: only from origin to through
};

struct Output {
  double problem;
  contact::Vector3<double> normal;  // (b − a) × (c − a), not normalised
  double area;
  double origin_height;  // signed distances from the plane
  double through_height;
  double crosses;  // 1 if the line meets the plane in one point, anywhere
  contact::Vector3<double> crossing;
  double hit;  // exact answer
  double t;    // of the exact test; 0 if no hit
  contact::Vector3<double> point;
  contact::Vector3<double> weights;        // of the crossing with the plane, inside or not
  contact::Vector3<double> edge_products;  // of bc, ca and ab: the three edge tests, in double
  double dropped;                          // 0, 1 or 2
  // One answer per method: edge tests, dropped dimension, Möller–Trumbore, watertight.
  std::array<double, 4> hit_in_double;
  std::array<double, 4> hit_in_float;
  std::array<double, 4> t_in_double;
  std::array<double, 4> t_in_float;
  double all_agree;         // 1 if all eight and the exact test agree
  double through_the_back;  // goal of a question: enters from behind, near c
};

template <class S, class Line>
void ask_all(const Line& line, const contact::Triangle<S>& triangle, std::array<double, 4>& hit,
             std::array<double, 4>& t) {
  const std::array answers{contact::intersect_by_edges(line, triangle),
                           contact::intersect_by_dropping(line, triangle),
                           contact::intersect_moller_trumbore(line, triangle),
                           contact::intersect_watertight(line, triangle)};
  for (std::size_t i = 0; i < answers.size(); ++i) {
    hit[i] = answers[i] ? 1 : 0;
    t[i] = answers[i] ? static_cast<double>(answers[i]->t) : 0;
  }
}

template <class S>
void ask_in(const Input& in, std::array<double, 4>& hit, std::array<double, 4>& t) {
  const contact::Vector3<S> origin = in.origin.cast<S>(), through = in.through.cast<S>();
  const contact::Triangle<S> triangle{in.a.cast<S>(), in.b.cast<S>(), in.c.cast<S>()};
  if (in.segment != 0) {
    ask_all<S>(contact::Segment<S>{origin, through}, triangle, hit, t);
  } else {
    ask_all<S>(contact::Ray<S>{origin, through - origin}, triangle, hit, t);
  }
}

Output compute(const Input& in) {
  Output out{};
  const contact::Triangle<double> triangle{in.a, in.b, in.c};
  const contact::Vector3<double> direction = in.through - in.origin;
  out.normal = (in.b - in.a).cross(in.c - in.a);
  const double length = out.normal.norm();
  if (direction == contact::Vector3<double>::Zero()) out.problem = contact::figure::zero_direction;
  if (length == 0) out.problem = contact::figure::zero_area;
  for (const auto* v : {&in.origin, &in.through, &in.a, &in.b, &in.c}) {
    if (v->cwiseAbs().maxCoeff() > 1e15) out.problem = contact::figure::too_large;
  }
  if (out.problem != 0) return out;

  out.area = length / 2;
  out.origin_height = out.normal.dot(in.origin - in.a) / length;
  out.through_height = out.normal.dot(in.through - in.a) / length;
  out.dropped = contact::largest_dimension(out.normal);

  const double rate = out.normal.dot(direction);
  if (rate != 0) {
    out.crosses = 1;
    out.crossing = in.origin + out.normal.dot(in.a - in.origin) / rate * direction;
    const auto weights = contact::barycentric(out.crossing, triangle);
    if (weights) out.weights = *weights;
    out.edge_products = {out.normal.cross(in.c - in.b).dot(out.crossing - in.b),
                         out.normal.cross(in.a - in.c).dot(out.crossing - in.c),
                         out.normal.cross(in.b - in.a).dot(out.crossing - in.a)};
  }

  const auto exact =
      in.segment != 0
          ? contact::intersect_exact(contact::Segment<double>{in.origin, in.through}, triangle)
          : contact::intersect_exact(contact::Ray<double>{in.origin, direction}, triangle);
  if (exact) {
    out.hit = 1;
    out.t = exact->t;
    out.point = contact::interpolate(exact->barycentric, in.a, in.b, in.c);
    out.weights = exact->barycentric;
    out.through_the_back = out.origin_height < 0 && exact->barycentric.z() >= 0.5 ? 1 : 0;
  }

  ask_in<double>(in, out.hit_in_double, out.t_in_double);
  ask_in<float>(in, out.hit_in_float, out.t_in_float);
  out.all_agree = 1;
  for (std::size_t i = 0; i < 4; ++i) {
    if (out.hit_in_double[i] != out.hit || out.hit_in_float[i] != out.hit) out.all_agree = 0;
  }
  return out;
}

FIGURE(Input, FIELDS(origin, through, a, b, c, segment), Output,
       FIELDS(problem, normal, area, origin_height, through_height, crosses, crossing, hit, t,
              point, weights, edge_products, dropped, hit_in_double, hit_in_float, t_in_double,
              t_in_float, all_agree, through_the_back))
