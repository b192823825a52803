#include "sum_of_impulses.hpp"

namespace exercise {

double total(const std::vector<double>& /*impulses*/) { contact::todo(); }

}  // namespace exercise
