// The near side of a call to another process, against a far side that misbehaves in every way we
// could think of.
#include <algorithm>
#include <catch2/catch_session.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <chrono>
#include <cstdio>
#include <cstdlib>

#include <contact/prelude.hpp>
#include <contact/remote.hpp>

namespace {

struct NotAttempted {};

constexpr contact::remote::Contract kContract{"specimen", 42};

/// One call whose argument comes back if all is well.
double echo(double x) { return contact::remote::call<double>(kContract, 0, x); }

void be_served_by(const std::string& how) {
  const std::string command = std::string("[\"") + CONTACT_SPECIMEN + "\", \"" + how + "\"]";
  setenv("CONTACT_SERVER", command.c_str(), 1);
  setenv("CONTACT_CALL_SECONDS", "0.5", 1);
  contact::host::test_starts();
}

std::string reason(const std::string& how) {
  be_served_by(how);
  try {
    echo(1.5);
    if (how == "speaks again") usleep(20000);
    echo(2.5);
  } catch (const contact::host::Stopped& stopped) {
    return stopped.what();
  }
  return "no reason";
}

}  // namespace

namespace contact {
void todo() { throw NotAttempted{}; }
}  // namespace contact

using Catch::Matchers::StartsWith;

TEST_CASE("values cross exactly, call after call") {
  be_served_by("behaves");
  for (const double x : {0.1, -0.0, 5e-324, 1e308}) CHECK(echo(x) == x);
  CHECK(std::isnan(echo(std::nan(""))));
}

TEST_CASE("a process that ends is told with its reason") {
  CHECK_THAT(reason("crashes"), StartsWith("crashed: "));
  CHECK(reason("exits") == "ended the program with status 3");
  CHECK_THAT(reason("leaves at once"), StartsWith("ended the program with status 0"));
  CHECK(reason("half an answer") == "ended the program with status 0");
  CHECK(reason("closes") == "closed its connection");
}

TEST_CASE("a process that does not answer is stopped in time") {
  const auto start = std::chrono::steady_clock::now();
  CHECK_THAT(reason("sleeps"), StartsWith("ran out of time"));
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(5));
}

TEST_CASE("bytes that are no answer fail the call") {
  for (const char* how : {"another contract", "another magic", "unknown kind"})
    CHECK(reason(how) == "sent back bytes that are not a reply");
  CHECK(reason("another sequence") == "sent bytes that nobody asked for");
  CHECK(reason("huge") == "sent back more than is allowed");
  CHECK_THAT(reason("too few bytes"), StartsWith("sent back something that is not a value"));
  CHECK_THAT(reason("too many bytes"), StartsWith("sent back something that is not a value"));
  CHECK(reason("speaks again") == "sent bytes that nobody asked for");
  CHECK_THAT(reason("speaks first"), StartsWith("sent b"));
}

TEST_CASE("an exception without its text is no answer either") {
  CHECK(reason("throws") == "sent back an exception without its text");
}

TEST_CASE("todo on the far side is todo on the near side") {
  be_served_by("not attempted");
  CHECK_THROWS_AS(echo(1), NotAttempted);
}

TEST_CASE("a program that cannot be run is told") {
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

TEST_CASE("a call takes microseconds") {
  be_served_by("behaves");
  std::vector<double> times;
  for (int i = 0; i < 2001; ++i) {
    const auto start = std::chrono::steady_clock::now();
    echo(i);
    times.push_back(
        std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start)
            .count());
  }
  std::sort(times.begin(), times.end());
  std::printf("a call across the proxy: median %.1f us, quartiles %.1f and %.1f, of %zu\n",
              times[1000], times[500], times[1500], times.size());
  CHECK(times[1000] < 1000);
}

int main(int argc, char* argv[]) { return Catch::Session().run(argc, argv); }
