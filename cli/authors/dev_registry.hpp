#pragma once

#include "../commands.hpp"

namespace contact::cli {

/// `contact dev registry`.
void add_dev_registry(Command dev, Action& action);

}  // namespace contact::cli
