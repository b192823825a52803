#pragma once

// What must hold of every explanation, whatever was asked.

#include <string>

#include "diagnosis/explain_request.hpp"

namespace contact::testing {

/// Why an explanation is wrong; empty if nothing is.
/// @param told the JSON that contact-explain prints
std::string what_is_wrong(const grading::ExplainRequest& asked, const std::string& told);

}  // namespace contact::testing
