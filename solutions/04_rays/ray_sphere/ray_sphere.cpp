#include "ray_sphere.hpp"

namespace exercise {

std::optional<Inside> ray_sphere(const contact::Ray<double>& ray,
                                 const contact::Sphere<double>& sphere) {
  //? |m + t d|² = r² is a t² + 2 b t + c = 0.
  //? gap: ray.origin - sphere.centre
  //? gap: m.dot(m) - sphere.radius * sphere.radius
  const Eigen::Vector3d d = ray.direction, m = ray.origin - sphere.centre;
  const double a = d.dot(d), b = d.dot(m), c = m.dot(m) - sphere.radius * sphere.radius;

  //? b² − a c without a difference of large squares: |d × m| is |d| times the distance of the
  //? line from the centre.
  //? gap: d.cross(m).squaredNorm()
  const double discriminant = a * sphere.radius * sphere.radius - d.cross(m).squaredNorm();
  if (discriminant < 0) return std::nullopt;

  //? −b and the root have the same sign here, so nothing cancels.
  //? gap: b > 0
  const double root = std::sqrt(discriminant);
  const double q = b > 0 ? -b - root : -b + root;

  //? The product of the roots of the equation is c/a, so the other one is c/q. If q is 0, the ray
  //? starts where it touches.
  //? gap: c / q
  double entry = q / a;
  double exit = q == 0 ? entry : c / q;
  if (entry > exit) std::swap(entry, exit);

  //? A ray has no points before its start.
  //? gap: exit < 0
  //? gap: std::max(entry, 0.0)
  if (exit < 0) return std::nullopt;
  return Inside{std::max(entry, 0.0), exit};
}

}  // namespace exercise
