/// @file
/// What the functions of the chapter give for degenerate input, as their comments say it.
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/convex_polygon.hpp>
#include <contact/perimeter.hpp>
#include <contact/polygon_in_space.hpp>
#include <limits>
#include <string_view>
#include <vector>

namespace degenerate_input {

using namespace contact;
using V = Vector2<double>;
using P = Polygon<double>;
using S2 = Segment2<double>;
using Space = SpacePolygon<double>;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double large = 1.7e308;
const P none, square{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, triangle{{0, 0}, {4, 2}, {0, 4}};
const P tiny{{-1e-200, -1e-200}, {1e-200, -1e-200}, {1e-200, 1e-200}, {-1e-200, 1e-200}};

/// Points of which a coordinate is not finite, at the levels that matter for the square.
std::vector<V> points_not_finite() {
  std::vector<V> points;
  for (const double bad : {nan, infinity, -infinity}) {
    for (const double other : {nan, infinity, -infinity, 0.0, 2.0, 4.0}) {
      points.emplace_back(bad, other);
      points.emplace_back(other, bad);
    }
  }
  return points;
}

struct Method {
  std::string_view name;
  Where (*where)(const P& polygon, const V& p);
};
const Method methods[] = {
    {"edges", [](const P& q, const V& p) { return where_by_edges(q, p); }},
    {"exact edges", [](const P& q, const V& p) { return where_by_edges_exact(q, p); }},
    {"bisection", [](const P& q, const V& p) { return where_by_bisection(q, p); }},
    {"angles", [](const P& q, const V& p) { return where_by_angle_sum(q, p); }},
    {"quadrants", [](const P& q, const V& p) { return where_by_quadrants(q, p); }},
    {"ends", [](const P& q, const V& p) { return where_by_crossings_with_ends(q, p); }},
    {"crossings", [](const P& q, const V& p) { return where_by_crossings(q, p); }},
    {"scanline", [](const P& q, const V& p) { return where_by_scanline(q, p); }},
    {"exact", [](const P& q, const V& p) { return where(q, p); }},
};

TEST_CASE("without vertices, and for a point that is not finite, every method says outside") {
  for (const Method& method : methods) {
    CAPTURE(method.name);
    CHECK(method.where(none, {0, 0}) == Where::outside);
    for (const V& p : points_not_finite()) {
      CAPTURE(p.x(), p.y());
      const bool level = p.y() == 2 || p.y() == 4;
      const bool inside = method.name == "quadrants" && std::isnan(p.x()) && level;
      CHECK(method.where(square, p) == (inside ? Where::inside : Where::outside));
    }
    const bool odd = method.name == "ends";  // both edges of the vertex at this level, and another
    CHECK(method.where(triangle, {-infinity, 2}) == (odd ? Where::inside : Where::outside));
  }
}

TEST_CASE("without vertices, and for a point that is not finite, sums and counts are 0") {
  CHECK(angle_sum(none, {0, 0}) == 0);
  CHECK(winding_by_edges(none, {0, 0}) == 0);
  CHECK(scanline(none, 0.0).empty());
  CHECK(where_on_scanline<double>({}, 0.0) == Where::outside);
  for (const V& p : points_not_finite()) {
    CAPTURE(p.x(), p.y());
    CHECK(std::isnan(angle_sum(square, p)));
    CHECK(winding_by_edges(square, p) == 0);
    CHECK(winding_number(square, p) == 0);
    CHECK(scanline(square, p.y()).empty() == !(p.y() == 0 || p.y() == 2));
    CHECK(where_on_scanline(scanline(square, 2.0), p.x()) ==
          (p.x() == 0 || p.x() == 2 ? Where::inside : Where::outside));
    CHECK((p.x() == -infinity || crossings(square, p) == 0));
    CHECK((p.x() == -infinity || crossings_with_ends(square, p) == 0));
  }
  CHECK(angle_sum(P{{0, 1}, {1, -1}}, V(infinity, 0)) == 0);
  CHECK(angle_sum(tiny, V(0, 0)) == 0);
  CHECK(quadrant_sum(square, V(nan, 2)) == -4);
  CHECK(crossings(triangle, V(-infinity, 2)) == 2);
  CHECK(crossings_with_ends(triangle, V(-infinity, 2)) == 3);
  // The crossing point of the right edge overflows to NaN.
  CHECK(scanline(P{{-1, -large}, {1, -large}, {1, large}, {-1, large}}, 1.6e308).size() == 1);
}

TEST_CASE("polygons without area and repeated vertices") {
  const P line{{0, 0}, {1, 0}, {2, 0}}, repeated{{0, 0}, {0, 0}, {4, 0}, {4, 4}, {0, 4}};
  CHECK(where_by_edges(line, V(9, 0)) == Where::on);
  CHECK(where_by_edges(P{{1, 1}, {1, 1}}, V(7, -3)) == Where::on);
  CHECK(where_by_edges(repeated, V(1, 2)) == Where::on);
  CHECK(where_by_edges(tiny, V(0, 0)) == Where::on);
  CHECK(where_by_edges_exact(repeated, V(1, 2)) == Where::inside);
  CHECK(where_by_bisection(line, V(1.5, 0)) == Where::outside);
  CHECK(where_by_bisection(repeated, V(1, 2)) == Where::outside);
  const PolygonWithHoles<double> holed{square, {none, {{1, 1}}, {{2, 2}, {3, 3}}}};
  CHECK(where(holed, V(1, 2)) == Where::inside);
  CHECK(where(holed, V(1, 1)) == Where::on);
  CHECK(where(holed, V(2.5, 2.5)) == Where::on);
  for_each_edge(none, [](const V&, const V&) { FAIL("an edge without vertices"); });
  CHECK(reversed(none).empty());
  CHECK(without_repeats(P{{1, 1}, {1, 1}, {1, 1}}) == P{{1, 1}});
  CHECK(without_repeats(P{{nan, 1}, {nan, 1}}).size() == 2);
  for (const double bad : {nan, infinity, -infinity}) {
    CHECK_FALSE(std::isfinite(doubled_area(P{{0, 0}, {4, 0}, {4, bad}})));
    CHECK(area_sign(P{{0, 0}, {4, 0}, {4, bad}}) == 0);
  }
  CHECK_FALSE(std::isfinite(doubled_area(P{{0, 0}, {1e200, 0}, {0, 1e200}})));
  CHECK(is_convex(P{{0, 0}, {1, 0}, {1, 1}, {0, infinity}}));
  CHECK_FALSE(is_convex(P{{infinity, 0}, {4, 0}, {4, 4}, {0, 4}}));
}

TEST_CASE("segments that are points, not finite, or overflow") {
  const S2 first{{0, 0}, {4, 4}}, second{{0, 4}, {4, 0}}, at{{1, 1}, {1, 1}};
  for (const double bad : {nan, infinity, -infinity}) {
    CHECK_FALSE(crossing_by_parameters(S2{{0, 0}, {4, bad}}, second).has_value());
    CHECK_FALSE(crossing_by_parameters(second, S2{{0, 0}, {4, bad}}).has_value());
  }
  CHECK(crossing_by_slopes(S2{{0, 0}, {infinity, 4}}, second).has_value());
  CHECK(meet_rounded(S2{{nan, nan}, {nan, nan}}, second) == Meeting::overlapping);
  CHECK_FALSE(crossing_by_slopes(at, first).has_value());
  CHECK_FALSE(crossing_by_parameters(at, first).has_value());
  const S2 wide{{-large, -1}, {large, 1}}, along_x{{0, 0}, {1e200, 0}}, along_y{{1, 1}, {1, 1e200}};
  CHECK(crossing_by_slopes(wide, S2{{1, -1}, {2, 1}}) == V(1, -1));  // not on the first segment
  CHECK(meet(along_x, along_y) == Meeting::none);
  CHECK(crossing_by_parameters(along_x, along_y)->meeting == Meeting::touching);
}

TEST_CASE("perimeters of points, without vertices, not finite, or that overflow") {
  CHECK(length_of(V(infinity, -1)) == infinity);
  CHECK(std::isnan(length_of(V(infinity, nan))));
  CHECK(length_of(V(large, large)) == infinity);
  CHECK(perimeter_segments(P{{1, 1}}).size() == 1);
  CHECK(perimeter_points(square, infinity) == square);
  const P overflowing{{-large, 0}, {large, 0}, {infinity, 1}, {0, 1}};
  CHECK(perimeter_points(overflowing, large) == overflowing);
  CHECK(hit_points({V(nan, 1), V(infinity, 1), V(2, 2)}, square).points == std::vector<int>{2});
  CHECK(edges_on_path(S2{{2, nan}, {2, 0}}, square).empty());
  CHECK(first_edge_on_path(S2{{4, 0}, {4, 0}}, square)->second == 0);
  CHECK_FALSE(first_edge_on_path(S2{{4, 0}, {4, 0}}, none).has_value());
  CHECK(polygons_meet(P{{1, 1}}, square));
  CHECK(distance_to_end(S2{{-large, 0}, {-large, 0}}, V(large, 0)) == infinity);
  CHECK(distance_to_end(S2{{1, 0}, {nan, 0}}, V(0, 0)) == 1);
  CHECK(std::isnan(distance_to_end(S2{{nan, 0}, {1, 0}}, V(0, 0))));
}

TEST_CASE("normals of edges that are points, not finite, subnormal, or that overflow") {
  const V zero(0, 0);
  CHECK(right_normal(S2{{0, 0}, {infinity, 0}}) == zero);
  CHECK(right_normal(S2{{0, 0}, {nan, 1}}) == zero);
  const double least = std::numeric_limits<double>::denorm_min(), diagonal = std::sqrt(0.5);
  CHECK((right_normal(S2{{0, 0}, {least, least}}) - V(diagonal, -diagonal)).norm() < 1e-15);
  const auto on_point = perimeter_contact(square, P{{2, 0}});
  CHECK(normal_of_hit_segment(on_point, on_point.found.hits.at(0)) == zero);
  const auto points = perimeter_contact(P{{2, 0}}, P{{2, 0}});
  CHECK(normal_by_nearer_end(points, points.found.hits.at(0)) == zero);
  // A vertex of the body is 1 below the line of the floor's upper edge, and 2.2e308 from its end.
  const P body{{-1.2e308, -1}, {0.5e308, 0.2}, {-1.2e308, 1}};
  const P floor{{0, -1}, {1e308, -1}, {1e308, 0}, {0, 0}};
  CHECK(face_of_least_penetration(perimeter_contact(body, floor))->depth == 0);
}

TEST_CASE("polygons in space without area, not finite, or that overflow") {
  const Space window{{0, 0, 1}, {2, 0, 1}, {2, 2, 1}, {0, 2, 1}};
  const Segment<double> through{{1, 0.5, 0}, {1, 0.5, 4}}, down{{0, 0, 1e7}, {0, 0, -1e9}};
  CHECK(doubled_area_vector(Space{{0, 0, 0}, {1, 0, 0}}).isZero(0));
  const double t = 5 * 0x1p-56;  // all three on the line y = 3x
  CHECK_FALSE(doubled_area_vector(Space{{1, 3, 0}, {t, 3 * t, 0}, {2, 6, 0}}).isZero(0));
  CHECK(drop_dimension(Space{{1, infinity, 2}}, 2) == P{{1, infinity}});
  for (const double bad : {nan, infinity, -infinity}) {
    for (int k = 0; k < 3; ++k) {
      Space broken = window;
      Segment<double> line = through;
      broken[1][k] = line.end[k] = bad;
      CHECK_FALSE(all_finite(doubled_area_vector(broken)));
      CHECK_FALSE(intersect_polygon_by_dropping(through, broken).has_value());
      CHECK_FALSE(intersect_polygon_by_dropping(line, window).has_value());
    }
  }
  const auto scaled = [](double s) {
    return Space{{-s, -s, 0}, {s, -s, 0}, {s, s, 0}, {-s, s, 0}};
  };
  for (const double s : {1e160, 1e-170}) {
    CHECK_FALSE(intersect_polygon_by_dropping(down, scaled(s)).has_value());
    CHECK(intersect_polygon(down, scaled(s)).has_value());
  }
  CHECK(intersect_polygon_by_dropping(down, scaled(1e150))->point.z() == 1e7);
}

}  // namespace degenerate_input
