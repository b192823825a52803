#include <04_rays/round_bodies.hpp>
#include <contact/ray_sphere.hpp>

namespace {

using namespace bodies;
using contact::Capsule;

const auto meets_capsule = [](const auto& line, const auto& body) {
  return contact::hits_capsule(line, body);
};
template <class S>
Capsule<S> capsule_of(const RoundCase<S>& c) {
  return {c.core, c.radius};
}

TEST_CASE("lines that are hard meet capsules as they do in fractions, doubles and floats") {
  compare_round<double>(2500, 31, capsule_of<double>, meets_capsule);
  compare_round<float>(2500, 32, capsule_of<float>, meets_capsule);
}

TEST_CASE("the normal of a capsule points away from its core") {
  Random random(33);
  int compared = 0;
  for (int i = 0; i < generators::tried(20000); ++i) {
    const RoundCase<double> c = round_case<double>(random, i % 3);
    const auto passage = contact::passage(c.ray, capsule_of(c));
    if (!passage || c.radius < 0.01 || std::isinf(passage->entry)) continue;
    const Vector3<double> e = c.core.end - c.core.start;
    if (e.norm() < 1e-3) continue;
    const Vector3<double> p = c.ray.origin + c.ray.direction * passage->entry;
    const double s = std::clamp((p - c.core.start).dot(e) / e.dot(e), 0.0, 1.0);
    const Vector3<double> away = (p - c.core.start - s * e) / c.radius;
    INFO("case " << i);
    ++compared;
    REQUIRE((passage->entry_normal - away).norm() < 1e-9);
    REQUIRE(passage->entry_face == -1);
  }
  CHECK(compared > generators::tried(2000));
}

TEST_CASE("what a capsule's degenerate and infinite inputs get") {
  const Capsule<double> pill{{{0, -1, 0}, {0, 1, 0}}, 0.5};
  const auto first = [&pill](double x, double y, double z, double dx, double dy, double dz) {
    return contact::first_hit(Ray<double>{{x, y, z}, {dx, dy, dz}}, pill);
  };
  CHECK_FALSE(first(1, 0, 0, 1, 0, 0));  // PhysX 487: the capsule is behind
  CHECK(first(0, 5, 0, 0, -1, 0)->t == 3.5);
  CHECK(first(0, 0, 0, 0, 1, 0)->inside);
  CHECK(first(0, 0.25, 0.25, 0, 0, 0)->inside);
  CHECK(first(0.5, -9, 0, 0, 1, 0)->t == 8);  // along the wall: touches where it begins
  CHECK_FALSE(first(std::nextafter(0.5, 1), -9, 0, 0, 1, 0));
  // A core of length 0 is a ball.
  const Capsule<double> ball{{{1, 2, 3}, {1, 2, 3}}, 2};
  const Ray<double> ray{{9, 2, 3}, {-2, 0, 0.25}};
  CHECK(contact::hits_capsule(ray, ball) ==
        contact::hits_sphere(ray, contact::Sphere<double>{{1, 2, 3}, 2}));
  CHECK(std::abs(contact::first_hit(ray, ball)->t -
                 contact::first_hit(ray, contact::Sphere<double>{{1, 2, 3}, 2})->t) < 1e-12);
  // A radius of 0 is a segment.
  CHECK(contact::first_hit(Ray<double>{{1, 0.5, 0}, {-1, 0, 0}},
                           Capsule<double>{{{0, -1, 0}, {0, 1, 0}}, 0})
            ->t == 1);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double endless = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, endless, -endless}) {
    CHECK_FALSE(first(bad, 0, 0, 0, 0, 1));
    CHECK_FALSE(first(0, 0, 0, 0, bad, 1));
    CHECK_FALSE(contact::hits_capsule(ray, Capsule<double>{{{0, 0, 0}, {0, 0, 2}}, bad}));
  }
  CHECK_FALSE(contact::hits_capsule(ray, Capsule<double>{{{1, 2, 3}, {1, 2, 3}}, -2}));
}

TEST_CASE("the textbook's capsule agrees far from its limits, and fails at them") {
  const Capsule<double> pill{{{0, -1, 0}, {0, 1, 0}}, 0.5};
  CHECK(contact::capsule_hit_by_textbook(Ray<double>{{5, 0.5, 0}, {-1, 0, 0}}, pill) == 4.5);
  CHECK(contact::capsule_hit_by_textbook(Ray<double>{{5, 1.25, 0}, {-1, 0, 0}}, pill).has_value());
  // Far away nothing is left of the radius.
  const Ray<double> far{{1e9, 0, 0.25}, {-1, 0, 0}};
  CHECK(contact::hits_capsule(far, pill));
  CHECK(std::abs(*contact::capsule_hit_by_textbook(far, pill) - contact::first_hit(far, pill)->t) >
        0.01);
}

}  // namespace
