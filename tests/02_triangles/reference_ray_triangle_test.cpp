// ray_triangle.hpp: decisions of the rounded methods beyond their rounding errors, and invariants
// of all methods.
#include <02_triangles/adversarial.hpp>
#include <02_triangles/families.hpp>
#include <02_triangles/truth.hpp>
#include <boost/multiprecision/eigen.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/barycentric.hpp>
#include <contact/exact.hpp>
#include <contact/exact_ray_triangle.hpp>
#include <contact/ray_triangle.hpp>
#include <contact/watertight.hpp>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <support/generators.hpp>
#include <support/oracle.hpp>

#include "reference.hpp"

using contact::Exact;
using contact::Ray;
using contact::Segment;
using contact::Triangle;
using contact::TriangleHit;
using contact::Vector3;
using generators::Family;
using generators::Random;
using oracle::Rational;
using oracle::Vector;
using reference::absolute;
using reference::determinant;
using reference::u;

namespace {

bool is_number(const TriangleHit<double>& hit) {
  return !std::isnan(hit.t) && hit.barycentric.allFinite();
}

/// p·(q × r) with every term made positive.
Rational sum_of_terms(const Vector& p, const Vector& q, const Vector& r) {
  const Vector a = absolute(p), b = absolute(q), c = absolute(r);
  return a.x() * (b.y() * c.z() + b.z() * c.y()) + a.y() * (b.z() * c.x() + b.x() * c.z()) +
         a.z() * (b.x() * c.y() + b.y() * c.x());
}

/// The quantities of a query, exactly, and the sums of their terms, from which the bounds below are
/// computed.
struct Conditions {
  Vector d, a, b, c, ab, ac;
  Rational denominator, of_a, of_b, of_c, start;
  Rational denominator_terms, of_a_terms, of_b_terms, of_c_terms, start_terms;

