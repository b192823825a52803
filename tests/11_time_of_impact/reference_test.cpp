// Roots and times of impact against fractions with one square root. u is the unit roundoff of the
// type. A bound stated in a comment of the reference code is tested as stated, without an
// allowance.
#include <algorithm>
#include <array>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/ballistic_impact.hpp>
#include <contact/quadratic_roots.hpp>
#include <contact/sphere_capsule_impact.hpp>
#include <contact/sphere_sphere_impact.hpp>
#include <contact/swept_volumes.hpp>
#include <limits>
#include <optional>
#include <vector>

#include "support/generators.hpp"
#include "support/oracle.hpp"
#include "support/rounding.hpp"

using contact::Vector3;
using generators::Random;
using oracle::Quadratic;
using oracle::Rational;
using oracle::Surd;
using rounding::u;

namespace {

/// |x| rounded up to a fraction.
Rational magnitude(const Surd& x) {
  const auto range = oracle::enclose(x, 128);
  return std::max(Rational(abs(range.low)), Rational(abs(range.high)));
}

/// Whether the error of got is at most `units` u of right, or the smallest positive number; ±∞
/// stands for numbers beyond the largest.
template <class S>
bool close(S got, const Surd& right, int units) {
  const Rational size = magnitude(right);
  if (!std::isfinite(got)) {
    if (std::isnan(got)) return false;
    const Rational most = oracle::exact(std::numeric_limits<S>::max());
    return size * (1 + units * u<S>()) >= most && (oracle::sign(right) > 0) == (got > 0);
  }
  const double off = oracle::error(static_cast<double>(got), right);
  return oracle::exact(off) <=
         units * u<S>() * size + oracle::exact(std::numeric_limits<S>::denorm_min());
}

template <class S>
Vector3<S> in_box(Random& random, double size) {
  const double x = random.uniform(-size, size);
  const double y = random.uniform(-size, size);
  const double z = random.uniform(-size, size);
  return {static_cast<S>(x), static_cast<S>(y), static_cast<S>(z)};
}

template <class S>
Vector3<S> whole(Random& random, int size) {
  const int x = random.integer(-size, size);
  const int y = random.integer(-size, size);
  const int z = random.integer(-size, size);
  return {S(x), S(y), S(z)};
}

template <class S>
S nudged(Random& random, S x, int count) {
  for (int k = random.integer(-count, count); k != 0; k += k > 0 ? -1 : 1)
    x = std::nextafter(x, k > 0 ? std::numeric_limits<S>::max() : std::numeric_limits<S>::lowest());
  return x;
}

template <class S>
Vector3<S> scaled(const Vector3<S>& v, int power) {
  return {std::ldexp(v.x(), power), std::ldexp(v.y(), power), std::ldexp(v.z(), power)};
}

template <class S>
struct Pair {
  contact::Sphere<S> a, b;
  Vector3<S> va, vb;
};

/// Spheres anywhere; on integers; on paths that graze to within a few ulps; that touch to within a
/// few ulps; far from the origin; very large and very small.
template <class S>
Pair<S> pair_of(Random& random, int kind) {
  Pair<S> p;
  if (kind == 1) {
    p.a = {whole<S>(random, 4), S(random.integer(0, 3))};
    p.b = {whole<S>(random, 4), S(random.integer(0, 3))};
    p.va = whole<S>(random, 3);
    p.vb = whole<S>(random, 3);
    return p;
  }
  p.a.centre = in_box<S>(random, 4);
  p.b.centre = in_box<S>(random, 4);
  p.a.radius = static_cast<S>(random.uniform(0, 2));
  p.b.radius = static_cast<S>(random.uniform(0, 2));
  p.va = in_box<S>(random, 3);
  p.vb = in_box<S>(random, 3);
  // Half of them are aimed at each other.
  if (random.chance(0.5)) p.va = p.vb + (p.b.centre - p.a.centre) * S(0.7) + in_box<S>(random, 0.5);
  const S radius_sum = p.a.radius + p.b.radius;
  if (kind == 2) {
    // The path passes at a distance of the sum of both radii.
    const Vector3<S> d = p.b.centre - p.a.centre;
    const Vector3<S> across = contact::normalised(Vector3<S>(d.cross(in_box<S>(random, 1))));
    p.va = p.vb + d;
    p.a.centre += across * nudged(random, radius_sum, 3);
  }
  if (kind == 3) {
    const Vector3<S> d = contact::normalised(Vector3<S>(p.a.centre - p.b.centre));
    p.a.centre = p.b.centre + d * nudged(random, radius_sum, 3);
  }
  if (kind == 4) {
    const Vector3<S> shift = in_box<S>(random, 1e6);
    p.a.centre += shift;
    p.b.centre += shift;
  }
  if (kind == 5) {
    const int most = std::numeric_limits<S>::max_exponent - 8;
    const int length = random.integer(-most, most);
    const int speed = random.integer(-most, most);
    p.a = {scaled(p.a.centre, length), std::ldexp(p.a.radius, length)};
    p.b = {scaled(p.b.centre, length), std::ldexp(p.b.radius, length)};
    p.va = scaled(p.va, speed);
    p.vb = scaled(p.vb, speed);
  }
  return p;
}

/// |d + w t|² − R² as a polynomial, exactly.
template <class S>
Quadratic distance_polynomial(const Pair<S>& p) {
  const oracle::Vector d = oracle::exact(p.a.centre) - oracle::exact(p.b.centre);
  const oracle::Vector w = oracle::exact(p.va) - oracle::exact(p.vb);
  const Rational radius_sum = oracle::exact(p.a.radius) + oracle::exact(p.b.radius);
  return {w.dot(w), 2 * d.dot(w), d.dot(d) - radius_sum * radius_sum};
}

}  // namespace

