#pragma once

// Reads a folder of untrusted submissions: each is a folder, an archive or one file. A fault in one
// is reported in a sentence and does not affect the others.

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "intake_ids.hpp"
#include "submission.hpp"

namespace contact::grading {

struct Entrant {
  /// Fit to be a folder's name; unique whatever the case of letters.
  std::string id;
  std::string name;
  /// As it lies in SUBMISSIONS; several, with ", " between them, if a learning system gave each
  /// file an entry of its own.
  std::string entry;
  /// Why it is refused whole; empty if it is not.
  std::string problem;
  /// Whether it was looked into; not if it is refused for its name, or for what kind of entry it
  /// is.
  bool opened = false;
  /// Its files that answer to no exercise of the book.
  std::vector<std::string> ignored;
  /// By the exercise's id.
  std::map<std::string, TakenFile> files;
};

struct Intake {
  /// In the order of their ids, without the texts.
  std::vector<Entrant> entrants;
  /// Entries that are not submissions (a learning system's own files).
  std::vector<std::string> passed_over;
  /// Entries that the table of ids names and that are not there.
  std::vector<std::string> absent;
};

/// @param only the exercise that a file is for if its name does not say; nullptr if that is not
/// known
/// @param keep called with each entrant and its texts, which are then dropped: one student's work
/// is in memory at a time
/// @throws BookError if the folder itself cannot be read
Intake take_in(const Book& book, const std::filesystem::path& submissions, const IdTable* ids,
               const Exercise* only, const std::function<void(const Entrant&)>& keep);

/// Why the refusal of a whole class looks like a mistake of the instructor; empty if it does not. A
/// single submission may be a broken archive, and its student should read that.
std::string mistaken_for_submissions(const Intake& intake,
                                     const std::filesystem::path& submissions);

}  // namespace contact::grading
