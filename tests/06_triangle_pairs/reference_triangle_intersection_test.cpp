// What two triangles have in common: kind, features, positions and their bound, against fractions;
// every order of the vertices and of the triangles; whole lattices.
#include <06_triangle_pairs/common_points_truth.hpp>
#include <06_triangle_pairs/drawn.hpp>
#include <06_triangle_pairs/pair_families.hpp>
#include <06_triangle_pairs/pair_truth.hpp>
#include <contact/triangle_intersection.hpp>

#include <support/generators.hpp>
#include <support/oracle.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace common_points_tests {

using common_points_truth::Vertices;
using contact::CommonPoint;
using contact::CommonPoints;
using contact::Exact;
using contact::Feature;
using contact::FeatureKind;
using contact::Triangle;
using contact::TriangleIntersection;
using contact::Vector3;
using drawn::whole;
using generators::Random;
using oracle::Rational;

// ---------------------------------------------------------------- input

template <class S>
Triangle<S> moved(const Triangle<S>& t, const Vector3<S>& d) {
  return {t.a + d, t.b + d, t.c + d};
}
template <class S>
Triangle<S> scaled(const Triangle<S>& t, S factor) {
  return {t.a * factor, t.b * factor, t.c * factor};
}
pair_families::Pair<double> whole_pair(Random& random, int i) {
  const int size = 1 + i % 4;
  Triangle<double> s{whole(random, size), whole(random, size), whole(random, size)};
  Triangle<double> t{whole(random, size), whole(random, size), whole(random, size)};
  if (i % 3 == 0) s.a.z() = s.b.z() = s.c.z() = t.a.z() = t.b.z() = t.c.z() = 1;
  if (i % 7 == 0) t.a = s.a;
  if (i % 14 == 0) t.b = s.b;
  if (i % 11 == 0) s.c = s.a + (s.b - s.a) * random.integer(-1, 2);
  if (i % 13 == 0) t.c = t.a + (t.b - t.a) * random.integer(-1, 2);
  return {s, t};
}

// ---------------------------------------------------------------- truth

/// The point of the truth with these features, or nothing.
const common_points_truth::Point* with_features(
    const std::vector<common_points_truth::Point>& points, const Feature& f, const Feature& g) {
  const auto found = std::find_if(points.begin(), points.end(), [&](const auto& p) {
    return p.of_first == f && p.of_second == g;
  });
  return found == points.end() ? nullptr : &*found;
}
Rational nearest_number(const Rational& x, double) { return oracle::exact(oracle::nearest(x)); }
Rational nearest_number(const Rational& x, float) {
  return oracle::exact(oracle::nearest_float(x));
}
template <class S>
Rational largest_error(const Vector3<S>& got, const oracle::Vector& right) {
  Rational largest = 0;
  for (int k = 0; k < 3; ++k) {
    const Rational error = abs(oracle::exact(got[k]) - right[k]);
    largest = std::max(largest, error);
  }
  return largest;
}
/// Whether the vertices are those of a convex polygon, counter-clockwise in the first projection in
/// which its plane has area.
bool is_ordered(const std::vector<oracle::Vector>& points, const Vertices& plane) {
  const oracle::Vector normal = (plane[1] - plane[0]).cross(plane[2] - plane[0]);
  const int k = normal[0] != 0 ? 0 : (normal[1] != 0 ? 1 : 2);
  const std::size_t n = points.size();
  for (std::size_t i = 0; i < n; ++i) {
    const oracle::Vector in = points[(i + 1) % n] - points[i];
    const oracle::Vector out = points[(i + 2) % n] - points[(i + 1) % n];
    if (in.cross(out)[k] <= 0) return false;
  }
  return true;
}

/// How often each kind occurred.
using Counts = std::array<int, 4>;

