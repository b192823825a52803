// Recomputes the answers of hard_cases.json and says which method gets which case right.
//
// Decisions and times of boxes and planes are rational in the stored numbers (class (a)). Times of
// balls have one square root (class (b)), those of moving vertices and edges are roots of a
// polynomial, that of a turning rod has an arcsine (class (c)). A decision is right or wrong. A
// time may have a relative error of 2^-40, that of boxes an error of 2^-40 of the step; a method
// that gives bounds is right if they contain the time.
#include "support/hard_cases.hpp"

#include <cmath>
#include <contact/ballistic_impact.hpp>
#include <contact/box_sweep.hpp>
#include <contact/quadratic_roots.hpp>
#include <contact/sliced_steps.hpp>
#include <contact/sphere_capsule_impact.hpp>
#include <contact/sphere_sphere_impact.hpp>
#include <optional>
#include <string>
#include <vector>

#include "boxes.hpp"
#include "hard_moving.hpp"
#include "hard_steps.hpp"

using hard_cases::Case;
using hard_cases::Json;
using hard_cases::unhex;
using oracle::Quadratic;
using oracle::Rational;
using oracle::Surd;

namespace {

using V = contact::Vector3<double>;
using Time = std::optional<double>;

/// "none", or the time as the nearest double.
Json answer_of(const std::optional<Surd>& t) {
  if (!t) return {{"class", "a"}, {"time", "none"}};
  return {{"class", "b"}, {"time", hard_cases::hex(oracle::nearest(*t))}};
}

bool right_time(const Time& got, const Json& answer) {
  if (answer.at("time") == "none") return !got;
  if (!got || !std::isfinite(*got)) return false;
  const double right = unhex(answer.at("time"));
  return std::abs(*got - right) <= std::ldexp(right, -40);
}

struct Balls {
  contact::Sphere<double> a, b;
  V va, vb;
};
Balls read_balls(const Case& c) {
  return {c.sphere("a"), c.sphere("b"), c.vector("velocity_a"), c.vector("velocity_b")};
}

void add_balls(hard_cases::Runner& runner) {
  runner.question("balls", [](const Case& c) {
    const Balls p = read_balls(c);
    const oracle::Vector d = oracle::exact(p.a.centre) - oracle::exact(p.b.centre);
    const oracle::Vector w = oracle::exact(p.va) - oracle::exact(p.vb);
    const Rational radius_sum = oracle::exact(p.a.radius) + oracle::exact(p.b.radius);
    const Quadratic q{w.dot(w), 2 * d.dot(w), d.dot(d) - radius_sum * radius_sum};
    if (!(q.b < 0)) return answer_of(std::nullopt);
    if (q.c <= 0) return answer_of(Surd{});
    if (q.discriminant() < 0) return answer_of(std::nullopt);
    return answer_of(q.roots().front());
  });
  const auto method = [&runner](const char* name, auto when) {
    runner.method("balls", name, [when](const Case& c, const Json& answer) {
      return right_time(when(read_balls(c)), answer);
    });
  };
  const auto overlap_at = [](const Balls& p, double t) {
    const V d = (p.a.centre + p.va * t) - (p.b.centre + p.vb * t);
    const double radius_sum = p.a.radius + p.b.radius;
    return d.dot(d) <= radius_sum * radius_sum;
  };
  method("slices of 1/60 s, last free state", [overlap_at](const Balls& p) -> Time {
    const auto seen =
        contact::sliced_step<double>([&](double t) { return overlap_at(p, t); }, 10.0, 600);
    return seen ? Time(seen->free) : std::nullopt;
  });
  method("slices, then bisection", [overlap_at](const Balls& p) -> Time {
    const auto overlap = [&](double t) { return overlap_at(p, t); };
    const auto seen = contact::sliced_step<double>(overlap, 10.0, 600);
    if (!seen) return std::nullopt;
    return contact::bisect_impact<double>(overlap, *seen, 60).hit;
  });
  method("school formula", [](const Balls& p) -> Time {
    const V d = p.a.centre - p.b.centre;
    const V w = p.va - p.vb;
    const double radius_sum = p.a.radius + p.b.radius;
    const double b = 2 * d.dot(w);
    const double c = d.dot(d) - radius_sum * radius_sum;
    if (!(b < 0)) return std::nullopt;
    if (c <= 0) return 0.0;
    const double discriminant = b * b - 4 * w.dot(w) * c;
    if (discriminant < 0) return std::nullopt;
    return (-b - std::sqrt(discriminant)) / (2 * w.dot(w));
  });
  method("quadratic_roots of rounded coefficients", [](const Balls& p) -> Time {
    const V d = p.a.centre - p.b.centre;
    const V w = p.va - p.vb;
    const double radius_sum = p.a.radius + p.b.radius;
    const double b = 2 * d.dot(w);
    const double c = d.dot(d) - radius_sum * radius_sum;
    if (!(b < 0)) return std::nullopt;
    if (c <= 0) return 0.0;
    const auto roots = contact::quadratic_roots(w.dot(w), b, c);
    return roots.count > 0 ? Time(roots.low) : std::nullopt;
  });
  method("book",
         [](const Balls& p) { return contact::sphere_sphere_impact(p.a, p.va, p.b, p.vb); });
}

void add_fall(hard_cases::Runner& runner) {
  runner.question("fall", [](const Case& c) {
    const auto ball = oracle::exact(c.sphere("ball"));
    const auto plane = oracle::exact(c.plane("plane"));
    const Rational gap = plane.normal.dot(ball.centre) - plane.offset - ball.radius;
    const Rational rate = plane.normal.dot(oracle::exact(c.vector("velocity")));
    const Rational bend = plane.normal.dot(oracle::exact(c.vector("gravity")));
    if (gap <= 0 && (rate < 0 || (rate == 0 && bend < 0))) return answer_of(Surd{});
    if (rate == 0 && bend == 0) return answer_of(std::nullopt);
    if (bend < 0 && rate * rate <= 2 * bend * gap) return answer_of(Surd{-rate / bend});
    for (const Surd& root : Quadratic{bend / 2, rate, gap}.roots()) {
      const int slope = oracle::sign(root * bend + rate);
      if (oracle::sign(root) > 0 && (slope < 0 || (slope == 0 && bend > 0))) return answer_of(root);
    }
    return answer_of(std::nullopt);
  });
  const auto method = [&runner](const char* name, auto when) {
    runner.method("fall", name, [when](const Case& c, const Json& answer) {
      return right_time(
          when(c.sphere("ball"), c.vector("velocity"), c.vector("gravity"), c.plane("plane")),
          answer);
    });
  };
  using Ball = contact::Sphere<double>;
  using Plane = contact::Plane<double>;
  struct Terms {
    double gap, rate, bend;
  };
  const auto terms = [](const Ball& ball, const V& v, const V& g, const Plane& plane) {
    return Terms{plane.normal.dot(ball.centre) - plane.offset - ball.radius, plane.normal.dot(v),
                 plane.normal.dot(g)};
  };
  method("straight ahead, without gravity",
         [terms](const Ball& ball, const V& v, const V& g, const Plane& plane) -> Time {
           const Terms f = terms(ball, v, g, plane);
           if (!(f.rate < 0)) return std::nullopt;
           return f.gap <= 0 ? 0.0 : f.gap / -f.rate;
         });
  method("steps of 1/60 s",
         [terms](const Ball& ball, const V& v, const V& g, const Plane& plane) -> Time {
           const Terms f = terms(ball, v, g, plane);
           const auto under = [&](double t) { return f.gap + (f.rate + f.bend * t / 2) * t <= 0; };
           const auto seen = contact::sliced_step<double>(under, 10.0, 600);
           if (!seen) return std::nullopt;
           return contact::bisect_impact<double>(under, *seen, 60).hit;
         });
  method("school formula",
         [terms](const Ball& ball, const V& v, const V& g, const Plane& plane) -> Time {
           const Terms f = terms(ball, v, g, plane);
           if (f.gap <= 0 && f.rate < 0) return 0.0;
           const double discriminant = f.rate * f.rate - 2 * f.bend * f.gap;
           if (discriminant < 0) return std::nullopt;
           const double t = (-f.rate - std::sqrt(discriminant)) / f.bend;
           return t > 0 ? Time(t) : std::nullopt;
         });
  method("book", [](const Ball& ball, const V& v, const V& g, const Plane& plane) {
    return contact::ballistic_impact(ball, v, g, plane);
  });
}

boxes::Box read_box(const Case& c, const std::string& name) {
  boxes::Box box;
  box.frame.origin = c.vector(name + "_centre");
  box.half_lengths = c.vector(name + "_half_lengths");
  box.displacement = c.vector(name + "_displacement");
  if (c.has(name + "_axes")) {
    const std::vector<double> n = c.numbers(name + "_axes");
    for (int k = 0; k < 3; ++k) {
      for (int i = 0; i < 3; ++i) {
        box.frame.axes(i, k) = n.at(3 * static_cast<std::size_t>(k) + static_cast<std::size_t>(i));
      }
    }
  }
  return box;
}

void add_boxes(hard_cases::Runner& runner) {
  runner.question("boxes", [](const Case& c) {
    const auto touch = boxes::first_touch(read_box(c, "a"), read_box(c, "b"));
    if (!touch) return Json{{"class", "a"}, {"time", "none"}};
    return Json{{"class", "a"}, {"time", hard_cases::hex(oracle::nearest(*touch))}};
  });
  const auto method = [&runner](const char* name, auto when) {
    runner.method("boxes", name, [when](const Case& c, const Json& answer) {
      const Time got = when(read_box(c, "a"), read_box(c, "b"));
      if (answer.at("time") == "none") return !got;
      return got && std::abs(*got - unhex(answer.at("time"))) <= 0x1p-40;
    });
  };
  using Box = boxes::Box;
  method("where they end", [](const Box& a, const Box& b) -> Time {
    Box end_a = a;
    Box end_b = b;
    end_a.frame.origin += a.displacement;
    end_b.frame.origin += b.displacement;
    end_a.displacement = end_b.displacement = V(0, 0, 0);
    return contact::box_impact(end_a, end_b) ? Time(1) : std::nullopt;
  });
  method("a hundred slices", [](const Box& a, const Box& b) -> Time {
    const auto overlap = [&](double t) {
      Box at_a = a;
      Box at_b = b;
      at_a.frame.origin += a.displacement * t;
      at_b.frame.origin += b.displacement * t;
      at_a.displacement = at_b.displacement = V(0, 0, 0);
      return contact::box_impact(at_a, at_b).has_value();
    };
    const auto seen = contact::sliced_step<double>(overlap, 1.0, 100);
    if (!seen) return std::nullopt;
    return contact::bisect_impact<double>(overlap, *seen, 60).hit;
  });
  const auto swept = [](const Box& a, const Box& b, std::size_t axes) -> Time {
    const auto pair = contact::detail::rounded_pair(a, b);
    const auto all = contact::separating_axes(pair.u, pair.v);
    double from = 0;
    double to = 1;
    for (std::size_t k = 0; k < axes; ++k) {
      const auto times = pair.times(all[k]);
      const double speed = std::abs(times.speed);
      if (speed == 0) {
        if (std::abs(times.distance) > times.radius_sum) return std::nullopt;
        continue;
      }
      from = std::max(from, times.begins() / speed);
      to = std::min(to, times.ends() / speed);
    }
    return from <= to ? Time(from) : std::nullopt;
  };
  method("six face axes", [swept](const Box& a, const Box& b) { return swept(a, b, 6); });
  method("fifteen axes, rounded", [swept](const Box& a, const Box& b) { return swept(a, b, 15); });
  method("book", [](const Box& a, const Box& b) -> Time {
    const auto touch = contact::box_impact(a, b);
    return touch ? Time(touch->t) : std::nullopt;
  });
}

void add_capsule(hard_cases::Runner& runner) {
  // Three quadratics: the side, and a ball at each end. The first root at which the distance of the
  // centre from the segment is at most the sum of the radii.
  runner.question("capsule", [](const Case& c) {
    const auto ball = oracle::exact(c.sphere("ball"));
    const oracle::Vector w = oracle::exact(c.vector("displacement"));
    const auto axis = c.segment("axis");
    const oracle::Vector m = ball.centre - oracle::exact(axis.start);
    const oracle::Vector e = oracle::exact(axis.end) - oracle::exact(axis.start);
    const Rational radius_sum = ball.radius + oracle::exact(c.number("radius"));
    const Rational ee = e.dot(e);
    const Rational along = m.dot(e);
    const auto square = [](const oracle::Vector& v) { return Rational(v.dot(v)); };
    const Rational here = along <= 0    ? square(m)
                          : along >= ee ? square(oracle::Vector(m - e))
                                        : Rational(square(m) - along * along / ee);
    if (here <= radius_sum * radius_sum) return answer_of(Surd{});
    std::optional<Surd> first;
    const auto note = [&first](const Surd& t) {
      if (oracle::sign(t) < 0 || oracle::compare(t, Surd{Rational(1)}) > 0) return;
      if (!first || oracle::compare(t, *first) < 0) first = t;
    };
    for (const oracle::Vector& from : {m, oracle::Vector(m - e)}) {
      const Quadratic q{square(w), 2 * from.dot(w), square(from) - radius_sum * radius_sum};
      if (q.a != 0 && q.discriminant() >= 0) note(q.roots().front());
    }
    const oracle::Vector across = m.cross(e);
    const oracle::Vector moved = w.cross(e);
    const Quadratic side{square(moved), 2 * across.dot(moved),
                         square(across) - radius_sum * radius_sum * ee};
    if (side.a != 0 && side.discriminant() >= 0) {
      const Surd t = side.roots().front();
      const Surd position = t * Rational(w.dot(e)) + along;
      if (oracle::sign(position) >= 0 && oracle::sign(position + Rational(-ee)) <= 0) note(t);
    }
    return answer_of(first);
  });
  const auto method = [&runner](const char* name, auto when) {
    runner.method("capsule", name, [when](const Case& c, const Json& answer) {
      return right_time(
          when(c.sphere("ball"), c.vector("displacement"), c.segment("axis"), c.number("radius")),
          answer);
    });
  };
  using Ball = contact::Sphere<double>;
  using Line = contact::Segment<double>;
  method("both ends only", [](const Ball& ball, const V& way, const Line& axis, double r) -> Time {
    Time first;
    for (const V& end : {axis.start, axis.end}) {
      const auto t = contact::sphere_sphere_impact<double>(ball, way, {end, r}, V(0, 0, 0));
      if (t && *t <= 1 && (!first || *t < *first)) first = t;
    }
    return first;
  });
  method("a line without ends",
         [](const Ball& ball, const V& way, const Line& axis, double r) -> Time {
           const V e = axis.end - axis.start;
           const V across = V(ball.centre - axis.start).cross(e);
           const V moved = way.cross(e);
           const double radius_sum = ball.radius + r;
           const auto roots =
               contact::quadratic_roots(moved.dot(moved), 2 * across.dot(moved),
                                        across.dot(across) - radius_sum * radius_sum * e.dot(e));
           if (roots.count == 0 || roots.low < 0 || roots.low > 1) return std::nullopt;
           return roots.low;
         });
  method("a hundred slices",
         [](const Ball& ball, const V& way, const Line& axis, double r) -> Time {
           const auto overlap = [&](double t) {
             const V m = ball.centre + way * t - axis.start;
             const V e = axis.end - axis.start;
             const double ee = e.dot(e);
             const double s = ee > 0 ? std::min(1.0, std::max(0.0, m.dot(e) / ee)) : 0.0;
             const V d = m - e * s;
             return d.dot(d) <= (ball.radius + r) * (ball.radius + r);
           };
           const auto seen = contact::sliced_step<double>(overlap, 1.0, 100);
           if (!seen) return std::nullopt;
           return contact::bisect_impact<double>(overlap, *seen, 60).hit;
         });
  method("book", [](const Ball& ball, const V& way, const Line& axis, double r) {
    return contact::sphere_capsule_impact(ball, way, axis, r);
  });
}

}  // namespace

int main(int argc, char** argv) {
  hard_cases::Runner runner("11_time_of_impact");
  add_balls(runner);
  add_fall(runner);
  add_boxes(runner);
  add_capsule(runner);
  hard_steps::add_plane(runner);
  hard_steps::add_balls(runner);
  hard_steps::add_corner(runner);
  hard_steps::add_rod(runner);
  hard_moving::add(runner, "vertex-face", false);
  hard_moving::add(runner, "edge-edge", true);
  return runner.run(argc, argv);
}
