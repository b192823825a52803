#pragma once

// The explanation of a compiler's or a linker's output, and its transfer from the process that
// finds it to the one that stores it.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "../verdict/verdict.hpp"

namespace contact::grading {

/// The maximum length of the explanation of one compile or link, as JSON.
inline constexpr std::size_t max_told_bytes = 256u << 10;
/// Of what the compiler or linker printed, no more than this is read or kept.
inline constexpr std::size_t max_log_bytes = 64u << 10;

struct Explained {
  /// The first error, if there is one.
  std::optional<CompileError> error;
  std::vector<Remark> remarks;
  /// Warnings at lines of the student's file, one line each.
  std::vector<std::string> warnings;
  /// The link failed only since the file defines names that the C library has too.
  bool only_library_twice = false;
};

/// The first lines of a log, with a last line that says how much was left out.
std::string kept_log(std::string_view log);

/// The text if nothing can be explained: the first line of the log that is an error, or else its
/// first line, cut to a readable length.
Explained unexplained(std::string_view log, bool failed, const std::string& file);

/// Without CompileError::full, which the caller has.
nlohmann::json to_json(const Explained& said);
/// @throws nlohmann::json::exception if it is not what to_json() makes
Explained explained_from_json(const nlohmann::json& json);

}  // namespace contact::grading