template <class S>
void check_points(const TriangleIntersection<S>& got,
                  const std::vector<common_points_truth::Point>& right, const Vertices& plane,
                  bool to_last_place) {
  REQUIRE(got.count == static_cast<int>(right.size()));
  REQUIRE(static_cast<int>(got.kind) == std::min(got.count, 3));
  std::vector<oracle::Vector> in_order;
  for (int i = 0; i < got.count; ++i) {
    const CommonPoint<S>& p = got.points[static_cast<std::size_t>(i)];
    const auto* truth = with_features(right, p.of_first, p.of_second);
    REQUIRE(truth != nullptr);
    in_order.push_back(truth->position);
    REQUIRE(largest_error(p.position, truth->position) <= oracle::exact(got.bound));
    for (int k = 0; k < 3; ++k) {
      REQUIRE(!(p.position[k] == S(0) && std::signbit(p.position[k])));
      if (!to_last_place) continue;
      REQUIRE(oracle::exact(p.position[k]) == nearest_number(truth->position[k], S(0)));
    }
  }
  if (got.count > 2) REQUIRE(is_ordered(in_order, plane));
}
template <class S>
void check_pair(const Triangle<S>& s, const Triangle<S>& t, Counts& counts) {
  const Vertices a = common_points_truth::vertices(s), b = common_points_truth::vertices(t);
  const auto right = common_points_truth::common_vertices(a, b);
  const TriangleIntersection<S> got = contact::intersect_triangles(s, t);
  check_points(got, right, a, false);
  check_points(contact::intersect_triangles_to_last_place(s, t), right, a, true);
  REQUIRE(contact::common_points(s, t) == got.kind);
  ++counts[static_cast<std::size_t>(got.kind)];
}
/// Of all cases; a build that tries an eighth of them may miss a kind.
void check_each_kind(const Counts& counts) {
  for (const int count : counts) CHECK((count > 0 || generators::sanitized));
}

TEMPLATE_TEST_CASE("kind, features and positions of random pairs are those of fractions", "", float,
                   double) {
  Random random(11);
  Counts counts{};
  for (int i = 0; i < generators::tried(900); ++i) {
    const auto family = generators::all_families[static_cast<std::size_t>(i) % 8];
    const Triangle<double> s = generators::triangle(random, family);
    Triangle<double> t{generators::point(random, family, s), generators::point(random, family, s),
                       generators::detail::near_triangle(random, family, s)};
    if (i % 3 == 0) t.b = generators::detail::near_triangle(random, family, s);
    const Triangle<TestType> first = generators::rounded<TestType>(s);
    const Triangle<TestType> second = generators::rounded<TestType>(t);
    if (!contact::all_finite(first.a + first.b + first.c + second.a + second.b + second.c)) {
      continue;
    }
    check_pair(first, second, counts);
  }
  check_each_kind(counts);
}

TEMPLATE_TEST_CASE("kind, features and positions of whole pairs are those of fractions", "", float,
                   double) {
  Random random(12);
  Counts counts{};
  for (int i = 0; i < generators::tried(1500); ++i) {
    const auto p = whole_pair(random, i);
    const Vector3<double> far = whole(random, 1000000);
    const auto first = generators::rounded<TestType>(i % 2 == 0 ? p.first : moved(p.first, far));
    const auto second = generators::rounded<TestType>(i % 2 == 0 ? p.second : moved(p.second, far));
    check_pair(first, second, counts);
  }
  check_each_kind(counts);
}

TEMPLATE_TEST_CASE("kind, features and positions are right in each family of pairs", "", float,
                   double) {
  for (const auto family : pair_families::all) {
    INFO(pair_families::name(family));
    Random random(13);
    Counts counts{};
    for (int i = 0; i < generators::tried(48); ++i) {
      const auto p = pair_families::pair<TestType>(random, family);
      check_pair(p.first, p.second, counts);
    }
  }
}

TEST_CASE("kind, features and positions are right from 1e-150 to 1e150, and at all exponents") {
  Random random(14);
  Counts counts{};
  for (int i = 0; i < generators::tried(600); ++i) {
    const auto p = whole_pair(random, i);
    const double factor = std::ldexp(1.0, random.integer(-500, 500));
    check_pair(scaled(p.first, factor), scaled(p.second, factor), counts);
    if (i % 10 != 0) continue;
    const Triangle<double> s{generators::any_vector(random), generators::any_vector(random),
                             generators::any_vector(random)};
    check_pair(s, {s.a, generators::any_vector(random), generators::any_vector(random)}, counts);
  }
  check_each_kind(counts);
}

