#include <03_polygons/reference.hpp>
#include <catch2/catch_test_macros.hpp>
#include <contact/convex_polygon.hpp>
#include <limits>
#include <map>

namespace {

using namespace polygons;
using contact::PolygonWithHoles;

const Polygon<double> star{{0, 3}, {2, -3}, {-3, 1}, {3, 1}, {-2, -3}};
const Polygon<double> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};

TEST_CASE("each stage of the orientation is right by itself") {
  Random random(8);
  int zeros = 0;
  for (int i = 0; i < generators::tried(140000); ++i) {
    const int kind = i % kinds;
    const Vector2<double> a = point(random, kind), b = point(random, kind);
    const Vector2<double> c = point_near(random, kind, {a, b});
    const int right = oracle::sign(cross(exact(b) - exact(a), exact(c) - exact(a)));
    INFO("kind " << kind << ", case " << i);
    REQUIRE(contact::polygon_detail::side(a, b, c) == right);
    REQUIRE(contact::polygon_detail::side_in_doubt(a, b, c) == right);
    zeros += right == 0 ? 1 : 0;
  }
  CHECK(zeros > generators::tried(10000));
  for (int i = 0; i < generators::tried(20000); ++i) {
    const auto any = [&random] {
      const double x = generators::any_finite(random);
      return Vector2<double>(x, generators::any_finite(random));
    };
    const Vector2<double> a = any(), b = any(), c = any();
    const int right = oracle::sign(cross(exact(b) - exact(a), exact(c) - exact(a)));
    REQUIRE(contact::polygon_detail::side(a, b, c) == right);
    REQUIRE(contact::polygon_detail::side_in_doubt(a, b, c) == right);
  }
}

template <class S>
void compare_points(int count, std::uint64_t seed) {
  Random random(seed);
  std::map<Where, int> seen;
  for (int i = 0; i < generators::tried(count); ++i) {
    const int kind = i % kinds;
    const Polygon<S> polygon = polygons::polygon<S>(random, kind, 0, 8);
    const Vector2<S> p = point_near<S>(random, kind, polygon);
    const std::optional<int> right = winding(exact(polygon), exact(p));
    INFO("kind " << kind << ", case " << i);
    REQUIRE(contact::winding_number(polygon, p) == right);
    REQUIRE(contact::winding_by_edges<Rational>(exact(polygon), exact(p)) == right);
    for (const Rule rule : {Rule::even_odd, Rule::non_zero}) {
      REQUIRE(contact::where(polygon, p, rule) == where(exact(polygon), exact(p), rule));
    }
    ++seen[contact::where(polygon, p)];
    // Neither the first vertex nor the orientation matters.
    Polygon<S> turned = polygon;
    if (!turned.empty()) std::rotate(turned.begin(), turned.begin() + 1, turned.end());
    REQUIRE(contact::winding_number(turned, p) == right);
    const auto backwards = contact::winding_number(contact::reversed(polygon), p);
    REQUIRE(backwards.has_value() == right.has_value());
    if (right) REQUIRE(*backwards == -*right);
  }
  CHECK(seen[Where::outside] > generators::tried(count) / 20);
  CHECK(seen[Where::on] > generators::tried(count) / 20);
  CHECK(seen[Where::inside] > generators::tried(count) / 20);
}

TEST_CASE("the winding number is right for hard polygons of doubles and floats") {
  compare_points<double>(70000, 1);
  compare_points<float>(70000, 2);
}

TEST_CASE("the winding number is right where vertices are taken 64 at a time") {
  Random random(3);
  int on = 0;
  for (int i = 0; i < generators::tried(3000); ++i) {
    const int kind = i % kinds, count = 64 * random.integer(1, 2) + random.integer(-1, 2);
    Polygon<double> polygon = polygons::polygon<double>(random, kind, count, count);
    const Vector2<double> p = point_near<double>(random, kind, polygon);
    const std::optional<int> right = winding(exact(polygon), exact(p));
    INFO("kind " << kind << ", case " << i << ", " << polygon.size() << " vertices");
    REQUIRE(contact::winding_number(polygon, p) == right);
    // The edge that matters comes last and first in a round.
    for (int turns = 0; turns < 64; ++turns) {
      std::rotate(polygon.begin(), polygon.begin() + 1, polygon.end());
      REQUIRE(contact::winding_number(polygon, p) == right);
    }
    on += right ? 0 : 1;
  }
  CHECK(on > generators::tried(3000) / 10);
}

