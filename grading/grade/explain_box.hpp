#pragma once

// Explaining what a compiler said of a stranger's file, in a box of its own: the file and the
// messages are a stranger's too.

#include "../diagnosis/explain_request.hpp"
#include "../sandbox/box.hpp"

namespace contact::grading {

/// Limits of one explanation.
inline constexpr double explain_cpu_seconds = 2.0;
inline constexpr double explain_wall_seconds = 20.0;
inline constexpr int explain_memory_mb = 256;

/// What contact-explain says of it; past its limits, and whatever else goes wrong there, only the
/// compiler's own first error.
/// @throws BookError if the machine itself fails
Explained explain_in_box(Loop& loop, const Machine& machine, const Seat& seat,
                         const ExplainRequest& request);

}  // namespace contact::grading
