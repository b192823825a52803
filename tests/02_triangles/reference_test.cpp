#include <support/generators.hpp>
#include <support/oracle.hpp>

#include <02_triangles/adversarial.hpp>
#include <02_triangles/families.hpp>
#include <02_triangles/truth.hpp>
#include <algorithm>
#include <boost/multiprecision/eigen.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/barycentric.hpp>
#include <contact/exact.hpp>
#include <contact/exact_ray_triangle.hpp>
#include <contact/ray_triangle.hpp>
#include <contact/tolerance.hpp>
#include <contact/watertight.hpp>
#include <limits>
#include <map>
#include <optional>
#include <string>

namespace {

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

constexpr double u = contact::tolerance::unit_roundoff<double>;

bool is_number(const TriangleHit<double>& hit) {
  return !std::isnan(hit.t) && hit.barycentric.allFinite();
}

Rational absolute(const Rational& x) { return x < 0 ? Rational(-x) : x; }
Vector absolute(const Vector& v) { return {absolute(v.x()), absolute(v.y()), absolute(v.z())}; }

/// p·(q × r) with every term made positive.
Rational sum_of_terms(const Vector& p, const Vector& q, const Vector& r) {
  const Vector a = absolute(p), b = absolute(q), c = absolute(r);
  return a.x() * (b.y() * c.z() + b.z() * c.y()) + a.y() * (b.z() * c.x() + b.x() * c.z()) +
         a.z() * (b.x() * c.y() + b.y() * c.x());
}
Rational determinant(const Vector& p, const Vector& q, const Vector& r) {
  return p.dot(q.cross(r));
}

/// The quantities of a query, exactly, and the sums of their terms: what every bound below is made
/// of.
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
    // As Möller and Trumbore measure them, from corner a: of_b = d·(−a × ac)…, so that the terms
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

}  // namespace

// ------------------------------------------------------------------------------------------
// barycentric coordinates

TEST_CASE("the flat cross product of what is left is the dropped coordinate of the cross product") {
  Random random(1);
  for (int i = 0; i < 3000; ++i) {
    const auto p = oracle::exact(generators::point(random, Family::random));
    const auto q = oracle::exact(generators::point(random, Family::random));
    const Vector full = p.cross(q);
    for (int k = 0; k < 3; ++k) {
      REQUIRE(contact::cross2<Rational>(contact::drop_dimension(p, k),
                                        contact::drop_dimension(q, k)) == full[k]);
    }
    const int largest = contact::largest_dimension(full);
    for (int k = 0; k < 3; ++k) REQUIRE(absolute(full[largest]) >= absolute(full[k]));
  }
}

TEST_CASE("weights put the point back together, exactly in rational arithmetic") {
  Random random(2);
  for (const Family family : generators::all_families) {
    for (int i = 0; i < 200; ++i) {
      const Triangle<Rational> triangle = oracle::exact(generators::triangle(random, family));
      const Vector normal = (triangle.b - triangle.a).cross(triangle.c - triangle.a);
      const Rational s(random.integer(-8, 8), 4), t(random.integer(-8, 8), 4);
      const Vector point =
          triangle.a + s * (triangle.b - triangle.a) + t * (triangle.c - triangle.a);
      const auto weights = contact::barycentric(point, triangle);
      REQUIRE(weights.has_value() == (normal.dot(normal) != 0));
      if (!weights) continue;
      REQUIRE(weights->x() + weights->y() + weights->z() == 1);
      REQUIRE(weights->y() == s);
      REQUIRE(weights->z() == t);
      REQUIRE(contact::interpolate(*weights, triangle.a, triangle.b, triangle.c) == point);
      REQUIRE(contact::inside(*weights) == (s >= 0 && t >= 0 && s + t <= 1));
    }
  }
}