TEST_CASE("a star has a middle that is inside by one rule and outside by the other") {
  const Vector2<double> middle(0, 0), arm(0, 2), outside(2, 0);
  CHECK(*contact::winding_number(star, middle) == -2);
  CHECK(contact::where(star, middle, Rule::even_odd) == Where::outside);
  CHECK(contact::where(star, middle, Rule::non_zero) == Where::inside);
  for (const Rule rule : {Rule::even_odd, Rule::non_zero}) {
    CHECK(contact::where(star, arm, rule) == Where::inside);
    CHECK(contact::where(star, outside, rule) == Where::outside);
    // An edge through the middle part is on, by both rules.
    CHECK(contact::where(star, {0, 1}, rule) == Where::on);
  }
}

TEST_CASE("degenerate polygons have no inside") {
  CHECK(contact::where(Polygon<double>{}, {0, 0}) == Where::outside);
  CHECK(contact::where(Polygon<double>{{1, 2}}, {1, 2}) == Where::on);
  CHECK(contact::where(Polygon<double>{{1, 2}}, {1, 2.5}) == Where::outside);
  const Polygon<double> segment{{0, 0}, {2, 1}};
  CHECK(contact::where(segment, {1, 0.5}) == Where::on);
  CHECK(contact::where(segment, {4, 2}) == Where::outside);
  const Polygon<double> level{{0, 0}, {2, 0}, {1, 0}};
  CHECK(contact::where(level, {0.5, 0}) == Where::on);
  CHECK(contact::where(level, {3, 0}) == Where::outside);
}

TEST_CASE("a point that is not finite is outside, and such vertices do no harm") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, infinity, -infinity}) {
    for (const Vector2<double>& p :
         {Vector2<double>(bad, 0.5), Vector2<double>(0.5, bad), Vector2<double>(bad, bad)}) {
      CHECK(contact::where(square, p) == Where::outside);
      CHECK(*contact::winding_number(square, p) == 0);
      CHECK(contact::where_by_edges(square, p) == Where::outside);
      CHECK(contact::where_by_edges_exact(square, p) == Where::outside);
      CHECK(contact::where_by_bisection(square, p) == Where::outside);
      CHECK(contact::where_by_crossings(square, p) == Where::outside);
      for (std::size_t i = 0; i < square.size(); ++i) {
        Polygon<double> broken = square;
        broken[i] = p;
        for (const Vector2<double>& x : square) {
          (void)contact::where(broken, x);
          (void)contact::where_by_edges_exact(broken, x);
          (void)contact::where_by_bisection(broken, x);
          (void)contact::is_convex(broken);
          (void)contact::area_sign(broken);
        }
      }
    }
  }
}

TEST_CASE("holes take their inside away and keep their boundary") {
  const PolygonWithHoles<double> frame{
      {{0, 0}, {4, 0}, {4, 4}, {0, 4}},
      {{{1, 1}, {2, 1}, {2, 2}, {1, 2}}, {{3, 3}, {3, 2}, {2, 3}}}};
  CHECK(contact::where(frame, {0.5, 0.5}) == Where::inside);
  CHECK(contact::where(frame, {1.5, 1.5}) == Where::outside);
  CHECK(contact::where(frame, {1.5, 1}) == Where::on);
  CHECK(contact::where(frame, {2.5, 2.5}) == Where::on);
  CHECK(contact::where(frame, {2.75, 2.75}) == Where::outside);
  CHECK(contact::where(frame, {4, 4}) == Where::on);
  CHECK(contact::where(frame, {5, 1}) == Where::outside);
  CHECK(contact::where(frame, {5, 1}, Rule::non_zero) == Where::outside);
}

TEST_CASE("the lecture's methods are right away from the boundary") {
  Random random(3);
  int checked = 0;
  for (int i = 0; i < generators::tried(20000); ++i) {
    const Polygon<double> polygon = polygons::polygon(random, 1, 3, 9);
    const Vector2<double> p = point(random, 1);
    bool close = false;
    contact::for_each_edge(polygon, [&](const Vector2<double>& a, const Vector2<double>& b) {
      // Far enough that no rounding matters: a thousandth of the edge's length.
      close = close || std::abs(contact::orientation<double>(a, b, p)) < 1e-3;
    });
    if (close) continue;
    ++checked;
    const Where even_odd = contact::where(polygon, p, Rule::even_odd);
    const Where non_zero = contact::where(polygon, p, Rule::non_zero);
    CHECK(contact::where_by_angle_sum(polygon, p) == non_zero);
    CHECK(contact::where_by_quadrants(polygon, p) == non_zero);
    CHECK(contact::where_by_crossings(polygon, p) == even_odd);
    CHECK(contact::where_by_crossings_with_ends(polygon, p) == even_odd);
    CHECK(contact::where_by_scanline(polygon, p) == non_zero);
    CHECK(contact::where_by_scanline(polygon, p, Rule::even_odd) == even_odd);
    CHECK(contact::quadrant_sum(polygon, p) == 4 * *contact::winding_number(polygon, p));
  }
  CHECK(checked > generators::tried(10000));
}

