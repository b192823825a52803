/// @file
/// Line, ray and segment against a box by slabs: as everyone writes it, padded, and with a decision
/// that is never wrong; also against an oriented box.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <concepts>
#include <contact/aabb.hpp>
#include <contact/error_free.hpp>
#include <contact/exact.hpp>
#include <contact/oriented_box.hpp>
#include <contact/passage.hpp>
#include <contact/products.hpp>
#include <contact/running_error.hpp>
#include <contact/shapes.hpp>
#include <contact/slabs.hpp>
#include <contact/tolerance.hpp>
#include <contact/vector.hpp>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

namespace contact {

/// The number of a box's face: 2 k for the lower face of axis k, 2 k + 1 for the upper one. The
/// axis is not checked.
constexpr int box_face(int axis, bool upper) { return 2 * axis + (upper ? 1 : 0); }

// [with-division]
/// The line through a box by slabs, with one division for each face: entry is the latest entry into
/// a slab, exit the earliest exit.
///
/// Limits: a direction component of 0 divides by 0. That gives ±∞, as wanted, except for an origin
/// on the face: 0/0 is NaN, every comparison with it is false, and the slab is ignored or the box
/// lost, by the order of the comparisons. Rounded: a line that passes an edge closely may be found
/// or missed. Equal entries: the lowest axis.
///
/// A direction of 0 has entry −∞ and exit ∞ in the box, and outside either nothing or entry and
/// exit both −∞ or both ∞. A slab with a NaN of the ray is ignored: a ray of NaN meets every box.
/// An infinite component of the direction is at both planes of its slab at t = 0. Overflow gives an
/// infinite t.
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
  found.entry_normal = detail::axis_normal<S>(found.entry_face);
  found.exit_normal = detail::axis_normal<S>(found.exit_face);
  return found;
}
// [/with-division]

/// The latest entry into the slabs of a box and the earliest exit, as the test is copied
/// everywhere: three reciprocals, then products, minima and maxima without a branch. Directions of
/// 0, infinities and NaN in the ray as for passage_by_slabs_with_division.
// [branchless]
template <std::floating_point S>
std::pair<S, S> branchless_times(const Ray<S>& ray, const Aabb<S>& box) {
  S entry = -std::numeric_limits<S>::infinity();
  S exit = std::numeric_limits<S>::infinity();
  for (int k = 0; k < 3; ++k) {
    const S inverse = S(1) / ray.direction(k);
    const S to_low = (box.low(k) - ray.origin(k)) * inverse;
    const S to_high = (box.high(k) - ray.origin(k)) * inverse;
    entry = std::max(entry, std::min(to_low, to_high));
    exit = std::min(exit, std::max(to_low, to_high));
  }
  return {entry, exit};
}
// [/branchless]

namespace detail {

/// The passage between two t, without faces and normals; none if they are out of order or NaN.
template <std::floating_point S>
std::optional<Passage<S>> passage_between(const S& entry, const S& exit) {
  if (!(entry <= exit)) return std::nullopt;
  Passage<S> found;
  found.entry = entry;
  found.exit = exit;
  return found;
}

}  // namespace detail

/// The line through a box by branchless_times(). No faces and normals.
///
/// Limits: 0 · ∞ is NaN for a line in the plane of a face, and std::min and std::max then return
/// their first argument. Rounded, as above; 1/d is infinite for |d| < 2^-1024. A ray of NaN meets
/// every box.
template <std::floating_point S>
std::optional<Passage<S>> passage_by_branchless_slabs(const Ray<S>& ray, const Aabb<S>& box) {
  const auto [entry, exit] = branchless_times(ray, box);
  return detail::passage_between(entry, exit);
}

// [padded]
/// The same, with the exit multiplied by 1 + 2 γ(3): no hit is lost to the rounding of t, and a
/// near miss may be reported.
///
/// Limits: only a positive exit is enlarged, so the guarantee is for rays (t ≥ 0), without
/// underflow and overflow. 0 · ∞ and NaN as above, also for a component so small that 1/d is
/// infinite.
///
/// Source: Ize, *Robust BVH Ray Traversal*, Journal of Computer Graphics Techniques 2 (2013).
template <std::floating_point S>
std::optional<Passage<S>> passage_by_padded_slabs(const Ray<S>& ray, const Aabb<S>& box) {
  const auto [entry, exit] = branchless_times(ray, box);
  return detail::passage_between(entry, S(exit * (S(1) + S(2) * tolerance::gamma<S>(3))));
}
// [/padded]

