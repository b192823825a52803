/// @file
/// The contact of two polygons from collision points or collision segments on their perimeters, and
/// three rules for the normal.
///
/// Normals are unit vectors from the second polygon to the first. They are rounded: only which edge
/// a normal belongs to is decided here.
///
/// Degenerate input, unless a function says otherwise: without vertices or segments nothing is
/// found. An edge that is a point counts as a segment. Points and segments with a coordinate that
/// is not finite meet nothing.
#pragma once

#include <algorithm>
#include <cmath>
#include <contact/point_in_polygon.hpp>
#include <contact/segments.hpp>
#include <cstdint>
#include <optional>
#include <vector>

namespace contact {

/// The length of a vector, rounded, without overflow or underflow of the squares. The same on every
/// machine to the last bit, which `std::hypot` is not.
///
/// The zero vector gives 0; NaN gives NaN, even beside an infinite coordinate; otherwise an
/// infinite coordinate gives ∞, and so does a length above the largest number.
template <std::floating_point S>
S length_of(const Vector2<S>& v) {
  const S square = v.x() * v.x() + v.y() * v.y();
  constexpr S tiny = std::numeric_limits<S>::min() / std::numeric_limits<S>::epsilon();
  if (square >= tiny && square <= std::numeric_limits<S>::max()) return std::sqrt(square);
  const S size = std::max(std::abs(v.x()), std::abs(v.y()));
  if (!(size > S(0)) || !std::isfinite(v.x()) || !std::isfinite(v.y())) return square;
  const int power = std::ilogb(size);
  const S x = std::scalbn(v.x(), -power), y = std::scalbn(v.y(), -power);
  return std::scalbn(std::sqrt(x * x + y * y), power);
}

/// The edges of a polygon as segments, in order; edge i leaves vertex i. One vertex gives one
/// segment, of length 0. Coordinates are copied, finite or not.
template <Ring S>
std::vector<Segment2<S>> perimeter_segments(const Polygon<S>& polygon) {
  std::vector<Segment2<S>> edges;
  edges.reserve(polygon.size());
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    edges.push_back({polygon[i], polygon[(i + 1) % polygon.size()]});
  }
  return edges;
}

// [perimeter-points]
/// Points on the perimeter: all vertices, and between them as few as make neighbours at most
/// `spacing` apart along an edge.
///
/// Limits: points between vertices are rounded, so they may be an ulp off the edge. A spacing that
/// is not positive or not finite gives the vertices alone, as does an edge with more than a million
/// points, or with a length that overflows or is not finite. Vertices are copied, finite or not.
/// @param spacing m
template <std::floating_point S>
std::vector<Vector2<S>> perimeter_points(const Polygon<S>& polygon, S spacing) {
  std::vector<Vector2<S>> points;
  for (const Segment2<S>& edge : perimeter_segments(polygon)) {
    const Vector2<S> along = edge.b - edge.a;
    const S parts = spacing > S(0) ? std::ceil(length_of<S>(along) / spacing) : S(1);
    const int count = parts >= S(1) && parts <= S(1000000) ? static_cast<int>(parts) : 1;
    points.push_back(edge.a);
    for (int i = 1; i < count; ++i) points.push_back(edge.a + S(i) / S(count) * along);
  }
  return points;
}
// [/perimeter-points]

/// What a test of perimeter points found.
struct PointHits {
  std::vector<int> points;  ///< indices of the points in the polygon or on it, in order
  std::int64_t tests = 0;   ///< how many points were compared with how many edges
};

/// The points that are in a polygon or on it (even-odd), each decided exactly.
///
/// What it misses: an edge or a vertex of the polygon that enters between two points. What it
/// costs: points × edges.
template <std::floating_point S>
PointHits hit_points(const std::vector<Vector2<S>>& points, const Polygon<S>& polygon) {
  PointHits hits;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (where(polygon, points[i]) != Where::outside) hits.points.push_back(static_cast<int>(i));
  }
  hits.tests = static_cast<std::int64_t>(points.size() * polygon.size());
  return hits;
}

/// Two edges that meet.
template <Scalar S>
struct SegmentHit {
  int first = 0;                ///< edge of the first polygon
  int second = 0;               ///< edge of the second polygon
  SegmentCrossing<S> crossing;  ///< how and where they meet
};

/// What a test of perimeter segments found.
template <Scalar S>
struct SegmentHits {
  std::vector<SegmentHit<S>> hits;  ///< by first edge, then by second
  std::int64_t tests = 0;           ///< how many pairs of segments were compared
};

/// All pairs of segments that meet, each decided exactly.
///
/// What it misses: a polygon that is wholly inside the other. What it costs: all pairs.
template <std::floating_point S>
SegmentHits<S> hit_segments(const std::vector<Segment2<S>>& first,
                            const std::vector<Segment2<S>>& second) {
  SegmentHits<S> found;
  for (std::size_t i = 0; i < first.size(); ++i) {
    for (std::size_t j = 0; j < second.size(); ++j) {
      const SegmentCrossing<S> meeting = crossing(first[i], second[j]);
      if (meeting.meeting == Meeting::none) continue;
      found.hits.push_back({static_cast<int>(i), static_cast<int>(j), meeting});
    }
  }
  found.tests = static_cast<std::int64_t>(first.size() * second.size());
  return found;
}

