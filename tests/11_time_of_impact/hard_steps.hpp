/// @file
/// Spheres, planes, boxes and a rod in a step: right answers, and methods as they are often
/// written.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <contact/bisection.hpp>
#include <contact/conservative_advancement.hpp>
#include <contact/moving_spheres.hpp>
#include <contact/offset_plane.hpp>
#include <contact/oriented_box.hpp>
#include <contact/previous_free_state.hpp>
#include <contact/sliced_steps.hpp>
#include <contact/swept_volumes.hpp>
#include <contact/translating_impact.hpp>
#include <contact/turning_impact.hpp>
#include <limits>
#include <optional>

#include "support/hard_cases.hpp"

namespace hard_steps {

using hard_cases::Case;
using hard_cases::Json;
using hard_cases::unhex;
using oracle::Interval;
using oracle::Quadratic;
using oracle::Rational;
using oracle::Surd;
using V = contact::Vector3<double>;
using Time = std::optional<double>;

/// "none", or the time as the nearest double.
inline Json answer_of(const std::optional<Surd>& t) {
  if (!t) return {{"class", "a"}, {"time", "none"}};
  return {{"class", "b"}, {"time", hard_cases::hex(oracle::nearest(*t))}};
}
inline Json answer_of(const std::optional<Rational>& t) {
  if (!t) return {{"class", "a"}, {"time", "none"}};
  return {{"class", "a"}, {"time", hard_cases::hex(oracle::nearest(*t))}};
}

/// A decision is right or wrong; a time may be off by 2^-40 of itself, and −0 is wrong.
inline bool right_time(const Time& got, const Json& answer) {
  if (answer.at("time") == "none") return !got;
  if (!got || !std::isfinite(*got) || std::signbit(*got)) return false;
  const double right = unhex(answer.at("time"));
  return std::abs(*got - right) <= std::ldexp(right, -40);
}
/// The same for bounds of a time that contain it, at most 2^-38 of it apart.
inline bool right_bounds(bool meets, double t, double t_high, const Json& answer) {
  if (answer.at("time") == "none") return !meets;
  if (!meets || std::signbit(t)) return false;
  const double right = unhex(answer.at("time"));
  const double next = std::nextafter(t, 1.0);
  return t <= right && right <= t_high && (t_high <= next || t_high - t <= std::ldexp(right, -38));
}

/// Where an overlap is found by tests at the ends of slices, and then by bisection.
template <class Overlap>
Time sliced(const Overlap& overlap, int slices, int halvings) {
  const auto bracket = contact::sliced_step<double>(overlap, 1.0, slices);
  if (!bracket) return std::nullopt;
  return contact::bisect_impact<double>(overlap, *bracket, halvings).hit;
}
/// The previous free state: its time, if an overlap was found.
template <class Overlap>
Time put_back(const Overlap& overlap, int slices) {
  const auto state = contact::previous_free_state<double>(overlap, slices);
  return state.hit ? Time(state.t) : std::nullopt;
}
/// Bisection between start and end, if only the end overlaps.
template <class Overlap>
Time bisected(const Overlap& overlap) {
  if (!overlap(1.0)) return std::nullopt;
  if (overlap(0.0)) return 0.0;
  return contact::bisect_impact<double>(overlap, {0.0, 1.0}, 60).hit;
}

struct PlaneStep {
  contact::Sphere<double> sphere;
  V displacement;
  contact::Plane<double> plane;

