#pragma once

// Untrusted archives, read entry by entry: a zip, or a tar in one layer of gzip. Nothing is
// written, only the requested entries are unpacked, and a fault is one error message.

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "../book/book.hpp"
#include "../text/shown_text.hpp"
#include "zip_names.hpp"

namespace contact::grading {

/// Why an archive is refused, in a sentence that names the entry and the limit.
class ArchiveError : public BookError {
 public:
  using BookError::BookError;
};

// Bytes and counts that are limits wherever a reader's work is taken in.
constexpr std::size_t mebibyte = std::size_t{1} << 20;
constexpr std::size_t max_in_file = 1 * mebibyte;
constexpr std::size_t max_in_all = 20 * mebibyte;
constexpr std::size_t max_packed = 24 * mebibyte;
constexpr std::size_t max_entries = 1000;

/// "20 MiB" for 20 * mebibyte.
std::string mebibytes(std::size_t bytes);

/// Why a text cannot be a reader's work, such as "is not text in UTF-8"; empty if it can.
std::string problem_of_text(std::string_view text);

/// Whether a name is one of an archive that is read here: it ends with .zip, .tar.gz or .tgz.
bool is_archive_name(std::string_view name);

/// The bytes of an archive. @throws ArchiveError if it is no file, empty or too large.
std::string packed(const std::filesystem::path& file);

/// One after the other, the entries of an archive. Every member throws ArchiveError.
class ArchiveEntries {
 public:
  /// @param bytes must outlive this
  explicit ArchiveEntries(const std::string& bytes);
  ~ArchiveEntries();
  ArchiveEntries(const ArchiveEntries&) = delete;
  ArchiveEntries& operator=(const ArchiveEntries&) = delete;

  /// Goes to the next entry; false at the end.
  bool next();
  /// In UTF-8 if the archive's name is, or is CP437 as old zips have it; else the bytes as they
  /// are.
  [[nodiscard]] const std::string& path() const { return readings_.front(); }
  /// The path, and what another program may call the entry instead.
  [[nodiscard]] const std::vector<std::string>& readings() const { return readings_; }
  [[nodiscard]] bool is_folder() const;
  /// Whether the path is in the archive exactly as path() returns it, with no other interpretation.
  [[nodiscard]] bool as_written() const { return as_written_; }
  /// Refuses links, devices, encryption, and compressions that may ask for gigabytes to unpack a
  /// few bytes.
  void require_plain() const;
  /// As the archive says it; 0 if it does not.
  [[nodiscard]] std::size_t size() const;
  /// Skips the entry, which counts with its declared size.
  void pass();
  /// Its bytes.
  std::string read();

 private:
  struct State;
  void require_room(std::size_t size, bool in_file) const;

  std::unique_ptr<State> state_;
  std::vector<std::string> readings_{""};
  bool as_written_ = false;
  std::string last_ = "its beginning";
  std::size_t entries_ = 0;
  std::size_t left_ = max_in_all;
};

}  // namespace contact::grading
