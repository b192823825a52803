// Whether points are on one line is decided without rounding, by the sign of each component of the
// cross product.
#include "break_the_epsilon.hpp"
#include "span_a_plane.hpp"

#include <support/break_it.hpp>

#include <contact/exact.hpp>

namespace {

using namespace contact::testing;
using contact::Exact;
using exercise::Points;
using Vector = Eigen::Vector3d;

bool on_one_line(const Points& p) {
  const auto d = [&](const Vector& q, int i) { return Exact(q[i]) - Exact(p.a[i]); };
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    if ((d(p.b, i) * d(p.c, j) - d(p.b, j) * d(p.c, i)).sign() != 0) return false;
  }
  return true;
}

/// Whether all six differences that the given code takes are exact.
bool exact_differences(const Points& p) {
  for (const Vector& q : {p.b, p.c}) {
    for (int i = 0; i < 3; ++i) {
      if (Exact(q[i]) - Exact(p.a[i]) != Exact(q[i] - p.a[i])) return false;
    }
  }
  return true;
}

double min_distance(const Points& p) {
  return std::min({(p.a - p.b).norm(), (p.b - p.c).norm(), (p.c - p.a).norm()});
}

/// Whether the angle at a is at least 30 degrees, up to rounding.
bool wide(const Vector& a, const Vector& b, const Vector& c) {
  const Vector u = b - a, v = c - a;
  return std::atan2(u.cross(v).norm(), u.dot(v)) >= 0.5235;
}

bool all_wide(const Points& p) {
  return wide(p.a, p.b, p.c) && wide(p.b, p.c, p.a) && wide(p.c, p.a, p.b);
}

std::string told(bool spans) { return spans ? "they span a plane" : "they do not span a plane"; }

Judged judged(const Points& p) {
  const bool given = given::span_a_plane(p.a, p.b, p.c), right = !on_one_line(p);
  const double length = (p.b - p.a).cross(p.c - p.a).norm();
  return {given != right, told(given), told(right),
          "The cross product has the computed length " + contact::text_of(length, {.digits = 3}) +
              (right ? ", and is not zero." : ". Without rounding it is zero.")};
}

BreakIt<Points> question(std::string_view text) {
  return break_it<Points>(text).rule("no coordinate is larger than 1e9",
                                     [](const Points& p) { return all_within(p, 1e9); });
}

BreakIt<Points> refused(std::string_view text) {
  return question(text)
      .rule("the points are not on one line", [](const Points& p) { return !on_one_line(p); })
      .suspect_if("break-area-is-large",
                  [](const Points& p) { return given::span_a_plane(p.a, p.b, p.c); });
}

}  // namespace

TEST_CASE("a plane through distant points is refused") {
  refused("Which plane is refused, although its points are 0.1 m apart?")
      .rule("no two points are closer than 0.1 m",
            [](const Points& p) { return min_distance(p) >= 0.1; })
      .input("points", [] { return exercise::plane_refused(); })
      .judge(judged);
}

TEST_CASE("a plane through a triangle without small angles is refused") {
  refused("Which plane is refused, although its triangle is not thin?")
      .rule("the angle at each point is at least 30 degrees", all_wide)
      .input("points", [] { return exercise::small_triangle_refused(); })
      .judge(judged);
}

TEST_CASE("a line is accepted") {
  question("Which points on a line are accepted?")
      .rule("the points are exactly on one line, as stored", on_one_line)
      .rule("no two points are equal",
            [](const Points& p) { return p.a != p.b && p.b != p.c && p.c != p.a; })
      .suspect_if("break-differences-are-exact", exact_differences)
      .input("points", [] { return exercise::line_accepted(); })
      .judge(judged);
}
