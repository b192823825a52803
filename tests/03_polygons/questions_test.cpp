#include "support/questions.hpp"

#define CONTACT_FIGURE_NO_MAIN
#include <algorithm>
#include <array>
#include <cmath>
#include <contact/arc.hpp>
#include <contact/convex_polygon.hpp>
#include <contact/figure.hpp>
#include <contact/perimeter.hpp>
#include <contact/point_in_polygon.hpp>
#include <contact/polygon_in_space.hpp>
#include <contact/segments.hpp>
#include <numbers>
#include <string>
#include <vector>

namespace where_figure {
#include "figures/where.cpp"
}

namespace questions_test {

namespace {

using contact::Polygon;
using contact::Segment2;
using contact::Vector2;
using contact::Where;

Polygon<double> square(double low, double high) {
  return {{low, low}, {high, low}, {high, high}, {low, high}};
}

/// The sum of the magnitudes of the angles at p, degrees.
double angles_without_signs(const Polygon<double>& polygon, const Vector2<double>& p) {
  double sum = 0;
  contact::for_each_edge(polygon, [&](const Vector2<double>& a, const Vector2<double>& b) {
    const Vector2<double> u = (a - p).normalized(), v = (b - p).normalized();
    sum += std::acos(std::clamp(u.dot(v), -1.0, 1.0));
  });
  return sum * 180 / std::numbers::pi;
}

}  // namespace

KEY("distance-from-an-edge") {
  const Vector2<double> a(1, 0), b(4, 4), p(2, 3);
  return contact::cross2<double>(b - a, p - a) / (b - a).norm();
}

KEY("bisection-of-a-thousand") {
  // Counted: a point in the middle of a polygon of 1,000 vertices, by halving what is left.
  int count = 2, candidates = 998;
  for (; candidates > 1; candidates = (candidates + 1) / 2) ++count;
  ++count;
  const std::array options{3, 13, 32, 500};
  int nearest = 0;
  for (int i = 0; i < 4; ++i) {
    const auto off = [&](int k) {
      return std::abs(options.at(static_cast<std::size_t>(k)) - count);
    };
    if (off(i) < off(nearest)) nearest = i;
  }
  return nearest;
}

KEY("angles-without-signs") {
  // Random inner points of a concave polygon: equal to 360° somewhere, more elsewhere, never less.
  const Polygon<double> concave{{0, 0}, {4, 0}, {4, 3}, {2, 0.5}, {0, 3}};
  bool equal = false, more = false, less = false;
  for (double x = 0.05; x < 4; x += 0.1) {
    for (double y = 0.05; y < 3; y += 0.1) {
      if (contact::where(concave, {x, y}) != Where::inside) continue;
      const double sum = angles_without_signs(concave, {x, y});
      less = less || sum < 360 - 1e-6;
      more = more || sum > 360 + 1e-6;
      equal = equal || std::abs(sum - 360) <= 1e-6;
    }
  }
  if (less && more) return 3;
  if (less) return 2;
  return more && equal ? 1 : 0;
}

KEY("opposite-quadrant") {
  // The change of this edge: that of a closed triangle without those of its two other edges, which
  // lead through the fourth and the first quadrant one step each.
  const Polygon<double> closed{{3, 1}, {-1, -2}, {2, -1}};
  const int others = 1 + 1;  // from the third quadrant to the fourth, and on to the first
  return static_cast<double>(contact::quadrant_sum(closed, Vector2<double>(0, 0)) - others);
}

KEY("vertex-at-the-height") {
  const Polygon<double> on_a_corner{{-1, 0}, {0, -1}, {1, 0}, {0, 1}};
  return static_cast<double>(contact::crossings_with_ends(on_a_corner, Vector2<double>(0, 0)));
}

KEY("both-ends-wrong") {
  // A square that stands on a corner, with corners in between, and p at the height of two of them.
  where_figure::Input in{};
  in.a = {0, -3}, in.b = {1.5, -1.5}, in.c = {3, 0}, in.d = {1.5, 1.5};
  in.e = {0, 3}, in.f = {-1.5, 1.5}, in.g = {-3, 0}, in.h = {-1.5, -1.5};
  in.p = {0, 0};
  const double winning = where_figure::compute(in).ends_wrong;
  in.p.y() = 0.5;
  return questions::Construct{winning, where_figure::compute(in).ends_wrong};
}

KEY("why-half-open") {
  // Whether the parity is right at the height of every vertex of a polygon: with the rule, and with
  // both ends included.
  const Polygon<double> zigzag{{0, 0},     {2, 2}, {4, 0}, {6, 3}, {8, 0},
                               {9.5, 2.5}, {9, 5}, {4, 3}, {1, 5}};
  const auto always_right = [&](auto where_by) {
    for (const Vector2<double>& v : zigzag) {
      for (double x = -0.95; x < 10; x += 0.1) {
        const Vector2<double> p(x, v.y());
        const Where right = contact::where(zigzag, p);
        if (right != Where::on && where_by(zigzag, p) != right) return false;
      }
    }
    return true;
  };
  return questions::Claim{
      always_right([](const auto& q, const auto& p) { return contact::where_by_crossings(q, p); }),
      always_right([](const auto& q, const auto& p) {
        return contact::where_by_crossings_with_ends(q, p);
      })};
}

KEY("corners-of-a-square") {
  const Polygon<double> unit = square(0, 1);
  double inside = 0;
  for (const Vector2<double>& corner : unit) {
    if (contact::where_by_crossings(unit, corner) == Where::inside) ++inside;
  }
  return inside;
}

KEY("centre-of-a-star") {
  Polygon<double> star;
  for (int i = 0; i < 5; ++i) {
    const double angle = 2 * i * 2 * std::numbers::pi / 5;
    star.push_back({std::cos(angle), std::sin(angle)});
  }
  return std::abs(1.0 * contact::winding_number(star, Vector2<double>(0, 0)).value());
}

KEY("hole-the-same-way") {
  // The edges of both: two polygons in one list, joined along an edge that is there twice.
  const Polygon<double> room = square(0, 10), pillar = square(4, 6);
  const Vector2<double> p(5, 5);
  const int winding =
      contact::winding_number(room, p).value() + contact::winding_number(pillar, p).value();
  CHECK(winding == 2);
  return winding != 0 ? 0 : 1;
}

KEY("fraction-of-a-segment") {
  const auto found =
      contact::crossing(Segment2<double>{{0, 0}, {4, 2}}, Segment2<double>{{3, 0}, {1, 4}});
  CHECK(found.meeting == contact::Meeting::crossing);
  return found.along_first;
}

KEY("four-zeros") {
  // On one line: with a gap, with a common point, and with a common segment.
  const auto meet = [](double start) {
    return contact::meet(Segment2<double>{{0, 0}, {50, 50}},
                         Segment2<double>{{start, start}, {100, 100}});
  };
  const bool all = meet(51) == contact::Meeting::none && meet(50) == contact::Meeting::touching &&
                   meet(49) == contact::Meeting::overlapping;
  return all ? 1 : 0;
}

KEY("between-two-points") {
  // The greatest depth at which no point of the edge is in the corner, by bisection.
  const auto noticed = [](double depth) {
    const Polygon<double> corner{{0, -depth}, {2, 2 - depth}, {-2, 2 - depth}};
    return contact::where(corner, Vector2<double>(0.25, 0)) != Where::outside ||
           contact::where(corner, Vector2<double>(-0.25, 0)) != Where::outside;
  };
  double unseen = 0, seen = 1;
  for (int i = 0; i < 40; ++i) {
    const double middle = (unseen + seen) / 2;
    (noticed(middle) ? seen : unseen) = middle;
  }
  return unseen;
}

KEY("nearer-end") {
  // A side that is 0.3 m below the floor, measured along it, and 0.1 m from the tile's end.
  const double low = 0.3 * std::numbers::sqrt2 / 2;
  const Polygon<double> box{{0, -low}, {1, 1 - low}, {0, 2 - low}, {-1, 1 - low}};
  const Polygon<double> tile{
      {low + 0.1 - 0.5, -1}, {low + 0.1, -1}, {low + 0.1, 0}, {low + 0.1 - 0.5, 0}};
  const auto contact = contact::perimeter_contact(box, tile);
  const Vector2<double> up(0, 1);
  for (const auto& hit : contact.found.hits) {
    if (std::abs(hit.crossing.point.x() - low) > 1e-9 || std::abs(hit.crossing.point.y()) > 1e-9)
      continue;
    const Vector2<double> normal = contact::normal_by_nearer_end(contact, hit);
    return (normal - up).norm() < 1e-9 ? 0 : 1;
  }
  return 3;
}

KEY("order-for-a-wall") {
  // What each step makes, and what it needs of the others.
  return questions::only_order({{"where", {"dropped"}},
                                {"area vector", {}},
                                {"dropped", {"area vector", "point"}},
                                {"point", {"area vector"}}});
}

}  // namespace questions_test