/// A box of floats or doubles, unchanged, as doubles: also infinities and NaN.
template <FloatOrDouble S>
Aabb<double> in_double(const Aabb<S>& box) {
  return {box.low.template cast<double>(), box.high.template cast<double>()};
}

namespace detail {

// [rough-box]
/// A decision, if it is certain.
struct Glance {
  bool certain = false;
  bool hit = false;
};

/// Whether a line hits a box, by the branchless slabs.
///
/// Difference, reciprocal, product and, for a segment, direction are rounded: each t is off by at
/// most 4 u of itself. So entry < exit (1 − 10 u) is a hit and entry (1 − 10 u) > exit a miss.
/// 2^-1000 covers underflow. Not certain are components of the direction that are 0, below 2^-511
/// or from 2^513 on (only exponents between set bit 62 when 512 is added to them), an entry beyond
/// 2^1000, and a start beyond 2^960: so no NaN arises, no reciprocal is subnormal, and no
/// difference overflows, because 2^960 is less than half the last place of the largest number. All
/// conditions are computed and joined by &: only a branch on the certainty can be predicted.
/// @tparam closer what costs more time as well, but no rounding: a component of 0 is compared, and
/// a line that starts in the box hits it
template <bool ends, bool closer>
[[gnu::always_inline]] inline Glance box_at_a_glance(const Ray<double>& ray,
                                                     const Aabb<double>& box) {
  constexpr double shorter = 1 - 10 * tolerance::unit_roundoff<double>;
  constexpr double floor = 0x1p-1000;
  constexpr double endless = std::numeric_limits<double>::infinity();
  double entry = 0;
  double exit = ends ? 1.0 : endless;
  std::uint64_t middle = ~std::uint64_t{0};
  int inside = 1, apart = 0;
  for (int k = 0; k < 3; ++k) {
    const double start = ray.origin(k);
    double rate = ray.direction(k);
    bool level = false;
    if constexpr (closer) {
      const int in_slab = int(box.low(k) <= start) & int(start <= box.high(k));
      level = rate == 0;
      inside &= in_slab;
      apart |= int(level) & (1 - in_slab);
      rate = level ? 1 : rate;
    }
    const double inverse = 1 / rate;
    middle &= std::bit_cast<std::uint64_t>(rate) + (std::uint64_t{512} << 52);
    const double to_low = (box.low(k) - start) * inverse;
    const double to_high = (box.high(k) - start) * inverse;
    const double first = std::min(to_low, to_high), last = std::max(to_low, to_high);
    entry = std::max(entry, level ? 0 : first);
    exit = std::min(exit, level ? endless : last);
  }
  const double reach = ray.origin.cwiseAbs().sum();  // of NaN too, which min and max may drop
  const int tame = int(middle >> 62 & 1) & int(entry <= 0x1p1000) & int(reach <= 0x1p960);
  const bool hit = entry + floor < exit * shorter;
  const bool miss = entry * shorter > exit + floor;
  if constexpr (closer) {
    if ((inside | apart) != 0) return {tame != 0, inside != 0};
  }
  return {((int(hit) | int(miss)) & tame) != 0, hit};
}
// [/rough-box]

// [box-time]
/// The t at which a line crosses the plane of a face: (plane − start)/(to − from), where to − from
/// is the component of the direction.
struct BoxTime {
  double plane = 0, start = 0;
  double to = 0, from = 0;  ///< the ends of a segment; a ray's component and 0
  int face = -1;

