/// @file
/// Whether two triangles meet, never wrong for finite input: also where they touch, lie in one
/// plane, or have no area.
#pragma once

#include <algorithm>
#include <array>
#include <contact/exact_ray_triangle.hpp>
#include <contact/orientation.hpp>
#include <contact/pair_orientations.hpp>
#include <contact/segments.hpp>
#include <contact/shapes.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace triangles_meet_detail {

using pair_orientations_detail::as_stored;
using pair_orientations_detail::Flat;
using pair_orientations_detail::Sides;
using Point = Vector3<double>;
using FlatPoint = Vector2<double>;

/// Signs by exact arithmetic alone.
struct Exactly {
  int volume(const Point& a, const Point& b, const Point& c, const Point& d) const {
    return orient_3d_exactly(a, b, c, d);
  }
  int area(const FlatPoint& a, const FlatPoint& b, const FlatPoint& c) const {
    return orient_2d_exactly(a, b, c);
  }
};
/// Signs by a filter, and exact arithmetic where it is not certain.
struct Filtered {
  int volume(const Point& a, const Point& b, const Point& c, const Point& d) const {
    return orient_3d(a, b, c, d);
  }
  int area(const FlatPoint& a, const FlatPoint& b, const FlatPoint& c) const {
    return orient_2d(a, b, c);
  }
};

/// The decision, with signs that are never wrong.
template <class Signs>
class Decision {
 public:
  Decision(const Triangle<double>& first, const Triangle<double>& second)
      : first_(first), second_(second) {}

  // [decide]
  /// If the vertices of neither triangle are all on the plane of the other, both have area: a
  /// triangle without it has a volume of 0 with every point. Then the planes cross in a line, and
  /// the intervals on it decide.
  bool meet() const {
    using namespace pair_orientations_detail;
    const Sides of_first = sides(second_, first_);
    if (on_one_side(of_first)) return false;
    if (on_the_plane(of_first)) return meet_flat();
    const Sides of_second = sides(first_, second_);
    if (on_one_side(of_second)) return false;
    if (on_the_plane(of_second)) return meet_flat();
    return intervals_overlap(as_stored(first_), as_stored(second_), of_first, of_second, volume());
  }
  // [/decide]

 private:
  const Triangle<double>& first_;
  const Triangle<double>& second_;
  Signs signs_;

  auto volume() const {
    return [this](const Point& a, const Point& b, const Point& c, const Point& d) {
      return signs_.volume(a, b, c, d);
    };
  }
  auto area() const {
    return [this](const FlatPoint& a, const FlatPoint& b, const FlatPoint& c) {
      return signs_.area(a, b, c);
    };
  }
  Sides sides(const Triangle<double>& plane, const Triangle<double>& of) const {
    const auto side = [&](const Point& v) { return signs_.volume(plane.a, plane.b, plane.c, v); };
    return {side(of.a), side(of.b), side(of.c)};
  }

  /// A projection in which the triangle has area, the one with the largest area first; {0, 0} if it
  /// has none.
  FlatView view(const Triangle<double>& t) const {
    const Point ab = t.b - t.a, ac = t.c - t.a;
    const int largest = largest_dimension<double>(ab.cross(ac));
    for (int i = 0; i < 3; ++i) {
      const int k = (largest + i) % 3;
      const Flat<double> flat = pair_orientations_detail::flattened<double>(t, k);
      const int orientation = signs_.area(flat[0], flat[1], flat[2]);
      if (orientation != 0) return {k, orientation};
    }
    return {};
  }

  // [flat]
  /// Both triangles are in one plane, or at least one of them has no area.
  bool meet_flat() const {
    const FlatView of_first = view(first_), of_second = view(second_);
    if (of_first.orientation != 0 && of_second.orientation != 0) {
      return meet_coplanar(of_first.dropped);
    }
    if (of_first.orientation != 0) return segment_meets(as_segment(second_), first_, of_first);
    if (of_second.orientation != 0) return segment_meets(as_segment(first_), second_, of_second);
    return segments_meet(as_segment(first_), as_segment(second_));
  }
  // [/flat]

  bool meet_coplanar(int dropped) const {
    using namespace pair_orientations_detail;
    const Flat<double> u = flattened<double>(first_, dropped);
    const Flat<double> v = flattened<double>(second_, dropped);
    return meet_in_plane(counter_clockwise<double>(u, signs_.area(u[0], u[1], u[2])),
                         counter_clockwise<double>(v, signs_.area(v[0], v[1], v[2])), area());
  }

  /// The segment or the point that a triangle without area is: on a line, the first and the last
  /// of three points by their coordinates are the ends.
  static Segment<double> as_segment(const Triangle<double>& t) {
    const auto before = [](const Point& p, const Point& q) {
      return std::lexicographical_compare(p.data(), p.data() + 3, q.data(), q.data() + 3);
    };
    const auto [low, high] = std::minmax({t.a, t.b, t.c}, before);
    return {low, high};
  }

