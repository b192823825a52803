#include "segment_plane.hpp"

namespace exercise {

std::optional<contact::RayHit<double>> segment_plane(const contact::Segment<double>& segment,
                                                     const contact::Plane<double>& plane) {
  //? The signed distance of the start says on which half-space it lies, and how far away.
  //? gap: plane.normal.dot(segment.start)
  const double d0 = plane.normal.dot(segment.start) - plane.offset;
  //? The same for the end.
  const double d1 = plane.normal.dot(segment.end) - plane.offset;
  //? With both ends strictly in one half-space the segment does not meet the plane. An end on the
  //? plane counts as touching.
  //? gap: d0 < 0 && d1 < 0
  // Compare the signs one by one: a product of two tiny distances underflows to zero.
  if ((d0 > 0 && d1 > 0) || (d0 < 0 && d1 < 0)) return std::nullopt;
  //? Equal distances: the segment is parallel to the plane, and the division below would have no
  //? result.
  //? gap: d0 == d1
  if (d0 == d1) return std::nullopt;  // parallel to the plane, or in it
  //? The distance changes linearly from d0 to d1; it is zero after the fraction d0 / (d0 − d1).
  //? gap: d0 / (d0 - d1)
  const double t = d0 / (d0 - d1);
  //? The same fraction of the segment, counted from its start, leads to the point.
  //? gap: segment.end - segment.start
  return contact::RayHit<double>{t, segment.start + t * (segment.end - segment.start)};
}

}  // namespace exercise
