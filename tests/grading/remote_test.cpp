// The near side of a call to another process, against a far side that misbehaves in every way we
// could think of.
#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <catch2/catch_session.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <thread>
#include <vector>

#include <contact/prelude.hpp>
#include <contact/remote.hpp>
#include <contact/remote_broker.hpp>
#include <contact/remote_frames.hpp>

namespace {

struct NotAttempted {};

constexpr contact::remote::Contract kContract{"specimen", 42};

/// One call whose argument comes back if all is well.
double echo(double x) { return contact::remote::call<double>(kContract, 0, x); }

// A busy machine may stop a program for a second. Only the tests of the time limit wait for it.
constexpr const char* kAmple = "60";
constexpr const char* kBrief = "0.5";

void be_served_by(const std::string& how, const char* seconds = kAmple) {
  const std::string command = std::string("[\"") + CONTACT_SPECIMEN + "\", \"" + how + "\"]";
  setenv("CONTACT_SERVER", command.c_str(), 1);
  setenv("CONTACT_CALL_SECONDS", seconds, 1);
  contact::host::test_starts();
}

std::string reason(const std::string& how, const char* seconds = kAmple) {
  be_served_by(how, seconds);
  try {
    echo(1.5);
    echo(2.5);
  } catch (const contact::host::Stopped& stopped) {
    return stopped.what();
  }
  return "no reason";
}

using contact::remote::BrokerReply;
using contact::remote::BrokerRequest;

/// A broker in this program: it starts specimens, and notes what it is asked.
class Broker {
 public:
  explicit Broker(std::string how) : how_(std::move(how)) {
    REQUIRE(socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends_.data()) == 0);
    setenv("CONTACT_BROKER", std::to_string(ends_[0]).c_str(), 1);
    thread_ = std::thread([this] { serve(); });
    contact::host::test_starts();
  }
  Broker(const Broker&) = delete;
  Broker& operator=(const Broker&) = delete;
  ~Broker() {
    contact::host::test_starts();
    leave();
    close(ends_[0]);
    unsetenv("CONTACT_BROKER");
    contact::host::test_starts();
  }

  /// Serves no longer. What it was asked can be read from now on.
  const std::vector<BrokerRequest>& leave() {
    if (thread_.joinable()) {
      shutdown(ends_[1], SHUT_RDWR);
      thread_.join();
      close(ends_[1]);
      end();
    }
    return asked_;
  }

 private:
  std::string how_;
  std::array<int, 2> ends_{};
  std::thread thread_;
  pid_t specimen_ = 0;
  std::vector<BrokerRequest> asked_;

  void serve() {
    BrokerRequest request;
    while (recv(ends_[1], &request, sizeof request, 0) == sizeof request) {
      asked_.push_back(request);
      if (request.kind == BrokerRequest::Kind::start && how_ == "refuses")
        contact::remote::send_reply(ends_[1], BrokerReply::Kind::words, "no box is free", -1);
      else if (request.kind == BrokerRequest::Kind::start)
        start();
      else if (request.kind == BrokerRequest::Kind::why)
        contact::remote::send_reply(ends_[1], BrokerReply::Kind::words,
                                    "status " + std::to_string(end()), -1);
      else
        kill(specimen_, SIGKILL);
    }
  }

  void start() {
    end();
    std::array<int, 2> ends{};
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) return;
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[1], contact::remote::kServerDescriptor);
    std::array<char*, 3> arguments{const_cast<char*>(CONTACT_SPECIMEN), how_.data(), nullptr};
    posix_spawn(&specimen_, CONTACT_SPECIMEN, &actions, nullptr, arguments.data(), nullptr);
    posix_spawn_file_actions_destroy(&actions);
    close(ends[1]);
    contact::remote::send_reply(ends_[1], BrokerReply::Kind::given, "", ends[0]);
    close(ends[0]);
  }

  int end() {
    int status = 0;
    if (specimen_ > 0) {
      if (how_ != "exits") kill(specimen_, SIGKILL);
      waitpid(specimen_, &status, 0);
    }
    specimen_ = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
};