  /// A segment or a point, and a triangle with area.
  bool segment_meets(const Segment<double>& s, const Triangle<double>& t,
                     const FlatView& view) const {
    const int at_start = signs_.volume(t.a, t.b, t.c, s.start);
    const int at_end = signs_.volume(t.a, t.b, t.c, s.end);
    if (at_start * at_end > 0) return false;
    if (at_start == 0 && at_end == 0) return flat_segment_meets(s, t, view);
    const int ab = signs_.volume(s.start, s.end, t.a, t.b);
    const int bc = signs_.volume(s.start, s.end, t.b, t.c);
    const int ca = signs_.volume(s.start, s.end, t.c, t.a);
    return ab * bc >= 0 && bc * ca >= 0 && ca * ab >= 0;
  }

  /// The same in the plane of the triangle. They are apart if a line along one of their edges
  /// separates them; a point has no such line.
  bool flat_segment_meets(const Segment<double>& s, const Triangle<double>& t,
                          const FlatView& view) const {
    const FlatPoint start = drop_dimension<double>(s.start, view.dropped);
    const FlatPoint end = drop_dimension<double>(s.end, view.dropped);
    const Flat<double> flat = pair_orientations_detail::flattened<double>(t, view.dropped);
    Sides sides{};
    for (std::size_t i = 0; i < 3; ++i) {
      const FlatPoint &a = flat[i], &b = flat[(i + 1) % 3];
      if (signs_.area(a, b, start) * view.orientation < 0 &&
          signs_.area(a, b, end) * view.orientation < 0) {
        return false;
      }
      sides[i] = signs_.area(start, end, a);
    }
    return !pair_orientations_detail::on_one_side(sides);
  }

  /// Two segments, of which any may be a point. If they are in one plane but not on one line, one
  /// of four triangles has area, and its projection decides. On one line the boxes decide.
  bool segments_meet(const Segment<double>& s, const Segment<double>& t) const {
    if (signs_.volume(s.start, s.end, t.start, t.end) != 0) return false;
    for (const Triangle<double>& plane :
         {Triangle<double>{s.start, s.end, t.start}, Triangle<double>{s.start, s.end, t.end},
          Triangle<double>{t.start, t.end, s.start}}) {
      const FlatView seen = view(plane);
      if (seen.orientation == 0) continue;
      const auto flat = [k = seen.dropped](const Segment<double>& u) {
        return Segment2<double>{drop_dimension<double>(u.start, k),
                                drop_dimension<double>(u.end, k)};
      };
      return segments_detail::meet_by(flat(s), flat(t), area()) != Meeting::none;
    }
    for (int k = 0; k < 3; ++k) {
      if (std::max(s.start[k], s.end[k]) < std::min(t.start[k], t.end[k])) return false;
      if (std::max(t.start[k], t.end[k]) < std::min(s.start[k], s.end[k])) return false;
    }
    return true;
  }
};

/// Whether all coordinates are finite.
inline bool is_finite_triangle(const Triangle<double>& t) {
  return all_finite(t.a) && all_finite(t.b) && all_finite(t.c);
}

}  // namespace triangles_meet_detail

// [triangles-meet]
/// Whether two triangles have a point in common: the book's choice.
///
/// The answer is right for every finite input: a floating-point filter decides most signs, and
/// exact arithmetic the rest. Touching counts. A triangle without area is the segment or the point
/// that its vertices span. A coordinate that is not finite: false.
/// @param first m, any scale
/// @param second m, any scale
///
/// Source: Guigue and Devillers, Fast and Robust Triangle-Triangle Overlap Test Using Orientation
/// Predicates, Journal of Graphics Tools 8 (2003).
template <FloatOrDouble S>
bool triangles_meet(const Triangle<S>& first, const Triangle<S>& second) {
  using namespace triangles_meet_detail;
  const Triangle<double> a = in_double(first), b = in_double(second);
  if (!is_finite_triangle(a) || !is_finite_triangle(b)) return false;
  return Decision<Filtered>(a, b).meet();
}
// [/triangles-meet]

/// The same decision, every sign in exact arithmetic: slow. It shows what the filter saves.
template <FloatOrDouble S>
bool triangles_meet_unfiltered(const Triangle<S>& first, const Triangle<S>& second) {
  using namespace triangles_meet_detail;
  const Triangle<double> a = in_double(first), b = in_double(second);
  if (!is_finite_triangle(a) || !is_finite_triangle(b)) return false;
  return Decision<Exactly>(a, b).meet();
}

}  // namespace contact
