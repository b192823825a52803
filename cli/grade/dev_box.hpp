#pragma once

#include "../commands.hpp"

namespace contact::cli {

/// `contact dev box`: one command in a sandbox, to try what the sandbox prevents.
void add_dev_box(Command dev, Action& action);

}  // namespace contact::cli
