// The references against rational arithmetic on the stored numbers (class (a) of the oracle), the
// angle against intervals (class (c)). u is the unit roundoff of the type. A bound stated in a
// comment of the reference is tested exactly, without an allowance.
#include <array>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/angle.hpp>
#include <contact/arc.hpp>
#include <contact/error_free.hpp>
#include <contact/frame.hpp>
#include <contact/orientation.hpp>
#include <contact/products.hpp>
#include <limits>
#include <stdexcept>

#include "support/generators.hpp"
#include "support/oracle.hpp"
#include "support/rounding.hpp"

using contact::Vector2;
using contact::Vector3;
using generators::any_finite;
using generators::Random;
using oracle::Rational;
using rounding::eta;
using rounding::gamma;
using rounding::nearest;
using rounding::u;

namespace {

template <class S>
Rational smallest_normal() {
  return oracle::exact(std::numeric_limits<S>::min());
}

/// A vector of a family of generators::point, stored in S; or one without a pattern.
template <class S>
Vector3<S> any_vector(Random& random, int kind) {
  if (kind == 0)
    return Vector3<S>{any_finite<S>(random), any_finite<S>(random), any_finite<S>(random)};
  if (kind == 1) {
    return Vector3<S>{S(random.integer(-4, 4)), S(random.integer(-4, 4)), S(random.integer(-4, 4))};
  }
  return Vector3<S>{S(random.uniform(-1, 1)), S(random.uniform(-1, 1)), S(random.uniform(-1, 1))};
}

/// A second vector beside u: arbitrary, nearly parallel, or nearly perpendicular.
template <class S>
Vector3<S> beside(Random& random, int kind, const Vector3<S>& a) {
  const int relation = random.integer(0, 2);
  const auto small = [&] { return static_cast<S>(random.magnitude(-60, -1)); };
  if (relation == 0 || kind == 0) return any_vector<S>(random, kind);
  const S factor = static_cast<S>(random.uniform(-2, 2));
  if (relation == 1) {
    return Vector3<S>{factor * a.x() + small(), factor * a.y() + small(), factor * a.z()};
  }
  return Vector3<S>{-a.y() + small(), a.x(), small()};
}

template <class S>
Rational size_of_products(const Vector3<S>& a, const Vector3<S>& b) {
  const auto ra = oracle::exact(a);
  const auto rb = oracle::exact(b);
  return abs(ra.x() * rb.x()) + abs(ra.y() * rb.y()) + abs(ra.z() * rb.z());
}

/// |got - right| ≤ bound, without rounding; and got is finite.
template <class S>
bool within(S got, const Rational& right, const Rational& bound) {
  return std::isfinite(got) && abs(oracle::exact(got) - right) <= bound;
}

}  // namespace

TEMPLATE_TEST_CASE("an ulp is the distance to the next larger number", "", float, double) {
  using S = TestType;
  const S infinity = std::numeric_limits<S>::infinity();
  Random random(1);
  for (int i = 0; i < 3000; ++i) {
    const S x = std::abs(any_finite<S>(random));
    if (x == std::numeric_limits<S>::max()) continue;
    CHECK(contact::ulp(x) == std::nextafter(x, infinity) - x);
    CHECK(contact::ulp(-x) == contact::ulp(x));
  }
  const S smallest = std::numeric_limits<S>::denorm_min();
  CHECK(contact::ulp(S(0)) == smallest);
  CHECK(contact::ulp(smallest) == smallest);
  CHECK(contact::ulp(std::numeric_limits<S>::min()) == smallest);
  CHECK(contact::ulp(2 * std::numeric_limits<S>::min()) == 2 * smallest);
  CHECK(contact::ulp(S(1)) == std::numeric_limits<S>::epsilon());
  const S largest = std::numeric_limits<S>::max();
  CHECK(contact::ulp(largest) == largest - std::nextafter(largest, S(0)));
  CHECK(contact::ulp(-infinity) == infinity);
  CHECK(std::isnan(contact::ulp(std::numeric_limits<S>::quiet_NaN())));
}

