#include <04_rays/lines.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <contact/ray_sphere.hpp>
#include <map>

namespace {

using namespace rays;
using contact::BodyHit;
using contact::LineMeets;
using contact::Passage;
using contact::Sphere;
using oracle::Quadratic;
using oracle::Surd;

template <class S>
Sphere<S> random_ball(Random& random, int kind, S scale) {
  Sphere<S> ball{Vector3<S>(vector<S>(random, kind) * scale), S(0)};
  ball.radius = kind == 6   ? std::abs(generators::any_finite<S>(random))
                : kind == 1 ? S(random.integer(0, 6))
                            : S(std::abs(random.uniform(0, 0.7)) * double(scale));
  return ball;
}

/// A line that touches a ball in whole numbers: the offset, the normal to the direction, is (a, b,
/// 0) of a right triangle, so that its length is whole.
template <class S>
std::pair<Ray<S>, Sphere<S>> tangent(Random& random) {
  static constexpr int triples[4][3] = {{3, 4, 5}, {5, 12, 13}, {8, 15, 17}, {0, 7, 7}};
  const auto& [a, b, c] = triples[random.integer(0, 3)];
  const Vector3<S> centre = vector<S>(random, 1);
  const Vector3<S> along(S(-b), S(a), S(random.integer(-9, 9)));
  const Vector3<S> offset(S(a), S(b), S(0));
  const S steps = S(random.integer(-1000, 1000));
  return {{Vector3<S>(centre + offset + along * steps),
           Vector3<S>(along * S(random.integer(1, 3) * (random.chance(0.5) ? 1 : -1)))},
          {centre, S(c)}};
}

/// Another way than by the discriminant: the least distance of the line, from start to last, to the
/// centre.
bool meets(const Ray<Rational>& line, const Sphere<Rational>& ball, bool from_start, bool to_end) {
  const Vector3<Rational> m = line.origin - ball.centre;
  const Rational a = line.direction.dot(line.direction);
  Rational t = a == 0 ? Rational(0) : Rational(-line.direction.dot(m) / a);
  if (from_start && t < 0) t = 0;
  if (to_end && t > 1) t = 1;
  const Vector3<Rational> nearest = m + line.direction * t;
  return nearest.dot(nearest) <= ball.radius * ball.radius;
}

template <class S, class Line>
void compare(const Line& line, const Sphere<S>& ball, std::map<int, int>& seen) {
  constexpr bool ends = contact::has_end<Line>;
  const Ray<Rational> exact = exact_line(line);
  const Sphere<Rational> body = oracle::exact(ball);
  const bool crosses = meets(exact, body, false, false);
  const bool hits = meets(exact, body, true, ends);
  const LineMeets crossing = contact::sphere_crossing(line, ball);
  REQUIRE((crossing != LineMeets::misses) == crosses);
  REQUIRE(contact::hits_sphere(line, ball) == hits);
  const std::optional<Passage<S>> passage = contact::passage(line, ball);
  const std::optional<BodyHit<S>> hit = contact::first_hit(line, ball);
  REQUIRE(passage.has_value() == crosses);
  REQUIRE(hit.has_value() == hits);
  ++seen[hits ? 1 : 0];
  const Vector3<Rational> m = exact.origin - body.centre;
  const Quadratic form{exact.direction.dot(exact.direction), 2 * exact.direction.dot(m),
                       m.dot(m) - body.radius * body.radius};
  if (form.a == 0) {
    if (hits) REQUIRE(hit->inside);
    return;
  }
  if (!crosses) return;
  REQUIRE((form.discriminant() == 0) == (crossing == LineMeets::touches));
  if (form.discriminant() == 0) ++seen[2];
  const std::vector<Surd> roots = form.roots();
  REQUIRE(passage->entry <= passage->exit);
  if (form.discriminant() == 0) REQUIRE(passage->entry == passage->exit);
  const double largest =
      std::max(std::abs(oracle::nearest(roots.front())), std::abs(oracle::nearest(roots.back())));
  REQUIRE(t_is(passage->exit, roots.back(), largest, 0x1p-40));
  for (int end = 0; end < 2 && body.radius != 0; ++end) {
    const Vector3<double> normal =
        (end == 0 ? passage->entry_normal : passage->exit_normal).template cast<double>();
    for (int k = 0; k < 3; ++k) {
      const Surd exact_normal =
          (roots[end == 0 ? 0 : roots.size() - 1] * exact.direction(k) + m(k)) *
          Rational(1 / body.radius);
      REQUIRE(oracle::error(normal(k), exact_normal) <= 0x1p-20);
    }
  }
  REQUIRE(std::abs(double(passage->entry_normal.norm()) - 1) < 4e-7);
  REQUIRE(std::abs(double(passage->exit_normal.norm()) - 1) < 4e-7);
  if (!hits) return;
  const bool inside = oracle::sign(roots.front()) < 0 && oracle::sign(roots.back()) >= 0;
  REQUIRE(hit->inside == inside);
  REQUIRE(hit->t >= S(0));
  if (ends) REQUIRE(hit->t <= S(1));
  if (inside) {
    ++seen[3];
    REQUIRE(hit->t == S(0));
    REQUIRE(hit->point == contact::start_of(line));
    REQUIRE(hit->normal == Vector3<S>::Zero());
    return;
  }
  REQUIRE(t_is(hit->t, roots.front(), largest, 0x1p-40));
  REQUIRE(hit->normal == passage->entry_normal);
  REQUIRE(hit->face == -1);
  // The point is on the surface, as near as its coordinates and t allow.
  const Vector3<double> p = hit->point.template cast<double>();
  const double reach = largest * contact::ray_of(line).direction.template cast<double>().norm();
  const double sizes = ball.centre.template cast<double>().norm() + double(ball.radius) +
                       contact::start_of(line).template cast<double>().norm() + reach;
  if (!(sizes < 1e150) || !contact::all_finite(p) || !(sizes > 1e-150)) return;
  const double room =
      (std::is_same_v<S, float> ? 0x1p-22 : 0x1p-51) *
          (ball.centre.template cast<double>().cwiseAbs().sum() + double(ball.radius)) +
      0x1p-20 * double(ball.radius) + 4 * double(std::numeric_limits<S>::denorm_min());
  const Vector3<Rational> from_centre = oracle::exact(p) - body.centre;
  const Rational squared = from_centre.dot(from_centre);
  const Rational low = std::max<Rational>(Rational(0), body.radius - oracle::exact(room));
  const Rational high = body.radius + oracle::exact(room);
  REQUIRE(squared >= low * low);
  REQUIRE(squared <= high * high);
  // And the normal leads from the centre to it.
  const Vector3<double> there = (hit->normal.template cast<double>() * double(ball.radius)) +
                                ball.centre.template cast<double>();
  REQUIRE((there - p).norm() <= 4 * room);
}

template <class S>
void compare_all(int count, std::uint64_t seed) {
  Random random(seed);
  std::map<int, int> seen;
  for (int i = 0; i < generators::tried(count); ++i) {
    const int kind = i % kinds;
    INFO("kind " << kind << ", case " << i);
    const S scale = size<S>(random, kind);
    Sphere<S> ball = random_ball<S>(random, kind, scale);
    Ray<S> ray = ray_towards<S>(
        random, kind, Vector3<S>(ball.centre + vector<S>(random, kind) * ball.radius * S(0.9)),
        scale);
    if (kind == 2 && random.chance(0.7)) {
      std::tie(ray, ball) = tangent<S>(random);
      if (random.chance(0.8)) ray.origin = nudged<S>(random, ray.origin);
      if (random.chance(0.3)) ball.radius = nudged<S>(random, ball.radius);
    } else if (kind == 1 && random.chance(0.5)) {
      std::tie(ray, ball) = tangent<S>(random);
    } else if (kind == 0 && random.chance(0.3)) {
      // From the surface, or nearly.
      ray.origin = nudged<S>(
          random, Vector3<S>(ball.centre + vector<S>(random, 0).normalized() * ball.radius));
    }
    if (!usable(ray) || !contact::is_ball(ball)) continue;
    compare<S>(ray, ball, seen);
    const Segment<S> segment{ray.origin, Vector3<S>(ray.origin + ray.direction)};
    if (contact::is_finite(segment)) compare<S>(segment, ball, seen);
    Segment<S> ending{ray.origin, Vector3<S>(ball.centre + (ray.origin - ball.centre).normalized() *
                                                               ball.radius)};
    if (contact::is_finite(ending)) compare<S>(ending, ball, seen);
  }
  for (const int what : {0, 1, 2, 3}) CHECK(seen[what] > count / 100);
}

TEST_CASE("a ray against a ball is decided as in fractions, in double") {
  compare_all<double>(21000, 1);
}
TEST_CASE("a ray against a ball is decided as in fractions, in float") {
  compare_all<float>(21000, 2);
}

TEST_CASE("numbers that are not finite are no hit of a ball, and no ball") {
  constexpr double inf = std::numeric_limits<double>::infinity();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const Sphere<double> ball{{0, 0, 0}, 2};
  for (const double bad : {inf, -inf, nan}) {
    for (int k = 0; k < 3; ++k) {
      for (const double start : {0.5, -3.0}) {  // inside and outside
        Ray<double> ray{{start, 0.25, 0.125}, {1, 0.0625, 0.03125}};
        CHECK(contact::hits_sphere(ray, ball));
        ray.direction(k) = bad;
        CHECK_FALSE(contact::hits_sphere(ray, ball));
        CHECK_FALSE(contact::first_hit(ray, ball));
        CHECK_FALSE(contact::passage(ray, ball));
        ray.direction(k) = 1;
        ray.origin(k) = bad;
        CHECK_FALSE(contact::hits_sphere(ray, ball));
        Segment<double> segment{{start, 0, 0}, {3, 3, 3}};
        segment.end(k) = bad;
        CHECK_FALSE(contact::hits_sphere(segment, ball));
      }
      Sphere<double> other = ball;
      other.centre(k) = bad;
      CHECK_FALSE(contact::hits_sphere(Ray<double>{{0, 0, 0}, {1, 0, 0}}, other));
    }
    CHECK_FALSE(
        contact::hits_sphere(Ray<double>{{0, 0, 0}, {1, 0, 0}}, Sphere<double>{{0, 0, 0}, bad}));
  }
  CHECK_FALSE(
      contact::hits_sphere(Ray<double>{{0, 0, 0}, {1, 0, 0}}, Sphere<double>{{0, 0, 0}, -2.0}));
  CHECK_FALSE(
      contact::hits_sphere(Ray<double>{{-5, 0, 0}, {1, 0, 0}}, Sphere<double>{{0, 0, 0}, -2.0}));
}

TEST_CASE("a square that overflows leaves the normal alone") {
  // m·m and 2^50 r² are both infinite.
  const Ray<double> ray{{0, 0, 0x1p614}, {0, 0, 1}};
  const auto found = contact::passage(ray, Sphere<double>{{0, 0, 0}, 0x1p487});
  REQUIRE(found);
  CHECK(found->entry_normal == Vector3<double>(0, 0, -1));
  CHECK(found->exit_normal == Vector3<double>(0, 0, 1));
}

TEST_CASE("a start on the surface: inwards, along it and outwards") {
  const Sphere<double> ball{{0, 0, 0}, 5};
  const Vector3<double> start(3, 4, 0);
  const auto inwards = contact::first_hit(Ray<double>{start, {-3, -4, 0}}, ball);
  REQUIRE(inwards);
  CHECK((inwards->t == 0 && !inwards->inside && inwards->point == start));
  CHECK((inwards->normal - start / 5).norm() < 1e-15);
  const auto along = contact::first_hit(Ray<double>{start, {-4, 3, 0}}, ball);
  REQUIRE(along);
  CHECK((along->t == 0 && !along->inside));
  const auto outwards = contact::first_hit(Ray<double>{start, {1, 0, 0}}, ball);
  REQUIRE(outwards);
  CHECK((outwards->t == 0 && outwards->inside));
}

}  // namespace