  double distance_at(double t) const {
    return plane.normal.dot(V(sphere.centre + displacement * t)) - plane.offset;
  }
  double change() const { return plane.normal.dot(displacement); }
  bool overlaps_at(double t) const { return std::abs(distance_at(t)) <= sphere.radius; }
};

/// A sphere against a plane that it can touch from both sides.
inline void add_plane(hard_cases::Runner& runner) {
  const auto read = [](const Case& c) {
    return PlaneStep{c.sphere("sphere"), c.vector("displacement"), c.plane("plane")};
  };
  runner.question("plane", [](const Case& c) {
    const auto sphere = oracle::exact(c.sphere("sphere"));
    const auto plane = oracle::exact(c.plane("plane"));
    const Rational d = plane.normal.dot(sphere.centre) - plane.offset;
    const Rational change = plane.normal.dot(oracle::exact(c.vector("displacement")));
    const Rational gap = (d < 0 ? Rational(-d) : d) - sphere.radius;
    const Rational closing = d < 0 ? change : Rational(-change);
    std::optional<Rational> t;
    if (gap <= 0) {
      t = 0;
    } else if (closing >= gap) {
      t = gap / closing;
    }
    return answer_of(t);
  });
  const auto method = [&runner, read](const char* name, auto when) {
    runner.method("plane", name, [read, when](const Case& c, const Json& answer) {
      return right_time(when(read(c)), answer);
    });
  };
  method("where it ends", [](const PlaneStep& p) -> Time {
    if (p.overlaps_at(0)) return 0.0;
    return p.overlaps_at(1) ? Time(1) : std::nullopt;
  });
  method("slices 0, 1/3, 2/3, 1, put back", [](const PlaneStep& p) {
    return put_back([&](double t) { return p.overlaps_at(t); }, 3);
  });
  method("a hundred slices, then bisection", [](const PlaneStep& p) {
    return sliced([&](double t) { return p.overlaps_at(t); }, 100, 60);
  });
  method("bisection of the step",
         [](const PlaneStep& p) { return bisected([&](double t) { return p.overlaps_at(t); }); });
  method("centre against the plane", [](const PlaneStep& p) -> Time {
    const double t = -p.distance_at(0) / p.change();
    return t >= 0 && t <= 1 ? Time(t) : std::nullopt;
  });
  method("in front of the plane only", [](const PlaneStep& p) -> Time {
    const double t = (p.sphere.radius - p.distance_at(0)) / p.change();
    return t >= 0 && t <= 1 ? Time(t) : std::nullopt;
  });
  method("sign of the approach first", [](const PlaneStep& p) -> Time {
    const double d = p.distance_at(0), closing = d < 0 ? p.change() : -p.change();
    if (!(closing > 0)) return std::nullopt;
    const double t = (std::abs(d) - p.sphere.radius) / closing;
    return t <= 1 ? Time(std::max(0.0, t)) : std::nullopt;
  });
  method("quotient, rounded", [](const PlaneStep& p) -> Time {
    const double d = p.distance_at(0), closing = d < 0 ? p.change() : -p.change();
    const double gap = std::abs(d) - p.sphere.radius;
    if (gap <= 0) return 0.0;
    const double t = gap / closing;
    return t >= 0 && t <= 1 ? Time(t) : std::nullopt;
  });
  method("book", [](const PlaneStep& p) -> Time {
    const auto hit = contact::sphere_plane_impact(p.sphere, p.displacement, p.plane);
    return hit ? Time(hit->t) : std::nullopt;
  });
}

struct BallStep {
  contact::Sphere<double> a, b;
  V displacement_a, displacement_b;

