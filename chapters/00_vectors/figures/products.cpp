// Two arrows from one point: their dot product, their cross product, and how both are drawn.
#include <cmath>
#include <contact/figure.hpp>
#include <contact/products.hpp>

struct Input {
  contact::Vector3<double> u;  // m
  contact::Vector3<double> v;  // m
};

struct Output {
  double problem;
  double dot;                      // m²
  contact::Vector3<double> cross;  // m²
  double area;                     // of the parallelogram, m²
  double length_u, length_v;       // m
  double cosine;                   // of the angle between them; 0 if one has no length
  double along;                    // component of v along u, m
  contact::Vector3<double> foot;   // projection of the tip of v on the line of u, m
  double perpendicular;            // goal of a question: a right angle to within a degree
  double down_and_back;            // goal of a question: u × v points down, and u · v is negative
};

Output compute(const Input& in) {
  Output out{};
  for (const auto* v : {&in.u, &in.v}) {
    if (v->cwiseAbs().maxCoeff() > 1e60) out.problem = contact::figure::too_large;
    const double size = v->cwiseAbs().maxCoeff();
    if (size > 0 && size < 1e-60) out.problem = contact::figure::too_small;
  }
  if (in.u == contact::Vector3<double>::Zero()) out.problem = contact::figure::zero_direction;
  if (out.problem != 0) return out;
  out.dot = contact::dot_accurately(in.u, in.v);
  out.cross = contact::cross_accurately(in.u, in.v);
  out.area = std::sqrt(contact::dot_accurately(out.cross, out.cross));
  const double u_squared = contact::dot_accurately(in.u, in.u);
  out.length_u = std::sqrt(u_squared);
  out.length_v = std::sqrt(contact::dot_accurately(in.v, in.v));
  if (out.length_v > 0) out.cosine = out.dot / (out.length_u * out.length_v);
  out.along = out.dot / out.length_u;
  out.foot = out.dot / u_squared * in.u;
  const bool long_enough = out.length_u >= 0.5 && out.length_v >= 0.5;
  out.perpendicular = long_enough && std::abs(out.cosine) <= 0.0175 ? 1 : 0;
  out.down_and_back = long_enough && out.dot < 0 && out.area > 0.1 * out.length_u * out.length_v &&
                              out.cross.z() <= -0.9 * out.area
                          ? 1
                          : 0;
  return out;
}

FIGURE(Input, FIELDS(u, v), Output,
       FIELDS(problem, dot, cross, area, length_u, length_v, cosine, along, foot, perpendicular,
              down_and_back))
