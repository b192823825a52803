#pragma once

// The restrictions of a sandbox on this machine, each tried in a sandbox of its own.

#include <optional>
#include <string>
#include <vector>

#include "machine.hpp"

namespace contact::grading {

/// Why not even a box that does nothing ends well; nothing if it does.
std::optional<std::string> why_no_box(Loop& loop, const Machine& machine);

/// @param why_not_full what was said when the machine could not make namespaces; empty if it can
std::vector<Measure> try_measures(Loop& loop, const Machine& machine,
                                  const std::string& why_not_full);

}  // namespace contact::grading