std::string why_no_answer() {
  try {
    echo(1.5);
  } catch (const contact::host::Stopped& stopped) {
    return stopped.what();
  }
  return "no reason";
}

std::size_t open_descriptors() {
  std::size_t count = 0;
  for (int i = 0; i < 256; ++i) count += fcntl(i, F_GETFD) >= 0 ? 1 : 0;
  return count;
}

}  // namespace

namespace contact {
void todo() { throw NotAttempted{}; }
}  // namespace contact

using Catch::Matchers::Equals;
using Catch::Matchers::StartsWith;

TEST_CASE("values cross exactly, call after call") {
  be_served_by("behaves");
  for (const double x : {0.1, -0.0, 5e-324, 1e308}) CHECK(echo(x) == x);
  CHECK(std::isnan(echo(std::nan(""))));
}

TEST_CASE("a process that ends is reported with its reason") {
  CHECK_THAT(reason("crashes"), StartsWith("crashed: "));
  CHECK(reason("exits") == "ended the program with status 3");
  CHECK_THAT(reason("leaves at once"), StartsWith("ended the program with status 0"));
  CHECK(reason("half an answer") == "ended the program with status 0");
  CHECK(reason("closes") == "closed its connection");
}

TEST_CASE("a process that does not answer is stopped in time") {
  // It would answer after a minute.
  CHECK_THAT(reason("sleeps", kBrief), StartsWith("ran out of time"));
}

TEST_CASE("bytes that are no answer fail the call") {
  for (const char* how : {"another contract", "another magic", "unknown kind"})
    CHECK(reason(how) == "sent back bytes that are not a reply");
  CHECK(reason("another sequence") == "sent unrequested bytes");
  CHECK(reason("huge") == "sent back more than is allowed");
  CHECK_THAT(reason("too few bytes"), StartsWith("sent back something that is not a value"));
  CHECK_THAT(reason("too many bytes"), StartsWith("sent back something that is not a value"));
  // Bytes that nobody asked for are found before the next question or, where they come later, in
  // place of its reply.
  for (const char* how : {"speaks again", "speaks first"})
    CHECK_THAT(reason(how),
               Equals("sent unrequested bytes") || Equals("sent back bytes that are not a reply"));
}

TEST_CASE("a reply made before its question is no answer, whatever it says") {
  CHECK(reason("replies first") == "sent unrequested bytes");
  CHECK(reason("replies ahead") == "sent unrequested bytes");
  CHECK(reason("more in one piece") == "sent unrequested bytes");
}

TEST_CASE("an answer may come in pieces, but not without end") {
  be_served_by("in pieces");
  CHECK(echo(2.5) == 2.5);
  CHECK(echo(3.5) == 3.5);
  CHECK_THAT(reason("dribbles slowly", kBrief), StartsWith("ran out of time"));
  CHECK(reason("dribbles") == "sent its answer in too many small pieces");
}

TEST_CASE("what comes back and how often is asked has limits") {
  setenv("CONTACT_ANSWER_BYTES", "100", 1);
  CHECK(reason("large") == "sent back more than is allowed");
  unsetenv("CONTACT_ANSWER_BYTES");
  CHECK_THAT(reason("large"), StartsWith("sent back something that is not a value"));
  setenv("CONTACT_CALLS", "2", 1);
  be_served_by("behaves");
  CHECK(echo(1) == 1);
  CHECK(echo(2) == 2);
  CHECK(why_no_answer() == "was called more than 2 times in one test");
  contact::host::test_starts();
  CHECK(echo(3) == 3);
  unsetenv("CONTACT_CALLS");
}

