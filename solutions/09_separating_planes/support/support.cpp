#include "support.hpp"

namespace exercise {

namespace {

// The direction with length 1. Zero stays zero.
Eigen::Vector3d unit(const Eigen::Vector3d& v) {
  //? The square of a very short or very long vector is 0 or infinity in double, so it is divided by
  //? its largest coordinate first.
  //? gap: v.cwiseAbs().maxCoeff()
  const double largest = v.cwiseAbs().maxCoeff();
  //? Zero has no direction.
  //? gap: largest == 0
  if (largest == 0) return v;
  //? Now its length is from 1 to 2.
  return (v / largest).normalized();
}

// The farthest point of a body along n, which has length 1 or is zero.
Eigen::Vector3d farthest(const contact::Sphere<double>& sphere, const Eigen::Vector3d& n) {
  //? From the centre straight along n.
  //? gap: sphere.centre + sphere.radius * n
  return sphere.centre + sphere.radius * n;
}

Eigen::Vector3d farthest(const contact::Capsule<double>& capsule, const Eigen::Vector3d& n) {
  //? A sphere slides along the core: it is farthest along n at one of the ends.
  //? gap: n.dot(end - start) > 0
  const auto& [start, end] = capsule.core;
  const Eigen::Vector3d centre = n.dot(end - start) > 0 ? end : start;
  //? There it is a sphere.
  //? gap: centre + capsule.radius * n
  return centre + capsule.radius * n;
}

Eigen::Vector3d farthest(const contact::OrientedBox<double>& box, const Eigen::Vector3d& n) {
  //? The sign of n along each axis tells which of the two faces the corner is on.
  //? gap: n.dot(box.axes.col(i))
  Eigen::Vector3d corner = box.centre;
  for (int i = 0; i < 3; ++i)
    corner += std::copysign(box.half_lengths[i], n.dot(box.axes.col(i))) * box.axes.col(i);
  return corner;
}

Eigen::Vector3d farthest(const Cylinder& cylinder, const Eigen::Vector3d& n) {
  //? One of the ends is farther along n, as in a capsule.
  //? gap: n.dot(axis) > 0
  const auto& [start, end] = cylinder.core;
  const Eigen::Vector3d axis = end - start;
  const Eigen::Vector3d centre = n.dot(axis) > 0 ? end : start;
  //? From there, the rim is perpendicular to the core: only that component of n counts.
  //? gap: n.dot(axis) / axis.squaredNorm() * axis
  //? gap: cylinder.radius * unit(outwards)
  const Eigen::Vector3d outwards = n - n.dot(axis) / axis.squaredNorm() * axis;
  return centre + cylinder.radius * unit(outwards);
}

Eigen::Vector3d farthest(const Ellipsoid& ellipsoid, const Eigen::Vector3d& n) {
  //? An ellipsoid is a unit ball whose coordinates are scaled by h. As n · (h x) = (h n) · x, the
  //? direction for the ball is h n.
  //? gap: ellipsoid.axes.transpose() * n
  const Eigen::Vector3d& h = ellipsoid.half_lengths;
  const Eigen::Vector3d scaled = h.cwiseProduct(ellipsoid.axes.transpose() * n);
  //? The farthest point of the ball is scaled too.
  //? gap: h.cwiseProduct(unit(scaled))
  return ellipsoid.centre + ellipsoid.axes * h.cwiseProduct(unit(scaled));
}

}  // namespace

Eigen::Vector3d support(const Body& body, const Eigen::Vector3d& direction) {
  //? The length of a direction does not matter, so it may be 1.
  //? gap: unit(direction)
  const Eigen::Vector3d n = unit(direction);
  //? Each kind of body has its own farthest point.
  return std::visit([&](const auto& shape) { return farthest(shape, n); }, body.shape);
}

Eigen::Vector3d support_of_difference(const Body& first, const Body& second,
                                      const Eigen::Vector3d& direction) {
  //? p - q is farthest along n if p is and if q is farthest along the opposite direction.
  //? gap: support(second, -direction)
  return support(first, direction) - support(second, -direction);
}

}  // namespace exercise
