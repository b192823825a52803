/// @file
/// Intersections of slabs along a line, decided without a division.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <contact/exact.hpp>
#include <contact/passage.hpp>
#include <contact/running_error.hpp>
#include <limits>
#include <optional>

namespace contact {

// [slab]
/// The part of a line between two parallel planes: all t with low ≤ t speed ≤ high.
template <class T>
struct Slab {
  T low;    ///< from the start of the line to the lower plane
  T high;   ///< from the start of the line to the upper plane
  T speed;  ///< along the normal for each unit of t; 0 for a line parallel to the planes
};

/// A t as a quotient, so that it can be compared without a division.
template <class T>
struct SlabTime {
  T above;        ///< numerator
  T below;        ///< denominator, greater than 0
  int face = -1;  ///< 2 k for the lower plane of slab k, 2 k + 1 for the upper one
};
// [/slab]

// [slabs]
/// The latest entry and the earliest exit of slabs; of equal ones that of the lowest slab.
template <class T>
struct SlabTimes {
  bool sure = true;           ///< whether all signs were certain; if not, the rest means nothing
  bool meets = true;          ///< whether the unbounded line has a point in all slabs
  bool bounded = false;       ///< whether there is an entry: the line crosses a slab
  SlabTime<T> entry;          ///< the latest
  SlabTime<T> exit;           ///< the earliest
  int entry_sign = -1;        ///< of the entry's t; −1 if there is none
  int exit_sign = 1;          ///< of the exit's t; 1 if there is none
  bool entry_in_time = true;  ///< whether the entry's t is at most 1
};

/// Computes them, from signs alone. Without slabs every line meets, unbounded; so do slabs of speed
/// 0 that contain the start. A NaN in bounded numbers is not sure; exact ones have none.
/// @param slabs a range of Slab<T>; one with low > high contains nothing
template <class T, class Slabs>
SlabTimes<T> slab_times(const Slabs& slabs) {
  using detail::sign_of;
  SlabTimes<T> times;
  const auto difference = [&](const SlabTime<T>& x, const SlabTime<T>& y) {
    return sign_of(x.above * y.below - y.above * x.below, times.sure);
  };
  int k = 0;
  for (const Slab<T>& slab : slabs) {
    const int forwards = sign_of(slab.speed, times.sure);
    const bool empty = sign_of(slab.high - slab.low, times.sure) < 0;
    if (empty || (forwards == 0 &&
                  (sign_of(slab.low, times.sure) > 0 || sign_of(slab.high, times.sure) < 0))) {
      times.meets = false;
      return times;
    }
    if (forwards != 0) {
      SlabTime<T> entry{slab.low, slab.speed, 2 * k};
      SlabTime<T> exit{slab.high, slab.speed, 2 * k + 1};
      if (forwards < 0) {
        entry = {-slab.high, -slab.speed, 2 * k + 1};
        exit = {-slab.low, -slab.speed, 2 * k};
      }
      if (!times.bounded || difference(entry, times.entry) > 0) times.entry = entry;
      if (!times.bounded || difference(exit, times.exit) < 0) times.exit = exit;
      times.bounded = true;
    }
    if (!times.sure) return times;
    ++k;
  }
  if (!times.bounded) return times;
  times.meets = difference(times.entry, times.exit) <= 0;
  times.entry_sign = sign_of(times.entry.above, times.sure);
  times.exit_sign = sign_of(times.exit.above, times.sure);
  times.entry_in_time = sign_of(times.entry.above - times.entry.below, times.sure) <= 0;
  return times;
}
// [/slabs]

namespace detail {

/// The direction of a ray in bounded or exact numbers.
template <class T>
Triple<T> direction_of(const Ray<double>& ray) {
  return triple<T>(ray.direction);
}
/// That of a segment: a difference.
template <class T>
Triple<T> direction_of(const Segment<double>& segment) {
  return minus(triple<T>(segment.end), triple<T>(segment.start));
}

/// Whether a ray, or a line that ends at t = 1, has a point in all slabs.
template <class T>
bool hits(const SlabTimes<T>& times, bool ends) {
  return times.meets && times.exit_sign >= 0 && (!ends || times.entry_in_time);
}

// [decide-slabs]
/// Decides by bounded numbers, and if these are not sure by exact ones.
/// @param body what slabs_of<T>(line, body) turns into slabs
template <class Line, class Body>
bool hits_slabs(const Line& line, const Body& body) {
  const auto rough = slab_times<RunningError>(slabs_of<RunningError>(line, body));
  if (rough.sure) return hits(rough, has_end<Line>);
  return hits(slab_times<Exact>(slabs_of<Exact>(line, body)), has_end<Line>);
}
// [/decide-slabs]

/// A passage in double with the signs that a hit needs.
struct SlabPassage {
  Passage<double> passage;  ///< without normals
  int entry_sign = -1;      ///< exact
  int exit_sign = 1;        ///< exact
  bool entry_in_time = true;
};

/// Where the unbounded line enters and leaves; both t within 2^-40 of the larger magnitude.
template <class Line, class Body>
std::optional<SlabPassage> slabs_passage(const Line& line, const Body& body) {
  SlabPassage found;
  Passage<double>& p = found.passage;
  p.exit = std::numeric_limits<double>::infinity();
  p.entry = -p.exit;
  const auto keep = [&](const auto& times) {
    p.entry_face = times.entry.face;
    p.exit_face = times.exit.face;
    found.entry_sign = times.entry_sign;
    found.exit_sign = times.exit_sign;
    found.entry_in_time = times.entry_in_time;
  };
  const auto rough = slab_times<RunningError>(slabs_of<RunningError>(line, body));
  if (rough.sure) {
    if (!rough.meets) return std::nullopt;
    if (!rough.bounded) return found;
    const RunningError entry = rough.entry.above / rough.entry.below;
    const RunningError exit = rough.exit.above / rough.exit.below;
    const double room = 0x1p-41 * std::max(std::abs(entry.value), std::abs(exit.value));
    if (entry.bound < room && exit.bound < room && room < 0x1p900) {
      p.entry = std::min(entry.value, exit.value);
      p.exit = exit.value;
      keep(rough);
      return found;
    }
  }
  const auto exact = slab_times<Exact>(slabs_of<Exact>(line, body));
  if (!exact.meets) return std::nullopt;
  if (!exact.bounded) return found;
  p.entry = quotient<double>(exact.entry.above, exact.entry.below);
  p.exit = quotient<double>(exact.exit.above, exact.exit.below);
  keep(exact);
  return found;
}

/// A passage in S whose normals are those of the faces.
template <std::floating_point S, class Normal>
Passage<S> with_normals(const Passage<double>& p, const Normal& normal) {
  return {static_cast<S>(p.entry),
          static_cast<S>(p.exit),
          p.entry_face < 0 ? Vector3<S>(Vector3<S>::Zero()) : normal(p.entry_face),
          p.exit_face < 0 ? Vector3<S>(Vector3<S>::Zero()) : normal(p.exit_face),
          p.entry_face,
          p.exit_face};
}

/// The first hit of a ray or a segment whose passage through slabs is known.
template <std::floating_point S, class Line, class Normal>
std::optional<BodyHit<S>> first_of_slabs(const Line& line, const std::optional<SlabPassage>& found,
                                         const Normal& normal) {
  if (!found || found->exit_sign < 0) return std::nullopt;
  if (has_end<Line> && !found->entry_in_time) return std::nullopt;
  BodyHit<S> hit;
  hit.point = start_of(line);
  hit.inside = found->entry_sign < 0;
  if (hit.inside) return hit;
  const double last = has_end<Line> ? 1.0 : std::numeric_limits<double>::infinity();
  const double t = std::clamp(found->passage.entry, 0.0, last) + 0.0;
  hit.t = static_cast<S>(t);
  hit.face = found->passage.entry_face;
  hit.normal = normal(hit.face);
  hit.point = point_of_line(line, t);
  return hit;
}

/// The unit normal of face 2 k (lower) or 2 k + 1 (upper) of an axis-aligned box; 0 for none (−1).
template <std::floating_point S>
Vector3<S> axis_normal(int face) {
  if (face < 0) return Vector3<S>::Zero();
  return Vector3<S>(Vector3<S>::Unit(face / 2) * S(face % 2 == 1 ? 1 : -1));
}

}  // namespace detail

}  // namespace contact
