// barycentric.hpp against rational arithmetic.
#include <02_triangles/adversarial.hpp>
#include <02_triangles/families.hpp>
#include <02_triangles/truth.hpp>
#include <boost/multiprecision/eigen.hpp>
#include <catch2/catch_test_macros.hpp>
#include <contact/barycentric.hpp>
#include <support/generators.hpp>
#include <support/oracle.hpp>

#include "reference.hpp"

using contact::Triangle;
using contact::Vector3;
using generators::Family;
using generators::Random;
using oracle::Rational;
using oracle::Vector;
using reference::absolute;
using reference::u;

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
    "a triangle without area has no weights, and blending gives the vertices their own values") {
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
