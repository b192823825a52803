// Right answers are computed in whole numbers, from the parameters of the common points. Every test
// asks for several answers, and each question in both orders and directions.
#include "segments_meet.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>
#include <support/shrinkable.hpp>

#include <03_polygons/whole.hpp>

namespace {

using namespace contact::testing;
using exercise::Meeting;
using exercise::Segment;
using whole::cross;
using whole::difference;
using whole::dot;
using whole::Point;

whole::Vector along(const Segment& s) { return difference(s.b, s.a); }
bool is_point(const Segment& s) { return s.a == s.b; }
bool is_parallel(const Segment& s, const Segment& t) { return cross(along(s), along(t)) == 0; }
/// Whether all four ends are on one line, given that s is no point.
bool on_one_line(const Segment& s, const Segment& t) {
  return whole::area(s.a, s.b, t.a) == 0 && whole::area(s.a, s.b, t.b) == 0;
}

Meeting of_interval(std::int64_t low, std::int64_t high) {
  return low > high ? Meeting::none : (low == high ? Meeting::touching : Meeting::overlapping);
}

Meeting truth(const Segment& s, const Segment& t) {
  if (is_point(s) || is_point(t)) {
    const bool meet =
        is_point(s) ? whole::on_segment(t.a, t.b, s.a) : whole::on_segment(s.a, s.b, t.a);
    return meet ? Meeting::touching : Meeting::none;
  }
  const whole::Vector u = along(s), v = along(t), w = difference(t.a, s.a);
  std::int64_t d = cross(u, v), of_s = cross(w, v), of_t = cross(w, u);
  if (d == 0) {
    if (cross(u, w) != 0) return Meeting::none;
    // Along u, from s.a: s is from 0 to u · u.
    const std::int64_t a = dot(u, w), b = dot(u, difference(t.b, s.a));
    return of_interval(std::max<std::int64_t>(0, std::min(a, b)),
                       std::min(dot(u, u), std::max(a, b)));
  }
  if (d < 0) d = -d, of_s = -of_s, of_t = -of_t;
  if (of_s < 0 || of_s > d || of_t < 0 || of_t > d) return Meeting::none;
  const bool at_an_end = of_s == 0 || of_s == d || of_t == 0 || of_t == d;
  return at_an_end ? Meeting::touching : Meeting::crossing;
}

/// With the ranges of x of segments on one line.
Meeting by_x(const Segment& s, const Segment& t, Meeting right) {
  if (is_point(s) || is_point(t) || !is_parallel(s, t) || !on_one_line(s, t)) return right;
  const double low = std::max(std::min(s.a.x(), s.b.x()), std::min(t.a.x(), t.b.x()));
  const double high = std::min(std::max(s.a.x(), s.b.x()), std::max(t.a.x(), t.b.x()));
  return of_interval(whole::to_integer(low), whole::to_integer(high));
}

/// With the ends of `other` on `s` alone.
Meeting by_ends_of(const Segment& other, const Segment& s, Meeting right) {
  if (right == Meeting::crossing) return right;
  const int on = whole::on_segment(s.a, s.b, other.a) + whole::on_segment(s.a, s.b, other.b);
  return on == 0 ? Meeting::none : (on == 1 ? Meeting::touching : Meeting::overlapping);
}

/// With triangles that are thin for their sides taken for flat.
Meeting with_epsilon(const Segment& s, const Segment& t) {
  const auto side = [](const Segment& line, const Point& p) {
    const double twice = static_cast<double>(whole::area(line.a, line.b, p));
    const double size = (line.b - line.a).norm() * (p - line.a).norm();
    return std::abs(twice) <= 1e-9 * size ? 0 : (twice > 0 ? 1 : -1);
  };
  if (side(s, t.a) * side(s, t.b) < 0 && side(t, s.a) * side(t, s.b) < 0) return Meeting::crossing;
  whole::Points common;
  for (const Point& p : {t.a, t.b, s.a, s.b}) {
    const bool is_new = std::find(common.begin(), common.end(), p) == common.end();
    const auto on = [&](const Segment& line) {
      return side(line, p) == 0 && (p - line.a).dot(p - line.b) <= 0;
    };
    if (is_new && on(s) && on(t)) common.push_back(p);
  }
  return common.empty() ? Meeting::none
                        : (common.size() == 1 ? Meeting::touching : Meeting::overlapping);
}

/// Whether the ends of t are on different sides of the line of s.
bool on_both_sides(const Segment& s, const Segment& t) {
  return whole::orientation(s.a, s.b, t.a) * whole::orientation(s.a, s.b, t.b) < 0;
}

bool an_end_on_the_line(const Segment& s, const Segment& t) {
  return whole::area(s.a, s.b, t.a) == 0 || whole::area(s.a, s.b, t.b) == 0;
}

void check(const Segment& s, const Segment& t) {
  const Meeting right = truth(s, t);
  const bool points = is_point(s) || is_point(t);
  const bool one_line = !points && is_parallel(s, t) && on_one_line(s, t);
  ask("How do the segments meet?")
      .given("s", s)
      .given("t", t)
      .suspect_if("other-segment-not-asked",
                  [&](const Meeting& got) {
                    return right == Meeting::none && got == Meeting::crossing &&
                           (on_both_sides(s, t) || on_both_sides(t, s));
                  })
      .suspect_if("touching-called-crossing",
                  [&](const Meeting& got) {
                    return right == Meeting::touching && got == Meeting::crossing;
                  })
      .suspect_if("touching-missed",
                  [&](const Meeting& got) {
                    return right == Meeting::touching && got == Meeting::none && !points &&
                           !is_parallel(s, t) && by_ends_of(t, s, right) != Meeting::none;
                  })
      .suspect_if("end-on-the-line",
                  [&](const Meeting& got) {
                    return right == Meeting::none && got == Meeting::touching && !points &&
                           !is_parallel(s, t) &&
                           (an_end_on_the_line(s, t) || an_end_on_the_line(t, s));
                  })
      .suspect_if("collinear-called-overlapping",
                  [&](const Meeting& got) {
                    return right == Meeting::none && got == Meeting::overlapping && one_line;
                  })
      .suspect_if("parallel-never-meets",
                  [&](const Meeting& got) {
                    return right != Meeting::none && got == Meeting::none && one_line;
                  })
      .suspect_if("shared-end-overlaps",
                  [&](const Meeting& got) {
                    return right == Meeting::touching && got == Meeting::overlapping && one_line;
                  })
      .suspect("overlap-by-x-alone", [&] { return by_x(s, t, right); })
      .suspect("ends-of-one-segment", [&] { return by_ends_of(t, s, right); })
      .suspect_if("point-meets-nothing",
                  [&](const Meeting& got) {
                    return right == Meeting::touching && got == Meeting::none && points;
                  })
      .suspect("epsilon-orientation", [&] { return with_epsilon(s, t); })
      .answer([&] { return exercise::segments_meet(s, t); })
      .equals(right);
}

Segment reversed(const Segment& s) { return {s.b, s.a}; }

void check_all_orders(const Segment& s, const Segment& t) {
  check(s, t);
  check(t, s);
  check(reversed(s), t);
  check(t, reversed(s));
  check(reversed(s), reversed(t));
}

}  // namespace

