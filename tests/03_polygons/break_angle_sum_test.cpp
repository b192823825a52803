// What is right is decided in whole numbers.
#include "break_angle_sum.hpp"
#include "inside_by_angles.hpp"

#include <support/break_it.hpp>

#include <03_polygons/whole.hpp>

namespace {

using namespace contact::testing;
using exercise::Query;
using whole::Point;
using whole::Points;

/// Whether no two edges have a point in common but neighbours their vertex.
bool is_simple(const Query& query) {
  const Points& polygon = query.polygon;
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Point a = polygon[i], b = whole::after(polygon, i);
    for (std::size_t j = 0; j < n; ++j) {
      const Point p = polygon[j], q = whole::after(polygon, j);
      const bool is_end = j == i || j == (i + 1) % n;
      if (!is_end && whole::on_segment(a, b, p)) return false;
      if (whole::orientation(a, b, p) * whole::orientation(a, b, q) < 0 &&
          whole::orientation(p, q, a) * whole::orientation(p, q, b) < 0)
        return false;
    }
    if (a == b) return false;
  }
  return true;
}

bool is_inside(const Query& query) {
  return whole::winding_number(query.polygon, query.point) != 0;
}

bool is_convex(const Query& query) {
  const Points reversed(query.polygon.rbegin(), query.polygon.rend());
  return whole::is_convex(query.polygon) || whole::is_convex(reversed);
}

/// Whether the point is at least 1 m from every edge.
bool is_away(const Query& query) {
  for (std::size_t i = 0; i < query.polygon.size(); ++i) {
    const Point a = query.polygon[i], b = whole::after(query.polygon, i), p = query.point;
    const whole::Vector ab = whole::difference(b, a), ap = whole::difference(p, a),
                        bp = whole::difference(p, b);
    const std::int64_t along = whole::dot(ab, ap), twice = whole::cross(ab, ap);
    if (along <= 0 || along >= whole::dot(ab, ab)) {
      if (std::min(whole::dot(ap, ap), whole::dot(bp, bp)) < 1) return false;
    } else if (twice * twice < whole::dot(ab, ab)) {
      return false;
    }
  }
  return true;
}

bool is_outside_the_box(const Query& query) {
  Eigen::AlignedBox2d box;
  for (const Point& v : query.polygon) box.extend(v);
  const Point p = query.point;
  return p.x() <= box.min().x() - 1 || p.x() >= box.max().x() + 1 || p.y() <= box.min().y() - 1 ||
         p.y() >= box.max().y() + 1;
}

std::string name(bool inside) { return inside ? "inside" : "outside"; }

Judged judged(const Query& query) {
  const bool given = given::inside_by_angles(query.polygon, query.point);
  const bool right = is_inside(query);
  const double turns = given::sum_of_angles(query.polygon, query.point) / (2 * std::numbers::pi);
  return {given != right, name(given), name(right),
          "The angles add up to " + contact::text_of(turns, {.digits = 4}) + " turns."};
}

BreakIt<Query> question(std::string_view text, double limit) {
  return break_it<Query>(text)
      .rule("the polygon has 3 to 12 vertices",
            [](const Query& query) {
              return query.polygon.size() >= 3 && query.polygon.size() <= 12;
            })
      .rule("every coordinate is a whole number from " + contact::text_of(-limit) + " to " +
                contact::text_of(limit),
            [limit](const Query& query) { return all_within(query, limit) && all_whole(query); })
      .rule("the polygon does not cross or touch itself", is_simple)
      .rule("the point is not on the polygon",
            [](const Query& query) { return !whole::on_boundary(query.polygon, query.point); });
}

}  // namespace

TEST_CASE("a point outside a triangle is taken for inside") {
  question("For which triangle and point is the given code wrong?", 1000)
      .rule("the polygon is a triangle",
            [](const Query& query) { return query.polygon.size() == 3; })
      .suspect_if("break-point-is-inside", is_inside)
      .suspect_if("break-sees-less-than-half", [](const Query&) { return true; })
      .input("query", [] { return exercise::outside_a_triangle(); })
      .judge(judged);
}

TEST_CASE("a point 1 m from a quadrilateral is taken for inside") {
  question("For which quadrilateral and point is the given code wrong?", 10)
      .rule("the polygon is a quadrilateral",
            [](const Query& query) { return query.polygon.size() == 4; })
      .rule("the point is at least 1 m from the boundary", is_away)
      .suspect_if("break-point-is-inside", is_inside)
      .suspect_if("break-polygon-is-convex", is_convex)
      .suspect_if("break-angles-too-small", [](const Query&) { return true; })
      .input("query", [] { return exercise::outside_a_quadrilateral(); })
      .judge(judged);
}

TEST_CASE("a point outside the bounding box is taken for inside") {
  question("For which polygon and point outside its bounding box is the given code wrong?", 10)
      .rule("the point is at least 1 m outside the bounding box", is_outside_the_box)
      .suspect_if("break-polygon-is-convex", is_convex)
      .suspect_if("break-angles-too-small", [](const Query&) { return true; })
      .input("query", [] { return exercise::outside_the_bounding_box(); })
      .judge(judged);
}
