// What is right is decided by exact numbers, for the boxes as they are given: also where an angle
// is not quite a right one, all fifteen directions together decide.
#include "axis_epsilon.hpp"
#include "boxes_meet.hpp"

#include <optional>

#include <support/break_it.hpp>

#include <contact/exact.hpp>
#include <contact/vector.hpp>

namespace {

using namespace contact::testing;
using contact::Exact;
using exercise::Pair;
using Point = Eigen::Vector3d;
using ExactVector = contact::Vector3<Exact>;

constexpr double kGap = 0.001, kRounding = 1e-9;

given::Edges edges_of_a(const Pair& pair) { return given::edges_of_a(pair); }
given::Edges edges_of_b(const Pair& pair) { return given::edges_of_b(pair); }
std::array<Point, 6> edges(const Pair& pair) {
  return {pair.u_a, pair.v_a, pair.w_a, pair.u_b, pair.v_b, pair.w_b};
}

ExactVector exact(const Point& v) { return {Exact(v.x()), Exact(v.y()), Exact(v.z())}; }

// Exact numbers first.

/// A direction of the fifteen, and the gap between the boxes along it, times its length.
struct Direction {
  ExactVector normal;
  Exact gap;
};

/// The fifteen directions without those that are zero, which the cross product of parallel edges
/// is.
std::vector<Direction> directions(const Pair& pair) {
  std::array<ExactVector, 6> e;
  for (std::size_t i = 0; i < 6; ++i) e[i] = exact(edges(pair)[i]);
  const ExactVector between = exact(pair.centre_b) - exact(pair.centre_a);
  std::vector<Direction> all;
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = i + 1; j < 6; ++j) {
      const ExactVector n = e[i].cross(e[j]);
      if (n == ExactVector::Zero()) continue;
      Exact gap = abs(n.dot(between));
      for (const ExactVector& edge : e) gap -= abs(n.dot(edge));
      all.push_back({n, gap});
    }
  }
  return all;
}

Exact square(double x) { return Exact(x) * Exact(x); }

bool are_apart_by(const Pair& pair, double least) {
  const std::vector<Direction> all = directions(pair);
  return std::any_of(all.begin(), all.end(), [&](const Direction& d) {
    return d.gap.sign() > 0 && d.gap * d.gap >= square(least) * d.normal.dot(d.normal);
  });
}

bool have_common_point(const Pair& pair) {
  const std::vector<Direction> all = directions(pair);
  return std::none_of(all.begin(), all.end(), [](const Direction& d) { return d.gap.sign() > 0; });
}

/// The widest gap along one of the directions, m, rounded.
double widest_gap(const Pair& pair) {
  double widest = -std::numeric_limits<double>::infinity();
  for (const Direction& d : directions(pair)) {
    const double length = std::sqrt(rounded<double>(d.normal.dot(d.normal)));
    widest = std::max(widest, rounded<double>(d.gap) / length);
  }
  return widest;
}

/// Whether u, v and w of each box have angles whose cosines are at most this, and none is zero.
bool are_perpendicular(const Pair& pair, double cosine) {
  for (const given::Edges& of_box : {edges_of_a(pair), edges_of_b(pair)}) {
    for (std::size_t i = 0; i < 3; ++i) {
      const ExactVector u = exact(of_box[i]), v = exact(of_box[(i + 1) % 3]);
      const Exact dot = u.dot(v);
      if (u == ExactVector::Zero()) return false;
      if (dot * dot > square(cosine) * u.dot(u) * v.dot(v)) return false;
    }
  }
  return true;
}

bool have_lengths(const Pair& pair, double least, double most) {
  const auto all = edges(pair);
  return std::all_of(all.begin(), all.end(), [&](const Point& e) {
    return e.norm() >= least * (1 - kRounding) && e.norm() <= most * (1 + kRounding);
  });
}

bool are_near(const Pair& pair) {
  return all_within(pair.centre_a, 10) && all_within(pair.centre_b, 10);
}

// What the given code computes.

Point between(const Pair& pair) { return pair.centre_b - pair.centre_a; }

bool given_separates(const Pair& pair, const Point& n) {
  return given::separates(n, between(pair), edges_of_a(pair), edges_of_b(pair));
}

bool some_face_separates(const Pair& pair) {
  const auto all = edges(pair);
  return std::any_of(all.begin(), all.end(),
                     [&](const Point& n) { return given_separates(pair, n); });
}

bool some_padded_face_separates(const Pair& pair) {
  const given::Cosines c = given::cosines(pair);
  return given::face_separates(c, 0) || given::face_separates(c, 1) || given::face_separates(c, 2);
}

