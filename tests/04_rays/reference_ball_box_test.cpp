#include <04_rays/round_bodies.hpp>

namespace {

using namespace bodies;
using contact::Aabb;

/// A path of a kind near a box, often through a corner or an edge of the rounded box.
template <class S>
struct BallCase {
  Segment<S> path;
  S radius;
  Aabb<S> box;
};

template <class S>
BallCase<S> ball_case(Random& random, int kind) {
  BallCase<S> c;
  const S scale = size<S>(random, kind);
  const Vector3<S> a = vector<S>(random, kind) * scale, b = vector<S>(random, kind) * scale;
  c.box = {a.cwiseMin(b), a.cwiseMax(b)};
  c.radius = kind == 6   ? std::abs(generators::any_finite<S>(random))
             : kind == 1 ? S(random.integer(0, 5))
                         : S(std::abs(random.uniform(0, 0.7)) * double(scale));
  if (kind == 2) c.radius = S(5);
  Vector3<S> target;
  for (int k = 0; k < 3; ++k) target(k) = random.chance(0.5) ? c.box.low(k) : c.box.high(k);
  if ((kind == 1 || kind == 2) && random.chance(0.7)) {
    // Passes an edge or a corner at the distance 5: (3, 4, 0) and a direction perpendicular to it.
    const int i = random.integer(0, 2), j = (i + 1) % 3;
    const S side = random.chance(0.5) ? S(1) : S(-1), other = random.chance(0.5) ? S(1) : S(-1);
    target(i) += S(3) * side;
    target(j) += S(4) * other;
    Vector3<S> along = Vector3<S>::Zero();
    along(i) = S(-4) * side;
    along(j) = S(3) * other;
    if (random.chance(0.4)) along((i + 2) % 3) = S(random.integer(-3, 3));
    c.path = {Vector3<S>(target - along * S(random.integer(0, 3))),
              Vector3<S>(target + along * S(random.integer(0, 3)))};
    c.radius = S(5);
    if (kind == 2) {
      c.path.start = nudged<S>(random, c.path.start);
      if (random.chance(0.3)) c.radius = nudged<S>(random, c.radius);
    }
    return c;
  }
  const Ray<S> ray = ray_towards<S>(random, kind, target, scale);
  c.path = {ray.origin, Vector3<S>(ray.origin + ray.direction * S(1.5))};
  return c;
}

template <class S>
void compare_ball(int count, std::uint64_t seed) {
  Random random(seed);
  int met = 0, missed = 0, inside = 0, beside = 0;
  for (int i = 0; i < generators::tried(count); ++i) {
    const int kind = i % kinds;
    const BallCase<S> c = ball_case<S>(random, kind);
    if (!contact::is_finite(c.path)) continue;
    INFO("kind " << kind << ", case " << i);
    const auto all = regions(
        exact_line(c.path),
        RoundedBox{oracle::exact(c.box.low), oracle::exact(c.box.high), oracle::exact(c.radius)});
    const bool right = meets(all, true);
    REQUIRE(contact::ball_hits_box(c.path, c.radius, c.box) == right);
    const auto hit = contact::ball_first_hit(c.path, c.radius, c.box);
    REQUIRE(hit.has_value() == right);
    if (kind < 5) {  // the enlarged box misses nothing
      const bool enlarged = contact::ball_hits_enlarged_box(c.path, c.radius, c.box).has_value();
      if (right) REQUIRE(enlarged);
      beside += enlarged && !right ? 1 : 0;
    }
    ++(right ? met : missed);
    if (!hit) continue;
    const Found found = find(all);
    REQUIRE(hit->inside == (found.low_open || oracle::sign(found.low) < 0));
    inside += hit->inside ? 1 : 0;
    if (hit->inside) continue;
    REQUIRE(t_is(hit->t, found.low, std::abs(oracle::nearest(found.low)), 0x1p-40));
    REQUIRE(hit->t <= 1);
    if (kind > 2 || c.radius < S(0.05)) continue;
    const Vector3<double> p = hit->point.template cast<double>();
    const Vector3<double> away =
        p -
        p.cwiseMax(c.box.low.template cast<double>()).cwiseMin(c.box.high.template cast<double>());
    const double room = std::is_same_v<S, float> ? 1e-4 : 1e-10;
    REQUIRE((hit->normal.template cast<double>() - away / double(c.radius)).norm() < room);
  }
  CHECK(met > generators::tried(count) / 6);
  CHECK(missed > generators::tried(count) / 6);
  CHECK(inside > generators::tried(count) / 50);
  CHECK(beside > generators::tried(count) / 200);
}

TEST_CASE("moving balls touch boxes as they do in fractions, doubles and floats") {
  compare_ball<double>(2100, 51);
  compare_ball<float>(2100, 52);
}

TEST_CASE("a ball that passes a corner, and degenerate inputs") {
  const Aabb<double> box{{0, 0, 0}, {2, 2, 2}};
  const auto path = [](double y) { return Segment<double>{{-4, y, 1}, {y, -4, 1}}; };
  // At the corner (0, 0): the line x + y = −1.6 is 1.13 away, in the enlarged box.
  const Segment<double> passes{{-3.6, 2, 1}, {2, -3.6, 1}};
  CHECK(contact::ball_hits_enlarged_box(passes, 1.0, box));
  CHECK_FALSE(contact::ball_hits_box(passes, 1.0, box));
  CHECK_FALSE(contact::ball_first_hit(passes, 1.0, box));
  CHECK(contact::ball_first_hit(Segment<double>{{-5, 1, 1}, {5, 1, 1}}, 1.0, box)->t == 0.4);
  CHECK(contact::ball_first_hit(Segment<double>{{-5, 1, 1}, {5, 1, 1}}, 1.0, box)->normal ==
        Vector3<double>(-1, 0, 0));
  CHECK(contact::ball_first_hit(Segment<double>{{-5, 1, 1}, {-1, 1, 1}}, 1.0, box)->t == 1);
  CHECK(contact::ball_hits_box(Segment<double>{{-1, 1, 1}, {-1, 1, 1}}, 1.0, box));
  CHECK_FALSE(contact::ball_hits_box(Segment<double>{{std::nextafter(-1, -2), 1, 1}, {-5, 1, 1}},
                                     1.0, box));
  CHECK_FALSE(contact::ball_hits_box(path(-2), 1.0, box));
  CHECK_FALSE(contact::ball_hits_box(path(2), -1.0, box));
  CHECK_FALSE(contact::ball_hits_box(path(2), 1.0, Aabb<double>{{2, 2, 2}, {0, 0, 0}}));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double endless = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, endless}) {
    CHECK_FALSE(contact::ball_hits_box(path(bad), 1.0, box));
    CHECK_FALSE(contact::ball_hits_box(path(2), bad, box));
    CHECK_FALSE(contact::ball_hits_enlarged_box(path(2), bad, box));
    CHECK_FALSE(contact::ball_hits_box(path(2), 1.0, Aabb<double>{{0, 0, 0}, {2, 2, bad}}));
  }
}

}  // namespace
