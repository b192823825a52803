#include "refit.hpp"

namespace exercise {

std::vector<Box> refit(const std::vector<Node>& /*nodes*/, const std::vector<Box>& /*boxes*/,
                       const std::vector<Box>& /*bodies*/) {
  contact::todo();
}

double cost(const std::vector<Node>& /*nodes*/, const std::vector<Box>& /*boxes*/) {
  contact::todo();
}

bool needs_rebuild(const std::vector<Node>& /*nodes*/, const std::vector<Box>& /*built*/,
                   const std::vector<Box>& /*now*/) {
  contact::todo();
}

}  // namespace exercise
