#pragma once

// A pack: a teacher's own chapters and exercises in a folder of their own, with the same layout as
// the book and a pack.toml. It is used with the book and writes nothing into it.

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "book.hpp"

namespace contact::grading {

/// A version of the book: major, minor, patch.
using Version = std::array<int, 3>;

/// "1.4" or "1.4.2"; none if the text is no version.
std::optional<Version> version_from(std::string_view text);

/// A condition on a version, as in ">=0.9,<0.10". Conditions are separated by commas, and all must
/// hold; a version alone is the lowest that is allowed.
class VersionRange {
 public:
  /// @return none if the text is no range
  static std::optional<VersionRange> from(std::string_view text);
  [[nodiscard]] bool holds(const Version& version) const;

 private:
  struct Bound {
    std::string sign;
    Version version{};
  };
  std::vector<Bound> bounds_;
};

/// The versions that a pack made with this version of the book needs: from this one on, below the
/// next that may change what packs use. "0.9.2" gives ">=0.9.2,<0.10", "1.4.0" gives ">=1.4.0,<2".
/// @throws BookError if the text is no version
std::string range_from(std::string_view version);

/// Where a fault of a pack is, and what it is.
struct PackFault {
  std::filesystem::path file;
  int line = 1;
  std::string what;
};

/// What pack.toml says.
struct Pack {
  std::string name;
  std::string title;
  std::string book;  ///< the versions of the book that it needs, ">=0.9,<0.10"
  std::vector<std::string> authors;
};

/// Reads pack.toml.
/// @param version the book's
/// @param faults what is wrong with the file is added to these
Pack read_pack(const std::filesystem::path& folder, std::string_view version,
               std::vector<PackFault>& faults);

/// What is wrong with a pack's folders and files: missing files, keys that are missing or unknown,
/// and names that the book has too.
std::vector<PackFault> faults_of_files(const Book& pack);

/// The pack in `folder`, on top of the book.
/// @param version the book's
/// @throws BookError with a line for each fault: FILE:LINE: what is wrong and what to do
std::unique_ptr<Book> open_pack(const std::filesystem::path& folder,
                                std::shared_ptr<const Book> book, std::string_view version);

/// The folder that CONTACT_PACK names, which `./contact --pack` sets; empty if it is unset.
std::filesystem::path find_pack();

}  // namespace contact::grading
