// Whether edges meet is decided in integers. Every test asks for several answers.
#include "edge_edge.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>
#include <support/shrinkable.hpp>

#include <06_triangle_pairs/whole_edges.hpp>

namespace {

using namespace contact::testing;
using exercise::EdgeContact;
using whole_edges::across;
using whole_edges::along;
using whole_edges::in_double;
using whole_edges::Integers;
using whole_edges::Point;
using whole_edges::Segment;
using Found = std::optional<EdgeContact>;

constexpr double kTolerance = 1e-9;
constexpr double kLimit = 1000;

double length(const Integers& v) { return in_double(v).norm(); }

/// The distance of the lines, and the same in multiples of the lengths: 0 for parallel edges.
double distance(const Segment& a, const Segment& b) {
  if (whole_edges::is_parallel(a, b)) return 0;
  return std::abs(double(whole_edges::volume(a, b))) / length(across(a, b));
}
double relative_volume(const Segment& a, const Segment& b) {
  const double size = length(along(a)) * length(along(b)) * (b.start - a.start).norm();
  return size > 0 ? std::abs(double(whole_edges::volume(a, b))) / size : 0;
}

double volume_in_float(const Segment& a, const Segment& b) {
  const auto vector = [](const Point& p, const Point& q) {
    return Eigen::Vector3f((p - q).cast<float>());
  };
  const Eigen::Vector3f n = vector(a.end, a.start).cross(vector(b.end, b.start));
  return double(n.dot(vector(b.start, a.start)));
}

void check_plane(const Segment& a, const Segment& b) {
  const bool right = whole_edges::volume(a, b) == 0;
  const Point n = in_double(across(a, b));
  ask("Are the edges in one plane?")
      .given("a", a)
      .given("b", b)
      .suspect("absolute-epsilon", [&] { return distance(a, b) < 1e-6; })
      .suspect("absolute-epsilon", [&] { return relative_volume(a, b) < 1e-9; })
      .suspect("edges-in-float", [&] { return volume_in_float(a, b) == 0; })
      .suspect("volume-from-the-origin", [&] { return n.dot(a.start) == 0; })
      .suspect("volume-from-the-origin", [&] { return n.dot(b.start) == 0; })
      .answer([&] { return exercise::in_one_plane(a, b); })
      .equals(right);
}

/// How edges meet as seen along an axis: -1 if they do not.
int seen_along(int axis, const Segment& a, const Segment& b) {
  const auto flat = [axis](Segment edge) {
    edge.start[axis] = edge.end[axis] = 0;
    return edge;
  };
  return whole_edges::meeting(flat(a), flat(b));
}
bool is_parallel_seen_along(int axis, const Segment& a, const Segment& b) {
  return across(a, b).at[static_cast<std::size_t>(axis)] == 0;
}

/// Whether the ranges of two edges overlap along a vector.
bool overlap_along(const Point& axis, const Segment& a, const Segment& b) {
  const auto [a_low, a_high] = std::minmax({axis.dot(a.start), axis.dot(a.end)});
  const auto [b_low, b_high] = std::minmax({axis.dot(b.start), axis.dot(b.end)});
  return std::max(a_low, b_low) <= std::min(a_high, b_high);
}

/// Whether two points computed from the two edges are the same double.
bool points_are_equal(const Segment& a, const Segment& b) {
  const Point n = in_double(across(a, b)), w = b.start - a.start;
  const Point u = in_double(along(a)), v = in_double(along(b));
  const double of_a = w.cross(v).dot(n) / n.dot(n), of_b = w.cross(u).dot(n) / n.dot(n);
  if (std::min(of_a, of_b) < 0 || std::max(of_a, of_b) > 1) return false;
  return a.start + of_a * u == b.start + of_b * v;
}

/// Nearly parallel edges are taken for parallel ones.
bool with_tolerance_of_angle(const Segment& a, const Segment& b, bool right) {
  if (whole_edges::is_parallel(a, b)) return right;
  const double sine = length(across(a, b)) / (length(along(a)) * length(along(b)));
  if (sine > 1e-6) return right;
  const Point w = b.start - a.start;
  return in_double(along(a)).cross(w).isZero(0) && overlap_along(in_double(along(a)), a, b);
}

using Decisions = std::vector<Suspect<bool>>;

Decisions decisions_about_lines(const Segment& a, const Segment& b, bool right) {
  const bool parallel = whole_edges::is_parallel(a, b);
  const bool plane = whole_edges::volume(a, b) == 0;
  const auto crossing = [=](auto decide) {
    return [=] { return parallel || !plane ? right : decide(); };
  };
  const Integers n = across(a, b);
  Decisions all;
  all.emplace_back("lines-for-edges", crossing([] { return true; }));
  all.emplace_back("one-edge-as-a-line",
                   crossing([=] { return whole_edges::crosses_line(a, b, n) >= 0; }));
  all.emplace_back("one-edge-as-a-line",
                   crossing([=] { return whole_edges::crosses_line(b, a, n) >= 0; }));
  all.emplace_back("touching-rejected", [=] { return whole_edges::meeting(a, b) > 0; });
  all.emplace_back("touching-rejected", crossing([=] { return whole_edges::meeting(a, b) > 0; }));
  for (int axis = 0; axis < 3; ++axis) {
    all.emplace_back("skew-edges-seen-along-an-axis", [=] {
      return is_parallel_seen_along(axis, a, b) ? right : seen_along(axis, a, b) >= 0;
    });
    all.emplace_back("plane-seen-edge-on",
                     [=] { return right && (parallel || !is_parallel_seen_along(axis, a, b)); });
  }
  return all;
}

void check_meeting(const Segment& a, const Segment& b) {
  const bool right = whole_edges::meeting(a, b) >= 0;
  const bool parallel = whole_edges::is_parallel(a, b);
  const bool one_line = parallel && whole_edges::on_one_line(a, b);
  const bool plane = whole_edges::volume(a, b) == 0;
  const auto ends_of = [&](const Segment& one, const Segment& other) {
    if (!one_line) return right;
    return std::max(whole_edges::on_edge(other, one.start), whole_edges::on_edge(other, one.end)) >=
           0;
  };
  const Point u = in_double(along(a));
  ask("Do the edges meet?")
      .given("a", a)
      .given("b", b)
      .suspects(decisions_about_lines(a, b, right))
      .suspect("parallel-never-meets", [&] { return right && !parallel; })
      .suspect("collinear-called-overlapping", [&] { return one_line || right; })
      .suspect("parallel-for-collinear", [&] { return parallel ? overlap_along(u, a, b) : right; })
      .suspect("overlap-by-x-alone",
               [&] {
                 return one_line ? overlap_along({1, 0, 0}, a, b) : right;
               })
      .suspect("ends-of-one-edge", [&] { return ends_of(a, b); })
      .suspect("ends-of-one-edge", [&] { return ends_of(b, a); })
      .suspect("rounded-points-compared", [&] { return parallel ? right : points_are_equal(a, b); })
      .suspect("absolute-epsilon", [&] { return with_tolerance_of_angle(a, b, right); })
      .suspect("absolute-epsilon",
               [&] {
                 if (plane || parallel || distance(a, b) > 1e-6) return right;
                 const Integers n = across(a, b);
                 return std::min(whole_edges::crosses_line(a, b, n),
                                 whole_edges::crosses_line(b, a, n)) >= 0;
               })
      .answer([&] { return exercise::edges_meet(a, b); })
      .equals(right);
}

Point mean(const Segment& edge) { return (edge.start + edge.end) / 2; }

void check_contact(const Segment& a, const Segment& b, const Point& inside_b) {
  const int meeting = whole_edges::meeting(a, b);
  const bool parallel = whole_edges::is_parallel(a, b);
  const Point n = in_double(across(a, b)), position = whole_edges::position(a, b);
  const bool is_outward = n.dot(a.start - inside_b) > 0;
  const Point outward = is_outward ? Point(n.normalized()) : Point(-n.normalized());
  // Where the edges meet, another position or another normal.
  const auto only_if_meeting = [&](const Point& at, const Point& normal) {
    return meeting < 0 || parallel ? Found{} : Found{{at, normal}};
  };
  const auto at = [&](const Point& other) { return only_if_meeting(other, outward); };
  const auto with_normal = [&](const Point& other) { return only_if_meeting(position, other); };
  const Found right = at(position);
  ask("Where do the edges touch, and with which normal?")
      .given("a", a)
      .given("b", b)
      .given("inside_b", inside_b)
      .suspect("normal-by-order-of-edges", [&] { return with_normal(n.normalized()); })
      .suspect("edge-normal-from-a-to-b", [&] { return with_normal(-outward); })
      .suspect("inside-taken-for-direction",
               [&] { return with_normal(n.dot(inside_b) < 0 ? n.normalized() : -n.normalized()); })
      .suspect("normal-from-the-inside",
               [&] { return with_normal((position - inside_b).normalized()); })
      .suspect("share-of-the-other-edge",
               [&] { return at(a.start + whole_edges::share_of(b, a) * in_double(along(a))); })
      .suspect("share-of-the-other-edge",
               [&] { return at(b.start + whole_edges::share_of(a, b) * in_double(along(b))); })
      .suspect("middle-for-the-crossing", [&] { return at(mean(a)); })
      .suspect("middle-for-the-crossing", [&] { return at(mean(b)); })
      .suspect("middle-for-the-crossing", [&] { return at((mean(a) + mean(b)) / 2); })
      .suspect("touching-rejected", [&] { return meeting == 0 ? Found{} : right; })
      .suspect_if("normal-not-unit",
                  [&](const Found& got) {
                    if (!got || !right) return false;
                    const Point &p = got->position, &m = got->normal;
                    return (p - right->position).cwiseAbs().maxCoeff() <= kTolerance &&
                           m.dot(outward) > 0 && m.cross(outward).norm() <= 1e-9 * m.norm() &&
                           std::abs(m.norm() - 1) > 1e-9;
                  })
      .suspect_if("parallel-edges-given-a-normal",
                  [&](const Found& got) {
                    return got && parallel && meeting >= 0 && got->normal.allFinite();
                  })
      .suspect_if("contact-without-a-meeting",
                  [&](const Found& got) {
                    return got && meeting < 0 && got->position.allFinite() &&
                           got->normal.allFinite();
                  })
      .suspect_if("division-by-zero",
                  [](const Found& got) {
                    return got && !(got->position.allFinite() && got->normal.allFinite());
                  })
      .answer([&] { return exercise::edge_contact(a, b, inside_b); })
      .close_to(right, within(kTolerance));
}

/// Asks with the edges in both orders and each of them in both directions.
template <class Check>
void in_every_order(const Check& check, const Segment& a, const Segment& b) {
  for (const Segment& one : {a, whole_edges::reversed(a)}) {
    for (const Segment& other : {b, whole_edges::reversed(b)}) {
      check(one, other);
      check(other, one);
    }
  }
}

/// Both bodies, the one as well as the other as B, on either side.
void check_contact_in_every_order(const Segment& a, const Segment& b, const Point& inside_b) {
  const Point opposite = a.start + b.start - inside_b;
  in_every_order(
      [&](const Segment& one, const Segment& other) {
        check_contact(one, other, inside_b);
        check_contact(one, other, opposite);
      },
      a, b);
}

/// Two edges that cross at different shares, in an oblique plane.
const Segment kLong{{1, 2, 3}, {9, 10, 19}};
const Segment kShort{{4, 1, 8}, {1, 10, 5}};

}  // namespace