  bool forwards() const { return to > from; }
  /// Within 3 u of itself, without underflow.
  double t() const {
    const double above = plane - start, below = to - from;
    if (std::isfinite(above) && std::isfinite(below)) return above / below;
    return quotient<double>(Exact(plane) - Exact(start), Exact(to) - Exact(from));
  }
  /// Sign of t: a comparison of stored numbers.
  int sign() const {
    const int ahead = plane > start ? 1 : (plane < start ? -1 : 0);
    return forwards() ? ahead : -ahead;
  }
  /// Whether t ≤ 1, for a segment: the same.
  bool in_time() const { return forwards() ? plane <= to : plane >= to; }
};

/// Sign of x − y. Quotients that are rounded by at most 3 u decide if they are apart. Else, if all
/// differences are exact, as for whole numbers, two products and their difference in double: its
/// sign is right. Else exact arithmetic.
inline int compare(const BoxTime& x, const BoxTime& y) {
  const auto sign = [](const auto& z) { return z > 0 ? 1 : (z < 0 ? -1 : 0); };
  const double tx = x.t(), ty = y.t();
  const double gap = tx - ty;
  const double bound =
      10 * tolerance::unit_roundoff<double> * (std::abs(tx) + std::abs(ty)) + 0x1p-1000;
  if (gap > bound || gap < -bound) return sign(gap);
  const int turned = x.forwards() == y.forwards() ? 1 : -1;
  const auto above_x = two_sum(x.plane, -x.start), above_y = two_sum(y.plane, -y.start);
  const auto below_x = two_sum(x.to, -x.from), below_y = two_sum(y.to, -y.from);
  if (above_x.error == 0 && above_y.error == 0 && below_x.error == 0 && below_y.error == 0 &&
      product_keeps_its_digits(above_x.value, below_y.value) &&
      product_keeps_its_digits(above_y.value, below_x.value)) {
    return turned *
           sign(difference_of_products(above_x.value, below_y.value, above_y.value, below_x.value));
  }
  const Exact first = (Exact(x.plane) - Exact(x.start)) * (Exact(y.to) - Exact(y.from));
  const Exact second = (Exact(y.plane) - Exact(y.start)) * (Exact(x.to) - Exact(x.from));
  return turned * (first - second).sign();
}
// [/box-time]

inline double to_of(const Ray<double>& ray, int k) { return ray.direction(k); }
inline double to_of(const Segment<double>& segment, int k) { return segment.end(k); }
inline double from_of(const Ray<double>&, int) { return 0; }
inline double from_of(const Segment<double>& segment, int k) { return segment.start(k); }

// [box-times]
/// The latest entry and the earliest exit, compared without error; of equal ones the lowest axis.
struct BoxTimes {
  bool meets = true;     ///< whether the unbounded line has a point in the box
  bool bounded = false;  ///< whether the direction is not 0
  BoxTime entry, exit;

  /// Whether a ray, or a line that ends at t = 1, meets the box.
  bool hits(bool ends) const {
    return meets && (!bounded || (exit.sign() >= 0 && (!ends || entry.in_time())));
  }
  bool starts_inside() const { return !bounded || entry.sign() < 0; }
};

/// Computes them. Without a meeting for numbers that are not finite.
template <class Line>
[[gnu::noinline]] BoxTimes box_times(const Line& line, const Aabb<double>& box) {
  const BoxTimes none{false, false, {}, {}};
  if (!is_finite(line) || !all_finite(box.low) || !all_finite(box.high)) return none;
  BoxTimes times;
  const Vector3<double>& start = start_of(line);
  for (int k = 0; k < 3; ++k) {
    const double to = to_of(line, k), from = from_of(line, k);
    if (to == from) {
      if (!(box.low(k) <= start(k) && start(k) <= box.high(k))) return none;
      continue;
    }
    const bool forwards = to > from;
    const BoxTime lower{box.low(k), start(k), to, from, box_face(k, false)};
    const BoxTime upper{box.high(k), start(k), to, from, box_face(k, true)};
    const BoxTime& entry = forwards ? lower : upper;
    const BoxTime& exit = forwards ? upper : lower;
    if (!times.bounded || compare(entry, times.entry) > 0) times.entry = entry;
    if (!times.bounded || compare(exit, times.exit) < 0) times.exit = exit;
    times.bounded = true;
  }
  times.meets = !times.bounded || compare(times.entry, times.exit) <= 0;
  return times;
}
// [/box-times]

/// Whether a line hits a box that is not decided at a glance. It converts to double once more, so
/// that the caller need not keep the numbers in memory.
template <std::floating_point S, class Line>
[[gnu::noinline]] bool hits_box_closely(const Line& line, const Aabb<S>& box) {
  const auto stored = contact::in_double(line);
  const Aabb<double> body = contact::in_double(box);
  const Glance seen = box_at_a_glance<has_end<Line>, true>(ray_of(stored), body);
  if (seen.certain) return seen.hit;
  return box_times(stored, body).hits(has_end<Line>);
}

/// A point of a face, with its coordinate as stored and the others not outside the box.
template <std::floating_point S>
Vector3<S> onto_face(const Vector3<S>& point, const Aabb<S>& box, int face) {
  const int k = face / 2;
  Vector3<S> result = point.cwiseMax(box.low).cwiseMin(box.high);
  result(k) = face % 2 == 1 ? box.high(k) : box.low(k);
  return result;
}

}  // namespace detail

