/// @file
/// A point and a polyhedron: by the planes of its faces if it is convex, else by the parity of a
/// ray's crossings, as the lecture has it. `locate_in_mesh` is the book's choice, and
/// `winding_by_solid_angles` needs no ray.
#pragma once

#include <algorithm>
#include <concepts>
#include <contact/exact_ray_triangle.hpp>
#include <contact/locate_in_mesh.hpp>
#include <contact/mesh.hpp>
#include <contact/orientation.hpp>
#include <contact/polygon.hpp>
#include <contact/ray_triangle.hpp>
#include <contact/solid_angle.hpp>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace contact {

// [convex-by-planes]
/// Where a point is, relative to a closed convex mesh, by the sign of E(p) = n·p − k for the plane
/// of every triangle: inside if all are negative, outside if one is positive, else on.
///
/// Limits: rounded. n·p and k are of the size |n||p|, so far from the origin E keeps few digits or
/// none, and a point near a face is on either side of it. A concave mesh: inside is only what is
/// behind every face, so points inside are called outside. A mesh without volume: every point of
/// its plane is on it. Triangles whose rounded normal is 0 are left out; if all planes are left
/// out, every point is inside. No triangles, or NaN: outside.
///
/// Source: *Interaction and Normals*, slide "Collision detection: polyhedra": a vertex is inside a
/// convex polyhedron if it is on the inside of all faces.
template <Scalar S>
Where in_convex_by_planes(const Vector3<S>& point, const Mesh<S>& mesh) {
  Where where = mesh.triangles.empty() ? Where::outside : Where::inside;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto [a, b, c] = triangle_of(mesh, i);
    const Vector3<S> n = (b - a).cross(c - a);
    if (n == Vector3<S>::Zero()) continue;
    const S k = n.dot(a);
    const S e = n.dot(point) - k;
    if (!(e <= S(0))) return Where::outside;
    if (e == S(0)) where = Where::on;
  }
  return where;
}
// [/convex-by-planes]

// [in-convex]
/// The same with exact signs: right for every finite input if the mesh is closed, convex and has
/// volume.
///
/// Triangles without area are left out. Coplanar triangles agree exactly. The first face with the
/// point in front of it decides, so a point far outside costs few tests; one just in front of a
/// face may cost as many as a point inside: one for each triangle. A point or a vertex that is not
/// finite: outside.
template <FloatOrDouble S>
Where in_convex(const Vector3<S>& point, const Mesh<S>& mesh) {
  const Vector3<double> p = point.template cast<double>();
  if (!all_finite(p)) return Where::outside;
  Where where = mesh.triangles.empty() ? Where::outside : Where::inside;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle<double> t = in_double(triangle_of(mesh, i));
    int side = bounded_volume(p - t.a, t.b - t.a, t.c - t.a).certain_sign();
    if (side == 0) {
      if (!mesh_location_detail::finite_triangle(t)) return Where::outside;
      side = orient_3d_in_doubt(t.a, t.b, t.c, p);
    }
    if (side > 0) return Where::outside;
    if (side == 0 && !are_collinear(t.a, t.b, t.c)) where = Where::on;
  }
  return where;
}
// [/in-convex]

// [parity]
/// The number of triangles that a ray from the point meets, each asked on its own by Möller and
/// Trumbore. An edge belongs to two triangles and a vertex to several, so a ray through one may be
/// counted once, several times or, with rounding, never.
/// @param direction of the ray, of any length; with 0, or with a number that is not finite in it or
/// in the point, the ray meets nothing
template <Scalar S>
int crossings_by_triangles(const Vector3<S>& point, const Mesh<S>& mesh,
                           const Vector3<S>& direction) {
  int count = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Ray<S> ray{point, direction};
    if (intersect_moller_trumbore(ray, triangle_of(mesh, i))) ++count;
  }
  return count;
}

