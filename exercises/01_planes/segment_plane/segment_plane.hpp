/// @file
/// Exercise: where and when a segment crosses a plane.
#pragma once

#include <contact/prelude.hpp>

#include <contact/shapes.hpp>

namespace exercise {

/// The one point at which the segment meets the plane, or nothing.
///
/// The hit holds `t`, the fraction of the segment from start (0) to end (1), and the `point`. If
/// the segment is the path of a particle during one step, t is the fraction of the step at the
/// contact.
///
/// - Touching counts: a segment that starts or ends on the plane meets it there.
/// - Both directions count, from the front to the back and from the back to the front.
/// - A segment that lies in the plane has no single point: nothing. A segment of length zero does
///   not cross: nothing.
/// - Size does not matter: two ends 1e-200 m in front of the plane are both in front of it.
///
/// @param segment start and end, m
/// @param plane normal·x = offset, with a unit normal
std::optional<contact::RayHit<double>> segment_plane(const contact::Segment<double>& segment,
                                                     const contact::Plane<double>& plane);

}  // namespace exercise
