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

using Point = contact::Vector3<double>;

/// The ray and the triangles, divided by a power of two if they are large: that rounds nothing.
ladder::Example shown(const Input& input, const Answer& got, const Answer& right,
                      const ladder::Method& method) {
  const Ray<double>& ray = input.ray_in_double;
  const Triangle<double>& t = input.triangles_in_double[0];
  const auto verdict = [](const Answer& answer) { return answer ? "hit" : "miss"; };
  ladder::Example example;
  example.facts = {ladder::numbers("ray's origin", input.ray.origin),
                   ladder::numbers("ray's direction", input.ray.direction),
                   ladder::numbers("a", input.triangles[0].a),
                   ladder::numbers("b", input.triangles[0].b),
                   ladder::numbers("c", input.triangles[0].c)};
  if (input.count == 2)
    example.facts.push_back(ladder::numbers("d, of triangle b a d", input.triangles[1].c));
  example.facts.push_back({"this method", verdict(got)});
  example.facts.push_back({"exact", verdict(right)});
  double size = 0;
  for (const Point& p : {ray.origin, t.a, t.b, t.c}) size = std::max(size, p.cwiseAbs().maxCoeff());
  const double scale = size > 4 ? std::ldexp(1.0, -std::ilogb(size)) : 1;
  const auto scaled = [scale](const Point& p) { return Point(p * scale); };
  const Point through = ray.origin + ray.direction;
  example.fields = {ladder::field("origin", scaled(ray.origin)), ladder::field("a", scaled(t.a)),
                    ladder::field("b", scaled(t.b)), ladder::field("c", scaled(t.c))};
  if (input.count == 2) {
    example.figure = "shared_edge";
    example.fields.push_back(ladder::field("d", scaled(input.triangles_in_double[1].c)));
    example.note = "The figure aims rays of its own at the shared edge, in float.";
    return example;
  }
  // The figure gets a second point of the ray, from which its methods must get this direction.
  const bool same_in_float =
      contact::Vector3<float>(through.cast<float>() - input.ray.origin) == input.ray.direction;
  const bool same_in_double = Point(through - ray.origin) == ray.direction;
  if (method.scalar == "float" ? same_in_float : same_in_double) {
    example.figure = "ray_triangle";
    example.fields.push_back(ladder::field("through", scaled(through)));
    example.fields.push_back({"segment", {0}});
    if (scale < 1) example.note = "All coordinates are divided by a power of two.";
  } else {
    example.note = "In the figure's form, with two points of the ray, this direction is rounded.";
  }
  return example;
}

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
  ladder.recommend("exact");
  ladder.show(shown);
  return ladder;
}

}  // namespace

LADDER(experiment)
