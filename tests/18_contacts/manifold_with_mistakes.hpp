/// @file
/// The contact points of two convex polygons with one mistake that people make: what the test of
/// the exercise recognises.
#pragma once

#include <algorithm>
#include <cmath>

#include "manifold_2d.hpp"

namespace manifold_with_mistakes {

using exercise::ContactPoint;
using exercise::Manifold;
using exercise::Polygon;
using Vector = Eigen::Vector2d;

/// What is done wrong.
enum class Way {
  only_a,              ///< the reference edge is always one of a
  deepest_edge,        ///< the edge with the smallest separation
  farthest_vertex,     ///< the separation of the farthest vertex
  clockwise,           ///< the normals point inwards
  not_unit,            ///< the normals have the lengths of the edges
  incident_alike,      ///< the incident edge has the most similar normal
  incident_at_vertex,  ///< the incident edge begins at the nearest vertex
  not_clipped,         ///< both ends of the incident edge
  one_end,             ///< clipped at the end of the reference edge only
  stretched,           ///< the points opposite to the ends of the reference edge
  no_margin,           ///< only points that do not lie outside
  all_points,          ///< points far outside too
  strict,              ///< points at exactly the margin are left out
  depth,               ///< penetrations count positive
  on_incident,         ///< points on the incident edge
  on_reference,        ///< points on the reference edge
  deepest,             ///< the deepest point alone
  mean,                ///< one point midway between the two
  other_order,         ///< in the order of the incident edge
  twice,               ///< a single point twice
};

struct Edge {
  Vector start;
  Vector end;
};

inline Edge edge_of(const Polygon& polygon, std::size_t k) {
  return {polygon[k], polygon[(k + 1) % polygon.size()]};
}

inline Vector normal_of(const Edge& edge, Way way) {
  const Vector along = edge.end - edge.start;
  const Vector normal{along.y(), -along.x()};
  if (way == Way::not_unit) return normal;
  return way == Way::clockwise ? Vector(-normal.normalized()) : Vector(normal.normalized());
}

inline double separation(const Edge& edge, const Polygon& other, Way way) {
  const Vector normal = normal_of(edge, way);
  double found = normal.dot(other[0] - edge.start);
  for (const Vector& vertex : other) {
    const double distance = normal.dot(vertex - edge.start);
    found = way == Way::farthest_vertex ? std::max(found, distance) : std::min(found, distance);
  }
  return found;
}

struct Reference {
  std::size_t edge;
  double separation;
};

inline Reference reference_of(const Polygon& polygon, const Polygon& other, Way way) {
  Reference best{0, separation(edge_of(polygon, 0), other, way)};
  for (std::size_t k = 1; k < polygon.size(); ++k) {
    const double apart = separation(edge_of(polygon, k), other, way);
    const bool better =
        way == Way::deepest_edge ? apart < best.separation : apart > best.separation;
    if (better) best = {k, apart};
  }
  return best;
}

inline Edge incident_of(const Polygon& polygon, const Vector& normal, Way way) {
  std::size_t best = 0;
  for (std::size_t k = 1; k < polygon.size(); ++k) {
    const double dot = normal_of(edge_of(polygon, k), way).dot(normal);
    const double other = normal_of(edge_of(polygon, best), way).dot(normal);
    if (way == Way::incident_at_vertex) {
      if (polygon[k].dot(normal) < polygon[best].dot(normal)) best = k;
    } else if (way == Way::incident_alike ? dot > other : dot < other) {
      best = k;
    }
  }
  return edge_of(polygon, best);
}

inline bool on_edge_of_a(const Reference& a, const Reference& b, Way way) {
  if (way == Way::only_a) return true;
  return way == Way::deepest_edge ? a.separation <= b.separation : a.separation >= b.separation;
}

inline Manifold contact_manifold(const Polygon& a, const Polygon& b, double margin, Way way) {
  const Reference of_a = reference_of(a, b, way), of_b = reference_of(b, a, way);
  const bool on_a = on_edge_of_a(of_a, of_b, way);
  const Edge reference = on_a ? edge_of(a, of_a.edge) : edge_of(b, of_b.edge);
  const Vector normal = normal_of(reference, way);
  const double sign = on_a ? -1 : 1;
  Manifold manifold{normal * sign, {}};
  const Edge incident = incident_of(on_a ? b : a, normal, way);
  const Vector along = (reference.end - reference.start).normalized();
  double first = along.dot(incident.end - reference.start);
  double last = along.dot(incident.start - reference.start);
  Vector from = incident.end, to = incident.start;
  const bool swapped = first > last;
  if (swapped) {
    std::swap(first, last);
    std::swap(from, to);
  }
  const double length = (reference.end - reference.start).norm();
  const auto at = [&, from, to](double t) -> Vector {
    return from + (to - from) * ((t - first) / (last - first));
  };
  std::vector<Vector> ends{from, to};
  if (way != Way::not_clipped) {
    if (last < 0 && way != Way::one_end && way != Way::stretched) return manifold;
    if (first > length && way != Way::stretched) return manifold;
    const bool both = way == Way::stretched;
    if ((first < 0 && way != Way::one_end) || both) ends[0] = at(0);
    if (last > length || both) ends[1] = at(length);
  }
  if (way == Way::other_order) std::swap(ends[0], ends[1]);
  for (const Vector& end : ends) {
    const double distance = normal.dot(end - reference.start);
    double most = way == Way::no_margin ? 0 : margin;
    if (way == Way::all_points) most = std::numeric_limits<double>::infinity();
    if (way == Way::strict ? !(distance < most) : !(distance <= most)) continue;
    double moved = distance / 2;
    if (way == Way::on_incident) moved = 0;
    if (way == Way::on_reference) moved = distance;
    manifold.points.push_back({end - normal * moved, way == Way::depth ? -distance : distance});
    if (ends[0] == ends[1] && way != Way::twice) break;
  }
  std::vector<ContactPoint>& points = manifold.points;
  if (points.size() == 2 && way == Way::deepest)
    points = {points[1].distance < points[0].distance ? points[1] : points[0]};
  if (points.size() == 2 && way == Way::mean)
    points = {
        {(points[0].point + points[1].point) / 2, (points[0].distance + points[1].distance) / 2}};
  return manifold;
}

}  // namespace manifold_with_mistakes
