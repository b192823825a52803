/// @file
/// Line, ray and segment against a cylinder: solid with flat caps, without ends, and as an open
/// tube.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <optional>

#include <contact/convex_part.hpp>
#include <contact/passage.hpp>
#include <contact/shapes.hpp>
#include <contact/sign_with_root.hpp>
#include <contact/vector.hpp>

namespace contact {

// [cylinder]
/// A solid cylinder: all points at most radius from the line of the core, between the planes
/// through its ends and perpendicular to it.
///
/// A core of length 0 has no direction, so it makes no cylinder, and nothing meets it. With a
/// radius of 0 it is its core.
template <Ring S>
struct Cylinder {
  Segment<S> core;  ///< m
  S radius = S(0);  ///< m, not negative
};
// [/cylinder]

/// The faces of a cylinder.
enum CylinderFace : int {
  cylinder_wall = -1,  ///< the curved surface
  cylinder_start = 0,  ///< the cap at the start of the core
  cylinder_end = 1     ///< the cap at its end
};

namespace detail {

/// A segment and a radius in double: the core of a cylinder or capsule.
struct DoubleCore {
  Vector3<double> start, end;
  double radius;

  template <std::floating_point S>
  DoubleCore(const Segment<S>& core, const S& r)
      : start(core.start.template cast<double>()),
        end(core.end.template cast<double>()),
        radius(static_cast<double>(r)) {}

  bool is_body() const {
    return all_finite(start) && all_finite(end) && std::isfinite(radius) && radius >= 0;
  }
  template <class T>
  Triple<T> axis() const {
    return minus(triple<T>(end), triple<T>(start));
  }
  /// From the core's line to p, which is relative to its start; perpendicular to the core. 0 if the
  /// core is longer than the largest number.
  Vector3<double> off_axis(const Vector3<double>& p) const {
    if (!all_finite(end - start)) return Vector3<double>::Zero();
    const Vector3<double> axis = unit_or_zero(end - start);
    return p - axis * axis.dot(p);
  }
};

// [cylinder-terms]
/// The quadratic of an infinite cylinder, |(m + t w) × e|² − r² e·e, with m from the start of the
/// core to the start of the line, and e the core. The cross products remove what is along the axis,
/// so nothing has to be subtracted for it.
template <class T>
ConvexPart<T> infinite_cylinder(const Triple<T>& m, const Triple<T>& w, const Triple<T>& e,
                                const T& radius) {
  const Triple<T> from = cross(m, e), moved = cross(w, e);
  const T length = dot(e, e), square = radius * radius, skew = dot(m, moved);
  ConvexPart<T> part;
  part.round = true;
  part.a = dot(moved, moved);
  part.b = dot(from, moved);
  part.c = dot(from, from) - square * length;
  part.depth = length * (square * part.a - skew * skew);  // Lagrange's identity
  return part;
}
// [/cylinder-terms]

/// A cylinder as one convex part: the infinite one and, unless it has no ends, the slab of its
/// caps.
struct CylinderParts {
  const DoubleLine& line;
  const DoubleCore& core;
  bool ends;

  template <class T>
  ConvexPart<T> part(int) const {
    const Triple<T> m = line.from<T>(core.start), w = line.direction<T>(), e = core.axis<T>();
    ConvexPart<T> cylinder = infinite_cylinder(m, w, e, T(core.radius));
    if (ends) cylinder.add(dot(m, e), dot(w, e), dot(e, e));
    return cylinder;
  }
  bool is_body() const { return line.finite() && core.is_body() && core.start != core.end; }

