#include "end_of_bounces.hpp"

namespace exercise {

double rest_time(double /*drop*/, double /*gravity*/, double /*k*/) { contact::todo(); }

int bounces_by(double /*drop*/, double /*gravity*/, double /*k*/, double /*time*/) {
  contact::todo();
}

}  // namespace exercise
