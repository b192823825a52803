// Two triangles that share the edge a b, and rays aimed at points of that edge, in float: which
// rays does each method lose?
#include <array>
#include <contact/exact_ray_triangle.hpp>
#include <contact/figure.hpp>
#include <contact/ray_triangle.hpp>
#include <contact/watertight.hpp>

inline constexpr std::size_t rays = 64;

struct Input {
  contact::Vector3<double> origin;
  contact::Vector3<double> a;
  contact::Vector3<double> b;
  contact::Vector3<double> c;  // the first triangle is a b c
  contact::Vector3<double> d;  // the second is b a d
};

struct Output {
  double problem;
  double opposite;  // 1 if c and d are on either side of the edge as seen along the ray: no gap
  std::array<contact::Vector3<double>, rays> targets;  // as float has them
  // The triangle that each ray hits: 0 neither (a leak), 1 the first triangle, 2 the second, 3
  // both.
  std::array<double, rays> by_edges;
  std::array<double, rays> by_dropping;
  std::array<double, rays> by_moller_trumbore;
  std::array<double, rays> by_watertight;
  std::array<double, rays> by_exact;
  std::array<double, 5> leaks;  // of each method, in that order
};

Output compute(const Input& in) {
  Output out{};
  for (const auto* v : {&in.origin, &in.a, &in.b, &in.c, &in.d}) {
    if (v->cwiseAbs().maxCoeff() > 1e6) out.problem = contact::figure::too_large;
  }
  const contact::Vector3<float> origin = in.origin.cast<float>(), a = in.a.cast<float>(),
                                b = in.b.cast<float>();
  const contact::Triangle<float> first{a, b, in.c.cast<float>()};
  const contact::Triangle<float> second{b, a, in.d.cast<float>()};
  if (a == b) out.problem = contact::figure::coincident_points;
  if (out.problem != 0) return out;

  const contact::Vector3<double> across = (in.b - in.a).cross((in.a + in.b) / 2 - in.origin);
  out.opposite = across.dot(in.c - in.a) * across.dot(in.d - in.a) < 0 ? 1 : 0;

  for (std::size_t i = 0; i < rays; ++i) {
    // Fractions with all their bits, so that the targets are rounded as any others.
    const float share = 0.013f + 0.974f * (static_cast<float>(i) + 0.5f) / static_cast<float>(rays);
    const contact::Vector3<float> target = a + share * (b - a);
    out.targets[i] = target.cast<double>();
    const contact::Ray<float> ray{origin, target - origin};
    const auto who = [&](const auto& method) {
      return (method(ray, first).has_value() ? 1.0 : 0.0) +
             (method(ray, second).has_value() ? 2.0 : 0.0);
    };
    out.by_edges[i] =
        who([](const auto& r, const auto& t) { return contact::intersect_by_edges(r, t); });
    out.by_dropping[i] =
        who([](const auto& r, const auto& t) { return contact::intersect_by_dropping(r, t); });
    out.by_moller_trumbore[i] =
        who([](const auto& r, const auto& t) { return contact::intersect_moller_trumbore(r, t); });
    out.by_watertight[i] =
        who([](const auto& r, const auto& t) { return contact::intersect_watertight(r, t); });
    out.by_exact[i] =
        who([](const auto& r, const auto& t) { return contact::intersect_exact(r, t); });
    const std::array verdicts{out.by_edges[i], out.by_dropping[i], out.by_moller_trumbore[i],
                              out.by_watertight[i], out.by_exact[i]};
    // If there is a gap along the rays, or a triangle is seen edge-on, passing through is no leak.
    for (std::size_t k = 0; k < verdicts.size(); ++k) {
      if (verdicts[k] == 0 && out.by_exact[i] != 0) out.leaks[k] += 1;
    }
  }
  return out;
}

FIGURE(Input, FIELDS(origin, a, b, c, d), Output,
       FIELDS(problem, opposite, targets, by_edges, by_dropping, by_moller_trumbore, by_watertight,
              by_exact, leaks))