TEST_CASE("a coefficient that is not finite has no root") {
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double wild : {infinity, -infinity, nan}) {
    CHECK(contact::quadratic_roots(wild, 1.0, nan).count == 0);
    CHECK(contact::quadratic_roots(1.0, wild, -1.0).count == 0);
    CHECK(contact::quadratic_roots(1.0, 1.0, wild).count == 0);
  }
}

TEMPLATE_TEST_CASE("roots of quadratics: their number, and each to 8 u", "", float, double) {
  using S = TestType;
  Random random(1);
  std::array<int, 3> counts{};
  const int most = std::numeric_limits<S>::max_exponent - 1;
  for (int i = 0; i < generators::tried(6000); ++i) {
    S a = 0;
    S b = 0;
    S c = 0;
    switch (i % 6) {
      case 0:  // general
        a = static_cast<S>(random.uniform(-3, 3));
        b = static_cast<S>(random.uniform(-3, 3));
        c = static_cast<S>(random.uniform(-3, 3));
        break;
      case 1:  // integers: double roots, zeros
        a = S(random.integer(-4, 4));
        b = S(random.integer(-4, 4));
        c = S(random.integer(-4, 4));
        break;
      case 2:  // b² much larger than 4 a c
        a = static_cast<S>(random.uniform(-1, 1));
        b = static_cast<S>(random.magnitude(10, 40));
        c = static_cast<S>(random.uniform(-1, 1));
        break;
      case 3:  // almost a double root
        a = static_cast<S>(random.uniform(0.5, 2));
        b = static_cast<S>(random.uniform(-4, 4));
        c = nudged(random, b * b / (S(4) * a), 3);
        break;
      case 4: {  // (p t − q)² with few digits: an exact double root, or one ulp beside it
        const S p = S(random.integer(1, 1000));
        const S q = S(random.integer(-1000, 1000));
        a = p * p;
        b = S(-2) * p * q;
        c = nudged(random, q * q, 1);
        break;
      }
      default:  // every magnitude
        a = static_cast<S>(random.magnitude(-most, most));
        b = static_cast<S>(random.magnitude(-most, most));
        c = static_cast<S>(random.magnitude(-most, most));
        break;
    }
    const auto got = contact::quadratic_roots(a, b, c);
    INFO("a = " << double(a) << ", b = " << double(b) << ", c = " << double(c));
    if (a == 0 && b == 0) {
      CHECK(got.count == 0);
      continue;
    }
    const auto right = Quadratic{oracle::exact(a), oracle::exact(b), oracle::exact(c)}.roots();
    REQUIRE(got.count == static_cast<int>(right.size()));
    ++counts[right.size()];
    if (right.empty()) continue;
    CHECK(close(got.low, right.front(), 8));
    CHECK(close(got.high, right.back(), 8));
    CHECK(got.low <= got.high);
  }
  for (const int count : counts) CHECK(count > generators::tried(200));
}

