// segment_plane.hpp against the oracle. u is the unit roundoff of the type, η its
// smallest number. A decision has no tolerance: either the inputs decide it beyond the documented
// error bound, or the arithmetic is exact.
#include <algorithm>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <contact/plane.hpp>
#include <contact/segment_plane.hpp>
#include <contact/sphere_plane.hpp>

#include "reference.hpp"
#include "support/generators.hpp"
#include "support/oracle_planes.hpp"
#include "support/rounding.hpp"

using contact::Plane;
using contact::Segment;
using generators::all_families;
using generators::Family;
using generators::Random;
using oracle::ExactPlane;
using oracle::Rational;
using reference::distance_bound;
using reference::fits;
using reference::plane_of;
using rounding::eta;
using rounding::u;

TEMPLATE_TEST_CASE("a segment crosses where the oracle says", "", float, double) {
  using S = TestType;
  Random random(109);
  int decided = 0;
  int hits = 0;
  for (int i = 0; i < 12000; ++i) {
    const Family family = all_families[static_cast<std::size_t>(i) % all_families.size()];
    if (!fits<S>(family)) continue;
    const auto t = generators::triangle(random, family);
    // On the grid the plane lies along an axis: every intermediate result is a small whole number,
    // so nothing is rounded and every contact must be found.
    const bool rounds = family != Family::grid;
    const auto made = rounds ? plane_of(generators::rounded<S>(t)) : [&] {
      const auto p = generators::plane(random, family);
      return std::optional(Plane<S>{generators::rounded<S>(p.normal), static_cast<S>(p.offset)});
    }();
    if (!made) continue;
    const Plane<S> plane = *made;
    const Segment<S> s = generators::rounded<S>(generators::segment(random, family, t));
    const ExactPlane stored = oracle::plane_as_stored(plane);
    const auto e = oracle::exact(s);
    const Rational d0 = oracle::value(stored, e.start);
    const Rational d1 = oracle::value(stored, e.end);
    const Rational e0 = rounds ? distance_bound(plane, s.start) : Rational(0);
    const Rational e1 = rounds ? distance_bound(plane, s.end) : Rational(0);
    const auto got = contact::segment_plane(s, plane);
    if (got) {  // holds for every hit, decided or not
      REQUIRE((got->t >= S(0) && got->t <= S(1)));
      for (int k = 0; k < 3; ++k) {
        REQUIRE((got->point(k) >= std::min(s.start(k), s.end(k)) &&
                 got->point(k) <= std::max(s.start(k), s.end(k))));
      }
    }
    if (rounds && (abs(d0) <= e0 || abs(d1) <= e1)) continue;
    ++decided;
    const auto right = oracle::crossing(e, stored);
    REQUIRE(got.has_value() == right.has_value());
    if (!got) continue;
    ++hits;
    // t = N / D with N = d0 off by e0 and D = d0 − d1 off by e0 + e1; the difference and the
    // quotient add 2 u in each direction.
    const Rational size = abs(d0 - d1);
    const Rational tolerance =
        (e0 + right->t * (e0 + e1)) / (size - e0 - e1) + 3 * u<S>() * right->t + eta<S>();
    REQUIRE(oracle::exact(oracle::error(double(got->t), right->t)) <= tolerance);
    // The two weights come from the same rounded distances, so their sum is 1 to within 2 u each;
    // products and sum: 2 u.
    for (int k = 0; k < 3; ++k) {
      const Rational a = e.start(k);
      const Rational b = e.end(k);
      REQUIRE(oracle::exact(oracle::error(double(got->point(k)), right->point(k))) <=
              tolerance * abs(b - a) + 5 * u<S>() * (abs(a) + abs(b)) + 3 * eta<S>());
    }
  }
  CHECK(decided > 3500);
  CHECK(hits > 1500);
}

TEST_CASE("touching counts, and a segment in the plane has no single point") {
  const auto floor = contact::plane_from_normal_and_point<double>({0, 0, 1}, {0, 0, 0});
  CHECK(contact::segment_plane<double>({{0, 0, 0}, {0, 0, 1}}, floor)->t == 0.0);
  CHECK(contact::segment_plane<double>({{0, 0, 1}, {0, 0, 0}}, floor)->t == 1.0);
  CHECK_FALSE(contact::segment_plane<double>({{0, 0, 0}, {5, 0, 0}}, floor).has_value());
  CHECK_FALSE(contact::segment_plane<double>({{0, 0, 0}, {0, 0, 0}}, floor).has_value());
  CHECK_FALSE(contact::segment_plane<double>({{0, 0, 2}, {5, 0, 2}}, floor).has_value());
  CHECK(contact::sphere_meets_plane<double>({{0, 0, 2}, 2}, floor));
  CHECK(contact::sphere_meets_plane<double>({{0, 0, -2}, 2}, floor));
  CHECK_FALSE(contact::sphere_meets_plane<double>({{0, 0, 2}, std::nextafter(2.0, 0.0)}, floor));
  CHECK(contact::sphere_meets_plane<double>({{0, 0, 0}, 0}, floor));
}
