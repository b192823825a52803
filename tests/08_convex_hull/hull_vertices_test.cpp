// Right answers are computed in whole numbers. Every test asks for at least two different answers.
#include "hull_vertices.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>

#include <08_convex_hull/whole.hpp>

namespace {

using namespace contact::testing;
using Point = Eigen::Vector3d;
using Points = std::vector<Point>;
using Corners = std::vector<int>;

bool on_edge(const Points& points, int i) {
  const auto& p = points[static_cast<std::size_t>(i)];
  for (const Point& a : points) {
    for (const Point& b : points) {
      if (a != p && b != p && a != b && whole::on_line(a, b, p) && (p - a).dot(p - b) < 0)
        return true;
    }
  }
  return false;
}

bool solid(const Points& points) {
  for (const Point& a : points) {
    for (const Point& b : points) {
      for (const Point& c : points) {
        if (whole::side(points[0], a, b, c) != 0) return true;
      }
    }
  }
  return false;
}

/// Whether the point lies in a plane that has all points on one side.
bool on_boundary(const Points& points, int i) {
  const auto& p = points[static_cast<std::size_t>(i)];
  for (const Point& a : points) {
    for (const Point& b : points) {
      if (!whole::on_line(p, a, b) &&
          std::all_of(points.begin(), points.end(),
                      [&](const Point& q) { return whole::side(p, a, b, q) <= 0; }))
        return true;
    }
  }
  return false;
}

/// The vertices of faces that have no fourth point in their plane.
Corners without_ties(const Points& points) {
  Corners corners;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point& a = points[i];
    bool found = std::find(points.begin(), points.end(), a) ==
                 points.begin() + static_cast<std::ptrdiff_t>(i);
    found = found && std::any_of(points.begin(), points.end(), [&](const Point& b) {
              return std::any_of(points.begin(), points.end(), [&](const Point& c) {
                return !whole::on_line(a, b, c) &&
                       std::all_of(points.begin(), points.end(), [&](const Point& p) {
                         return p == a || p == b || p == c || whole::side(a, b, c, p) < 0;
                       });
              });
            });
    if (found) corners.push_back(static_cast<int>(i));
  }
  return corners;
}

void check(const Points& points) {
  const Corners right = whole::hull_vertices(points);
  const auto has = [](const Corners& list, int i) {
    return std::find(list.begin(), list.end(), i) != list.end();
  };
  const auto valid = [&](const Corners& got) {
    return std::all_of(got.begin(), got.end(),
                       [&](int i) { return i >= 0 && i < static_cast<int>(points.size()); });
  };
  const auto at = [&](int i) { return points[static_cast<std::size_t>(i)]; };
  // All vertices, and besides them only points of the boundary, without copies.
  const auto all_and_more = [&](const Corners& got) {
    return valid(got) && solid(points) && got.size() > right.size() &&
           std::is_sorted(got.begin(), got.end()) &&
           std::all_of(right.begin(), right.end(), [&](int i) { return has(got, i); }) &&
           std::all_of(got.begin(), got.end(), [&](int i) {
             return has(right, i) || (on_boundary(points, i) &&
                                      std::count(points.begin(), points.end(), at(i)) == 1);
           });
  };
  ask("Which points are vertices of the hull?")
      .given("points", points)
      .suspect_if("ties-dropped",
                  [&](const Corners& got) {
                    // Of an empty list the hint would say nothing.
                    return !got.empty() && got.size() < right.size() && solid(points) &&
                           got == without_ties(points);
                  })
      .suspect_if("flat-input-empty",
                  [&](const Corners& got) { return got.empty() && !solid(points); })
      .suspect("axis-extremes-only",
               [&] {
                 Corners extremes;
                 for (std::size_t i = 0; i < points.size(); ++i) {
                   bool extreme = false;
                   bool first = true;
                   for (std::size_t j = 0; j < i; ++j) first = first && points[j] != points[i];
                   for (int k = 0; k < 3; ++k) {
                     bool least = true;
                     bool most = true;
                     for (const Point& p : points) {
                       least = least && points[i][k] <= p[k];
                       most = most && points[i][k] >= p[k];
                     }
                     extreme = extreme || least || most;
                   }
                   if (extreme && first) extremes.push_back(static_cast<int>(i));
                 }
                 return extremes;
               })
      .suspect_if("duplicates-kept",
                  [&](const Corners& got) {
                    // Right but for later copies of points, which are beside the first or instead.
                    if (!valid(got)) return false;
                    Corners once;
                    for (const int i : got) {
                      const auto found = std::find(points.begin(), points.end(), at(i));
                      once.push_back(static_cast<int>(found - points.begin()));
                    }
                    std::sort(once.begin(), once.end());
                    once.erase(std::unique(once.begin(), once.end()), once.end());
                    return once == right && std::any_of(got.begin(), got.end(),
                                                        [&](int i) { return !has(right, i); });
                  })
      .suspect_if("collinear-kept",
                  [&](const Corners& got) {
                    return all_and_more(got) && std::all_of(got.begin(), got.end(), [&](int i) {
                             return has(right, i) || on_edge(points, i);
                           });
                  })
      .suspect_if("face-points-kept",
                  [&](const Corners& got) {
                    return all_and_more(got) && std::any_of(got.begin(), got.end(), [&](int i) {
                             return !has(right, i) && !on_edge(points, i);
                           });
                  })
      .answer([&] { return exercise::hull_vertices(points); })
      .close_to(right, within(0.0));
}

}  // namespace