TEST_CASE("weights in double are within their bound") {
  // w_b = (x × e2)/(e1 × e2) in two dimensions: a term of either takes two entries, a product and a
  // difference, four roundings; with the quotient c = 6 holds all of it by the argument at
  // quotient_bound. The sum for w_a adds two.
  Random random(3);
  int judged = 0;
  for (int i = 0; i < 4000; ++i) {
    const Family family =
        generators::all_families[static_cast<std::size_t>(i) % generators::all_families.size()];
    const Triangle<double> triangle = generators::proper_triangle(random, family);
    const Vector3<double> point = generators::point(random, Family::coplanar, triangle);
    const Triangle<Rational> exact = oracle::exact(triangle);
    const Vector normal = (exact.b - exact.a).cross(exact.c - exact.a);
    const auto got = contact::barycentric(point, triangle);
    if (!got) continue;
    const Vector3<double> ab = triangle.b - triangle.a, ac = triangle.c - triangle.a;
    const int k = contact::largest_dimension(Vector3<double>(ab.cross(ac)));
    const auto drop = [k](const Vector& v) { return contact::drop_dimension(v, k); };
    const auto terms = [](const contact::Vector2<Rational>& p,
                          const contact::Vector2<Rational>& q) -> Rational {
      return absolute(Rational(p.x() * q.y())) + absolute(Rational(p.y() * q.x()));
    };
    const Vector xv = oracle::exact(point) - exact.a;
    const contact::Vector2<Rational> x = drop(xv), e1 = drop(Vector(exact.b - exact.a)),
                                     e2 = drop(Vector(exact.c - exact.a));
    const Rational area = contact::cross2(e1, e2);
    if (absolute(area) <= 6 * 1024 * oracle::exact(u) * terms(e1, e2)) continue;
    const Rational w_b = contact::cross2(x, e2) / area, w_c = contact::cross2(e1, x) / area;
    const Rational scale = 6 * oracle::exact(u) / absolute(area);
    const Rational bound_b = scale * (terms(x, e2) + absolute(w_b) * terms(e1, e2));
    const Rational bound_c = scale * (terms(e1, x) + absolute(w_c) * terms(e1, e2));
    const Rational bound_a =
        bound_b + bound_c + 4 * oracle::exact(u) * (1 + absolute(w_b) + absolute(w_c));
    CAPTURE(generators::name(family), point, triangle.a, triangle.b, triangle.c);
    REQUIRE(oracle::error(got->y(), w_b) <= bound_b);
    REQUIRE(oracle::error(got->z(), w_c) <= bound_c);
    REQUIRE(oracle::error(got->x(), Rational(1 - w_b - w_c)) <= bound_a);
    ++judged;
  }
  REQUIRE(judged > 3000);
}

TEST_CASE(
    "a triangle without area has no weights, and blending gives the corners their own values") {
  const Triangle<double> line{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}};
  REQUIRE_FALSE(contact::barycentric(Vector3<double>(1, 1, 1), line).has_value());
  const Triangle<double> point{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}};
  REQUIRE_FALSE(contact::barycentric(Vector3<double>(1, 2, 3), point).has_value());
  const Triangle<double> huge{{-1e300, 0, 0}, {1e300, 0, 0}, {0, 1e300, 0}};
  REQUIRE_FALSE(
      contact::barycentric(Vector3<double>(0, 0, 0), huge).has_value());  // the area overflows
  const Triangle<double> large{{0, 0, 0}, {1e200, 0, 0}, {0, 1e200, 0}};  // finite edges, and still
  REQUIRE_FALSE(contact::barycentric(Vector3<double>(1, 1, 0), large).has_value());

  const Triangle<double> triangle{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  const auto at_corner = contact::barycentric(triangle.b, triangle);
  REQUIRE(at_corner.has_value());
  REQUIRE(contact::interpolate(*at_corner, 10.0, 20.0, 30.0) == 20.0);
}

// ------------------------------------------------------------------------------------------ the
// three plain methods

