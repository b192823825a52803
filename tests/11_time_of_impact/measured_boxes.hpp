/// @file
/// Methods for the time at which two translating boxes meet, as the ladder measures them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <contact/box_sweep.hpp>
#include <contact/conservative_advancement.hpp>
#include <contact/oriented_box.hpp>
#include <contact/translating_impact.hpp>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "families.hpp"
#include "measured_impact.hpp"

namespace measured_boxes {

using contact::Exact;
using contact::Vector3;
using measured_impact::Answer;
using measured_impact::exact;
using measured_impact::hit_at;
using measured_impact::judge;
using measured_impact::rounded;
using Vector = Vector3<double>;

using Box = contact::TranslatingBox<double>;

struct Input {
  Box a, b;
  contact::TranslatingBox<float> a_in_float, b_in_float;
  contact::OrientedBox<double> a_at_start, b_at_start;
};

inline Input made(const Box& a, const Box& b) {
  const auto in_float = [](const Box& box) {
    contact::TranslatingBox<float> to;
    to.frame.origin = box.frame.origin.cast<float>();
    to.frame.axes = box.frame.axes.cast<float>();
    to.half_lengths = box.half_lengths.cast<float>();
    to.displacement = box.displacement.cast<float>();
    return to;
  };
  const auto at_start = [](const Box& box) {
    return contact::OrientedBox<double>{box.frame.origin, box.frame.axes, box.half_lengths};
  };
  return {a, b, in_float(a), in_float(b), at_start(a), at_start(b)};
}

/// The half edges of both boxes, and the motion of b relative to a, in any kind of number.
template <class T>
struct Pair {
  std::array<Vector3<T>, 3> u, v;
  Vector3<T> d, w;

