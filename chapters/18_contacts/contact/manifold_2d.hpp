/// @file
/// The contact manifold of two convex polygons in the plane: reference edge, incident edge,
/// clipping.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include <contact/close_points.hpp>
#include <contact/manifold_point.hpp>
#include <contact/polygon.hpp>
#include <contact/signed_distance_result.hpp>
#include <contact/tolerance.hpp>
#include <contact/vector.hpp>

namespace contact {

// [manifold-2d]
/// A contact point in the plane.
template <Ring S>
struct ManifoldPoint2d {
  Vector2<S> point = Vector2<S>::Zero();  ///< midway between the two polygons, m
  S distance = S(0);         ///< of the polygons along the normal, m; negative: penetration
  PointFeatures features{};  ///< a vertex and an edge, or two vertices
};

/// The contact manifold of two polygons A and B. Without points there is no contact.
template <Ring S>
struct ContactManifold2d {
  Vector2<S> normal = Vector2<S>::Zero();  ///< unit vector, from B to A
  std::vector<ManifoldPoint2d<S>> points;  ///< none, one or two
};
// [/manifold-2d]

/// The same manifold with the two polygons exchanged. A coordinate 0 of the normal stays 0 and does
/// not become −0.
template <Ring S>
ContactManifold2d<S> exchanged(ContactManifold2d<S> manifold) {
  manifold.normal = Vector2<S>(Vector2<S>::Zero() - manifold.normal);
  for (ManifoldPoint2d<S>& p : manifold.points) p.features = exchanged(p.features);
  return manifold;
}

// [edge-separation]
/// An edge of a polygon and how far it separates another polygon.
template <Ring S>
struct EdgeSeparation {
  int edge = -1;      ///< from this vertex to the next; −1: the polygon has no edge
  S separation{};     ///< smallest n · x of the other polygon's vertices above the edge, m
  Vector2<S> normal;  ///< outward, unit vector
};

/// The edge of `polygon` along whose outward normal `other` is farthest away; of equal ones the
/// first. Its separation is at most the distance of disjoint polygons, because the strip between
/// the edge's line and the other polygon lies between the two.
/// @param polygon convex, counter-clockwise; edges of length 0 are skipped
/// @param other at least one vertex
template <FloatOrDouble S>
EdgeSeparation<S> max_edge_separation(const Polygon<S>& polygon, const Polygon<S>& other) {
  EdgeSeparation<S> best;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2<S> edge = polygon[(i + 1) % polygon.size()] - polygon[i];
    const S length = std::sqrt(edge.dot(edge));
    if (!(length > S(0))) continue;
    const Vector2<S> normal(edge.y() / length, -edge.x() / length);
    S separation = std::numeric_limits<S>::infinity();
    for (const Vector2<S>& vertex : other) {
      separation = std::min(separation, normal.dot(Vector2<S>(vertex - polygon[i])));
    }
    if (best.edge < 0 || separation > best.separation) best = {int(i), separation, normal};
  }
  return best;
}
// [/edge-separation]

// [incident-edge]
/// The edge of a convex polygon whose outward normal is most opposite to n; of equal ones the
/// first; −1 if it has no edge. One of its ends is a vertex farthest against n, because the normals
/// of the two edges at that vertex are the closest to −n on either side.
/// @param polygon convex, counter-clockwise
template <FloatOrDouble S>
int incident_edge(const Polygon<S>& polygon, const Vector2<S>& n) {
  int best = -1;
  S least(0);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2<S> edge = polygon[(i + 1) % polygon.size()] - polygon[i];
    const S length = std::sqrt(edge.dot(edge));
    if (!(length > S(0))) continue;
    const S along = (n.x() * edge.y() - n.y() * edge.x()) / length;
    if (best < 0 || along < least) {
      best = int(i);
      least = along;
    }
  }
  return best;
}
// [/incident-edge]

