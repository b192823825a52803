#include "sha256.hpp"

#include <array>
#include <cstdint>

#include "../book/book.hpp"

namespace contact::grading {

Sha256::Sha256() { sha256_init(&state_); }

Sha256& Sha256::add(std::string_view bytes) {
  sha256_update(&state_, bytes.size(), reinterpret_cast<const std::uint8_t*>(bytes.data()));
  return *this;
}

Sha256& Sha256::add_part(std::string_view bytes) {
  return add(std::to_string(bytes.size())).add(":").add(bytes);
}

std::string Sha256::text() {
  std::array<std::uint8_t, SHA256_DIGEST_SIZE> digest{};
  sha256_digest(&state_, digest.size(), digest.data());
  constexpr std::string_view digits = "0123456789abcdef";
  std::string result;
  for (const std::uint8_t byte : digest) {
    result += digits[byte >> 4];
    result += digits[byte & 0xf];
  }
  return result;
}

std::string sha256(std::string_view bytes) { return Sha256().add(bytes).text(); }

std::string sha256_of_file(const std::filesystem::path& file) { return sha256(read_text(file)); }

}  // namespace contact::grading