TEST_CASE("segments that cross are told from segments that miss each other") {
  check_all_orders({{0, 0}, {8, 6}}, {{1, 5}, {6, 1}});
  check_all_orders({{-3, 2}, {9, 3}}, {{4, -5}, {3, 11}});
  // The line of one passes between the ends of the other, but beyond its own.
  check_all_orders({{0, 0}, {2, 1}}, {{6, 0}, {7, 9}});
  // Neither line does, and parallel ones.
  check_all_orders({{0, 0}, {2, 1}}, {{6, 0}, {9, 1}});
  check_all_orders({{0, 0}, {4, 2}}, {{1, 2}, {5, 4}});
}

TEST_CASE("an end on the other segment touches it") {
  check_all_orders({{0, 0}, {8, 0}}, {{3, 0}, {5, 7}});
  check_all_orders({{0, 0}, {8, 0}}, {{3, 1}, {5, 7}});
  check_all_orders({{0, 0}, {8, 4}}, {{6, 3}, {1, 9}});
  check_all_orders({{2, 1}, {5, 9}}, {{2, 1}, {-3, 2}});
}

TEST_CASE("an end on the line of the other segment need not touch it") {
  check_all_orders({{0, 0}, {4, 2}}, {{6, 3}, {5, 9}});
  check_all_orders({{0, 0}, {4, 0}}, {{-2, 0}, {1, 5}});
  check_all_orders({{0, 0}, {4, 0}}, {{2, 0}, {1, 5}});
}

