#include <contact/remote.hpp>

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>

#include <contact/prelude.hpp>
#include <contact/remote_frames.hpp>

extern char** environ;

namespace contact::remote {
namespace {

using Clock = std::chrono::steady_clock;

std::vector<std::string> server_command() {
  const char* text = std::getenv("CONTACT_SERVER");
  if (text == nullptr || *text == '\0')
    throw host::Stopped("CONTACT_SERVER names no program to ask");
  if (*text != '[') return {text};
  return nlohmann::json::parse(text).get<std::vector<std::string>>();
}

std::chrono::duration<double> patience() {
  const char* text = std::getenv("CONTACT_CALL_SECONDS");
  return std::chrono::duration<double>(text != nullptr ? std::strtod(text, nullptr) : 10.0);
}

/// One process with the student's code in it, and our end of the socket to it.
class Server {
 public:
  Server() = default;
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;
  ~Server() { stop(); }

  bool running() const { return pid_ > 0; }

  void start() {
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) {
      throw host::Stopped(std::string{"no socket: "} + std::strerror(errno));
    }
    const std::vector<std::string> command = server_command();
    std::vector<char*> arguments;
    for (const auto& argument : command) arguments.push_back(const_cast<char*>(argument.c_str()));
    arguments.push_back(nullptr);

    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, ends[1], kServerDescriptor);
    const int error =
        posix_spawnp(&pid_, arguments[0], &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    close(ends[1]);
    socket_ = ends[0];
    sequence_ = 0;
    if (error != 0) {
      pid_ = -1;
      stop();
      throw host::Stopped("cannot run " + command[0] + ": " + std::strerror(error));
    }
  }

  /// Ends the process, whatever it is doing.
  void stop() {
    if (pid_ > 0) {
      kill(pid_, SIGKILL);
      while (waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
      }
    }
    if (socket_ >= 0) close(socket_);
    pid_ = -1;
    socket_ = -1;
  }

  std::pair<Reply, Bytes> ask(const Contract& contract, std::uint32_t function,
                              const Bytes& arguments) {
    const auto deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(patience());
    std::uint8_t byte = 0;
    if (recv(socket_, &byte, 1, MSG_DONTWAIT | MSG_PEEK) > 0)
      stop_because("sent bytes that nobody asked for");

    Header header;
    header.kind = function;
    header.fingerprint = contract.fingerprint;
    header.sequence = ++sequence_;
    header.length = arguments.size();
    Bytes request(sizeof header);
    std::memcpy(request.data(), &header, sizeof header);
    request.insert(request.end(), arguments.begin(), arguments.end());
    send_all(request, deadline);

    Header reply;
    receive_all(reinterpret_cast<std::uint8_t*>(&reply), sizeof reply, deadline);
    if (reply.magic != kMagic || reply.fingerprint != contract.fingerprint ||
        reply.sequence != sequence_ || reply.kind >= static_cast<std::uint32_t>(Reply::refused)) {
      stop_because("sent back bytes that are not a reply");
    }
    if (reply.length > kMaxPayload) stop_because("sent back more than is allowed");
    Bytes payload(reply.length);
    receive_all(payload.data(), payload.size(), deadline);
    return {static_cast<Reply>(reply.kind), std::move(payload)};
  }

 private:
  pid_t pid_ = -1;
  int socket_ = -1;
  std::uint64_t sequence_ = 0;

  void send_all(const Bytes& bytes, Clock::time_point deadline) {
    for (std::size_t at = 0; at < bytes.size();) {
      const ssize_t n =
          send(socket_, bytes.data() + at, bytes.size() - at, MSG_NOSIGNAL | MSG_DONTWAIT);
      if (n > 0) {
        at += static_cast<std::size_t>(n);
      } else if (errno == EAGAIN || errno == EINTR) {
        wait_for(POLLOUT, deadline);
      } else {
        stop_because(how_it_ended());
      }
    }
  }

  void receive_all(std::uint8_t* bytes, std::size_t size, Clock::time_point deadline) {
    for (std::size_t at = 0; at < size;) {
      wait_for(POLLIN, deadline);
      const ssize_t n = recv(socket_, bytes + at, size - at, MSG_DONTWAIT);
      if (n > 0) {
        at += static_cast<std::size_t>(n);
      } else if (n == 0 || (errno != EAGAIN && errno != EINTR)) {
        stop_because(how_it_ended());
      }
    }
  }

  void wait_for(short events, Clock::time_point deadline) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
    pollfd poll_for{socket_, events, 0};
    if (left <= 0 ||
        poll(&poll_for, 1, static_cast<int>(std::min<std::int64_t>(left, 1 << 30))) == 0) {
      stop_because("ran out of time: no answer after " + std::to_string(patience().count()) + " s");
    }
  }

  /// The other end is closed. Normally the process has ended, or is about to.
  std::string how_it_ended() {
    int status = 0;
    for (int tries = 0; tries < 100; ++tries) {
      const pid_t ended = waitpid(pid_, &status, WNOHANG);
      if (ended == pid_) {
        pid_ = -1;
        if (WIFSIGNALED(status)) return std::string{"crashed: "} + strsignal(WTERMSIG(status));
        return "ended the program with status " + std::to_string(WEXITSTATUS(status));
      }
      usleep(5000);
    }
    return "closed its connection";
  }
};

Server& server() {
  static Server only;
  return only;
}

// A test must not see what an earlier one left behind.
const bool kRestart = [] {
  host::at_test_start([] { server().stop(); });
  return true;
}();

std::string text_in(const Bytes& bytes) {
  try {
    return from_bytes<std::string>(bytes);
  } catch (const BadBytes&) {
    stop_because("sent back an exception without its text");
  }
}

}  // namespace

void stop_because(const std::string& reason) {
  server().stop();
  throw host::Stopped(reason);
}

Bytes exchange(const Contract& contract, std::uint32_t function, const Bytes& arguments) {
  if (!server().running()) server().start();
  auto [reply, payload] = server().ask(contract, function, arguments);
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
