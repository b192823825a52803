#pragma once

// SHA-256, to tell whether a unit of grading is made of the same parts as before.

#include <filesystem>
#include <string>
#include <string_view>

#include <nettle/sha2.h>

namespace contact::grading {

class Sha256 {
 public:
  Sha256();
  Sha256& add(std::string_view bytes);
  /// Also says how long it is, so that "ab" and "c" is not "a" and "bc".
  Sha256& add_part(std::string_view bytes);
  /// In hexadecimal. Begins a new sum.
  std::string text();

 private:
  sha256_ctx state_{};
};

std::string sha256(std::string_view bytes);
/// Of a file's bytes. @throws BookError if it cannot be read.
std::string sha256_of_file(const std::filesystem::path& file);

}  // namespace contact::grading
