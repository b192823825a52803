#include "newtons_cradle.hpp"

namespace exercise {

std::vector<double> settled(const std::vector<Ball>& /*row*/) { contact::todo(); }

}  // namespace exercise
