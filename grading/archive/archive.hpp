#pragma once

// The archive of a reader's work, which the page, the command line and a grader exchange.
// cli/README.md defines it. No archive is trusted: reading one returns either its whole content,
// checked, or one error message.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "../progress/progress_record.hpp"
#include "archive_entries.hpp"

namespace contact::grading {

struct ArchivedCopy {
  std::string chapter;
  std::string name;
  std::string text;
  [[nodiscard]] std::string id() const { return chapter + "/" + name; }
  /// The path in the archive: work/NN_slug/NAME.cpp.
  [[nodiscard]] std::string path() const { return "work/" + id() + ".cpp"; }
};

struct Submission {
  /// When it was exported, in UTC; empty if the archive does not say.
  std::string exported;
  /// "page" or "contact"; empty if it says neither.
  std::string from;
  std::optional<ProgressRecord> progress;
  /// In the order of their paths.
  std::vector<ArchivedCopy> copies;
};

/// The chapter and the name in "NN_slug/NAME", without a text; nothing if it is spelled otherwise.
std::optional<ArchivedCopy> copy_from_id(std::string_view id);

/// @throws ArchiveError if it is broken, or holds anything that an archive of a reader's work does
/// not.
Submission read_submission(const std::filesystem::path& file);

/// The bytes of a zip file, the same for the same content.
/// @throws ArchiveError if reading it again would be refused for its size.
std::string submission_bytes(const Submission& submission);

}  // namespace contact::grading
