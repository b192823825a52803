#pragma once

// The names in a zip as its bytes have them. libarchive converts names to the locale, changes
// backslashes, cuts at a zero byte, and loses what it cannot convert.

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace contact::grading {

/// The possible names of one entry: programs that unpack a zip do not agree on which name counts.
struct ZipName {
  /// In UTF-8 if that can be told, the best first; backslashes are slashes in a name that has no
  /// slash, as some programs on Windows write them.
  std::vector<std::string> readings;
  /// Whether all copies of the name in the archive equal the first reading, byte by byte.
  bool as_written = false;
};

class ZipNames {
 public:
  /// @param bytes must outlive this. Without a directory that can be read no name is known.
  explicit ZipNames(std::string_view bytes);

  [[nodiscard]] std::size_t size() const { return entries_.size(); }
  /// Of the entry whose header ends last before a position; without readings if there is none.
  [[nodiscard]] ZipName before(std::size_t position) const;

 private:
  struct Places {
    std::size_t local;
    std::size_t central;
  };

  std::string_view bytes_;
  /// By the end of the header in front of the entry's data.
  std::map<std::size_t, Places> entries_;
};

}  // namespace contact::grading