/// Inside if that number is odd: two answers.
///
/// Limits: may be wrong where the ray meets an edge or a vertex, or comes so close that the
/// triangles disagree by rounding; on the surface by chance. A ray in the plane of a triangle does
/// not meet it. A point or direction that is not finite and a zero direction: outside. A vertex
/// that is not finite: its triangles are not counted, so the answer means nothing.
///
/// Source: *Interaction and Normals*, slide "Collision detection: polyhedra": a semi-infinite ray
/// from the vertex intersects an odd number of faces.
template <Scalar S>
Where in_by_parity(const Vector3<S>& point, const Mesh<S>& mesh,
                   const Vector3<S>& direction = Vector3<S>(S(1), S(0), S(0))) {
  return crossings_by_triangles(point, mesh, direction) % 2 != 0 ? Where::inside : Where::outside;
}
// [/parity]

namespace polyhedron_detail {

/// splitmix64 (Steele, Lea and Flood, 2014): the same directions on every machine.
inline std::uint64_t next_bits(std::uint64_t& state) {
  std::uint64_t z = (state += 0x9e3779b97f4a7c15u);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

/// A direction with coordinates in [−1, 1), not 0.
template <std::floating_point S>
Vector3<S> next_direction(std::uint64_t& state) {
  Vector3<S> direction = Vector3<S>::Zero();
  while (direction == Vector3<S>::Zero()) {
    for (int k = 0; k < 3; ++k) {
      const auto bits = static_cast<std::int32_t>(next_bits(state) >> 40);  // 24 bits
      direction[k] = static_cast<S>(bits - 0x800000) / S(0x800000);
    }
  }
  return direction;
}

/// The crossings of a ray; nothing if it comes close to an edge of a triangle.
template <std::floating_point S>
std::optional<int> crossings_away_from_edges(const Ray<S>& ray, const Mesh<S>& mesh, S margin) {
  int count = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle<S> t = triangle_of(mesh, i);
    const Vector3<S> ab = t.b - t.a, ac = t.c - t.a, s = ray.origin - t.a;
    const Vector3<S> p = ray.direction.cross(ac), q = s.cross(ab);
    const S determinant = ab.dot(p);
    const S of_b = s.dot(p) / determinant, of_c = ray.direction.dot(q) / determinant;
    const S least = std::min({of_b, of_c, S(1) - of_b - of_c});
    if (!(least > -margin)) continue;
    if (!(least > margin)) return std::nullopt;
    if (ac.dot(q) / determinant > S(0)) ++count;
  }
  return count;
}

}  // namespace polyhedron_detail

/// What random rays say about a point.
struct RandomRays {
  Where where = Where::outside;  ///< inside or outside
  int cast = 0;                  ///< rays in all
  int given_up = 0;              ///< of the three votes, those for which no ray kept the margin
};

// [random-rays]
/// The parities of rays in random directions: a ray that comes closer to an edge of a triangle than
/// the margin is replaced, until 32 have been cast for a vote; then the last one is counted as
/// `crossings_by_triangles` does. The majority of three votes decides.
///
/// Limits: no proof. The margin is one of barycentric weights, and their rounding errors may be
/// larger: for a triangle that is nearly parallel to the ray, or far away in multiples of its size.
/// Close to an edge most directions are within the margin of it. The more triangles a ray meets,
/// the more rays are replaced. On the surface each vote is a matter of chance. A point that is not
/// finite: outside, without a ray. A vertex that is not finite: the answer means nothing.
/// @param margin of the barycentric weights
/// @param seed of the directions: the same seed, the same answer on every machine
template <std::floating_point S>
RandomRays in_by_random_rays(const Vector3<S>& point, const Mesh<S>& mesh, S margin = S(1e-4),
                             std::uint64_t seed = 1) {
  constexpr int votes = 3, tries = 32;
  RandomRays answer;
  if (!all_finite(point)) return answer;
  int inside = 0;
  for (int vote = 0; vote < votes; ++vote) {
    std::optional<int> count;
    Ray<S> ray{point, Vector3<S>::Zero()};
    for (int i = 0; i < tries && !count; ++i, ++answer.cast) {
      ray.direction = polyhedron_detail::next_direction<S>(seed);
      count = polyhedron_detail::crossings_away_from_edges(ray, mesh, margin);
    }
    if (!count) {
      ++answer.given_up;
      count = crossings_by_triangles(point, mesh, ray.direction);
    }
    inside += *count % 2;
  }
  if (2 * inside > votes) answer.where = Where::inside;
  return answer;
}
// [/random-rays]

}  // namespace contact
