/// @file
/// Asks other programs about pairs that may end them: a failed assertion, a fault or an endless
/// loop must not end the comparison.
#pragma once

#include <sys/mman.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "../comparison.hpp"
#include "peers.hpp"

namespace careful {

/// Of processor time, for one pair.
inline constexpr int patience_in_milliseconds = 300;
inline constexpr std::size_t max_ended = 30;

template <class Pairs>
using Prepare = std::function<std::function<void(peers::Answers&)>(const Pairs&)>;

/// The pairs of which a program can be asked. It is asked of one after the other in a process of
/// its own; where that ends, another begins after the pair, up to `max_ended` times.
template <class Pairs>
std::vector<char> answered(const Prepare<Pairs>& prepare, const Pairs& pairs) {
  std::vector<char> fine(pairs.size(), 1);
  auto* next = static_cast<std::size_t*>(mmap(nullptr, sizeof(std::size_t), PROT_READ | PROT_WRITE,
                                              MAP_SHARED | MAP_ANONYMOUS, -1, 0));
  *next = 0;
  std::size_t ended = 0;
  while (*next < pairs.size() && ended < max_ended) {
    std::fflush(nullptr);
    const pid_t child = fork();
    if (child == 0) {
      if (std::freopen("/dev/null", "w", stderr) == nullptr) comparison::leave(1);
      for (; *next < pairs.size(); ++*next) {
        const itimerval limit{{0, 0}, {0, 1000 * patience_in_milliseconds}};
        setitimer(ITIMER_PROF, &limit, nullptr);  // of processor time, then it is ended
        peers::Answers answer(1);
        prepare({pairs[*next]})(answer);
      }
      comparison::leave(0);
    }
    int status = 1;
    waitpid(child, &status, 0);
    if (*next < pairs.size()) {
      ++ended;
      fine[(*next)++] = 0;
    }
  }
  for (std::size_t i = *next; i < pairs.size(); ++i) fine[i] = 0;
  munmap(next, sizeof(std::size_t));
  return fine;
}

/// A method that does not ask of pairs that end the program, and says that it does not know them.
/// It is told how many they are.
template <class Pairs>
comparison::Method<peers::Answers> method(const std::string& name, const Prepare<Pairs>& prepare,
                                          const Pairs& pairs, const std::string& title) {
  const std::vector<char> fine = answered(prepare, pairs);
  Pairs asked;
  for (std::size_t i = 0; i < fine.size(); ++i) {
    if (fine[i] != 0) asked.push_back(pairs[i]);
  }
  if (asked.size() < pairs.size()) {
    std::printf("%s: %zu pairs of %s end the program or take %d ms\n", name.c_str(),
                pairs.size() - asked.size(), title.c_str(), patience_in_milliseconds);
  }
  const auto ask = prepare(asked);
  return {name, [ask, fine, count = asked.size()](peers::Answers& answers) {
            peers::Answers got(count);
            ask(got);
            std::size_t next = 0;
            for (std::size_t i = 0; i < fine.size(); ++i)
              answers[i] = fine[i] != 0 ? got[next++] : peers::Answer{false, 0, true};
          }};
}

}  // namespace careful
