/// @file
/// Whether two triangles meet, from signs that are never wrong: the method of Guigue and Devillers,
/// completed for triangles without area.
#pragma once

#include <algorithm>
#include <array>
#include <contact/drop_dimension.hpp>
#include <contact/orientation.hpp>
#include <contact/pair_orientations.hpp>
#include <contact/pair_signs.hpp>
#include <contact/vector.hpp>
#include <cstddef>

namespace contact::pair_decision_detail {

using pair_orientations_detail::Ordered;
using pair_orientations_detail::Sides;
using Three = Ordered<Vertex>;

/// Two vertices: the segment between them, or a point.
struct Two {
  Vertex start, end;
};

/// The decision, with signs that are never wrong.
/// @tparam Signs has plane(a, b, c), side(plane, v) and area(k, a, b, c)
template <class Signs>
class Decision {
 public:
  /// @param at the six vertices
  Decision(const Vertices& at, const Signs& signs) : at_(at), signs_(signs) {}

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
    return intervals_overlap(
        first_, second_, apex(of_first), apex(of_second),
        [this](Vertex a, Vertex b, Vertex c, Vertex d) { return volume(a, b, c, d); });
  }
  // [/decide]

 private:
  const Vertices& at_;
  const Signs& signs_;
  static constexpr Three first_{0, 1, 2}, second_{3, 4, 5};

  int volume(Vertex a, Vertex b, Vertex c, Vertex d) const {
    return signs_.side(signs_.plane(a, b, c), d);
  }
  /// Orientations in the projection without coordinate k.
  auto area(int k) const {
    return [this, k](Vertex a, Vertex b, Vertex c) { return signs_.area(k, a, b, c); };
  }
  Sides sides(const Three& plane, const Three& of) const {
    const auto p = signs_.plane(plane.a, plane.b, plane.c);
    return {signs_.side(p, of.a), signs_.side(p, of.b), signs_.side(p, of.c)};
  }

  /// A projection in which the triangle has area, first that in which the rounded area is largest;
  /// {0, 0} if it has none.
  FlatView view(const Three& t) const {
    const Vector3<double> ab = at_[t.b] - at_[t.a], ac = at_[t.c] - at_[t.a];
    const int largest = largest_dimension<double>(ab.cross(ac));
    for (int i = 0; i < 3; ++i) {
      const int k = (largest + i) % 3;
      const int orientation = signs_.area(k, t.a, t.b, t.c);
      if (orientation != 0) return {k, orientation};
    }
    return {};
  }

  // [flat]
  /// Both triangles are in one plane, or at least one of them has no area.
  bool meet_flat() const {
    using namespace pair_orientations_detail;
    const FlatView of_first = view(first_);
    if (of_first.orientation == 0) {
      const FlatView of_second = view(second_);
      if (of_second.orientation == 0) return segments_meet(as_segment(first_), as_segment(second_));
      return segment_meets(as_segment(first_), second_, of_second);
    }
    const auto turn = area(of_first.dropped);
    const int of_second = turn(second_.a, second_.b, second_.c);
    if (of_second == 0 && view(second_).orientation == 0) {
      return segment_meets(as_segment(second_), first_, of_first);
    }
    // In one plane, so both have area in the same projections.
    return meet_in_plane(counter_clockwise(first_, of_first.orientation),
                         counter_clockwise(second_, of_second), turn);
  }
  // [/flat]

  /// The ends of a triangle without area: on a line, the first and the last of three points by
  /// their coordinates.
  Two as_segment(const Three& t) const {
    const auto before = [this](Vertex i, Vertex j) {
      return std::lexicographical_compare(at_[i].data(), at_[i].data() + 3, at_[j].data(),
                                          at_[j].data() + 3);
    };
    const auto [low, high] = std::minmax({t.a, t.b, t.c}, before);
    return {low, high};
  }

  /// A segment or a point, and a triangle with area.
  bool segment_meets(const Two& s, const Three& t, const FlatView& view) const {
    const auto plane = signs_.plane(t.a, t.b, t.c);
    const int at_start = signs_.side(plane, s.start), at_end = signs_.side(plane, s.end);
    if (at_start * at_end > 0) return false;
    if (at_start == 0 && at_end == 0) return flat_segment_meets(s, t, view);
    const int ab = volume(s.start, s.end, t.a, t.b);
    const int bc = volume(s.start, s.end, t.b, t.c);
    const int ca = volume(s.start, s.end, t.c, t.a);
    return ab * bc >= 0 && bc * ca >= 0 && ca * ab >= 0;
  }

  /// The same in the plane of the triangle. They are apart if and only if the line of an edge of
  /// the triangle or of the segment separates them strictly; a point has no line.
  bool flat_segment_meets(const Two& s, const Three& t, const FlatView& view) const {
    const auto turn = area(view.dropped);
    const std::array<Vertex, 3> around{t.a, t.b, t.c};
    Sides sides{};
    for (std::size_t i = 0; i < 3; ++i) {
      const Vertex a = around[i], b = around[(i + 1) % 3];
      if (turn(a, b, s.start) * view.orientation < 0 && turn(a, b, s.end) * view.orientation < 0) {
        return false;
      }
      sides[i] = turn(s.start, s.end, a);
    }
    return !pair_orientations_detail::on_one_side(sides);
  }

  /// Two segments, of which any may be a point. If they are in one plane but not on one line, one
  /// of three triangles has area, and its projection decides. On one line the boxes decide.
  bool segments_meet(const Two& s, const Two& t) const {
    if (boxes_apart(s, t)) return false;
    if (volume(s.start, s.end, t.start, t.end) != 0) return false;
    for (const Three& plane : {Three{s.start, s.end, t.start}, Three{s.start, s.end, t.end},
                               Three{t.start, t.end, s.start}}) {
      const FlatView seen = view(plane);
      if (seen.orientation == 0) continue;
      const auto turn = area(seen.dropped);
      return turn(s.start, s.end, t.start) * turn(s.start, s.end, t.end) <= 0 &&
             turn(t.start, t.end, s.start) * turn(t.start, t.end, s.end) <= 0;
    }
    return true;
  }
  bool boxes_apart(const Two& s, const Two& t) const {
    for (int k = 0; k < 3; ++k) {
      const auto [s_low, s_high] = std::minmax(at_[s.start][k], at_[s.end][k]);
      const auto [t_low, t_high] = std::minmax(at_[t.start][k], at_[t.end][k]);
      if (s_high < t_low || t_high < s_low) return true;
    }
    return false;
  }
};

}  // namespace contact::pair_decision_detail