TEMPLATE_TEST_CASE("a rounded sum and its error add up to the exact sum", "", float, double) {
  using S = TestType;
  Random random(2);
  for (int i = 0; i < 3000; ++i) {
    const bool near = i % 2 == 0;
    const S a = near ? static_cast<S>(random.magnitude(-30, 30)) : any_finite<S>(random);
    const S b = near ? static_cast<S>(random.magnitude(-30, 30)) : any_finite<S>(random);
    const auto sum = contact::two_sum(a, b);
    if (!std::isfinite(sum.value)) continue;
    CHECK(sum.value == a + b);
    CHECK(oracle::exact(sum.value) + oracle::exact(sum.error) ==
          oracle::exact(a) + oracle::exact(b));
  }
}

TEMPLATE_TEST_CASE("a rounded product and its error add up to the exact product", "", float,
                   double) {
  using S = TestType;
  const Rational safe =
      oracle::exact(std::ldexp(std::numeric_limits<S>::min(), std::numeric_limits<S>::digits));
  Random random(3);
  int seen = 0;
  for (int i = 0; i < 6000; ++i) {
    const S a = any_finite<S>(random);
    const S b = any_finite<S>(random);
    const auto product = contact::two_product(a, b);
    if (!std::isfinite(product.value)) continue;
    const Rational right = oracle::exact(a) * oracle::exact(b);
    const Rational got = oracle::exact(product.value) + oracle::exact(product.error);
    if (abs(right) >= safe) {
      CHECK(got == right);
      ++seen;
    } else {
      CHECK(abs(got - right) <= eta<S>() / 2);
    }
  }
  CHECK(seen > 1000);
}

TEMPLATE_TEST_CASE("errors of dot products are within their bounds", "", float, double) {
  using S = TestType;
  Random random(4);
  int rescued = 0;
  for (int i = 0; i < 4000; ++i) {
    const int kind = i % 4;
    const Vector3<S> a = any_vector<S>(random, kind);
    const Vector3<S> b = beside<S>(random, kind, a);
    const Rational right = oracle::exact(a).dot(oracle::exact(b));
    const Rational size = size_of_products(a, b);
    const S exactly = contact::dot_exactly(a, b);
    CHECK(exactly == nearest<S>(right));
    const S accurately = contact::dot_accurately(a, b);
    if (!std::isfinite(exactly)) continue;
    if (abs(right) >= 2 * smallest_normal<S>()) {
      CHECK(within(accurately, right, 3 * u<S>() * abs(right)));
      CHECK(std::signbit(accurately) == (right < 0));
    } else {
      CHECK(accurately == exactly);
    }
    if (size > oracle::exact(std::numeric_limits<S>::max()) / 8) continue;
    CHECK(within(contact::dot_recursive(a, b), right, gamma<S>(3) * size + 2 * eta<S>()));
    CHECK(within(contact::dot_compensated(a, b), right,
                 u<S>() * abs(right) + gamma<S>(3) * gamma<S>(3) * size + 4 * eta<S>()));
    rescued += contact::dot_recursive(a, b) != accurately;
  }
  CHECK(rescued > 100);
}

TEST_CASE("a sum is a dot product with ones") {
  Eigen::VectorXd terms(3);
  terms << 1, 1e100, -1e100;
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(3);
  CHECK(contact::dot_recursive(terms, ones) == 0);
  CHECK(contact::dot_compensated(terms, ones) == 1);
  CHECK(contact::dot_accurately(terms, ones) == 1);
  const Eigen::VectorXd none(0);
  CHECK(contact::dot_recursive(none, none) == 0);
  CHECK(contact::dot_compensated(none, none) == 0);
  CHECK(contact::dot_accurately(none, none) == 0);
  Random random(5);
  for (int n : {2, 10, 100}) {
    Eigen::VectorXd x(n);
    Rational right = 0;
    for (int i = 0; i < n; ++i) {
      x[i] = random.magnitude(-30, 30);
      right += oracle::exact(x[i]);
    }
    CHECK(within(contact::dot_accurately<double, Eigen::Dynamic>(x, Eigen::VectorXd::Ones(n)),
                 right, 3 * u<double>() * abs(right)));
  }
}

