/// @file
/// What the hard cases of this chapter share: input, and the questions of a box and of the smallest
/// sphere around points, with the methods of the reports.
#pragma once

#include <07_bounding_volumes/volume_families.hpp>
#include <algorithm>
#include <cmath>
#include <concepts>
#include <contact/aabb.hpp>
#include <contact/shapes.hpp>
#include <contact/vector.hpp>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <support/generators.hpp>
#include <support/hard_cases.hpp>
#include <support/oracle.hpp>
#include <vector>

namespace hard_common {

using contact::Aabb;
using contact::Vector3;
using hard_cases::Case;
using hard_cases::Json;

template <std::floating_point S>
using Points = std::vector<Vector3<S>>;

// ---------------------------------------------------------------- input

/// A field with three numbers for each point.
template <std::floating_point S>
Points<S> points_of(const Case& c, const std::string& field = "points") {
  const std::vector<double> numbers = c.numbers(field);
  Points<S> points;
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3) {
    points.push_back(
        generators::rounded<S>(Vector3<double>(numbers[i], numbers[i + 1], numbers[i + 2])));
  }
  return points;
}
/// A method in S answers cases whose input S can store.
template <std::floating_point S>
bool applies(const Case& c) {
  return std::same_as<S, double> || c.type() == "float";
}
using volume_families::span_of;

// ---------------------------------------------------------------- a box of points as often written

/// From the given start of both corners.
template <std::floating_point S>
Aabb<S> grown_box(const Points<S>& points, const Vector3<S>& low, const Vector3<S>& high) {
  Aabb<S> box{low, high};
  for (const Vector3<S>& p : points) {
    for (int k = 0; k < 3; ++k) {
      box.low[k] = std::min(box.low[k], p[k]);
      box.high[k] = std::max(box.high[k], p[k]);
    }
  }
  return box;
}
/// numeric_limits::min() is the smallest positive number, not the lowest.
template <std::floating_point S>
Aabb<S> from_smallest_positive(const Points<S>& points) {
  using Limits = std::numeric_limits<S>;
  return grown_box<S>(points, Vector3<S>::Constant(Limits::max()),
                      Vector3<S>::Constant(Limits::min()));
}
/// The origin is inside every box.
template <std::floating_point S>
Aabb<S> from_origin(const Points<S>& points) {
  return grown_box<S>(points, Vector3<S>::Zero(), Vector3<S>::Zero());
}

// ---------------------------------------------------------------- the smallest sphere, exactly

/// A sphere with its radius squared.
struct ExactSphere {
  oracle::Vector centre;
  oracle::Rational radius_squared;
};
inline bool contains(const ExactSphere& sphere, const oracle::Vector& p) {
  const oracle::Vector away = p - sphere.centre;
  return away.dot(away) <= sphere.radius_squared;
}
/// The smallest sphere through up to four points, none if they are affinely dependent. Its centre
/// is p + Σ xᵢ dᵢ, dᵢ the differences from the first point p, with 2 dᵢ · Σ xⱼ dⱼ = dᵢ · dᵢ.
inline std::optional<ExactSphere> sphere_through(const std::vector<oracle::Vector>& points) {
  const std::size_t n = points.size() - 1;
  std::vector<oracle::Vector> d;
  for (std::size_t i = 0; i < n; ++i) d.push_back(points[i + 1] - points[0]);
  std::vector<std::vector<oracle::Rational>> rows(n, std::vector<oracle::Rational>(n + 1));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) rows[i][j] = 2 * d[i].dot(d[j]);
    rows[i][n] = d[i].dot(d[i]);
  }
  // A Gram matrix is positive definite or singular, so elimination needs no exchange of rows.
  for (std::size_t i = 0; i < n; ++i) {
    if (rows[i][i] == 0) return {};
    for (std::size_t k = 0; k < n; ++k) {
      if (k == i) continue;
      const oracle::Rational factor = rows[k][i] / rows[i][i];
      for (std::size_t j = i; j <= n; ++j) rows[k][j] -= factor * rows[i][j];
    }
  }
  oracle::Vector away = oracle::Vector::Zero();
  for (std::size_t i = 0; i < n; ++i) away += oracle::Rational(rows[i][n] / rows[i][i]) * d[i];
  return ExactSphere{points[0] + away, away.dot(away)};
}
/// The smallest sphere around all points: the smallest of those through one to four of them that
/// contain the others. For few points.
inline ExactSphere smallest_sphere_of(const Points<double>& points) {
  std::vector<oracle::Vector> all;
  for (const auto& p : points) all.push_back(oracle::exact(p));
  std::optional<ExactSphere> best;
  std::vector<oracle::Vector> chosen;
  const std::function<void(std::size_t)> choose = [&](std::size_t from) {
    for (std::size_t i = from; i < all.size(); ++i) {
      chosen.push_back(all[i]);
      const auto sphere = sphere_through(chosen);
      const auto inside = [&](const oracle::Vector& p) { return contains(*sphere, p); };
      if (sphere && (!best || sphere->radius_squared < best->radius_squared) &&
          std::all_of(all.begin(), all.end(), inside)) {
        best = sphere;
      }
      if (chosen.size() < 4) choose(i + 1);
      chosen.pop_back();
    }
  };
  choose(0);
  return *best;
}
/// Whether a sphere contains all points and its radius exceeds the smallest one by at most one part
/// in 10⁹.
template <std::floating_point S>
bool is_smallest(const Points<S>& points, const Vector3<S>& centre, S radius,
                 const oracle::Rational& smallest_squared) {
  if (!centre.allFinite() || !std::isfinite(radius)) return false;
  const oracle::Rational r = oracle::exact(radius);
  const ExactSphere sphere{oracle::exact(centre), r * r};
  for (const auto& p : points) {
    if (!contains(sphere, oracle::exact(p))) return false;
  }
  return r * r * oracle::Rational(1000000000) <= smallest_squared * oracle::Rational(1000000002);
}

