#pragma once

// The contract as text: what it declares, so that a message can show it beside the student's line.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "verdict.hpp"

namespace contact::grading {

/// The contract itself, then the plain shapes that contracts are written with.
std::vector<std::filesystem::path> contract_files(const Exercise& exercise);

/// Whether two names mean one file, wherever the root is.
bool same_file(const std::filesystem::path& a, const std::filesystem::path& b);

/// A line of a file; empty if there is none.
std::string line_of_file(const std::filesystem::path& file, int number);

/// A line and those after it, to the end of the declaration.
std::string declaration_at(const std::filesystem::path& file, int line);

/// The lines of a header that declare a name (a function, a struct), to the end of the declaration.
std::optional<ContractLine> declaration_of(const std::filesystem::path& header,
                                           const std::string& name);

/// The same from the contract or the shapes.
std::optional<ContractLine> declaration_of(const Exercise& exercise, const std::string& name);

/// Whether a file holds this text.
bool mentions(const std::filesystem::path& file, std::string_view text);

/// The members of a struct of the contract or the shapes, in order; empty if it is none of them.
std::vector<std::string> members_of(const Exercise& exercise, const std::string& structure);

}  // namespace contact::grading
