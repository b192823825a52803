#include <04_rays/slab_truth.hpp>
#include <Eigen/Geometry>
#include <contact/ray_box.hpp>

namespace {

using namespace rays;
using contact::Aabb;
using contact::BodyHit;
using contact::OrientedBox;
using contact::Passage;

constexpr double u = 0x1p-53;

template <class S>
Aabb<S> random_box(Random& random, int kind, S scale) {
  Vector3<S> a = vector<S>(random, kind) * scale;
  Vector3<S> b = vector<S>(random, kind) * scale;
  if (random.chance(0.05)) b(random.integer(0, 2)) = a(0);
  return {a.cwiseMin(b), a.cwiseMax(b)};
}

/// A point of an edge, a corner or a face of a box, or inside.
template <class S>
Vector3<S> point_of(Random& random, const Aabb<S>& box) {
  Vector3<S> p;
  for (int k = 0; k < 3; ++k) {
    const S share = S(random.integer(0, 8)) / S(8);
    p(k) = random.chance(0.4)   ? box.low(k)
           : random.chance(0.5) ? box.high(k)
                                : box.low(k) * (S(1) - share) + box.high(k) * share;
  }
  return p;
}

template <class S, class Line>
std::vector<ExactSlab> slabs(const Line& line, const Aabb<S>& box) {
  const Ray<Rational> exact = exact_line(line);
  std::vector<ExactSlab> result;
  for (int k = 0; k < 3; ++k) {
    result.push_back({exact.origin(k), exact.direction(k), oracle::exact(box.low(k)),
                      oracle::exact(box.high(k))});
  }
  return result;
}

/// In the coordinates of the box's own axes, by Cramer's rule.
template <class S, class Line>
std::vector<ExactSlab> slabs(const Line& line, const OrientedBox<S>& box) {
  const Ray<Rational> exact = exact_line(line);
  std::array<Vector3<Rational>, 3> axes;
  for (int k = 0; k < 3; ++k) axes[std::size_t(k)] = oracle::exact(Vector3<S>(box.axes.col(k)));
  const auto volume = [](const Vector3<Rational>& a, const Vector3<Rational>& b,
                         const Vector3<Rational>& c) -> Rational { return a.dot(b.cross(c)); };
  const Rational whole = volume(axes[0], axes[1], axes[2]);
  const Vector3<Rational> m = exact.origin - oracle::exact(box.centre);
  const auto along = [&](const Vector3<Rational>& x, std::size_t k) -> Rational {
    auto replaced = axes;
    replaced[k] = x;
    return volume(replaced[0], replaced[1], replaced[2]) / whole;
  };
  std::vector<ExactSlab> result;
  for (std::size_t k = 0; k < 3; ++k) {
    const Rational half = oracle::exact(box.half_lengths(int(k)));
    result.push_back({along(m, k), along(exact.direction, k), Rational(-half), half});
  }
  return result;
}

const auto meets_box = [](const auto& line, const auto& box) {
  return contact::hits_box(line, box);
};

template <class S, class Use>
void lines_at(Random& random, int kind, const Aabb<S>& box, S scale, const Use& use) {
  const Vector3<S> target = point_of<S>(random, box);
  Ray<S> ray = ray_towards<S>(random, kind, target, scale);
  if (random.chance(0.2)) ray.origin = point_of<S>(random, box);
  if (random.chance(0.1)) ray.origin(random.integer(0, 2)) = target(0);
  if (random.chance(0.2)) {  // in a face
    const int k = random.integer(0, 2);
    ray.origin(k) = random.chance(0.5) ? box.low(k) : box.high(k);
    ray.direction(k) = random.chance(0.5) ? S(0) : -S(0);
  }
  if (!usable(ray)) return;
  use(ray);
  const Segment<S> segment{ray.origin,
                           random.chance(0.5) ? target : Vector3<S>(ray.origin + ray.direction)};
  if (contact::is_finite(segment)) use(segment);
}

template <class S>
void compare_boxes(int count, std::uint64_t seed) {
  Random random(seed);
  std::map<int, int> seen;
  for (int i = 0; i < generators::tried(count); ++i) {
    const int kind = i % kinds;
    INFO("kind " << kind << ", case " << i);
    const S scale = size<S>(random, kind);
    const Aabb<S> box = random_box<S>(random, kind, scale);
    if (!contact::all_finite(box.low) || !contact::all_finite(box.high)) continue;
    lines_at<S>(random, kind, box, scale, [&](const auto& line) {
      compare_slabs<S>(line, box, slabs<S>(line, box), meets_box, 3 * u, seen);
      const auto hit = contact::first_hit(line, box);
      if (!hit || hit->inside) return;
      const int k = hit->face / 2;
      REQUIRE(hit->point(k) == (hit->face % 2 == 1 ? box.high(k) : box.low(k)));
      REQUIRE((hit->point.array() >= box.low.array()).all());
      REQUIRE((hit->point.array() <= box.high.array()).all());
    });
  }
  for (const int what : {0, 1, 2, 3}) CHECK(seen[what] > generators::tried(count) / 100);
}

TEST_CASE("a line against a box is decided as in fractions, in double") {
  compare_boxes<double>(40000, 3);
}
TEST_CASE("a line against a box is decided as in fractions, in float") {
  compare_boxes<float>(40000, 4);
}

template <class S>
void compare_oriented(int count, std::uint64_t seed) {
  Random random(seed);
  std::map<int, int> seen;
  for (int i = 0; i < generators::tried(count); ++i) {
    const int kind = i % 6;
    INFO("kind " << kind << ", case " << i);
    const S scale = size<S>(random, kind);
    OrientedBox<S> box;
    box.centre = vector<S>(random, kind) * scale;
    box.half_lengths = (vector<S>(random, kind).cwiseAbs() + Vector3<S>::Constant(S(0.5))) * scale;
    if (kind == 1 || kind == 5) {  // axes in another order, which is exact
      box.axes = Eigen::Matrix<S, 3, 3>::Zero();
      const int first = random.integer(0, 2);
      for (int k = 0; k < 3; ++k) box.axes((k + first) % 3, k) = random.chance(0.5) ? S(1) : S(-1);
    } else {
      const Eigen::Vector4d q(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1),
                              random.uniform(-1, 1));
      box.axes = Eigen::Quaterniond(q).normalized().toRotationMatrix().template cast<S>();
    }
    const Aabb<S> bounds{Vector3<S>(-box.half_lengths), box.half_lengths};
    lines_at<S>(random, kind, bounds, scale, [&](const auto& line) {
      const auto moved = [&](const Vector3<S>& x) {
        return Vector3<S>(box.centre + Vector3<S>(box.axes * x));
      };
      auto there = line;
      if constexpr (contact::has_end<decltype(there)>) {
        there = {moved(line.start), moved(line.end)};
      } else {
        there = {moved(line.origin), Vector3<S>(box.axes * line.direction)};
      }
      if (!contact::is_finite(there)) return;
      compare_slabs<S>(there, box, slabs<S>(there, box), meets_box, 0x1p-40, seen);
    });
  }
  for (const int what : {0, 1, 2, 3}) CHECK(seen[what] > generators::tried(count) / 400);
}

