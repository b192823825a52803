// A disc, the bullet, that moves in a straight line during a step, and a plate at rest or a second
// moving disc: when do they first touch? By slices of the step, by bisection, and exactly; and the
// starts from which the slices miss the touch.
#include <algorithm>
#include <array>
#include <cmath>
#include <contact/figure.hpp>
#include <contact/moving_spheres.hpp>
#include <contact/offset_plane.hpp>
#include <contact/sine_cosine.hpp>
#include <contact/sliced_steps.hpp>
#include <contact/sphere_capsule_impact.hpp>
#include <contact/swept_volumes.hpp>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

using Point = contact::Vector2<double>;
using Vector = contact::Vector3<double>;
using Ball = contact::Sphere<double>;

struct Input {
  double target;               // 0 a plate at rest, 1 a disc that moves
  Point from, to;              // centre of the bullet at the start and at the end of the step, m
  double radius;               // of the bullet, m
  double thickness;            // of the plate, m
  Point other_from, other_to;  // centre of the disc, m
  double other_radius;         // of the disc, m
  double slices;               // of the step
  double halvings;             // of the slice in which the overlap is found
  double time;                 // at which the bodies are drawn, as a fraction of the step
};

constexpr std::size_t max_slices = 40, max_halvings = 20, corners = 64, samples = 48;

struct Output {
  double problem;
  Point at, other_at;                               // the centres at that time
  Point plate_low, plate_high;                      // corners of the plate
  std::array<Point, corners> grown;                 // the target at the start, grown by the radius
  double slices;                                    // how many there are
  std::array<double, max_slices + 1> tested;        // times k / slices
  std::array<double, max_slices + 1> overlaps;      // 1 if the bodies overlap then
  std::array<Point, max_slices + 1> bullet, other;  // the centres then
  // What each method answers: 1 if it finds a touch, and its time as a fraction of the step.
  double sliced, sliced_time;
  double previous_free;      // the end of the last free slice before that
  double interpolated_time;  // between the last free slice and the first one with an overlap
  double bisected, free_time, hit_time;
  double halvings;                                           // how many were made
  std::array<double, max_halvings> halved, halved_overlaps;  // the times tested, and the answers
  double touches, time;                                      // the exact answer
  double leaves;                                             // when they separate again, at most 1
  // At the touch: the bullet's centre, that of the disc, the point in common on both surfaces, and
  // the unit normal of the surface that is hit, towards the bullet. Between overlapping discs the
  // point divides the line of the centres as the radii do.
  Point touch_centre, touch_other, touch_point, normal;
  double at_start;     // 1 if they touch or overlap at the start
  double swept_meets;  // 1 if the volumes that they sweep have a point in common
  // Starts from which slices miss a touch, if the bullet is displaced by as much: `parts` outlines,
  // low[i] to high[i] along parallel paths, and the same displaced by `shift` for each slice more.
  double parts;
  std::array<std::array<Point, samples>, 2> missed_low, missed_high;
  Point shift;
  // The plate's face that the bullet is before at the start, as a plane without edges; whether the
  // bullet touches it in the step, when, and where on the plane.
  Vector face_normal;
  double face_offset;
  double face_touched, face_time;
  Vector face_point;
  // Goals of questions.
  double missed;       // they touch in the step, and no slice shows it
  double missed_fine;  // the same with at least 20 slices
  double grazed;       // the same with slices shorter than the radius
  double crossed;      // the swept volumes meet, and the bodies do not touch
  double late;         // slices find the touch at least a fifth of the step late
};

namespace {

const Point plate_centre(0.8, 1);
constexpr double plate_half_height = 1.4;
constexpr double pi = 3.141592653589793;

Vector space(const Point& p) { return {p.x(), p.y(), 0}; }

/// The bodies of the figure and their motion.
struct Motion {
  bool plate;
  Point from, displacement;
  Point other_from, other_displacement;
  double radius, other_radius;
  Point half;  // of the plate