// ---------------------------------------------------------------- questions

template <std::floating_point S, class Make>
void add_box_method(hard_cases::Runner& runner, const std::string& name, const Make& make) {
  runner.method("aabb", name, applies<S>, [make](const Case& c, const Json& answer) {
    const Aabb<S> box = make(points_of<S>(c));
    return hard_cases::hex(box.low.template cast<double>()) == answer.at("low") &&
           hard_cases::hex(box.high.template cast<double>()) == answer.at("high");
  });
}

template <class Make>
void add_sphere_method(hard_cases::Runner& runner, const std::string& name, const Make& make) {
  runner.method("smallest_sphere", name, [make](const Case& c, const Json&) {
    const Points<double> points = points_of<double>(c);
    const contact::Sphere<double> sphere = make(points);
    return is_smallest(points, sphere.centre, sphere.radius,
                       smallest_sphere_of(points).radius_squared);
  });
}

/// The smallest sphere of a few points, with two mistakes in the use of a library.
inline void add_sphere_question(hard_cases::Runner& runner) {
  runner.question("smallest_sphere", [](const Case& c) -> Json {
    const ExactSphere sphere = smallest_sphere_of(points_of<double>(c));
    return {{"class", "a"},
            {"centre", hard_cases::hex(oracle::nearest(sphere.centre))},
            {"radius_squared", hard_cases::hex(oracle::nearest(sphere.radius_squared))}};
  });
  add_sphere_method(runner, "radius squared as radius", [](const Points<double>& points) {
    const ExactSphere sphere = smallest_sphere_of(points);
    return contact::Sphere<double>{oracle::nearest(sphere.centre),
                                   oracle::nearest(sphere.radius_squared)};
  });
  add_sphere_method(runner, "first point read n times", [](const Points<double>& points) {
    return contact::Sphere<double>{points.front(), 0};
  });
}

/// Adds them to a runner.
inline void add_questions(hard_cases::Runner& runner) {
  add_sphere_question(runner);
  runner.question("aabb", [](const Case& c) -> Json {
    oracle::Vector low, high;
    const Points<double> points = points_of<double>(c);
    for (int k = 0; k < 3; ++k) {
      const auto less = [k](const auto& p, const auto& q) {
        return oracle::exact(p[k]) < oracle::exact(q[k]);
      };
      low[k] = oracle::exact((*std::min_element(points.begin(), points.end(), less))[k]);
      high[k] = oracle::exact((*std::max_element(points.begin(), points.end(), less))[k]);
    }
    return {{"class", "a"},
            {"low", hard_cases::hex(oracle::nearest(low))},
            {"high", hard_cases::hex(oracle::nearest(high))}};
  });
  add_box_method<float>(runner, "from the smallest positive number, float",
                        from_smallest_positive<float>);
  add_box_method<double>(runner, "from the smallest positive number, double",
                         from_smallest_positive<double>);
  add_box_method<double>(runner, "from the origin, double", from_origin<double>);
  add_box_method<double>(runner, "the book, exact", [](const Points<double>& points) {
    return contact::aabb_of_points(span_of<double>(points));
  });
}

}  // namespace hard_common
