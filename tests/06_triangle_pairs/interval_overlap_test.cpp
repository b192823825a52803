// What is right is decided in integers, or by orientations that are exact.
#include "interval_overlap.hpp"
#include "triangles_meet.hpp"

#include <support/break_it.hpp>

#include <06_triangle_pairs/exercise_pairs.hpp>
#include <contact/orientation.hpp>

namespace {

using namespace contact::testing;
using namespace exercise_pairs;
using exercise::Pair;

Triangle first_of(const Pair& pair) { return {pair.a, pair.b, pair.c}; }
Triangle second_of(const Pair& pair) { return {pair.p, pair.q, pair.r}; }

std::string name(bool meet) { return meet ? "meet" : "apart"; }

Judged judged(const Pair& pair, bool right, std::string difference) {
  const bool given = given::triangles_meet(first_of(pair), second_of(pair));
  return {given != right, name(given), name(right), std::move(difference)};
}

/// The distances as the given code computes and changes them.
Point given_distances(const Triangle& of, const Triangle& other) {
  return given::distances(of, other);
}

std::string say_distances(const Pair& pair) {
  const Triangle first = first_of(pair), second = second_of(pair);
  return "The given code's distances are " + contact::text_of(given_distances(first, second)) +
         " and " + contact::text_of(given_distances(second, first)) + ".";
}

// Whole numbers up to 10: everything in integers.

/// A coordinate of a point on the common line: a quotient with a positive denominator.
struct Fraction {
  std::int64_t at = 0, over = 1;
};
bool less(const Fraction& x, const Fraction& y) { return x.at * y.over < y.at * x.over; }

/// Where the border of a triangle begins and ends on the common line of the planes.
std::pair<Fraction, Fraction> ends(const Triangle& t, const Triangle& other, int along) {
  const std::array<std::int64_t, 3> d = distances(t, other);
  const std::array<Point, 3> u = vertices(t);
  std::vector<Fraction> all;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    if (d[i] * d[j] > 0 || (d[i] == 0 && d[j] == 0)) continue;
    const auto of = [&](std::size_t k) { return static_cast<std::int64_t>(u[k][along]); };
    const std::int64_t of_i = std::abs(d[j]), of_j = std::abs(d[i]);
    all.push_back({of_i * of(i) + of_j * of(j), of_i + of_j});
  }
  return {*std::min_element(all.begin(), all.end(), less),
          *std::max_element(all.begin(), all.end(), less)};
}

int line_coordinate(const Pair& pair) {
  const Vector line = cross(normal(first_of(pair)), normal(second_of(pair)));
  int best = 0;
  for (int i = 1; i < 3; ++i)
    if (std::abs(line.at[static_cast<std::size_t>(i)]) >
        std::abs(line.at[static_cast<std::size_t>(best)]))
      best = i;
  return best;
}

/// Where the one interval ends and the other begins, if they have a point in common.
std::pair<Fraction, Fraction> overlap(const Pair& pair) {
  const int along = line_coordinate(pair);
  const auto [low, high] = ends(first_of(pair), second_of(pair), along);
  const auto [low2, high2] = ends(second_of(pair), first_of(pair), along);
  return {less(low, low2) ? low2 : low, less(high, high2) ? high : high2};
}

bool is_long(const Pair& pair) {
  const auto [begin, end] = overlap(pair);
  return less(begin, end);
}

/// Whether a double holds the quotient, and it is what the given code computes.
bool is_exact(const Fraction& x, double computed) {
  const std::int64_t over = x.over / std::gcd(x.at, x.over);
  return (over & (over - 1)) == 0 &&
         static_cast<double>(x.at) / static_cast<double>(x.over) == computed;
}

std::array<given::Interval, 2> given_intervals(const Pair& pair) {
  const Triangle first = first_of(pair), second = second_of(pair);
  const int along = line_coordinate(pair);
  return {given::interval(first, given_distances(first, second), along),
          given::interval(second, given_distances(second, first), along)};
}

/// Whether all ends at the only common point are computed without rounding.
bool ends_are_exact(const Pair& pair) {
  const int along = line_coordinate(pair);
  const Fraction at = overlap(pair).first;
  const auto [one, other] = given_intervals(pair);
  const auto exact = [&](const std::pair<Fraction, Fraction>& ends, const given::Interval& given) {
    const auto is_there = [&](const Fraction& end) { return !less(end, at) && !less(at, end); };
    return (!is_there(ends.first) || is_exact(ends.first, given.low)) &&
           (!is_there(ends.second) || is_exact(ends.second, given.high));
  };
  return exact(ends(first_of(pair), second_of(pair), along), one) &&
         exact(ends(second_of(pair), first_of(pair), along), other);
}

std::string say_intervals(const Pair& pair) {
  const auto [one, other] = given_intervals(pair);
  const auto text = [](const given::Interval& interval) {
    return contact::text_of(interval.low) + " to " + contact::text_of(interval.high);
  };
  return "Along " + std::string(1, "xyz"[line_coordinate(pair)]) +
         ", the given code's intervals are " + text(one) + " and " + text(other) + ".";
}

// Any numbers: orientations of contact, which are exact.

