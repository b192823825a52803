/// @file
/// A vertex and a face, or two edges, that move linearly: right answers, and methods as they are
/// often written.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <contact/moving_triangles.hpp>
#include <optional>
#include <vector>

#include "hard_steps.hpp"
#include "moving_truth.hpp"
#include "support/hard_cases.hpp"

namespace hard_moving {

using hard_cases::Case;
using hard_cases::Json;
using hard_steps::right_bounds;
using hard_steps::right_time;
using hard_steps::Time;
using hard_steps::V;

/// Four points at the start and at the end of the step.
struct Moving {
  bool edges = false;
  std::array<V, 4> start, end;

  V at(std::size_t k, double t) const { return start[k] + (end[k] - start[k]) * t; }
  double volume_at(double t) const {
    const V a = at(0, t), b = at(1, t), c = at(2, t), d = at(3, t);
    return edges ? V(b - a).cross(V(d - c)).dot(V(c - a)) : V(c - b).cross(V(d - b)).dot(V(a - b));
  }
  /// Whether the vertex is over the face, or the lines cross between their ends, with a tolerance
  /// in the barycentric coordinates; the distance is not tested.
  bool inside_at(double t, double tolerance) const {
    const V a = at(0, t), b = at(1, t), c = at(2, t), d = at(3, t);
    const V n = edges ? V(V(b - a).cross(V(d - c))) : V(V(c - b).cross(V(d - b)));
    const double square = n.dot(n);
    if (!(square > 0)) return false;
    double u = 0, v = 0;
    if (edges) {
      u = V(c - a).cross(V(d - c)).dot(n) / square;
      v = V(c - a).cross(V(b - a)).dot(n) / square;
      return u >= -tolerance && u <= 1 + tolerance && v >= -tolerance && v <= 1 + tolerance;
    }
    u = V(a - b).cross(V(d - b)).dot(n) / square;
    v = V(c - b).cross(V(a - b)).dot(n) / square;
    return u >= -tolerance && v >= -tolerance && u + v <= 1 + tolerance;
  }
};

inline Moving read(const Case& c, bool edges) {
  const std::vector<double> from = c.numbers("start"), to = c.numbers("end");
  Moving p;
  p.edges = edges;
  for (std::size_t k = 0; k < 4; ++k) {
    p.start[k] = V(from.at(3 * k), from.at(3 * k + 1), from.at(3 * k + 2));
    p.end[k] = V(to.at(3 * k), to.at(3 * k + 1), to.at(3 * k + 2));
  }
  return p;
}
inline moving_truth::Four exact_four(const Moving& p) {
  moving_truth::Four four;
  for (std::size_t k = 0; k < 4; ++k) {
    four.start[k] = oracle::exact(p.start[k]);
    four.displacement[k] = oracle::exact(p.end[k]) - four.start[k];
  }
  return four;
}

/// The coefficients of the volume, interpolated at 0, 1/3, 2/3 and 1.
inline std::array<double, 4> cubic(const Moving& p) {
  const double f0 = p.volume_at(0), f1 = p.volume_at(1.0 / 3), f2 = p.volume_at(2.0 / 3),
               f3 = p.volume_at(1);
  return {f0, (-11 * f0 + 18 * f1 - 9 * f2 + 2 * f3) / 2, 9 * (2 * f0 - 5 * f1 + 4 * f2 - f3) / 2,
          9 * (-f0 + 3 * f1 - 3 * f2 + f3) / 2};
}
/// The roots in [0, 1] at which a rounded cubic changes its sign, between its extrema.
inline std::vector<double> rounded_roots(const std::array<double, 4>& c) {
  const auto value = [&c](double t) { return ((c[3] * t + c[2]) * t + c[1]) * t + c[0]; };
  std::vector<double> ends{0};
  const double a = 3 * c[3], b = 2 * c[2], discriminant = b * b - 4 * a * c[1];
  if (discriminant > 0 && a != 0) {
    const double root = std::sqrt(discriminant);
    for (const double t : {(-b - root) / (2 * a), (-b + root) / (2 * a)}) {
      if (t > 0 && t < 1) ends.push_back(t);
    }
    std::sort(ends.begin(), ends.end());
  } else if (a == 0 && b != 0) {
    const double t = -c[1] / b;
    if (t > 0 && t < 1) ends.push_back(t);
  }
  ends.push_back(1);
  std::vector<double> roots;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    double low = ends[i], high = ends[i + 1];
    if (value(low) == 0) roots.push_back(low);
    if (!(value(low) * value(high) < 0)) continue;
    for (int k = 0; k < 60; ++k) {
      const double middle = low + (high - low) / 2;
      (value(low) * value(middle) <= 0 ? high : low) = middle;
    }
    roots.push_back(high);
  }
  if (value(1) == 0) roots.push_back(1);
  return roots;
}