TEST_CASE("a line against an oriented box is decided as in fractions, in double") {
  compare_oriented<double>(9000, 5);
}
TEST_CASE("a line against an oriented box is decided as in fractions, in float") {
  compare_oriented<float>(9000, 6);
}

TEST_CASE("the padded slabs of a ray lose no hit") {
  Random random(7);
  int near = 0;
  for (int i = 0; i < generators::tried(60000); ++i) {
    const int kind = i % 5;
    const Aabb<double> box = random_box<double>(random, kind, 1.0);
    Ray<double> ray = ray_towards<double>(random, kind, point_of<double>(random, box), 1.0);
    // 0, or a component whose reciprocal is infinite, makes NaN: not promised.
    if ((ray.direction.array().abs() < 0x1p-1000).any()) continue;
    const auto found = contact::passage_by_padded_slabs(ray, box);
    const bool said = found && found->exit >= 0;
    const bool right = contact::hits_box(ray, box);
    if (right) REQUIRE(said);
    near += said && !right ? 1 : 0;
  }
  CHECK(near > 0);
}

TEST_CASE("numbers that are not finite are no hit of a box") {
  constexpr double inf = std::numeric_limits<double>::infinity();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const Aabb<double> box{{-1, -1, -1}, {1, 1, 1}};
  for (const double bad : {inf, -inf, nan}) {
    for (int k = 0; k < 3; ++k) {
      Ray<double> ray{{-3, 0.5, 0.25}, {1, 0.0625, 0.03125}};
      CHECK(contact::hits_box(ray, box));
      ray.origin(k) = bad;
      CHECK_FALSE(contact::hits_box(ray, box));
      CHECK_FALSE(contact::first_hit(ray, box));
      CHECK_FALSE(contact::passage(ray, box));
      ray.origin(k) = 0;
      ray.direction(k) = bad;
      CHECK_FALSE(contact::hits_box(ray, box));
      CHECK_FALSE(contact::first_hit(ray, box));
      Segment<double> segment{{0, 0, 0}, {3, 3, 3}};
      segment.end(k) = bad;
      CHECK_FALSE(contact::hits_box(segment, box));
      OrientedBox<double> turned;
      turned.half_lengths = {1, 1, 1};
      CHECK_FALSE(contact::hits_box(ray, turned));
      turned.centre(k) = bad;
      CHECK_FALSE(contact::hits_box(Ray<double>{{0, 0, 0}, {1, 0, 0}}, turned));
    }
  }
}

TEST_CASE("a difference that overflows decides nothing") {
  // Along x the box is left at 1.5 × 2^525; along y it is reached at 2^600, or at 2^500.
  const Aabb<double> box{{-1, 0x1p600, -1}, {0x1.8p1023, 0x1p700, 1}};
  const Ray<double> ray{{-0x1.8p1023, 0, 0}, {0x1p499, 1, 0x1p-490}};
  const Aabb<double> wide{{-1, 0x1p600, -1}, {0x1.8p1023, 0x1p700, 0x1p300}};
  CHECK_FALSE(contact::hits_box(ray, wide));
  CHECK_FALSE(contact::first_hit(ray, wide));
  CHECK_FALSE(contact::hits_box(ray, box));
  const Aabb<double> nearer{{-1, 0x1p500, -1}, {0x1.8p1023, 0x1p700, 1}};
  CHECK_FALSE(contact::hits_box(ray, nearer));
  const Ray<double> level{{-0x1.8p1023, 0, 0}, {0x1p499, 1, 0}};
  CHECK_FALSE(contact::hits_box(level, box));
  CHECK(contact::hits_box(level, nearer));
}

TEST_CASE("0 times infinity: a ray in the plane of a face") {
  const Aabb<double> box{{0, 0, 0}, {2, 2, 2}};
  const Ray<double> ray{{0, 1, -1}, {0, 0, 1}};  // in the face x = 0
  const auto hit = contact::first_hit(ray, box);
  REQUIRE(hit);
  CHECK(hit->t == 1);
  CHECK(hit->face == contact::box_face(2, false));
  CHECK(hit->point == Vector3<double>(0, 1, 0));
}

}  // namespace
