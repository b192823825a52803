#pragma once

// Runs the book's scripts in Python, for commands that need what such a script knows.

#include <filesystem>
#include <string>
#include <vector>

#include "../grading/book/book.hpp"
#include "../grading/process/run_process.hpp"

namespace contact::cli {

/// The project's own Python if `./contact setup` has made it, or the system's.
std::filesystem::path python_of(const grading::Book& book);
grading::ProcessResult run_python(grading::Loop& loop, const std::vector<std::string>& command);

}  // namespace contact::cli
