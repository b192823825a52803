// All coordinates are whole numbers up to 1000, so which segments are met, and in which order, is
// decided in integers. Every test expects an entry somewhere.
#include "perimeter_normal.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>
#include <support/shrinkable.hpp>

#include <03_polygons/whole.hpp>

namespace {

using namespace contact::testing;
using exercise::Entry;
using whole::Point;
using whole::Points;
using Found = std::optional<Entry>;

/// A fraction with a positive denominator.
struct Fraction {
  std::int64_t over = 0, under = 1;

  friend bool operator<(const Fraction& x, const Fraction& y) {
    return x.over * y.under < y.over * x.under;
  }
  double value() const { return double(over) / double(under); }
};

/// Where the line of the path crosses that of segment i: t and the position along the segment.
/// Nothing if they are parallel.
struct OnLines {
  Fraction t, along;
};
std::optional<OnLines> on_lines(const Points& perimeter, std::size_t i, const Point& from,
                                const Point& to) {
  const Point a = perimeter[i];
  const whole::Vector d = whole::difference(to, from), w = whole::difference(a, from);
  const whole::Vector e = whole::difference(whole::after(perimeter, i), a);
  const std::int64_t under = whole::cross(d, e), sign = under < 0 ? -1 : 1;
  if (under == 0) return std::nullopt;
  return OnLines{{sign * whole::cross(w, e), sign * under},
                 {sign * whole::cross(w, d), sign * under}};
}

bool from_0_to_1(const Fraction& x) { return x.over >= 0 && x.over <= x.under; }

Point outward(const Points& perimeter, std::size_t i) {
  const Point edge = whole::after(perimeter, i) - perimeter[i];
  return Point(edge.y(), -edge.x()).normalized();
}

/// Every segment that the path meets, in the order of the list.
std::vector<std::size_t> met(const Points& perimeter, const Point& from, const Point& to) {
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < perimeter.size(); ++i) {
    const auto lines = on_lines(perimeter, i, from, to);
    if (lines && from_0_to_1(lines->t) && from_0_to_1(lines->along)) all.push_back(i);
  }
  return all;
}

Found first_met(const Points& perimeter, const Point& from, const Point& to, std::size_t segments) {
  std::optional<Fraction> least;
  Found first;
  for (const std::size_t i : met(perimeter, from, to)) {
    const Fraction t = on_lines(perimeter, i, from, to)->t;
    if (i >= segments || (least && !(t < *least))) continue;
    least = t;
    first = Entry{static_cast<int>(i), t.value(), outward(perimeter, i)};
  }
  return first;
}