namespace detail {

/// A point of an incident edge above a reference edge.
template <Ring S>
struct PointOverEdge {
  Vector2<S> position;       // on the incident edge
  S height;                  // above the reference edge's line
  SurfaceFeature reference;  // the edge, or the end at which the incident edge was clipped
  SurfaceFeature incident;   // the edge or its end
};

// [clip-edge]
/// The ends of the part of an incident edge that lies over a reference edge, in the direction of
/// the reference edge; none if there is no such part, one if the part is a point.
///
/// Where an end of the incident edge lies over the reference edge it is taken as it is. Elsewhere
/// the incident edge is clipped at the line through the end of the reference edge, from the end
/// that is closer to it.
template <FloatOrDouble S>
std::vector<PointOverEdge<S>> part_over_edge(const Polygon<S>& reference, int edge,
                                             const Vector2<S>& normal, const Polygon<S>& incident,
                                             int other) {
  const auto next = [](const Polygon<S>& polygon, int i) { return (i + 1) % int(polygon.size()); };
  const auto at = [](const Polygon<S>& polygon, int i) { return polygon[std::size_t(i)]; };
  const int from = edge, to = next(reference, edge);
  const Vector2<S> p = at(reference, from), along(-normal.y(), normal.x());
  const S length = along.dot(Vector2<S>(at(reference, to) - p));
  int low = next(incident, other), high = other;  // both polygons run counter-clockwise
  const auto position = [&](int i) { return along.dot(Vector2<S>(at(incident, i) - p)); };
  if (position(high) < position(low)) std::swap(low, high);
  const S first = position(low), last = position(high);
  if (last < S(0) || first > length) return {};
  const auto end_or_cut = [&](int near, const S& x, const S& bound, bool beyond, int vertex) {
    PointOverEdge<S> found{at(incident, near), S(0), edge_feature(from, to), vertex_feature(near)};
    if (beyond) {
      const int far = near == low ? high : low;
      const Vector2<S> whole = at(incident, far) - at(incident, near);
      const S part = bound - x, rest = position(far) - bound;
      found.position = std::abs(part) <= std::abs(rest)
                           ? Vector2<S>(at(incident, near) + whole * part / (part + rest))
                           : Vector2<S>(at(incident, far) - whole * rest / (part + rest));
      found.reference = vertex_feature(vertex);
      found.incident = edge_feature(low, high);
    }
    found.height = normal.dot(Vector2<S>(found.position - p));
    return found;
  };
  std::vector<PointOverEdge<S>> part{end_or_cut(low, first, S(0), first < S(0), from),
                                     end_or_cut(high, last, length, last > length, to)};
  if (part[0].position == part[1].position) part.pop_back();
  return part;
}
// [/clip-edge]

/// A pair of closest points of the polygons A and B.
template <Ring S>
struct ClosestOfPolygons {
  Vector2<S> on_a, on_b;
  PointFeatures features;
};

/// The closest points of the boundaries: of a vertex of one and an edge of the other; of equally
/// close ones the first.
template <FloatOrDouble S>
ClosestOfPolygons<S> closest_of_polygons(const Polygon<S>& a, const Polygon<S>& b) {
  ClosestOfPolygons<S> best;
  S least = std::numeric_limits<S>::infinity();
  for (const bool of_a : {true, false}) {
    const Polygon<S>& points = of_a ? a : b;
    const Polygon<S>& edges = of_a ? b : a;
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (std::size_t k = 0; k < edges.size(); ++k) {
        const std::size_t next = (k + 1) % edges.size();
        const Vector2<S> d = edges[next] - edges[k];
        const S whole = d.dot(d);
        const S part = whole > S(0) ? d.dot(Vector2<S>(points[i] - edges[k])) / whole : S(0);
        Vector2<S> on_edge = edges[k] + d * part;
        SurfaceFeature feature = edge_feature(int(k), int(next));
        if (part <= S(0) || part >= S(1)) {
          feature = vertex_feature(int(part <= S(0) ? k : next));
          on_edge = edges[std::size_t(feature.first)];
        }
        const Vector2<S> between = points[i] - on_edge;
        if (!(between.dot(between) < least)) continue;
        least = between.dot(between);
        const PointFeatures found{vertex_feature(int(i)), feature};
        best = of_a ? ClosestOfPolygons<S>{points[i], on_edge, found}
                    : ClosestOfPolygons<S>{on_edge, points[i], exchanged(found)};
      }
    }
  }
  return best;
}

