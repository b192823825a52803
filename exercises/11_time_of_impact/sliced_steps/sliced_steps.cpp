#include "sliced_steps.hpp"

// The code to break. Your functions may call it, to search for an input on which it fails.
#include "slices_as_tested.hpp"

namespace exercise {

Shot through_the_plate() { contact::todo(); }

Shot graze_missed_again() { contact::todo(); }

Shot lost_by_finer_slices() { contact::todo(); }

}  // namespace exercise
