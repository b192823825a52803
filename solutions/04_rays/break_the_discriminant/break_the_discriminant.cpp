#include "break_the_discriminant.hpp"

namespace exercise {

// b² and 4 a c are 1.8e11, where floats are 16384 apart, and round to the same one.
Shot missed_ball() { return {{-28, -873, 0}, {8, 241, 0}, {0, 0, 0}, 1}; }

// With a direction this long, a is rounded too, and comes out smaller than it is.
Shot ball_beside_the_ray() { return {{892, 43, 0}, {-4153, -205, 0}, {0, 0, 0}, 1}; }

// Nearby the ray must almost touch.
Shot near_ball() { return {{2, -120, 0}, {-3, 120, 0}, {0, 0, 0}, 1}; }

}  // namespace exercise
