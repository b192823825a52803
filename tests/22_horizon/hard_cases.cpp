// Recomputes the answers of hard_cases.json and reports which method gets which case right.
//
// Points fly in the direction of the x-axis and hit a round post, with its centre at the origin, or
// pass it. The offset is the y-coordinate of the path.
//
// growth: by which factor the distance of two paths, parallel before the hit, has grown after a
// flight behind it, in the limit of small distances: 1 + 2 ℓ/√(r² − b²), of class (b); a path that
// misses has the factor 1, and a path that touches the post has none.
//
// angle: between the directions of two points behind the post, whose offsets differ by a given
// error. A point with the sine s = offset/r is rotated by π − 2 asin s, and not at all if it
// misses: of class (c).
//
// A factor is right if its relative error is at most 2^-20, since two paths, whose distance is not
// small, cannot have more than half the digits; an angle if its error is at most 2^-40 of itself.
#include "support/hard_cases.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

using hard_cases::Case;
using hard_cases::Json;
using hard_cases::unhex;
using oracle::Interval;
using oracle::Rational;

namespace {

bool same(double got, double right, int bits) {
  return std::isfinite(got) && std::abs(got - right) <= std::ldexp(std::abs(right), -bits);
}

// ---------------------------------------------------------------- growth

/// A point before or behind the post, and the direction in which it flies.
struct Flying {
  double x, y, vx, vy;
};

/// From 2 r before the centre, by the length of a path.
Flying behind(double offset, double r, double length) {
  if (!(std::abs(offset) < r)) return {-2 * r + length, offset, 1, 0};
  const double half_chord = std::sqrt(r * r - offset * offset);
  const double left = length - (2 * r - half_chord);
  const double nx = -half_chord / r;
  const double ny = offset / r;
  const double vx = 1 - 2 * nx * nx;
  const double vy = -2 * nx * ny;
  return {-half_chord + left * vx, offset + left * vy, vx, vy};
}

void add_growth(hard_cases::Runner& runner) {
  runner.question("growth", [](const Case& c) {
    const Rational b = oracle::exact(c.number("offset"));
    const Rational r = oracle::exact(c.number("radius"));
    const Rational flight = oracle::exact(c.number("flight"));
    const Rational square = r * r - b * b;
    if (square < 0) return Json{{"class", "a"}, {"factor", hard_cases::hex(1.0)}};
    if (square == 0) return Json{{"class", "a"}, {"factor", "none"}};
    const oracle::Surd factor = oracle::divided_by_root(2 * flight, square) + Rational(1);
    return Json{{"class", "b"}, {"factor", hard_cases::hex(oracle::nearest(factor))}};
  });
  const auto method = [&runner](const char* name, auto factor) {
    runner.method("growth", name, [factor](const Case& c, const Json& answer) {
      const double got = factor(c.number("offset"), c.number("radius"), c.number("flight"));
      if (answer.at("factor") == "none") return std::isinf(got);
      return same(got, unhex(answer, "factor"), 20);
    });
  };
  method("1 + 2ℓ/r", [](double, double r, double flight) { return 1 + 2 * flight / r; });
  method("two paths", [](double b, double r, double flight) {
    const double apart = r * 0x1p-26;
    const double length = 2 * r - std::sqrt(std::max(0.0, r * r - b * b)) + flight;
    const Flying one = behind(b, r, length);
    const Flying other = behind(b + apart, r, length);
    return std::hypot(one.x - other.x, one.y - other.y) / apart;
  });
  method("cosine from the sine", [](double b, double r, double flight) {
    const double sine = b / r;
    if (std::abs(sine) > 1) return 1.0;
    return 1 + 2 * flight / (r * std::sqrt(1 - sine * sine));
  });
  method("half the chord", [](double b, double r, double flight) {
    const double square = r * r - b * b;
    return square < 0 ? 1.0 : 1 + 2 * flight / std::sqrt(square);
  });
  method("book", [](double b, double r, double flight) {
    if (std::abs(b) > r) return 1.0;
    return 1 + 2 * flight / (std::sqrt(r - std::abs(b)) * std::sqrt(r + std::abs(b)));
  });
}

// ---------------------------------------------------------------- angle

/// By what angle a path with this offset is rotated: from 0 to 2 π, which is no rotation either.
Interval rotated(const Rational& offset, const Rational& r, unsigned bits) {
  const Interval pi = Interval::pi(bits);
  if (offset >= r) return Interval(Rational(0), bits);
  if (offset <= -r) return pi + pi;
  return pi - Interval(Rational(2), bits) * asin(Interval(Rational(offset / r), bits));
}

/// The angle between two directions, of an angle by which one is rotated into the other.
double to_half_a_turn(double angle) { return std::min(angle, 2 * std::numbers::pi - angle); }

void add_angle(hard_cases::Runner& runner) {
  runner.question("angle", [](const Case& c) {
    const Rational b = oracle::exact(c.number("offset"));
    const Rational other = b + oracle::exact(c.number("error"));
    const Rational r = oracle::exact(c.number("radius"));
    if (b == other || (abs(b) >= r && abs(other) >= r))
      return Json{{"class", "a"}, {"angle", hard_cases::hex(0.0)}};
    const oracle::Expression difference = [&](unsigned bits) {
      Interval angle = rotated(b, r, bits) - rotated(other, r, bits);
      if (angle.sign() == -1) angle = -angle;
      const Interval pi = Interval::pi(bits);
      return (angle - pi).sign() == 1 ? pi + pi - angle : angle;
    };
    return Json{{"class", "c"},
                {"angle", hard_cases::hex(oracle::nearest_value(difference).value())}};
  });
  const auto method = [&runner](const char* name, auto angle) {
    runner.method("angle", name, [angle](const Case& c, const Json& answer) {
      const double got = angle(c.number("offset"), c.number("error"), c.number("radius"));
      return same(got, unhex(answer, "angle"), 40);
    });
  };
  method("2 δ/r", [](double, double error, double r) { return 2 * std::abs(error) / r; });
  method("2 δ/(r cos θ)", [](double b, double error, double r) {
    if (std::abs(b) >= r) return 0.0;
    return 2 * std::abs(error) / (std::sqrt(r - std::abs(b)) * std::sqrt(r + std::abs(b)));
  });
  method("two arcsines", [](double b, double error, double r) {
    const auto one = [r](double offset) {
      return 2 * std::asin(std::clamp(offset / r, -1.0, 1.0));
    };
    return to_half_a_turn(std::abs(one(b) - one(b + error)));
  });
  // With tan((α − β)/2) = (sin α − sin β)/(cos α + cos β) no digits cancel.
  method("half the angle", [](double b, double error, double r) {
    const auto half_chord = [r](double offset) {
      const double square = (r - std::abs(offset)) / r * ((r + std::abs(offset)) / r);
      return std::sqrt(std::max(0.0, square));
    };
    const double other = b + error;
    const double cosines = half_chord(b) + half_chord(other);
    if (cosines == 0) return 0.0;
    if (std::abs(b) > r || std::abs(other) > r) {
      const double sine = std::min(std::abs(b), std::abs(other)) / r;
      return 2 * std::atan2(cosines, sine);
    }
    return to_half_a_turn(4 * std::atan(std::abs(error) / r / cosines));
  });
}

}  // namespace

int main(int argc, char** argv) {
  hard_cases::Runner runner("22_horizon");
  add_growth(runner);
  add_angle(runner);
  return runner.run(argc, argv);
}