double distance_to(const Points& perimeter, std::size_t i, const Point& p) {
  const Point a = perimeter[i], edge = whole::after(perimeter, i) - a;
  const double along = std::clamp((p - a).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
  return (p - a - along * edge).norm();
}

/// Whether no other segment is as near to p.
bool is_nearest(const Points& perimeter, std::size_t i, const Point& p) {
  for (std::size_t j = 0; j < perimeter.size(); ++j) {
    if (j != i && distance_to(perimeter, j, p) <= distance_to(perimeter, i, p)) return false;
  }
  return true;
}

bool near(double x, double y) { return std::abs(x - y) <= 1e-9 * std::max(1.0, std::abs(y)); }
bool near(const Point& x, const Point& y) { return near(x.x(), y.x()) && near(x.y(), y.y()); }

struct Case {
  const Points& perimeter;
  const Point& from;
  const Point& to;
  const Found& right;

  bool valid(const Found& got) const {
    return got && got->segment >= 0 && got->segment < static_cast<int>(perimeter.size());
  }
  std::size_t at(const Found& got) const { return static_cast<std::size_t>(got->segment); }
  /// Right but for the normal.
  bool right_segment(const Found& got) const {
    return got && right && got->segment == right->segment && near(got->t, right->t);
  }
};

bool not_the_first(const Case& c, const Found& got) {
  if (!c.valid(got) || !c.right || got->segment == c.right->segment) return false;
  const auto all = met(c.perimeter, c.from, c.to);
  return std::find(all.begin(), all.end(), c.at(got)) != all.end();
}

bool line_alone(const Case& c, const Found& got) {
  if (!c.valid(got)) return false;
  const auto lines = on_lines(c.perimeter, c.at(got), c.from, c.to);
  return lines && from_0_to_1(lines->t) && !from_0_to_1(lines->along);
}

bool nearer_end(const Case& c, const Found& got) {
  const Point d = c.to - c.from;
  if (!c.right_segment(got) || !near(got->normal.norm(), 1) || !near(got->normal.dot(d), 0.0))
    return false;
  const Point hit = c.from + c.right->t * d, a = c.perimeter[c.at(got)],
              b = whole::after(c.perimeter, c.at(got));
  return std::min((hit - a).norm(), (hit - b).norm()) <
         std::min((hit - c.from).norm(), (hit - c.to).norm());
}

void check(const Points& perimeter, const Point& from, const Point& to) {
  const Found right = first_met(perimeter, from, to, perimeter.size());
  const Case c{perimeter, from, to, right};
  const double length = (to - from).norm();
  ask("Where does the vertex meet the perimeter first?")
      .given("perimeter", perimeter)
      .given("from", from)
      .given("to", to)
      .suspect("last-edge-forgotten",
               [&] { return first_met(perimeter, from, to, perimeter.size() - 1); })
      .suspect_if("not-the-first-crossed",
                  [&](const Found& got) {
                    const Found forgotten = first_met(perimeter, from, to, perimeter.size() - 1);
                    return not_the_first(c, got) &&
                           !(forgotten && forgotten->segment == got->segment);
                  })
      .suspect_if("nearest-segment-at-the-end",
                  [&](const Found& got) {
                    return c.valid(got) && right && got->segment != right->segment &&
                           !not_the_first(c, got) && !line_alone(c, got) &&
                           is_nearest(perimeter, c.at(got), to);
                  })
      .suspect_if("line-for-segment", [&](const Found& got) { return line_alone(c, got); })
      .suspect_if("normal-inwards",
                  [&](const Found& got) {
                    return c.right_segment(got) && near(got->normal, -right->normal);
                  })
      .suspect_if("normal-not-unit",
                  [&](const Found& got) {
                    return c.right_segment(got) && got->normal.norm() > 0 &&
                           !near(got->normal.norm(), 1) &&
                           near(got->normal.normalized(), right->normal);
                  })
      .suspect_if("movement-for-normal",
                  [&](const Found& got) {
                    return c.right_segment(got) && near(got->normal, Point((from - to) / length)) &&
                           !near(got->normal, right->normal);
                  })
      .suspect_if("nearer-end-decides", [&](const Found& got) { return nearer_end(c, got); })
      .suspect_if("t-in-metres",
                  [&](const Found& got) {
                    return got && right && got->segment == right->segment &&
                           near(got->t, right->t * length) && !near(got->t, right->t);
                  })
      .suspect_if(
          "path-as-a-line",
          [&](const Found& got) { return c.valid(got) && !right && !(got->t >= 0 && got->t <= 1); })
      .suspect_if("touching-rejected",
                  [&](const Found& got) { return !got && right && right->t == 1; })
      .answer([&] { return exercise::perimeter_normal(perimeter, from, to); })
      .close_to(right, within(1e-11));
}

/// Also with every other vertex as the first.
void check_all_orders(Points perimeter, const Point& from, const Point& to) {
  for (std::size_t i = 0; i < perimeter.size(); ++i) {
    check(perimeter, from, to);
    std::rotate(perimeter.begin(), perimeter.begin() + 1, perimeter.end());
  }
}

const Points kBox{{0, 0}, {16, 0}, {16, 8}, {0, 8}};
/// Open at the top: three faces look into the notch.
const Points kCup{{0, 0}, {24, 0}, {24, 16}, {16, 16}, {16, 8}, {8, 8}, {8, 16}, {0, 16}};

/// Whether the path is long, passes through no vertex and meets no segment at a small angle, and no
/// two at nearly the same t: then a right program makes an error of less than 1e-12, whatever it
/// divides by.
bool is_clear(const Points& perimeter, const Point& from, const Point& to) {
  const Point d = to - from;
  if (d.norm() < 50) return false;
  const auto on_the_path = [&](const Point& v) { return whole::on_segment(from, to, v); };
  if (std::any_of(perimeter.begin(), perimeter.end(), on_the_path)) return false;
  std::vector<double> all;
  for (const std::size_t i : met(perimeter, from, to)) {
    if (std::abs(outward(perimeter, i).dot(d)) < 0.02 * d.norm()) return false;
    all.push_back(on_lines(perimeter, i, from, to)->t.value());
  }
  std::sort(all.begin(), all.end());
  const auto close = [](double t, double next) { return next - t < 1e-6; };
  return std::adjacent_find(all.begin(), all.end(), close) == all.end();
}

/// Whether the perimeter is as the contract says: counter-clockwise, and no two segments meet but
/// neighbours in their common vertex.
bool is_simple(const Points& perimeter) {
  const std::size_t n = perimeter.size();
  std::int64_t twice = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Point a = perimeter[i], b = whole::after(perimeter, i);
    twice += whole::area({0, 0}, a, b);
    for (std::size_t j = 0; j < n; ++j) {
      const Point p = perimeter[j];
      if (p != a && p != b && whole::on_segment(a, b, p)) return false;
      if (j != i && (p == a || (p == b && j != (i + 1) % n))) return false;
      const Point q = whole::after(perimeter, j);
      if (whole::orientation(a, b, p) * whole::orientation(a, b, q) < 0 &&
          whole::orientation(p, q, a) * whole::orientation(p, q, b) < 0)
        return false;
    }
  }
  return n >= 3 && twice > 0;
}

}  // namespace

