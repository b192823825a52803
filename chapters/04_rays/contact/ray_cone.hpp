/// @file
/// Line, ray and segment against a solid cone.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <optional>

#include <contact/convex_part.hpp>
#include <contact/passage.hpp>
#include <contact/ray_cylinder.hpp>
#include <contact/shapes.hpp>
#include <contact/vector.hpp>

namespace contact {

// [cone]
/// A solid cone: all points between its apex and the disc about the centre of its base.
///
/// An apex in the centre of the base has no axis, so it makes no cone, and nothing meets it. With a
/// radius of 0 it is a segment.
template <Ring S>
struct Cone {
  Vector3<S> apex = Vector3<S>::Zero();  ///< m
  Vector3<S> base = Vector3<S>::Zero();  ///< the centre of the disc, m
  S radius = S(0);                       ///< of the disc, m, not negative
};
// [/cone]

/// The faces of a cone.
enum ConeFace : int {
  cone_wall = -1,  ///< the curved surface, the apex included
  cone_base = 0    ///< the disc
};

namespace detail {

// [cone-parts]
/// A cone as one convex part. With h from the apex to the base, x from the apex, s = x·h: h·h |x ×
/// h|² ≤ r² s², which a second cone beyond the apex satisfies too, the mirror nappe, and 0 ≤ s ≤
/// h·h, which it does not.
struct ConeParts {
  const DoubleLine& line;
  const DoubleCore& core;  // from the apex to the base

  template <class T>
  ConvexPart<T> part(int) const {
    const Triple<T> m = line.from<T>(core.start), w = line.direction<T>(), h = core.axis<T>();
    const Triple<T> from = cross(m, h), moved = cross(w, h);
    const T length = dot(h, h), at = dot(m, h), rate = dot(w, h), r = T(core.radius);
    ConvexPart<T> cone;
    cone.round = true;
    cone.a = length * dot(moved, moved) - r * r * rate * rate;
    cone.b = length * dot(from, moved) - r * r * at * rate;
    cone.c = length * dot(from, from) - r * r * at * at;
    cone.depth = cone.b * cone.b - cone.a * cone.c;
    cone.add(at, rate, length);
    return cone;
  }
  // [/cone-parts]
  bool is_body() const { return line.finite() && core.is_body() && core.start != core.end; }

  Vector3<double> normal(double t, int face) const {
    const Vector3<double> h = core.end - core.start, axis = unit_or_zero(h);
    if (face == 1) return axis;  // the far side of the slab: the base
    const Vector3<double> away = unit_or_zero(core.off_axis(line.at(t, core.start)));
    if (face == 0 || away == Vector3<double>::Zero()) return -axis;
    return unit_or_zero(away * h.dot(axis) - axis * core.radius);
  }
  /// The slab's near side is the plane through the apex, which belongs to the wall.
  static PartEnd numbered(PartEnd end) {
    if (end.face >= 0) end.face = end.face == 1 ? cone_base : cone_wall;
    return end;
  }
};

template <FloatOrDouble S, LineOf<S> Line, class Answer>
auto ask_cone(const Line& line, const Cone<S>& cone, const Answer& answer) {
  const DoubleLine in_double(line);
  const DoubleCore core(Segment<S>{cone.apex, cone.base}, cone.radius);
  const ConeParts parts{in_double, core};
  return parts.is_body() ? answer(parts) : decltype(answer(parts)){};
}

}  // namespace detail

// [cone-by-textbook]
/// Where an unbounded line meets an infinite double cone, by the quadratic alone: both roots, of
/// which either may be on the mirror nappe or beyond the base.
///
/// Limits: rounded, with the cancellation of every discriminant. A line parallel to a generator has
/// a = 0 and one root, which rounding seldom sees. It is the caller who must ask where the points
/// are; many do not. Nothing for a direction of 0, an axis of length 0, and for NaN; a negative
/// radius counts as its magnitude.
/// @return the smaller root and the larger one; nothing if the line misses both nappes
///
/// Source: the implicit equation in *Fundamentals of Computer Animation*, "Types of geometry".
template <std::floating_point S>
std::optional<Passage<S>> passage_of_double_cone(const Ray<S>& ray, const Cone<S>& cone) {
  const Vector3<S> h = cone.base - cone.apex, m = ray.origin - cone.apex;
  const S hh = h.dot(h), at = m.dot(h), rate = ray.direction.dot(h);
  const S widening = S(1) + cone.radius * cone.radius / hh;
  const S a = hh * ray.direction.dot(ray.direction) - widening * rate * rate;
  const S b = hh * m.dot(ray.direction) - widening * at * rate;
  const S c = hh * m.dot(m) - widening * at * at;
  const S discriminant = b * b - a * c;
  if (!(discriminant >= S(0)) || a == S(0)) return std::nullopt;
  const S one = (-b - std::sqrt(discriminant)) / a, other = (-b + std::sqrt(discriminant)) / a;
  Passage<S> found;
  found.entry = std::min(one, other);
  found.exit = std::max(one, other);
  return found;
}
// [/cone-by-textbook]

/// Whether a ray or a segment meets a solid cone. Touching counts, and the apex and the rim belong
/// to it; the mirror nappe does not.
///
/// Right for every finite input, and without a root, as hits_cylinder: where the quadratic is not
/// convex, it is ≤ 0 at an end of the interval that the base and the apex leave, or nowhere. A
/// direction of 0 is a point. No for an axis of length 0, a negative radius, and numbers that are
/// not finite.
template <FloatOrDouble S, LineOf<S> Line>
bool hits_cone(const Line& line, const Cone<S>& cone) {
  return detail::ask_cone(line, cone, [](const detail::ConeParts& parts) {
    return detail::meets_parts(1, parts, parts.line.extent);
  });
}

/// Where the unbounded line through a ray or a segment enters and leaves a solid cone: the book's
/// choice. Decision and t as for a cylinder. Faces as ConeFace; on the rim the base, but the wall
/// for a line in its plane. The normal at the apex is the direction from the base to it; 0 where a
/// difference of coordinates overflows; any unit vector for a radius of 0. A direction of 0 in the
/// cone has entry −∞, exit ∞. Nothing for what hits_cone denies.
template <FloatOrDouble S, LineOf<S> Line>
std::optional<Passage<S>> passage(const Line& line, const Cone<S>& cone) {
  return detail::ask_cone(line, cone, [](const detail::ConeParts& parts) {
    auto found =
        detail::passage_with_normals<S>(detail::passage_in_parts(1, parts),
                                        [&](double t, int face) { return parts.normal(t, face); });
    if (found) {
      found->entry_face = parts.numbered({0, found->entry_face}).face;
      found->exit_face = parts.numbered({0, found->exit_face}).face;
    }
    return found;
  });
}

/// What a ray or a segment meets first of a solid cone. Decision and `inside` are exact; nothing
/// where hits_cone says no. A t beyond the largest number is that number.
template <FloatOrDouble S, LineOf<S> Line>
std::optional<BodyHit<S>> first_hit(const Line& line, const Cone<S>& cone) {
  return detail::ask_cone(line, cone,
                          [](const detail::ConeParts& parts) -> std::optional<BodyHit<S>> {
                            auto hit = detail::hit_with_normal<S>(
                                parts.line, detail::passage_in_parts(1, parts, parts.line.extent),
                                [&](double t, int face) { return parts.normal(t, face); });
                            if (hit && !hit->inside)
                              hit->face = parts.numbered({0, hit->face}).face;
                            return hit;
                          });
}

}  // namespace contact