inline Time by_cubic(const Moving& p, double tolerance) {
  for (const double t : rounded_roots(cubic(p))) {
    if (p.inside_at(t, tolerance)) return t;
  }
  return std::nullopt;
}

inline void add(hard_cases::Runner& runner, const char* question, bool edges) {
  runner.question(question, [edges](const Case& c) {
    const auto four = exact_four(read(c, edges));
    auto t = edges ? moving_truth::edge_edge(four) : moving_truth::vertex_face(four);
    if (!t) return Json{{"class", "a"}, {"time", "none"}};
    const double nearest = t->nearest();
    // A root that is no fraction with a power of two below is left as an interval.
    const char* kind = t->low() == t->high() ? "a" : "c";
    return Json{{"class", kind}, {"time", hard_cases::hex(nearest)}};
  });
  const auto method = [&runner, question, edges](const char* name, auto when) {
    runner.method(question, name, [edges, when](const Case& c, const Json& answer) {
      return right_time(when(read(c, edges)), answer);
    });
  };
  method("signs at the start and at the end", [](const Moving& p) -> Time {
    const double first = p.volume_at(0), last = p.volume_at(1);
    if (!(first * last <= 0)) return std::nullopt;
    double low = 0, high = 1;
    for (int k = 0; k < 60; ++k) {
      const double middle = low + (high - low) / 2;
      (first * p.volume_at(middle) <= 0 ? high : low) = middle;
    }
    return p.inside_at(high, 0) ? Time(high) : std::nullopt;
  });
  method("a hundred slices", [](const Moving& p) -> Time {
    for (int i = 0; i < 100; ++i) {
      double low = i / 100.0, high = (i + 1) / 100.0;
      const double first = p.volume_at(low);
      if (!(first * p.volume_at(high) <= 0)) continue;
      for (int k = 0; k < 60; ++k) {
        const double middle = low + (high - low) / 2;
        (first * p.volume_at(middle) <= 0 ? high : low) = middle;
      }
      if (p.inside_at(high, 0)) return high;
    }
    return std::nullopt;
  });
  method("cubic in double", [](const Moving& p) { return by_cubic(p, 0); });
  method("cubic in double, tolerance 1e-6", [](const Moving& p) { return by_cubic(p, 1e-6); });
  method("first root only", [](const Moving& p) -> Time {
    const auto roots = rounded_roots(cubic(p));
    if (roots.empty() || !p.inside_at(roots.front(), 1e-9)) return std::nullopt;
    return roots.front();
  });
  runner.method(question, "book", [edges](const Case& c, const Json& answer) {
    const Moving p = read(c, edges);
    std::optional<contact::FeatureImpact<double>> found;
    if (edges) {
      found = contact::edge_edge_impact<double>({{p.start[0], p.start[1]}, {p.end[0], p.end[1]}},
                                                {{p.start[2], p.start[3]}, {p.end[2], p.end[3]}});
    } else {
      found = contact::vertex_face_impact<double>(
          {p.start[0], p.end[0]},
          {{p.start[1], p.start[2], p.start[3]}, {p.end[1], p.end[2], p.end[3]}});
    }
    if (answer.at("time") == "none") return !found;
    if (!found) return false;
    const double right = hard_cases::unhex(answer.at("time"));
    return found->t <= right && right <= found->t_high && found->t_high - found->t <= 0x1p-24;
  });
}

}  // namespace hard_moving