TEST_CASE("kind and features at the ends of the number range are right") {
  constexpr double huge = std::numeric_limits<double>::max();
  constexpr double tiny = std::numeric_limits<double>::denorm_min();
  for (const double unit : {huge, tiny, 3 * tiny, std::numeric_limits<double>::min()}) {
    Counts counts{};
    for (const double z : {0.0, unit}) {
      check_pair<double>({{-unit, -unit, 0}, {unit, -unit, 0}, {0, unit, 0}},
                         {{0, 0, -unit}, {unit, 0, z}, {-unit, 0, unit}}, counts);
      check_pair<double>({{-unit, -unit, z}, {unit, -unit, 0}, {0, unit, 0}},
                         {{-unit, unit, 0}, {unit, unit, 0}, {0, -unit, 0}}, counts);
    }
  }
}

TEST_CASE("the decision is that of integers in each family of pairs") {
  for (const auto family : pair_families::all) {
    INFO(pair_families::name(family));
    Random random(15);
    for (int i = 0; i < generators::tried(20000); ++i) {
      const auto p = pair_families::pair<double>(random, family);
      const bool meet = contact::common_points(p.first, p.second) != CommonPoints::none;
      REQUIRE(meet == pair_truth::meet_in_integers(p.first, p.second));
    }
  }
}

// ---------------------------------------------------------------- a whole lattice

TEST_CASE("all pairs of triangles of a small lattice in the plane have the right common points") {
  // A fixed triangle of each shape, against all triangles with vertices in {0, 1, 2}².
  const auto point = [](int i) { return Vector3<double>(i % 3, 1, i / 3); };
  Counts counts{};
  const std::vector<std::array<int, 3>> fixed{
      {0, 2, 6}, {0, 2, 7}, {1, 3, 8}, {0, 4, 8}, {4, 4, 4}};
  const std::size_t last = generators::sanitized ? 1 : fixed.size();
  for (std::size_t f = 0; f < last; ++f) {
    const Triangle<double> s{point(fixed[f][0]), point(fixed[f][1]), point(fixed[f][2])};
    for (int i = 0; i < 9; ++i) {
      for (int j = i; j < 9; ++j) {
        for (int k = j; k < 9; ++k) check_pair(s, {point(i), point(k), point(j)}, counts);
      }
    }
  }
  check_each_kind(counts);
}

TEST_CASE("all pairs of triangles of a small lattice in space have the right common points") {
  // A fixed triangle, against all triangles with vertices in {−1, 0, 1} × {−1, 0, 1} × {−1, 0, 1}.
  const auto point = [](int i) { return Vector3<double>(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1); };
  const Triangle<double> s{{-1, -1, 0}, {1, 0, 0}, {0, 1, 0}};
  Counts counts{};
  for (int i = 0; i < 27; ++i) {
    for (int j = i; j < 27; ++j) {
      for (int k = j; k < 27; k += generators::sanitized ? 16 : 2) {
        check_pair(s, {point(k), point(i), point(j)}, counts);
      }
    }
  }
  check_each_kind(counts);
}

// ---------------------------------------------------------------- order

