// What the page "Ask the engines" asks the reference headers: a ray at a ball or a box, the signed
// distance of two of them, the time of impact of two that translate, and many rays at a mesh.
// Scenes are run by the scene player.
#include <array>
#include <cmath>
#include <contact/convex_shapes.hpp>
#include <contact/figure.hpp>
#include <contact/mesh.hpp>
#include <contact/mesh_tree.hpp>
#include <contact/oriented_box.hpp>
#include <contact/quaternion.hpp>
#include <contact/ray_box.hpp>
#include <contact/ray_sphere.hpp>
#include <contact/signed_distance.hpp>
#include <contact/translating_impact.hpp>
#include <cstddef>
#include <limits>
#include <type_traits>

using Vector = contact::Vector3<double>;

constexpr std::size_t max_vertices = 162, max_triangles = 320, max_rays = 500;

struct Input {
  double
      query;  // 0 a ray at a, 1 the distance of a and b, 2 the impact of a at b, 3 rays at a mesh
  double radius_a, radius_b;         // m; 0: a box
  Vector half_a, half_b;             // of a box, m
  Vector centre_a, centre_b;         // m
  std::array<double, 4> q_a, q_b;    // unit quaternions, w first
  Vector origin, direction;          // of the ray; of an impact the direction is a's velocity, m/s
  double vertices, triangles, rays;  // how many of the following are used
  std::array<Vector, max_vertices> vertex;
  std::array<Vector, max_triangles> triangle;
  std::array<Vector, max_rays> ray_origin, ray_direction;
};

struct Output {
  double problem;
  double answer;                     // m or s; infinite: no hit
  std::array<double, max_rays> hit;  // distance to the first hit of the mesh; infinite: no hit
};

namespace {

constexpr double none = std::numeric_limits<double>::infinity();
/// s; a power of two, so that the displacement of a velocity is not rounded.
constexpr double horizon = 4;

contact::OrientedBox<double> box(const Vector& centre, const Vector& half,
                                 const std::array<double, 4>& q) {
  return {centre, contact::matrix_of(contact::Quaternion<double>{q[0], Vector(q[1], q[2], q[3])}),
          half};
}

/// Calls `use` with the body a, a sphere or a box.
template <class Use>
double with_a(const Input& in, const Use& use) {
  if (in.radius_a > 0) return use(contact::Sphere<double>{in.centre_a, in.radius_a});
  return use(box(in.centre_a, in.half_a, in.q_a));
}

/// Calls `use` with the bodies a and b.
template <class Use>
double with_both(const Input& in, const Use& use) {
  return with_a(in, [&](const auto& a) {
    if (in.radius_b > 0) return use(a, contact::Sphere<double>{in.centre_b, in.radius_b});
    return use(a, box(in.centre_b, in.half_b, in.q_b));
  });
}

double cast(const Input& in) {
  const contact::Ray<double> ray{in.origin, in.direction};
  return with_a(in, [&](const auto& body) {
    const auto hit = contact::first_hit(ray, body);
    return hit ? hit->t : none;
  });
}

double distance(const Input& in) {
  return with_both(
      in, [](const auto& a, const auto& b) { return contact::signed_distance(a, b).distance; });
}

double impact(const Input& in) {
  return with_both(in, [&](const auto& a, const auto& b) {
    const auto found =
        contact::translating_impact(a, Vector(horizon * in.direction), b, Vector(Vector::Zero()));
    return found.meets ? horizon * found.t : none;
  });
}

void mesh_hits(const Input& in, std::array<double, max_rays>& hits) {
  contact::Mesh<double> mesh;
  for (std::size_t i = 0; i < static_cast<std::size_t>(in.vertices); ++i) {
    mesh.vertices.push_back(in.vertex[i]);
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(in.triangles); ++i) {
    const Vector& t = in.triangle[i];
    mesh.triangles.push_back(
        {static_cast<int>(t.x()), static_cast<int>(t.y()), static_cast<int>(t.z())});
  }
  const contact::MeshTree<double> tree(mesh);
  for (std::size_t i = 0; i < static_cast<std::size_t>(in.rays); ++i) {
    const contact::Ray<double> ray{in.ray_origin[i], in.ray_direction[i]};
    const auto first = tree.first(ray);
    hits[i] = first ? first->hit.t : none;
  }
}

bool fits(const Input& in) {
  return in.vertices >= 0 && in.vertices <= max_vertices && in.triangles >= 0 &&
         in.triangles <= max_triangles && in.rays >= 0 && in.rays <= max_rays;
}

}  // namespace

Output compute(const Input& in) {
  Output out{};
  if (!fits(in)) out.problem = contact::figure::too_large;
  if (out.problem != 0) return out;
  if (in.query == 0) out.answer = cast(in);
  if (in.query == 1) out.answer = distance(in);
  if (in.query == 2) out.answer = impact(in);
  if (in.query == 3) mesh_hits(in, out.hit);
  return out;
}

FIGURE(Input,
       FIELDS(query, radius_a, radius_b, half_a, half_b, centre_a, centre_b, q_a, q_b, origin,
              direction, vertices, triangles, rays, vertex, triangle, ray_origin, ray_direction),
       Output, FIELDS(problem, answer, hit))
