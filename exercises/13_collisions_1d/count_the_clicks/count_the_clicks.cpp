#include "count_the_clicks.hpp"

namespace exercise {

int clicks(double /*ratio*/) { contact::todo(); }

}  // namespace exercise
