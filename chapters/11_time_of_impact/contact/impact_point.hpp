/// @file
/// Where two translating bodies touch: the contact point on the surfaces, for drawing and response.
#pragma once

#include <cmath>
#include <cstddef>
#include <type_traits>

#include <contact/bounded_differences.hpp>
#include <contact/gjk_simplex.hpp>
#include <contact/impact_proof.hpp>
#include <contact/plane.hpp>
#include <contact/support.hpp>
#include <contact/translating_impact.hpp>
#include <contact/vector.hpp>

namespace contact {

/// A contact of two translating bodies at their time of impact.
struct TouchPoint {
  Vector3<double> point = Vector3<double>::Zero();   ///< m, where it is at that time
  Vector3<double> normal = Vector3<double>::Zero();  ///< unit vector from B to A; 0 at the start
};

// [impact-point]
/// A point in which two bodies touch at their time of impact: start + displacement · t, and from
/// there against the normal by the radius, to the surface itself.
///
/// The vertices that prove the meeting have weights for which their difference is closest to 0; the
/// same mean of A's vertices, moved to the time t, is a point of its core. Of bodies that touch
/// along an edge or a face it is one point of these. Rounded: off by 2^-40 of the displacement and
/// some u of the coordinates, divided by the angle between features that are nearly parallel.
/// @param found of translating_impact() for the same bodies, whose numbers are double; it must meet
/// @return for bodies that meet at the start, a point near a common one and no normal
template <PolytopeCore A, PolytopeCore B>
TouchPoint impact_point(const TranslatingImpact& found, const A& a,
                        const Vector3<double>& displacement_a, const B& b,
                        const Vector3<double>& displacement_b) {
  static_assert(std::is_same_v<ScalarOf<A>, double> && std::is_same_v<ScalarOf<B>, double>,
                "the bodies' numbers must be double");
  TouchPoint contact;
  const auto count = static_cast<std::size_t>(found.common.count);
  if (!found.meets || count == 0) return contact;
  FourPoints<double> differences, points;
  differences.fill(Vector3<double>::Zero());
  points.fill(Vector3<double>::Zero());
  const Vector3<double> w = displacement_a - displacement_b;
  for (std::size_t i = 0; i < count; ++i) {
    const auto p = detail::vertex_from_position(a, found.common.of_a[i]);
    const auto q = detail::vertex_from_position(b, found.common.of_b[i]);
    points[i] = p.position + p.offset;
    differences[i] = (p.position - q.position) + (p.offset - q.offset) + w * found.t;
  }
  const auto weights = closest_of_simplex(differences, found.common.count).weights;
  Vector3<double> from_a = Vector3<double>::Zero();
  for (std::size_t i = 0; i < count; ++i) from_a += points[i] * weights[i];
  from_a += displacement_a * found.t;
  if (found.t > 0) contact.normal = normalised(found.plane.normal);
  const Vector3<double> zero = Vector3<double>::Zero();
  contact.normal += zero;  // no −0
  contact.point = from_a - contact.normal * radius_of(a) + zero;
  return contact;
}
// [/impact-point]

}  // namespace contact