TEMPLATE_TEST_CASE("errors of cross products are within their bounds", "", float, double) {
  using S = TestType;
  Random random(6);
  int rescued = 0;
  for (int i = 0; i < 4000; ++i) {
    const int kind = i % 4;
    const Vector3<S> a = any_vector<S>(random, kind);
    const Vector3<S> b = beside<S>(random, kind, a);
    const oracle::Vector right = oracle::exact(a).cross(oracle::exact(b));
    const Vector3<S> exactly = contact::cross_exactly(a, b);
    const Vector3<S> accurately = contact::cross_accurately(a, b);
    const Vector3<S> reversed = contact::cross_accurately(b, a);
    const Vector3<S> in_order = contact::cross_plain(a, b);
    for (int k = 0; k < 3; ++k) {
      const int next = (k + 1) % 3;
      const int last = (k + 2) % 3;
      CHECK(exactly[k] == nearest<S>(right[k]));
      if (!std::isfinite(exactly[k])) continue;
      if (abs(right[k]) >= 2 * smallest_normal<S>()) {
        CHECK(within(accurately[k], right[k], 2 * u<S>() * abs(right[k])));
        CHECK(within(reversed[k], -right[k], 2 * u<S>() * abs(right[k])));
      } else {
        CHECK(accurately[k] == exactly[k]);
      }
      const Rational size = abs(oracle::exact(a[next]) * oracle::exact(b[last])) +
                            abs(oracle::exact(a[last]) * oracle::exact(b[next]));
      if (size > oracle::exact(std::numeric_limits<S>::max()) / 8) continue;
      CHECK(within(in_order[k], right[k], gamma<S>(2) * size + eta<S>()));
      rescued += in_order[k] != accurately[k];
    }
  }
  CHECK(rescued > 100);
}

TEST_CASE(
    "a cross product is perpendicular to its factors, antisymmetric, and as long as the area") {
  // Whole numbers: nothing is rounded, so the laws hold exactly for every method.
  Random random(7);
  for (int i = 0; i < 500; ++i) {
    const auto a = any_vector<double>(random, 1);
    const auto b = any_vector<double>(random, 1);
    const Vector3<double> n = contact::cross_accurately(a, b);
    CHECK(n == contact::cross_plain(a, b));
    CHECK(n == Vector3<double>(a.cross(b)));
    CHECK(contact::cross_accurately(b, a) == -n);
    CHECK(contact::dot_accurately(n, a) == 0);
    CHECK(contact::dot_accurately(n, b) == 0);
    // Lagrange: |a × b|² + (a · b)² = |a|² |b|².
    const double dot = contact::dot_accurately(a, b);
    CHECK(contact::dot_accurately(n, n) + dot * dot ==
          contact::dot_accurately(a, a) * contact::dot_accurately(b, b));
    CHECK(contact::cross_accurately(a, Vector3<double>(2 * a)) == Vector3<double>(0, 0, 0));
  }
}

TEST_CASE("the orientation predicate is exact") {
  Random random(8);
  int expanded_wrong = 0;
  for (int i = 0; i < 3000; ++i) {
    const Vector2<double> a{random.uniform(), random.uniform()};
    const Vector2<double> b{random.uniform(8, 9), random.uniform(8, 9)};
    const double share = random.uniform();
    const double nudge = i % 3 == 0 ? random.magnitude(-56, -50) : 0;
    const Vector2<double> p{a.x() + share * (b.x() - a.x()),
                            a.y() + share * (b.y() - a.y()) + nudge};
    const auto exact = [](const Vector2<double>& v) {
      return contact::Vector2<Rational>(oracle::exact(v.x()), oracle::exact(v.y()));
    };
    const Rational right = contact::orientation(exact(a), exact(b), exact(p));
    CHECK(right == contact::orientation_expanded(exact(a), exact(b), exact(p)));
    CHECK(contact::orient_2d_exactly(a, b, p) == oracle::sign(right));
    CHECK(contact::orient_2d_exactly(b, a, p) == -oracle::sign(right));
    CHECK(contact::orient_2d_exactly(b, p, a) == oracle::sign(right));
    const double size =
        std::abs((b.x() - a.x()) * (p.y() - a.y())) + std::abs((b.y() - a.y()) * (p.x() - a.x()));
    CHECK(within(contact::orientation(a, b, p), right,
                 gamma<double>(5) * oracle::exact(size) * (1 + 8 * u<double>())));
    const double expanded = contact::orientation_expanded(a, b, p);
    expanded_wrong += (expanded > 0) - (expanded < 0) != oracle::sign(right);
  }
  CHECK(expanded_wrong > 300);
  CHECK(contact::orient_2d_exactly({0, 0}, {1, 0}, {0, 1}) == 1);
  CHECK(contact::orient_2d_exactly({3, 4}, {3, 4}, {0, 1}) == 0);
}

