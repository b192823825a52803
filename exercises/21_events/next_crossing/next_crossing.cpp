#include "next_crossing.hpp"

namespace exercise {

std::optional<Crossing> next_crossing(const Ball& /*ball*/, double /*size*/) { contact::todo(); }

}  // namespace exercise
