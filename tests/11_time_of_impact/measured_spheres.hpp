/// @file
/// Methods for the time at which two moving spheres meet, as the ladder measures them.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <contact/entry_time.hpp>
#include <contact/moving_spheres.hpp>
#include <contact/quadratic_roots.hpp>
#include <contact/translating_impact.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "families.hpp"
#include "measured_impact.hpp"

namespace measured_spheres {

using contact::Exact;
using contact::Vector3;
using measured_impact::Answer;
using measured_impact::exact;
using measured_impact::hit_at;
using measured_impact::judge;
using measured_impact::rounded;
using Vector = Vector3<double>;
using Plane2 = contact::Vector2<double>;

using Spheres = families::MovingSpheres<double>;

struct Input {
  Spheres pair;
  families::MovingSpheres<float> in_float;  ///< each number rounded to the nearest
};

inline Input made(const Spheres& pair) {
  const auto body = [](const contact::Sphere<double>& s) { return generators::rounded<float>(s); };
  return {pair,
          {body(pair.a), body(pair.b), pair.displacement_a.cast<float>(),
           pair.displacement_b.cast<float>()}};
}

/// In fractions of whole numbers, up to the root and the quotients that give the time.
inline Answer truth(const Input& input) {
  const auto& [a, b, displacement_a, displacement_b] = input.pair;
  const auto terms =
      contact::entry_terms<Exact>(contact::exact_vector_difference(a.centre, b.centre),
                                  contact::exact_vector_difference(displacement_a, displacement_b),
                                  Exact(a.radius) + Exact(b.radius));
  if (terms.gap.sign() <= 0) return hit_at(0);
  if (!terms.enters_by(Exact(1.0))) return {};
  return hit_at(std::min(1.0, contact::entry_time<double>(terms)));
}

/// Both centres at a time, and whether they are as close as the radii allow.
inline bool overlap_at(const Spheres& pair, double t) {
  const Vector a = pair.a.centre + t * pair.displacement_a;
  const Vector b = pair.b.centre + t * pair.displacement_b;
  const double reach = pair.a.radius + pair.b.radius;
  return (a - b).squaredNorm() <= reach * reach;
}

inline Answer sliced(const Input& input, int slices, int halvings = 0) {
  return measured_impact::by_slices([&input](double t) { return overlap_at(input.pair, t); },
                                    slices, halvings);
}

/// The formula of textbooks: (−b − √(b² − 4 a c)) / (2 a).
template <std::floating_point S>
inline Answer textbook(const families::MovingSpheres<S>& pair) {
  const Vector3<S> d = pair.a.centre - pair.b.centre;
  const Vector3<S> w = pair.displacement_a - pair.displacement_b;
  const S reach = pair.a.radius + pair.b.radius;
  const S a = w.dot(w), b = 2 * d.dot(w), c = d.dot(d) - reach * reach;
  if (c <= 0) return hit_at(0);
  const S discriminant = b * b - 4 * a * c;
  if (discriminant < 0) return {};
  const S t = (-b - std::sqrt(discriminant)) / (2 * a);
  if (t >= 0 && t <= 1) return hit_at(double(t));
  return {};
}

/// The roots without cancellation, of coefficients that are rounded.
inline Answer stable_roots(const Input& input) {
  const auto& [a, b, displacement_a, displacement_b] = input.pair;
  const Vector d = a.centre - b.centre, w = displacement_a - displacement_b;
  const double reach = a.radius + b.radius;
  const double gap = d.dot(d) - reach * reach;
  if (gap <= 0) return hit_at(0);
  const auto roots = contact::quadratic_roots<double>(w.dot(w), 2 * d.dot(w), gap);
  if (roots.count > 0 && roots.low >= 0 && roots.low <= 1) return hit_at(roots.low);
  return {};
}

/// The book's terms, which cancel least, rounded: no decision is proven.
template <std::floating_point S>
inline Answer rounded_terms(const families::MovingSpheres<S>& pair) {
  const auto terms = contact::entry_terms<S>(pair.a.centre - pair.b.centre,
                                             pair.displacement_a - pair.displacement_b,
                                             pair.a.radius + pair.b.radius);
  if (terms.gap <= 0) return hit_at(0);
  if (!terms.enters()) return {};
  const S t = terms.gap / (terms.approach + std::sqrt(terms.depth));
  if (t <= 1) return hit_at(double(t));
  return {};
}

inline Answer proven(const Input& input) {
  const auto& [a, b, displacement_a, displacement_b] = input.pair;
  const auto impact = contact::translating_impact(a, displacement_a, b, displacement_b);
  if (!impact.meets) return {};
  return hit_at(impact.t);
}

inline Answer exactly(const Input& input) {
  const auto& [a, b, displacement_a, displacement_b] = input.pair;
  const auto t = contact::moving_spheres_impact(a, displacement_a, b, displacement_b);
  if (!t) return {};
  return hit_at(*t);
}

/// How a method is set in the figure: slices and halvings.
std::optional<std::pair<int, int>> in_figure(const std::string& id) {
  if (id == "slices-3") return {{3, 0}};
  if (id == "slices-100") return {{100, 0}};
  if (id == "bisection") return {{3, 20}};
  return std::nullopt;
}

/// The motion of a relative to b in its plane, moved and scaled to fit into the figure.
struct InPlane {
  Plane2 from, to, other;
  double radius, other_radius;

