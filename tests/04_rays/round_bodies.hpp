/// @file
/// Random round bodies with lines that nearly or exactly touch them, and the comparison with
/// fractions.
#pragma once

#include <04_rays/bodies.hpp>
#include <catch2/catch_test_macros.hpp>
#include <map>

namespace bodies {

using namespace rays;
using contact::BodyHit;
using contact::Passage;

/// A core and a radius with a line, related often enough. In whole numbers, and in kind 2 a few
/// ulps beside them, the core is along an axis, and the line is a tangent, passes a rim or an end.
template <class S>
struct RoundCase {
  Segment<S> core;
  S radius;
  Ray<S> ray;
};

template <class S>
RoundCase<S> round_case(Random& random, int kind) {
  static constexpr int triples[5][3] = {{3, 4, 5}, {5, 12, 13}, {8, 15, 17}, {0, 7, 7}, {4, 3, 5}};
  const S scale = size<S>(random, kind);
  RoundCase<S> c;
  if ((kind == 1 || kind == 2) && random.chance(0.7)) {
    const int k = random.integer(0, 2), i = (k + 1) % 3, j = (k + 2) % 3;
    const auto& [a, b, r] = triples[random.integer(0, 4)];
    const Vector3<S> start = vector<S>(random, 1);
    Vector3<S> end = start, on = start, along = Vector3<S>::Zero();
    end(k) += S(random.integer(-6, 6));
    on(i) += S(a);
    on(j) += S(b);
    on(k) = random.chance(0.4) ? end(k) : S(random.integer(-6, 6));
    switch (random.integer(0, 3)) {
      case 0:  // a tangent of the wall
        along(i) = S(-b);
        along(j) = S(a);
        along(k) = S(random.integer(-2, 2));
        break;
      case 1:  // a generator or a line in the plane of a cap
        along(random.integer(0, 2)) = S(1);
        break;
      case 2:
        along = Vector3<S>(end - on);
        break;
      default:
        along = vector<S>(random, 1);
    }
    const S steps = S(random.integer(-3, 3));
    c = {{start, end}, S(r), {Vector3<S>(on - along * steps), along}};
    if (kind == 2) {
      if (random.chance(0.5)) c.ray.origin = nudged<S>(random, c.ray.origin);
      if (random.chance(0.3)) c.ray.direction = nudged<S>(random, c.ray.direction);
      if (random.chance(0.3)) c.radius = nudged<S>(random, c.radius);
      if (random.chance(0.2)) c.core.end = nudged<S>(random, c.core.end);
    }
    return c;
  }
  c.core.start = vector<S>(random, kind) * scale;
  c.core.end = random.chance(0.02) ? c.core.start : Vector3<S>(vector<S>(random, kind) * scale);
  c.radius = kind == 6   ? std::abs(generators::any_finite<S>(random))
             : kind == 1 ? S(random.integer(0, 6))
                         : S(std::abs(random.uniform(0, 0.7)) * double(scale));
  if (random.chance(0.03)) c.radius = S(0);
  const S share = S(random.uniform(-0.2, 1.2));
  Vector3<S> target = c.core.start + (c.core.end - c.core.start) * share;
  if (kind != 6) target += vector<S>(random, 0) * c.radius;
  c.ray = ray_towards<S>(random, kind, target, scale);
  if (kind != 6 && random.chance(0.05)) c.ray.direction = c.core.end - c.core.start;
  return c;
}

/// What was seen: 0 misses, 1 hits, 2 inside, 3 touches.
using Seen = std::map<int, int>;

/// Compares decision, both t and `inside` of a body with fractions.
template <class S, class L, class Body, class Exactly, class Hits>
void compare(const L& line, const Body& body, const Exactly& exactly, const Hits& hits,
             Seen& seen) {
  constexpr bool ends = contact::has_end<L>;
  const std::vector<Region> all = regions(exact_line(line), exactly);
  const Found right = find(all);
  const bool met = right.met && meets(all, ends);
  REQUIRE(hits(line, body) == met);
  const std::optional<BodyHit<S>> hit = contact::first_hit(line, body);
  REQUIRE(hit.has_value() == met);
  const std::optional<Passage<S>> passage = contact::passage(line, body);
  REQUIRE(passage.has_value() == right.met);
  ++seen[met ? 1 : 0];
  if (!right.met) return;
  REQUIRE(passage->entry <= passage->exit);
  const auto end_is = [](S got, bool open, const Surd& t, int side) {
    if (open) return std::isinf(got) && (got > 0) == (side > 0);
    const int sign = oracle::sign(t);
    if (sign != (got > 0 ? 1 : got < 0 ? -1 : 0)) return false;
    return t_is(got, t, std::abs(oracle::nearest(t)), 0x1p-40);
  };
  REQUIRE(end_is(passage->entry, right.low_open, right.low, -1));
  REQUIRE(end_is(passage->exit, right.high_open, right.high, 1));
  if (!right.low_open && !right.high_open && oracle::compare(right.low, right.high) == 0) {
    ++seen[3];
  }
  if (!hit) return;
  REQUIRE(hit->inside == (right.low_open || oracle::sign(right.low) < 0));
  if (hit->inside) {
    ++seen[2];
    REQUIRE(hit->t == 0);
    REQUIRE(hit->normal == Vector3<S>::Zero());
    return;
  }
  REQUIRE(end_is(hit->t, false, right.low, -1));
  if (ends) REQUIRE(hit->t <= 1);
  for (int k = 0; k < 3; ++k) {
    REQUIRE(!std::isnan(hit->point(k)));
    REQUIRE(std::isfinite(hit->normal(k)));
  }
}

/// Rays and segments of all kinds against bodies that make(case) gives.
template <class S, class Make, class Hits>
void compare_round(int count, std::uint64_t seed, const Make& make, const Hits& hits) {
  Random random(seed);
  Seen seen;
  for (int i = 0; i < generators::tried(count); ++i) {
    const int kind = i % kinds;
    const RoundCase<S> c = round_case<S>(random, kind);
    const auto body = make(c);
    const Segment<S> segment{c.ray.origin, Vector3<S>(c.ray.origin + c.ray.direction * S(1.5))};
    INFO("kind " << kind << ", case " << i);
    if (!contact::is_finite(c.ray) || !contact::is_finite(c.core)) continue;
    compare<S>(c.ray, body, body, hits, seen);
    if (contact::is_finite(segment)) compare<S>(segment, body, body, hits, seen);
  }
  for (int what = 0; what <= 3; ++what) {
    INFO("outcome " << what);
    CHECK(seen[what] > generators::tried(count) / 200);
  }
}

}  // namespace bodies