// [hits-box]
/// Whether a ray or a segment meets a solid box. Touching counts.
///
/// Right for every finite input: the branchless slabs decide if entry and exit are further apart
/// than their errors. Else the same is tried with comparisons for a start in the box and for
/// components of 0; else products are compared without error. A component of 0 is compared, not
/// divided by; a line in a face, an edge or a corner meets the box. A direction of 0 is a point. A
/// line that is not finite: no. A box with low > high or a number that is not finite is an error of
/// the program, as in Aabb, and gets any answer.
template <FloatOrDouble S, LineOf<S> Line>
bool hits_box(const Line& line, const Aabb<S>& box) {
  const detail::Glance seen =
      detail::box_at_a_glance<has_end<Line>, false>(ray_of(in_double(line)), in_double(box));
  return seen.certain ? seen.hit : detail::hits_box_closely(line, box);
}
// [/hits-box]

// [box-passage]
/// Where the unbounded line through a ray or a segment enters and leaves a box: the book's choice.
///
/// The decision is right for every finite line. Faces as box_face; of faces that are entered at the
/// same t that of the lowest axis, decided exactly; −1 and normal 0 where t is infinite (a
/// direction of 0). Each t has a relative error of at most 3 u (of double, and then rounded to S),
/// without underflow; beyond the largest number it is infinite. Nothing for a box with low > high
/// and numbers that are not finite.
template <FloatOrDouble S, LineOf<S> Line>
std::optional<Passage<S>> passage(const Line& line, const Aabb<S>& box) {
  const detail::BoxTimes times = detail::box_times(in_double(line), in_double(box));
  if (!times.meets) return std::nullopt;
  Passage<double> found;
  found.exit = std::numeric_limits<double>::infinity();
  found.entry = -found.exit;
  if (times.bounded) {
    found.exit = times.exit.t();
    found.entry = std::min(times.entry.t(), found.exit);
    found.entry_face = times.entry.face;
    found.exit_face = times.exit.face;
  }
  return detail::with_normals<S>(found, detail::axis_normal<S>);
}
// [/box-passage]

// [first-hit-box]
/// What a ray or a segment meets first of a solid box.
///
/// Decision, face and `inside` are exact: inside if the start is in the box and not on a face that
/// the line enters. On the face from which it enters t = 0. A direction of 0 is a point. Nothing
/// for a box with low > high and numbers that are not finite.
///
/// The point's coordinate on the face is the stored one; the others are off by at most 6 u of their
/// two terms, and never outside the box, even of an infinite t. t as in passage.
template <FloatOrDouble S, LineOf<S> Line>
std::optional<BodyHit<S>> first_hit(const Line& line, const Aabb<S>& box) {
  const auto stored = in_double(line);
  const Aabb<double> body = in_double(box);
  const detail::Glance seen = detail::box_at_a_glance<has_end<Line>, false>(ray_of(stored), body);
  if (seen.certain && !seen.hit) return std::nullopt;
  const detail::BoxTimes times = detail::box_times(stored, body);
  if (!times.hits(has_end<Line>)) return std::nullopt;
  BodyHit<S> hit;
  hit.point = start_of(line);
  hit.inside = times.starts_inside();
  if (hit.inside) return hit;
  const double last = has_end<Line> ? 1.0 : std::numeric_limits<double>::infinity();
  const double t = std::clamp(times.entry.t(), 0.0, last) + 0.0;  // not −0
  hit.t = static_cast<S>(t);
  hit.face = times.entry.face;
  hit.normal = detail::axis_normal<S>(hit.face);
  hit.point = detail::onto_face<S>(detail::point_of_line(line, t), box, hit.face);
  return hit;
}
// [/first-hit-box]

// [by-frame]
/// The line through an oriented box by slabs in the box's frame: rotated there, then as
/// passage_by_slabs_with_division; the normals are rotated back.
///
/// Limits: those of passage_by_slabs_with_division, also for a direction of 0, and the rotation
/// rounds, so that a line in a face is no longer in it. A NaN in the ray, whose rotation has more
/// of them, meets every box.
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