/// The largest magnitude of a coordinate; NaN if one is.
template <FloatOrDouble S>
S largest_coordinate(const Polygon<S>& polygon) {
  S largest(0);
  for (const Vector2<S>& p : polygon) {
    for (int i = 0; i < 2; ++i) {
      if (!(std::abs(p[i]) <= largest)) largest = std::abs(p[i]);
      if (std::isnan(largest)) return largest;
    }
  }
  return largest;
}

/// The larger side of the box around the polygon.
template <FloatOrDouble S>
S extent(const Polygon<S>& polygon) {
  Vector2<S> low = polygon[0], high = polygon[0];
  for (const Vector2<S>& p : polygon) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return (high - low).maxCoeff();
}

/// By how much the points of a reference edge or face may be farther apart than the closest points
/// before these are the contact instead, as a fraction of the smaller body: 2^-10. A body that
/// rests on another is rotated slightly by rounding; one point in place of several would let it
/// rock.
template <FloatOrDouble S>
inline constexpr S reference_preference = S(0x1p-10);

template <FloatOrDouble S>
S edge_length(const Polygon<S>& polygon, int edge) {
  const std::size_t from = std::size_t(edge), to = (from + 1) % polygon.size();
  const Vector2<S> along = polygon[to] - polygon[from];
  return std::sqrt(along.dot(along));
}

// [corners]
/// The vertices of a convex polygon without those that are in the middle of a side or coincide with
/// a previous one, up to 8 u of the coordinates: where several edges have one direction, they are
/// one edge. All vertices, if less than three would be left.
/// @param largest magnitude of a coordinate of the polygon
template <FloatOrDouble S>
std::vector<int> corners(const Polygon<S>& polygon, const S& largest) {
  const int count = int(polygon.size());
  const auto at = [&](int i) { return polygon[std::size_t(i % count)]; };
  const S least =
      std::min(S(8) * tolerance::unit_roundoff<S> * largest, flatness<S> * extent(polygon));
  // No vertex is farther left, and of those none is lower: it is in the middle of no side.
  int start = 0;
  for (int i = 1; i < count; ++i) {
    if (at(i).x() < at(start).x() || (at(i).x() == at(start).x() && at(i).y() < at(start).y()))
      start = i;
  }
  const auto is_between = [&](const Vector2<S>& p, const Vector2<S>& from, const Vector2<S>& to) {
    const Vector2<S> side = to - from, d = p - from;
    const S length = std::sqrt(side.dot(side));
    if (!(length > least)) return d.cwiseAbs().maxCoeff() <= least;
    const S above = (side.x() * d.y() - side.y() * d.x()) / length, along = side.dot(d) / length;
    return std::abs(above) <= least && along >= -least && along <= length + least;
  };
  std::vector<int> kept{start};
  for (int i = start + 1; i < start + count; ++i) {
    bool is_middle = true;
    const int last = kept.back();
    for (int k = last < start ? last + count + 1 : last + 1; k <= i && is_middle; ++k)
      is_middle = is_between(at(k), at(last), at(i + 1));
    if (!is_middle) kept.push_back(i % count);
  }
  if (kept.size() < 3) {
    kept.clear();
    for (int i = 0; i < count; ++i) kept.push_back(i);
  }
  return kept;
}
// [/corners]

