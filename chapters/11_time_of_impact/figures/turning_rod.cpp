// A rod that moves and turns during a step, towards a wall or a disc: conservative advancement step
// by step, and samples at equal times, which can pass the touch.
#include <algorithm>
#include <array>
#include <cmath>
#include <contact/conservative_advancement.hpp>
#include <contact/figure.hpp>
#include <contact/sine_cosine.hpp>
#include <cstddef>
#include <utility>

using Point = contact::Vector2<double>;

struct Input {
  double target;    // 0 a wall, 1 a disc
  Point from, to;   // centre of the rod at the start and at the end of the step, m
  double angle;     // of the rod at the start, degrees
  double turns;     // in the step; negative: clockwise
  double wall;      // position of the wall's face: it is solid from x = wall on, m
  Point disc;       // centre of the disc, m
  double towards;   // 1: only the speed towards the wall is bounded
  double exponent;  // the tolerance is 10^exponent m
  double step;      // which advance is shown, from 1 on
  double samples;   // tests at equal times after the start
};

constexpr std::size_t max_advances = 60, max_samples = 30, curve_points = 241;
using Ends = std::array<Point, 2>;

struct Output {
  double problem;
  double half_length;     // of the rod's axis, m
  double half_thickness;  // of the rod, m
  double disc_radius;     // m
  double tolerance;       // m
  double approach;        // bound on the speed at which the rod comes closer, m per step
  double advances;        // how often the distance is evaluated
  double ended;           // 0 within the tolerance, 1 no touch in the step, 2 too many advances
  double time;            // at which it ended, as a fraction of the step
  std::array<double, max_advances> times, distances;  // of each evaluation
  double shown;                                       // the one that is shown, from 1 to advances
  // Of that: the rod's ends, the closest points of its axis and of the target, the distance, and
  // the time up to which no touch is possible, with the rod then.
  Ends ends;
  Point on_axis, on_target;
  double now, distance, next_time;
  Ends next_ends;
  // Samples: times, distances, ends of the rod, and how many of them overlap the target.
  double samples;
  std::array<double, max_samples + 1> sampled, sampled_distances;
  std::array<Ends, max_samples + 1> sampled_ends;
  double overlapping, first_overlap;
  std::array<double, curve_points> curve;  // the distance at equal times from 0 to 1, m
  double touches, touch_time;              // up to 10⁻⁹ m; the time is not after the touch
  Ends touch_ends;
  Point touch_point;
  // The same motion for a rod without thickness and a disc with both radii.
  double start_angle, turned;  // rad
  Point displacement;          // m
  double radius_sum;           // m
  // Goals of questions.
  double passed;      // it touches, and no sample shows it
  double many;        // more than 20 advances
  double few;         // it touches, and fewer than 10 advances come within the tolerance
  double clear_fast;  // at most three advances prove that it does not touch
};

namespace {

constexpr double half_length = 1.2, half_thickness = 0.1, disc_radius = 0.5;
constexpr double pi = 3.141592653589793;

struct Closest {
  Point on_axis, on_target;
  double distance;  // of the surfaces; negative if they overlap
};

struct Rod {
  bool wall;
  Point from, displacement;
  double angle, turned;  // at the start, and in the step, rad
  double face;
  Point disc;

  explicit Rod(const Input& in)
      : wall(in.target != 1),
        from(in.from),
        displacement(in.to - in.from),
        angle(in.angle / 180 * pi),
        turned(2 * pi * in.turns),
        face(in.wall),
        disc(in.disc) {}