namespace {

/// How far a decision of a plain method is from the nearest wrong one: all of these must be beyond
/// rounding.
///
/// The methods that form the point x = o + t d first carry its error into the edges. With e_t the
/// bound on t, each coordinate of x is off by e_t|d| + 3u(|o| + |t d|), and a weight, a quotient of
/// areas over the normal squared, moves by that times |edge||n|/n², plus its own rounding. `safe`
/// takes eight times the sum as the distance that no rounding here covers.
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

/// One method held against the truth: its decision where rounding cannot reach it, its t within the
/// bound, never a NaN.
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
  // underflow, so the bounds hold; edge tests multiply four, and the hard cases show what becomes
  // of that.
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

TEST_CASE("edge tests decide beyond their rounding, with t inside its bound") {
  hold_plain_on_families(
      [](const auto& line, const auto& t) { return contact::intersect_by_edges(line, t); }, true,
      11, false);
}

TEST_CASE("the dropped dimension decides beyond its rounding, with t inside its bound") {
  hold_plain_on_families(
      [](const auto& line, const auto& t) { return contact::intersect_by_dropping(line, t); }, true,
      12, true);
}

TEST_CASE("Möller-Trumbore decides beyond its rounding, with t and weights inside their bounds") {
  hold_plain_on_families(
      [](const auto& line, const auto& t) { return contact::intersect_moller_trumbore(line, t); },
      false, 13, true);
}

TEST_CASE("in rational arithmetic the plain methods are exact") {
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

// ------------------------------------------------------------------------------------------
// watertight

TEST_CASE(
    "the flat cross product has the right sign for every pair of doubles that does not over- or "
    "underflow") {
  Random random(21);
  int ties = 0;
  for (int i = 0; i < 20000; ++i) {
    const auto near_one = [&] {
      return 1.0 + random.integer(-4, 4) * std::numeric_limits<double>::epsilon();
    };
    const auto wide = [&] { return random.magnitude(-200, 200); };
    contact::Vector2<double> p{i % 2 == 0 ? near_one() : wide(), 0},
        q{i % 2 == 0 ? near_one() : wide(), 0};
    p.y() = i % 2 == 0 ? near_one() : wide();
    q.y() = i % 2 == 0 ? near_one() : wide();
    const Rational right =
        oracle::exact(p.x()) * oracle::exact(q.y()) - oracle::exact(p.y()) * oracle::exact(q.x());
    const double got = contact::cross2_right_sign(p, q);
    REQUIRE((got > 0) - (got < 0) == oracle::sign(right));
    REQUIRE(contact::cross2_right_sign(q, p) == -got);
    ties += p.x() * q.y() == p.y() * q.x() && right != 0;
  }
  REQUIRE(ties > 500);  // the plain difference would have said 0
}

namespace {

/// Of the rays aimed between two triangles, those that a method sees pass through neither.
template <class S, class Method>
int leaks(int rays, std::uint64_t seed, const Method& method) {
  Random random(seed);
  int leaked = 0;
  for (int i = 0; i < rays; ++i) {
    const families::Aimed aimed = families::at_shared_edge(random);
    const Ray<S> ray = generators::rounded<S>(aimed.ray);
    const bool hit = method(ray, generators::rounded<S>(aimed.triangles[0])).has_value() ||
                     method(ray, generators::rounded<S>(aimed.triangles[1])).has_value();
    leaked += !hit;
  }
  return leaked;
}

const auto watertight = [](const auto& ray, const auto& t) {
  return contact::intersect_watertight(ray, t);
};

}  // namespace

TEST_CASE("between two triangles there is no gap for the exact test, so a miss is a leak") {
  REQUIRE(leaks<float>(20000, 22, [](const auto& ray, const auto& t) {
            return contact::intersect_exact(ray, t);
          }) == 0);
}

TEST_CASE("of a million rays between two triangles, the watertight test in float leaks none") {
  REQUIRE(leaks<float>(1000000, 23, watertight) == 0);
}

TEST_CASE("the watertight test in double leaks none") {
  REQUIRE(leaks<double>(200000, 24, watertight) == 0);
}

TEST_CASE("the plain methods in float do leak, at about the rate that the ladder shows") {
  const auto by_edges = [](const auto& ray, const auto& t) {
    return contact::intersect_by_edges(ray, t);
  };
  const auto by_dropping = [](const auto& ray, const auto& t) {
    return contact::intersect_by_dropping(ray, t);
  };
  const auto moller = [](const auto& ray, const auto& t) {
    return contact::intersect_moller_trumbore(ray, t);
  };
  const int of_edges = leaks<float>(20000, 25, by_edges);
  const int of_dropping = leaks<float>(20000, 25, by_dropping);
  const int of_moller = leaks<float>(20000, 25, moller);
  UNSCOPED_INFO("leaks of 20000: edge tests " << of_edges << ", dropped dimension " << of_dropping
                                              << ", Möller-Trumbore " << of_moller);
  REQUIRE(of_edges > 1000);
  REQUIRE(of_dropping > 1000);
  REQUIRE(of_moller > 500);
}

TEST_CASE("a closed mesh takes every ray that starts inside it") {
  // An octahedron, moved off the origin and slightly bent, so that nothing about it is exact. Rays
  // from inside are aimed at its corners and edges, where a crack would be.
  Random random(26);
  for (int round = 0; round < 400; ++round) {
    std::array<Vector3<float>, 6> corners;
    const Vector3<float> centre = 8 * families::random_point(random);
    for (std::size_t i = 0; i < 6; ++i) {
      Vector3<float> axis = Vector3<float>::Zero();
      axis(static_cast<Eigen::Index>(i / 2)) = i % 2 == 0 ? 1.0f : -1.0f;
      corners[i] = centre + axis + 0.2f * families::random_point(random);
    }
    for (int shot = 0; shot < 50; ++shot) {
      const auto one = static_cast<std::size_t>(random.integer(0, 5));
      auto other = static_cast<std::size_t>(random.integer(0, 5));
      if (other / 2 == one / 2) other = (other + 2) % 6;
      const double share = random.chance(0.3) ? 0.0 : random.uniform();
      const Vector3<float> origin = centre + 0.1f * families::random_point(random);
      const Ray<float> ray =
          families::towards(origin, families::between(corners[one], corners[other], share));
      bool hit = false;
      for (std::size_t x = 0; x < 2; ++x) {
        for (std::size_t y = 2; y < 4; ++y) {
          for (std::size_t z = 4; z < 6; ++z) {
            hit = hit || contact::intersect_watertight(
                             ray, Triangle<float>{corners[x], corners[y], corners[z]});
          }
        }
      }
      REQUIRE(hit);
    }
  }
}

TEST_CASE("the watertight test decides beyond its rounding, with t inside its bound") {
  // The sheared x of a corner is x − (d_x/d_z) z: at most four roundings a term. An edge function
  // multiplies two such, five more with its difference; sum, quotient, z, product, sum of three and
  // the last division bring it to less than 20. The terms are those of the sheared products.
  Random random(27);
  const Rational c = 20 * oracle::exact(u);
  int values = 0, decided = 0;
  for (int i = 0; i < 8000; ++i) {
    const Family family =
        generators::all_families[static_cast<std::size_t>(i) % generators::all_families.size()];
    const Triangle<double> triangle = generators::proper_triangle(random, family);
    const Ray<double> ray = generators::ray(random, family, triangle);
    if (ray.direction.isZero(0)) continue;
    const auto got = contact::intersect_watertight(ray, triangle);
    const auto right = truth::meet(ray, triangle);

    const Vector o = oracle::exact(ray.origin), d = oracle::exact(ray.direction);
    const int z = contact::largest_dimension(ray.direction), x = (z + 1) % 3, y = (z + 2) % 3;
    const Triangle<Rational> exact = oracle::exact(triangle);
    std::array<contact::Vector2<Rational>, 3> seen, size;
    std::array<Rational, 3> depth;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector p = (k == 0 ? exact.a : k == 1 ? exact.b : exact.c) - o;
      const Rational shift_x = d[x] / d[z] * p[z], shift_y = d[y] / d[z] * p[z];
      seen[k] = {p[x] - shift_x, p[y] - shift_y};
      size[k] = {absolute(p[x]) + absolute(shift_x), absolute(p[y]) + absolute(shift_y)};
      depth[k] = p[z] / d[z];
    }
    Rational sum = 0, sum_terms = 0, t = 0, t_terms = 0;
    bool clear = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t m = (k + 1) % 3, n = (k + 2) % 3;
      const Rational edge = contact::cross2(seen[m], seen[n]);
      const Rational terms = size[m].x() * size[n].y() + size[m].y() * size[n].x();
      clear = clear && absolute(edge) > c * terms;
      sum += edge;
      sum_terms += terms;
      t += edge * depth[k];
      t_terms += terms * absolute(depth[k]);
    }
    if (absolute(sum) <= 1024 * c * sum_terms) continue;
    t /= sum;
    const Rational bound = c * (t_terms + absolute(t) * sum_terms) / absolute(sum);
    CAPTURE(generators::name(family), i);
    if (clear && absolute(t) > bound) {
      REQUIRE(got.has_value() == right.has_value());
      ++decided;
    }
    if (got && right) {
      REQUIRE(oracle::error(got->t, right->t) <= bound);
      ++values;
    }
  }
  CAPTURE(values, decided);
  REQUIRE(values > 400);
  REQUIRE(decided > 3000);
}

