/// @file
/// Asks other programs about pairs that may end them: an assertion, a fault or an endless loop must
/// not end the comparison.
#pragma once

#include <sys/mman.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstddef>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "../comparison.hpp"
#include "peers.hpp"

namespace careful {

/// The pairs of which a program can be asked. It is asked of one after the other in a process of
/// its own; where that ends, another begins after the pair.
/// @param prepare as in PairTest
template <class Answer>
std::vector<char> answered(
    const std::function<std::function<void(std::vector<Answer>&)>(const peers::Pairs&)>& prepare,
    const peers::Pairs& pairs) {
  std::vector<char> fine(pairs.size(), 1);
  auto* next = static_cast<std::size_t*>(mmap(nullptr, sizeof(std::size_t), PROT_READ | PROT_WRITE,
                                              MAP_SHARED | MAP_ANONYMOUS, -1, 0));
  *next = 0;
  while (*next < pairs.size()) {
    std::fflush(nullptr);
    const pid_t child = fork();
    if (child == 0) {
      if (std::freopen("/dev/null", "w", stderr) == nullptr) comparison::leave(1);
      for (; *next < pairs.size(); ++*next) {
        const itimerval limit{{0, 0}, {5, 0}};
        setitimer(ITIMER_PROF, &limit, nullptr);  // of processor time, then it is ended
        std::vector<Answer> answer(1);
        prepare({pairs[*next]})(answer);
      }
      comparison::leave(0);
    }
    int status = 1;
    waitpid(child, &status, 0);
    if (*next < pairs.size()) fine[(*next)++] = 0;
  }
  munmap(next, sizeof(std::size_t));
  return fine;
}

/// The pairs with those that end the program replaced by one that does not; tells how many. Nothing
/// is left if all end it.
inline peers::Pairs without(const std::vector<char>& fine, const peers::Pairs& pairs,
                            const std::string& title) {
  std::size_t kept = 0;
  peers::Pairs made = pairs;
  while (kept < fine.size() && fine[kept] == 0) ++kept;
  if (kept == fine.size()) made.clear();
  std::size_t ended = 0;
  for (std::size_t i = 0; i < fine.size(); ++i) {
    if (fine[i] != 0) continue;
    ++ended;
    if (!made.empty()) made[i] = pairs[kept];
  }
  if (ended > 0) {
    std::printf("%s: %zu pairs end the program or take 5 s, and are left out\n", title.c_str(),
                ended);
  }
  return made;
}

}  // namespace careful
