#include "edge_edge.hpp"

namespace exercise {
namespace {

using Segment = contact::Segment<double>;

Eigen::Vector3d along(const Segment& edge) { return edge.end - edge.start; }

// Perpendicular to both edges; zero if they are parallel.
Eigen::Vector3d across(const Segment& a, const Segment& b) { return along(a).cross(along(b)); }

// Where the lines of two edges cross that lie in one plane and are not parallel.
struct Crossing {
  double of_a;  // in multiples of the edge: 0 at its start, 1 at its end
  double of_b;
};

Crossing crossing(const Segment& a, const Segment& b) {
  //? From a.start + s u = b.start + t v follows s u − t v = w. The cross product with v leaves s,
  //? that with u leaves t, each times u × v.
  //? gap: w.cross(along(b)).dot(n)
  //? gap: w.cross(along(a)).dot(n)
  const Eigen::Vector3d n = across(a, b), w = b.start - a.start;
  return {w.cross(along(b)).dot(n) / n.dot(n), w.cross(along(a)).dot(n) / n.dot(n)};
}

// Whether parallel edges have a point in common.
bool parallel_edges_meet(const Segment& a, const Segment& b) {
  const Eigen::Vector3d u = along(a);
  //? They must be on one line.
  //? gap: u.cross(b.start - a.start)
  if (!u.cross(b.start - a.start).isZero(0)) return false;
  //? Along u, edge a goes from 0 to u · u, and edge b between two other numbers.
  //? gap: u.dot(b.start - a.start)
  //? gap: std::min(from, to) <= u.dot(u)
  const double from = u.dot(b.start - a.start), to = u.dot(b.end - a.start);
  return std::max(from, to) >= 0 && std::min(from, to) <= u.dot(u);
}

}  // namespace

bool in_one_plane(const contact::Segment<double>& a, const contact::Segment<double>& b) {
  //? Six times the volume of the tetrahedron of the four ends.
  //? gap: across(a, b).dot(b.start - a.start) == 0
  return across(a, b).dot(b.start - a.start) == 0;
}

bool edges_meet(const contact::Segment<double>& a, const contact::Segment<double>& b) {
  if (!in_one_plane(a, b)) return false;
  //? Parallel edges have no single point where their lines cross.
  //? gap: across(a, b).isZero(0)
  if (across(a, b).isZero(0)) return parallel_edges_meet(a, b);
  //? The point must be on both edges, ends included.
  //? gap: std::min(of_a, of_b) >= 0 && std::max(of_a, of_b) <= 1
  const auto [of_a, of_b] = crossing(a, b);
  return std::min(of_a, of_b) >= 0 && std::max(of_a, of_b) <= 1;
}

std::optional<EdgeContact> edge_contact(const contact::Segment<double>& a,
                                        const contact::Segment<double>& b,
                                        const Eigen::Vector3d& inside_b) {
  const Eigen::Vector3d n = across(a, b);
  //? Edges that are parallel determine no normal, even if they meet.
  //? gap: n.isZero(0) || !edges_meet(a, b)
  if (n.isZero(0) || !edges_meet(a, b)) return std::nullopt;
  //? The position is on edge A, at its share of the edge.
  //? gap: crossing(a, b).of_a * along(a)
  const Eigen::Vector3d position = a.start + crossing(a, b).of_a * along(a);
  //? Which way n points depends on the order and the directions of the edges. It must point away
  //? from the inside of B.
  //? gap: n.dot(a.start - inside_b) > 0
  //? gap: is_outward ? unit : -unit
  const bool is_outward = n.dot(a.start - inside_b) > 0;
  const Eigen::Vector3d unit = n.normalized();
  return EdgeContact{position, is_outward ? unit : -unit};
}

}  // namespace exercise
