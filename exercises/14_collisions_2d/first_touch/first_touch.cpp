#include "first_touch.hpp"

namespace exercise {

std::optional<Touch> first_touch(const std::vector<Disc>& /*discs*/) { contact::todo(); }

}  // namespace exercise
