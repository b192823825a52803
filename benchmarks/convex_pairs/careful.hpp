/// @file
/// Asks other programs about pairs that may end them: an assertion, a fault or an endless loop must
/// not end the comparison.
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
inline constexpr std::size_t max_ended = 10;

/// The pairs of which a program can be asked. It is asked of one after the other in a process of
/// its own; where that ends, another begins after the pair. After `max_ended` of them it is asked
/// no more, and none of the rest counts as answered.
/// @param prepare as in PairTest
template <class Answer>
std::vector<char> answered(
    const std::function<std::function<void(std::vector<Answer>&)>(const peers::Pairs&)>& prepare,
    const peers::Pairs& pairs) {
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
        std::vector<Answer> answer(1);
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

/// The pairs with those that end the program replaced by one that does not; tells how many. Nothing
/// is left if too many end it.
inline peers::Pairs without(const std::vector<char>& fine, const peers::Pairs& pairs,
                            const std::string& title) {
  const auto ended = static_cast<std::size_t>(std::count(fine.begin(), fine.end(), 0));
  if (ended == 0) return pairs;
  const bool too_many = ended >= std::min(max_ended, fine.size());
  std::printf("%s: %s%zu pairs end the program or take %d ms, and %s left out\n", title.c_str(),
              too_many ? "at least " : "", too_many ? std::min(max_ended, ended) : ended,
              patience_in_milliseconds, too_many ? "it is" : "these are");
  if (too_many) return {};
  peers::Pairs made = pairs;
  const auto kept = std::find(fine.begin(), fine.end(), 1) - fine.begin();
  for (std::size_t i = 0; i < fine.size(); ++i) {
    if (fine[i] == 0) made[i] = pairs[static_cast<std::size_t>(kept)];
  }
  return made;
}

}  // namespace careful