  explicit Motion(const Input& in)
      : plate(in.target != 1),
        from(in.from),
        displacement(in.to - in.from),
        other_from(plate ? plate_centre : in.other_from),
        other_displacement(plate ? Point::Zero() : Point(in.other_to - in.other_from)),
        radius(in.radius),
        other_radius(in.other_radius),
        half(in.thickness / 2, plate_half_height) {}

  Point bullet(double t) const { return from + t * displacement; }
  Point other(double t) const { return other_from + t * other_displacement; }
  /// The point of the plate that is closest to a point.
  Point closest(const Point& p) const {
    return other_from + (p - other_from).cwiseMax(-half).cwiseMin(half);
  }
  /// The distance of the surfaces; negative if they overlap.
  double gap(double t) const {
    const Point between = bullet(t) - other(t);
    if (!plate) return std::sqrt(between.squaredNorm()) - other_radius - radius;
    const Point outside = between.cwiseAbs() - half;
    const double inside = std::min(outside.maxCoeff(), 0.0);
    return std::sqrt(outside.cwiseMax(0.0).squaredNorm()) + inside - radius;
  }
};

// [first-touch]
/// The first touch of the bullet and the target in the step, as a fraction of it; 0 if they touch
/// at the start. The plate's four edges are segments, and a bullet outside it meets one first.
std::optional<double> first_touch(const Motion& m) {
  if (m.gap(0) <= 0) return 0.0;
  const Ball bullet{space(m.from), m.radius};
  const Vector displacement = space(m.displacement);
  if (!m.plate) {
    const Ball other{space(m.other_from), m.other_radius};
    return contact::moving_spheres_impact(bullet, displacement, other, space(m.other_displacement));
  }
  const auto corner = [&m](int x, int y) {
    return space(m.other_from + Point(x * m.half.x(), y * m.half.y()));
  };
  std::optional<double> first;
  for (const auto& [start, end] : {std::pair(corner(-1, -1), corner(-1, 1)),
                                   {corner(-1, 1), corner(1, 1)},
                                   {corner(1, 1), corner(1, -1)},
                                   {corner(1, -1), corner(-1, -1)}}) {
    const auto t = contact::sphere_segment_impact(bullet, displacement, {start, end});
    if (t && (!first || *t < *first)) first = t;
  }
  return first;
}
// [/first-touch]

/// The same motion from its end to its start.
Motion reversed(Motion m) {
  m.from += m.displacement;
  m.displacement = -m.displacement;
  m.other_from += m.other_displacement;
  m.other_displacement = -m.other_displacement;
  return m;
}

void exactly(const Motion& m, Output& out) {
  const std::optional<double> t = first_touch(m);
  // At rest, the plate sweeps nothing but itself.
  const bool swept = m.plate
                         ? t.has_value()
                         : contact::swept_spheres_meet<double>(
                               {space(m.from), m.radius}, space(m.displacement),
                               {space(m.other_from), m.other_radius}, space(m.other_displacement));
  out.swept_meets = swept ? 1 : 0;
  if (!t) return;
  out.touches = 1;
  out.time = std::min(1.0, *t);
  out.at_start = out.time == 0 ? 1 : 0;
  out.leaves = std::max(out.time, 1 - first_touch(reversed(m)).value_or(0.0));
  out.touch_centre = m.bullet(out.time);
  out.touch_other = m.other(out.time);
  const double share = m.radius / (m.radius + m.other_radius);
  out.touch_point = m.plate
                        ? m.closest(out.touch_centre)
                        : Point(out.touch_centre + share * (out.touch_other - out.touch_centre));
  const Point between = out.touch_centre - out.touch_point;
  const double distance = std::sqrt(between.squaredNorm());
  if (distance > 0) out.normal = between / distance;
}

void by_slices(const Input& in, const Motion& m, Output& out) {
  const auto slices = static_cast<int>(std::clamp(std::round(in.slices), 1.0, double(max_slices)));
  const auto halvings =
      static_cast<int>(std::clamp(std::round(in.halvings), 0.0, double(max_halvings)));
  out.slices = slices;
  const auto overlap = [&m](double t) { return m.gap(t) <= 0; };
  for (int k = 0; k <= slices; ++k) {
    const auto i = static_cast<std::size_t>(k);
    out.tested[i] = double(k) / slices;
    out.overlaps[i] = overlap(out.tested[i]) ? 1 : 0;
    out.bullet[i] = m.bullet(out.tested[i]);
    out.other[i] = m.other(out.tested[i]);
  }
  // [slices]
  const auto found = contact::sliced_step<double>(overlap, 1.0, slices);
  if (!found) return;
  std::size_t tests = 0;
  const auto recorded = [&](double t) {
    const bool answer = overlap(t);
    out.halved[tests] = t;
    out.halved_overlaps[tests++] = answer ? 1 : 0;
    return answer;
  };
  const auto bracket = contact::bisect_impact<double>(recorded, *found, halvings);
  // [/slices]
  out.sliced = 1;
  out.sliced_time = found->hit;
  out.previous_free = found->free;
  out.interpolated_time =
      contact::interpolated_impact(*found, m.gap(found->free), m.gap(found->hit));
  out.bisected = 1;
  out.free_time = bracket.free;
  out.hit_time = bracket.hit;
  out.halvings = double(tests);
}

/// Where a line at the distance `across` from the target's centre enters and leaves the target
/// grown by the radius: distances along it. `u` is its direction.
std::pair<double, double> chord(const Motion& m, const Point& u, double across) {
  const Point perpendicular(-u.y(), u.x());
  double enters = std::numeric_limits<double>::infinity(), leaves = -enters;
  const auto add = [&](double along) {
    enters = std::min(enters, along);
    leaves = std::max(leaves, along);
  };
  const auto disc = [&](const Point& centre, double radius) {
    const double off = across - centre.dot(perpendicular);
    if (std::abs(off) > radius) return;
    const double half = std::sqrt((radius - off) * (radius + off));
    add(centre.dot(u) - half);
    add(centre.dot(u) + half);
  };
  if (!m.plate) {
    disc(Point::Zero(), m.radius + m.other_radius);
    return {enters, leaves};
  }
  // The hull of four discs: their chords, and those of the four edges between them.
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) disc({x * m.half.x(), y * m.half.y()}, m.radius);
  }
  for (int k = 0; k < 2; ++k) {
    for (const double side : {-1.0, 1.0}) {
      if (u(k) == 0) continue;
      const double along = (side * (m.half(k) + m.radius) - across * perpendicular(k)) / u(k);
      const double at = across * perpendicular(1 - k) + along * u(1 - k);
      if (std::abs(at) <= m.half(1 - k)) add(along);
    }
  }
  return {enters, leaves};
}

