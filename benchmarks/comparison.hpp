/// @file
/// The tables of the comparisons: what each way to answer takes, as a share of the book's, and how
/// often it is wrong.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace comparison {

/// Nanoseconds of this process.
inline double processor_time() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e9 + static_cast<double>(now.tv_nsec);
}

/// One way to answer.
template <class Answer>
struct Method {
  std::string name;
  std::function<void(Answer&)> ask;
};
/// How many of its answers are wrong in one respect, with a title.
template <class Answer>
struct Fault {
  const char* title;
  std::function<std::size_t(const Answer&)> count;
};

struct Spread {
  double median, least, most;
};
inline Spread spread(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return {values[values.size() / 2], values.front(), values.back()};
}

/// A line of a table.
struct Row {
  std::string name;
  Spread time, share;                ///< of the unit, and what the book takes of it
  std::vector<std::size_t> counted;  ///< of each fault
};

/// The first method is the book's; each time of it is divided by the others' of the same run.
/// @param per nanoseconds that count as one unit
/// @param answer as it is before the first question
/// @param patience a method that takes more nanoseconds is timed only once
template <class Answer>
std::vector<Row> compare(const std::string& title, const char* unit, double per,
                         const std::vector<Method<Answer>>& methods,
                         const std::vector<Fault<Answer>>& faults, int runs, Answer answer = {},
                         double patience = std::numeric_limits<double>::infinity()) {
  std::vector<std::vector<double>> times(methods.size()), shares(methods.size());
  std::vector<std::vector<std::size_t>> counted(methods.size());
  for (int run = 0; run <= runs; ++run) {
    double book = 0;
    for (std::size_t m = 0; m < methods.size(); ++m) {
      if (run > 1 && m > 0 && times[m].front() * per > patience) continue;
      const double start = processor_time();
      methods[m].ask(answer);
      const double elapsed = (processor_time() - start) / per;
      if (m == 0) book = elapsed;
      if (run > 0) {
        times[m].push_back(elapsed);
        shares[m].push_back(book / elapsed);
      } else {  // the first one warms up
        for (const auto& fault : faults) counted[m].push_back(fault.count(answer));
      }
    }
  }
  std::printf("%s\n  %-34s %9s %19s %11s %15s", title.c_str(), "", unit, "least - most",
              "book / this", "least - most");
  for (const auto& fault : faults) std::printf(" %9s", fault.title);
  std::printf("\n");
  std::vector<Row> rows;
  for (std::size_t m = 0; m < methods.size(); ++m) {
    const Spread time = spread(times[m]), share = spread(shares[m]);
    rows.push_back({methods[m].name, time, share, counted[m]});
    std::printf("  %-34s %9.1f %8.1f - %8.1f %11.3f %6.3f - %6.3f", methods[m].name.c_str(),
                time.median, time.least, time.most, share.median, share.least, share.most);
    for (const std::size_t wrong : counted[m]) std::printf(" %9zu", wrong);
    std::printf("\n");
  }
  std::printf("\n");
  std::fflush(stdout);
  return rows;
}

/// A positive whole number from the arguments.
inline std::size_t number(int argc, char** argv, int at, std::size_t otherwise) {
  return argc > at ? static_cast<std::size_t>(std::max(1L, std::atol(argv[at]))) : otherwise;
}

/// Ends the program at once: FCL and Coal bring a library in two versions, which free the same
/// memory when they are unloaded.
[[noreturn]] inline void leave(int code) {
  std::fflush(nullptr);
  std::_Exit(code);
}

}  // namespace comparison