TEST_CASE("edges are in one plane if their ends span no volume") {
  check_plane({{0, 0, 1}, {4, 0, 1}}, {{2, -3, 1}, {2, 5, 1}});
  check_plane({{0, 0, 1}, {4, 0, 1}}, {{2, -3, 2}, {2, 5, 2}});
  in_every_order(check_plane, kLong, kShort);
  in_every_order(check_plane, kLong, {{4, 1, 9}, {1, 10, 7}});
  // The planes through the origin and one edge contain the direction of the other.
  check_plane({{0, 0, 0}, {3, 1, 2}}, {{5, 1, 1}, {6, 4, 2}});
  check_plane({{5, 1, 1}, {6, 4, 2}}, {{0, 0, 0}, {3, 1, 2}});
  check_plane({{1, 1, 1}, {3, 4, 5}}, {{7, 1, 2}, {11, 7, 10}});
}

TEST_CASE("edges meet, not only their lines") {
  in_every_order(check_meeting, {{0, 0, 0}, {8, 0, 4}}, {{4, -2, 2}, {4, 2, 2}});
  in_every_order(check_meeting, {{0, 0, 0}, {8, 0, 4}}, {{10, 1, 5}, {10, 5, 5}});
  in_every_order(check_meeting, {{0, 0, 0}, {8, 0, 4}}, {{4, 1, 2}, {4, 5, 2}});
  // One over the other.
  in_every_order(check_meeting, {{0, 0, 0}, {8, 0, 0}}, {{4, -2, 2}, {4, 2, 2}});
  in_every_order(check_meeting, {{0, 0, 1}, {4, 4, 5}}, {{0, 4, 3}, {4, 0, 4}});
}