TEST_CASE("each of the lecture's methods fails where the lesson says so") {
  const Polygon<double> diamond{{-1, 0}, {0, -1}, {1, 0}, {0, 1}};
  // At the level of a vertex, an edge with both its ends is counted twice.
  CHECK(contact::crossings_with_ends(diamond, {0, 0}) == 2);
  CHECK(contact::where_by_crossings_with_ends(diamond, {0, 0}) == Where::outside);
  CHECK(contact::crossings(diamond, {0, 0}) == 1);
  CHECK(contact::where(diamond, {0, 0}) == Where::inside);
  // On the boundary the answers depend on the edge.
  CHECK(contact::where_by_crossings(square, {0, 0.5}) == Where::inside);
  CHECK(contact::where_by_crossings(square, {1, 0.5}) == Where::outside);
  CHECK(contact::where_by_crossings(square, {0.5, 0}) == Where::inside);
  CHECK(contact::where_by_crossings(square, {0.5, 1}) == Where::outside);
}

TEST_CASE("a scanline serves all points of a row") {
  const auto row = contact::scanline<double>(star, 0.0);
  REQUIRE(row.size() == 4);
  for (std::size_t i = 1; i < row.size(); ++i) CHECK(row[i - 1].x < row[i].x);
  for (double x = -3; x <= 3; x += 0.25) {
    CHECK(contact::where_on_scanline(row, x) == contact::where_by_scanline(star, {x, 0.0}));
  }
}

// ---------------------------------------------------------------- convex polygons

/// A convex polygon of hard points: their hull in fractions, with points on its edges kept.
template <class S>
Polygon<S> convex(Random& random, int kind, int points) {
  Polygon<S> all;
  for (int i = 0; i < points; ++i) all.push_back(point<S>(random, kind));
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  });
  all.erase(std::unique(all.begin(), all.end()), all.end());
  if (all.size() < 3) return {};
  Polygon<S> lower, upper;
  const bool keep = random.chance(0.5);
  const auto grow = [keep](Polygon<S>& chain, const Vector2<S>& p) {
    while (chain.size() >= 2) {
      const Exact2 a = exact(chain[chain.size() - 2]), b = exact(chain.back()), c = exact(p);
      const Rational turn = cross(b - a, c - a);
      if (turn > 0 || (keep && turn == 0)) break;
      chain.pop_back();
    }
    chain.push_back(p);
  };
  for (const auto& p : all) grow(lower, p);
  for (auto p = all.rbegin(); p != all.rend(); ++p) grow(upper, *p);
  lower.pop_back();
  upper.pop_back();
  lower.insert(lower.end(), upper.begin(), upper.end());
  if (contact::area_sign(lower) <= 0) return {};
  std::rotate(lower.begin(), lower.begin() + random.integer(0, static_cast<int>(lower.size()) - 1),
              lower.end());
  return lower;
}

template <class S>
void compare_convex(int count, std::uint64_t seed) {
  Random random(seed);
  int tried = 0;
  std::map<Where, int> seen;
  for (int i = 0; i < generators::tried(count); ++i) {
    const int kind = i % kinds;
    const Polygon<S> polygon = convex<S>(random, kind, random.integer(3, 14));
    if (polygon.empty()) continue;
    ++tried;
    REQUIRE(contact::is_convex(polygon));
    REQUIRE(contact::is_convex(contact::reversed(polygon)));
    for (int k = 0; k < 4; ++k) {
      const Vector2<S> p = point_near<S>(random, kind, polygon);
      const Where right = where(exact(polygon), exact(p), Rule::even_odd);
      INFO("kind " << kind << ", case " << i);
      REQUIRE(contact::where_by_edges_exact(polygon, p) == right);
      REQUIRE(contact::where_by_bisection(polygon, p) == right);
      REQUIRE(contact::where(polygon, p) == right);
      REQUIRE(contact::where_by_edges<Rational>(exact(polygon), exact(p)) == right);
      ++seen[right];
    }
  }
  CHECK(tried > generators::tried(count) / 2);
  CHECK(seen[Where::on] > tried / 2);
  CHECK(seen[Where::inside] > tried / 2);
}

TEST_CASE("edge tests and bisection are right for hard convex polygons") {
  compare_convex<double>(14000, 4);
  compare_convex<float>(14000, 5);
}

TEST_CASE("bisection finds points on straight edges at the first vertex") {
  // The first vertex is inside a straight edge, at its start, or at its end.
  Polygon<double> polygon{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {4, 4}, {0, 4}};
  for (std::size_t turn = 0; turn < polygon.size(); ++turn) {
    std::rotate(polygon.begin(), polygon.begin() + 1, polygon.end());
    for (double x = -1; x <= 5; x += 0.5) {
      for (double y = -1; y <= 5; y += 0.5) {
        INFO(turn << ": " << x << ", " << y);
        CHECK(contact::where_by_bisection(polygon, {x, y}) == contact::where(polygon, {x, y}));
      }
    }
  }
}

