#include "manifold_2d.hpp"

namespace exercise {

namespace {

using Vector = Eigen::Vector2d;

struct Edge {
  Vector start;
  Vector end;
};

Edge edge_of(const Polygon& polygon, std::size_t k) {
  return {polygon[k], polygon[(k + 1) % polygon.size()]};
}

// The polygon is counter-clockwise: its inside is to the left of each edge.
Vector outward(const Edge& edge) {
  const Vector along = edge.end - edge.start;
  return Vector(along.y(), -along.x()).normalized();
}

double separation(const Edge& edge, const Polygon& other) {
  const Vector normal = outward(edge);
  double nearest = std::numeric_limits<double>::infinity();
  for (const Vector& vertex : other) nearest = std::min(nearest, normal.dot(vertex - edge.start));
  return nearest;
}

struct Reference {
  std::size_t edge;
  double separation;
};

Reference reference_of(const Polygon& polygon, const Polygon& other) {
  Reference best{0, separation(edge_of(polygon, 0), other)};
  for (std::size_t k = 1; k < polygon.size(); ++k) {
    const double apart = separation(edge_of(polygon, k), other);
    if (apart > best.separation) best = {k, apart};
  }
  return best;
}

Edge incident_of(const Polygon& polygon, const Vector& normal) {
  Edge best = edge_of(polygon, 0);
  for (std::size_t k = 1; k < polygon.size(); ++k) {
    const Edge edge = edge_of(polygon, k);
    if (outward(edge).dot(normal) < outward(best).dot(normal)) best = edge;
  }
  return best;
}

// The part of the edge for which direction·x is at most the limit.
std::optional<Edge> clipped(Edge edge, const Vector& direction, double limit) {
  const double start = direction.dot(edge.start) - limit;
  const double end = direction.dot(edge.end) - limit;
  if (start > 0 && end > 0) return std::nullopt;
  const Vector along = edge.end - edge.start;
  if (start > 0) edge.start += along * (start / (start - end));
  if (end > 0) edge.end -= along * (end / (end - start));
  return edge;
}

}  // namespace

Manifold contact_manifold(const Polygon& a, const Polygon& b, double margin) {
  const Reference of_a = reference_of(a, b);
  const Reference of_b = reference_of(b, a);
  const bool on_a = of_a.separation >= of_b.separation;
  const Edge reference = on_a ? edge_of(a, of_a.edge) : edge_of(b, of_b.edge);
  const Vector normal = outward(reference);
  Manifold manifold{on_a ? Vector(-normal) : normal, {}};
  // The incident edge runs against the reference edge.
  const Edge incident = incident_of(on_a ? b : a, normal);
  const Vector along = (reference.end - reference.start).normalized();
  const auto before_end = clipped({incident.end, incident.start}, along, along.dot(reference.end));
  if (!before_end) return manifold;
  const auto part = clipped(*before_end, -along, -along.dot(reference.start));
  if (!part) return manifold;
  for (const Vector& end : {part->start, part->end}) {
    const double distance = normal.dot(end - reference.start);
    if (distance <= margin) manifold.points.push_back({end - normal * (distance / 2), distance});
    if (part->start == part->end) break;
  }
  return manifold;
}

}  // namespace exercise