/// The starts from which slices of the length `slice` step over the grown target.
void missed_starts(const Motion& m, Output& out) {
  const Point displacement = m.displacement - m.other_displacement;
  const double length = std::sqrt(displacement.squaredNorm());
  if (!(length > 0)) return;
  const Point u = displacement / length, perpendicular(-u.y(), u.x());
  const double slice = length / out.slices;
  // A little less than half the width, so that every line meets the target.
  const double half = (1 - 0x1p-40) * (m.plate ? m.radius + m.half.dot(perpendicular.cwiseAbs())
                                               : m.radius + m.other_radius);
  const auto longest = [&](double across) {
    const auto [enters, leaves] = chord(m, u, across);
    return std::max(0.0, leaves - enters);
  };
  // The target is symmetric about its centre, and convex: its chord through the centre is a
  // longest one, and chords on either side get shorter.
  double inner = 0;
  if (longest(0) >= slice) {
    double outer = half;
    for (int i = 0; i < 50; ++i) {
      const double middle = inner + (outer - inner) / 2;
      (longest(middle) >= slice ? inner : outer) = middle;
    }
  }
  out.shift = -slice * u;
  out.parts = inner > 0 ? 2 : 1;
  for (std::size_t part = 0; part < std::size_t(out.parts); ++part) {
    const double low = part == 0 ? (out.parts == 2 ? inner : -half) : -half;
    const double high = part == 0 ? half : -inner;
    for (std::size_t i = 0; i < samples; ++i) {
      // Close to each other near the ends, where the outline is round.
      const double share = (1 - contact::sine_cosine(pi * double(i) / (samples - 1)).cosine) / 2;
      const double across = low + (high - low) * share;
      const auto [enters, leaves] = chord(m, u, across);
      out.missed_low[part][i] = m.other_from + across * perpendicular + (leaves - slice) * u;
      out.missed_high[part][i] = m.other_from + across * perpendicular + enters * u;
    }
  }
}

