#include <contact/remote.hpp>

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <optional>
#include <random>
#include <string>
#include <utility>

#include <contact/prelude.hpp>
#include <contact/remote_frames.hpp>
#include <contact/remote_process.hpp>

namespace contact::remote {
namespace {

using Clock = std::chrono::steady_clock;

// Words of the student's own code, in an exception, are cut here.
constexpr std::size_t kMaxWords = 2000;
// An answer is sent at once and arrives in large pieces. In small ones it could take as long as the
// sender likes, which then would neither work nor sleep for long.
constexpr std::size_t kMaxSmallPieces = 256;
constexpr std::size_t kSmallPiece = 256;
constexpr std::string_view kUnasked = "sent unrequested bytes";

/// What the far side may send, and how often it is asked in one test.
struct Allowance {
  std::size_t bytes = number_from_environment("CONTACT_ANSWER_BYTES", kMaxPayload);
  std::uint64_t calls = number_from_environment("CONTACT_CALLS", 1'000'000);
};

/// The conversation with one far process after another.
class Conversation {
 public:
  Conversation() = default;
  Conversation(const Conversation&) = delete;
  Conversation& operator=(const Conversation&) = delete;
  ~Conversation() { hang_up(); }

  /// A test must not see what an earlier one left behind.
  void new_test() {
    stop();
    far_.reset();
    allowed_ = {};
    ++test_;
    calls_ = 0;
  }

  void stop() {
    if (socket_ < 0) return;
    hang_up();
    far_->stop();
  }

  std::pair<Reply, Bytes> ask(const Contract& contract, std::uint32_t function,
                              const Bytes& arguments) {
    if (++calls_ > allowed_.calls)
      stop_because("was called more than " + std::to_string(allowed_.calls) + " times in one test");
    if (arguments.size() > kMaxPayload) stop_because("would have been given more than can be sent");
    if (socket_ < 0) start();
    deadline_.reset();
    if (const double seconds = far_->patience(); seconds > 0.0)
      deadline_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                     std::chrono::duration<double>(seconds));
    std::uint8_t byte = 0;
    if (recv(socket_, &byte, 1, MSG_DONTWAIT | MSG_PEEK) > 0) stop_because(std::string{kUnasked});

    Header header;
    header.kind = function;
    header.fingerprint = contract.fingerprint;
    header.sequence = sequence_();
    header.length = arguments.size();
    Bytes request(sizeof header + arguments.size());
    std::memcpy(request.data(), &header, sizeof header);
    if (!arguments.empty())
      std::memcpy(request.data() + sizeof header, arguments.data(), arguments.size());
    send_all(request);
    return receive(contract, header.sequence);
  }

 private:
  Allowance allowed_;
  std::unique_ptr<FarProcess> far_;
  int socket_ = -1;
  std::uint64_t test_ = 0;
  std::uint64_t calls_ = 0;
  std::size_t small_pieces_ = 0;
  std::optional<Clock::time_point> deadline_;
  // No reply can be written before its question is known: the numbers do not follow one another.
  std::mt19937_64 sequence_{std::random_device{}()};
  std::array<std::uint8_t, 1u << 16> buffer_;

  void start() {
    if (!far_) far_ = far_process();
    socket_ = far_->start(test_);
  }

  void hang_up() {
    if (socket_ >= 0) close(socket_);
    socket_ = -1;
  }

  std::pair<Reply, Bytes> receive(const Contract& contract, std::uint64_t sequence) {
    std::size_t have = 0;
    small_pieces_ = 0;
    while (have < sizeof(Header)) have += receive_some(have);
    Header reply;
    std::memcpy(&reply, buffer_.data(), sizeof reply);
    if (reply.magic != kMagic || reply.fingerprint != contract.fingerprint ||
        reply.kind >= static_cast<std::uint32_t>(Reply::refused))
      stop_because("sent back bytes that are not a reply");
    if (reply.sequence != sequence) stop_because(std::string{kUnasked});
    if (reply.length > allowed_.bytes) stop_because("sent back more than is allowed");

    // Memory is taken as bytes arrive, not as they are announced.
    Bytes payload;
    have -= sizeof reply;
    const std::uint8_t* from = buffer_.data() + sizeof reply;
    while (true) {
      if (have > reply.length - payload.size()) stop_because(std::string{kUnasked});
      payload.insert(payload.end(), from, from + have);
      if (payload.size() == reply.length) break;
      have = receive_some(0);
      from = buffer_.data();
    }
    return {static_cast<Reply>(reply.kind), std::move(payload)};
  }

  void send_all(const Bytes& bytes) {
    for (std::size_t at = 0; at < bytes.size();) {
      wait_for(POLLOUT);
      const ssize_t n = send(socket_, bytes.data() + at, bytes.size() - at,
                             MSG_NOSIGNAL | (deadline_ ? MSG_DONTWAIT : 0));
      if (n > 0) {
        at += static_cast<std::size_t>(n);
      } else if (errno != EAGAIN && errno != EINTR) {
        stop_because(why_it_ended());
      }
    }
  }

  // At least one more byte into the buffer, behind those that are kept.
  std::size_t receive_some(std::size_t kept) {
    while (true) {
      wait_for(POLLIN);
      const ssize_t n =
          recv(socket_, buffer_.data() + kept, buffer_.size() - kept, deadline_ ? MSG_DONTWAIT : 0);
      if (n > 0) {
        const auto size = static_cast<std::size_t>(n);
        if (size < kSmallPiece && ++small_pieces_ > kMaxSmallPieces)
          stop_because("sent its answer in too many small pieces");
        return size;
      }
      if (n == 0 || (errno != EAGAIN && errno != EINTR)) stop_because(why_it_ended());
    }
  }

  // If no other process ends a silent far side, the time limit does.
  void wait_for(short events) {
    if (!deadline_) return;
    const auto left =
        std::chrono::ceil<std::chrono::milliseconds>(*deadline_ - Clock::now()).count();
    pollfd poll_for{socket_, events, 0};
    if (left <= 0 ||
        poll(&poll_for, 1, static_cast<int>(std::min<std::int64_t>(left, 1 << 30))) == 0) {
      stop_because("ran out of time: no answer after " + std::to_string(far_->patience()) + " s");
    }
  }

  std::string why_it_ended() {
    hang_up();
    return far_->why_it_ended();
  }
};

Conversation& conversation() {
  static Conversation only;
  return only;
}

const bool kNewTest = [] {
  host::at_test_start([] { conversation().new_test(); });
  return true;
}();

std::string text_in(const Bytes& bytes) {
  try {
    std::string text = from_bytes<std::string>(bytes);
    if (text.size() > kMaxWords) text = text.substr(0, kMaxWords) + " ...";
    return text;
  } catch (const BadBytes&) {
    stop_because("sent back an exception without its text");
  }
}

}  // namespace

void stop_because(const std::string& reason) {
  conversation().stop();
  throw host::Stopped(reason);
}

Bytes exchange(const Contract& contract, std::uint32_t function, const Bytes& arguments) {
  auto [reply, payload] = conversation().ask(contract, function, arguments);
  switch (reply) {
    case Reply::value:
      return std::move(payload);
    case Reply::not_attempted:
      todo();
    case Reply::invalid_argument:
      throw std::invalid_argument(text_in(payload));
    case Reply::exception:
      throw std::runtime_error(text_in(payload));
    case Reply::out_of_memory:
      throw std::bad_alloc();
    case Reply::not_an_exception:
      throw 0;
    case Reply::refused:
      break;
  }
  stop_because("refused the call");
}

}  // namespace contact::remote