  Conditions(const Vector& origin, const Vector& direction, const Triangle<Rational>& t)
      : d(direction),
        a(t.a - origin),
        b(t.b - origin),
        c(t.c - origin),
        ab(t.b - t.a),
        ac(t.c - t.a) {
    denominator = determinant(d, ab, ac);
    denominator_terms = sum_of_terms(d, ab, ac);
    // As Möller and Trumbore measure them, from vertex a: of_b = d·(−a × ac)…, so that the terms
    // are those they round.
    of_b = determinant(d, ac, a);
    of_b_terms = sum_of_terms(d, ac, a);
    of_c = determinant(d, a, ab);
    of_c_terms = sum_of_terms(d, a, ab);
    of_a = denominator - of_b - of_c;
    of_a_terms = denominator_terms + of_b_terms + of_c_terms;
    start = determinant(a, ab, ac);
    start_terms = sum_of_terms(a, ab, ac);
  }
};

/// c·u (Σ|terms of N| + |t| Σ|terms of D|)/|D|, plus what an underflow can add; infinite where the
/// denominator is less than 2^10 times its own error, and nothing can be said.
///
/// N and D are determinants of three differences. A term of either takes at most eight roundings
/// (three entries, two products, three sums and differences), so N̂ = N + e_N and D̂ = D + e_D with
/// |e| ≤ γ(8) Σ|terms|. Then |N̂/D̂ − N/D| = |e_N − t e_D|/|D̂| ≤ γ(8)(ΣN + |t| ΣD)/(|D|(1 − 2^-10)),
/// and the division adds u|N̂/D̂|, which is at most u |t| ΣD/|D| and as much again of higher order: c
/// = 10 holds all of it.
Rational quotient_bound(const Rational& n, const Rational& n_terms, const Conditions& x,
                        int c = 10) {
  const Rational t = absolute(Rational(n / x.denominator));
  return Rational(c) * oracle::exact(u) * (n_terms + t * x.denominator_terms) /
         absolute(x.denominator);
}

bool well_conditioned(const Conditions& x, int c = 10) {
  return absolute(x.denominator) > Rational(c) * 1024 * oracle::exact(u) * x.denominator_terms;
}

/// The distances of a decision of a rounded method from the opposite one: all must exceed the
/// rounding errors.
///
/// The methods that compute the point x = o + t d first propagate its error to the edge tests. With
/// e_t the bound on t, each coordinate of x is off by e_t|d| + 3u(|o| + |t d|), and a weight, a
/// quotient of areas over the normal squared, moves by that times |edge||n|/n², plus its own
/// rounding. `safe` takes eight times the sum as a distance that exceeds all rounding errors here.
struct Margins {
  bool safe_for_point_methods = false;
  bool safe_for_determinants = false;
};

Margins margins(const Conditions& x, const Vector& origin, bool bounded) {
  Margins result;
  if (!well_conditioned(x)) return result;
  const Rational t = x.start / x.denominator;
  const Rational e_t = quotient_bound(x.start, x.start_terms, x);
  const bool t_clear = absolute(t) > e_t && (!bounded || absolute(Rational(t - 1)) > e_t);
  const auto clear = [&](const Rational& n, const Rational& terms) {
    return absolute(n) > 10 * oracle::exact(u) * terms;
  };
  result.safe_for_determinants = t_clear && clear(x.of_a, x.of_a_terms) &&
                                 clear(x.of_b, x.of_b_terms) && clear(x.of_c, x.of_c_terms);

  const auto size = [](const Vector& v) -> Rational {
    const Vector a = absolute(v);
    return a.x() + a.y() + a.z();
  };
  const Vector normal = x.ab.cross(x.ac);
  const Rational n2 = normal.dot(normal);
  const Rational edge = size(x.ab) + size(x.ac);
  const Rational e_point =
      e_t * size(x.d) +
      4 * oracle::exact(u) * (size(origin) + size(x.a) + (absolute(t) + 1) * size(x.d));
  const Rational normal_terms = edge * edge;
  const Rational e_weight =
      8 *
          (normal_terms * edge *
           (e_point + 16 * oracle::exact(u) * (size(x.a) + absolute(t) * size(x.d) + edge))) /
          n2 +
      64 * oracle::exact(u) * normal_terms * normal_terms / n2;
  result.safe_for_point_methods = t_clear;
  for (const Rational& n : {x.of_a, x.of_b, x.of_c}) {
    if (absolute(Rational(n / x.denominator)) <= e_weight) result.safe_for_point_methods = false;
  }
  return result;
}

struct Tally {
  int asked = 0, hits = 0, decided_by_point = 0, decided_by_determinant = 0, values = 0;
};

/// Compares one method with the truth: its decision where it exceeds the rounding errors, its t
/// within the bound, and no NaN.
template <class Line, class Method>
void hold_plain(const Line& line, const Triangle<double>& triangle, const Method& method,
                bool point_method, bool bounded, Tally& tally) {
  const auto right = truth::meet(line, triangle);
  const auto got = method(line, triangle);
  ++tally.asked;
  tally.hits += right.has_value();
  if (got) REQUIRE(is_number(*got));

  Vector origin, direction;
  if constexpr (std::same_as<Line, Ray<double>>) {
    origin = oracle::exact(line.origin);
    direction = oracle::exact(line.direction);
  } else {
    origin = oracle::exact(line.start);
    direction = oracle::exact(line.end) - origin;
  }
  const Conditions x(origin, direction, oracle::exact(triangle));
  if (x.denominator == 0) return;
  const Margins margin = margins(x, origin, bounded);
  if (point_method ? margin.safe_for_point_methods : margin.safe_for_determinants) {
    REQUIRE(got.has_value() == right.has_value());
    ++(point_method ? tally.decided_by_point : tally.decided_by_determinant);
  }
  if (got && right && well_conditioned(x)) {
    // (a) and (b) find a segment's t from the distances of its ends: their denominator's terms are
    // those of both.
    Conditions terms = x;
    if (bounded && point_method) {
      const Vector end = x.a - x.d;
      terms.denominator_terms = x.start_terms + sum_of_terms(end, x.ab, x.ac);
      if (!well_conditioned(terms)) return;
    }
    REQUIRE(oracle::error(got->t, right->t) <= quotient_bound(x.start, x.start_terms, terms));
    ++tally.values;
    if (!point_method) {
      REQUIRE(oracle::error(got->barycentric.y(), right->weights.y()) <=
              quotient_bound(x.of_b, x.of_b_terms, x));
      REQUIRE(oracle::error(got->barycentric.z(), right->weights.z()) <=
              quotient_bound(x.of_c, x.of_c_terms, x));
    }
  }
}

template <class Method>
void hold_plain_on_families(const Method& method, bool point_method, std::uint64_t seed,
                            bool any_scale) {
  Random random(seed);
  // `huge` and `tiny` are 2^±200 to 2^±320. Products of three such numbers neither overflow nor
  // underflow, so the bounds hold; edge tests multiply four, and the hard cases show the
  // consequences.
  for (const Family family : generators::all_families) {
    if (!any_scale && (family == Family::huge || family == Family::tiny)) continue;
    Tally tally;
    for (int i = 0; i < 600; ++i) {
      const Triangle<double> triangle = generators::proper_triangle(random, family);
      const Ray<double> ray = generators::ray(random, family, triangle);
      const Segment<double> segment = generators::segment(random, family, triangle);
      CAPTURE(generators::name(family), i);
      hold_plain(ray, triangle, method, point_method, false, tally);
      hold_plain(segment, triangle, method, point_method, true, tally);
    }
    CAPTURE(generators::name(family));
    REQUIRE(tally.hits > 30);
    if (family != Family::coplanar) REQUIRE(tally.values > 30);
    if (family == Family::random)
      REQUIRE(tally.decided_by_point + tally.decided_by_determinant > 1000);
  }
}

}  // namespace

