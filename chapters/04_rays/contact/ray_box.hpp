/// @file
/// Line, ray and segment against a box by slabs: as everyone writes it, padded, and with a decision
/// that is never wrong; also against an oriented box.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <contact/aabb.hpp>
#include <contact/exact.hpp>
#include <contact/oriented_box.hpp>
#include <contact/passage.hpp>
#include <contact/shapes.hpp>
#include <contact/slabs.hpp>
#include <contact/tolerance.hpp>
#include <contact/vector.hpp>
#include <limits>
#include <optional>
#include <utility>

namespace contact {

/// The number of a box's face: 2 k for the lower face of axis k, 2 k + 1 for the upper one.
constexpr int box_face(int axis, bool upper) { return 2 * axis + (upper ? 1 : 0); }

// [with-division]
/// The line through a box by slabs, with one division for each face: entry is the latest entry into
/// a slab, exit the earliest exit.
///
/// Limits: a direction component of 0 divides by 0. That gives ±∞, as wanted, except for an origin
/// on the face: 0/0 is NaN, every comparison with it is false, and the slab is ignored or the box
/// lost, by the order of the comparisons. Rounded: a line that passes an edge closely may be found
/// or missed. Equal entries: the lowest axis.
template <std::floating_point S>
std::optional<Passage<S>> passage_by_slabs_with_division(const Ray<S>& ray, const Aabb<S>& box) {
  Passage<S> found;
  found.exit = std::numeric_limits<S>::infinity();
  found.entry = -found.exit;
  for (int k = 0; k < 3; ++k) {
    S first = (box.low(k) - ray.origin(k)) / ray.direction(k);
    S last = (box.high(k) - ray.origin(k)) / ray.direction(k);
    const bool backwards = first > last;
    if (backwards) std::swap(first, last);
    if (first > found.entry) {
      found.entry = first;
      found.entry_face = box_face(k, backwards);
    }
    if (last < found.exit) {
      found.exit = last;
      found.exit_face = box_face(k, !backwards);
    }
    if (found.entry > found.exit) return std::nullopt;
  }
  detail::set_box_normals(found);
  return found;
}
// [/with-division]

// [branchless]
/// The same as it is copied everywhere: three reciprocals, then products, minima and maxima without
/// a branch. No faces and normals.
///
/// Limits: 0 · ∞ is NaN for a line in the plane of a face, and std::min and std::max then return
/// their first argument. Rounded, as above; 1/d is infinite for |d| < 2^-1024.
template <std::floating_point S>
std::optional<Passage<S>> passage_by_branchless_slabs(const Ray<S>& ray, const Aabb<S>& box) {
  S entry = -std::numeric_limits<S>::infinity();
  S exit = std::numeric_limits<S>::infinity();
  for (int k = 0; k < 3; ++k) {
    const S inverse = S(1) / ray.direction(k);
    const S to_low = (box.low(k) - ray.origin(k)) * inverse;
    const S to_high = (box.high(k) - ray.origin(k)) * inverse;
    entry = std::max(entry, std::min(to_low, to_high));
    exit = std::min(exit, std::max(to_low, to_high));
  }
  if (!(entry <= exit)) return std::nullopt;
  Passage<S> found;
  found.entry = entry;
  found.exit = exit;
  return found;
}
// [/branchless]

// [padded]
/// The same, with the exit multiplied by 1 + 2 γ(3): no hit is lost to the rounding of t, and a
/// near miss may be reported.
///
/// Limits: only a positive exit is enlarged, so the guarantee is for rays (t ≥ 0), without
/// underflow and overflow. 0 · ∞ as above.
///
/// Source: Ize, *Robust BVH Ray Traversal*, Journal of Computer Graphics Techniques 2 (2013).
template <std::floating_point S>
std::optional<Passage<S>> passage_by_padded_slabs(const Ray<S>& ray, const Aabb<S>& box) {
  S entry = -std::numeric_limits<S>::infinity();
  S exit = std::numeric_limits<S>::infinity();
  for (int k = 0; k < 3; ++k) {
    const S inverse = S(1) / ray.direction(k);
    const S to_low = (box.low(k) - ray.origin(k)) * inverse;
    const S to_high = (box.high(k) - ray.origin(k)) * inverse;
    entry = std::max(entry, std::min(to_low, to_high));
    exit = std::min(exit, std::max(to_low, to_high));
  }
  exit *= S(1) + S(2) * tolerance::gamma<S>(3);
  if (!(entry <= exit)) return std::nullopt;
  Passage<S> found;
  found.entry = entry;
  found.exit = exit;
  return found;
}
// [/padded]

/// A box of floats or doubles, unchanged, as doubles.
template <FloatOrDouble S>
Aabb<double> in_double(const Aabb<S>& box) {
  return {box.low.template cast<double>(), box.high.template cast<double>()};
}

namespace detail {

/// A box as slabs of a line: low − origin ≤ t direction ≤ high − origin.
inline std::array<Slab<Exact>, 3> exact_slabs(const Ray<Exact>& ray, const Aabb<double>& box) {
  std::array<Slab<Exact>, 3> slabs;
  for (int k = 0; k < 3; ++k) {
    slabs[std::size_t(k)] = {Exact(box.low(k)) - ray.origin(k), Exact(box.high(k)) - ray.origin(k),
                             ray.direction(k)};
  }
  return slabs;
}

}  // namespace detail

/// Whether a ray or a segment meets a solid box. Touching counts.
///
/// Right for every finite input. A component of 0 is compared, not divided by; a line in a face, an
/// edge or a corner meets the box. A direction of 0 is a point. A line that is not finite: no. A
/// box with low > high is empty: no.
template <FloatOrDouble S, LineOf<S> Line>
bool hits_box(const Line& line, const Aabb<S>& box) {
  if (!is_finite(line)) return false;
  return hits_slabs(detail::exact_slabs(exact_ray_of(line), in_double(box)), has_end<Line>);
}

/// Where the unbounded line through a ray or a segment enters and leaves a box: the book's choice.
///
/// The decision is right as that of hits_box. Faces as box_face; of faces that are entered at the
/// same t the one of the lowest axis, decided exactly; −1 and normal 0 where t is infinite (a
/// direction of 0).
template <FloatOrDouble S, LineOf<S> Line>
std::optional<Passage<S>> passage(const Line& line, const Aabb<S>& box) {
  if (!is_finite(line)) return std::nullopt;
  std::optional<Passage<S>> found =
      slabs_passage<S>(detail::exact_slabs(exact_ray_of(line), in_double(box)));
  if (found) detail::set_box_normals(*found);
  return found;
}

/// What a ray or a segment meets first of a solid box. Decision, face and `inside` are exact.
template <FloatOrDouble S, LineOf<S> Line>
std::optional<BodyHit<S>> first_hit(const Line& line, const Aabb<S>& box) {
  if (!hits_box(line, box)) return std::nullopt;
  return first_hit(line, *passage(line, box));
}

// [by-frame]
/// The line through an oriented box by slabs in the box's frame: rotated there, then as
/// passage_by_slabs_with_division; the normals are rotated back.
///
/// Limits: those of passage_by_slabs_with_division, and the rotation rounds, so that a line in a
/// face is no longer in it.
template <std::floating_point S>
std::optional<Passage<S>> passage_by_frame(const Ray<S>& ray, const OrientedBox<S>& box) {
  const Matrix3<S> to_box = box.axes.transpose();
  const Ray<S> there{Vector3<S>(to_box * Vector3<S>(ray.origin - box.centre)),
                     Vector3<S>(to_box * ray.direction)};
  std::optional<Passage<S>> found = passage_by_slabs_with_division<S>(
      there, Aabb<S>{Vector3<S>(-box.half_lengths), box.half_lengths});
  if (!found) return found;
  found->entry_normal = box.axes * found->entry_normal;
  found->exit_normal = box.axes * found->exit_normal;
  return found;
}
// [/by-frame]

namespace detail {

/// The stored body of an oriented box as slabs: with n the cross product of the other two axes and
/// det the volume of the axes, |n · (x − centre)| ≤ det h.
inline std::array<Slab<Exact>, 3> exact_slabs(const Ray<Exact>& ray,
                                              const OrientedBox<double>& box) {
  std::array<Vector3<Exact>, 3> axes;
  for (int k = 0; k < 3; ++k) axes[std::size_t(k)] = exact_vector(Vector3<double>(box.axes.col(k)));
  const Vector3<Exact> m = ray.origin - exact_vector(box.centre);
  std::array<Slab<Exact>, 3> slabs;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3<Exact> n = axes[(k + 1) % 3].cross(axes[(k + 2) % 3]);
    const Exact half = abs(Exact(n.dot(axes[k]))) * Exact(box.half_lengths(int(k)));
    const Exact from_centre = n.dot(m);
    slabs[k] = {-half - from_centre, half - from_centre, n.dot(ray.direction)};
  }
  return slabs;
}

template <FloatOrDouble S>
OrientedBox<double> in_double(const OrientedBox<S>& box) {
  return {box.centre.template cast<double>(), box.axes.template cast<double>(),
          box.half_lengths.template cast<double>()};
}

template <FloatOrDouble S>
bool is_finite(const OrientedBox<S>& box) {
  return all_finite(box.centre) && all_finite(box.axes) && all_finite(box.half_lengths);
}

}  // namespace detail