TEMPLATE_TEST_CASE("the error of an angle is within its bound", "", float, double) {
  using S = TestType;
  using oracle::Interval;
  Random random(9);
  for (int i = 0; i < 400; ++i) {
    const int kind = i % 4;
    const Vector3<S> a = any_vector<S>(random, kind);
    const Vector3<S> b = beside<S>(random, kind, a);
    const auto got = contact::angle_between(a, b);
    const Vector3<S> zero(0, 0, 0);
    REQUIRE(got.has_value() == (a != zero && b != zero));
    if (!got) continue;
    const oracle::Vector n = oracle::exact(a).cross(oracle::exact(b));
    const Rational cosine = oracle::exact(a).dot(oracle::exact(b));
    const Rational sine_squared = n.dot(n);
    const auto angle = [&](unsigned bits) {
      if (cosine == 0) return Interval::pi(bits) * Interval(Rational(1) / 2, bits);
      const Interval acute = atan(sqrt(Interval(sine_squared, bits)) / Interval(abs(cosine), bits));
      return cosine > 0 ? acute : Interval::pi(bits) - acute;
    };
    const Interval truth = angle(256);
    const Rational room = 12 * u<S>() * truth.high() + eta<S>();
    CHECK(abs(oracle::exact(*got) - truth.low()) <= room);
    CHECK(*got >= S(0));
  }
  const S infinity = std::numeric_limits<S>::infinity();
  const S tiny = std::numeric_limits<S>::min();
  CHECK(contact::angle_between<S>({1, 0, 0}, {1, tiny, 0}) == tiny);
  CHECK(contact::angle_between<S>({tiny, 0, 0}, {0, std::numeric_limits<S>::max(), 0}) ==
        std::atan2(S(1), S(0)));
  CHECK(contact::angle_between<S>({2, 4, -6}, {1, 2, -3}) == S(0));
  CHECK(*contact::angle_between<S>({2, 4, -6}, {-1, -2, 3}) < infinity);
}

TEST_CASE("the error of an angle by half angles is within its bound") {
  using oracle::Interval;
  Random random(12);
  const auto check = [](double across, double along) {
    INFO(across << " across, " << along << " along");
    const Rational y = oracle::exact(across), x = oracle::exact(along);
    const auto angle = [&](unsigned bits) {
      if (x == 0) return Interval::pi(bits) * Interval(Rational(1) / 2, bits);
      const Interval acute = atan(Interval(Rational(y / abs(x)), bits));
      return x > 0 ? acute : Interval::pi(bits) - acute;
    };
    const Interval truth = angle(1200);  // enough for a sine of 2^-1074 beside π
    const Rational room = 16 * u<double>() * truth.high() + 4 * eta<double>();
    REQUIRE(within(contact::portable_angle(across, along), truth.low(), room));
  };
  for (int i = 0; i < generators::tried(2000); ++i) {
    const double across = random.magnitude(-30, 30);
    double along = i % 4 == 0 ? random.magnitude(-30, 30) : across * random.uniform(0.2, 5);
    if (i % 3 == 0) along = -along;
    check(std::abs(across), along);
  }
  const double huge = std::numeric_limits<double>::max();
  const double tiny = std::numeric_limits<double>::denorm_min();
  for (const double across : {0.0, tiny, 1.0, huge}) {
    for (const double along : {-huge, -1.0, -tiny, 0.0, tiny, 1.0, huge}) {
      if (across != 0 || along != 0) check(across, along);
    }
  }
  CHECK(contact::portable_angle(0, 0) == 0);
  CHECK(contact::portable_angle(0, -3) == std::atan2(0.0, -3.0));
}