  template <class S>
  bool overlaps_at(S t) const {
    const contact::Vector3<S> d = (a.centre.cast<S>() + displacement_a.cast<S>() * t) -
                                  (b.centre.cast<S>() + displacement_b.cast<S>() * t);
    const S reach = static_cast<S>(a.radius) + static_cast<S>(b.radius);
    return d.dot(d) <= reach * reach;
  }
};

/// The textbook's quadratic, in float or double.
template <class S>
Time textbook_quadratic(const BallStep& p) {
  const contact::Vector3<S> d = p.a.centre.cast<S>() - p.b.centre.cast<S>();
  const contact::Vector3<S> w = p.displacement_a.cast<S>() - p.displacement_b.cast<S>();
  const S reach = static_cast<S>(p.a.radius) + static_cast<S>(p.b.radius);
  const S c = d.dot(d) - reach * reach, b = d.dot(w), a = w.dot(w);
  if (c <= S(0)) return 0.0;
  const S discriminant = b * b - a * c;
  if (discriminant < S(0)) return std::nullopt;
  const S t = (-b - std::sqrt(discriminant)) / a;
  return t >= S(0) && t <= S(1) ? Time(double(t)) : std::nullopt;
}

/// Two spheres in a step: 0 if they meet at the start, whatever their displacements.
inline void add_balls(hard_cases::Runner& runner) {
  const auto read = [](const Case& c) {
    return BallStep{c.sphere("a"), c.sphere("b"), c.vector("displacement_a"),
                    c.vector("displacement_b")};
  };
  runner.question("balls in a step", [read](const Case& c) {
    const BallStep p = read(c);
    const oracle::Vector d = oracle::exact(p.a.centre) - oracle::exact(p.b.centre);
    const oracle::Vector w = oracle::exact(p.displacement_a) - oracle::exact(p.displacement_b);
    const Rational reach = oracle::exact(p.a.radius) + oracle::exact(p.b.radius);
    const Quadratic q{w.dot(w), 2 * d.dot(w), d.dot(d) - reach * reach};
    if (q.c <= 0) return answer_of(std::optional<Surd>(Surd{}));
    if (!(q.b < 0) || q.discriminant() < 0) return answer_of(std::optional<Surd>());
    const Surd t = q.roots().front();
    if (oracle::compare(t, Surd{Rational(1)}) > 0) return answer_of(std::optional<Surd>());
    return answer_of(std::optional<Surd>(t));
  });
  const auto method = [&runner, read](const char* name, auto when) {
    runner.method("balls in a step", name, [read, when](const Case& c, const Json& answer) {
      return right_time(when(read(c)), answer);
    });
  };
  method("where they end", [](const BallStep& p) -> Time {
    if (p.overlaps_at(0.0)) return 0.0;
    return p.overlaps_at(1.0) ? Time(1) : std::nullopt;
  });
  method("slices 0, 1/3, 2/3, 1, put back",
         [](const BallStep& p) { return put_back([&](double t) { return p.overlaps_at(t); }, 3); });
  method("a hundred slices, then bisection", [](const BallStep& p) {
    return sliced([&](double t) { return p.overlaps_at(t); }, 100, 60);
  });
  method("bisection of the step",
         [](const BallStep& p) { return bisected([&](double t) { return p.overlaps_at(t); }); });
  method("swept volumes", [](const BallStep& p) -> Time {
    if (!contact::swept_spheres_meet(p.a, p.displacement_a, p.b, p.displacement_b))
      return std::nullopt;
    return sliced([&](double t) { return p.overlaps_at(t); }, 100, 60).value_or(1);
  });
  method("approach of the centres first", [](const BallStep& p) -> Time {
    const V d = p.a.centre - p.b.centre;
    if (!(d.dot(V(p.displacement_a - p.displacement_b)) < 0)) return std::nullopt;
    return textbook_quadratic<double>(p);
  });
  method("textbook formula, float", textbook_quadratic<float>);
  method("textbook formula, double", textbook_quadratic<double>);
  method("book", [](const BallStep& p) {
    return contact::moving_spheres_impact(p.a, p.displacement_a, p.b, p.displacement_b);
  });
  runner.method("balls in a step", "book: bodies of any kind",
                [read](const Case& c, const Json& answer) {
                  const BallStep p = read(c);
                  const auto found =
                      contact::translating_impact(p.a, p.displacement_a, p.b, p.displacement_b);
                  return right_bounds(found.meets, found.t, found.t_high, answer);
                });
}

struct CornerStep {
  contact::Sphere<double> ball;
  V displacement;
  V centre, half_lengths;  ///< of the box, along the axes