/// The manifold of polygons of an ordinary size without vertices in the middle of a side.
template <FloatOrDouble S>
ContactManifold2d<S> manifold_of_corners(const Polygon<S>& a, const Polygon<S>& b, const S& margin,
                                         const S& size) {
  const EdgeSeparation<S> of_a = max_edge_separation(a, b), of_b = max_edge_separation(b, a);
  if (of_a.edge < 0 || of_b.edge < 0) return {};
  const bool a_is_reference = !(of_b.separation > of_a.separation);
  const EdgeSeparation<S>& best = a_is_reference ? of_a : of_b;
  const Polygon<S>& reference = a_is_reference ? a : b;
  const Polygon<S>& incident = a_is_reference ? b : a;
  const auto from_b_to_a = [&](const Vector2<S>& outward) {
    return a_is_reference ? Vector2<S>(Vector2<S>::Zero() - outward) : outward;
  };
  ContactManifold2d<S> manifold{from_b_to_a(best.normal), {}};
  if (best.separation > margin) return manifold;
  const ClosestOfPolygons<S> near = closest_of_polygons(a, b);
  const Vector2<S> between = near.on_a - near.on_b;
  const S apart = std::sqrt(between.dot(between));
  const bool disjoint =
      best.separation > S(0) && apart > S(64) * tolerance::unit_roundoff<S> * size;
  const S distance = disjoint ? apart : best.separation;
  const int other = incident_edge<S>(incident, best.normal);
  S deepest = std::numeric_limits<S>::infinity();
  for (const PointOverEdge<S>& p :
       part_over_edge<S>(reference, best.edge, best.normal, incident, other)) {
    if (!(p.height <= margin)) continue;
    const PointFeatures features{p.reference, p.incident};
    manifold.points.push_back({Vector2<S>(p.position - best.normal * (p.height / S(2))), p.height,
                               a_is_reference ? features : exchanged(features)});
    deepest = std::min(deepest, p.height);
  }
  merge_close_points(manifold,
                     std::min(edge_length(reference, best.edge), edge_length(incident, other)));
  const S room = reference_preference<S> * std::min(extent(a), extent(b));
  if (deepest <= distance + room) return manifold;
  manifold.points.clear();
  if (!(distance <= margin)) return manifold;
  if (disjoint) {
    manifold.normal = between / apart;
    manifold.points.push_back({Vector2<S>((near.on_a + near.on_b) / S(2)), apart, near.features});
    return manifold;
  }
  // The vertex of the incident edge that is deepest.
  const int ends[2]{other, (other + 1) % int(incident.size())};
  const auto along = [&](int i) { return best.normal.dot(incident[std::size_t(i)]); };
  const int vertex = along(ends[1]) < along(ends[0]) ? ends[1] : ends[0];
  const PointFeatures features{edge_feature(best.edge, (best.edge + 1) % int(reference.size())),
                               vertex_feature(vertex)};
  manifold.points.push_back(
      {Vector2<S>(incident[std::size_t(vertex)] - best.normal * (distance / S(2))), distance,
       a_is_reference ? features : exchanged(features)});
  return manifold;
}

/// The manifold of polygons of an ordinary size: of their corners, whose names are the indices in
/// the whole polygons.
template <FloatOrDouble S>
ContactManifold2d<S> manifold_2d(const Polygon<S>& a, const Polygon<S>& b, const S& margin,
                                 const S& size) {
  const std::vector<int> of_a = corners<S>(a, largest_coordinate<S>(a));
  const std::vector<int> of_b = corners<S>(b, largest_coordinate<S>(b));
  const auto chosen = [](const Polygon<S>& polygon, const std::vector<int>& indices) {
    Polygon<S> made;
    for (const int i : indices) made.push_back(polygon[std::size_t(i)]);
    return made;
  };
  const auto named = [](const SurfaceFeature& f, const std::vector<int>& indices) {
    return edge_feature(indices[std::size_t(f.first)], indices[std::size_t(f.second)]);
  };
  auto manifold = manifold_of_corners<S>(chosen(a, of_a), chosen(b, of_b), margin, size);
  for (ManifoldPoint2d<S>& p : manifold.points)
    p.features = {named(p.features.of_a, of_a), named(p.features.of_b, of_b)};
  return manifold;
}