TEMPLATE_TEST_CASE("a frame on a normal is orthonormal and right-handed", "", float, double) {
  using S = TestType;
  Random random(10);
  for (int i = 0; i < 1500; ++i) {
    Vector3<S> n = any_vector<S>(random, i % 3);
    if (n == Vector3<S>(0, 0, 0)) n = Vector3<S>(0, 0, -1);
    if (i % 7 == 0 && n.x() != S(0)) n.z() = S(-1e6) * std::abs(n.x());
    if (!contact::all_finite(n)) continue;
    const auto frame = contact::frame_on_normal<S>(Vector3<S>(1, 2, 3), n);
    CHECK(frame.origin == Vector3<S>(1, 2, 3));
    const Eigen::Matrix<S, 3, 3>& axes = frame.axes;
    const auto column = [&](int k) { return oracle::exact(Vector3<S>(axes.col(k))); };
    for (int j = 0; j < 3; ++j) {
      for (int k = 0; k < 3; ++k) {
        CHECK(abs(column(j).dot(column(k)) - (j == k ? 1 : 0)) <= 32 * u<S>());
      }
    }
    CHECK(column(0).cross(column(1)).dot(column(2)) > Rational(99) / 100);
    CHECK(oracle::exact(n).dot(column(2)) > 0);
  }
  const S nan = std::numeric_limits<S>::quiet_NaN();
  CHECK_THROWS_AS(contact::frame_on_normal<S>({0, 0, 0}, {0, 0, 0}), std::invalid_argument);
  CHECK_THROWS_AS(contact::frame_on_normal<S>({0, 0, 0}, {0, nan, 1}), std::invalid_argument);
  CHECK_THROWS_AS(contact::frame_on_normal<S>({0, nan, 0}, {0, 0, 1}), std::invalid_argument);
}

TEST_CASE("positions and directions convert into a frame and back") {
  // A frame whose axes are rational: nothing rounds.
  contact::CoordinateFrame<Rational> frame;
  const Rational third = Rational(1) / 3;
  frame.origin = {5, -2, 7};
  frame.axes << 2 * third, -2 * third, third, third, 2 * third, 2 * third, -2 * third, -third,
      2 * third;
  REQUIRE(frame.axes.transpose() * frame.axes == Eigen::Matrix<Rational, 3, 3>::Identity());
  Random random(11);
  for (int i = 0; i < 50; ++i) {
    const oracle::Vector p = oracle::exact(any_vector<double>(random, 2));
    const oracle::Vector q = oracle::exact(any_vector<double>(random, 2));
    CHECK(contact::position_in_world(frame, contact::position_in_frame(frame, p)) == p);
    CHECK(contact::direction_in_world(frame, contact::direction_in_frame(frame, p)) == p);
    // The difference of two positions is a direction.
    CHECK(oracle::Vector(contact::position_in_frame(frame, p) -
                         contact::position_in_frame(frame, q)) ==
          contact::direction_in_frame(frame, oracle::Vector(p - q)));
    // Dot products do not depend on the frame.
    CHECK(contact::direction_in_frame(frame, p).dot(contact::direction_in_frame(frame, q)) ==
          p.dot(q));
  }
  CHECK(contact::position_in_frame(frame, frame.origin) == oracle::Vector(0, 0, 0));
}

TEMPLATE_TEST_CASE("rounding errors in a frame are within their bounds", "", float, double) {
  using S = TestType;
  Random random(12);
  for (int i = 0; i < 500; ++i) {
    const auto frame = contact::frame_on_normal<S>(Vector3<S>(S(1000) * any_vector<S>(random, 2)),
                                                   any_vector<S>(random, 2));
    const Vector3<S> p = S(1000) * any_vector<S>(random, 2);
    const Eigen::Matrix<Rational, 3, 3> axes = frame.axes.template cast<Rational>();
    const oracle::Vector origin = oracle::exact(frame.origin);
    const oracle::Vector exact_p = oracle::exact(p);
    const oracle::Vector world = origin + oracle::Vector(axes * exact_p);
    const oracle::Vector local = axes.transpose() * oracle::Vector(exact_p - origin);
    const oracle::Vector world_size =
        origin.cwiseAbs() + oracle::Vector(axes.cwiseAbs() * exact_p.cwiseAbs());
    const oracle::Vector local_size =
        axes.cwiseAbs().transpose() * oracle::Vector(exact_p.cwiseAbs() + origin.cwiseAbs());
    const Vector3<S> got_world = contact::position_in_world(frame, p);
    const Vector3<S> got_local = contact::position_in_frame(frame, p);
    for (int k = 0; k < 3; ++k) {
      CHECK(within(got_world[k], world[k], gamma<S>(4) * world_size[k]));
      CHECK(within(got_local[k], local[k], gamma<S>(4) * local_size[k]));
    }
  }
}