template <class S>
std::array<Vector3<S>, 3> listed(const Triangle<S>& t) {
  return {t.a, t.b, t.c};
}
template <class S>
std::vector<Triangle<S>> all_orders(const Triangle<S>& t) {
  const auto v = listed(t);
  return {{v[0], v[1], v[2]}, {v[0], v[2], v[1]}, {v[1], v[0], v[2]},
          {v[1], v[2], v[0]}, {v[2], v[0], v[1]}, {v[2], v[1], v[0]}};
}
/// The vertices of a feature in the order of their coordinates.
template <class S>
std::vector<std::array<S, 3>> position_of(const Feature& feature, const Triangle<S>& t) {
  const auto v = listed(t);
  const auto numbers = [](const Vector3<S>& x) { return std::array<S, 3>{x.x(), x.y(), x.z()}; };
  const auto i = static_cast<std::size_t>(feature.index);
  std::vector<std::array<S, 3>> found{numbers(v[i])};
  if (feature.kind != FeatureKind::vertex) found.push_back(numbers(v[(i + 1) % 3]));
  if (feature.kind == FeatureKind::face) found.push_back(numbers(v[2]));
  std::sort(found.begin(), found.end());
  return found;
}
template <class S>
bool same_bits(S x, S y) {
  using Bits = std::conditional_t<sizeof(S) == 4, std::uint32_t, std::uint64_t>;
  return std::bit_cast<Bits>(x) == std::bit_cast<Bits>(y);
}
template <class S>
void require_same(const TriangleIntersection<S>& got, const Triangle<S>& s, const Triangle<S>& t,
                  const TriangleIntersection<S>& other, const Triangle<S>& u,
                  const Triangle<S>& v) {
  REQUIRE(got.kind == other.kind);
  REQUIRE(got.count == other.count);
  REQUIRE(same_bits(got.bound, other.bound));
  for (std::size_t i = 0; i < static_cast<std::size_t>(got.count); ++i) {
    for (int k = 0; k < 3; ++k) {
      REQUIRE(same_bits(got.points[i].position[k], other.points[i].position[k]));
    }
    REQUIRE(position_of(got.points[i].of_first, s) == position_of(other.points[i].of_first, u));
    REQUIRE(position_of(got.points[i].of_second, t) == position_of(other.points[i].of_second, v));
  }
}
template <class S>
void check_orders(const Triangle<S>& s, const Triangle<S>& t) {
  const TriangleIntersection<S> got = contact::intersect_triangles(s, t);
  for (const Triangle<S>& u : all_orders(s)) {
    for (const Triangle<S>& v : all_orders(t)) {
      require_same(got, s, t, contact::intersect_triangles(u, v), u, v);
      TriangleIntersection<S> swapped = contact::intersect_triangles(v, u);
      for (auto& p : swapped.points) std::swap(p.of_first, p.of_second);
      require_same(got, s, t, swapped, u, v);
    }
  }
}

TEMPLATE_TEST_CASE("every order of the vertices and of the triangles gives the same bits", "",
                   float, double) {
  Random random(16);
  for (int i = 0; i < generators::tried(60); ++i) {
    for (const auto family : pair_families::all) {
      const auto p = pair_families::pair<TestType>(random, family);
      check_orders(p.first, p.second);
    }
    const auto p = whole_pair(random, i);
    check_orders(generators::rounded<TestType>(p.first), generators::rounded<TestType>(p.second));
    const auto s = generators::triangle(random, generators::Family::random);
    const auto t = generators::triangle(random, generators::Family::random);
    check_orders(generators::rounded<TestType>(s), generators::rounded<TestType>(t));
  }
}

TEST_CASE("a negative zero is the same as zero") {
  const Triangle<double> s{{-0.0, 0.0, -0.0}, {1, -0.0, 0}, {0.0, 1, -0.0}};
  const Triangle<double> t{{0.0, -0.0, 0.0}, {-1, 0.0, -0.0}, {-0.0, -1, 0.0}};
  check_orders(s, t);
  const auto got = contact::intersect_triangles(s, t);
  REQUIRE(got.kind == CommonPoints::point);
  for (int k = 0; k < 3; ++k) CHECK(!std::signbit(got.points[0].position[k]));
}

// ---------------------------------------------------------------- single cases

TEST_CASE("two triangles that form a star have a hexagon in common") {
  const auto got = contact::intersect_triangles<double>({{0, 0, 0}, {3, 0, 0}, {0, 3, 0}},
                                                        {{2, 2, 0}, {-1, 2, 0}, {2, -1, 0}});
  REQUIRE(got.count == 6);
  for (const auto& p : got.points) {
    CHECK(p.of_first.kind == FeatureKind::edge);
    CHECK(p.of_second.kind == FeatureKind::edge);
  }
}

TEST_CASE("a triangle and itself have the triangle in common") {
  const Triangle<double> t{{0, 0, 0}, {4, 0, 0}, {0, 4, 8}};
  const auto got = contact::intersect_triangles(t, t);
  REQUIRE(got.kind == CommonPoints::area);
  REQUIRE(got.count == 3);
  CHECK(got.bound == 0);
  for (std::size_t i = 0; i < 3; ++i) CHECK(got.points[i].of_first == got.points[i].of_second);
}

