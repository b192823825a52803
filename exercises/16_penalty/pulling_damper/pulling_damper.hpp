/// @file
/// Exercise: bodies that a contact with a damper pulls back.
///
/// A contact is a spring and a damper in parallel. No other force acts. With the damping ratio
/// ζ = c / (2 √(k m)) it is critically damped for ζ = 1.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// A contact at one moment.
struct Moment {
  double stiffness;    ///< k, N/m
  double damping;      ///< c, N·s/m
  double mass;         ///< m, kg
  double penetration;  ///< m
  double approach;     ///< rate of change of the penetration, m/s; negative: separation
};

/// A moment at which given::contact_force pulls, although the damping ratio is at most 0.1 and the
/// surfaces overlap by at least a millimetre. The stiffness is from 1 to 100,000, the mass from
/// 0.01 to 100, the overlap at most 1 m, the speed at most 1 m/s.
Moment weak_damper_pulls();

/// A first touch, with a penetration of 0, after which the body leaves, by given::rebound_speed,
/// with at least 5 % of its speed, but with at most half of the speed that it would have if the
/// contact ended at zero force. The stiffness is from 1 to 100,000, the mass from 0.01 to 100, the
/// damping ratio at most 10, the approach from 0.01 to 10 m/s.
Moment rebounds_too_slowly();

/// A first touch, with a penetration of 0, after which the body has not left the surface after a
/// hundred √(m / k), by given::rebound_speed, although it would leave with at least 12 % of its
/// speed if the contact ended at zero force. The numbers are from the same ranges.
Moment never_lets_go();

}  // namespace exercise