// ------------------------------------------------------------------------------------------ exact

namespace {

struct Count {
  int asked = 0, wrong = 0, hits = 0;
};

/// The exact test's decision and values, with and without its filter.
template <class Line>
void hold_exact(const Line& line, const Triangle<double>& triangle, Count& count) {
  const auto right = truth::meet(line, triangle);
  const auto got = contact::intersect_exact(line, triangle);
  ++count.asked;
  count.hits += right.has_value();
  if (got.has_value() != right.has_value()) {
    ++count.wrong;
    return;
  }
  if (!got) return;
  // 2^-40 max(1, |t|), as documented; beyond the largest double t is infinite.
  const Rational tolerance = Rational(1) / (Rational(1) * (std::int64_t{1} << 40));
  const Rational largest = oracle::exact(std::numeric_limits<double>::max());
  if (std::isinf(got->t)) {
    REQUIRE(right->t > largest);
  } else {
    REQUIRE(got->t >= 0);
    REQUIRE(oracle::error(got->t, right->t) <= tolerance * std::max(Rational(1), right->t));
  }
  REQUIRE(oracle::error(got->barycentric, right->weights) <= tolerance);
  REQUIRE(got->barycentric.minCoeff() >= 0);
  REQUIRE(got->barycentric.maxCoeff() <= 1);
}

}  // namespace