TEST_CASE("the corners of a box are vertices, and inner points are not") {
  // A box with a roof: only the faces of the roof have no fourth point in their plane.
  check({{0, 0, 0},
         {4, 0, 0},
         {0, 4, 0},
         {1, 1, 1},
         {4, 4, 0},
         {0, 0, 4},
         {4, 0, 4},
         {0, 4, 4},
         {4, 4, 4},
         {1, 2, 3},
         {2, 2, 7}});
  check({{0, 0, 0}, {9, 1, 0}, {1, 8, 2}, {2, 1, 7}, {2, 2, 2}});
}

TEST_CASE("points inside a face or on an edge are no vertices") {
  // Inside a face, and on no line between two others.
  check({{-1, -1, -1}, {9, 0, 0}, {0, 9, 0}, {3, 3, 3}, {0, 0, 9}});
  // On edges only.
  check({{-1, -1, -1}, {8, 0, 0}, {0, 8, 0}, {0, 0, 8}, {4, 4, 0}, {2, 0, 6}, {4, 0, 4}});
}

TEST_CASE("vertices are found in every direction") {
  check({{-9, 0, 0}, {9, 0, 0}, {0, -9, 0}, {0, 9, 0}, {0, 0, -9}, {0, 0, 9}, {5, 5, 5}});
  check({{-9, 0, 0},
         {9, 0, 0},
         {0, -9, 0},
         {0, 9, 0},
         {0, 0, -9},
         {0, 0, 9},
         {-4, 4, 4},
         {2, -2, -3}});
}

TEST_CASE("equal points count once") {
  check({{0, 0, 0}, {5, 0, 0}, {5, 0, 0}, {0, 6, 1}, {1, 0, 7}, {0, 0, 0}});
  check({{1, 0, 7}, {5, 0, 0}, {1, 0, 7}, {0, 6, 1}, {0, 0, 0}});
}

TEST_CASE("coplanar, collinear and equal points have vertices too") {
  check({{0, 0, 0}, {6, 0, 6}, {0, 5, 0}, {6, 5, 6}, {2, 1, 2}});
  check({{1, 1, 1}, {3, 5, 7}, {2, 3, 4}});
  check({{2, 2, 2}, {2, 2, 2}});
  check({{4, 4, 4}});
  check({});
}

TEST_CASE("random sets agree with whole-number arithmetic") {
  generators::Random random(seed(0));
  for (int round = 0; round < 64; ++round) {
    const int size = round % 2 == 0 ? 2 : 1000;
    Points points;
    for (int n = random.integer(1, 14); n > 0; --n) {
      const double x = random.integer(-size, size), y = random.integer(-size, size);
      points.push_back({x, y, round % 4 == 0 ? x : double(random.integer(-size, size))});
    }
    check(points);
  }
}
