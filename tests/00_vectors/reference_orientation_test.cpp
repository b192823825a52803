// orientation.hpp and filter.hpp against rational arithmetic.
#include <00_vectors/hard_points.hpp>
#include <boost/multiprecision/eigen.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/orientation.hpp>
#include <limits>
#include <support/generators.hpp>
#include <support/oracle.hpp>

namespace orientation_test {

using contact::Vector2;
using contact::Vector3;
using oracle::Rational;
constexpr double infinity = std::numeric_limits<double>::infinity();

Rational right_volume(const Vector3<double>& a, const Vector3<double>& b, const Vector3<double>& c,
                      const Vector3<double>& d) {
  return contact::signed_volume<Rational>(oracle::exact(a), oracle::exact(b), oracle::exact(c),
                                          oracle::exact(d));
}

/// The bound of a filter holds, and a sign that it calls certain is right.
void require_bound(const contact::Bounded& bounded, const Rational& right) {
  if (std::isfinite(bounded.bound))
    REQUIRE(oracle::error(bounded.value, right) <= oracle::exact(bounded.bound));
  if (bounded.certain_sign() != 0) REQUIRE(bounded.certain_sign() == oracle::sign(right));
}

TEST_CASE("orientation predicates have the sign that fractions give, on every kind of input") {
  generators::Random random(1);
  int zeros = 0, doubts = 0;
  for (int i = 0; i < 8000; ++i) {
    const int kind = i % hard_points::kKinds;
    const auto draw = [&] { return hard_points::draw(random, kind); };
    const Vector3<double> a = draw(), b = draw(), c = draw(), d = draw();
    const Rational volume = right_volume(a, b, c, d);
    const int right = oracle::sign(volume);
    REQUIRE(contact::orient_3d(a, b, c, d) == right);
    REQUIRE(contact::orient_3d_exactly(a, b, c, d) == right);
    REQUIRE(contact::orient_3d_in_doubt(a, b, c, d) == right);
    const contact::Bounded bounded = contact::bounded_volume(d - a, b - a, c - a);
    require_bound(bounded, volume);
    zeros += right == 0;
    doubts += bounded.certain_sign() == 0;
    for (int k = 0; k < 3; ++k) {
      const auto flat = [&](const Vector3<double>& v) {
        return contact::drop_dimension<double>(v, k);
      };
      const auto exact = [&](const Vector3<double>& v) {
        return contact::drop_dimension<Rational>(oracle::exact(v), k);
      };
      const Rational area = contact::orientation<Rational>(exact(a), exact(b), exact(c));
      REQUIRE(contact::orient_2d(flat(a), flat(b), flat(c)) == oracle::sign(area));
      REQUIRE(contact::orient_2d_exactly(flat(a), flat(b), flat(c)) == oracle::sign(area));
      REQUIRE(contact::orient_2d_in_doubt(flat(a), flat(b), flat(c)) == oracle::sign(area));
      require_bound(contact::bounded_orientation(flat(a), flat(b), flat(c)), area);
    }
  }
  // Guard: many signs are exactly 0, and many cannot be decided by the filter.
  REQUIRE(zeros > 500);
  REQUIRE(doubts > zeros);
}

TEST_CASE("a projection that keeps an orientation exists unless three points are collinear") {
  generators::Random random(2);
  int collinear = 0;
  for (int i = 0; i < 4000; ++i) {
    const int kind = i % hard_points::kKinds;
    const auto draw = [&] { return hard_points::draw(random, kind); };
    const Vector3<double> a = draw(), b = draw(), c = i % 5 == 0 ? b : draw();
    const oracle::Vector normal =
        (oracle::exact(b) - oracle::exact(a)).cross(oracle::exact(c) - oracle::exact(a));
    const bool flat = normal.dot(normal) == 0;
    REQUIRE(contact::are_collinear(a, b, c) == flat);
    const contact::FlatView view = contact::flat_view(a, b, c);
    REQUIRE((view.orientation == 0) == flat);
    REQUIRE(view.orientation == oracle::sign(normal[view.dropped]));
    collinear += flat;
  }
  REQUIRE(collinear > 800);
}

TEST_CASE("a filter that overflows calls no sign certain") {
  const Vector3<double> far(1e200, 0, 0), up(0, 1e200, 0), out(0, 0, 1e200);
  REQUIRE(contact::bounded_volume(far, up, out).certain_sign() == 0);
  REQUIRE(contact::bounded_volume(far, up, Vector3<double>(0, 0, infinity)).certain_sign() == 0);
  const Vector2<double> a(-1e300, 0), b(1e300, 0), c(0, 1e300);
  REQUIRE(contact::bounded_orientation(a, b, c).certain_sign() == 0);
  REQUIRE(contact::orient_2d(a, b, c) == 1);
  REQUIRE(contact::orient_3d(Vector3<double>::Zero(), far, up, out) == 1);
}

}  // namespace orientation_test