// [oriented-slabs]
/// The stored body of an oriented box as slabs: with n the cross product of the other two axes, |n
/// · (x − centre)| ≤ h |n · axis|. Axes in one plane make slabs without thickness. For T = Exact
/// all numbers must be finite.
template <class T, class Line>
std::array<Slab<T>, 3> slabs_of(const Line& line, const OrientedBox<double>& box) {
  using namespace detail;
  const std::array<Triple<T>, 3> axes{triple<T>(box.axes.col(0)), triple<T>(box.axes.col(1)),
                                      triple<T>(box.axes.col(2))};
  const Triple<T> from_centre = minus(triple<T>(start_of(line)), triple<T>(box.centre));
  const Triple<T> direction = direction_of<T>(line);
  std::array<Slab<T>, 3> slabs;
  for (std::size_t k = 0; k < 3; ++k) {
    const Triple<T> n = cross(axes[(k + 1) % 3], axes[(k + 2) % 3]);
    const T height = dot(n, axes[k]) * T(box.half_lengths(int(k)));
    const T at = dot(n, from_centre);
    const T speed = dot(n, direction);
    // A left-handed frame has a negative volume: then n points against the axis.
    bool sure = true;
    const bool turned = sign_of(height, sure) < 0;
    slabs[k] = turned ? Slab<T>{height + at, at - height, -speed}
                      : Slab<T>{-height - at, height - at, speed};
  }
  return slabs;
}
// [/oriented-slabs]

namespace detail {

template <FloatOrDouble S>
OrientedBox<double> in_double(const OrientedBox<S>& box) {
  return {box.centre.template cast<double>(), box.axes.template cast<double>(),
          box.half_lengths.template cast<double>()};
}

template <FloatOrDouble S>
bool box_is_finite(const OrientedBox<S>& box) {
  return all_finite(box.centre) && all_finite(box.axes) && all_finite(box.half_lengths);
}

/// The unit outward normals of a box's faces: the stored axes.
template <FloatOrDouble S>
auto normals_of(const OrientedBox<S>& box) {
  return [&box](int face) {
    const Vector3<S> axis = box.axes.col(face / 2);
    return face % 2 == 1 ? axis : Vector3<S>(-axis);
  };
}

}  // namespace detail

// [hits-oriented-box]
/// Whether a ray or a segment meets a solid oriented box. Touching counts.
///
/// Right for every finite input, about the stored body, the parallelepiped that the stored axes
/// span; axes in one plane and half lengths that are negative make an error of the program, and get
/// any answer. A number that is not finite: no.
template <FloatOrDouble S, LineOf<S> Line>
bool hits_box(const Line& line, const OrientedBox<S>& box) {
  if (!is_finite(line) || !detail::box_is_finite(box)) return false;
  return detail::hits_slabs(in_double(line), detail::in_double(box));
}
// [/hits-oriented-box]

/// Where the unbounded line through a ray or a segment enters and leaves an oriented box.
///
/// The decision is that of hits_box. Faces as box_face, of the box's axes; ties as for an Aabb.
/// Normals are the stored axes. Each t is within 2^-40 of the larger magnitude of both; beyond the
/// largest number it is infinite. A direction of 0 in the box has entry −∞, exit ∞ and normals 0.
template <FloatOrDouble S, LineOf<S> Line>
std::optional<Passage<S>> passage(const Line& line, const OrientedBox<S>& box) {
  if (!is_finite(line) || !detail::box_is_finite(box)) return std::nullopt;
  const auto found = detail::slabs_passage(in_double(line), detail::in_double(box));
  if (!found) return std::nullopt;
  return detail::with_normals<S>(found->passage, detail::normals_of(box));
}

/// What a ray or a segment meets first of a solid oriented box. Decision, face and `inside` are
/// exact; t as in passage, and the point off by that times the direction and by 6 u of its terms,
/// so infinite with t. Nothing where hits_box says no.
template <FloatOrDouble S, LineOf<S> Line>
std::optional<BodyHit<S>> first_hit(const Line& line, const OrientedBox<S>& box) {
  if (!is_finite(line) || !detail::box_is_finite(box)) return std::nullopt;
  const auto found = detail::slabs_passage(in_double(line), detail::in_double(box));
  return detail::first_of_slabs<S>(line, found, detail::normals_of(box));
}

}  // namespace contact
