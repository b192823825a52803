#include "ray_cylinder.hpp"

namespace exercise {

std::optional<Entry> ray_cylinder(const contact::Ray<double>& ray, const Cylinder& cylinder) {
  //? The vectors from which both inequalities are made.
  //? gap: ray.origin - cylinder.start
  const Eigen::Vector3d d = ray.direction, w = cylinder.end - cylinder.start;
  const Eigen::Vector3d m = ray.origin - cylinder.start;
  constexpr double infinity = std::numeric_limits<double>::infinity();

  //? Inside the infinite cylinder: |w × (m + t d)|² ≤ r² w·w, or a t² + 2 b t + c ≤ 0.
  //? gap: wm.dot(wm) - cylinder.radius * cylinder.radius * w.dot(w)
  const Eigen::Vector3d wd = w.cross(d), wm = w.cross(m);
  const double a = wd.dot(wd), b = wd.dot(wm);
  const double c = wm.dot(wm) - cylinder.radius * cylinder.radius * w.dot(w);
  double wall_entry = -infinity, wall_exit = infinity;
  //? Parallel to the axis the ray is inside for every t or for none; otherwise between two roots.
  //? gap: c > 0
  //? gap: b * b - a * c
  if (a == 0) {
    if (c > 0) return std::nullopt;
  } else {
    const double discriminant = b * b - a * c;
    if (discriminant < 0) return std::nullopt;
    wall_entry = (-b - std::sqrt(discriminant)) / a;
    wall_exit = (-b + std::sqrt(discriminant)) / a;
  }

  //? Between the planes of the caps: 0 ≤ w·m + t w·d ≤ w·w.
  //? gap: along == 0
  //? gap: height < 0 || height > w.dot(w)
  const double height = w.dot(m), along = w.dot(d);
  double cap_entry = -infinity, cap_exit = infinity;
  if (along == 0) {
    if (height < 0 || height > w.dot(w)) return std::nullopt;
  } else {
    cap_entry = -height / along;
    cap_exit = (w.dot(w) - height) / along;
    if (along < 0) std::swap(cap_entry, cap_exit);
  }

  //? In both from the later entry to the earlier exit, if that is later.
  //? gap: std::max(wall_entry, cap_entry)
  //? gap: std::min(wall_exit, cap_exit)
  const double entry = std::max(wall_entry, cap_entry);
  const double exit = std::min(wall_exit, cap_exit);
  if (entry > exit || exit < 0) return std::nullopt;
  //? The ray starts inside.
  if (entry < 0) return Entry{0, Eigen::Vector3d::Zero()};
  //? Through a cap, whose normal is along the axis and against the ray.
  //? gap: along > 0
  if (cap_entry > wall_entry) return Entry{entry, (along > 0 ? -w : w).normalized()};
  //? Through the wall: the normal is what is left of the vector to the point without its part along
  //? the axis.
  //? gap: p.dot(w) / w.dot(w)
  const Eigen::Vector3d p = m + entry * d;
  return Entry{entry, (p - p.dot(w) / w.dot(w) * w).normalized()};
}

}  // namespace exercise
