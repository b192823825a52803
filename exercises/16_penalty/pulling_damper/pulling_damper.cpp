#include "pulling_damper.hpp"

// The code to break. Your functions may call it, to search for an input on which it fails.
#include "damped_contact.hpp"

namespace exercise {

Moment weak_damper_pulls() { contact::todo(); }

Moment rebounds_too_slowly() { contact::todo(); }

Moment never_lets_go() { contact::todo(); }

}  // namespace exercise