TEST_CASE("edges meet in a plane parallel to an axis") {
  // Seen along z, x and y, one line.
  in_every_order(check_meeting, {{1, 2, 0}, {5, 6, 8}}, {{1, 2, 8}, {5, 6, 0}});
  in_every_order(check_meeting, {{0, 1, 2}, {8, 5, 6}}, {{8, 1, 2}, {0, 5, 6}});
  in_every_order(check_meeting, {{2, 0, 1}, {6, 8, 5}}, {{2, 8, 1}, {6, 0, 5}});
  in_every_order(check_meeting, {{2, 0, 1}, {6, 8, 5}}, {{2, 8, 1}, {3, 6, 2}});
}

TEST_CASE("an end on the other edge touches it") {
  in_every_order(check_meeting, {{0, 0, 0}, {8, 0, 4}}, {{4, 0, 2}, {4, 5, 7}});
  in_every_order(check_meeting, {{0, 0, 0}, {8, 0, 4}}, {{8, 0, 4}, {4, 5, 7}});
  in_every_order(check_meeting, {{0, 0, 0}, {1, 0, 0}}, {{1, 1, 0}, {1, 0, 0}});
  in_every_order(check_meeting, kLong, {{3, 4, 7}, {3, 9, 2}});
  in_every_order(check_meeting, kLong, {{9, 10, 18}, {3, 9, 2}});
}

