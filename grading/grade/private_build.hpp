#pragma once

// From an instructor's sources to the program that asks a submission.

#include <filesystem>

#include "private_folder.hpp"

namespace contact::grading {

/// Compiles and links the tests of one exercise, unless the program of an earlier call is current.
/// @param cache where programs are kept, a folder for each exercise
/// @throws BookError that holds what the compiler or the linker said, or the test that is not
/// listed or not there
PrivateExercise private_exercise(Loop& loop, const Book& book, const BuildDescription& build,
                                 const PrivateFolder& folder, const std::filesystem::path& cache);

}  // namespace contact::grading
