// A point of a triangle's plane: its weights, the interpolated value, and the triangle's three
// projections along the axes.
#include <array>
#include <cmath>
#include <contact/barycentric.hpp>
#include <contact/figure.hpp>

struct Input {
  contact::Vector3<double> a;
  contact::Vector3<double> b;
  contact::Vector3<double> c;
  contact::Vector3<double> point;   // arbitrary; its projection on the plane is tested
  contact::Vector3<double> values;  // at the vertices: temperatures, °C
};

struct Output {
  double problem;
  contact::Vector3<double> normal;  // (b − a) × (c − a)
  contact::Vector3<double> foot;    // nearest point of the plane
  contact::Vector3<double> weights;
  double inside;
  double value;                         // interpolated, °C
  contact::Vector3<double> part_areas;  // signed: opposite a, b and c
  double area;
  double dropped;  // the dimension in which |normal| is largest: 0, 1 or 2
  contact::Vector3<double> projection_areas;  // of the triangle along x, y and z, not negative
  std::array<contact::Vector3<double>, 4>
      projection;        // of a, b, c and the foot, where the dropped coordinate is 0
  double beta_on_slide;  // the lecture's β, with its sign
  double inside_on_slide;
  double balanced;  // goal of a question: all three weights within 0.02 of a third
};

Output compute(const Input& in) {
  Output out{};
  for (const auto* v : {&in.a, &in.b, &in.c, &in.point, &in.values}) {
    if (v->cwiseAbs().maxCoeff() > 1e15) out.problem = contact::figure::too_large;
  }
  if (out.problem != 0) return out;
  const contact::Triangle<double> triangle{in.a, in.b, in.c};
  const contact::Vector3<double> ab = in.b - in.a, ac = in.c - in.a;
  out.normal = ab.cross(ac);
  const double normal_squared = out.normal.dot(out.normal);
  if (normal_squared > 0)
    out.foot = in.point - out.normal.dot(in.point - in.a) / normal_squared * out.normal;
  const auto weights = contact::barycentric(out.foot, triangle);
  if (!weights || !(normal_squared > 0)) {
    out.problem = contact::figure::zero_area;
    return out;
  }

  out.weights = *weights;
  out.inside = contact::inside(out.weights) ? 1 : 0;
  out.value = contact::interpolate(out.weights, in.values.x(), in.values.y(), in.values.z());
  out.area = std::sqrt(normal_squared) / 2;
  out.part_areas = out.area * out.weights;

  const int k = contact::largest_dimension(out.normal);
  out.dropped = k;
  out.projection_areas = out.normal.cwiseAbs() / 2;
  out.projection = {in.a, in.b, in.c, out.foot};
  for (auto& corner : out.projection) corner[k] = 0;

  const auto x = contact::drop_dimension<double>(out.foot - in.a, k);
  const auto e1 = contact::drop_dimension(ab, k);
  out.beta_on_slide = contact::cross2(x, e1) / out.normal[k];
  out.inside_on_slide =
      out.weights.y() >= 0 && out.beta_on_slide >= 0 && out.weights.y() + out.beta_on_slide <= 1
          ? 1
          : 0;
  out.balanced = (out.weights.array() - 1.0 / 3).abs().maxCoeff() <= 0.02 ? 1 : 0;
  return out;
}

FIGURE(Input, FIELDS(a, b, c, point, values), Output,
       FIELDS(problem, normal, foot, weights, inside, value, part_areas, area, dropped,
              projection_areas, projection, beta_on_slide, inside_on_slide, balanced))
