// Compares the book's test of a point in a polygon with those of CGAL, Boost.Geometry and GEOS:
// medians of several runs, and wrong answers of each. usage: polygon_peers [points] [runs]
#include "peers.hpp"

#include <support/generators.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <contact/point_in_polygon.hpp>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>

namespace {

using contact::Exact;
using peers::Place;
using Point = contact::Vector2<double>;
using Points = std::vector<Point>;

generators::Random dice(1);

/// Once around the origin, each vertex at a random distance: concave, without crossing itself.
Points star(int count) {
  Points vertices;
  for (int i = 0; i < count; ++i) {
    const double angle = (i + dice.uniform(0.05, 0.95)) / count * 6.283185307179586;
    vertices.push_back(Point(std::cos(angle), std::sin(angle)) * dice.uniform(0.2, 1));
  }
  return vertices;
}

Point in_square() {
  const double x = dice.uniform(-1, 1);
  return {x, dice.uniform(-1, 1)};
}

/// A comb of whole numbers: teeth of height 8 and 3, with level and vertical edges.
Points comb() {
  Points vertices{{0, -1}};
  for (int tooth = 0; tooth < 8; ++tooth) {
    const double x = 2 * tooth, top = tooth % 2 != 0 ? 8 : 3;
    for (const Point& v : {Point(x, 0), Point(x, top), Point(x + 1, top), Point(x + 1, 0)})
      vertices.push_back(v);
  }
  vertices.emplace_back(15, -1);
  std::reverse(vertices.begin(), vertices.end());
  return vertices;
}

/// By exact numbers without a filter.
Place exactly(const Points& polygon, const Point& p) {
  const auto in_exact = [](const Point& v) {
    return contact::Vector2<Exact>(Exact(v.x()), Exact(v.y()));
  };
  bool odd = false, on = false;
  contact::for_each_edge(polygon, [&](const Point& a, const Point& b) {
    if (std::max(a.y(), b.y()) < p.y() || std::min(a.y(), b.y()) > p.y()) return;
    const int side = contact::orientation<Exact>(in_exact(a), in_exact(b), in_exact(p)).sign();
    on = on || (side == 0 && std::min(a.x(), b.x()) <= p.x() && p.x() <= std::max(a.x(), b.x()));
    if ((a.y() > p.y()) != (b.y() > p.y())) odd ^= (side > 0) == (b.y() > p.y());
  });
  return on ? Place::on : odd ? Place::inside : Place::outside;
}

std::vector<double> flat(const Points& points) {
  std::vector<double> coordinates;
  for (const Point& p : points) coordinates.insert(coordinates.end(), {p.x(), p.y()});
  return coordinates;
}

struct Method {
  std::string name;
  peers::Locate locate;
  bool two_answers = false;  ///< never `on`: not wrong on the boundary
  bool closed = false;       ///< `inside` includes the boundary
};

/// Whether a method's answer is not the right one of those that it can give.
bool is_wrong(const Method& method, Place got, Place right) {
  if (right == Place::on && method.two_answers) return false;
  if (right == Place::on && method.closed) return got != Place::inside;
  return got != right;
}

/// Without a branch, which could not be predicted and would be timed.
Place place(contact::Where where) {
  static_assert(static_cast<int>(contact::Where::outside) == static_cast<int>(Place::outside) &&
                static_cast<int>(contact::Where::inside) == static_cast<int>(Place::inside));
  return static_cast<Place>(where);
}

void compare(const char* family, const std::vector<Points>& polygons, const Points& points,
             int runs) {
  const auto book = [&](auto ask) {
    return [&polygons, &points, ask](std::vector<Place>& places) {
      peers::in_turn(polygons, points, places, ask);
    };
  };
  std::vector<Method> methods{
      {"Contact Hours, crossings", book([](const Points& polygon, const Point& p) {
         return place(contact::where_by_crossings(polygon, p));
       }),
       true},
      {"Contact Hours, where", book([](const Points& polygon, const Point& p) {
         return place(contact::where(polygon, p));
       })}};
  peers::Questions questions;
  for (const Points& polygon : polygons) questions.polygons.push_back(flat(polygon));
  questions.points = flat(points);
#ifdef CONTACT_HAS_CGAL
  methods.push_back({"CGAL, bounded_side_2", peers::cgal(questions)});
#endif
#ifdef CONTACT_HAS_BOOST
  methods.push_back(
      {"Boost.Geometry, covered_by", peers::boost_covered_by(questions), false, true});
#endif
#ifdef CONTACT_HAS_GEOS
  methods.push_back({"GEOS, locateInRing", peers::geos(questions)});
  methods.push_back({"GEOS, with its index", peers::geos_indexed(questions)});
#endif
  std::vector<Place> right;
  std::size_t on = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    right.push_back(exactly(polygons[i % polygons.size()], points[i]));
    if (right.back() == Place::on) ++on;
  }
  std::vector<std::vector<double>> times(methods.size());
  std::vector<std::size_t> wrong(methods.size());
  std::vector<Place> places(points.size());
  // In turns, so that a slow moment of the machine does not fall on one method only.
  for (int run = 0; run <= runs; ++run) {
    for (std::size_t m = 0; m < methods.size(); ++m) {
      const auto start = std::chrono::steady_clock::now();
      methods[m].locate(places);
      const std::chrono::duration<double, std::nano> elapsed =
          std::chrono::steady_clock::now() - start;
      if (run > 0) {
        times[m].push_back(elapsed.count() / static_cast<double>(points.size()));
        continue;
      }
      for (std::size_t i = 0; i < points.size(); ++i)  // the first one warms up
        if (is_wrong(methods[m], places[i], right[i])) ++wrong[m];
    }
  }
  std::printf("%s, %zu vertices, %zu points, %zu on the boundary\n  %-28s %10s %19s %9s\n", family,
              polygons[0].size(), points.size(), on, "", "ns a point", "least - most", "wrong");
  for (std::size_t m = 0; m < methods.size(); ++m) {
    std::sort(times[m].begin(), times[m].end());
    std::printf("  %-28s %10.1f %8.1f - %8.1f %9zu\n", methods[m].name.c_str(),
                times[m][times[m].size() / 2], times[m].front(), times[m].back(), wrong[m]);
  }
  std::printf("\n");
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t count = argc > 1 ? static_cast<std::size_t>(std::atol(argv[1])) : 100000;
  const int runs = argc > 2 ? std::max(1, std::atoi(argv[2])) : 9;
  const auto stars = [](int number, int vertices) {
    std::vector<Points> polygons;
    for (int i = 0; i < number; ++i) polygons.push_back(star(vertices));
    return polygons;
  };
  const auto each = [](const std::vector<Points>& polygons, std::size_t number, auto draw) {
    Points points;
    for (std::size_t i = 0; i < number; ++i) points.push_back(draw(polygons[i % polygons.size()]));
    return points;
  };
  const auto anywhere = [](const Points&) { return in_square(); };
  const auto any_vertex = [](const Points& polygon) {
    return static_cast<std::size_t>(dice.integer(0, static_cast<int>(polygon.size()) - 1));
  };
  const std::vector<Points> of_16 = stars(1000, 16), of_256 = stars(100, 256);
  compare("random, 1,000 polygons", of_16, each(of_16, count, anywhere), runs);
  compare("random, 100 polygons", of_256, each(of_256, count, anywhere), runs);
  const std::vector<Points> single = stars(1, 16);
  compare("random, one polygon", single, each(single, count, anywhere), runs);
  const auto on_edge = [&](const Points& polygon) {
    const std::size_t i = any_vertex(polygon);
    const Point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    return Point(a + dice.uniform() * (b - a));
  };
  compare("on an edge, rounded, 1,000 polygons", of_16, each(of_16, count, on_edge), runs);
  const auto at_level = [&](const Points& polygon) {
    const double y = polygon[any_vertex(polygon)].y();
    return Point(dice.uniform(-1, 1), y);
  };
  compare("at the level of a vertex, 1,000 polygons", of_16, each(of_16, count, at_level), runs);
  const std::vector<Points> combs{comb()};
  const auto on_grid = [](const Points&) {
    const double x = dice.integer(-1, 16);
    return Point(x, dice.integer(-2, 9));
  };
  compare("whole numbers, one polygon", combs, each(combs, count, on_grid), runs);
}
