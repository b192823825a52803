/// @file
/// The force of a contact with one mistake that people make: what the test of the exercise
/// recognises.
#pragma once

#include <algorithm>
#include <cmath>

#include "contact_force.hpp"

namespace force_with_mistakes {

using exercise::Spring;
using Plane = contact::Plane<double>;
using Sphere = contact::Sphere<double>;
using Vector = Eigen::Vector3d;

/// What is done wrong along the normal.
enum class Way {
  energy,            ///< k d² / 2 instead of k d
  no_damper,         ///< the damper is left out
  damper_reversed,   ///< it pushes in separation
  damper_by_depth,   ///< its force is multiplied by the penetration
  damper_one_way,    ///< it acts in approach only
  speed,             ///< it pushes in separation as in approach
  ends_at_depth,     ///< no force in separation
  pulls,             ///< the sum may be negative
  magnitude,         ///< a pull becomes a push
  damper_let_go,     ///< where both would pull, the spring alone pushes
  touching_missed,   ///< a penetration of 0 is no contact
  across_a_gap,      ///< a gap is not tested, and the sum is clamped
  pulls_over_a_gap,  ///< nor is the sum clamped
};

inline double force(double d, double approach, const Spring& s, Way way) {
  const bool tests_gap = way != Way::across_a_gap && way != Way::pulls_over_a_gap;
  if (tests_gap && (way == Way::touching_missed ? d <= 0 : d < 0)) return 0;
  if (way == Way::ends_at_depth && approach < 0) return 0;
  const double spring = way == Way::energy ? s.stiffness * d * d / 2 : s.stiffness * d;
  double damper = s.damping * approach;
  if (way == Way::no_damper) damper = 0;
  if (way == Way::damper_reversed) damper = -damper;
  if (way == Way::damper_by_depth) damper *= d;
  if (way == Way::damper_one_way) damper = std::max(damper, 0.0);
  if (way == Way::speed) damper = std::abs(damper);
  const double sum = spring + damper;
  if (way == Way::pulls || way == Way::pulls_over_a_gap) return sum;
  if (way == Way::magnitude) return std::abs(sum);
  if (way == Way::damper_let_go && sum < 0) return spring;
  return std::max(sum, 0.0);
}

/// What is done wrong with a ball.
enum class BallWay {
  centre,        ///< the penetration of the centre
  diameter,      ///< the penetration by twice the radius
  either_side,   ///< the half-space as a plane with two sides
  offset_added,  ///< normal·x = −offset
  into,          ///< the force points into the half-space
  moving_away,   ///< the approach has the wrong sign
  whole_speed,   ///< the approach is the speed
  whole_damper,  ///< the damper resists the whole velocity
  along_path,    ///< the force is opposite to the velocity
  pulled,        ///< the force may point into the half-space, in separation
};

inline Vector force_on_ball(const Sphere& ball, const Vector& velocity, const Plane& surface,
                            const Spring& spring, BallWay way) {
  const Vector& n = surface.normal;
  const double offset = way == BallWay::offset_added ? -surface.offset : surface.offset;
  double distance = n.dot(ball.centre) - offset;
  if (way == BallWay::either_side) distance = std::abs(distance);
  double radius = ball.radius;
  if (way == BallWay::centre) radius = 0;
  if (way == BallWay::diameter) radius *= 2;
  const double d = radius - distance;
  if (d < 0) return {0, 0, 0};
  double approach = -n.dot(velocity);
  if (way == BallWay::moving_away) approach = -approach;
  if (way == BallWay::whole_speed) approach = velocity.norm();
  const double sum = spring.stiffness * d + spring.damping * approach;
  if (way == BallWay::pulled) return sum * n;
  if (way == BallWay::whole_damper) return spring.stiffness * d * n - spring.damping * velocity;
  const double push = std::max(sum, 0.0);
  if (way == BallWay::along_path) return -push * velocity.normalized();
  return way == BallWay::into ? Vector(-push * n) : Vector(push * n);
}

}  // namespace force_with_mistakes
