#pragma once

#include "../commands.hpp"

namespace contact::cli {

/// `contact dev box`: one command in one box, for trying what a box keeps it from.
void add_dev_box(Command dev, Action& action);

}  // namespace contact::cli