  contact::AxisTimes<T> times(const Vector3<T>& axis) const {
    const auto magnitude = [](const T& x) { return x < T(0) ? T(-x) : x; };
    T radius_sum(0);
    for (std::size_t k = 0; k < 3; ++k)
      radius_sum = radius_sum + magnitude(axis.dot(u[k])) + magnitude(axis.dot(v[k]));
    return {axis.dot(d), axis.dot(w), radius_sum};
  }
};

template <class T, std::floating_point S>
Pair<T> pair_of(const contact::TranslatingBox<S>& a, const contact::TranslatingBox<S>& b) {
  const auto as = [](const Vector3<S>& v) { return Vector3<T>(T(v.x()), T(v.y()), T(v.z())); };
  Pair<T> pair;
  for (int k = 0; k < 3; ++k) {
    const auto at = std::size_t(k);
    pair.u[at] = as(a.frame.axes.col(k)) * T(a.half_lengths(k));
    pair.v[at] = as(b.frame.axes.col(k)) * T(b.half_lengths(k));
  }
  pair.d = as(b.frame.origin) - as(a.frame.origin);
  pair.w = as(b.displacement) - as(a.displacement);
  return pair;
}

/// The sweep in fractions, which are compared without a division.
inline Answer truth(const Input& input) {
  struct Time {
    Exact numerator, denominator;
    bool before(const Time& other) const {
      return numerator * other.denominator < other.numerator * denominator;
    }
  };
  const auto pair = pair_of<Exact>(input.a, input.b);
  Time begin{Exact(0.0), Exact(1.0)}, end{Exact(1.0), Exact(1.0)};
  for (const Vector3<Exact>& axis : contact::separating_axes(pair.u, pair.v)) {
    const auto times = pair.times(axis);
    const Exact speed = abs(times.speed);
    if (speed.sign() == 0) {
      if (times.radius_sum < abs(times.distance)) return {};
      continue;
    }
    const Time first{times.begins(), speed}, last{times.ends(), speed};
    if (begin.before(first)) begin = first;
    if (last.before(end)) end = last;
    if (end.before(begin)) return {};
  }
  return hit_at(quotient<double>(begin.numerator, begin.denominator));
}

/// Whether none of the fifteen axes separates the boxes at a time; rounded.
inline Answer sliced(const Input& input, int slices) {
  const auto pair = pair_of<double>(input.a, input.b);
  const auto axes = contact::separating_axes(pair.u, pair.v);
  std::array<contact::AxisTimes<double>, 15> times;
  for (std::size_t k = 0; k < 15; ++k) times[k] = pair.times(axes[k]);
  const auto overlap = [&times](double t) {
    return std::none_of(times.begin(), times.end(), [t](const auto& axis) {
      return std::abs(axis.distance + t * axis.speed) > axis.radius_sum;
    });
  };
  return measured_impact::by_slices(overlap, slices);
}

/// Whether the axis-aligned boxes of what both sweep touch: no time is known.
inline Answer swept(const Input& input) {
  const auto around = [](const Box& box) {
    const Vector reach = box.frame.axes.cwiseAbs() * box.half_lengths;
    const Vector end = box.frame.origin + box.displacement;
    return contact::Aabb<double>{box.frame.origin.cwiseMin(end) - reach,
                                 box.frame.origin.cwiseMax(end) + reach};
  };
  if (!contact::boxes_touch(around(input.a), around(input.b))) return {};
  return hit_at(0);
}

/// The sweep without bounds on its errors.
template <std::floating_point S>
inline Answer sweep(const contact::TranslatingBox<S>& a, const contact::TranslatingBox<S>& b) {
  const auto pair = pair_of<S>(a, b);
  S begin(0), end(1);
  for (const Vector3<S>& axis : contact::separating_axes(pair.u, pair.v)) {
    const auto times = pair.times(axis);
    const S speed = std::abs(times.speed);
    if (speed == S(0)) {
      if (std::abs(times.distance) > times.radius_sum) return {};
      continue;
    }
    begin = std::max(begin, times.begins() / speed);
    end = std::min(end, times.ends() / speed);
    if (begin > end) return {};
  }
  return hit_at(double(begin));
}

inline Answer advanced(const Input& input) {
  const auto rotating = [](const Box& box) {
    return contact::RotatingBox<double>{box.frame.origin, contact::quaternion_of(box.frame.axes),
                                        box.half_lengths, box.displacement, Vector::Zero()};
  };
  const auto found =
      contact::rotating_boxes_impact<double>(rotating(input.a), rotating(input.b), 1, 1e-4, 200);
  if (found.end == contact::ConservativeEnd::clear) return {};
  return {true, found.t, found.end == contact::ConservativeEnd::gave_up};
}

inline Answer proven(const Input& input) {
  const auto impact = contact::translating_impact(input.a_at_start, input.a.displacement,
                                                  input.b_at_start, input.b.displacement);
  if (!impact.meets) return {};
  return hit_at(impact.t);
}

inline Answer exactly(const Input& input) {
  const auto impact = contact::box_impact(input.a, input.b);
  if (!impact) return {};
  return hit_at(impact->t);
}

inline ladder::Example shown(const Input& input, const Answer& got, const Answer& right,
                             const ladder::Method&) {
  ladder::Example example;
  for (const auto& [name, box] : {std::pair("first", &input.a), std::pair("second", &input.b)}) {
    const std::string of = name;
    example.facts.push_back(ladder::numbers(of + " centre", box->frame.origin));
    for (int k = 0; k < 3; ++k)
      example.facts.push_back(
          ladder::numbers(of + " axis " + std::to_string(k + 1), Vector(box->frame.axes.col(k))));
    example.facts.push_back(ladder::numbers(of + " half lengths", box->half_lengths));
    example.facts.push_back(ladder::numbers(of + " displacement", box->displacement));
  }
  example.facts.push_back(measured_impact::told("this method", got));
  example.facts.push_back(measured_impact::told("exact", right));
  example.note = "The figures show discs and rods in the plane.";
  return example;
}

/// Described relative to the second box, or with fewer digits.
inline std::vector<Input> simpler(const Input& input) {
  std::vector<Input> all;
  const auto same = [](const Box& x, const Box& y) {
    return x.frame.origin == y.frame.origin && x.half_lengths == y.half_lengths &&
           x.displacement == y.displacement;
  };
  const auto offer = [&](const Box& a, const Box& b) {
    if (!same(a, input.a) || !same(b, input.b)) all.push_back(made(a, b));
  };
  Box a = input.a, b = input.b;
  a.frame.origin -= b.frame.origin;
  a.displacement -= b.displacement;
  b.frame.origin = b.displacement = Vector::Zero();
  offer(a, b);
  for (const int bits : {0, 2, 4, 8, 16, 24}) {
    const auto shorter = [bits](const Box& box) {
      const auto each = [bits](const Vector& v) {
        return Vector(v.unaryExpr(
            [bits](double x) { return std::ldexp(std::round(std::ldexp(x, bits)), -bits) + 0.0; }));
      };
      Box to = box;
      to.frame.origin = each(box.frame.origin);
      to.displacement = each(box.displacement);
      const Vector half = each(box.half_lengths);
      if (half.minCoeff() > 0) to.half_lengths = half;
      return to;
    };
    offer(shorter(input.a), shorter(input.b));
  }
  return all;
}

/// Orthonormal columns, up to rounding.
inline contact::Matrix3<double> turned(generators::Random& random) {
  const Vector axis = families::in_box(random, 3);
  return contact::matrix_of(contact::normalised(contact::exponential<double>(axis)));
}

inline Box any_box(generators::Random& random) {
  Box box;
  box.frame.origin = families::in_box(random, 3);
  box.frame.axes = turned(random);
  box.half_lengths = families::in_box(random, 1).cwiseAbs() + Vector::Constant(0.05);
  box.displacement = families::in_box(random, 3);
  return box;
}

inline Input random(generators::Random& random) {
  const Box a = any_box(random);
  Box b = any_box(random);
  if (random.chance(0.5)) b.displacement = a.displacement + (a.frame.origin - b.frame.origin);
  return made(a, b);
}

/// Axis-aligned, on whole numbers: faces that slide along each other, edges that meet.
inline Input whole(generators::Random& random) {
  const auto any = [&random] {
    Box box;
    box.frame.origin = families::whole_in_box(random, 3);
    box.half_lengths = families::whole_in_box(random, 1).cwiseAbs() + Vector::Ones();
    box.displacement = families::whole_in_box(random, 4);
    return box;
  };
  const Box a = any();
  return made(a, any());
}

/// Turned alike to about 2^-30, so that edges are nearly parallel.
inline Input nearly_parallel(generators::Random& random) {
  const Box a = any_box(random);
  Box b = any_box(random);
  const Vector by = std::ldexp(1.0, -30) * families::in_box(random, 1);
  const auto slightly = contact::matrix_of(contact::normalised(contact::exponential<double>(by)));
  b.frame.axes = slightly * a.frame.axes;
  return made(a, b);
}

/// A bullet of 2 cm and a plate of 1 cm.
inline Input bullet(generators::Random& random) {
  Box plate, shot = any_box(random);
  plate.half_lengths = {5, 5, 0.005};
  shot.half_lengths = {0.01, 0.01, 0.02};
  shot.frame.origin.z() = random.uniform(1, 20);
  shot.displacement.z() = -random.uniform(5, 900);
  return made(plate, shot);
}

/// Cut off where they touch, so that they do so at the end of the step, up to rounding.
inline Input last_moment(generators::Random& random) {
  Input input = measured_boxes::random(random);
  const Answer touch = truth(input);
  if (!touch.hit || touch.t == 0) return input;
  input.a.displacement *= touch.t;
  input.b.displacement *= touch.t;
  return made(input.a, input.b);
}

/// One face on another at the start, axis-aligned, or a few ulps from it.
inline Input start_in_touch(generators::Random& random) {
  Box a, b;
  a.half_lengths = families::in_box(random, 1).cwiseAbs() + Vector::Constant(0.25);
  b.half_lengths = families::in_box(random, 1).cwiseAbs() + Vector::Constant(0.25);
  b.frame.origin = families::in_box(random, 0.4);
  const int k = random.integer(0, 2);
  b.frame.origin(k) =
      (a.half_lengths(k) + b.half_lengths(k)) * (1 + random.integer(-2, 2) * 0x1p-52);
  a.displacement = families::in_box(random, 0.5);
  b.displacement = families::in_box(random, 0.5);
  return made(a, b);
}

inline ladder::Ladder<Input, Answer> experiment() {
  ladder::Ladder<Input, Answer> ladder("When do two moving boxes meet?", truth, judge);
  ladder.family("box-random", "random", random);
  ladder.family("box-whole", "axis-aligned, on whole numbers", whole);
  ladder.family("box-parallel", "edges nearly parallel", nearly_parallel);
  ladder.family("box-bullet", "a bullet and a plate of 1 cm", bullet);
  ladder.family("box-start", "start in touch, to the last bit", start_in_touch);
  ladder.family("box-end", "touch at the end, to the last bit", last_moment);

  ladder.method(rounded("box-slices-3", "3 slices", "double"),
                [](const Input& input) { return sliced(input, 3); });
  ladder.method(rounded("box-slices-100", "100 slices", "double"),
                [](const Input& input) { return sliced(input, 100); });
  ladder.method(rounded("box-swept", "boxes of what both sweep", "double"), swept);
  ladder.method(rounded("box-sweep-float", "swept axes, rounded", "float"), [](const Input& input) {
    return sweep<float>(input.a_in_float, input.b_in_float);
  });
  ladder.method(rounded("box-sweep-double", "swept axes, rounded", "double"),
                [](const Input& input) { return sweep<double>(input.a, input.b); });
  ladder.method(rounded("box-advance", "conservative advancement to 0.1 mm", "double"), advanced);
  ladder.method(exact("box-proven", "ray cast with a proof, for all bodies"), proven);
  ladder.method(exact("box-exact", "swept axes: filter, then exact"), exactly);
  ladder.recommend("box-exact");
  ladder.show(shown);
  ladder.simplify(simpler);
  return ladder;
}

}  // namespace measured_boxes
