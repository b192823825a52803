#include "throwing.hpp"

namespace exercise {

double after_exchange(double /*mass*/, double /*velocity*/, double /*mass_change*/,
                      double /*matter_velocity*/) {
  contact::todo();
}

double after_throws(double /*thrower*/, const std::vector<double>& /*stones*/, double /*velocity*/,
                    double /*relative*/) {
  contact::todo();
}

}  // namespace exercise