/// The edges of a polygon that a path meets (the movement vector through a wall), in the order of
/// the polygon's edges; `SegmentHit::first` is 0. The decisions are exact.
template <std::floating_point S>
std::vector<SegmentHit<S>> edges_on_path(const Segment2<S>& path, const Polygon<S>& polygon) {
  return hit_segments<S>({path}, perimeter_segments(polygon)).hits;
}

/// The one of these edges that the path meets first: that with the smallest fraction as rounded, of
/// equals the one with the lowest index. A path that is a point has fraction 0 at every edge.
template <std::floating_point S>
std::optional<SegmentHit<S>> first_edge_on_path(const Segment2<S>& path,
                                                const Polygon<S>& polygon) {
  std::optional<SegmentHit<S>> first;
  for (const SegmentHit<S>& hit : edges_on_path(path, polygon)) {
    if (!first || hit.crossing.along_first < first->crossing.along_first) first = hit;
  }
  return first;
}

/// Whether two regions (even-odd) have a point in common; touching counts. Decided exactly.
///
/// Either two edges meet, or one polygon contains the other, and then also its first vertex. A
/// polygon without vertices meets nothing.
// [polygons-meet]
template <std::floating_point S>
bool polygons_meet(const Polygon<S>& first, const Polygon<S>& second) {
  if (first.empty() || second.empty()) return false;
  for (const Segment2<S>& s : perimeter_segments(first)) {
    for (const Segment2<S>& t : perimeter_segments(second)) {
      if (meet(s, t) != Meeting::none) return true;
    }
  }
  return where(second, first[0]) != Where::outside || where(first, second[0]) != Where::outside;
}
// [/polygons-meet]

// [outward-normal]
/// The unit normal to the right of a segment: outward for an edge of a counter-clockwise polygon. A
/// segment that is a point, or whose length overflows or is not finite, gives the zero vector.
template <std::floating_point S>
Vector2<S> right_normal(const Segment2<S>& edge) {
  const Vector2<S> along = edge.b - edge.a;
  const S length = length_of<S>(along);
  if (!(length > S(0)) || !std::isfinite(length)) return Vector2<S>::Zero();
  if (length < std::numeric_limits<S>::min()) {  // it has too few digits to divide by
    return right_normal<S>({Vector2<S>::Zero(), along / std::numeric_limits<S>::epsilon()});
  }
  return {along.y() / length, -along.x() / length};
}
// [/outward-normal]

/// Two polygons with what their perimeters show: the edges that meet. Both are counter-clockwise.
template <std::floating_point S>
struct PerimeterContact {
  std::vector<Segment2<S>> first;   ///< edges of the first polygon
  std::vector<Segment2<S>> second;  ///< edges of the second polygon
  SegmentHits<S> found;             ///< the edges that meet
};

/// Tests all edges of two counter-clockwise polygons.
template <std::floating_point S>
PerimeterContact<S> perimeter_contact(const Polygon<S>& first, const Polygon<S>& second) {
  PerimeterContact<S> contact{perimeter_segments(first), perimeter_segments(second), {}};
  contact.found = hit_segments(contact.first, contact.second);
  return contact;
}

// [normal-of-hit]
/// The first rule: the outward normal of the segment of the second polygon that was hit.
///
/// Wrong where it is the second polygon's vertex that enters: then the face is the first polygon's.
/// An edge that is a point, or too long for `right_normal`, gives the zero vector. The hit must be
/// one of this contact: its indices are not checked.
template <std::floating_point S>
Vector2<S> normal_of_hit_segment(const PerimeterContact<S>& contact, const SegmentHit<S>& hit) {
  return right_normal(contact.second[static_cast<std::size_t>(hit.second)]);
}
// [/normal-of-hit]

// [normal-by-end]
/// The distance from a point to the nearer end of a segment, m. ∞ if both distances overflow. NaN
/// in the point or in end a gives NaN; NaN in end b alone gives the distance to a.
template <std::floating_point S>
S distance_to_end(const Segment2<S>& segment, const Vector2<S>& p) {
  const Vector2<S> to_a = segment.a - p, to_b = segment.b - p;
  return std::min(length_of<S>(to_a), length_of<S>(to_b));
}

