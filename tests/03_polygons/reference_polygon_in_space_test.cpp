#include <03_polygons/reference.hpp>
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <limits>
#include <map>

namespace {

using namespace polygons;
using contact::Segment;
using contact::SpacePolygon;
using contact::SpacePolygonHit;
using oracle::Vector;

/// Whether and where a segment meets a polygon, in fractions: the plane through the first vertex,
/// and the polygon as it is seen along the segment.
struct RightHit {
  Rational t = 0;
  Where where = Where::outside;
};
template <class S>
std::optional<RightHit> right_hit(const Segment<S>& segment, const SpacePolygon<S>& polygon,
                                  Rule rule) {
  std::vector<Vector> v;
  for (const auto& x : polygon) v.push_back(oracle::exact(x));
  const Vector start = oracle::exact(segment.start), end = oracle::exact(segment.end);
  if (v.size() < 3) return std::nullopt;
  Vector normal(0, 0, 0);
  for (std::size_t i = 0; i < v.size(); ++i) {
    const Vector& next = v[(i + 1) % v.size()];
    normal += v[i].cross(next);
  }
  const Rational at_start = normal.dot(start - v[0]), at_end = normal.dot(end - v[0]);
  if (oracle::sign(at_start) * oracle::sign(at_end) > 0 || at_start == at_end) return std::nullopt;
  // Two vectors perpendicular to the segment give the coordinates of the view along it.
  const Vector along = end - start;
  const Vector axis = along.x() != 0 ? Vector(0, 0, 1) : Vector(1, 0, 0);
  const Vector right = along.cross(axis), up = along.cross(right);
  ExactPolygon view;
  for (const Vector& x : v) view.push_back({right.dot(x - start), up.dot(x - start)});
  const Where found = polygons::where(view, Exact2(0, 0), rule);
  if (found == Where::outside) return std::nullopt;
  return RightHit{at_start / (at_start - at_end), found};
}

template <class S>
Vector3<S> point3(Random& random, int kind) {
  const S x = coordinate<S>(random, kind), y = coordinate<S>(random, kind);
  return {x, y, coordinate<S>(random, kind)};
}

/// A polygon, planar on purpose or in general not.
template <class S>
SpacePolygon<S> space_polygon(Random& random, int kind) {
  const bool flat = random.chance(0.6);
  const int axis = random.integer(0, 2);
  const S level = coordinate<S>(random, kind);
  SpacePolygon<S> polygon;
  for (int n = random.integer(3, 6); n > 0; --n) {
    polygon.push_back(point3<S>(random, kind));
    if (flat && kind == 0) polygon.back()[axis] = polygon.back()[(axis + 1) % 3] + 1;
    if (flat && kind != 0) polygon.back()[axis] = level;
  }
  return polygon;
}

template <class S>
Segment<S> segment_near(Random& random, int kind, const SpacePolygon<S>& polygon) {
  Segment<S> segment{point3<S>(random, kind), point3<S>(random, kind)};
  if (random.chance(0.4)) {
    const auto i = static_cast<std::size_t>(random.integer(0, 2));
    const S t = random.chance(0.3) ? S(0) : (random.chance(0.5) ? S(0.5) : S(random.uniform()));
    const Vector3<S> target =
        polygon[i] + t * (polygon[i + 1 < polygon.size() ? i + 1 : 0] - polygon[i]);
    const Vector3<S> end = target + (target - segment.start);
    if (contact::all_finite(end)) segment.end = random.chance(0.3) ? target : end;
  }
  return segment;
}

template <class S>
void compare_in_space(int count, std::uint64_t seed) {
  Random random(seed);
  std::map<Where, int> seen;
  for (int i = 0; i < generators::tried(count); ++i) {
    const int kind = i % kinds;
    const SpacePolygon<S> polygon = space_polygon<S>(random, kind);
    const Segment<S> segment = segment_near<S>(random, kind, polygon);
    if (!contact::all_finite(segment.end)) continue;
    const Rule rule = random.chance(0.5) ? Rule::even_odd : Rule::non_zero;
    INFO("kind " << kind << ", case " << i);
    const auto right = right_hit(segment, polygon, rule);
    const auto got = contact::intersect_polygon(segment, polygon, rule);
    REQUIRE(got.has_value() == right.has_value());
    ++seen[right ? right->where : Where::outside];
    if (!got) continue;
    REQUIRE(got->where == right->where);
    const double room = sizeof(S) == sizeof(double) ? 0x1p-40 : 0x1p-23;
    REQUIRE(oracle::error(static_cast<double>(got->t), right->t) <= room);
    for (int k = 0; k < 3; ++k) {
      const Rational a = oracle::exact(segment.start[k]), b = oracle::exact(segment.end[k]);
      const Rational largest = std::max<Rational>(abs(a), abs(b));
      const Rational off = abs(oracle::exact(got->point[k]) - (a + right->t * (b - a)));
      REQUIRE(off <= largest * oracle::exact(2 * room) + oracle::exact(0x1p-148));
    }
  }
  CHECK(seen[Where::inside] > generators::tried(count) / 50);
  CHECK(seen[Where::on] > generators::tried(count) / 50);
  CHECK(seen[Where::outside] > generators::tried(count) / 50);
}

TEST_CASE("a segment and a polygon in space meet as they do in fractions") {
  compare_in_space<double>(28000, 31);
  compare_in_space<float>(28000, 32);
}

const SpacePolygon<double> window{{0, 0, 1}, {2, 0, 1}, {2, 2, 1}, {1, 0.5, 1}, {0, 2, 1}};

TEST_CASE("a wall with a notch") {
  const auto through = [](double x, double y) { return Segment<double>{{x, y, 0}, {x, y, 4}}; };
  const auto hit = contact::intersect_polygon(through(1, 0.25), window);
  REQUIRE(hit.has_value());
  CHECK(hit->t == 0.25);
  CHECK(hit->point == Vector3<double>(1, 0.25, 1));
  CHECK(hit->where == Where::inside);
  CHECK(contact::intersect_polygon(through(1, 0.5), window)->where == Where::on);
  CHECK_FALSE(contact::intersect_polygon(through(1, 1), window).has_value());
  for (double x = -0.5; x <= 2.5; x += 0.25) {
    for (double y = -0.5; y <= 2.5; y += 0.25) {
      const auto exact = contact::intersect_polygon(through(x, y), window);
      const auto dropped = contact::intersect_polygon_by_dropping(through(x, y), window);
      REQUIRE(exact.has_value() == dropped.has_value());
      if (exact) CHECK(exact->where == dropped->where);
    }
  }
}

TEST_CASE("the area vector is the same in any order of the sum and points to the front") {
  CHECK(contact::doubled_area_vector(window) == Vector3<double>(0, 0, 5));
  CHECK(contact::doubled_area_vector(SpacePolygon<double>{}) == Vector3<double>(0, 0, 0));
  CHECK(contact::doubled_area_vector(SpacePolygon<double>{{0, 0, 0}, {1, 1, 1}}) ==
        Vector3<double>(0, 0, 0));
}

TEST_CASE("no hit: in the plane, short of it, without area, not finite") {
  const auto misses = [](const Segment<double>& s, const SpacePolygon<double>& p) {
    return !contact::intersect_polygon(s, p) && !contact::intersect_polygon_by_dropping(s, p);
  };
  CHECK(misses({{-1, 0.25, 1}, {3, 0.25, 1}}, window));
  CHECK(misses({{1, 0.25, 0}, {1, 0.25, 0.5}}, window));
  CHECK(misses({{1, 0.25, 1}, {1, 0.25, 1}}, window));
  CHECK(misses({{0, 0, -1}, {0, 0, 1}}, {{-1, 0, 0}, {0, 0, 0}, {1, 0, 0}}));
  CHECK(misses({{0, 0, -1}, {0, 0, 1}}, {}));
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(misses({{1, 0.25, nan}, {1, 0.25, 4}}, window));
  CHECK_FALSE(contact::intersect_polygon({{1, 0.25, 0}, {1, 0.25, 4}},
                                         SpacePolygon<double>{{0, 0, nan}, {2, 0, 1}, {2, 2, 1}}));
  // Ending on the plane counts.
  CHECK(contact::intersect_polygon({{1, 0.25, 0}, {1, 0.25, 1}}, window)->t == 1);
}

TEST_CASE("between two polygons that share an edge no line passes") {
  Random random(33);
  int by_dropping = 0;
  for (int i = 0; i < generators::tried(20000); ++i) {
    // A quadrilateral, cut along its diagonal; points of the diagonal as rounded.
    const SpacePolygon<double> p{point3<double>(random, 1), point3<double>(random, 1),
                                 point3<double>(random, 1), point3<double>(random, 1)};
    const Vector3<double> target = p[0] + random.uniform(0.1, 0.9) * (p[2] - p[0]);
    const Vector3<double> start = point3<double>(random, 1);
    const Segment<double> path{start, start + 16 * (target - start)};
    const SpacePolygon<double> one{p[0], p[1], p[2]}, other{p[2], p[3], p[0]};
    // Seen from the start, the two triangles must be on different sides of the diagonal.
    const int side = contact::orient_3d(start, p[0], p[2], p[1]);
    if (side * contact::orient_3d(start, p[0], p[2], p[3]) >= 0) continue;
    const bool hit = contact::intersect_polygon(path, one).has_value() ||
                     contact::intersect_polygon(path, other).has_value();
    REQUIRE(hit);
    if (!contact::intersect_polygon_by_dropping(path, one) &&
        !contact::intersect_polygon_by_dropping(path, other)) {
      ++by_dropping;
    }
  }
  CHECK(by_dropping > 0);
}

}  // namespace