/// Whether the given code computes the gap along a direction without any rounding.
bool is_gap_exact(const Pair& pair, const Point& n) {
  const double distance = std::abs(given::dot(n, between(pair)));
  const double radii =
      given::projected_radius(edges_of_a(pair), n) + given::projected_radius(edges_of_b(pair), n);
  Exact sum;
  for (const Point& e : edges(pair)) sum += abs(exact(n).dot(exact(e)));
  return Exact(radii) == sum && Exact(distance) == abs(exact(n).dot(exact(between(pair))));
}

/// Whether it does so for each direction along which the boxes touch.
bool is_touch_exact(const Pair& pair) {
  const auto& [u, v, w, p, q, r] = edges(pair);
  std::vector<Point> normals{u, v, w, p, q, r};
  for (const Point& of_a : edges_of_a(pair)) {
    for (const Point& of_b : edges_of_b(pair)) normals.emplace_back(of_a.cross(of_b));
  }
  return std::all_of(normals.begin(), normals.end(), [&](const Point& n) {
    Exact gap = abs(exact(n).dot(exact(pair.centre_b) - exact(pair.centre_a)));
    for (const Point& e : edges(pair)) gap -= abs(exact(n).dot(exact(e)));
    return n == Point::Zero() || gap.sign() != 0 || is_gap_exact(pair, n);
  });
}

bool overlap(const Pair& pair) {
  const std::vector<Direction> all = directions(pair);
  return std::all_of(all.begin(), all.end(), [](const Direction& d) { return d.gap.sign() < 0; });
}

std::string name(bool meet) { return meet ? "meet" : "apart"; }

std::string say_gap(const Pair& pair) {
  const double gap = widest_gap(pair);
  if (gap > 0)
    return "The widest gap along one of the fifteen directions is " +
           contact::text_of(gap, {.digits = 4}) + ".";
  return gap < 0 ? "The projections overlap along all fifteen directions."
                 : "Along one of the fifteen directions the projections touch.";
}

Judged judged(const Pair& pair, bool given, bool right) {
  return {given != right, name(given), name(right), say_gap(pair)};
}

}  // namespace

TEST_CASE("small boxes that are apart are said to meet") {
  break_it<Pair>("Which small boxes are apart and said to meet, because short axes are skipped?")
      .rule("every number is finite", [](const Pair& pair) { return all_finite(pair); })
      .rule("no coordinate of a centre is beyond 10", are_near)
      .rule("u, v and w have lengths from 0.01 to 0.05",
            [](const Pair& pair) { return have_lengths(pair, 0.01, 0.05); })
      .rule("u, v and w are perpendicular to one another",
            [](const Pair& pair) { return are_perpendicular(pair, kRounding); })
      .rule("the boxes are apart by at least 0.001 along one of the fifteen directions",
            [](const Pair& pair) { return are_apart_by(pair, kGap); })
      .suspect_if("break-a-face-separates", some_face_separates)
      .suspect_if("break-cross-product-is-long", [](const Pair&) { return true; })
      .input("boxes", [] { return exercise::small_gap_missed(); })
      .judge([](const Pair& pair) { return judged(pair, given::meet_skipping(pair), false); });
}

TEST_CASE("boxes that are apart are said to meet for the padding") {
  break_it<Pair>("Which boxes are apart and said to meet, because the cosines are padded?")
      .rule("every number is finite", [](const Pair& pair) { return all_finite(pair); })
      .rule("no coordinate of a centre is beyond 10", are_near)
      .rule("u, v and w have lengths from 0.1 to 1",
            [](const Pair& pair) { return have_lengths(pair, 0.1, 1); })
      .rule("u, v and w are perpendicular to one another",
            [](const Pair& pair) { return are_perpendicular(pair, kRounding); })
      .rule("the boxes are apart by at least 0.001 along one of the fifteen directions",
            [](const Pair& pair) { return are_apart_by(pair, kGap); })
      .suspect_if("break-a-face-separates", some_padded_face_separates)
      .suspect_if("break-edges-cross-clearly", [](const Pair&) { return true; })
      .input("boxes", [] { return exercise::padded_gap_missed(); })
      .judge([](const Pair& pair) { return judged(pair, given::meet_padded(pair), false); });
}

TEST_CASE("boxes with a common point are said to be apart") {
  break_it<Pair>("Which boxes have a common point and are said to be apart?")
      .rule("every coordinate is a whole number from -10000000 to 10000000",
            [](const Pair& pair) { return all_within(pair, 1e7) && all_whole(pair); })
      .rule("u, v and w are perpendicular to one another, and none is zero",
            [](const Pair& pair) { return are_perpendicular(pair, 0); })
      .rule("the boxes have a common point", have_common_point)
      .suspect_if("break-boxes-overlap", overlap)
      .suspect_if("break-touch-is-exact", is_touch_exact)
      .suspect_if("break-rounded-to-meet", [](const Pair&) { return true; })
      .input("boxes", [] { return exercise::common_point_missed(); })
      .judge([](const Pair& pair) { return judged(pair, given::meet_skipping(pair), true); });
}
