#include "same_averages.hpp"

namespace exercise {

Comparison compare(const std::vector<double>& /*first*/, const std::vector<double>& /*second*/,
                   double /*limit*/) {
  contact::todo();
}

}  // namespace exercise
