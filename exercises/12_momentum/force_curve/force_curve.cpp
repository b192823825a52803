#include "force_curve.hpp"

namespace exercise {

Push push(const std::vector<Sample>& /*samples*/, double /*mass*/, double /*velocity*/) {
  contact::todo();
}

}  // namespace exercise
