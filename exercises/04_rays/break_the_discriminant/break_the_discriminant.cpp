#include "break_the_discriminant.hpp"

// The code to break. Your functions may call it, to search for an input on which it fails.
#include "hits_by_discriminant.hpp"

namespace exercise {

Shot missed_ball() { contact::todo(); }

Shot ball_beside_the_ray() { contact::todo(); }

Shot near_ball() { contact::todo(); }

}  // namespace exercise