  Ends ends(double t) const {
    const auto [sine, cosine] = contact::sine_cosine(angle + turned * t);
    const Point centre = from + t * displacement, half(half_length * cosine, half_length * sine);
    return {centre - half, centre + half};
  }
  Closest closest(double t) const {
    const auto [start, end] = ends(t);
    if (wall) {
      const Point& tip = start.x() > end.x() ? start : end;
      return {tip, {face, tip.y()}, face - tip.x() - half_thickness};
    }
    const Point axis = end - start;
    const double share = std::clamp((disc - start).dot(axis) / axis.squaredNorm(), 0.0, 1.0);
    const Point on_axis = start + share * axis, between = on_axis - disc;
    const double length = std::sqrt(between.squaredNorm());
    const Point on_disc = length > 0 ? Point(disc + disc_radius / length * between) : disc;
    return {on_axis, on_disc, length - disc_radius - half_thickness};
  }
  // [approach]
  /// No point of the rod comes closer faster than its centre moves plus an end turns about it. With
  /// `towards`, only the motion of the centre along the wall's normal is counted.
  double approach(bool towards) const {
    const double turning = half_length * std::abs(turned);
    const double centre =
        towards && wall ? displacement.x() : std::sqrt(displacement.squaredNorm());
    return std::max(0.0, centre + turning) * (1 + 0x1p-40);
  }
  // [/approach]
};

void advance(const Rod& rod, double approach, Output& out) {
  // [advanced]
  std::size_t count = 0;
  const auto distance = [&](double t) {
    out.times[count] = t;
    return out.distances[count++] = rod.closest(t).distance;
  };
  const auto advance = contact::conservative_advancement<double>(distance, approach, 1.0,
                                                                 out.tolerance, int(max_advances));
  // [/advanced]
  out.advances = advance.advances;
  out.time = advance.t;
  out.ended = advance.end == contact::ConservativeEnd::impact  ? 0
              : advance.end == contact::ConservativeEnd::clear ? 1
                                                               : 2;
}

void show(const Rod& rod, double wanted, Output& out) {
  out.shown = std::clamp(std::floor(wanted), 1.0, out.advances);
  const auto i = std::size_t(out.shown) - 1;
  out.now = out.times[i];
  out.ends = rod.ends(out.now);
  const Closest closest = rod.closest(out.now);
  out.on_axis = closest.on_axis;
  out.on_target = closest.on_target;
  out.distance = closest.distance;
  out.next_time = out.shown < out.advances ? out.times[i + 1] : out.time;
  out.next_ends = rod.ends(out.next_time);
}

void sample(const Rod& rod, double wanted, Output& out) {
  out.samples = std::clamp(std::round(wanted), 1.0, double(max_samples));
  out.first_overlap = -1;
  for (std::size_t k = 0; k <= std::size_t(out.samples); ++k) {
    const double t = double(k) / out.samples;
    out.sampled[k] = t;
    out.sampled_ends[k] = rod.ends(t);
    out.sampled_distances[k] = rod.closest(t).distance;
    if (!(out.sampled_distances[k] <= 0)) continue;
    ++out.overlapping;
    if (out.first_overlap < 0) out.first_overlap = t;
  }
  for (std::size_t k = 0; k < curve_points; ++k)
    out.curve[k] = rod.closest(double(k) / double(curve_points - 1)).distance;
}

/// The touch itself, with a tolerance that is not visible.
void find_touch(const Rod& rod, double approach, Output& out) {
  const auto distance = [&rod](double t) { return rod.closest(t).distance; };
  const auto found =
      contact::conservative_advancement<double>(distance, approach, 1.0, 1e-9, 20000);
  if (found.end != contact::ConservativeEnd::impact) return;
  out.touches = 1;
  out.touch_time = found.t;
  out.touch_ends = rod.ends(found.t);
  out.touch_point = rod.closest(found.t).on_target;
}

}  // namespace

Output compute(const Input& in) {
  Output out{};
  const double size = std::max({in.from.cwiseAbs().maxCoeff(), in.to.cwiseAbs().maxCoeff(),
                                in.disc.cwiseAbs().maxCoeff(), std::abs(in.wall),
                                std::abs(in.turns), std::abs(in.angle) / 1000});
  if (size > 1000) out.problem = contact::figure::too_large;
  if (out.problem != 0) return out;
  const Rod rod(in);
  out.half_length = half_length;
  out.half_thickness = half_thickness;
  out.start_angle = rod.angle;
  out.turned = rod.turned;
  out.displacement = rod.displacement;
  out.radius_sum = disc_radius + half_thickness;
  out.disc_radius = disc_radius;
  constexpr std::array<double, 4> tolerances{1, 0.1, 0.01, 0.001};
  out.tolerance = tolerances[std::size_t(std::clamp(std::round(-in.exponent), 1.0, 3.0))];
  out.approach = rod.approach(in.towards == 1);
  advance(rod, out.approach, out);
  show(rod, in.step, out);
  sample(rod, in.samples, out);
  find_touch(rod, rod.approach(true), out);
  out.passed = out.touches == 1 && out.overlapping == 0 ? 1 : 0;
  out.many = out.advances > 20 ? 1 : 0;
  out.few = out.touches == 1 && out.ended == 0 && out.advances < 10 ? 1 : 0;
  out.clear_fast = out.ended == 1 && out.advances <= 3 ? 1 : 0;
  return out;
}

FIGURE(Input, FIELDS(target, from, to, angle, turns, wall, disc, towards, exponent, step, samples),
       Output,
       FIELDS(problem, half_length, half_thickness, disc_radius, tolerance, approach, advances,
              ended, time, times, distances, shown, ends, on_axis, on_target, now, distance,
              next_time, next_ends, samples, sampled, sampled_distances, sampled_ends, overlapping,
              first_overlap, curve, touches, touch_time, touch_ends, touch_point, start_angle,
              turned, displacement, radius_sum, passed, many, few, clear_fast))
