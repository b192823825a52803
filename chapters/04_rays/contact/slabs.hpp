/// @file
/// Intersections of slabs along a line, decided without a division.
#pragma once

#include <contact/exact.hpp>
#include <contact/passage.hpp>
#include <limits>
#include <optional>
#include <type_traits>

namespace contact {

// [slab]
/// The part of a line between two parallel planes: low ≤ t speed ≤ high.
template <Ring T>
struct Slab {
  T low = T(0);    ///< from the start of the line to the lower plane
  T high = T(0);   ///< from the start of the line to the upper plane
  T speed = T(0);  ///< along the normal for each unit of t; 0 for a line parallel to the planes
};

/// A quotient that is compared without division; the denominator is positive.
template <Ring T>
struct SlabTime {
  T above;        ///< numerator
  T below;        ///< denominator, > 0
  int face = -1;  ///< 2 k for the lower plane of slab k, 2 k + 1 for the upper one

  /// Whether this time is before the other.
  bool before(const SlabTime& other) const { return above * other.below < other.above * below; }
};
// [/slab]

// [slabs]
/// The latest entry and the earliest exit of slabs. Of equal ones the lowest slab.
template <Ring T>
struct SlabTimes {
  bool apart = false;                ///< a slab that the line is parallel to does not contain it
  std::optional<SlabTime<T>> entry;  ///< nothing if the line is parallel to all slabs
  std::optional<SlabTime<T>> exit;   ///< the same

  /// Whether the line has a point in all slabs.
  bool meet() const { return !apart && (!entry || !exit->before(*entry)); }
};

/// Computes them.
/// @param slabs a range of Slab<T>
template <class Slabs>
auto slab_times(const Slabs& slabs) {
  using T = std::remove_cvref_t<decltype(slabs[0].low)>;
  SlabTimes<T> times;
  int k = 0;
  for (const Slab<T>& slab : slabs) {
    if (slab.high < slab.low) times.apart = true;
    if (slab.speed == T(0)) {
      if (T(0) < slab.low || slab.high < T(0)) times.apart = true;
    } else {
      const bool forwards = T(0) < slab.speed;
      const T below = forwards ? slab.speed : T(-slab.speed);
      const SlabTime<T> entry{forwards ? slab.low : T(-slab.high), below,
                              2 * k + (forwards ? 0 : 1)};
      const SlabTime<T> exit{forwards ? slab.high : T(-slab.low), below,
                             2 * k + (forwards ? 1 : 0)};
      if (!times.entry || times.entry->before(entry)) times.entry = entry;
      if (!times.exit || exit.before(*times.exit)) times.exit = exit;
    }
    ++k;
  }
  return times;
}
// [/slabs]

/// Whether a ray (or, with `has_last`, a segment that ends at t = 1) has a point in all slabs.
template <class Slabs>
bool hits_slabs(const Slabs& slabs, bool has_last) {
  const auto times = slab_times(slabs);
  using T = std::remove_cvref_t<decltype(slabs[0].low)>;
  if (!times.meet()) return false;
  if (!times.entry) return true;
  return !(times.exit->above < T(0)) && !(has_last && times.entry->below < times.entry->above);
}

/// The passage of a line through exactly known slabs: no normals; both t rounded once.
template <std::floating_point S, class Slabs>
std::optional<Passage<S>> slabs_passage(const Slabs& slabs) {
  const auto times = slab_times(slabs);
  if (!times.meet()) return std::nullopt;
  Passage<S> found;
  found.exit = std::numeric_limits<S>::infinity();
  found.entry = -found.exit;
  if (!times.entry) return found;
  found.entry = quotient<S>(times.entry->above, times.entry->below);
  found.exit = quotient<S>(times.exit->above, times.exit->below);
  found.entry_face = times.entry->face;
  found.exit_face = times.exit->face;
  return found;
}

namespace detail {

/// The outward normals of a box's faces.
template <std::floating_point S>
void set_box_normals(Passage<S>& found) {
  const auto normal = [](int face) {
    return face < 0 ? Vector3<S>(Vector3<S>::Zero())
                    : Vector3<S>(Vector3<S>::Unit(face / 2) * S(face % 2 == 1 ? 1 : -1));
  };
  found.entry_normal = normal(found.entry_face);
  found.exit_normal = normal(found.exit_face);
}

}  // namespace detail

}  // namespace contact
