#include <03_polygons/reference.hpp>
#include <catch2/catch_test_macros.hpp>
#include <limits>
#include <map>

namespace {

using namespace polygons;
using contact::SegmentCrossing;

template <class S>
Segment2<S> turned(const Segment2<S>& s) {
  return {s.b, s.a};
}

/// Two segments of a kind, related often enough.
template <class S>
std::pair<Segment2<S>, Segment2<S>> two_segments(Random& random, int kind) {
  const Segment2<S> s{point<S>(random, kind), point<S>(random, kind)};
  const Polygon<S> line{s.a, s.b};
  Segment2<S> t{point<S>(random, kind), point<S>(random, kind)};
  if (random.chance(0.4)) t.a = point_near<S>(random, kind, line);
  if (random.chance(0.3)) t.b = point_near<S>(random, kind, line);
  if (random.chance(0.05)) t.b = t.a;
  return {s, t};
}

template <class S>
Rational distance(const Vector2<S>& got, const Exact2& right) {
  const Exact2 difference = exact(got) - right;
  const Rational x = abs(difference.x()), y = abs(difference.y());
  return std::max(x, y);
}

/// The fraction of the segment at which p is; 0 if it is a point.
template <class S>
Rational fraction(const Segment2<S>& s, const Exact2& p) {
  const Exact2 along = exact(s.b) - exact(s.a);
  const Rational length = along.dot(along);
  return length == 0 ? Rational(0) : Rational(along.dot(p - exact(s.a)) / length);
}

template <class S>
S nearest_in(const Rational& x) {
  if constexpr (std::is_same_v<S, float>) {
    return oracle::nearest_float(x);
  } else {
    return oracle::nearest(x);
  }
}

template <class S>
void compare_segments(int count, std::uint64_t seed) {
  Random random(seed);
  std::map<Meeting, int> seen;
  for (int i = 0; i < generators::tried(count); ++i) {
    const int kind = i % kinds;
    const auto [s, t] = two_segments<S>(random, kind);
    const Common right = common(s, t);
    INFO("kind " << kind << ", case " << i);
    ++seen[right.meeting];
    REQUIRE(contact::meet(s, t) == right.meeting);
    REQUIRE(contact::meet(t, s) == right.meeting);
    REQUIRE(contact::meet(turned(s), t) == right.meeting);
    REQUIRE(contact::meet(t, turned(s)) == right.meeting);

    const SegmentCrossing<S> last = contact::crossing_to_last_place(s, t);
    const SegmentCrossing<S> book = contact::crossing(s, t);
    REQUIRE(last.meeting == right.meeting);
    REQUIRE(book.meeting == right.meeting);
    if (right.meeting == Meeting::none) continue;

    // To the last place: every number is the nearest of its type. A zero may have either sign.
    REQUIRE(last.point.x() == nearest_in<S>(right.first.x()));
    REQUIRE(last.point.y() == nearest_in<S>(right.first.y()));
    REQUIRE(last.along_first == nearest_in<S>(fraction(s, right.first)));
    REQUIRE(last.along_second == nearest_in<S>(fraction(t, right.first)));
    for (const SegmentCrossing<S>& got : {last, book}) {
      REQUIRE(distance(got.point, right.first) <= oracle::exact(got.point_bound));
      REQUIRE(abs(oracle::exact(got.along_first) - fraction(s, right.first)) <=
              oracle::exact(got.along_bound));
      REQUIRE(abs(oracle::exact(got.along_second) - fraction(t, right.first)) <=
              oracle::exact(got.along_bound));
      REQUIRE(got.along_first >= 0);
      REQUIRE(got.along_first <= 1);
      REQUIRE(got.overlap.a == got.point);
      if (right.meeting == Meeting::overlapping) {
        // The direction of a first segment that is a point cannot be said; it never overlaps.
        REQUIRE(exact(got.overlap.a) == right.first);
        REQUIRE(exact(got.overlap.b) == right.last);
      } else {
        REQUIRE(got.overlap.b == got.point);
      }
      if (right.meeting != Meeting::crossing) REQUIRE(got.point_bound == 0);
    }
    REQUIRE(book.along_bound <= (sizeof(S) == sizeof(double) ? 0x1p-40 : 0x1p-23));
  }
  for (const Meeting meeting :
       {Meeting::none, Meeting::crossing, Meeting::touching, Meeting::overlapping}) {
    CHECK(seen[meeting] > generators::tried(count) / 100);
  }
}

TEST_CASE("segments that are hard meet as they do in fractions, doubles and floats") {
  compare_segments<double>(70000, 11);
  compare_segments<float>(70000, 12);
}

TEST_CASE("every kind of meeting, by example") {
  const Segment2<double> s{{0, 0}, {4, 2}};
  const auto with = [&s](double ax, double ay, double bx, double by) {
    return contact::crossing(s, Segment2<double>{{ax, ay}, {bx, by}});
  };
  CHECK(with(0, 2, 4, 0).meeting == Meeting::crossing);
  CHECK(with(0, 2, 4, 0).point == Vector2<double>(2, 1));
  CHECK(with(2, 1, 3, 4).meeting == Meeting::touching);  // an end on the other's inside
  CHECK(with(4, 2, 3, 4).meeting == Meeting::touching);  // two ends
  CHECK(with(4, 2, 8, 4).meeting == Meeting::touching);  // collinear, one common end
  CHECK(with(6, 3, 8, 4).meeting == Meeting::none);      // collinear, a gap
  CHECK(with(0, 1, 4, 3).meeting == Meeting::none);      // parallel
  CHECK(with(8, 4, 2, 1).meeting == Meeting::overlapping);
  CHECK(with(8, 4, 2, 1).overlap.a == Vector2<double>(2, 1));
  CHECK(with(8, 4, 2, 1).overlap.b == Vector2<double>(4, 2));
  CHECK(with(8, 4, 2, 1).along_first == 0.5);
  CHECK(with(8, 4, 2, 1).along_second == 1);
  CHECK(with(2, 1, 2, 1).meeting == Meeting::touching);  // a point on it
  CHECK(with(2, 1, 2, 1).along_first == 0.5);
  CHECK(with(2, 1, 2, 1).along_second == 0);
  CHECK(with(2, 2, 2, 2).meeting == Meeting::none);
  const Segment2<double> point{{1, 1}, {1, 1}};
  CHECK(contact::meet(point, point) == Meeting::touching);
  CHECK(contact::meet(point, Segment2<double>{{1, 2}, {1, 2}}) == Meeting::none);
}

TEST_CASE("segments that are not finite meet nothing") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Segment2<double> s{{0, 0}, {1, 1}};
  for (const double bad : {nan, infinity, -infinity}) {
    const Segment2<double> t{{0, 1}, {bad, 0}};
    CHECK(contact::meet(s, t) == Meeting::none);
    CHECK(contact::meet(t, s) == Meeting::none);
    CHECK(contact::crossing(t, s).point == Vector2<double>(0, 0));
    if (std::isnan(bad)) CHECK_FALSE(contact::crossing_by_slopes(t, s).has_value());
  }
}

TEST_CASE("without rounding, the textbook methods are right where they answer") {
  Random random(13);
  int answers = 0;
  for (int i = 0; i < generators::tried(20000); ++i) {
    const auto [s, t] = two_segments<double>(random, i % 3);
    const Segment2<Rational> es{exact(s.a), exact(s.b)}, et{exact(t.a), exact(t.b)};
    const Common right = common(s, t);
    const auto got = contact::crossing_by_parameters<Rational>(es, et);
    const bool point = s.a == s.b || t.a == t.b;
    const bool parallel = cross(es.b - es.a, et.b - et.a) == 0;
    if (parallel || point) {
      REQUIRE_FALSE(got.has_value());
      continue;
    }
    REQUIRE(got.has_value() == (right.meeting != Meeting::none));
    if (!got) continue;
    ++answers;
    REQUIRE(got->meeting == right.meeting);
    REQUIRE(got->point == right.first);
    REQUIRE(contact::meet_rounded<Rational>(es, et) == right.meeting);
  }
  CHECK(answers > generators::tried(5000));
}

}  // namespace