TEMPLATE_TEST_CASE("moving spheres: the decision is right, and the time to 256 u", "", float,
                   double) {
  using S = TestType;
  Random random(2);
  int touched = 0;
  int passed = 0;
  int at_once = 0;
  for (int i = 0; i < generators::tried(6000); ++i) {
    const Pair<S> p = pair_of<S>(random, i % 6);
    if (!contact::all_finite(p.a.centre) || !contact::all_finite(p.b.centre)) continue;
    const Quadratic polynomial = distance_polynomial(p);
    const auto got = contact::sphere_sphere_impact(p.a, p.va, p.b, p.vb);
    const bool approach = polynomial.b < 0;
    if (approach && polynomial.c <= 0) {
      REQUIRE(got.has_value());
      CHECK(*got == 0);
      ++at_once;
      continue;
    }
    if (!approach || polynomial.discriminant() < 0) {
      CHECK_FALSE(got.has_value());
      ++passed;
      continue;
    }
    const Surd right = polynomial.roots().front();
    if (!got) {
      CHECK(magnitude(right) > oracle::exact(std::numeric_limits<S>::max()) / 2);
      continue;
    }
    ++touched;
    INFO("kind " << i % 6);
    CHECK(close(*got, right, 256));
    // Until the end of a step: also right if the step ends with the touch.
    for (const S last : {*got, std::nextafter(*got, S(0)), *got / 2, *got * 2, S(1)}) {
      if (!std::isfinite(last)) continue;
      const bool by_then = oracle::compare(right, Surd{oracle::exact(last)}) <= 0;
      CHECK(contact::spheres_touch_by(p.a, p.va, p.b, p.vb, last) == by_then);
    }
  }
  CHECK(touched > generators::tried(1000));
  CHECK(passed > generators::tried(500));
  CHECK(at_once > generators::tried(200));
  CHECK_FALSE(
      contact::spheres_touch_by<S>({{0, 0, 0}, 1}, {1, 0, 0}, {{1, 0, 0}, 1}, {0, 0, 0}, -1));
}

TEST_CASE("balls in the same free fall touch when they would without gravity") {
  // Both fall for t: the difference of their positions is that of straight paths, exactly, in
  // fractions.
  Random random(3);
  int touched = 0;
  for (int i = 0; i < generators::tried(400); ++i) {
    const Pair<double> p = pair_of<double>(random, 0);
    const auto t = contact::sphere_sphere_impact(p.a, p.va, p.b, p.vb);
    if (!t || *t == 0) continue;
    ++touched;
    const oracle::Vector g(0, 0, Rational(-981) / 100);
    const Rational time = oracle::exact(*t);
    const oracle::Vector a =
        oracle::ballistic(oracle::exact(p.a.centre), oracle::exact(p.va), g, time);
    const oracle::Vector b =
        oracle::ballistic(oracle::exact(p.b.centre), oracle::exact(p.vb), g, time);
    const oracle::Vector d = a - b;
    const Rational radius_sum = oracle::exact(p.a.radius) + oracle::exact(p.b.radius);
    const Quadratic polynomial = distance_polynomial(p);
    CHECK(d.dot(d) - radius_sum * radius_sum == polynomial.at(time));
    // The residual is the slope there times the error of the time, 256 u, plus a term in its
    // square.
    const Rational slope = abs(2 * polynomial.a * time + polynomial.b);
    const Rational off = 256 * u<double>() * time;
    CHECK(abs(d.dot(d) - radius_sum * radius_sum) <= slope * off + polynomial.a * off * off);
  }
  CHECK(touched > generators::tried(60));
  const Vector3<double> at =
      contact::ballistic_position<double>({1, 2, 3}, {4, 0, 8}, {0, 0, -10}, 0.5);
  CHECK(at == Vector3<double>(3, 2, 5.75));
}