TEST_CASE("the exact test has no wrong answer over adversarial rays and segments") {
  // 17,000 of each of six kinds; half are read as rays and half as segments.
  Random random(31);
  for (std::size_t kind = 0; kind < adversarial::all.size(); ++kind) {
    Count count;
    for (int i = 0; i < generators::tried(17000); ++i) {
      const adversarial::Case c = adversarial::all[kind](random);
      CAPTURE(kind, i);
      if (i % 2 == 0) {
        hold_exact(Ray<double>{c.start, c.second}, c.triangle, count);
      } else {
        hold_exact(Segment<double>{c.start, c.second}, c.triangle, count);
      }
    }
    CAPTURE(kind, count.asked, count.hits);
    REQUIRE(count.wrong == 0);
    REQUIRE(count.hits > generators::tried(100));
  }
}

TEST_CASE("the exact test has no wrong answer over the common families") {
  Random random(32);
  for (const Family family : generators::all_families) {
    Count count;
    for (int i = 0; i < 2000; ++i) {
      const Triangle<double> triangle = generators::triangle(random, family);
      CAPTURE(generators::name(family), i);
      hold_exact(generators::ray(random, family, triangle), triangle, count);
      hold_exact(generators::segment(random, family, triangle), triangle, count);
    }
    CAPTURE(generators::name(family), count.hits);
    REQUIRE(count.wrong == 0);
    REQUIRE(count.hits > 100);
  }
}