  explicit InPlane(const Spheres& pair) {
    const Vector d = pair.a.centre - pair.b.centre;
    const Vector w = pair.displacement_a - pair.displacement_b;
    const double length = std::sqrt(w.squaredNorm());
    const Vector along = w / length;
    const double before = d.dot(along);
    const double beside = std::sqrt((d - before * along).squaredNorm());
    const double low = std::min(before, 0.0), high = std::max(before + length, 0.0);
    const double scale = std::min({1.0, 8 / (high - low), 2 / beside});
    const double middle = (low + high) / 2;
    other = {-scale * middle, 1 - scale * beside / 2};
    from = other + scale * Plane2(before, beside);
    to = from + Plane2(scale * length, 0);
    radius = scale * pair.a.radius;
    other_radius = scale * pair.b.radius;
  }
  bool visible() const {
    return from.allFinite() && to.allFinite() && other.allFinite() && radius >= 0.05 &&
           other_radius >= 0.05 && radius <= 1.5 && other_radius <= 1.5;
  }
  Spheres spheres() const {
    const auto space = [](const Plane2& p) { return Vector(p.x(), p.y(), 0); };
    return {{space(from), radius}, {space(other), other_radius}, space(to - from), Vector::Zero()};
  }
  Answer sliced(int slices) const {
    const auto overlap = [this](double t) {
      const Plane2 between = from + t * (to - from) - other;
      return std::sqrt(between.squaredNorm()) - other_radius - radius <= 0;
    };
    return measured_impact::by_slices(overlap, slices);
  }
};

inline ladder::Example shown(const Input& input, const Answer& got, const Answer& right,
                             const ladder::Method& method) {
  const auto& [a, b, displacement_a, displacement_b] = input.pair;
  ladder::Example example;
  example.facts = {ladder::numbers("first centre", a.centre),
                   ladder::number("first radius", a.radius),
                   ladder::numbers("first displacement", displacement_a),
                   ladder::numbers("second centre", b.centre),
                   ladder::number("second radius", b.radius),
                   ladder::numbers("second displacement", displacement_b),
                   measured_impact::told("this method", got),
                   measured_impact::told("exact", right)};
  const auto setting = in_figure(method.id);
  if (!setting) {
    example.note = "The figure does not have this method.";
    return example;
  }
  const InPlane plane(input.pair);
  if (!plane.visible()) {
    example.note = "In the figure these spheres would be too small.";
    return example;
  }
  const bool same =
      plane.sliced(setting->first).hit == got.hit && truth(made(plane.spheres())).hit == right.hit;
  if (!same) {
    example.note = "In the figure's plane, rounding gives another answer.";
    return example;
  }
  example.figure = "bullet_and_plate";
  example.fields = {{"target", {1}},
                    ladder::field("from", plane.from),
                    ladder::field("to", plane.to),
                    {"radius", {plane.radius}},
                    ladder::field("other_from", plane.other),
                    ladder::field("other_to", plane.other),
                    {"other_radius", {plane.other_radius}},
                    {"slices", {double(setting->first)}},
                    {"halvings", {double(setting->second)}}};
  example.note = "The figure shows the motion relative to the second sphere.";
  return example;
}

/// Described relative to the second sphere, or with fewer digits.
inline std::vector<Input> simpler(const Input& input) {
  std::vector<Input> all;
  const Spheres& pair = input.pair;
  if (pair.b.centre != Vector::Zero() || pair.displacement_b != Vector::Zero()) {
    Spheres relative = pair;
    relative.a.centre -= pair.b.centre;
    relative.displacement_a -= pair.displacement_b;
    relative.b.centre = relative.displacement_b = Vector::Zero();
    all.push_back(made(relative));
  }
  for (const int bits : {0, 2, 4, 8, 16, 24}) {
    const auto shorter = [bits](double x) {
      return std::ldexp(std::round(std::ldexp(x, bits)), -bits) + 0.0;
    };
    const auto each = [&shorter](const Vector& v) { return Vector(v.unaryExpr(shorter)); };
    const Spheres short_one{{each(pair.a.centre), shorter(pair.a.radius)},
                            {each(pair.b.centre), shorter(pair.b.radius)},
                            each(pair.displacement_a),
                            each(pair.displacement_b)};
    const bool same = short_one.a.centre == pair.a.centre && short_one.b.centre == pair.b.centre &&
                      short_one.a.radius == pair.a.radius && short_one.b.radius == pair.b.radius &&
                      short_one.displacement_a == pair.displacement_a &&
                      short_one.displacement_b == pair.displacement_b;
    if (!same) all.push_back(made(short_one));
  }
  return all;
}

inline ladder::Ladder<Input, Answer> experiment() {
  ladder::Ladder<Input, Answer> ladder("When do two moving spheres meet?", truth, judge);
  const auto family = [&ladder](const char* id, const char* title, families::Spheres kind) {
    ladder.family(id, title, [kind](generators::Random& random) {
      return made(families::spheres<double>(random, kind));
    });
  };
  family("random", "random", families::Spheres::random);
  family("graze", "grazing, to the last bit", families::Spheres::graze);
  family("fast", "50 to 5,000 distances in the step", families::Spheres::fast);
  family("start-in-touch", "start in touch", families::Spheres::start_in_touch);
  family("nearly-touching", "start a few ulps apart", families::Spheres::nearly_touching);
  family("at-the-end", "touch at the end, to the last bit", families::Spheres::at_the_end);
  family("far", "10⁸ m from the origin", families::Spheres::far);
  family("one-large", "a marble and a planet", families::Spheres::one_large);

  ladder.method(rounded("slices-3", "3 slices", "double"),
                [](const Input& input) { return sliced(input, 3); });
  ladder.method(rounded("slices-100", "100 slices", "double"),
                [](const Input& input) { return sliced(input, 100); });
  ladder.method(rounded("bisection", "3 slices, then 20 halvings", "double"),
                [](const Input& input) { return sliced(input, 3, 20); });
  ladder.method(rounded("textbook-float", "quadratic, as in textbooks", "float"),
                [](const Input& input) { return textbook<float>(input.in_float); });
  ladder.method(rounded("textbook-double", "quadratic, as in textbooks", "double"),
                [](const Input& input) { return textbook<double>(input.pair); });
  ladder.method(rounded("stable-double", "roots without cancellation", "double"), stable_roots);
  ladder.method(rounded("terms-float", "coefficients without cancellation too", "float"),
                [](const Input& input) { return rounded_terms<float>(input.in_float); });
  ladder.method(rounded("terms-double", "coefficients without cancellation too", "double"),
                [](const Input& input) { return rounded_terms<double>(input.pair); });
  ladder.method(exact("proven", "ray cast with a proof, for all bodies"), proven);
  ladder.method(exact("exact", "filter, then exact"), exactly);
  ladder.recommend("exact");
  ladder.show(shown);
  ladder.simplify(simpler);
  return ladder;
}

}  // namespace measured_spheres
