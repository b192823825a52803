#include <04_rays/round_bodies.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

namespace {

using namespace bodies;
using contact::Cylinder;

const auto meets_cylinder = [](const auto& line, const auto& body) {
  return contact::hits_cylinder(line, body);
};
template <class S>
Cylinder<S> cylinder_of(const RoundCase<S>& c) {
  return {c.core, c.radius};
}

TEST_CASE("lines that are hard meet cylinders as they do in fractions, doubles and floats") {
  compare_round<double>(3500, 21, cylinder_of<double>, meets_cylinder);
  compare_round<float>(3500, 22, cylinder_of<float>, meets_cylinder);
}

template <class S>
void compare_open(int count, std::uint64_t seed) {
  Random random(seed);
  int met = 0, touched = 0;
  for (int i = 0; i < generators::tried(count); ++i) {
    const RoundCase<S> c = round_case<S>(random, i % kinds);
    const Segment<S> segment{c.ray.origin, Vector3<S>(c.ray.origin + c.ray.direction * S(1.5))};
    if (!contact::is_finite(c.ray) || !contact::is_finite(segment) || c.core.start == c.core.end) {
      continue;
    }
    INFO("case " << i);
    const auto check = [&](const auto& line, bool has_end) {
      const auto right = first_on_wall(exact_line(line), core_of(c.core, c.radius), has_end);
      const auto got = contact::first_hit_open(line, cylinder_of(c));
      REQUIRE(got.has_value() == right.has_value());
      if (!right) return;
      ++met;
      REQUIRE(!got->inside);
      touched += oracle::sign(*right) == 0 ? 1 : 0;
      REQUIRE(t_is(got->t, *right, std::abs(oracle::nearest(*right)), 0x1p-40));
    };
    check(c.ray, false);
    check(segment, true);
  }
  CHECK(met > generators::tried(count) / 8);
  CHECK(touched > 20);
}

TEST_CASE("an open cylinder is met as in fractions") {
  compare_open<double>(7000, 23);
  compare_open<float>(7000, 24);
}

TEST_CASE("faces and normals of a cylinder") {
  Random random(25);
  int walls = 0, caps = 0, rims = 0;
  for (int i = 0; i < generators::tried(20000); ++i) {
    const int kind = i % 3;
    const RoundCase<double> c = round_case<double>(random, kind);
    const auto passage = contact::passage(c.ray, cylinder_of(c));
    if (!passage || c.radius < 0.01 || std::isinf(passage->entry)) continue;
    if ((c.core.end - c.core.start).norm() < 1e-3) continue;
    const Found right = find(regions(exact_line(c.ray), cylinder_of(c)));
    const Core core = core_of(c.core, c.radius);
    const Line line = exact_line(c.ray);
    const Point m = line.origin - core.start;
    const Rational at = m.dot(core.axis), rate = line.direction.dot(core.axis);
    const Rational length = core.axis.dot(core.axis);
    const bool at_start = rate > 0 && sign_at({0, rate, at}, right.low) == 0;
    const bool at_end = rate < 0 && sign_at({0, rate, at - length}, right.low) == 0;
    INFO("kind " << kind << ", case " << i);
    REQUIRE(passage->entry_face == (at_start ? contact::cylinder_start
                                    : at_end ? contact::cylinder_end
                                             : contact::cylinder_wall));
    const Vector3<double> axis = (c.core.end - c.core.start).normalized();
    REQUIRE_THAT(passage->entry_normal.norm(), Catch::Matchers::WithinAbs(1, 1e-12));
    if (at_start || at_end) {
      ++caps;
      if (sign_at(wall(line, core), right.low) == 0) ++rims;
      REQUIRE((passage->entry_normal - axis * (at_end ? 1 : -1)).norm() < 1e-12);
      continue;
    }
    ++walls;
    const Vector3<double> p =
        oracle::nearest(Point(m + line.direction * oracle::exact(oracle::nearest(right.low))));
    const Vector3<double> away = p - axis * axis.dot(p);
    REQUIRE((passage->entry_normal - away / c.radius).norm() < 1e-9);
    REQUIRE(passage->entry_normal.dot(c.ray.direction) < 1e-6 * c.ray.direction.norm());
  }
  CHECK(walls > generators::tried(1000));
  CHECK(caps > generators::tried(500));
  CHECK(rims > generators::tried(100));
}

TEST_CASE("what a cylinder's degenerate and infinite inputs get") {
  const Cylinder<double> tin{{{0, 0, 0}, {0, 0, 2}}, 1};
  const auto first = [&tin](double x, double y, double z, double dx, double dy, double dz) {
    return contact::first_hit(Ray<double>{{x, y, z}, {dx, dy, dz}}, tin);
  };
  CHECK(first(0, 0, 1, 0, 0, 0)->inside);  // no direction: a point
  CHECK_FALSE(first(0, 0, 3, 0, 0, 0));
  CHECK(first(1, 0, -1, 0, 0, 1)->t == 1);  // in the wall, along a generator
  CHECK(first(1, 0, -1, 0, 0, 1)->face == contact::cylinder_start);
  CHECK_FALSE(first(std::nextafter(1, 2), 0, -1, 0, 0, 1));
  CHECK(first(-3, 0, 2, 1, 0, 0)->t == 2);  // in the plane of a cap
  CHECK(first(-3, 1, 2, 1, 0, 0)->t == 3);  // touches a rim
  CHECK_FALSE(first(-3, 0, std::nextafter(2, 3), 1, 0, 0));
  CHECK_FALSE(first(1, 1, 1, 1, 0, 0));  // behind
  const double endless = std::numeric_limits<double>::infinity();
  const auto inside = contact::passage_of_infinite_cylinder(Ray<double>{{1, 0, 9}, {0, 0, 1}}, tin);
  REQUIRE(inside);
  CHECK(inside->entry == -endless);
  CHECK(inside->exit == endless);
  CHECK(contact::passage_of_infinite_cylinder(Ray<double>{{-3, 0, 9}, {1, 0, 1}}, tin)->entry == 2);
  // An axis of another length is the same cylinder.
  const Cylinder<double> oblique{{{0, 0, 0}, {0, 3e-200, 4e-200}}, 1e-200};
  CHECK(contact::hits_cylinder(Ray<double>{{0, 0, -1}, {0, 0, 1}}, oblique));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {nan, endless, -endless}) {
    CHECK_FALSE(first(bad, 0, 0, 0, 0, 1));
    CHECK_FALSE(first(0, 0, 0, 0, bad, 1));
    CHECK_FALSE(contact::hits_cylinder(Ray<double>{{0, 0, 0}, {0, 0, 1}},
                                       Cylinder<double>{{{0, 0, 0}, {0, 0, 2}}, bad}));
  }
  CHECK_FALSE(contact::hits_cylinder(Ray<double>{{0, 0, 0}, {0, 0, 1}},
                                     Cylinder<double>{{{0, 0, 0}, {0, 0, 2}}, -1}));
  CHECK_FALSE(contact::hits_cylinder(Ray<double>{{0, 0, 0}, {0, 0, 1}},
                                     Cylinder<double>{{{0, 0, 0}, {0, 0, 0}}, 1}));
}

TEST_CASE("the textbook's cylinder agrees far from its limits") {
  Random random(26);
  int compared = 0;
  for (int i = 0; i < 3000; ++i) {
    const RoundCase<double> c = round_case<double>(random, 0);
    const auto book = contact::passage(c.ray, cylinder_of(c));
    const auto other = contact::passage_by_textbook(c.ray, cylinder_of(c));
    if (!book || !other || !(book->exit - book->entry > 0.05) || !(std::abs(book->entry) < 50)) {
      continue;
    }
    ++compared;
    REQUIRE_THAT(other->entry, Catch::Matchers::WithinAbs(book->entry, 1e-6));
    REQUIRE_THAT(other->exit, Catch::Matchers::WithinAbs(book->exit, 1e-6));
    REQUIRE(other->entry_face == book->entry_face);
    REQUIRE((other->entry_normal - book->entry_normal).norm() < 1e-5);
  }
  CHECK(compared > 500);
}

}  // namespace
