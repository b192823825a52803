#pragma once

// Why a student's program ended, in words for the student: the same for a check and for grading.

#include <string>

#include "../process/run_process.hpp"

namespace contact::grading {

inline constexpr const char* printed_too_much = "it printed without end and was stopped";

/// Why a program that should have answered ended instead.
/// @param seconds that it had: of processor time, or on the clock if it was idle
std::string why_stopped(const ProcessResult& process, double seconds);

/// A signal in words: "segmentation fault: ...".
std::string signal_in_words(int signal, const std::string& printed);

/// What a program printed on standard error, without the line that why_stopped() has told.
std::string errors_not_told(const ProcessResult& process);

}  // namespace contact::grading
