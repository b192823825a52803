#pragma once

#include "../commands.hpp"

namespace contact::cli {

/// `contact dev mutants`.
void add_dev_mutants(Command dev, Action& action);

}  // namespace contact::cli