/// Whether B is taken before A: it comes first along the coordinate in which the means of their
/// vertices differ most, or, if these are equal, in the order of the stored numbers. While one
/// polygon rests on the other the order does not change.
template <FloatOrDouble S>
bool is_second(const Polygon<S>& a, const Polygon<S>& b) {
  const auto mean = [](const Polygon<S>& polygon) {
    Vector2<S> sum = Vector2<S>::Zero();
    for (const Vector2<S>& p : polygon) sum += Vector2<S>(p / S(polygon.size()));
    return sum;
  };
  const Vector2<S> between = mean(b) - mean(a);
  const int largest = std::abs(between.y()) > std::abs(between.x()) ? 1 : 0;
  if (between(largest) != S(0)) return between(largest) < S(0);
  return std::lexicographical_compare(b.begin(), b.end(), a.begin(), a.end(),
                                      [](const Vector2<S>& p, const Vector2<S>& q) {
                                        return p.x() < q.x() || (p.x() == q.x() && p.y() < q.y());
                                      });
}

template <FloatOrDouble S>
Polygon<S> times_power_of_two(Polygon<S> polygon, int power) {
  for (Vector2<S>& p : polygon) p = {std::ldexp(p.x(), power), std::ldexp(p.y(), power)};
  return polygon;
}

}  // namespace detail

// [contact-manifold-2d]
/// The contact manifold of two convex polygons.
///
/// The edge that separates most is the reference edge, and the other polygon's edge that faces it
/// most is the incident edge. What of the incident edge lies over the reference edge has two ends;
/// those within the margin are the points. The polygon that comes first along the coordinate in
/// which their centres differ most has the reference edge if both separate as much. Where two
/// vertices meet, several edges do: then the first one gives the normal. So the answer is the same
/// in every run, and exchanging the polygons gives exactly the opposite normal and the same points,
/// unless all their numbers are equal.
///
/// A vertex in the middle of a side, up to 8 u of the coordinates, is no vertex: the edges on both
/// sides of it are one edge, with the names of its two ends.
///
/// If no point is as close as the closest points, to within 2^-10 of the smaller polygon, the
/// closest points are the only contact: as where one vertex is obliquely above another. Then the
/// normal leads from one to the other, if they are farther apart than 64 u of the largest
/// coordinate; nearer ones touch up to rounding, and the normal is that of the reference edge.
///
/// The edge of largest separation is an edge of the Minkowski difference, so it gives the direction
/// of least penetration; moving A by −(least distance) along the normal makes the polygons touch,
/// to within 2^-10 of the smaller one.
/// @param a, b convex, counter-clockwise, at least three vertices; of any size, but of a polygon
/// smaller than 1e-150 (float: 1e-20) of the largest coordinate, lengths underflow, and it may have
/// no points
/// @param margin polygons at most this far apart are in contact, m; not negative
/// @return no points if an argument is not finite or a polygon has fewer than three vertices
/// @see *Game Physics – Part III*, slide "Determine collision point P"; Dirk Gregorius, *Robust
/// Contact Creation for Physics Simulations*, GDC 2015 (for the names)
template <FloatOrDouble S>
ContactManifold2d<S> contact_manifold_2d(const Polygon<S>& a, const Polygon<S>& b,
                                         const S& margin) {
  const S of_a = detail::largest_coordinate<S>(a), of_b = detail::largest_coordinate<S>(b);
  if (a.size() < 3 || b.size() < 3 || !std::isfinite(of_a) || !std::isfinite(of_b) ||
      !std::isfinite(margin)) {
    return {};
  }
  if (detail::is_second<S>(a, b)) return exchanged(contact_manifold_2d(b, a, margin));
  const S size = std::max(of_a, of_b);
  const int power = detail::scale_power(size);
  if (power == 0) return detail::manifold_2d(a, b, margin, size);
  auto manifold = detail::manifold_2d<S>(detail::times_power_of_two<S>(a, -power),
                                         detail::times_power_of_two<S>(b, -power),
                                         std::ldexp(margin, -power), S(1));
  for (ManifoldPoint2d<S>& p : manifold.points) {
    p.point = {std::ldexp(p.point.x(), power), std::ldexp(p.point.y(), power)};
    p.distance = std::ldexp(p.distance, power);
  }
  return manifold;
}
// [/contact-manifold-2d]

}  // namespace contact
