#include "at_an_angle.hpp"

namespace exercise {

Motion stuck_together(const Vehicle& /*a*/, const Vehicle& /*b*/) { contact::todo(); }

Sizes leaving_at(double /*total*/, double /*angle_a*/, double /*angle_b*/) { contact::todo(); }

}  // namespace exercise
