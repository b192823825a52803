#include "sort_and_sweep.hpp"

namespace exercise {

std::vector<int> order_along_x(const std::vector<Box>& /*boxes*/) { contact::todo(); }

Swept sort_and_sweep(const std::vector<Box>& /*boxes*/) { contact::todo(); }

}  // namespace exercise