  Vector3<double> normal(double t, int face) const {
    const Vector3<double> axis = unit_or_zero(core.end - core.start);
    if (face == cylinder_start) return -axis;
    if (face == cylinder_end) return axis;
    if (core.radius == 0) return Vector3<double>::Zero();
    return unit_or_zero(core.off_axis(line.at(t, core.start)));
  }
};

template <FloatOrDouble S, LineOf<S> Line, class Answer>
auto ask_cylinder(const Line& line, const Cylinder<S>& cylinder, bool ends, const Answer& answer) {
  const DoubleLine in_double(line);
  const DoubleCore core(cylinder.core, cylinder.radius);
  const CylinderParts parts{in_double, core, ends};
  return parts.is_body() ? answer(parts) : decltype(answer(parts)){};
}

}  // namespace detail

// [cylinder-by-textbook]
/// The line through a solid cylinder by the formulas of the books: squares of the direction and of
/// the distance, less what is along the axis.
///
/// Limits: each coefficient subtracts two nearly equal numbers where the line is nearly parallel to
/// the axis or far away, and the discriminant does again; then hits are lost and misses hit. A line
/// that is exactly parallel needs a coefficient that is exactly 0, which rounding does not give for
/// most axes. The denominators of the caps may be 0, and 0/0 is NaN. So a core of length 0, and a
/// direction of 0 in the cylinder, give entry −∞, exit ∞ and normals of NaN. A negative radius
/// counts as its magnitude; a NaN gives nothing or is overlooked.
///
/// Source: Ericson, *Real-Time Collision Detection* (2005), section 5.3.7.
template <std::floating_point S>
std::optional<Passage<S>> passage_by_textbook(const Ray<S>& ray, const Cylinder<S>& cylinder) {
  const Vector3<S> e = cylinder.core.end - cylinder.core.start;
  const Vector3<S> m = ray.origin - cylinder.core.start;
  const S ee = e.dot(e), ew = e.dot(ray.direction), em = e.dot(m);
  const S a = ee * ray.direction.dot(ray.direction) - ew * ew;
  const S b = ee * m.dot(ray.direction) - ew * em;
  const S c = ee * (m.dot(m) - cylinder.radius * cylinder.radius) - em * em;
  constexpr S endless = std::numeric_limits<S>::infinity();
  Passage<S> found;
  found.entry = -endless;
  found.exit = endless;
  if (a == S(0)) {
    if (c > S(0)) return std::nullopt;
  } else {
    const S discriminant = b * b - a * c;
    if (!(discriminant >= S(0))) return std::nullopt;
    found.entry = (-b - std::sqrt(discriminant)) / a;
    found.exit = (-b + std::sqrt(discriminant)) / a;
  }
  S low = -em / ew, high = (ee - em) / ew;
  const bool backwards = high < low;
  if (backwards) std::swap(low, high);
  if (low > found.entry) {
    found.entry = low;
    found.entry_face = backwards ? cylinder_end : cylinder_start;
  }
  if (high < found.exit) {
    found.exit = high;
    found.exit_face = backwards ? cylinder_start : cylinder_end;
  }
  if (!(found.entry <= found.exit)) return std::nullopt;
  const auto normal = [&](const S& t, int face) -> Vector3<S> {
    if (face != cylinder_wall) return e.normalized() * S(face == cylinder_end ? 1 : -1);
    const Vector3<S> p = m + ray.direction * t;
    return Vector3<S>(p - e * (e.dot(p) / ee)).normalized();
  };
  found.entry_normal = normal(found.entry, found.entry_face);
  found.exit_normal = normal(found.exit, found.exit_face);
  return found;
}
// [/cylinder-by-textbook]

// [hits-cylinder]
/// Whether a ray or a segment meets a solid cylinder with flat caps. Touching counts.
///
/// Right for every finite input, for cores of any length and direction. No root is needed: on the t
/// that the caps and the line's ends leave, the quadratic is ≤ 0 at an end, or has its vertex
/// between the ends and a discriminant that is not negative. A direction of 0 is a point; a line in
/// the wall, on a rim or in the plane of a cap meets the cylinder. No for a core of length 0, a
/// negative radius, and numbers that are not finite.
template <FloatOrDouble S, LineOf<S> Line>
bool hits_cylinder(const Line& line, const Cylinder<S>& cylinder) {
  return detail::ask_cylinder(line, cylinder, true, [](const detail::CylinderParts& parts) {
    return detail::meets_parts(1, parts, parts.line.extent);
  });
}
// [/hits-cylinder]

/// Where the unbounded line through a ray or a segment enters and leaves a solid cylinder: the
/// book's choice.
///
/// The decision is right as that of hits_cylinder. Each t is within 2^-40 |t| of the exact one, has
/// its sign, and is rounded to S; beyond the largest number it is that number. Faces as
/// CylinderFace; on a rim the cap, but the wall for a line in the plane of the cap. The normal of
/// the wall is computed from the point, so its error is that of the point over the radius; 0 for a
/// radius of 0 and where a difference of coordinates overflows. A direction of 0 in the cylinder
/// has entry −∞, exit ∞.
template <FloatOrDouble S, LineOf<S> Line>
std::optional<Passage<S>> passage(const Line& line, const Cylinder<S>& cylinder) {
  return detail::ask_cylinder(line, cylinder, true, [](const detail::CylinderParts& parts) {
    return detail::passage_with_normals<S>(
        detail::passage_in_parts(1, parts),
        [&](double t, int face) { return parts.normal(t, face); });
  });
}

/// The same of a cylinder without ends, the line of whose axis is that of the core. A line that is
/// parallel to the axis and inside or in the wall has entry −∞, exit ∞, as has a direction of 0
/// there. Nothing for a core of length 0, a negative radius, and numbers that are not finite.
template <FloatOrDouble S, LineOf<S> Line>
std::optional<Passage<S>> passage_of_infinite_cylinder(const Line& line,
                                                       const Cylinder<S>& cylinder) {
  return detail::ask_cylinder(line, cylinder, false, [](const detail::CylinderParts& parts) {
    return detail::passage_with_normals<S>(
        detail::passage_in_parts(1, parts),
        [&](double t, int face) { return parts.normal(t, face); });
  });
}

/// What a ray or a segment meets first of a solid cylinder. Decision and `inside` are exact; t,
/// face and normal are those of passage(). Nothing where hits_cylinder says no.
template <FloatOrDouble S, LineOf<S> Line>
std::optional<BodyHit<S>> first_hit(const Line& line, const Cylinder<S>& cylinder) {
  return detail::ask_cylinder(line, cylinder, true,
                              [](const detail::CylinderParts& parts) -> std::optional<BodyHit<S>> {
                                if (!detail::meets_parts(1, parts, parts.line.extent))
                                  return std::nullopt;
                                return detail::hit_with_normal<S>(
                                    parts.line, detail::passage_in_parts(1, parts),
                                    [&](double t, int face) { return parts.normal(t, face); });
                              });
}

namespace detail {

/// Where the wall of a cylinder with ends but without caps is met first: which root, or in the
/// wall.
enum class TubeMeeting { none, entering, leaving, along };

inline TubeMeeting tube_meeting(const CylinderParts& parts) {
  const ConvexPart<Exact> x = parts.part<Exact>(0);
  const LineSlab<Exact>& caps = x.slab[0];
  const bool segment = parts.line.extent == LineExtent::segment;
  if (x.a.sign() == 0) {
    if (x.c.sign() != 0) return TubeMeeting::none;
    bool sure = true;
    return meets(x, parts.line.extent, sure) ? TubeMeeting::along : TubeMeeting::none;
  }
  if (x.depth.sign() < 0) return TubeMeeting::none;
  for (const int which : {-1, 1}) {  // t = (−b + which √depth)/a
    const Exact root(double{1} * which);
    if (sign_with_root(-x.b, root, x.depth) < 0) continue;
    if (segment && sign_with_root(-x.b - x.a, root, x.depth) > 0) continue;
    const Exact at = x.a * caps.along - x.b * caps.rate, by = root * caps.rate;
    if (sign_with_root(at, by, x.depth) < 0) continue;
    if (sign_with_root(at - x.a * caps.length, by, x.depth) > 0) continue;
    return which < 0 ? TubeMeeting::entering : TubeMeeting::leaving;
  }
  return TubeMeeting::none;
}

}  // namespace detail

// [open-cylinder]
/// What a ray or a segment meets first of the wall of a cylinder without caps, a tube: from outside
/// or, through an open end, from inside.
///
/// Exact for every finite input: whether a root is between 0 and 1, and its point between the ends,
/// is the sign of a + b √d, by squaring. The rims belong to the wall. A line in the wall hits where
/// it enters the wall, or at its start. The body is a surface, so `inside` is false. t as in
/// passage(); the normal points away from the axis on both sides. A direction of 0 hits on the wall
/// only. Nothing for a core of length 0, a negative radius, and numbers that are not finite.
template <FloatOrDouble S, LineOf<S> Line>
std::optional<BodyHit<S>> first_hit_open(const Line& line, const Cylinder<S>& cylinder) {
  return detail::ask_cylinder(
      line, cylinder, true, [](const detail::CylinderParts& parts) -> std::optional<BodyHit<S>> {
        const detail::TubeMeeting meeting = detail::tube_meeting(parts);
        if (meeting == detail::TubeMeeting::none) return std::nullopt;
        bool sure = true;
        const detail::ConvexPart<Exact> x = parts.part<Exact>(0);
        double t = 0;
        if (meeting == detail::TubeMeeting::along) {
          const auto in = detail::clip(x, parts.line.extent, sure);
          t = detail::settled_cut(*in.low, sure);
        } else {
          t = detail::settled_root(x, meeting == detail::TubeMeeting::leaving, sure);
        }
        detail::PartPassage found{{t, cylinder_wall}, {t, cylinder_wall}};
        return detail::hit_with_normal<S>(
            parts.line, found, [&](double at, int face) { return parts.normal(at, face); });
      });
}
// [/open-cylinder]

}  // namespace contact
