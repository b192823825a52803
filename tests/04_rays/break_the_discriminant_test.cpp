// Where the ray passes is decided without rounding.
#include "break_the_discriminant.hpp"
#include "hits_by_discriminant.hpp"

#include <support/break_it.hpp>

#include <04_rays/exact_lines.hpp>

namespace {

using namespace contact::testing;
using contact::Exact;
using exercise::Shot;

/// What decides about a shot. The quadratic is a t² + 2 b t + c.
struct Exactly {
  Exact a, b, c, r, discriminant;

  explicit Exactly(const Shot& shot) : r(shot.radius) {
    const exact::Vector m = exact::exactly(shot.origin) - exact::exactly(shot.centre);
    const exact::Vector d = exact::exactly(shot.direction);
    a = exact::dot(d, d);
    b = exact::dot(d, m);
    c = exact::dot(m, m) - r * r;
    discriminant = b * b - a * c;
  }

  /// The squared distance of start and centre.
  Exact away() const { return c + r * r; }
  /// a times the squared distance of centre and line.
  Exact beside() const { return a * r * r - discriminant; }
};

bool passes_through(const Shot& shot) { return Exactly(shot).discriminant.sign() > 0; }

/// Half of the chord has the square discriminant / a.
bool is_long_inside(const Shot& shot) {
  const Exactly of(shot);
  return Exact(64.0) * of.discriminant >= of.a;
}

bool passes_beside(const Shot& shot) {
  const Exactly of(shot);
  const Exact least = Exact(100.0) * of.r + Exact(1.0);
  return Exact(10'000.0) * of.beside() >= of.a * least * least;
}

std::function<bool(const Shot&)> starts_within(double distance) {
  return [distance](const Shot& shot) {
    return Exactly(shot).away() <= Exact(distance) * Exact(distance);
  };
}

float computed(const Shot& shot) {
  return given::discriminant(shot.origin, shot.direction, shot.centre, shot.radius);
}

/// b² − 4 a c, with the b of the given code.
Exact right_one(const Shot& shot) { return Exact(4.0) * Exactly(shot).discriminant; }

bool is_exact(const Shot& shot) { return Exact(double(computed(shot))) == right_one(shot); }

Judged judged(const Shot& shot) {
  const bool given =
      given::hits_by_discriminant(shot.origin, shot.direction, shot.centre, shot.radius);
  const bool right = passes_through(shot);
  const auto name = [](bool hit) { return hit ? "hit" : "miss"; };
  return {given != right, name(given), name(right),
          "The computed discriminant is " + contact::text_of(double(computed(shot))) +
              ", and without rounding it is " + contact::text_of(rounded<double>(right_one(shot))) +
              "."};
}

BreakIt<Shot> question(std::string_view text) {
  return break_it<Shot>(text)
      .rule("all numbers are whole", [](const Shot& shot) { return all_whole(shot); })
      .rule("the coordinates of origin and centre are from -1000 to 1000",
            [](const Shot& shot) {
              return all_within(shot.origin, 1000) && all_within(shot.centre, 1000);
            })
      .rule("the direction is not zero, and its coordinates are from -10000 to 10000",
            [](const Shot& shot) {
              return all_within(shot.direction, 10'000) && !shot.direction.isZero(0);
            })
      .rule("the radius is from 1 to 1000",
            [](const Shot& shot) { return shot.radius >= 1 && shot.radius <= 1000; })
      .rule("the ray starts at most 1000 m from the centre", starts_within(1000))
      .rule("the ray starts outside the ball",
            [](const Shot& shot) { return Exactly(shot).c.sign() > 0; })
      .rule("the ray leads towards the ball",
            [](const Shot& shot) { return Exactly(shot).b.sign() < 0; });
}

}  // namespace

TEST_CASE("a ball is missed although a quarter of a metre of the ray is in it") {
  question("Which ball does the given code miss?")
      .rule("at least 0.25 m of the ray is in the ball", is_long_inside)
      .suspect_if("break-terms-are-exact", is_exact)
      .suspect_if("break-discriminant-is-clear", [](const Shot&) { return true; })
      .input("shot", [] { return exercise::missed_ball(); })
      .judge(judged);
}

TEST_CASE("a ball is hit although the ray passes a centimetre beside it") {
  question("Which ball does the given code hit beside the ray?")
      .rule("the ray passes at least 0.01 m beside the ball", passes_beside)
      .suspect_if("break-terms-are-exact", is_exact)
      .suspect_if("break-discriminant-is-clear", [](const Shot&) { return true; })
      .input("shot", [] { return exercise::ball_beside_the_ray(); })
      .judge(judged);
}

TEST_CASE("a ball at most 150 m away is missed") {
  question("Which ball nearby does the given code miss?")
      .rule("the ray starts at most 150 m from the centre", starts_within(150))
      .rule("the ray passes through the interior of the ball", passes_through)
      .suspect_if("break-terms-are-exact", is_exact)
      .suspect_if("break-discriminant-is-clear", [](const Shot&) { return true; })
      .input("shot", [] { return exercise::near_ball(); })
      .judge(judged);
}