TEST_CASE("edge tests are right beyond their rounding errors, with t within its bound") {
  hold_plain_on_families(
      [](const auto& line, const auto& t) { return contact::intersect_by_edges(line, t); }, true,
      11, false);
}

TEST_CASE("the dropped dimension is right beyond its rounding errors, with t within its bound") {
  hold_plain_on_families(
      [](const auto& line, const auto& t) { return contact::intersect_by_dropping(line, t); }, true,
      12, true);
}

TEST_CASE(
    "Möller-Trumbore is right beyond its rounding errors, with t and weights within their bounds") {
  hold_plain_on_families(
      [](const auto& line, const auto& t) { return contact::intersect_moller_trumbore(line, t); },
      false, 13, true);
}

TEST_CASE("in rational arithmetic the rounded methods are exact") {
  Random random(14);
  int hits = 0;
  for (int i = 0; i < 1500; ++i) {
    const Family family =
        generators::all_families[static_cast<std::size_t>(i) % generators::all_families.size()];
    const Triangle<double> triangle = generators::triangle(random, family);
    const auto hold = [&](const auto& line) {
      const auto right = truth::meet(line, triangle);
      const auto exact_line = oracle::exact(line);
      const auto exact_triangle = oracle::exact(triangle);
      for (const auto& got : {contact::intersect_by_edges(exact_line, exact_triangle),
                              contact::intersect_by_dropping(exact_line, exact_triangle),
                              contact::intersect_moller_trumbore(exact_line, exact_triangle)}) {
        REQUIRE(got.has_value() == right.has_value());
        if (!got) continue;
        ++hits;
        REQUIRE(got->t == right->t);
        REQUIRE(got->barycentric == right->weights);
      }
    };
    hold(generators::ray(random, family, triangle));
    hold(generators::segment(random, family, triangle));
  }
  REQUIRE(hits > 1000);
}

TEST_CASE("without a division, Möller-Trumbore is exact in dyadic numbers") {
  Random random(15);
  const auto dyadic = [](const Vector3<double>& v) {
    return Vector3<Exact>(Exact(v.x()), Exact(v.y()), Exact(v.z()));
  };
  int hits = 0;
  for (int i = 0; i < 4000; ++i) {
    const adversarial::Case c =
        adversarial::all[static_cast<std::size_t>(i) % adversarial::all.size()](random);
    const Triangle<Exact> triangle{dyadic(c.triangle.a), dyadic(c.triangle.b),
                                   dyadic(c.triangle.c)};
    const auto got = contact::moller_trumbore_fractions<Exact>(dyadic(c.start), dyadic(c.second),
                                                               std::nullopt, triangle);
    const auto right = truth::meet(Ray<double>{c.start, c.second}, c.triangle);
    REQUIRE(got.has_value() == right.has_value());
    hits += right.has_value();
  }
  REQUIRE(hits > 200);
}

TEST_CASE(
    "every rounded method in float fails on rays aimed at an edge, and the count is recorded") {
  Random random(34);
  std::map<std::string, int> wrong;
  for (int i = 0; i < 5000; ++i) {
    const families::Aimed aimed = families::at_edge(random);
    const Triangle<float>& triangle = aimed.triangles[0];
    const bool right = contact::intersect_exact(aimed.ray, triangle).has_value();
    wrong["edges"] += contact::intersect_by_edges(aimed.ray, triangle).has_value() != right;
    wrong["dropping"] += contact::intersect_by_dropping(aimed.ray, triangle).has_value() != right;
    wrong["moller-trumbore"] +=
        contact::intersect_moller_trumbore(aimed.ray, triangle).has_value() != right;
    wrong["watertight"] += contact::intersect_watertight(aimed.ray, triangle).has_value() != right;
  }
  for (const auto& [method, count] : wrong) {
    CAPTURE(method, count);
    REQUIRE(count > 500);
  }
}

