#pragma once

// The position in a message is only a claim, because a submission controls what the compiler
// prints: a #line directive gives any line any number, and an assembler's .error prints any text.
// This file checks each claim against the file that was handed in.

#include <string>
#include <vector>

#include "compiler_messages.hpp"
#include "contract_text.hpp"
#include "source_text.hpp"

namespace contact::grading {

/// Makes the numbers of messages, of their notes and of the steps to them true: in the student's
/// file, a line that it has (and the one after the last) and a column that lies in it, in bytes;
/// in a header of the book, a line that it has. What is not true, and what is said of any other
/// file, becomes 0. Lines that a #line directive renumbers get the number that they have in the
/// file. An excerpt whose line is not the file's is dropped.
void check_claims(std::vector<Diagnostic>& diagnostics, const std::string& file,
                  const SourceText& source, const ContractText& contract, Columns columns);

}  // namespace contact::grading
