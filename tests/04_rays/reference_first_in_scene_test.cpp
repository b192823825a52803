#include <04_rays/round_bodies.hpp>
#include <contact/first_in_scene.hpp>
#include <variant>

namespace {

using namespace bodies;
using contact::Aabb;
using contact::Capsule;
using contact::Cone;
using contact::Cylinder;
using contact::Matrix3;
using contact::OrientedBox;
using contact::Primitive;
using contact::Sphere;
using contact::Triangle;
using Scene = std::vector<Primitive<double>>;

Scene random_scene(Random& random, int kind, int count) {
  Scene scene;
  for (int i = 0; i < count; ++i) {
    const RoundCase<double> c = round_case<double>(random, kind);
    const Vector3<double> a = c.core.start, b = c.core.end;
    switch (random.integer(0, 6)) {
      case 0:
        scene.push_back(Sphere<double>{a, c.radius});
        break;
      case 1:
        scene.push_back(Aabb<double>{a.cwiseMin(b), a.cwiseMax(b)});
        break;
      case 2:
        scene.push_back(OrientedBox<double>{a, Matrix3<double>::Identity(),
                                            Vector3<double>::Constant(c.radius + 0.01)});
        break;
      case 3:
        scene.push_back(Cylinder<double>{c.core, c.radius});
        break;
      case 4:
        scene.push_back(Capsule<double>{c.core, c.radius});
        break;
      case 5:
        scene.push_back(Cone<double>{a, b, c.radius});
        break;
      default:
        scene.push_back(Triangle<double>{a, b, vector<double>(random, kind)});
    }
    if (random.chance(0.1)) scene.push_back(scene.back());  // a tie
  }
  return scene;
}

/// All t of a body of a scene, in fractions and roots.
struct InFractions {
  const Line& line;
  std::vector<Region> operator()(const Sphere<double>& x) const {
    return {{ball(line.origin - oracle::exact(x.centre), line.direction, oracle::exact(x.radius))}};
  }
  std::vector<Region> operator()(const Aabb<double>& x) const {
    Region box;
    for (int k = 0; k < 3; ++k) {
      between(box, line.origin(k), line.direction(k), oracle::exact(x.low(k)),
              oracle::exact(x.high(k)));
    }
    return {box};
  }
  std::vector<Region> operator()(
      const OrientedBox<double>& x) const {  // whose axes are the world's
    Region box;
    for (int k = 0; k < 3; ++k) {
      between(box, line.origin(k) - oracle::exact(x.centre(k)), line.direction(k),
              -oracle::exact(x.half_lengths(k)), oracle::exact(x.half_lengths(k)));
    }
    return {box};
  }
  std::vector<Region> operator()(const Triangle<double>& x) const {
    const auto t = oracle::exact(x);
    const Point n = Point(t.b - t.a).cross(Point(t.c - t.a));
    Region plane;
    between(plane, n.dot(line.origin - t.a), n.dot(line.direction), 0, 0);
    // The weights of the vertices, which are fractions of n·n at the point.
    for (const auto& [from, to] : {std::pair{t.a, t.b}, {t.b, t.c}, {t.c, t.a}}) {
      const Point inwards = n.cross(Point(to - from));
      plane.push_back({0, -inwards.dot(line.direction), -inwards.dot(line.origin - from)});
    }
    if (n.dot(line.direction) == 0) return {};  // parallel, or no area
    return {plane};
  }
  template <class Round>
  std::vector<Region> operator()(const Round& x) const {
    return regions(line, x);
  }
};

/// The t at which a line enters a body, at least 0.
std::optional<Surd> entry(const Line& line, const Primitive<double>& body, bool has_end) {
  const auto all = std::visit(InFractions{line}, body);
  if (!meets(all, has_end)) return std::nullopt;
  const Found found = find(all);
  return found.low_open || oracle::sign(found.low) < 0 ? Surd{0, 0, 0} : found.low;
}

TEST_CASE("the first hit of a scene is the least t, of equal ones the lowest index") {
  Random random(61);
  int met = 0, ties = 0;
  for (int i = 0; i < generators::tried(1050); ++i) {
    const int kind = i % kinds;
    const Scene scene = random_scene(random, kind, 8);
    const RoundCase<double> c = round_case<double>(random, kind);
    if (!contact::is_finite(c.ray)) continue;
    const Segment<double> segment{c.ray.origin, c.ray.origin + c.ray.direction * 1.5};
    const auto check = [&](const auto& line, bool has_end) {
      const Line exact = exact_line(line);
      std::vector<std::pair<Surd, std::size_t>> right;
      for (std::size_t k = 0; k < scene.size(); ++k) {
        if (const auto t = entry(exact, scene[k], has_end)) right.push_back({*t, k});
      }
      std::stable_sort(right.begin(), right.end(), [](const auto& a, const auto& b) {
        return oracle::compare(a.first, b.first) < 0;
      });
      const auto first = contact::first_in_scene<double>(line, scene);
      const auto all = contact::all_in_scene<double>(line, scene);
      INFO("kind " << kind << ", case " << i);
      REQUIRE(first.has_value() == !right.empty());
      REQUIRE(all.size() == right.size());
      if (!first) return;
      ++met;
      REQUIRE(first->index == right[0].second);
      for (std::size_t k = 0; k < all.size(); ++k) {
        REQUIRE(all[k].index == right[k].second);
        if (k > 0 && oracle::compare(right[k - 1].first, right[k].first) == 0) ++ties;
      }
    };
    check(c.ray, false);
    if (contact::is_finite(segment)) check(segment, true);
  }
  CHECK(met > generators::tried(500));
  CHECK(ties > generators::tried(100));
}

TEST_CASE("a scene of one body of each kind, a triangle's side, an empty scene") {
  const Scene scene{
      Sphere<double>{{0, 0, 0}, 1},
      Aabb<double>{{3, -1, -1}, {4, 1, 1}},
      OrientedBox<double>{{7, 0, 0}, Matrix3<double>::Identity(), {1, 1, 1}},
      Cylinder<double>{{{10, 0, -1}, {10, 0, 1}}, 1},
      Capsule<double>{{{13, 0, -1}, {13, 0, 1}}, 1},
      Cone<double>{{15, 0, 0}, {16, 0, 0}, 1},
      Triangle<double>{{18, -1, -1}, {18, 2, -1}, {18, -1, 2}},
  };
  const auto all = contact::all_in_scene<double>(Ray<double>{{-4, 0, 0}, {2, 0, 0}}, scene);
  REQUIRE(all.size() == 7);
  const double at[] = {1.5, 3.5, 5, 6.5, 8, 9.5, 11};
  for (std::size_t k = 0; k < 7; ++k) {
    CHECK(all[k].index == k);
    CHECK(std::abs(all[k].hit.t - at[k]) < 1e-12);
    CHECK((all[k].hit.normal - Vector3<double>(-1, 0, 0)).norm() < 1e-12);
  }
  const auto back = contact::first_in_scene<double>(Ray<double>{{30, 0, 0}, {-2, 0, 0}}, scene);
  REQUIRE(back);
  CHECK(back->index == 6);
  CHECK(back->hit.normal == Vector3<double>(1, 0, 0));
  CHECK_FALSE(contact::first_in_scene<double>(Ray<double>{{0, 5, 0}, {0, 1, 0}}, scene));
  CHECK_FALSE(contact::first_in_scene<double>(Ray<double>{{0, 0, 0}, {0, 1, 0}}, Scene{}));
}

/// Zeros, whole numbers, the largest and smallest numbers, and any others.
template <class S>
Vector3<S> wild(Random& random) {
  Vector3<S> v;
  for (int k = 0; k < 3; ++k) {
    const S x = generators::any_finite<S>(random);
    const S choices[] = {S(0), std::copysign(std::numeric_limits<S>::max(), x),
                         std::copysign(std::numeric_limits<S>::denorm_min(), x),
                         S(random.integer(-2, 2)), x};
    v(k) = choices[random.integer(0, 4)];
  }
  return v;
}

template <class S>
void no_nan(int count, std::uint64_t seed) {
  Random random(seed);
  int met = 0;
  const auto check = [&met](const std::optional<BodyHit<S>>& hit) {
    if (!hit) return;
    ++met;
    REQUIRE(hit->t >= 0);
    for (int k = 0; k < 3; ++k) {
      REQUIRE_FALSE(std::isnan(hit->point(k)));
      REQUIRE(std::isfinite(hit->normal(k)));
    }
  };
  for (int i = 0; i < generators::tried(count); ++i) {
    const Vector3<S> a = wild<S>(random), b = wild<S>(random);
    const S radius = std::abs(wild<S>(random)(0));
    const Ray<S> ray{wild<S>(random), wild<S>(random)};
    const Segment<S> segment{ray.origin, ray.direction};
    const std::vector<Primitive<S>> scene{Cylinder<S>{{a, b}, radius}, Capsule<S>{{a, b}, radius},
                                          Cone<S>{a, b, radius},
                                          Triangle<S>{a, b, wild<S>(random)}};
    INFO("case " << i);
    for (const auto& body : scene) {
      check(contact::first_hit(ray, body));
      check(contact::first_hit(segment, body));
    }
    const Cylinder<S> tube{{a, b}, radius};
    check(contact::first_hit_open(ray, tube));
    check(contact::first_hit_open(segment, tube));
    check(contact::ball_first_hit(segment, radius, Aabb<S>{a.cwiseMin(b), a.cwiseMax(b)}));
  }
  CHECK(met > generators::tried(count) / 4);
}

TEST_CASE("finite input never gives NaN, whatever overflows") {
  no_nan<double>(800, 63);
  no_nan<float>(2000, 64);
}

TEST_CASE("samples miss a thin wall that segments find") {
  const Scene scene{Aabb<double>{{9.9, -5, -5}, {9.95, 5, 5}}, Sphere<double>{{40, 0, 0}, 6}};
  const Vector3<double> start(0, 0, 0), displacement(4, 0, 0);
  const auto sampled = contact::bullet_by_samples<double>(start, displacement, 20, scene);
  const auto swept = contact::bullet_by_segments<double>(start, displacement, 20, scene);
  REQUIRE(sampled);
  CHECK(sampled->index == 1);  // it has passed the wall
  CHECK(sampled->step == 8);
  CHECK(sampled->hit.inside);
  REQUIRE(swept);
  CHECK(swept->index == 0);
  CHECK(swept->step == 2);
  CHECK(std::abs(swept->hit.t - (9.9 - 8) / 4) < 1e-12);
  CHECK_FALSE(contact::bullet_by_segments<double>(start, displacement, 2, scene));
  CHECK_FALSE(contact::bullet_by_segments<double>(start, displacement, 0, scene));
  // Slower than the wall is thick, samples find it.
  const auto slow = contact::bullet_by_samples<double>(start, {0.04, 0, 0}, 1000, scene);
  REQUIRE(slow);
  CHECK(slow->index == 0);
  // A start inside a body is met in step 0.
  CHECK(contact::bullet_by_segments<double>({40, 0, 0}, displacement, 3, scene)->hit.inside);
}

TEST_CASE("no segment of a path is missed: whatever a sample is in, a segment has met before") {
  Random random(62);
  int found = 0;
  for (int i = 0; i < generators::tried(1000); ++i) {
    Scene scene = random_scene(random, i % 2, 6);
    const RoundCase<double> c = round_case<double>(random, i % 2);
    const Vector3<double> step = c.ray.direction / 8;
    const auto sampled = contact::bullet_by_samples<double>(c.ray.origin, step, 12, scene);
    if (!sampled) continue;
    ++found;
    const auto swept = contact::bullet_by_segments<double>(c.ray.origin, step, 12, scene);
    REQUIRE(swept);
    REQUIRE(swept->step <= sampled->step);
  }
  CHECK(found > generators::tried(200));
}

}  // namespace
