/// @file
/// What a program that runs tests in a box asks of whoever put it there: in a box it can start no
/// process itself.
///
/// CONTACT_BROKER in its environment is the number of a descriptor, a Unix socket that keeps
/// packets apart (SOCK_SEQPACKET). Each request is one packet, and so is each reply.
///
///     start  ->  given, and by SCM_RIGHTS the near end of the socket to a submission started anew;
///                or words: why there is none
///     why    ->  words: why the submission ended
///     done       no reply: the submission is no longer needed
#pragma once

#include <cstddef>
#include <cstdint>

namespace contact::remote {

inline constexpr std::uint32_t kBrokerMagic = 0x31524b42;  // "BKR1"

struct BrokerRequest {
  enum class Kind : std::uint32_t { start, why, done };
  std::uint32_t magic = kBrokerMagic;
  Kind kind = Kind::start;
  /// For which test, counted from 1 as they begin in this process.
  std::uint64_t test = 0;
};
static_assert(sizeof(BrokerRequest) == 16);

/// The head of a reply; the words follow it, as bytes.
struct BrokerReply {
  enum class Kind : std::uint32_t { given, words };
  std::uint32_t magic = kBrokerMagic;
  Kind kind = Kind::given;
};
static_assert(sizeof(BrokerReply) == 8);

inline constexpr std::size_t kMaxBrokerWords = 4096;

}  // namespace contact::remote