bool has_exact_area(const Triangle& t) {
  const auto without = [](const Point& p, int axis) {
    return contact::Vector2<double>(p[(axis + 1) % 3], p[(axis + 2) % 3]);
  };
  for (int axis = 0; axis < 3; ++axis)
    if (contact::orient_2d(without(t.a, axis), without(t.b, axis), without(t.c, axis)) != 0)
      return true;
  return false;
}

double gap(const Pair& pair) {
  double largest = -1;
  for (int i = 0; i < 3; ++i) {
    const auto [low, high] = std::minmax({pair.a[i], pair.b[i], pair.c[i]});
    const auto [low2, high2] = std::minmax({pair.p[i], pair.q[i], pair.r[i]});
    largest = std::max({largest, low2 - high, low - high2});
  }
  return largest;
}

double shortest_edge(const Triangle& t) {
  return std::min({(t.b - t.a).norm(), (t.c - t.b).norm(), (t.a - t.c).norm()});
}

bool in_exact_plane(const Pair& pair) {
  const auto in_plane = [&](const Point& p) {
    return contact::orient_3d(pair.a, pair.b, pair.c, p) == 0;
  };
  return in_plane(pair.p) && in_plane(pair.q) && in_plane(pair.r);
}

/// Whether a point of the plane of a, b, c is inside this triangle, not on its border.
bool is_inside(const Pair& pair, const Point& p) {
  for (int axis = 0; axis < 3; ++axis) {
    const auto flat = [axis](const Point& v) {
      return contact::Vector2<double>(v[(axis + 1) % 3], v[(axis + 2) % 3]);
    };
    const int side = contact::orient_2d(flat(pair.a), flat(pair.b), flat(pair.c));
    if (side == 0) continue;
    return contact::orient_2d(flat(pair.a), flat(pair.b), flat(p)) == side &&
           contact::orient_2d(flat(pair.b), flat(pair.c), flat(p)) == side &&
           contact::orient_2d(flat(pair.c), flat(pair.a), flat(p)) == side;
  }
  return false;
}

/// Whether the given code takes the triangles for triangles in one plane.
bool taken_for_coplanar(const Pair& pair) {
  const Triangle first = first_of(pair), second = second_of(pair);
  return given_distances(first, second).isZero(0) || given_distances(second, first).isZero(0);
}

BreakIt<Pair> question(std::string_view text, double limit) {
  return break_it<Pair>(text)
      .rule(
          "every coordinate is from " + contact::text_of(-limit) + " to " + contact::text_of(limit),
          [limit](const Pair& pair) { return all_within(pair, limit); })
      .rule("both triangles have an area", [](const Pair& pair) {
        return has_exact_area(first_of(pair)) && has_exact_area(second_of(pair));
      });
}

}  // namespace

TEST_CASE("triangles with a common point are said to be apart") {
  question("For which triangles with a common point is the given code wrong?", 10)
      .rule("every coordinate is a whole number", [](const Pair& pair) { return all_whole(pair); })
      .rule("the triangles are not in one plane",
            [](const Pair& pair) { return !in_one_plane(first_of(pair), second_of(pair)); })
      .rule("the triangles have a point in common",
            [](const Pair& pair) { return meet_across_planes(first_of(pair), second_of(pair)); })
      .suspect_if("break-overlap-is-long", is_long)
      .suspect_if("break-ends-are-exact", ends_are_exact)
      .suspect_if("break-rounded-the-other-way", [](const Pair&) { return true; })
      .input("pair", [] { return exercise::common_point_missed(); })
      .judge([](const Pair& pair) { return judged(pair, true, say_intervals(pair)); });
}

TEST_CASE("triangles with a gap between them are said to meet") {
  // What is typed as 0.005 may be a little less, and so may a difference.
  constexpr double kLeast = 0.005 * (1 - 1e-12);
  question("For which triangles with a gap between them is the given code wrong?", 1)
      .rule("no edge is shorter than 0.005",
            [](const Pair& pair) {
              return shortest_edge(first_of(pair)) >= kLeast &&
                     shortest_edge(second_of(pair)) >= kLeast;
            })
      .rule("in one of the coordinates the triangles are apart by at least 0.005",
            [](const Pair& pair) { return gap(pair) >= kLeast; })
      .suspect_if("break-distance-is-above",
                  [](const Pair& pair) { return !taken_for_coplanar(pair); })
      .suspect_if("break-apart-in-the-plane", [](const Pair&) { return true; })
      .input("pair", [] { return exercise::gap_missed(); })
      .judge([](const Pair& pair) { return judged(pair, false, say_distances(pair)); });
}

TEST_CASE("a triangle inside another is said to be apart from it") {
  question("For which triangle inside another is the given code wrong?", 1e7)
      .rule("every coordinate is a whole number", [](const Pair& pair) { return all_whole(pair); })
      .rule("p, q and r are in the plane of a, b and c", in_exact_plane)
      .rule("p, q and r are inside the triangle a, b, c",
            [](const Pair& pair) {
              return is_inside(pair, pair.p) && is_inside(pair, pair.q) && is_inside(pair, pair.r);
            })
      .suspect_if("break-distances-are-zero", taken_for_coplanar)
      .suspect_if("break-reached-by-rounding", [](const Pair&) { return true; })
      .input("pair", [] { return exercise::inside_missed(); })
      .judge([](const Pair& pair) { return judged(pair, true, say_distances(pair)); });
}