TEMPLATE_TEST_CASE("a ball in free fall against a plane, to 8 u", "", float, double) {
  using S = TestType;
  Random random(4);
  std::array<int, 5> seen{};  // at once, falling, thrown up, grazing or away, never
  for (int i = 0; i < generators::tried(6000); ++i) {
    contact::Sphere<S> sphere{in_box<S>(random, 3), static_cast<S>(random.uniform(0, 1))};
    contact::Plane<S> plane;
    Vector3<S> velocity = in_box<S>(random, 4);
    Vector3<S> gravity = in_box<S>(random, 10);
    switch (i % 5) {
      case 0:  // a floor
        plane = {Vector3<S>::UnitZ(), S(0)};
        gravity = {S(0), S(0), static_cast<S>(-9.81)};
        sphere.centre.z() = sphere.radius + static_cast<S>(random.uniform(0, 2));
        break;
      case 1:  // integers, and gravity away from the plane: grazing is exact
        plane = {Vector3<S>::UnitZ(), S(random.integer(-2, 2))};
        sphere = {whole<S>(random, 4), S(random.integer(0, 2))};
        velocity = whole<S>(random, 4);
        gravity = whole<S>(random, 2);
        break;
      case 2:  // lies on the floor, up to an ulp, and is thrown up or down
        plane = {Vector3<S>::UnitZ(), S(0)};
        gravity = {S(0), S(0), static_cast<S>(-9.81)};
        sphere.centre.z() = nudged(random, sphere.radius, 2);
        break;
      case 3:  // any plane
        plane = contact::plane_from_normal_and_point<S>(in_box<S>(random, 1) + Vector3<S>(0, 0, 2),
                                                        in_box<S>(random, 2));
        break;
      default:  // no gravity, or almost none
        plane = {Vector3<S>::UnitX(), S(-2)};
        gravity *= static_cast<S>(std::ldexp(1.0, -random.integer(20, 60)));
        if (random.chance(0.3)) gravity = Vector3<S>::Zero();
        break;
    }
    const oracle::Vector n = oracle::exact(plane.normal);
    const Rational gap = n.dot(oracle::exact(sphere.centre)) - oracle::exact(plane.offset) -
                         oracle::exact(sphere.radius);
    const Rational rate = n.dot(oracle::exact(velocity));
    const Rational bend = n.dot(oracle::exact(gravity));
    const auto got = contact::ballistic_impact(sphere, velocity, gravity, plane);
    INFO("kind " << i % 5 << ": " << double(gap) << ", " << double(rate) << ", " << double(bend));
    if (gap <= 0 && (rate < 0 || (rate == 0 && bend < 0))) {
      REQUIRE(got.has_value());
      CHECK(*got == 0);
      ++seen[0];
      continue;
    }
    // The first root at which the gap closes; or the highest point of a rise without separation.
    std::optional<Surd> right;
    if (bend != 0 || rate != 0) {
      for (const Surd& root : Quadratic{bend / 2, rate, gap}.roots()) {
        const int slope = oracle::sign(root * bend + rate);
        const bool closes = slope < 0 || (slope == 0 && bend > 0);
        if (!right && oracle::sign(root) > 0 && closes) right = root;
      }
      if (bend < 0 && rate * rate - 2 * bend * gap < 0) right = Surd{-rate / bend};
      // Rising, and just touching at the highest point: there it begins to fall.
      if (bend < 0 && rate * rate == 2 * bend * gap) right = Surd{-rate / bend};
    }
    REQUIRE(got.has_value() == right.has_value());
    if (!right) {
      ++seen[4];
      continue;
    }
    ++seen[bend >= 0 ? 3 : rate > 0 ? 2 : 1];
    CHECK(close(*got, *right, 8));
  }
  for (const int count : seen) CHECK(count > generators::tried(80));
}

namespace {

/// The smallest squared distance of m + t w, 0 ≤ t ≤ last, from the segment from 0 to e: the
/// minimum of a convex quadratic over a rectangle, exactly.
Rational min_square(const oracle::Vector& m, const oracle::Vector& w, const oracle::Vector& e,
                    const Rational& last) {
  const auto clamp = [](const Rational& x, const Rational& high) {
    return x < 0 ? Rational(0) : x > high ? high : x;
  };
  const auto at = [&](const Rational& t, const Rational& s) {
    const oracle::Vector d = m + w * t - e * s;
    return Rational(d.dot(d));
  };
  const Rational ww = w.dot(w);
  const Rational we = w.dot(e);
  const Rational ee = e.dot(e);
  // The best s for a given t, and the best t for a given s.
  const auto best_s = [&](const Rational& t) {
    return ee == 0 ? Rational(0)
                   : clamp(Rational(oracle::Vector(m + w * t).dot(e)) / ee, Rational(1));
  };
  const auto best_t = [&](const Rational& s) {
    return ww == 0 ? Rational(0) : clamp(Rational(-oracle::Vector(m - e * s).dot(w)) / ww, last);
  };
  Rational least = at(0, best_s(0));
  least = std::min(least, at(last, best_s(last)));
  least = std::min(least, at(best_t(0), 0));
  least = std::min(least, at(best_t(1), 1));
  const Rational determinant = ww * ee - we * we;
  if (determinant > 0) {
    const Rational t = (m.dot(e) * we - m.dot(w) * ee) / determinant;
    const Rational s = (m.dot(e) * ww - m.dot(w) * we) / determinant;
    if (t >= 0 && t <= last && s >= 0 && s <= 1) least = std::min(least, at(t, s));
  }
  return least;
}

}  // namespace

