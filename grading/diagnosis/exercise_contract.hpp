#pragma once

// The headers of an exercise, read from the book, so that messages can be about them.

#include "contract_text.hpp"

namespace contact::grading {

/// The contract and the plain shapes. One that cannot be read is empty.
ContractText contract_of(const Exercise& exercise);

/// The same as texts, to be handed to where no file can be read.
std::vector<HeaderText> headers_of(const Exercise& exercise);

}  // namespace contact::grading
