#include "break_body_inertia.hpp"

// The code to break. Your functions may call it, to search for an input on which it fails.
#include "effective_mass.hpp"

namespace exercise {

Contact wrong_by_half() { contact::todo(); }

Contact small_rotation() { contact::todo(); }

Contact similar_moments() { contact::todo(); }

}  // namespace exercise
