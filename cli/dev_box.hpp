#pragma once

#include <CLI/CLI.hpp>

#include "commands.hpp"

namespace contact::cli {

/// `contact dev box`: one command in one box, for trying what a box keeps it from.
void add_dev_box(CLI::App& dev, Action& action);

}  // namespace contact::cli