TEST_CASE("a fast vertex comes in where it came from") {
  // At the end, the vertex is nearer to another segment than to the one through which it came.
  check_all_orders(kBox, {6, -3}, {8, 7});
  check_all_orders(kBox, {5, -1}, {7, 4});
  check_all_orders(kBox, {6, -3}, {14, 5});
  check_all_orders(kBox, {18, 5}, {1, 3});
  check_all_orders(kCup, {12, 10}, {11, 1});
}

TEST_CASE("of several segments on the path the first one counts") {
  check(kBox, {9, 11}, {6, -5});
  check(kBox, {6, -5}, {9, 11});
  // The line of the left segment is crossed below the box.
  check_all_orders(kBox, {-2, -3}, {4, 1});
  check_all_orders(kCup, {-3, 11}, {29, 13});
  check_all_orders(kBox, {9, 11}, {6, -5});
  check_all_orders(kBox, {6, -5}, {9, 11});
  check_all_orders(kBox, {-2, 3}, {20, 5});
  check_all_orders(kBox, {18, 5}, {-2, 3});
  check_all_orders(kCup, {12, 10}, {13, -2});
  check_all_orders(kCup, {13, 14}, {21, 9});
  check_all_orders({{-3, -2}, {5, -4}, {1, 6}}, {-3, 1}, {3, -5});
}

TEST_CASE("near the end of a segment the normal is still that of the segment") {
  check_all_orders(kBox, {-4, -9}, {4, 3});
  check_all_orders(kBox, {20, -9}, {12, 3});
  check_all_orders(kBox, {-4, 17}, {4, 5});
  check_all_orders({{0, 0}, {30, 10}, {20, 40}}, {-20, 3}, {20, 13});
}

TEST_CASE("a path that ends too early or leads away meets nothing") {
  check_all_orders(kBox, {6, -8}, {7, -4});
  check_all_orders(kBox, {6, -4}, {5, -12});
  check_all_orders(kBox, {-5, -5}, {-5, 20});
  check_all_orders(kBox, {-5, 12}, {30, 12});
  check_all_orders(kBox, {-5, 4}, {-5, 4});
  check_all_orders(kCup, {12, 12}, {13, 14});
  // The end of the movement is on the perimeter.
  check_all_orders(kBox, {6, -8}, {8, 0});
  check_all_orders(kBox, {20, 1}, {16, 3});
  check_all_orders(kCup, {12, 12}, {16, 11});
}

TEST_CASE("random paths agree with exact arithmetic") {
  generators::Random random(seed(0));
  const auto judged = [](const Points& perimeter, const Point& from, const Point& to) {
    if (!whole::all_whole(perimeter, 1000) || !whole::all_whole({from, to}, 1000)) return false;
    return is_simple(perimeter) && !whole::on_boundary(perimeter, from) &&
           whole::winding_number(perimeter, from) == 0 &&
           // Meeting it at the very end is another test's: a division may be rounded beyond 1.
           !whole::on_boundary(perimeter, to) && is_clear(perimeter, from, to);
  };
  for (int asked = 0; asked < 300;) {
    const auto point = [&](int size) {
      const double x = random.integer(-size, size);
      return Point{x, double(random.integer(-size, size))};
    };
    // A star round the origin, convex or not.
    Points perimeter;
    const int corners = random.integer(3, 9);
    for (int i = 0; i < corners; ++i) {
      const double angle = 6.283185307179586 * (i + random.uniform(0, 0.8)) / corners;
      const double radius = random.uniform(60, 600);
      perimeter.push_back(
          Point(std::round(radius * std::cos(angle)), std::round(radius * std::sin(angle))));
    }
    const Point from = point(1000), to = asked % 4 == 0 ? point(1000) : point(300);
    if (!judged(perimeter, from, to)) continue;
    ++asked;
    shrinkable(check, judged, perimeter, from, to);
  }
}