TEMPLATE_TEST_CASE("a moving ball against a capsule: the decision is right, and t to 5 u", "",
                   float, double) {
  using S = TestType;
  Random random(5);
  int touched = 0;
  int missed = 0;
  for (int i = 0; i < generators::tried(3000); ++i) {
    contact::Sphere<S> sphere;
    Vector3<S> way;
    contact::Segment<S> axis;
    S radius = 0;
    if (i % 3 == 0) {
      sphere = {whole<S>(random, 4), S(random.integer(0, 2))};
      way = whole<S>(random, 6);
      axis = {whole<S>(random, 3), whole<S>(random, 3)};
      radius = S(random.integer(0, 1));
    } else {
      sphere = {in_box<S>(random, 4), static_cast<S>(random.uniform(0, 1))};
      axis = {in_box<S>(random, 2), in_box<S>(random, 2)};
      radius = static_cast<S>(random.uniform(0, 1));
      way = (axis.start + (axis.end - axis.start) * static_cast<S>(random.uniform(-0.5, 1.5)) -
             sphere.centre) *
            static_cast<S>(random.uniform(0.5, 2));
      if (i % 3 == 2) {
        // Along the side, or past an end, to within a few ulps of the sum of the radii.
        const Vector3<S> side =
            way.cross(i % 2 == 0 ? Vector3<S>(axis.end - axis.start) : in_box<S>(random, 1));
        if (side != Vector3<S>::Zero())
          sphere.centre += contact::normalised(side) * nudged(random, S(sphere.radius + radius), 2);
      }
    }
    const oracle::Vector m = oracle::exact(sphere.centre) - oracle::exact(axis.start);
    const oracle::Vector w = oracle::exact(way);
    const oracle::Vector e = oracle::exact(axis.end) - oracle::exact(axis.start);
    const Rational radius_sum = oracle::exact(sphere.radius) + oracle::exact(radius);
    const auto got = contact::sphere_capsule_impact(sphere, way, axis, radius);
    const bool right = min_square(m, w, e, 1) <= radius_sum * radius_sum;
    INFO("case " << i);
    REQUIRE(got.has_value() == right);
    if (!right) {
      ++missed;
      continue;
    }
    const bool at_start = min_square(m, w, e, 0) <= radius_sum * radius_sum;
    CHECK((*got == 0) == at_start);
    if (at_start) continue;
    ++touched;
    // They touch by t plus 5 u of it, and not before t less 5 u of it.
    const Rational t = oracle::exact(*got);
    const Rational step = 5 * u<S>() * t;
    CHECK(min_square(m, w, e, t - step) >= radius_sum * radius_sum);
    CHECK(min_square(m, w, e, std::min(Rational(1), Rational(t + step))) <=
          radius_sum * radius_sum);
  }
  CHECK(touched > generators::tried(500));
  CHECK(missed > generators::tried(300));
  const auto met =
      contact::sphere_segment_impact<S>({{0, 0, 5}, 1}, {0, 0, -8}, {{-1, 0, 0}, {1, 0, 0}});
  REQUIRE(met.has_value());
  CHECK(*met == S(0.5));
}

TEST_CASE(
    "swept volumes: decided exactly, never disjoint where balls touch, often met without a touch") {
  Random random(6);
  int met = 0;
  int apart = 0;
  int in_vain = 0;
  for (int i = 0; i < generators::tried(3000); ++i) {
    Pair<double> p = pair_of<double>(random, i % 4);
    if (i % 8 == 4) p.vb = p.va * 2;  // parallel paths
    if (i % 8 == 5) p.va = Vector3<double>::Zero();
    const bool got = contact::swept_spheres_meet(p.a, p.va, p.b, p.vb);
    const oracle::Vector d = oracle::exact(p.a.centre) - oracle::exact(p.b.centre);
    const Rational radius_sum = oracle::exact(p.a.radius) + oracle::exact(p.b.radius);
    const bool right =
        min_square(d, oracle::exact(p.va), oracle::exact(p.vb), 1) <= radius_sum * radius_sum;
    REQUIRE(got == right);
    CHECK(contact::swept_spheres_meet(p.b, p.vb, p.a, p.va) == right);
    (right ? met : apart) += 1;
    const bool touch = contact::spheres_touch_by(p.a, p.va, p.b, p.vb, 1.0);
    if (touch) CHECK(right);
    if (right && !touch) ++in_vain;
  }
  CHECK(met > generators::tried(500));
  CHECK(apart > generators::tried(500));
  CHECK(in_vain > generators::tried(100));
}
