// What is right is the exact hull of the book, which the tests of the references hold against an
// oracle. The given code counts as wrong if it returns other vertices, in any order: the order is
// not what it gets wrong.
#include "break_angles.hpp"
#include "hull_by_angles.hpp"

#include <support/break_it.hpp>

#include <contact/hull_2d.hpp>

namespace {

using namespace contact::testing;
using Point = Eigen::Vector2d;
using Points = std::vector<Point>;
using Vertices = std::vector<int>;

bool all_different(const Points& points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (points[i] == points[j]) return false;
    }
  }
  return true;
}

std::size_t lowest_of(const Points& points) {
  std::size_t low = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Point p = points[i], q = points[low];
    if (p.y() < q.y() || (p.y() == q.y() && p.x() < q.x())) low = i;
  }
  return low;
}

/// Calls pair(i, j) for all i < j whose points are in the same direction from the lowest point.
template <class Pair>
void for_each_tie(const Points& points, Pair&& pair) {
  const std::size_t low = lowest_of(points);
  for (std::size_t j = 0; j < points.size(); ++j) {
    for (std::size_t i = 0; i < j; ++i) {
      if (i == low || j == low) continue;
      // No point is below the lowest one or left of it at its height, so points on a line with it
      // are in one direction.
      if (contact::orient_2d(points[low], points[i], points[j]) == 0) pair(i, j);
    }
  }
}

/// Whether all angles about the lowest point differ as std::atan2 rounds them.
bool angles_differ(const Points& points) {
  const std::size_t low = lowest_of(points);
  std::vector<double> angles;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point d = points[i] - points[low];
    if (i != low) angles.push_back(std::atan2(d.y(), d.x()));
  }
  std::sort(angles.begin(), angles.end());
  return std::adjacent_find(angles.begin(), angles.end()) == angles.end();
}

bool no_ties(const Points& points) {
  bool none = true;
  for_each_tie(points, [&](std::size_t, std::size_t) { none = false; });
  return none;
}

/// Whether of each pair in one direction the nearer comes first in the list.
bool nearer_first(const Points& points) {
  bool all = true;
  const Point low = points[lowest_of(points)];
  for_each_tie(points, [&](std::size_t i, std::size_t j) {
    all = all && (points[i] - low).squaredNorm() < (points[j] - low).squaredNorm();
  });
  return all && !no_ties(points);
}

Vertices missing_from(const Vertices& list, const Vertices& of) {
  Vertices missing;
  for (const int i : of) {
    if (std::find(list.begin(), list.end(), i) == list.end()) missing.push_back(i);
  }
  return missing;
}

struct Compared {
  Vertices given, right, lost, extra;
};

Compared compared(const Points& points) {
  Compared all{given::hull_by_angles(points), contact::convex_hull_2d(points), {}, {}};
  std::rotate(all.right.begin(),
              std::find(all.right.begin(), all.right.end(), static_cast<int>(lowest_of(points))),
              all.right.end());
  all.lost = missing_from(all.given, all.right);
  all.extra = missing_from(all.right, all.given);
  return all;
}

std::string listed(const Vertices& indices) {
  std::string text = indices.size() == 1 ? "point " : "points ";
  for (const int i : indices) text += (i == indices.front() ? "" : ", ") + std::to_string(i);
  return text;
}

Judged judged(const Compared& all, bool wrong, const std::string& otherwise) {
  std::string difference;
  if (!all.lost.empty()) difference = "The given code loses " + listed(all.lost) + ".";
  if (!all.extra.empty()) {
    difference += difference.empty() ? "The given code " : " It ";
    difference += "returns " + listed(all.extra) + ", no vertex of the hull.";
  }
  if (difference.empty()) {
    difference = "Both have the same vertices: the given code is right here.";
  } else if (!wrong) {
    difference += " " + otherwise;
  }
  return {wrong, contact::text_of(all.given), contact::text_of(all.right), difference};
}

BreakIt<Points> question(std::string_view text, double limit) {
  return break_it<Points>(text)
      .rule("there are 3 to 50 points",
            [](const Points& p) { return p.size() >= 3 && p.size() <= 50; })
      .rule("every coordinate is a whole number from " + contact::text_of(-limit) + " to " +
                contact::text_of(limit),
            [limit](const Points& p) { return all_within(p, limit) && all_whole(p); })
      .rule("no two points are equal", all_different)
      .rule("the points are not all on one line",
            [](const Points& p) { return contact::convex_hull_2d(p).size() > 2; })
      .suspect_if("break-no-equal-angles",
                  [limit](const Points& p) { return limit < 11 && angles_differ(p); })
      .suspect_if("break-angles-far-apart", angles_differ)
      .suspect_if("break-nearer-point-first", nearer_first);
}

}  // namespace

TEST_CASE("a vertex is lost, and every coordinate is a whole number up to 10") {
  question("Of which points does the given code lose a vertex?", 10)
      .input("points", [] { return exercise::points_that_lose_a_vertex(); })
      .judge([](const Points& points) {
        const Compared all = compared(points);
        return judged(all, !all.lost.empty(), "No vertex is lost.");
      });
}

TEST_CASE("no vertex is lost, and a point of an edge is returned") {
  question("Of which points does the given code return all vertices, and one more point?", 10)
      .input("points", [] { return exercise::points_with_an_extra_vertex(); })
      .judge([](const Points& points) {
        const Compared all = compared(points);
        return judged(all, all.lost.empty() && !all.extra.empty(),
                      "Here no vertex may be lost, and some other point must be returned.");
      });
}

TEST_CASE("no two points are in the same direction from the lowest") {
  question("On which points is the given code wrong, although all directions differ?", 0x1p30)
      .rule("no two points are in the same direction from the lowest point", no_ties)
      .input("points", [] { return exercise::points_in_different_directions(); })
      .judge([](const Points& points) {
        const Compared all = compared(points);
        return judged(all, !all.lost.empty() || !all.extra.empty(), "");
      });
}