TEST_CASE("no method turns finite input into NaN, whatever its scale") {
  Random random(41);
  const auto hold = [](const auto& got) {
    if (got) {
      REQUIRE_FALSE(std::isnan(got->t));
      REQUIRE(got->barycentric.allFinite());
    }
  };
  const auto hold_all = [&hold](const auto& line, const auto& triangle) {
    hold(contact::intersect_by_edges(line, triangle));
    hold(contact::intersect_by_dropping(line, triangle));
    hold(contact::intersect_moller_trumbore(line, triangle));
    hold(contact::intersect_watertight(line, triangle));
    hold(contact::intersect_exact(line, triangle));
  };
  for (int i = 0; i < generators::tried(30000); ++i) {
    const adversarial::Case c =
        adversarial::all[static_cast<std::size_t>(i) % adversarial::all.size()](random);
    hold_all(Ray<double>{c.start, c.second}, c.triangle);
    hold_all(Segment<double>{c.start, c.second}, c.triangle);
    const Ray<float> ray = generators::rounded<float>(Ray<double>{c.start, c.second});
    const Triangle<float> triangle = generators::rounded<float>(c.triangle);
    const auto finite = [](const Vector3<float>& v) { return v.allFinite(); };
    if (finite(ray.origin) && finite(ray.direction) && finite(triangle.a) && finite(triangle.b) &&
        finite(triangle.c)) {
      hold_all(ray, triangle);
    }
  }
}

TEST_CASE(
    "zero direction, no area and a line in the plane are no hit for any method; a NaN is none for "
    "the exact one") {
  const Triangle<double> triangle{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  const Triangle<double> line{{0, 0, 0}, {1, 1, 0}, {2, 2, 0}};
  const Triangle<double> dot{{1, 1, 0}, {1, 1, 0}, {1, 1, 0}};
  const auto none = [](const auto& query, const Triangle<double>& t) {
    REQUIRE_FALSE(contact::intersect_by_edges(query, t).has_value());
    REQUIRE_FALSE(contact::intersect_by_dropping(query, t).has_value());
    REQUIRE_FALSE(contact::intersect_moller_trumbore(query, t).has_value());
    REQUIRE_FALSE(contact::intersect_watertight(query, t).has_value());
    REQUIRE_FALSE(contact::intersect_exact(query, t).has_value());
  };
  none(Ray<double>{{1, 1, 0}, {0, 0, 0}}, triangle);
  none(Segment<double>{{1, 1, 0}, {1, 1, 0}}, triangle);
  none(Ray<double>{{-1, 1, 0}, {1, 0, 0}}, triangle);
  none(Segment<double>{{-1, 1, 0}, {5, 1, 0}}, triangle);
  none(Ray<double>{{1, 1, 1}, {0, 0, -1}}, line);
  none(Ray<double>{{1, 1, 1}, {0, 0, -1}}, dot);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  REQUIRE_FALSE(
      contact::intersect_exact(Ray<double>{{1, 1, nan}, {0, 0, -1}}, triangle).has_value());
  REQUIRE_FALSE(contact::intersect_exact(Segment<double>{{1, 1, 1}, {1, 1, -1}},
                                         Triangle<double>{{0, 0, 0}, {4, 0, 0}, {0, nan, 0}})
                    .has_value());
}

TEST_CASE("touching counts from both sides: vertices, edges and the ends of a segment") {
  const Triangle<double> triangle{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  const auto hit = [&triangle](const auto& query, double t) {
    for (const auto& got : {contact::intersect_by_edges(query, triangle),
                            contact::intersect_by_dropping(query, triangle),
                            contact::intersect_moller_trumbore(query, triangle),
                            contact::intersect_watertight(query, triangle),
                            contact::intersect_exact(query, triangle)}) {
      REQUIRE(got.has_value());
      REQUIRE(got->t == t);
    }
  };
  for (const double side : {1.0, -1.0}) {
    hit(Ray<double>{{0, 0, side}, {0, 0, -side}}, 1.0);  // a vertex
    hit(Ray<double>{{2, 2, side}, {0, 0, -2 * side}},
        0.5);  // the long edge; t is in multiples of the direction
    hit(Segment<double>{{1, 1, side}, {1, 1, 0}}, 1.0);  // ends on it
    hit(Segment<double>{{1, 1, 0}, {1, 1, side}}, 0.0);  // starts on it
    hit(Ray<double>{{1, 1, 0}, {0, 0, side}}, 0.0);
  }
}
