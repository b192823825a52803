#include <04_rays/round_bodies.hpp>

namespace {

using namespace bodies;
using contact::Cone;

const auto meets_cone = [](const auto& line, const auto& body) {
  return contact::hits_cone(line, body);
};
template <class S>
Cone<S> cone_of(const RoundCase<S>& c) {
  return {c.core.start, c.core.end, c.radius};
}

TEST_CASE("lines that are hard meet cones as they do in fractions, doubles and floats") {
  compare_round<double>(3500, 41, cone_of<double>, meets_cone);
  compare_round<float>(3500, 42, cone_of<float>, meets_cone);
}

/// Whole numbers: lines through the apex, along a generator, parallel to one, in tangent planes.
template <class S>
void compare_generators(int count, std::uint64_t seed) {
  Random random(seed);
  Seen seen;
  for (int i = 0; i < generators::tried(count); ++i) {
    static constexpr int triples[4][3] = {{3, 4, 5}, {5, 12, 13}, {-8, 15, 17}, {0, -7, 7}};
    const int k = random.integer(0, 2);
    const auto& [a, b, r] = triples[random.integer(0, 3)];
    const Vector3<S> apex = vector<S>(random, 1);
    Vector3<S> base = apex;
    base(k) += S(random.chance(0.5) ? random.integer(1, 9) : -random.integer(1, 9));
    Vector3<S> rim = base, tangent = Vector3<S>::Zero();
    rim((k + 1) % 3) += S(a);
    rim((k + 2) % 3) += S(b);
    tangent((k + 1) % 3) = S(-b);
    tangent((k + 2) % 3) = S(a);
    const Vector3<S> generator = rim - apex;
    // A point of a tangent plane, half of a generator from the apex, and a direction in the plane.
    Vector3<S> on = apex + generator * (S(random.integer(-2, 4)) / S(2));
    const Vector3<S> along =
        generator * S(random.integer(-1, 1)) + tangent * S(random.integer(-1, 1));
    if (random.chance(0.3)) on += vector<S>(random, 1);
    const S steps = S(random.integer(-3, 3)) / S(2);
    Ray<S> ray{Vector3<S>(on - along * steps), along};
    if (random.chance(0.3)) ray.origin = nudged<S>(random, ray.origin);
    const Cone<S> cone{apex, base, S(r)};
    INFO("case " << i);
    compare<S>(ray, cone, cone, meets_cone, seen);
    compare<S>(Segment<S>{ray.origin, Vector3<S>(ray.origin + ray.direction)}, cone, cone,
               meets_cone, seen);
  }
  for (int what = 0; what <= 3; ++what) CHECK(seen[what] > generators::tried(count) / 100);
}

TEST_CASE("lines in tangent planes of cones, along generators and through the apex") {
  compare_generators<double>(4000, 43);
  compare_generators<float>(4000, 44);
}

TEST_CASE("faces, normals, and the mirror nappe of a cone") {
  const Cone<double> cone{{0, 0, 4}, {0, 0, 0}, 3};
  const auto first = [&cone](double x, double y, double z, double dx, double dy, double dz) {
    return contact::first_hit(Ray<double>{{x, y, z}, {dx, dy, dz}}, cone);
  };
  const auto down = first(0, 0, 9, 0, 0, -1);  // on the apex
  CHECK(down->t == 5);
  CHECK(down->face == contact::cone_wall);
  CHECK(down->normal == Vector3<double>(0, 0, 1));
  const auto up = first(0, 0, -2, 0, 0, 1);
  CHECK(up->t == 2);
  CHECK(up->face == contact::cone_base);
  CHECK(up->normal == Vector3<double>(0, 0, -1));
  const auto side = first(9, 0, 2, -1, 0, 0);
  CHECK(std::abs(side->t - 7.5) < 1e-12);
  CHECK((side->normal - Vector3<double>(0.8, 0, 0.6)).norm() < 1e-12);
  CHECK_FALSE(first(9, 0, 6, -1, 0, 0));  // the mirror nappe
  CHECK(contact::passage_of_double_cone(Ray<double>{{9, 0, 6}, {-1, 0, 0}}, cone));
  CHECK(first(9, 0, 4, -1, 0, 0)->t == 9);  // touches at the apex
  CHECK(first(9, 0, 0, -1, 0, 0)->t == 6);  // in the plane of the base
  CHECK(first(9, 0, 0, -1, 0, 0)->face == contact::cone_wall);
  CHECK(first(0, 0, 2, 0, 0, 0)->inside);
  CHECK_FALSE(first(0, 0, 5, 0, 0, 0));
  CHECK(contact::first_hit(Ray<double>{{3, 0, -1}, {0, 0, 1}}, cone)->face == contact::cone_base);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double endless = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, endless, -endless}) {
    CHECK_FALSE(first(bad, 0, 0, 0, 0, 1));
    CHECK_FALSE(first(0, 0, 0, 0, bad, 1));
    CHECK_FALSE(contact::hits_cone(Ray<double>{{0, 0, 9}, {0, 0, -1}},
                                   Cone<double>{{0, 0, bad}, {0, 0, 0}, 3}));
  }
  CHECK_FALSE(contact::hits_cone(Ray<double>{{0, 0, 9}, {0, 0, -1}},
                                 Cone<double>{{0, 0, 4}, {0, 0, 0}, -3}));
  CHECK_FALSE(contact::hits_cone(Ray<double>{{0, 0, 9}, {0, 0, -1}},
                                 Cone<double>{{0, 0, 4}, {0, 0, 4}, 3}));
}

TEST_CASE("the normal of a cone's wall is perpendicular to the generator") {
  Random random(45);
  int walls = 0;
  for (int i = 0; i < generators::tried(20000); ++i) {
    const RoundCase<double> c = round_case<double>(random, i % 3);
    const Vector3<double> h = c.core.end - c.core.start;
    if (c.radius < 0.05 || h.norm() < 0.05) continue;
    const auto hit = contact::first_hit(c.ray, cone_of(c));
    if (!hit || hit->inside || hit->face != contact::cone_wall) continue;
    const Vector3<double> generator = hit->point - c.core.start;
    if (generator.norm() < 0.05) continue;
    ++walls;
    INFO("case " << i);
    REQUIRE(std::abs(hit->normal.norm() - 1) < 1e-12);
    REQUIRE(std::abs(hit->normal.dot(generator)) < 1e-8 * generator.norm());
    REQUIRE(hit->normal.dot(h) < 0);
  }
  CHECK(walls > generators::tried(800));
}

}  // namespace