TEST_CASE("an edge in common is a segment between vertices") {
  const auto got = contact::intersect_triangles<float>({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                                                       {{1, 0, 0}, {0, 0, 0}, {0, 0, 1}});
  REQUIRE(got.kind == CommonPoints::segment);
  CHECK(got.bound == 0);
  CHECK(got.points[0].of_first == Feature{FeatureKind::vertex, 0});
  CHECK(got.points[0].of_second == Feature{FeatureKind::vertex, 1});
  CHECK(got.points[1].of_first == Feature{FeatureKind::vertex, 1});
  CHECK(got.points[1].of_second == Feature{FeatureKind::vertex, 0});
}

TEST_CASE("a segment given as a triangle has its middle vertex and two short edges") {
  const Triangle<double> segment{{0, 0, -2}, {0, 0, 2}, {0, 0, 0}};
  const auto through = [&](double z) {
    const auto got =
        contact::intersect_triangles<double>(segment, {{-4, -4, z}, {4, -4, z}, {0, 4, z}});
    REQUIRE(got.kind == CommonPoints::point);
    CHECK(got.points[0].of_second == Feature{});
    return got.points[0].of_first;
  };
  CHECK(through(0) == Feature{FeatureKind::vertex, 2});
  CHECK(through(-2) == Feature{FeatureKind::vertex, 0});
  CHECK(through(-1) == Feature{FeatureKind::edge, 2});
  CHECK(through(1) == Feature{FeatureKind::edge, 1});
}

TEST_CASE("of equal vertices and edges the first is named") {
  const Triangle<double> segment{{0, 0, -2}, {0, 0, 2}, {0, 0, 2}};
  const Triangle<double> point{{0, 0, 2}, {0, 0, 2}, {0, 0, 2}};
  const auto end = contact::intersect_triangles(point, segment);
  REQUIRE(end.kind == CommonPoints::point);
  CHECK(end.points[0].of_first == Feature{FeatureKind::vertex, 0});
  CHECK(end.points[0].of_second == Feature{FeatureKind::vertex, 1});
  const auto inside =
      contact::intersect_triangles<double>({{-4, -4, 0}, {4, -4, 0}, {0, 4, 0}}, segment);
  REQUIRE(inside.kind == CommonPoints::point);
  CHECK(inside.points[0].of_second == Feature{FeatureKind::edge, 0});
}

TEST_CASE("triangles with a coordinate that is not finite have nothing in common") {
  const Triangle<double> good{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
        -std::numeric_limits<double>::infinity()}) {
    Triangle<double> t = good;
    t.b.y() = bad;
    CHECK(contact::intersect_triangles(good, t).count == 0);
    CHECK(contact::intersect_triangles_to_last_place(t, good).count == 0);
    CHECK(contact::common_points(t, t) == CommonPoints::none);
  }
}

TEST_CASE("where two planes are nearly parallel, the position is still sharp") {
  Random random(17);
  int exact = 0;
  for (int i = 0; i < generators::tried(2000); ++i) {
    const double tilt = std::ldexp(1.0, -random.integer(10, 50));
    const auto near = [&](double x, double y) {
      x += random.uniform();
      y += random.uniform();
      return Vector3<double>(x, y, 0.3 * x + 0.7 * y + tilt * random.uniform());
    };
    const Triangle<double> s{near(0, 0), near(3, 0), near(0, 3)};
    const Triangle<double> t{near(1, 0), near(-2, 0), near(1, 3)};
    const auto got = contact::intersect_triangles(s, t);
    if (got.count == 0) continue;
    // 2^-40 of an edge below 8, and a few roundings.
    REQUIRE(got.bound <= 0x1p-37 + 0x1p-45);
    const auto last = contact::intersect_triangles_to_last_place(s, t);
    if (same_bits(got.bound, last.bound)) ++exact;
  }
  CHECK(exact > generators::tried(2000) / 20);
}

TEST_CASE("the bound of well-conditioned pairs is a few roundings") {
  Random random(18);
  int found = 0;
  for (int i = 0; i < generators::tried(2000); ++i) {
    const auto s = generators::triangle(random, generators::Family::random);
    const auto t = generators::triangle(random, generators::Family::random);
    const auto got = contact::intersect_triangles(s, t);
    if (got.count == 2 && got.bound < 0x1p-46) ++found;
  }
  CHECK(found > generators::tried(2000) / 20);
}

}  // namespace common_points_tests