/// The outline of the target grown by the bullet's radius.
void grow(const Motion& m, Output& out) {
  for (std::size_t i = 0; i < corners; ++i) {
    const auto [sine, cosine] = contact::sine_cosine(2 * pi * (double(i) + 0.5) / corners);
    const Point direction(cosine, sine);
    const Point centre =
        m.plate ? Point(std::copysign(m.half.x(), cosine), std::copysign(m.half.y(), sine))
                : Point(m.other_radius * direction);
    out.grown[i] = m.other_from + centre + m.radius * direction;
  }
}

/// The plane of the face that the bullet's centre is before at the start, as if it had no edges.
void against_face(const Motion& m, Output& out) {
  const double side = m.from.x() < m.other_from.x() ? -1 : 1;
  out.face_normal = {side, 0, 0};
  out.face_offset = side * m.other_from.x() + m.half.x();
  const auto hit = contact::sphere_plane_impact<double>(
      {space(m.from), m.radius}, space(m.displacement), {out.face_normal, out.face_offset});
  if (!hit) return;
  out.face_touched = 1;
  out.face_time = hit->t;
  out.face_point = hit->point;
}

}  // namespace

Output compute(const Input& in) {
  Output out{};
  for (const Point* p : {&in.from, &in.to, &in.other_from, &in.other_to}) {
    if (p->cwiseAbs().maxCoeff() > 1e6) out.problem = contact::figure::too_large;
  }
  for (const double size : {in.radius, in.thickness, in.other_radius}) {
    if (size > 1e6) out.problem = contact::figure::too_large;
    if (!(size >= 1e-6)) out.problem = contact::figure::too_small;
  }
  if (out.problem != 0) return out;
  const Motion motion(in);
  const double time = std::clamp(in.time, 0.0, 1.0);
  out.at = motion.bullet(time);
  out.other_at = motion.other(time);
  out.plate_low = plate_centre - motion.half;
  out.plate_high = plate_centre + motion.half;
  grow(motion, out);
  by_slices(in, motion, out);
  exactly(motion, out);
  missed_starts(motion, out);
  if (motion.plate) against_face(motion, out);
  out.missed = out.touches == 1 && out.sliced == 0 ? 1 : 0;
  out.missed_fine = out.missed == 1 && out.slices >= 20 ? 1 : 0;
  out.grazed = out.missed == 1 && out.shift.squaredNorm() < in.radius * in.radius ? 1 : 0;
  out.crossed = out.swept_meets == 1 && out.touches == 0 ? 1 : 0;
  out.late = out.sliced == 1 && out.sliced_time - out.time >= 0.2 ? 1 : 0;
  return out;
}

FIGURE(Input,
       FIELDS(target, from, to, radius, thickness, other_from, other_to, other_radius, slices,
              halvings, time),
       Output,
       FIELDS(problem, at, other_at, plate_low, plate_high, grown, slices, tested, overlaps, bullet,
              other, sliced, sliced_time, previous_free, interpolated_time, bisected, free_time,
              hit_time, halvings, halved, halved_overlaps, touches, time, leaves, touch_centre,
              touch_other, touch_point, normal, at_start, swept_meets, crossed, parts, missed_low,
              missed_high, shift, face_normal, face_offset, face_touched, face_time, face_point,
              missed, missed_fine, grazed, late))