TEST_CASE("parallel edges meet if they are on one line and touch or overlap") {
  const Segment edge{{1, 2, 3}, {5, 8, 5}};
  in_every_order(check_meeting, edge, {{3, 5, 4}, {9, 14, 7}});
  in_every_order(check_meeting, edge, {{7, 11, 6}, {9, 14, 7}});
  in_every_order(check_meeting, edge, {{1, 2, 4}, {5, 8, 6}});
  in_every_order(check_meeting, {{2, 0, 0}, {2, 0, 4}}, {{2, 0, 6}, {2, 0, 9}});
  in_every_order(check_meeting, edge, {{-1, -1, 2}, {7, 11, 6}});
  in_every_order(check_meeting, edge, {{5, 8, 5}, {7, 11, 6}});
  in_every_order(check_meeting, edge, edge);
  in_every_order(check_meeting, {{0, 0, 0}, {1, 0, 0}}, {{0, 1, 0}, {1, 1, 0}});
  in_every_order(check_meeting, {{0, 0, 0}, {3, 0, 0}}, {{5, 0, 0}, {7, 0, 0}});
  in_every_order(check_meeting, {{0, 0, 0}, {0, 3, 0}}, {{0, 4, 0}, {0, 7, 0}});
}

TEST_CASE("a small distance is not zero") {
  check_plane({{753, 925, 936}, {-247, -908, -536}}, {{-718, -763, -544}, {538, -182, 135}});
  check_plane({{899, -581, 409}, {-913, 734, -820}}, {{-357, -991, -266}, {725, 606, 149}});
  check_meeting({{788, -512, -816}, {-957, 957, 524}}, {{571, 537, -915}, {-478, 101, 295}});
  check_meeting({{528, -980, -943}, {781, 975, 629}}, {{-237, -360, -884}, {839, -92, -127}});
  // A small angle is not zero, either.
  check_meeting({{-823, -3, -534}, {943, 898, 331}}, {{-774, 22, -510}, {894, 873, 307}});
  check_meeting({{-3, -534, -823}, {898, 331, 943}}, {{22, -510, -774}, {873, 307, 894}});
}

