// Whether the ray hits, and how far from every edge, is decided without rounding.
#include "break_the_determinant.hpp"
#include "hit_with_epsilon.hpp"

#include <support/break_it.hpp>

#include <contact/exact.hpp>

namespace {

using namespace contact::testing;
using contact::Exact;
using exercise::Shot;
using Vector = Eigen::Matrix<Exact, 3, 1>;

Vector exact(const Eigen::Vector3d& v) { return {Exact(v.x()), Exact(v.y()), Exact(v.z())}; }

Exact triple(const Vector& u, const Vector& v, const Vector& w) {
  Exact sum;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    sum += u[i] * (v[j] * w[k] - v[k] * w[j]);
  }
  return sum;
}

/// The determinant of the ray and the triangle, and the numerators of t and of the weights of b and
/// c, all with the sign that makes the determinant positive.
struct Numerators {
  Exact determinant, t, b, c;

  explicit Numerators(const Shot& shot) {
    const Vector d = exact(shot.direction), a = exact(shot.a);
    const Vector ab = exact(shot.b) - a, ac = exact(shot.c) - a, s = exact(shot.origin) - a;
    determinant = triple(ab, d, ac);
    b = triple(s, d, ac);
    c = triple(d, s, ab);
    t = triple(ac, s, ab);
    if (determinant.sign() >= 0) return;
    for (Exact* x : {&determinant, &b, &c, &t}) *x = Exact() - *x;
  }

  bool hit() const { return inside(0) && t.sign() >= 0; }
  /// Whether every weight is at least this share of 2^-10.
  bool inside(int share) const {
    if (determinant.sign() <= 0) return false;
    const Exact least = determinant * Exact(share), full(1024.0);
    const Exact first = (determinant - b - c) * full;
    return b * full >= least && c * full >= least && first >= least;
  }
};

bool hits(const Shot& shot) { return Numerators(shot).hit(); }
/// Each weight is at least 204/1024, a little less than 0.2, so that 0.2 as typed is enough.
bool in_the_middle(const Shot& shot) { return Numerators(shot).inside(204); }

double determinant(const Shot& shot) {
  return (shot.b - shot.a).dot(shot.direction.cross(shot.c - shot.a));
}

Judged judged(const Shot& shot) {
  const bool given = given::hit_with_epsilon(shot.origin, shot.direction, shot.a, shot.b, shot.c);
  return {
      !given, given ? "hit" : "miss", "hit",
      "The computed determinant is " + contact::text_of(determinant(shot), {.digits = 3}) + "."};
}

BreakIt<Shot> question(std::string_view text) {
  return break_it<Shot>(text)
      .rule("no coordinate is larger than 1e9",
            [](const Shot& shot) { return all_within(shot, 1e9); })
      .rule("the ray hits the triangle", hits);
}

}  // namespace

TEST_CASE("a hit in the middle of a small triangle is missed") {
  question("Which small triangle is missed?")
      .rule("the direction is (0, 0, -1)",
            [](const Shot& shot) { return shot.direction == Eigen::Vector3d(0, 0, -1); })
      .rule("each barycentric weight is at least 0.2", in_the_middle)
      .suspect_if("break-determinant-is-large",
                  [](const Shot& shot) { return std::abs(determinant(shot)) >= 1e-6; })
      .input("shot", [] { return exercise::small_triangle(); })
      .judge(judged);
}

TEST_CASE("a hit in the middle of a triangle of 4 m is missed") {
  question("Which ray misses a triangle of 4 m?")
      .rule("the triangle is (0, 0, 0), (4, 0, 0), (0, 4, 0)",
            [](const Shot& shot) {
              return shot.a.isZero(0) && shot.b == Eigen::Vector3d(4, 0, 0) &&
                     shot.c == Eigen::Vector3d(0, 4, 0);
            })
      .rule("each barycentric weight is at least 0.2", in_the_middle)
      .suspect_if("break-determinant-is-large",
                  [](const Shot& shot) { return std::abs(determinant(shot)) >= 1e-6; })
      .input("shot", [] { return exercise::short_direction(); })
      .judge(judged);
}

TEST_CASE("a hit of whole numbers is missed") {
  question("Which hit of whole numbers is missed?")
      .rule("every coordinate is a whole number from -10 to 10",
            [](const Shot& shot) { return all_within(shot, 10) && all_whole(shot); })
      .suspect_if("break-ray-starts-away",
                  [](const Shot& shot) { return Numerators(shot).t.sign() > 0; })
      .input("shot", [] { return exercise::whole_numbers(); })
      .judge(judged);
}
