#include <04_rays/slab_truth.hpp>
#include <contact/ray_kdop.hpp>
#include <limits>
#include <stdexcept>

namespace {

using namespace rays;
using contact::Kdop;

template <class S, class Line>
std::vector<ExactSlab> slabs(const Line& line, const Kdop<S>& dop) {
  const Ray<Rational> exact = exact_line(line);
  std::vector<ExactSlab> result;
  for (std::size_t k = 0; k < dop.normals.size(); ++k) {
    const Vector3<Rational> n = oracle::exact(dop.normals[k]);
    result.push_back({n.dot(exact.origin), n.dot(exact.direction), oracle::exact(dop.low[k]),
                      oracle::exact(dop.high[k])});
  }
  return result;
}

const auto meets_kdop = [](const auto& line, const auto& dop) {
  return contact::hits_kdop(line, dop);
};

template <class S>
void compare_kdops(int count, std::uint64_t seed) {
  Random random(seed);
  std::map<int, int> seen;
  for (int i = 0; i < generators::tried(count); ++i) {
    const int kind = i % kinds;
    INFO("kind " << kind << ", case " << i);
    const S scale = size<S>(random, kind);
    std::vector<Vector3<S>> points;
    for (int n = random.integer(1, 8); n > 0; --n)
      points.push_back(vector<S>(random, kind) * scale);
    static constexpr int sizes[4] = {6, 14, 18, 26};
    std::vector<Vector3<S>> normals = contact::kdop_normals<S>(sizes[random.integer(0, 3)]);
    if (random.chance(0.3)) {
      for (Vector3<S>& n : normals) n = vector<S>(random, kind == 6 ? 0 : kind) + n * S(20);
    }
    bool usable_points = true;
    for (const auto& p : points) usable_points = usable_points && contact::all_finite(p);
    if (!usable_points) continue;
    const Kdop<S> dop = contact::kdop_of_points<S>(normals, points);
    for (std::size_t k = 0; k < normals.size(); ++k) {  // outward, and by less than an ulp
      for (const auto& p : points) {
        const Rational at = oracle::exact(normals[k]).dot(oracle::exact(p));
        if (std::isfinite(dop.low[k])) REQUIRE(oracle::exact(dop.low[k]) <= at);
        if (std::isfinite(dop.high[k])) REQUIRE(oracle::exact(dop.high[k]) >= at);
      }
    }
    if (!contact::detail::dop_is_finite(dop)) continue;
    const Vector3<S> target = points[0] + (points.back() - points[0]) * S(0.5);
    const Ray<S> ray = ray_towards<S>(random, kind, random.chance(0.5) ? points[0] : target, scale);
    if (!usable(ray)) continue;
    compare_slabs<S>(ray, dop, slabs<S>(ray, dop), meets_kdop, 0x1p-40, seen);
    const Segment<S> segment{random.chance(0.1) ? target : ray.origin, points[0]};
    if (contact::is_finite(segment))
      compare_slabs<S>(segment, dop, slabs<S>(segment, dop), meets_kdop, 0x1p-40, seen);
  }
  for (const int what : {0, 1, 2, 3}) CHECK(seen[what] > generators::tried(count) / 200);
}

TEST_CASE("a line against a k-DOP is decided as in fractions, in double") {
  compare_kdops<double>(6000, 8);
}
TEST_CASE("a line against a k-DOP is decided as in fractions, in float") {
  compare_kdops<float>(6000, 9);
}

TEST_CASE("a 14-DOP of a cube's corners is the cube; of an octahedron's it cuts the box") {
  const auto normals = contact::kdop_normals<double>(14);
  const std::vector<Vector3<double>> corners{{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                             {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};
  const Kdop<double> octahedron = contact::kdop_of_points<double>(normals, corners);
  // In the box, beside the octahedron.
  const Ray<double> ray{{0.75, 0.75, -5}, {0, 0, 1}};
  CHECK_FALSE(contact::hits_kdop(ray, octahedron));
  const auto hit = contact::first_hit(Ray<double>{{0.25, 0.25, -5}, {0, 0, 1}}, octahedron);
  REQUIRE(hit);
  CHECK(hit->t == 4.5);
  CHECK(hit->face == 9);  // x + y - z <= 1
}

TEST_CASE("a k-DOP of points contains them also where a bound overflows") {
  for (const double sign : {1.0, -1.0}) {
    const std::vector<Vector3<double>> points{Vector3<double>(1e308, 1e308, 1e308) * sign};
    const Kdop<double> dop =
        contact::kdop_of_points<double>(contact::kdop_normals<double>(14), points);
    for (std::size_t k = 0; k < dop.normals.size(); ++k) {
      const contact::Exact at =
          contact::exact_vector(dop.normals[k]).dot(contact::exact_vector(points[0]));
      const auto is_at_most = [](double x, const contact::Exact& y) {
        return x == -std::numeric_limits<double>::infinity() ||
               (x < std::numeric_limits<double>::infinity() && contact::Exact(x) <= y);
      };
      CHECK(is_at_most(dop.low[k], at));
      CHECK(is_at_most(-dop.high[k], -at));
    }
  }
}

TEST_CASE("what a k-DOP refuses") {
  CHECK_THROWS_AS(contact::kdop_normals<double>(8), std::invalid_argument);
  const std::vector<Vector3<double>> points{{1, 0, 0}};
  CHECK_THROWS_AS(contact::kdop_of_points<double>({}, points), std::invalid_argument);
  CHECK_THROWS_AS(contact::kdop_of_points<double>({{0, 0, 0}}, points), std::invalid_argument);
  CHECK_THROWS_AS(contact::kdop_of_points<double>({{1, 0, 0}}, std::span<const Vector3<double>>{}),
                  std::invalid_argument);
}

}  // namespace
