#pragma once

// Identifies the student of a submission: from the names that learning systems give to exported
// files, or from a table.

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace contact::grading {

/// A to Z as a to z; everything else as it is.
std::string ascii_lower(std::string text);

/// Records of a CSV file as RFC 4180 has it: commas, quoted fields, "" for a quote in one. A byte
/// order mark is passed over, and so are empty lines.
/// @throws BookError with the line of what is not so
std::vector<std::vector<std::string>> parse_csv(std::string_view text, const std::string& file);

struct Identity {
  std::string id;
  /// Empty if not given.
  std::string name;
};

/// A table of students: columns entry and id, and name if there is one, in any order.
class IdTable {
 public:
  /// @throws BookError with the file and the line
  explicit IdTable(const std::filesystem::path& file);

  [[nodiscard]] const std::filesystem::path& file() const { return file_; }
  /// Of an entry of SUBMISSIONS by its name as UTF-8, composed or decomposed, with or without what
  /// an archive's name ends with.
  [[nodiscard]] const Identity* find(const std::string& entry) const;
  /// What the table names and what is not among the entries.
  [[nodiscard]] std::vector<std::string> missing_in(const std::vector<std::string>& entries) const;

 private:
  std::filesystem::path file_;
  std::map<std::string, Identity> entries_;
  /// The entries of the table by how they are decomposed.
  std::map<std::string, std::string> by_form_;
};

/// What the name of an entry says:
///
///   Moodle  Name_12345_assignsubmission_file_            -> 12345, "Name"
///           Name_12345_assignsubmission_file_FILE        -> the same, and FILE
///   Canvas  name_123_456_FILE, name_LATE_123_456_FILE    -> 123, "name", and FILE
///           (files only, numbers of three digits or more)
///   else    STUDENT_EXERCISE.cpp, -EXERCISE.cpp          -> STUDENT, and EXERCISE.cpp
///   else    the whole name, without .zip, .tar.gz or .tgz
struct EntryName {
  Identity identity;
  /// The student's own name of the file; empty if the entry's name does not hold one.
  std::string file;
  /// Whether several entries may be of one student: each is one of the files handed in.
  bool one_of_several = false;
};
/// @param exercises the names of exercises that only one chapter has
EntryName read_entry_name(const std::string& entry, bool is_folder,
                          const std::vector<std::string>& exercises);

/// The name without .zip, .tar.gz, .tgz or .cpp.
std::string without_suffix(const std::string& entry);

/// An id as the name of a folder on every system and in every address: letters, digits and "._-"
/// stay, as do "@" and "+" but in front, anything else becomes ~ and two hexadecimal digits a byte.
std::string safe_id(const std::string& id);

}  // namespace contact::grading