TEST_CASE("edge tests of a polygon without area say on or outside") {
  const Polygon<double> flat{{0, 0}, {2, 2}, {1, 1}};
  CHECK(contact::where_by_edges_exact(flat, {0.5, 0.5}) == Where::on);
  CHECK(contact::where_by_edges_exact(flat, {3, 3}) == Where::outside);
  CHECK(contact::where_by_edges_exact(flat, {0, 1}) == Where::outside);
  CHECK(contact::where_by_edges_exact(Polygon<double>{{1, 1}}, {1, 1}) == Where::on);
  CHECK(contact::where_by_edges_exact(Polygon<double>{{1, 1}}, {1, 2}) == Where::outside);
  CHECK(contact::where_by_edges_exact(Polygon<double>{}, {1, 2}) == Where::outside);
  CHECK(contact::where_by_edges(Polygon<double>{}, {1, 2}) == Where::outside);
  // The lecture's own has the whole line.
  CHECK(contact::where_by_edges(flat, {3, 3}) == Where::on);
}

TEST_CASE("repeated vertices change nothing for edge tests") {
  const Polygon<double> doubled{{0, 0}, {0, 0}, {1, 0}, {1, 1}, {1, 1}, {1, 1}, {0, 1}, {0, 0}};
  for (double x = -0.5; x <= 1.5; x += 0.25) {
    for (double y = -0.5; y <= 1.5; y += 0.25) {
      CHECK(contact::where_by_edges_exact(doubled, {x, y}) == contact::where(square, {x, y}));
    }
  }
  CHECK(contact::without_repeats(doubled) == square);
}

// ---------------------------------------------------------------- area and shape

TEST_CASE("the sign of the area is exact") {
  Random random(6);
  std::map<int, int> seen;
  for (int i = 0; i < generators::tried(30000); ++i) {
    const int kind = i % kinds;
    const Polygon<double> polygon = polygons::polygon(random, kind, 0, 7);
    const int right = oracle::sign(contact::doubled_area<Rational>(exact(polygon)));
    REQUIRE(contact::area_sign(polygon) == right);
    REQUIRE(contact::area_sign(contact::reversed(polygon)) == -right);
    ++seen[right];
  }
  CHECK(seen[0] > generators::tried(3000));
  CHECK(contact::doubled_area(square) == 2);
  CHECK(contact::doubled_area(Polygon<double>{{1, 1}, {2, 2}}) == 0);
}

/// Convex by definition: of some orientation, no vertex is right of any edge, and going around the
/// edges turns once: their sum of angles is 2π, here by counting quadrants of directions.
bool convex_by_definition(const Polygon<double>& given) {
  const ExactPolygon polygon = exact(contact::without_repeats(given));
  const std::size_t n = polygon.size();
  if (n < 3) return false;
  for (const int orientation : {1, -1}) {
    bool all = true, area = false;
    for (std::size_t i = 0; i < n && all; ++i) {
      const Exact2 &a = polygon[i], &b = polygon[(i + 1) % n], &c = polygon[(i + 2) % n];
      const Exact2 edge = b - a, next = c - b;
      if (cross(edge, next) == 0 && edge.dot(next) < 0) all = false;  // a spike
      for (const Exact2& v : polygon) {
        const int side = oracle::sign(cross(edge, v - a)) * orientation;
        all = all && side >= 0;
        area = area || side > 0;
      }
    }
    if (!all || !area) continue;
    // Each point of the boundary once: no edge leads along another one.
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) {
        if (i != j && polygon[i] == polygon[j]) return false;
      }
    }
    return true;
  }
  return false;
}

TEST_CASE("convex means turning one way, once around") {
  CHECK(contact::is_convex(square));
  CHECK_FALSE(contact::is_convex(star));
  CHECK_FALSE(contact::is_convex(Polygon<double>{{0, 0}, {1, 1}, {2, 2}}));
  CHECK_FALSE(contact::is_convex(Polygon<double>{{0, 0}, {2, 0}, {1, 0}, {1, 1}}));
  CHECK_FALSE(contact::is_convex(Polygon<double>{{0, 0}, {1, 0}}));
  Polygon<double> twice = square;
  twice.insert(twice.end(), square.begin(), square.end());
  CHECK_FALSE(contact::is_convex(twice));
  Random random(7);
  int convex = 0;
  for (int i = 0; i < generators::tried(30000); ++i) {
    const Polygon<double> polygon = polygons::polygon(random, i % kinds, 0, i % 2 == 0 ? 4 : 6);
    const bool right = convex_by_definition(polygon);
    INFO("case " << i);
    REQUIRE(contact::is_convex(polygon) == right);
    convex += right ? 1 : 0;
  }
  CHECK(convex > generators::tried(2000));
}

}  // namespace
