#include "moving_spheres.hpp"

namespace exercise {

std::optional<Contact> spheres_meet(const MovingSphere& a, const MovingSphere& b) {
  //? Where the point is, once t is known.
  //? gap: a.radius / (a.radius + b.radius)
  const auto contact_at = [&](double t) {
    const Eigen::Vector3d of_a = a.centre + t * a.displacement;
    const Eigen::Vector3d of_b = b.centre + t * b.displacement;
    return Contact{t, of_a + a.radius / (a.radius + b.radius) * (of_b - of_a)};
  };
  //? Sphere a as seen from b: a point that moves towards a sphere with the sum of the radii.
  //? gap: a.displacement - b.displacement
  const Eigen::Vector3d d = a.centre - b.centre;
  const Eigen::Vector3d w = a.displacement - b.displacement;
  const double radius_sum = a.radius + b.radius;
  //? A contact at the start, whatever the displacements.
  //? gap: gap <= 0
  const double gap = d.squaredNorm() - radius_sum * radius_sum;
  if (gap <= 0) return contact_at(0);
  //? From here on they must approach.
  //? gap: approach <= 0
  const double approach = -d.dot(w);
  if (approach <= 0) return std::nullopt;
  //? The cross product has the distance of the path from the centre: no large squares cancel.
  //? gap: radius_sum * radius_sum * w.squaredNorm() - d.cross(w).squaredNorm()
  //? gap: depth < 0
  const double depth = radius_sum * radius_sum * w.squaredNorm() - d.cross(w).squaredNorm();
  if (depth < 0) return std::nullopt;
  //? The smaller root, written with a sum instead of a difference.
  //? gap: approach + std::sqrt(depth)
  //? gap: t > 1
  const double t = gap / (approach + std::sqrt(depth));
  if (t > 1) return std::nullopt;
  return contact_at(t);
}

}  // namespace exercise