TEST_CASE("segments on one line overlap, touch or miss each other") {
  // A gap, as in issue 3 of cl-geometry.
  check_all_orders({{0, 0}, {50, 50}}, {{51, 51}, {100, 100}});
  // Overlap on a falling line, as in pull request 309 of Meshes.jl.
  check_all_orders({{0, 0}, {2, -2}}, {{1, -1}, {3, -3}});
  check_all_orders({{0, 0}, {4, 2}}, {{4, 2}, {8, 4}});
  check_all_orders({{0, 0}, {9, 6}}, {{3, 2}, {6, 4}});
  check_all_orders({{0, 0}, {9, 6}}, {{0, 0}, {6, 4}});
  check_all_orders({{0, 0}, {9, 6}}, {{9, 6}, {0, 0}});
  check_all_orders({{3, 0}, {3, 5}}, {{3, 7}, {3, 9}});
  check_all_orders({{3, 0}, {3, 5}}, {{3, 4}, {3, 9}});
  check_all_orders({{3, 0}, {3, 5}}, {{3, 5}, {3, 9}});
}

TEST_CASE("a segment that is a point touches or misses the other") {
  check_all_orders({{3, 2}, {3, 2}}, {{0, 0}, {9, 6}});
  check_all_orders({{3, 3}, {3, 3}}, {{0, 0}, {9, 6}});
  check_all_orders({{12, 8}, {12, 8}}, {{0, 0}, {9, 6}});
  check_all_orders({{9, 6}, {9, 6}}, {{0, 0}, {9, 6}});
  check_all_orders({{4, 4}, {4, 4}}, {{4, 4}, {4, 4}});
  check_all_orders({{4, 4}, {4, 4}}, {{4, 5}, {4, 5}});
}

TEST_CASE("an end beside a long segment does not touch it") {
  constexpr double kFar = 0x1p25;
  const Segment far{{-kFar, -kFar}, {kFar, kFar - 1}};
  check_all_orders(far, {{0, 0}, {-9, 7}});
  check_all_orders(far, {{0, 0}, {0, -1}});
  check_all_orders(far, {{0, -1}, {5, -9}});
  check_all_orders({{-kFar, -kFar}, {kFar, kFar}}, {{0, 0}, {-9, 7}});
  // Parallel but for an area of one, and on one line.
  check_all_orders({{0, 0}, {kFar - 1, kFar - 2}}, {{0, 0}, {kFar, kFar - 1}});
  check_all_orders({{-kFar, -kFar}, {0, -1}}, {{0, 0}, {kFar, kFar - 1}});
}

TEST_CASE("random segments agree with whole-number arithmetic") {
  generators::Random random(seed(0));
  const auto judged = [](const Segment& s, const Segment& t) {
    return whole::all_whole({s.a, s.b, t.a, t.b});
  };
  for (int i = 0; i < 600; ++i) {
    const int size = i % 3 == 0 ? 1 << 25 : 1 + i % 4;
    const auto point = [&] {
      const double x = random.integer(-size, size);
      return Point{x, double(random.integer(-size, size))};
    };
    const Segment s{point(), point()}, t{point(), point()};
    shrinkable(check, judged, s, t);
  }
}