#ifndef __SANITIZE_ADDRESS__  // which takes address space of its own
TEST_CASE("a length takes memory only as its bytes arrive") {
  // 64 MB are announced, and never come: 32 MB more than this process has are enough.
  be_served_by("announces 64 MB");
  rlimit before{};
  getrlimit(RLIMIT_AS, &before);
  std::FILE* file = std::fopen("/proc/self/statm", "r");
  REQUIRE(file != nullptr);
  unsigned long pages = 0;
  REQUIRE(std::fscanf(file, "%lu", &pages) == 1);
  std::fclose(file);
  rlimit tight = before;
  tight.rlim_cur = pages * static_cast<unsigned long>(sysconf(_SC_PAGESIZE)) + (32u << 20);
  REQUIRE(setrlimit(RLIMIT_AS, &tight) == 0);
  const std::string why = why_no_answer();
  setrlimit(RLIMIT_AS, &before);
  CHECK(why == "ended the program with status 0");
}
#endif

TEST_CASE("the text of an exception is cut") {
  be_served_by("throws at length");
  try {
    echo(1);
    FAIL("it threw nothing");
  } catch (const std::invalid_argument& error) {
    CHECK(std::strlen(error.what()) < 3000);
  }
}

TEST_CASE("a broker gives a process for each test and reports why one ended") {
  {
    Broker broker("behaves");
    CHECK(echo(1.5) == 1.5);
    CHECK(echo(2.5) == 2.5);
    contact::host::test_starts();
    CHECK(echo(3.5) == 3.5);
    contact::host::test_starts();
    const std::vector<BrokerRequest>& asked = broker.leave();
    REQUIRE(asked.size() == 4);
    using Kind = BrokerRequest::Kind;
    CHECK(asked[0].kind == Kind::start);
    CHECK(asked[1].kind == Kind::done);
    CHECK(asked[2].kind == Kind::start);
    CHECK(asked[3].kind == Kind::done);
    CHECK(asked[1].test == asked[0].test);
    CHECK(asked[2].test == asked[0].test + 1);
  }
  {
    Broker broker("exits");
    CHECK(why_no_answer() == "status 3");
  }
  Broker broker("refuses");
  CHECK(why_no_answer() == "no box is free");
}

TEST_CASE("with a broker the judge has no clock of its own") {
  setenv("CONTACT_CALL_SECONDS", "0.01", 1);
  Broker broker("thinks");
  CHECK(echo(1.5) == 1.5);
}

TEST_CASE("with a broker, too, bytes that are no answer fail the call") {
  for (const char* how : {"replies first", "more in one piece", "another sequence"}) {
    Broker broker(how);
    CHECK(why_no_answer() == "sent unrequested bytes");
  }
}

TEST_CASE("a broker that is gone is reported, and no descriptor remains open") {
  const std::size_t before = open_descriptors();
  {
    Broker broker("behaves");
    for (int i = 0; i < 20; ++i) {
      CHECK(echo(i) == i);
      contact::host::test_starts();
    }
    broker.leave();
    CHECK(why_no_answer() == "there is no process to answer");
  }
  CHECK(open_descriptors() == before);
}

TEST_CASE("an exception without its text is no answer either") {
  CHECK(reason("throws") == "sent back an exception without its text");
}

TEST_CASE("todo on the far side is todo on the near side") {
  be_served_by("not attempted");
  CHECK_THROWS_AS(echo(1), NotAttempted);
}

TEST_CASE("a program that cannot be run is reported") {
  setenv("CONTACT_SERVER", "/nowhere/at/all", 1);
  contact::host::test_starts();
  CHECK_THROWS_AS(echo(1), contact::host::Stopped);
  unsetenv("CONTACT_SERVER");
  contact::host::test_starts();
  CHECK_THROWS_AS(echo(1), contact::host::Stopped);
}

TEST_CASE("after a failure the next test gets a new process") {
  be_served_by("exits");
  CHECK_THROWS_AS(echo(1), contact::host::Stopped);
  be_served_by("behaves");
  CHECK(echo(7) == 7);
}

int main(int argc, char* argv[]) { return Catch::Session().run(argc, argv); }
