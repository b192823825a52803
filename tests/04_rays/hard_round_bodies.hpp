/// @file
/// The hard cases of cylinders, capsules, cones, moving balls and bullets: questions and methods.
#pragma once

#include <04_rays/bodies.hpp>
#include <cmath>
#include <contact/first_in_scene.hpp>
#include <optional>
#include <string>
#include <support/hard_cases.hpp>

namespace hard_round {

using bodies::Found;
using bodies::Line;
using bodies::Region;
using contact::Aabb;
using contact::BodyHit;
using contact::Capsule;
using contact::Cone;
using contact::Cylinder;
using contact::Passage;
using contact::Ray;
using contact::Segment;
using contact::Sphere;
using contact::Vector3;
using hard_cases::Case;
using hard_cases::Json;
using oracle::Rational;

// ---------------------------------------------------------------- input

template <class S>
Cylinder<S> cylinder_of(const Case& c) {
  return {generators::rounded<S>(c.segment("core")), static_cast<S>(c.number("radius"))};
}
template <class S>
Capsule<S> capsule_of(const Case& c) {
  return {generators::rounded<S>(c.segment("core")), static_cast<S>(c.number("radius"))};
}
template <class S>
Cone<S> cone_of(const Case& c) {
  return {generators::rounded<S>(c.vector("apex")), generators::rounded<S>(c.vector("base")),
          static_cast<S>(c.number("radius"))};
}
inline Aabb<double> box_of(const Case& c) { return {c.vector("low"), c.vector("high")}; }

inline bool is_segment(const Case& c) { return c.has("segment"); }
template <class S>
Ray<S> ray_of(const Case& c) {
  return is_segment(c) ? contact::ray_of(generators::rounded<S>(c.segment("segment")))
                       : generators::rounded<S>(c.ray("ray"));
}

/// Asks with the ray or the segment of a case.
template <class S, class Ask>
auto with_line(const Case& c, const Ask& ask) {
  return is_segment(c) ? ask(generators::rounded<S>(c.segment("segment")))
                       : ask(generators::rounded<S>(c.ray("ray")));
}

// ---------------------------------------------------------------- answers

inline Json answer_of(const std::vector<Region>& regions, bool has_end) {
  const bool met = bodies::meets(regions, has_end);
  Json answer{{"class", "b"}, {"hit", met}};
  if (!met) return answer;
  const Found found = bodies::find(regions);
  const bool inside = found.low_open || oracle::sign(found.low) < 0;
  if (inside) answer["inside"] = true;
  answer["t"] = hard_cases::hex(inside ? 0.0 : oracle::nearest(found.low));
  return answer;
}
inline Line line_of(const Case& c) {
  return with_line<double>(c, [](const auto& line) { return rays::exact_line(line); });
}

/// Right if the decision is, and t (0 if inside) so that the point is off by at most a thousandth
/// of the radius and, far away, 2^-50 of the distance.
template <class S>
bool right(const Case& c, const std::optional<S>& t, const Json& answer) {
  if (t.has_value() != answer.at("hit").get<bool>()) return false;
  if (!t) return true;
  const double exact = hard_cases::unhex(answer, "t");
  const double length = ray_of<double>(c).direction.cwiseAbs().maxCoeff();
  const double room = length > 0 ? 0x1p-10 * c.number("radius") / length : 0;
  return hard_cases::close(double(*t), exact, room + 0x1p-50 * std::abs(exact));
}
template <class S>
bool right(const Case& c, const std::optional<BodyHit<S>>& hit, const Json& answer) {
  if (hit && hit->inside != answer.contains("inside")) return false;
  return right(c, hit ? std::optional<S>(hit->t) : std::nullopt, answer);
}

// ---------------------------------------------------------------- methods as they are often
// written

template <class S>
std::optional<BodyHit<S>> by_passage(const Case& c, const std::optional<Passage<S>>& passage) {
  if (!passage) return std::nullopt;
  return with_line<S>(c, [&](const auto& line) { return contact::first_hit(line, *passage); });
}

template <class S>
std::optional<S> in_extent(const Case& c, std::optional<S> t) {
  if (t && is_segment(c) && !(*t <= S(1))) return std::nullopt;
  return t;
}

/// The wall's roots and the caps' planes, each kept if its point is in range; the least t ≥ 0.
template <class S>
std::optional<S> cone_by_roots(const Case& c) {
  const Ray<S> ray = ray_of<S>(c);
  const Cone<S> cone = cone_of<S>(c);
  const Vector3<S> h = cone.base - cone.apex, m = ray.origin - cone.apex;
  const S hh = h.dot(h), at = m.dot(h), rate = ray.direction.dot(h);
  std::optional<S> best;
  const auto offer = [&](const S& t) {
    if (t >= S(0) && (!best || t < *best)) best = t;
  };
  if (const auto roots = contact::passage_of_double_cone(ray, cone)) {
    for (const S& t : {roots->entry, roots->exit}) {
      const S along = at + t * rate;
      if (S(0) <= along && along <= hh) offer(t);
    }
  }
  const S t = (hh - at) / rate;
  const Vector3<S> off = m + ray.direction * t - h;
  if (off.dot(off) <= cone.radius * cone.radius) offer(t);
  return in_extent(c, best);
}

/// The nearer root of the double cone, if it is not behind: which nappe it is on is not asked.
template <class S>
std::optional<S> cone_without_height(const Case& c) {
  const auto roots = contact::passage_of_double_cone(ray_of<S>(c), cone_of<S>(c));
  if (!roots || !(roots->exit >= S(0))) return std::nullopt;
  return in_extent(c, std::optional<S>(std::max(roots->entry, S(0))));
}

/// The wall's roots of a tube, each kept if its point is between the ends.
template <class S>
std::optional<S> tube_by_roots(const Case& c) {
  const Ray<S> ray = ray_of<S>(c);
  const Cylinder<S> tube = cylinder_of<S>(c);
  const Vector3<S> e = tube.core.end - tube.core.start, m = ray.origin - tube.core.start;
  const S ee = e.dot(e), ew = e.dot(ray.direction), em = e.dot(m);
  const S a = ee * ray.direction.dot(ray.direction) - ew * ew;
  const S b = ee * m.dot(ray.direction) - ew * em;
  const S rest = b * b - a * (ee * (m.dot(m) - tube.radius * tube.radius) - em * em);
  if (!(rest >= S(0))) return std::nullopt;
  for (const S& t : {(-b - std::sqrt(rest)) / a, (-b + std::sqrt(rest)) / a}) {
    const S along = em + t * ew;
    if (t >= S(0) && S(0) <= along && along <= ee) return in_extent(c, std::optional<S>(t));
  }
  return std::nullopt;
}

/// The roots of the infinite wall, negative ones clamped to 0, and the point there: between the
/// ends it is taken for a hit, also if both roots were negative.
inline std::optional<double> capsule_by_clamped_roots(const Case& c) {
  const Ray<double> ray = ray_of<double>(c);
  const auto wall = contact::passage_of_infinite_cylinder(ray, cylinder_of<double>(c));
  const auto by_ball = [&] {
    return in_extent(c, contact::capsule_hit_by_textbook(ray, capsule_of<double>(c)));
  };
  if (!wall || std::isinf(wall->entry)) return by_ball();
  const double t = std::max(wall->entry, 0.0);
  const Segment<double> core = c.segment("core");
  const Vector3<double> e = core.end - core.start;
  const double along = e.dot(ray.origin + ray.direction * t - core.start);
  if (0 <= along && along <= e.dot(e)) return in_extent(c, std::optional<double>(t));
  return by_ball();
}

/// Samples of a path: the first at which the ball overlaps the box.
inline std::optional<double> ball_by_samples(const Case& c) {
  constexpr int samples = 16;
  const Segment<double> path = c.segment("segment");
  const Aabb<double> box = box_of(c);
  const double radius = c.number("radius");
  for (int k = 0; k <= samples; ++k) {
    const double t = double(k) / samples;
    const Vector3<double> p = path.start * (1 - t) + path.end * t;
    const Vector3<double> off = p - p.cwiseMax(box.low).cwiseMin(box.high);
    if (off.dot(off) <= radius * radius) return t;
  }
  return std::nullopt;
}

inline contact::Primitive<double> wall_of(const Case& c) {
  if (c.has("low")) return box_of(c);
  if (c.has("core")) return capsule_of<double>(c);
  return Sphere<double>{c.vector("centre"), c.number("radius")};
}

// ---------------------------------------------------------------- questions

template <class BodyOf>
void add_body(hard_cases::Runner& runner, const std::string& name, BodyOf body_of) {
  runner.question(name, [body_of](const Case& c) -> Json {
    return answer_of(bodies::regions(line_of(c), body_of(c)), is_segment(c));
  });
}
template <class BodyOf>
void add_book(hard_cases::Runner& runner, const std::string& name, BodyOf body_of) {
  runner.method(name, "the book, exact", [body_of](const Case& c, const Json& answer) {
    return with_line<double>(c, [&](const auto& line) {
      return right(c, contact::first_hit(line, body_of(c)), answer);
    });
  });
}

inline void add_questions(hard_cases::Runner& runner) {
  add_body(runner, "cylinder", cylinder_of<double>);
  runner.method("cylinder", "textbook, float", [](const Case& c, const Json& answer) {
    return right(
        c,
        by_passage<float>(c, contact::passage_by_textbook(ray_of<float>(c), cylinder_of<float>(c))),
        answer);
  });
  runner.method("cylinder", "textbook, double", [](const Case& c, const Json& answer) {
    return right(c,
                 by_passage<double>(
                     c, contact::passage_by_textbook(ray_of<double>(c), cylinder_of<double>(c))),
                 answer);
  });
  runner.method("cylinder", "wall only, double", [](const Case& c, const Json& answer) {
    return right(c, tube_by_roots<double>(c), answer);
  });
  add_book(runner, "cylinder", cylinder_of<double>);

  runner.question("tube", [](const Case& c) -> Json {
    const Line line = line_of(c);
    const auto t = bodies::first_on_wall(
        line, bodies::core_of(c.segment("core"), c.number("radius")), is_segment(c));
    Json answer{{"class", "b"}, {"hit", t.has_value()}};
    if (t) answer["t"] = hard_cases::hex(oracle::nearest(*t));
    return answer;
  });
  runner.method("tube", "wall by roots, float", [](const Case& c, const Json& answer) {
    return right(c, tube_by_roots<float>(c), answer);
  });
  runner.method("tube", "wall by roots, double", [](const Case& c, const Json& answer) {
    return right(c, tube_by_roots<double>(c), answer);
  });
  runner.method("tube", "the book, exact", [](const Case& c, const Json& answer) {
    return with_line<double>(c, [&](const auto& line) {
      return right(c, contact::first_hit_open(line, cylinder_of<double>(c)), answer);
    });
  });

  add_body(runner, "capsule", capsule_of<double>);
  runner.method("capsule", "wall, then ball, float", [](const Case& c, const Json& answer) {
    return right(
        c, in_extent(c, contact::capsule_hit_by_textbook(ray_of<float>(c), capsule_of<float>(c))),
        answer);
  });
  runner.method("capsule", "wall, then ball, double", [](const Case& c, const Json& answer) {
    return right(
        c, in_extent(c, contact::capsule_hit_by_textbook(ray_of<double>(c), capsule_of<double>(c))),
        answer);
  });
  runner.method("capsule", "clamped roots, double", [](const Case& c, const Json& answer) {
    return right(c, capsule_by_clamped_roots(c), answer);
  });
  add_book(runner, "capsule", capsule_of<double>);

  add_body(runner, "cone", cone_of<double>);
  runner.method("cone", "without the height, double", [](const Case& c, const Json& answer) {
    return right(c, cone_without_height<double>(c), answer);
  });
  runner.method("cone", "roots and base, float", [](const Case& c, const Json& answer) {
    return right(c, cone_by_roots<float>(c), answer);
  });
  runner.method("cone", "roots and base, double", [](const Case& c, const Json& answer) {
    return right(c, cone_by_roots<double>(c), answer);
  });
  add_book(runner, "cone", cone_of<double>);

  runner.question("ball_box", [](const Case& c) -> Json {
    return answer_of(
        bodies::regions(line_of(c), bodies::RoundedBox{oracle::exact(c.vector("low")),
                                                       oracle::exact(c.vector("high")),
                                                       oracle::exact(c.number("radius"))}),
        true);
  });
  runner.method("ball_box", "16 samples", [](const Case& c, const Json& answer) {
    return right(c, ball_by_samples(c), answer);
  });
  runner.method("ball_box", "enlarged box", [](const Case& c, const Json& answer) {
    return right(
        c, contact::ball_hits_enlarged_box(c.segment("segment"), c.number("radius"), box_of(c)),
        answer);
  });
  runner.method("ball_box", "the book, exact", [](const Case& c, const Json& answer) {
    return right(c, contact::ball_first_hit(c.segment("segment"), c.number("radius"), box_of(c)),
                 answer);
  });

  // A bullet of `steps` steps: whether it meets the wall, which is stored.
  runner.question("bullet", [](const Case& c) -> Json {
    const Vector3<double> start = c.vector("start"), step = c.vector("displacement");
    const int steps = static_cast<int>(c.number("steps"));
    bool met = false;
    for (int k = 0; k < steps && !met; ++k) {
      const Line line =
          rays::exact_line(Segment<double>{start + step * double(k), start + step * double(k + 1)});
      std::vector<Region> regions;
      if (c.has("low")) {
        Region box;
        for (int i = 0; i < 3; ++i) {
          bodies::between(box, line.origin(i), line.direction(i), oracle::exact(c.vector("low")(i)),
                          oracle::exact(c.vector("high")(i)));
        }
        regions.push_back(box);
      } else if (c.has("core")) {
        regions = bodies::regions(line, capsule_of<double>(c));
      } else {
        regions.push_back({bodies::ball(line.origin - oracle::exact(c.vector("centre")),
                                        line.direction, oracle::exact(c.number("radius")))});
      }
      met = bodies::meets(regions, true);
    }
    return {{"class", "a"}, {"hit", met}};
  });
  const auto bullet = [](auto method) {
    return [method](const Case& c, const Json& answer) {
      const std::vector<contact::Primitive<double>> scene{wall_of(c)};
      const bool met =
          method(c.vector("start"), c.vector("displacement"), static_cast<int>(c.number("steps")),
                 std::span<const contact::Primitive<double>>(scene))
              .has_value();
      return met == answer.at("hit").get<bool>();
    };
  };
  runner.method("bullet", "a sample a step",
                bullet([](const auto&... x) { return contact::bullet_by_samples<double>(x...); }));
  runner.method("bullet", "a segment a step",
                bullet([](const auto&... x) { return contact::bullet_by_segments<double>(x...); }));
}

}  // namespace hard_round
