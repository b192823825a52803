#include <contact/remote_process.hpp>

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>
#include <vector>

#include <contact/host.hpp>
#include <contact/remote_broker.hpp>
#include <contact/remote_frames.hpp>

extern char** environ;

namespace contact::remote {
namespace {

std::vector<std::string> server_command() {
  const char* text = std::getenv("CONTACT_SERVER");
  if (text == nullptr || *text == '\0')
    throw host::Stopped("CONTACT_SERVER names no program to ask");
  if (*text != '[') return {text};
  return nlohmann::json::parse(text).get<std::vector<std::string>>();
}

/// A child of this process: for tests, in which all programs are trusted.
class Child : public FarProcess {
 public:
  ~Child() override { end(); }

  int start(std::uint64_t) override {
    end();
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
      throw host::Stopped(std::string{"no socket: "} + std::strerror(errno));
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
    if (error != 0) {
      pid_ = -1;
      close(ends[0]);
      throw host::Stopped("cannot run " + command[0] + ": " + std::strerror(error));
    }
    return ends[0];
  }

  void stop() override { end(); }

  std::string why_it_ended() override {
    int status = 0;
    // A process that is ending closes its connection first, and a busy machine may keep it there.
    for (int tries = 0; tries < 400; ++tries) {
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

  double patience() const override {
    const char* text = std::getenv("CONTACT_CALL_SECONDS");
    return text != nullptr ? std::strtod(text, nullptr) : 10.0;
  }

 private:
  pid_t pid_ = -1;

  void end() {
    if (pid_ <= 0) return;
    kill(pid_, SIGKILL);
    while (waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
    }
    pid_ = -1;
  }
};

/// A submission in a box of its own, which the broker starts, limits and ends.
class Brokered : public FarProcess {
 public:
  explicit Brokered(int socket) : socket_(socket) {}

  int start(std::uint64_t test) override {
    test_ = test;
    ask(BrokerRequest::Kind::start);
    auto [words, descriptor] = reply();
    if (descriptor < 0) throw host::Stopped(words);
    return descriptor;
  }

  std::string why_it_ended() override {
    ask(BrokerRequest::Kind::why);
    auto [words, descriptor] = reply();
    if (descriptor >= 0) close(descriptor);
    return words;
  }

  void stop() override { ask(BrokerRequest::Kind::done); }
  double patience() const override { return 0.0; }

 private:
  int socket_;
  std::uint64_t test_ = 0;

  void ask(BrokerRequest::Kind kind) {
    BrokerRequest request;
    request.kind = kind;
    request.test = test_;
    ssize_t sent = 0;
    do {
      sent = send(socket_, &request, sizeof request, MSG_NOSIGNAL);
    } while (sent < 0 && errno == EINTR);
    if (sent != static_cast<ssize_t>(sizeof request)) gone();
  }

  std::pair<std::string, int> reply() {
    std::array<char, sizeof(BrokerReply) + kMaxBrokerWords> packet;
    iovec bytes{packet.data(), packet.size()};
    alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(int))> control{};
    msghdr message{};
    message.msg_iov = &bytes;
    message.msg_iovlen = 1;
    message.msg_control = control.data();
    message.msg_controllen = control.size();
    ssize_t size = 0;
    do {
      size = recvmsg(socket_, &message, MSG_CMSG_CLOEXEC);
    } while (size < 0 && errno == EINTR);
    BrokerReply head;
    if (size < static_cast<ssize_t>(sizeof head)) gone();
    std::memcpy(&head, packet.data(), sizeof head);
    if (head.magic != kBrokerMagic) gone();
    int descriptor = -1;
    const cmsghdr* part = CMSG_FIRSTHDR(&message);
    if (part != nullptr && part->cmsg_level == SOL_SOCKET && part->cmsg_type == SCM_RIGHTS)
      std::memcpy(&descriptor, CMSG_DATA(part), sizeof descriptor);
    return {std::string(packet.data() + sizeof head, static_cast<std::size_t>(size) - sizeof head),
            descriptor};
  }

  [[noreturn]] static void gone() { throw host::Stopped("there is no process to answer"); }
};

}  // namespace

std::unique_ptr<FarProcess> far_process() {
  if (const auto broker = number_from_environment("CONTACT_BROKER", 0); broker > 0)
    return std::make_unique<Brokered>(static_cast<int>(broker));
  return std::make_unique<Child>();
}

std::uint64_t number_from_environment(const char* name, std::uint64_t otherwise) {
  const char* text = std::getenv(name);
  if (text == nullptr) return otherwise;
  const std::string_view digits(text);
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(digits.begin(), digits.end(), number);
  return error == std::errc() && end == digits.end() ? number : otherwise;
}

}  // namespace contact::remote