/// The lecture's rule: the segment that has an end nearer to the common point is the one that
/// enters, so the other is the face, and its normal is that of the contact. Of equals, the second
/// polygon's segment is the face.
///
/// Wrong where the face is short or its end is near: on a floor of tiles, the nearest end is often
/// that of a tile, and the rule takes the side of the entering body as the face. The two common
/// points of one contact may give two normals. A face that is a point, or too long for
/// `right_normal`, gives the zero vector. The hit must be one of this contact.
///
/// Source: *Game Physics 3*, slide "To the code".
template <std::floating_point S>
Vector2<S> normal_by_nearer_end(const PerimeterContact<S>& contact, const SegmentHit<S>& hit) {
  const Segment2<S>& s = contact.first[static_cast<std::size_t>(hit.first)];
  const Segment2<S>& t = contact.second[static_cast<std::size_t>(hit.second)];
  const Vector2<S>& p = hit.crossing.point;
  if (distance_to_end(s, p) <= distance_to_end(t, p)) return right_normal(t);
  return -right_normal(s);
}
// [/normal-by-end]

/// A face of the contact.
template <std::floating_point S>
struct ContactFace {
  bool of_first = false;                   ///< an edge of the first polygon, or else of the second
  int edge = 0;                            ///< its index
  Vector2<S> normal = Vector2<S>::Zero();  ///< unit, from the second polygon to the first
  S depth = S(0);  ///< m, how far the other polygon is behind the face; not negative
  Vector2<S> point = Vector2<S>::Zero();  ///< m; the mean of the common points
};

namespace perimeter_detail {

/// Which edges of the first or the second polygon were hit.
template <std::floating_point S>
std::vector<bool> edges_hit(const PerimeterContact<S>& contact, bool of_first) {
  std::vector<bool> hit((of_first ? contact.first : contact.second).size(), false);
  for (const SegmentHit<S>& h : contact.found.hits) {
    hit[static_cast<std::size_t>(of_first ? h.first : h.second)] = true;
  }
  return hit;
}

/// The other polygon's vertices in or on the polygon, and both ends of its edges that were hit.
template <std::floating_point S>
std::vector<Vector2<S>> points_that_count(const std::vector<Segment2<S>>& own,
                                          const std::vector<Segment2<S>>& other,
                                          const std::vector<bool>& other_hit) {
  Polygon<S> polygon;
  for (const Segment2<S>& edge : own) polygon.push_back(edge.a);
  std::vector<Vector2<S>> points;
  for (std::size_t i = 0; i < other.size(); ++i) {
    if (other_hit[i]) points.push_back(other[i].b);
    if (other_hit[i] || where(polygon, other[i].a) != Where::outside) points.push_back(other[i].a);
  }
  return points;
}

/// The mean of the points that the edges have in common; an overlap counts with both its ends.
template <std::floating_point S>
Vector2<S> mean_of_common_points(const PerimeterContact<S>& contact) {
  Vector2<S> mean = Vector2<S>::Zero();
  const S count = static_cast<S>(2 * contact.found.hits.size());
  for (const SegmentHit<S>& h : contact.found.hits) {
    mean += h.crossing.overlap.a / count + h.crossing.overlap.b / count;
  }
  return mean;
}

}  // namespace perimeter_detail

// [least-penetration]
/// The book's rule: of all edges that were hit, the face is the one behind which the other polygon
/// is least deep. Moving the first polygon by depth along the normal takes all points that count to
/// the front of the face's line or onto it.
///
/// The points that count are the other polygon's vertices that are inside (or on the boundary), and
/// both ends of its edges that were hit. Of equal depths, the second polygon's edge with the lowest
/// index is the face, then the first polygon's. Nothing if no edges meet, or if all edges that meet
/// are points or too long for `right_normal`.
///
/// Limits: depths are rounded, so two faces whose depths differ by rounding may be exchanged; the
/// decisions which edges meet and which vertices are inside are exact. It is a rule for one moment:
/// a body that moved too far in a step may be least deep behind the wrong face. Differences of
/// coordinates that overflow can make a depth too small.
template <std::floating_point S>
std::optional<ContactFace<S>> face_of_least_penetration(const PerimeterContact<S>& contact) {
  std::optional<ContactFace<S>> best;
  for (const bool of_first : {false, true}) {
    const auto& own = of_first ? contact.first : contact.second;
    const auto& other = of_first ? contact.second : contact.first;
    const std::vector<bool> hit = perimeter_detail::edges_hit(contact, of_first);
    const std::vector<Vector2<S>> points = perimeter_detail::points_that_count(
        own, other, perimeter_detail::edges_hit(contact, !of_first));
    for (std::size_t i = 0; i < own.size(); ++i) {
      const Vector2<S> normal = right_normal(own[i]);
      if (!hit[i] || normal == Vector2<S>::Zero()) continue;
      S depth = S(0);
      for (const Vector2<S>& p : points) depth = std::max(depth, normal.dot(own[i].a - p));
      if (best && !(depth < best->depth)) continue;
      best = ContactFace<S>{of_first, static_cast<int>(i), of_first ? Vector2<S>(-normal) : normal,
                            depth, perimeter_detail::mean_of_common_points(contact)};
    }
  }
  return best;
}
// [/least-penetration]

}  // namespace contact