TEST_CASE("for floats the exact test has no wrong answer, where float methods have many") {
  Random random(33);
  int asked = 0, wrong = 0, wrong_in_float = 0, wrong_in_double = 0;
  for (int i = 0; i < 6000; ++i) {
    const families::Aimed aimed =
        i % 2 == 0 ? families::at_edge(random) : families::on_grid(random);
    const Triangle<float>& triangle = aimed.triangles[0];
    const bool right = truth::meet(aimed.ray, triangle).has_value();
    const auto got = contact::intersect_exact(aimed.ray, triangle);
    ++asked;
    wrong += got.has_value() != right;
    wrong_in_float += contact::intersect_moller_trumbore(aimed.ray, triangle).has_value() != right;
    wrong_in_double += contact::intersect_moller_trumbore(contact::in_double(aimed.ray),
                                                          contact::in_double(triangle))
                           .has_value() != right;
  }
  CAPTURE(asked, wrong_in_float, wrong_in_double);
  REQUIRE(wrong == 0);
  REQUIRE(wrong_in_float > 1000);
  REQUIRE(wrong_in_double > 200);
}

TEST_CASE("every plain method in float fails on rays aimed at an edge, and the count is recorded") {
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

TEST_CASE("with and without its filter the exact test decides alike, and agrees on t") {
  Random random(35);
  for (int i = 0; i < 6000; ++i) {
    const adversarial::Case c =
        adversarial::all[static_cast<std::size_t>(i) % adversarial::all.size()](random);
    const Ray<double> ray{c.start, c.second};
    const auto filtered = contact::intersect_exact(ray, c.triangle);
    const auto plain = contact::intersect_exact_unfiltered(ray, c.triangle);
    REQUIRE(filtered.has_value() == plain.has_value());
    if (!plain) continue;
    // Without the filter the values are the nearest doubles.
    const auto right = truth::meet(ray, c.triangle);
    REQUIRE(plain->t == oracle::nearest(right->t));
    REQUIRE(plain->barycentric == oracle::nearest(right->weights));
  }
}

TEST_CASE(
    "the filter decides almost everything that is not degenerate, and its bound is never "
    "exceeded") {
  Random random(36);
  int certain = 0;
  for (int i = 0; i < 20000; ++i) {
    const adversarial::Case c =
        adversarial::all[static_cast<std::size_t>(i) % adversarial::all.size()](random);
    const Vector3<double> p = c.triangle.a - c.start, q = c.triangle.b - c.start,
                          r = c.triangle.c - c.start;
    const contact::Bounded bounded = contact::bounded_volume(p, q, r);
    const Vector start = oracle::exact(c.start);
    const Triangle<Rational> exact = oracle::exact(c.triangle);
    const Rational right = determinant(exact.a - start, exact.b - start, exact.c - start);
    if (bounded.certain_sign() != 0) REQUIRE(bounded.certain_sign() == oracle::sign(right));
    if (std::isfinite(bounded.bound))
      REQUIRE(oracle::error(bounded.value, right) <= oracle::exact(bounded.bound));
    certain += bounded.certain_sign() != 0;
  }
  REQUIRE(certain > 4000);
  int undecided = 0;
  for (int i = 0; i < 20000; ++i) {
    const auto draw = [&] { return adversarial::point([&] { return random.uniform(-1, 1); }); };
    const Vector3<double> p = draw(), q = draw(), r = draw();
    undecided += contact::bounded_volume(p, q, r).certain_sign() == 0;
  }
  REQUIRE(undecided == 0);
}

// ------------------------------------------------------------------------------------------ all of
// them

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

TEST_CASE("touching counts from both sides: corners, edges and the ends of a segment") {
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
    hit(Ray<double>{{0, 0, side}, {0, 0, -side}}, 1.0);  // a corner
    hit(Ray<double>{{2, 2, side}, {0, 0, -2 * side}},
        0.5);  // the long edge; t counts lengths of the direction
    hit(Segment<double>{{1, 1, side}, {1, 1, 0}}, 1.0);  // ends on it
    hit(Segment<double>{{1, 1, 0}, {1, 1, side}}, 0.0);  // starts on it
    hit(Ray<double>{{1, 1, 0}, {0, 0, side}}, 0.0);
  }
}
