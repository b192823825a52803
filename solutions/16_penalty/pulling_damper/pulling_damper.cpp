#include "pulling_damper.hpp"

namespace exercise {

// The damping ratio is 4 / (2 √1000), 0.063. Near the end of a contact the spring pushes with 1 N,
// and the damper pulls with 4 N.
Moment weak_damper_pulls() { return {1000, 4, 1, 0.001, -1}; }

// With ζ = 0.6 the body keeps 9 % of its speed, and 25 % if the contact ends at zero force.
Moment rebounds_too_slowly() { return {100, 12, 1, 0, 2}; }

// With ζ = 1 the overlap only tends to 0. At zero force the restitution is exp(−2), 14 %.
Moment never_lets_go() { return {100, 20, 1, 0, 2}; }

}  // namespace exercise
