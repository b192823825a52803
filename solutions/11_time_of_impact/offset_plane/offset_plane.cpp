#include "offset_plane.hpp"

namespace exercise {

contact::Plane<double> offset_plane(const contact::Plane<double>& plane,
                                    const contact::Sphere<double>& sphere) {
  //? The side is that of the centre: the sphere may reach to the other side already.
  //? gap: distance < 0
  const double distance = plane.normal.dot(sphere.centre) - plane.offset;
  const double side = distance < 0 ? -1 : 1;
  //? The normal stays, and the offset changes by the radius.
  //? gap: plane.offset + side * sphere.radius
  return {plane.normal, plane.offset + side * sphere.radius};
}

std::optional<Contact> sphere_meets_plane(const contact::Sphere<double>& sphere,
                                          const Eigen::Vector3d& displacement,
                                          const contact::Plane<double>& plane, double rise) {
  //? A contact at the start needs no division.
  //? gap: sphere.centre - distance * plane.normal
  const double distance = plane.normal.dot(sphere.centre) - plane.offset;
  if (std::abs(distance) <= sphere.radius) {
    return Contact{0, sphere.centre - distance * plane.normal};
  }
  //? The centre has to get to the offset plane, and only the relative displacement counts.
  //? gap: offset.offset - plane.normal.dot(sphere.centre)
  //? gap: plane.normal.dot(displacement) - rise
  const contact::Plane<double> offset = offset_plane(plane, sphere);
  const double missing = offset.offset - plane.normal.dot(sphere.centre);
  const double closing = plane.normal.dot(displacement) - rise;
  //? They move apart, keep their distance, or do not get near enough.
  //? gap: std::abs(missing) > std::abs(closing)
  const bool approach = distance < 0 ? closing > 0 : closing < 0;
  if (!approach || std::abs(missing) > std::abs(closing)) return std::nullopt;
  const double t = missing / closing;
  //? From the centre back to the plane, along the normal.
  //? gap: sphere.centre + t * displacement
  //? gap: plane.offset - offset.offset
  const Eigen::Vector3d centre = sphere.centre + t * displacement;
  return Contact{t, centre + (plane.offset - offset.offset) * plane.normal};
}

}  // namespace exercise
