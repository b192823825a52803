// explain_fuzz: asks contact-explain's library random questions and checks the properties that
// every answer must have. Each question has 2 s of processor time and 64 MB; a question that fails
// is written to a file, which `explain_fuzz --case FILE` asks again.
//
//   explain_fuzz --from N --runs N [--failures FOLDER]
//   explain_fuzz --case FILE...

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <new>
#include <string>
#include <string_view>

#include <malloc.h>
#include <sys/time.h>
#include <unistd.h>

#include "claims_hold.hpp"
#include "fuzz_cases.hpp"

namespace {

using contact::grading::ExplainRequest;

constexpr long max_seconds = 2;
constexpr std::size_t max_live = std::size_t{64} << 20;

std::size_t live = 0;
std::size_t limit = ~std::size_t{0};

/// The current question, to be printed if it takes too long.
std::string asked_now;
std::string failures = ".";

[[noreturn]] void give_up(std::string_view why) {
  limit = ~std::size_t{0};
  const std::string file =
      (std::filesystem::path(failures) / ("explain_fuzz." + std::to_string(::getpid()) + ".case"))
          .string();
  std::ofstream(file, std::ios::binary) << asked_now;
  std::fprintf(stderr, "%.*s\nthe question: %s\n", static_cast<int>(why.size()), why.data(),
               file.c_str());
  std::_Exit(1);
}

void too_long(int) { give_up("the answer took more than 2 s of processor time"); }

void set_clock(long seconds) {
  const itimerval value{{0, 0}, {seconds, 0}};
  ::setitimer(ITIMER_VIRTUAL, &value, nullptr);
}

std::string answer(const ExplainRequest& asked) {
  limit = live + max_live;
  std::string told = contact::grading::explain(asked);
  limit = ~std::size_t{0};
  return told;
}

void ask(const ExplainRequest& asked) {
  asked_now = to_bytes(asked);
  if (to_bytes(contact::grading::request_from(asked_now)) != asked_now)
    give_up("the question is another one when it is read again");
  set_clock(max_seconds);
  try {
    const std::string wrong = contact::testing::what_is_wrong(asked, answer(asked));
    if (!wrong.empty()) give_up(wrong);
  } catch (const std::exception& error) {
    give_up(std::string("an exception: ") + error.what());
  }
  set_clock(0);
}

std::string read(const char* file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace

void* operator new(std::size_t size) {
  void* const block = std::malloc(size);
  if (block == nullptr) throw std::bad_alloc();
  live += ::malloc_usable_size(block);
  if (live > limit) give_up("the answer took more than 64 MB");
  return block;
}
void operator delete(void* block) noexcept {
  live -= ::malloc_usable_size(block);
  std::free(block);
}
void operator delete(void* block, std::size_t) noexcept { operator delete(block); }

int main(int count, char** words) {
  std::signal(SIGVTALRM, too_long);
  std::uint64_t from = 0;
  std::uint64_t runs = 0;
  for (int i = 1; i + 1 < count; ++i) {
    const std::string_view word = words[i];
    if (word == "--from") from = std::strtoull(words[++i], nullptr, 10);
    if (word == "--runs") runs = std::strtoull(words[++i], nullptr, 10);
    if (word == "--failures") failures = words[++i];
    if (word != "--case") continue;
    for (++i; i < count; ++i) ask(contact::grading::request_from(read(words[i])));
  }
  const std::vector<contact::testing::Seed> seeds =
      contact::testing::read_seeds(CONTACT_SOURCE_DIR);
  for (std::uint64_t number = from; number < from + runs; ++number)
    ask(contact::testing::fuzzed(seeds, number));
  std::printf("%llu questions answered\n", static_cast<unsigned long long>(runs));
  return 0;
}