  bool overlaps_at(double t) const {
    const V from = (ball.centre + displacement * t - centre).cwiseAbs() - half_lengths;
    const V outside = from.cwiseMax(V::Zero());
    return outside.dot(outside) <= ball.radius * ball.radius;
  }
};

/// The first time in [0, 1] at which a point that moves is in a box with the given half lengths.
inline std::optional<Rational> enters_box(const oracle::Vector& m, const oracle::Vector& w,
                                          const oracle::Vector& half) {
  Rational from = 0, to = 1;
  for (int k = 0; k < 3; ++k) {
    if (w(k) == 0) {
      if (m(k) > half(k) || m(k) < -half(k)) return std::nullopt;
      continue;
    }
    const Rational one = (half(k) - m(k)) / w(k), other = (-half(k) - m(k)) / w(k);
    from = std::max(from, std::min(one, other));
    to = std::min(to, std::max(one, other));
  }
  return from <= to ? std::optional<Rational>(from) : std::nullopt;
}

/// The rounded box of the centre is three boxes and the capsules of twelve edges: the first time at
/// which it enters one of them.
inline std::optional<Surd> first_in_rounded_box(const oracle::Vector& m, const oracle::Vector& w,
                                                const oracle::Vector& half, const Rational& r) {
  std::optional<Surd> first;
  const auto note = [&first](const Surd& t) {
    if (oracle::sign(t) < 0 || oracle::compare(t, Surd{Rational(1)}) > 0) return;
    if (!first || oracle::compare(t, *first) < 0) first = t;
  };
  for (int k = 0; k < 3; ++k) {
    oracle::Vector longer = half;
    longer(k) = half(k) + r;
    if (const auto t = enters_box(m, w, longer)) note(Surd{*t});
  }
  for (int axis = 0; axis < 3; ++axis) {
    const int y = (axis + 1) % 3, z = (axis + 2) % 3;
    for (int corner = 0; corner < 4; ++corner) {
      const Rational my = m(y) - (corner % 2 == 0 ? half(y) : Rational(-half(y)));
      const Rational mz = m(z) - (corner / 2 == 0 ? half(z) : Rational(-half(z)));
      // The side of the cylinder between the ends of the edge.
      const Quadratic side{w(y) * w(y) + w(z) * w(z), 2 * (my * w(y) + mz * w(z)),
                           my * my + mz * mz - r * r};
      if (side.a != 0 && side.discriminant() >= 0) {
        const Surd t = side.roots().front();
        const Surd at = t * w(axis) + m(axis);
        if (oracle::sign(at + half(axis)) >= 0 && oracle::sign(at + Rational(-half(axis))) <= 0)
          note(t);
      }
      for (const int end : {-1, 1}) {
        const Rational mx = m(axis) + (end < 0 ? half(axis) : Rational(-half(axis)));
        const Quadratic ball{w.dot(w), 2 * (mx * w(axis) + my * w(y) + mz * w(z)),
                             mx * mx + my * my + mz * mz - r * r};
        if (ball.c <= 0) note(Surd{});
        if (ball.a != 0 && ball.discriminant() >= 0) note(ball.roots().front());
      }
      if (my * my + mz * mz <= r * r && m(axis) <= half(axis) && m(axis) >= -half(axis))
        note(Surd{});
    }
  }
  return first;
}

/// A ball against a box at rest, along the axes: faces, edges and corners.
inline void add_corner(hard_cases::Runner& runner) {
  const auto read = [](const Case& c) {
    return CornerStep{c.sphere("ball"), c.vector("displacement"), c.vector("box_centre"),
                      c.vector("box_half_lengths")};
  };
  runner.question("ball and box", [read](const Case& c) {
    const CornerStep p = read(c);
    return answer_of(
        first_in_rounded_box(oracle::Vector(oracle::exact(p.ball.centre) - oracle::exact(p.centre)),
                             oracle::exact(p.displacement), oracle::exact(p.half_lengths),
                             oracle::exact(p.ball.radius)));
  });
  const auto method = [&runner, read](const char* name, auto when) {
    runner.method("ball and box", name, [read, when](const Case& c, const Json& answer) {
      return right_time(when(read(c)), answer);
    });
  };
  const auto slab = [](const CornerStep& p, double margin) -> Time {
    double from = 0, to = 1;
    for (int k = 0; k < 3; ++k) {
      const double m = p.ball.centre(k) - p.centre(k), h = p.half_lengths(k) + margin;
      const double one = (h - m) / p.displacement(k), other = (-h - m) / p.displacement(k);
      from = std::max(from, std::min(one, other));
      to = std::min(to, std::max(one, other));
    }
    return from <= to ? Time(from) : std::nullopt;
  };
  method("centre against the box", [slab](const CornerStep& p) -> Time { return slab(p, 0); });
  method("centre against a larger box",
         [slab](const CornerStep& p) -> Time { return slab(p, p.ball.radius); });
  method("where it ends", [](const CornerStep& p) -> Time {
    if (p.overlaps_at(0)) return 0.0;
    return p.overlaps_at(1) ? Time(1) : std::nullopt;
  });
  method("a hundred slices, then bisection", [](const CornerStep& p) {
    return sliced([&](double t) { return p.overlaps_at(t); }, 100, 60);
  });
  method("until the advance is below 1e-4", [](const CornerStep& p) -> Time {
    // Advances by the distance over the approach along its direction; an approach that is too slow
    // for the rest of the step ends it, although the direction changes.
    double t = 0;
    for (int i = 0; i < 20; ++i) {
      const V at = p.ball.centre + p.displacement * t - p.centre;
      const V out = at - at.cwiseMin(p.half_lengths).cwiseMax(-p.half_lengths);
      const double gap = out.norm() - p.ball.radius;
      if (gap <= 1e-4) return t;
      const double approach = -p.displacement.dot(out) / out.norm();
      if (approach <= gap) return std::nullopt;
      t += gap / approach;
      if (t > 1) return std::nullopt;
    }
    return t;
  });
  runner.method("ball and box", "book", [read](const Case& c, const Json& answer) {
    const CornerStep p = read(c);
    const contact::OrientedBox<double> box{p.centre, contact::Matrix3<double>::Identity(),
                                           p.half_lengths};
    const auto found = contact::translating_impact(p.ball, p.displacement, box, V(V::Zero()));
    return right_bounds(found.meets, found.t, found.t_high, answer);
  });
}

/// A rod of half length L and half thickness e, level at the start, h above the floor, that turns
/// by an angle in the step about its centre at rest. An end is lowest at asin(h/R) − atan(e/L),
/// where R is half the diagonal.
struct RodStep {
  double half_length, half_thickness, height, angle;