/// Whether a ray or a segment meets a solid oriented box. Touching counts.
///
/// Right for every finite input, about the stored body: the parallelepiped that the stored axes
/// span. Not finite: no.
template <FloatOrDouble S, LineOf<S> Line>
bool hits_box(const Line& line, const OrientedBox<S>& box) {
  if (!is_finite(line) || !detail::is_finite(box)) return false;
  return hits_slabs(detail::exact_slabs(exact_ray_of(line), detail::in_double(box)), has_end<Line>);
}

/// Where the unbounded line through a ray or a segment enters and leaves an oriented box. Faces as
/// box_face; normals are the stored axes.
template <FloatOrDouble S, LineOf<S> Line>
std::optional<Passage<S>> passage(const Line& line, const OrientedBox<S>& box) {
  if (!is_finite(line) || !detail::is_finite(box)) return std::nullopt;
  std::optional<Passage<S>> found =
      slabs_passage<S>(detail::exact_slabs(exact_ray_of(line), detail::in_double(box)));
  if (!found) return found;
  detail::set_box_normals(*found);
  found->entry_normal = box.axes * found->entry_normal;
  found->exit_normal = box.axes * found->exit_normal;
  return found;
}

/// What a ray or a segment meets first of a solid oriented box.
template <FloatOrDouble S, LineOf<S> Line>
std::optional<BodyHit<S>> first_hit(const Line& line, const OrientedBox<S>& box) {
  if (!hits_box(line, box)) return std::nullopt;
  return first_hit(line, *passage(line, box));
}

}  // namespace contact
