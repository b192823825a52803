#include "force_curve.hpp"

namespace exercise {

ForceEffect apply_force(const std::vector<Sample>& /*samples*/, double /*mass*/,
                        double /*velocity*/) {
  contact::todo();
}

}  // namespace exercise
