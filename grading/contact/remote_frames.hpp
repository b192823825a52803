/// @file
/// The bytes between a proxy and its server: for remote.cpp and remote_server.cpp only.
#pragma once

#include <sys/resource.h>

#include <cstdint>
#include <cstdlib>

namespace contact::remote {

inline constexpr std::uint32_t kMagic = 0x31544e43;  // "CNT1"
inline constexpr int kServerDescriptor = 3;

enum class Reply : std::uint32_t {
  value,
  not_attempted,
  invalid_argument,
  exception,
  out_of_memory,
  not_an_exception,
  refused
};

struct Header {
  std::uint32_t magic = kMagic;
  std::uint32_t kind = 0;  ///< of a request: the function; of a reply: a Reply
  std::uint64_t fingerprint = 0;
  std::uint64_t sequence = 0;
  std::uint64_t length = 0;
};
static_assert(sizeof(Header) == 32);

/// CONTACT_MEMORY_MB bounds the address space, and a crash leaves no core file.
inline void limit_resources() {
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  if (const char* text = std::getenv("CONTACT_MEMORY_MB")) {
    const rlim_t bytes = rlim_t{std::strtoull(text, nullptr, 10)} << 20;
    const rlimit memory{bytes, bytes};
    setrlimit(RLIMIT_AS, &memory);
  }
}

}  // namespace contact::remote