TEST_CASE("the points of two edges are not compared as doubles") {
  in_every_order(check_meeting, {{0, 0, 0}, {7, 3, 1}}, {{5, 0, 0}, {1, 3, 1}});
  in_every_order(check_meeting, {{1, 2, 3}, {12, 5, 9}}, {{3, 6, 5}, {9, 0, 7}});
  in_every_order(check_meeting, {{-3, 1, 2}, {10, 8, 4}}, {{1, 8, 3}, {5, -1, 3}});
}

TEST_CASE("two edges touch in a point, with a normal from B to A") {
  // A above B, and then exchanged.
  check_contact({{0, 0, 0}, {8, 0, 0}}, {{2, -1, 0}, {2, 7, 0}}, {9, 3, -5});
  check_contact({{2, -1, 0}, {2, 7, 0}}, {{0, 0, 0}, {8, 0, 0}}, {9, 3, -5});
  check_contact({{2, -1, 6}, {2, 7, 6}}, {{0, 0, 6}, {8, 0, 6}}, {9, 3, 2});
  check_contact_in_every_order(kLong, kShort, {5, 5, 0});
  check_contact_in_every_order({{0, 0, 0}, {1, 0, 0}}, {{1, 1, 0}, {1, 0, 0}}, {2, 3, -1});
  check_contact_in_every_order({{0, 0, 0}, {7, 3, 1}}, {{5, 0, 0}, {1, 3, 1}}, {2, 2, 5});
  check_contact_in_every_order({{0, 0, 0}, {8, 0, 4}}, {{4, 0, 2}, {4, 5, 7}}, {3, 1, -1});
}

TEST_CASE("edges that are parallel or apart have no contact") {
  const Point inside(2, 1, -4);
  const auto check = [&](const Segment& a, const Segment& b) { check_contact(a, b, inside); };
  check({{0, 0, 0}, {8, 0, 0}}, {{4, -2, 0}, {4, 2, 0}});
  in_every_order(check, {{1, 2, 3}, {5, 8, 5}}, {{3, 5, 4}, {9, 14, 7}});
  in_every_order(check, {{1, 2, 3}, {5, 8, 5}}, {{5, 8, 5}, {7, 11, 6}});
  in_every_order(check, {{1, 2, 3}, {5, 8, 5}}, {{1, 2, 4}, {5, 8, 6}});
  in_every_order(check, {{0, 0, 0}, {8, 0, 0}}, {{4, -2, 2}, {4, 2, 2}});
  in_every_order(check, {{0, 0, 0}, {8, 0, 4}}, {{4, 1, 2}, {4, 5, 2}});
}

TEST_CASE("random edges agree with integers") {
  generators::Random random(seed(0));
  const auto judged = [](const Segment& a, const Segment& b, const Point& inside) {
    if (!whole_edges::is_whole(a, kLimit) || !whole_edges::is_whole(b, kLimit)) return false;
    const Integers from_inside = whole_edges::difference(a.start, inside);
    const bool is_off = whole_edges::dot(across(a, b), from_inside) != 0;
    return whole_edges::is_whole(inside, kLimit) &&
           (whole_edges::meeting(a, b) < 0 || is_off || whole_edges::is_parallel(a, b));
  };
  const auto check = [](const Segment& a, const Segment& b, const Point& inside) {
    check_plane(a, b);
    check_meeting(a, b);
    check_contact(a, b, inside);
  };
  for (int asked = 0; asked < 2000;) {
    const int size = asked % 5 == 4 ? 150 : 9;
    const auto number = [&](int limit) { return double(random.integer(-limit, limit)); };
    const auto vector = [&](int limit) {
      const double x = number(limit);
      const double y = number(limit);
      return Point(x, y, number(limit));
    };
    // In a plane, on a line, or anywhere.
    const Point origin = vector(size), u = vector(size), v = vector(size);
    const int kind = random.integer(0, 3);
    const auto end = [&]() -> Point {
      const double x = number(2);
      const double y = number(2);
      if (kind == 0) return origin + x * u;
      if (kind == 1) return vector(3);
      return origin + x * u + y * v;
    };
    const Point a = end(), b = end(), c = end(), d = end();
    const Point inside = vector(size);
    if (!judged({a, b}, {c, d}, inside)) continue;
    ++asked;
    shrinkable(check, judged, Segment{a, b}, Segment{c, d}, inside);
  }
}
