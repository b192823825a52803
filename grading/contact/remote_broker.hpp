/// @file
/// The requests of a program that runs tests in a sandbox to the process that put it there, because
/// in a sandbox it cannot start processes.
///
/// CONTACT_BROKER in its environment is the number of a descriptor, a Unix socket that keeps
/// packets apart (SOCK_SEQPACKET). Each request is one packet, and so is each reply.
///
///     start  ->  given, and by SCM_RIGHTS the near end of the socket to a submission started anew;
///                or words: why there is none
///     why    ->  words: why the submission ended
///     done       no reply: the submission is no longer needed
#pragma once

#include <sys/socket.h>
#include <sys/uio.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

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

/// Sends a reply, with a descriptor unless that is negative. The process that asked may have ended;
/// then the reply is dropped.
inline void send_reply(int socket, BrokerReply::Kind kind, std::string_view words,
                       int descriptor = -1) {
  BrokerReply head;
  head.kind = kind;
  words = words.substr(0, kMaxBrokerWords);
  std::string packet(sizeof head, '\0');
  std::memcpy(packet.data(), &head, sizeof head);
  packet += words;
  iovec bytes{packet.data(), packet.size()};
  alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(int))> control{};
  msghdr message{};
  message.msg_iov = &bytes;
  message.msg_iovlen = 1;
  if (descriptor >= 0) {
    message.msg_control = control.data();
    message.msg_controllen = control.size();
    cmsghdr* part = CMSG_FIRSTHDR(&message);
    part->cmsg_level = SOL_SOCKET;
    part->cmsg_type = SCM_RIGHTS;
    part->cmsg_len = CMSG_LEN(sizeof(int));
    std::memcpy(CMSG_DATA(part), &descriptor, sizeof descriptor);
  }
  ::sendmsg(socket, &message, MSG_NOSIGNAL | MSG_DONTWAIT);
}

}  // namespace contact::remote