  double gap_at(double t) const {
    const double turned = angle * t;
    return height - half_length * std::abs(std::sin(turned)) -
           half_thickness * std::abs(std::cos(turned));
  }
  bool overlaps_at(double t) const { return gap_at(t) <= 0; }
};

/// A rod that turns about its centre over a floor. The true time is transcendental; a method is
/// right if it decides rightly and gives a time that is not past the touch and at which the gap is
/// at most 2^-20 of the rod's length. Methods stop within 2^-24 of it.
inline void add_rod(hard_cases::Runner& runner) {
  const auto read = [](const Case& c) {
    return RodStep{c.number("half_length"), c.number("half_thickness"), c.number("height"),
                   c.number("angle")};
  };
  runner.question("turning rod", [read](const Case& c) {
    const RodStep p = read(c);
    const Rational length = oracle::exact(p.half_length), thin = oracle::exact(p.half_thickness);
    const Rational height = oracle::exact(p.height), angle = oracle::exact(std::abs(p.angle));
    if (height <= thin) return Json{{"class", "a"}, {"time", hard_cases::hex(0.0)}};
    if (height * height > length * length + thin * thin || angle == 0)
      return Json{{"class", "a"}, {"time", "none"}};
    const auto time = [&](unsigned bits) {
      const Interval radius = sqrt(Interval(length * length + thin * thin, bits));
      return (asin(Interval(height, bits) / radius) - atan(Interval(thin / length, bits))) /
             Interval(angle, bits);
    };
    const auto past = oracle::decide_sign(
        [&](unsigned bits) { return time(bits) - Interval(Rational(1), bits); });
    if (past.sign && *past.sign > 0) return Json{{"class", "c"}, {"time", "none"}};
    return Json{{"class", "c"},
                {"time", hard_cases::hex(oracle::nearest_value(time).value_or(-1))}};
  });
  const auto method = [&runner, read](const char* name, auto when) {
    runner.method("turning rod", name, [read, when](const Case& c, const Json& answer) {
      const RodStep p = read(c);
      const Time got = when(p);
      if (answer.at("time") == "none") return !got;
      if (!got || !(*got >= 0)) return false;
      return *got <= unhex(answer.at("time")) && p.gap_at(*got) <= std::ldexp(p.half_length, -20);
    });
  };
  /// Advances by the gap over a bound of the approach.
  const auto advance = [](const RodStep& p, double approach) -> Time {
    const auto found =
        contact::conservative_advancement<double>([&](double t) { return p.gap_at(t); }, approach,
                                                  1.0, std::ldexp(p.half_length, -24), 1000000);
    if (found.end == contact::ConservativeEnd::clear) return std::nullopt;
    return found.t;
  };
  method("where it ends",
         [](const RodStep& p) -> Time { return p.overlaps_at(1) ? Time(1) : std::nullopt; });
  method("six slices, then bisection", [](const RodStep& p) -> Time {
    const auto overlap = [&](double t) { return p.overlaps_at(t); };
    const auto bracket = contact::sliced_step<double>(overlap, 1.0, 6);
    if (!bracket) return std::nullopt;
    return contact::bisect_impact<double>(overlap, *bracket, 60).free;
  });
  method("bisection of the step", [](const RodStep& p) -> Time {
    if (!p.overlaps_at(1)) return std::nullopt;
    return contact::bisect_impact<double>([&](double t) { return p.overlaps_at(t); }, {0.0, 1.0},
                                          60)
        .free;
  });
  method("advance without the turning", [advance](const RodStep& p) { return advance(p, 0); });
  method("advance with half the length",
         [advance](const RodStep& p) { return advance(p, std::abs(p.angle) * p.half_length / 2); });
  method("ends on straight lines", [](const RodStep& p) -> Time {
    // The end of the rod goes straight from its first position to its last.
    const double down = p.half_length * std::abs(std::sin(p.angle));
    const double t = (p.height - p.half_thickness) / down;
    return t >= 0 && t <= 1 ? Time(t) : std::nullopt;
  });
  method("book", [](const RodStep& p) -> Time {
    contact::RotatingBox<double> rod;
    rod.position = V(0, 0, p.height);
    rod.half_lengths = V(p.half_length, p.half_thickness, p.half_thickness);
    rod.angular_velocity = V(0, p.angle, 0);
    const auto found = contact::rotating_box_plane_impact<double>(
        rod, {V(0, 0, 1), 0}, 1.0, std::ldexp(p.half_length, -24), 1000000);
    if (found.end == contact::ConservativeEnd::clear) return std::nullopt;
    return found.t;
  });
  method("book: bodies of any kind", [](const RodStep& p) -> Time {
    const V centre(0, 0, p.height), half(p.half_length, p.half_thickness, p.half_thickness);
    const contact::OrientedBox<double> rod{centre, contact::Matrix3<double>::Identity(), half};
    const auto found = contact::turning_impact<contact::OrientedBox<double>>(
        rod, contact::turning_motion<double>(centre, V(0, 0, 0), V(0, p.angle, 0)),
        contact::HalfSpace<double>{{V(0, 0, 1), 0}}, std::ldexp(p.half_length, -24), 1000000);
    if (found.end == contact::ConservativeEnd::clear) return std::nullopt;
    return found.t;
  });
}

}  // namespace hard_steps
