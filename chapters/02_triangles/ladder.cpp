// The cost of a correct test of a ray against a triangle: each method in float and in double, on
// four families of input.
#include <support/ladder.hpp>

#include <02_triangles/families.hpp>
#include <contact/exact_ray_triangle.hpp>
#include <contact/ray_triangle.hpp>
#include <contact/watertight.hpp>

#ifdef CONTACT_HAS_GMP
#include <boost/multiprecision/eigen.hpp>
#include <boost/multiprecision/gmp.hpp>
#endif

namespace {

using contact::Ray;
using contact::Triangle;
using contact::TriangleHit;

/// The same numbers in float and in double: the conversion is not timed.
struct Input {
  Ray<float> ray;
  std::array<Triangle<float>, 2> triangles;
  Ray<double> ray_in_double;
  std::array<Triangle<double>, 2> triangles_in_double;
  int count;
};
using Answer = std::optional<TriangleHit<double>>;

Input both_types(const families::Aimed& aimed) {
  return {aimed.ray,
          aimed.triangles,
          contact::in_double(aimed.ray),
          {contact::in_double(aimed.triangles[0]), contact::in_double(aimed.triangles[1])},
          aimed.count};
}

/// The first of the triangles that a method reports as hit.
template <class S, class Method>
Answer ask(const Method& method, const Ray<S>& ray, const std::array<Triangle<S>, 2>& triangles,
           int count) {
  for (int i = 0; i < count; ++i) {
    const std::optional<TriangleHit<S>> hit = method(ray, triangles[static_cast<std::size_t>(i)]);
    if (hit)
      return TriangleHit<double>{static_cast<double>(hit->t),
                                 hit->barycentric.template cast<double>()};
  }
  return std::nullopt;
}

Answer truth(const Input& input) {
  const auto exact = [](const auto& ray, const auto& triangle) {
    return contact::intersect_exact_unfiltered(ray, triangle);
  };
  return ask(exact, input.ray_in_double, input.triangles_in_double, input.count);
}

/// Wrong is a hit where there is none, or none where there is one. The error is that of t,
/// relative.
ladder::Verdict judge(const Answer& got, const Answer& right) {
  ladder::Verdict verdict;
  verdict.wrong = got.has_value() != right.has_value();
  if (got && right) {
    const double difference = std::abs(got->t - right->t);
    verdict.error = difference == 0 ? 0 : difference / std::abs(right->t);
  }
  return verdict;
}

#ifdef CONTACT_HAS_GMP
using Rational = boost::multiprecision::number<boost::multiprecision::gmp_rational,
                                               boost::multiprecision::et_off>;

contact::Vector3<Rational> rational(const contact::Vector3<double>& v) {
  return {Rational(v.x()), Rational(v.y()), Rational(v.z())};
}

/// Möller–Trumbore with rational numbers: the simplest exact method.
Answer by_rationals(const Ray<double>& ray, const Triangle<double>& triangle) {
  const auto hit = contact::intersect_moller_trumbore(
      Ray<Rational>{rational(ray.origin), rational(ray.direction)},
      Triangle<Rational>{rational(triangle.a), rational(triangle.b), rational(triangle.c)});
  if (!hit) return std::nullopt;
  const auto& w = hit->barycentric;
  return TriangleHit<double>{
      hit->t.convert_to<double>(),
      {w.x().convert_to<double>(), w.y().convert_to<double>(), w.z().convert_to<double>()}};
}
#endif

ladder::Ladder<Input, Answer> experiment() {
  ladder::Ladder<Input, Answer> ladder("Does the ray hit the triangle?", truth, judge);

  const auto family = [&ladder](const char* id, const char* title, auto generator) {
    ladder.family(id, title, [generator](generators::Random& random) {
      return both_types(generator(random));
    });
  };
  family("random", "random", families::random);
  family("edge", "aimed at an edge", families::at_edge);
  family("grid", "whole numbers, exactly on an edge", families::on_grid);
  family("shared-edge", "between two triangles", families::at_shared_edge);

  const auto in_both = [&ladder](const char* id, const char* title, auto method) {
    ladder.method(
        {.id = std::string(id) + "-float", .title = title, .scalar = "float", .exact = false},
        [method](const Input& input) {
          return ask(method, input.ray, input.triangles, input.count);
        });
    ladder.method(
        {.id = std::string(id) + "-double", .title = title, .scalar = "double", .exact = false},
        [method](const Input& input) {
          return ask(method, input.ray_in_double, input.triangles_in_double, input.count);
        });
  };
  in_both("edges", "edge tests",
          [](const auto& r, const auto& t) { return contact::intersect_by_edges(r, t); });
  in_both("dropping", "dropped dimension",
          [](const auto& r, const auto& t) { return contact::intersect_by_dropping(r, t); });
  in_both("moller-trumbore", "Möller–Trumbore",
          [](const auto& r, const auto& t) { return contact::intersect_moller_trumbore(r, t); });
  in_both("watertight", "watertight",
          [](const auto& r, const auto& t) { return contact::intersect_watertight(r, t); });

  const auto exact = [&ladder](const char* id, const char* title, const char* scalar, auto method) {
    ladder.method({.id = id, .title = title, .scalar = scalar, .exact = true},
                  [method](const Input& input) {
                    return ask(method, input.ray_in_double, input.triangles_in_double, input.count);
                  });
  };
  exact("exact", "exact, filtered", "double, then exact",
        [](const auto& r, const auto& t) { return contact::intersect_exact(r, t); });
  exact("exact-unfiltered", "exact, no filter", "exact",
        [](const auto& r, const auto& t) { return contact::intersect_exact_unfiltered(r, t); });
#ifdef CONTACT_HAS_GMP
  exact("rational", "Möller–Trumbore, rational numbers (GMP)", "rational", by_rationals);
#endif
  return ladder;
}

}  // namespace

LADDER(experiment)
