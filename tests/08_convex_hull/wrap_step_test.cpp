// Right answers are computed in whole numbers. Every test asks for at least two different answers.
#include "wrap_step.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>

#include <08_convex_hull/whole.hpp>

namespace {

using namespace contact::testing;
using Point = Eigen::Vector3d;
using Points = std::vector<Point>;

/// The first index whose triangle over the edge has no point in front.
int over_edge(const Points& points, const Point& from, const Point& to) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (whole::on_line(to, from, points[i])) continue;
    const auto in_front = [&](const Point& p) { return whole::side(to, from, points[i], p) > 0; };
    if (std::none_of(points.begin(), points.end(), in_front)) return static_cast<int>(i);
  }
  return -1;
}

int folded_back(const Points& points, const Point& f, const Point& t) {
  const int inner = over_edge(points, t, f);  // a third point of the known face
  const Point normal = (t - f).cross(points[static_cast<std::size_t>(inner)] - f);
  double least = 4;
  int best = inner;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (whole::on_line(t, f, points[i]) || static_cast<int>(i) == inner) continue;
    const Point turned = (f - t).cross(points[i] - t);
    const double cosine = std::abs(normal.dot(turned)) / (normal.norm() * turned.norm());
    const double angle = std::acos(std::min(1.0, cosine));
    if (angle < least - 1e-7) {
      least = angle;
      best = static_cast<int>(i);
    }
  }
  return best;
}

int nearest(const Points& points, const Point& f, const Point& t) {
  int best = -1;
  double least = -1;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (whole::on_line(t, f, points[i])) continue;
    const double distance = (t - f).cross(points[i] - f).squaredNorm();
    if (least < 0 || distance < least) {
      least = distance;
      best = static_cast<int>(i);
    }
  }
  return best;
}

int inwards(const Points& points, const Point& f, const Point& t) {
  std::size_t best = 0;
  while (whole::on_line(t, f, points[best])) ++best;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (whole::side(t, f, points[best], points[i]) < 0) best = i;
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!whole::on_line(t, f, points[i]) && whole::side(t, f, points[best], points[i]) == 0) {
      return static_cast<int>(i);
    }
  }
  return -1;
}

void check(const Points& points, int from, int to) {
  const Point f = points[static_cast<std::size_t>(from)], t = points[static_cast<std::size_t>(to)];
  const int right = over_edge(points, f, t);
  ask("Which point makes the next face over the edge?")
      .given("points", points)
      .given("from", from)
      .given("to", to)
      .suspect_if("starts-on-the-edge",
                  [&](const int& got) {
                    return got >= 0 && got < static_cast<int>(points.size()) &&
                           whole::on_line(t, f, points[static_cast<std::size_t>(got)]);
                  })
      .suspect_if("tie-to-the-last",
                  [&](const int& got) {
                    return got > right && got < static_cast<int>(points.size()) &&
                           !whole::on_line(t, f, points[static_cast<std::size_t>(got)]) &&
                           whole::side(t, f, points[static_cast<std::size_t>(right)],
                                       points[static_cast<std::size_t>(got)]) == 0;
                  })
      .suspect("fold-back", [&] { return folded_back(points, f, t); })
      .suspect("nearest-point", [&] { return nearest(points, f, t); })
      .suspect("wraps-inwards", [&] { return inwards(points, f, t); })
      .answer([&] { return exercise::wrap_step(points, from, to); })
      .close_to(right, within(0.0));
}

/// Finds the edges of a set and asks for the fold over each of them.
void check_all_edges(const Points& points, int most) {
  int asked = 0;
  const int n = static_cast<int>(points.size());
  for (int a = 0; a < n; ++a) {
    for (int b = 0; b < n; ++b) {
      for (int c = 0; c < n && asked < most; ++c) {
        const auto at = [&](int i) { return points[static_cast<std::size_t>(i)]; };
        if (whole::on_line(at(a), at(b), at(c))) continue;
        // From a to b there must be an edge and not a diagonal of a face: then the fold has an
        // answer.
        const auto in_front = [&](const Point& p) {
          return whole::side(at(a), at(b), at(c), p) > 0;
        };
        if (std::any_of(points.begin(), points.end(), in_front)) continue;
        const int over = over_edge(points, at(a), at(b));
        if (over < 0 || whole::side(at(a), at(b), at(c), at(over)) == 0) continue;
        check(points, a, b);
        ++asked;
        break;
      }
    }
  }
}

}  // namespace

TEST_CASE("the next face of a box and of a pyramid is found") {
  const Points box{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {4, 4, 0}, {0, 0, 3},
                   {4, 0, 3}, {0, 4, 3}, {4, 4, 3}, {1, 1, 2}};
  check_all_edges(box, 200);
  const Points pyramid{{-6, -6, 0}, {6, -6, 0}, {6, 6, 0}, {-6, 6, 0}, {0, 0, 9}, {1, -5, 1}};
  check_all_edges(pyramid, 200);
}

TEST_CASE("over a sharp edge the paper folds on and not back") {
  // A wedge: the last two points are almost directly behind the first face.
  const Points wedge{{0, 0, 0}, {0, 10, 0}, {40, 5, 0}, {39, 4, -2}, {20, 5, -12}, {10, 6, -3}};
  check(wedge, 1, 0);
  check(wedge, 0, 2);
  check(wedge, 2, 1);
  check_all_edges(wedge, 100);
}

TEST_CASE("points on the edge's line make no face") {
  const Points set{{2, 0, 0}, {3, 0, 0}, {0, 0, 0}, {5, 0, 0}, {2, 6, 0}, {3, 3, -5}, {1, 1, -1}};
  check(set, 2, 3);
  const Points other{{1, 0, 0}, {0, 0, 0}, {4, 0, 0}, {0, 5, 0}, {2, 2, 2}, {3, 1, 7}, {0, -2, 1}};
  check_all_edges(other, 60);
}

TEST_CASE("of several points in the new plane the one with the smallest index counts") {
  const Points box{{0, 0, 0},  {4, 0, 0},  {4, 4, 0},  {0, 4, 0},  {2, 0, -2},
                   {0, 0, -3}, {4, 0, -3}, {4, 4, -3}, {0, 4, -3}, {4, 1, -1}};
  check(box, 0, 1);
  check(box, 1, 2);
  check(box, 2, 3);
  check(box, 3, 0);
}

TEST_CASE("random sets agree with whole-number arithmetic") {
  generators::Random random(seed(0));
  for (int round = 0; round < 40; ++round) {
    const int size = round % 2 == 0 ? 1000 : 3;
    Points points;
    for (int n = random.integer(6, 12); n > 0; --n) {
      const double x = random.integer(-size, size), y = random.integer(-size, size);
      points.push_back({x, y, double(random.integer(-size, size))});
    }
    // Not all coplanar, as the contract says.
    bool solid = false;
    for (const Point& a : points) {
      for (const Point& b : points) {
        for (const Point& c : points) solid = solid || whole::side(points[0], a, b, c) != 0;
      }
    }
    if (solid) check_all_edges(points, 8);
  }
}
