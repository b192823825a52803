/// @file
/// A ladder in the page: what its module exports, as ladder.hpp says.
#pragma once

#include <support/ladder_experiment.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace ladder {

/// Text between quotes; ids and titles need no other escapes.
inline std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + "\"";
}

/// What there is to run, as JSON.
inline std::string layout(const Experiment& experiment) {
  std::string text = "{\"question\":" + quoted(experiment.question()) + ",\"families\":[";
  for (const Family& family : experiment.families()) {
    if (text.back() == '}') text += ",";
    text += "{\"id\":" + quoted(family.id) + ",\"title\":" + quoted(family.title) +
            ",\"part\":" + quoted(family.part) + "}";
  }
  text += "],\"methods\":[";
  for (const Method& method : experiment.methods()) {
    if (text.back() == '}') text += ",";
    text += "{\"id\":" + quoted(method.id) + ",\"title\":" + quoted(method.title) +
            ",\"scalar\":" + quoted(method.scalar) +
            ",\"exact\":" + (method.exact ? "true" : "false") + ",\"part\":" + quoted(method.part) +
            "}";
  }
  text += "],\"peers\":[";
  for (const Peer& peer : experiment.peers()) {
    if (text.back() == '}') text += ",";
    text += "{\"id\":" + quoted(peer.id) + ",\"title\":" + quoted(peer.title) +
            ",\"scalar\":" + quoted(peer.scalar) + ",\"asks\":" + std::to_string(peer.asks) +
            ",\"tells\":" + std::to_string(peer.tells) + ",\"part\":" + quoted(peer.part) + "}";
  }
  return text + "]}";
}

/// The timed passes of one method in the page, after one that warms up: enough for a median, few
/// enough to wait for.
inline constexpr int passes_in_page = 7;

/// One method on the prepared family: the nine numbers of `run`.
template <class Now>
void run_in_page(Experiment& experiment, std::size_t method, const Now& now_in_ms, double* to) {
  experiment.pass(method);
  const Judgement judged = experiment.judge();
  std::vector<double> ns;
  // A browser's clock is coarse: a pass that it cannot resolve is repeated until it can.
  constexpr double long_enough = 4;
  for (int i = 0; i < passes_in_page; ++i) {
    const double start = now_in_ms();
    double elapsed = 0;
    int rounds = 0;
    while (elapsed < long_enough) {
      experiment.pass(method);
      ++rounds;
      elapsed = now_in_ms() - start;
    }
    ns.push_back(elapsed * 1e6 / (rounds * static_cast<double>(judged.n)));
  }
  const Spread times = spread(std::move(ns));
  for (const double value :
       {static_cast<double>(judged.n), static_cast<double>(judged.wrong),
        static_cast<double>(judged.undecided), judged.error_median, judged.error_max, times.median,
        times.q1, times.q3, double{passes_in_page}}) {
    *to++ = value;
  }
}

/// The numbers that go to a peer in the page, and those that come back.
class Exchange {
 public:
  /// The address of how many numbers a peer is given before all questions, and of these numbers.
  const double* given(const Experiment& experiment, std::size_t peer) {
    numbers_ = experiment.given(peer);
    numbers_.insert(numbers_.begin(), static_cast<double>(numbers_.size()));
    return numbers_.data();
  }

  /// The address of the questions of the prepared inputs.
  const double* questions(const Experiment& experiment, std::size_t peer) {
    numbers_ = experiment.questions(peer);
    return numbers_.data();
  }

  /// The address of room for the answers to them.
  double* answers(const Experiment& experiment, std::size_t peer) {
    const Peer& about = experiment.peers()[peer];
    numbers_.assign(experiment.questions(peer).size() / about.asks * about.tells, std::nan(""));
    return numbers_.data();
  }

  /// The address of n, wrong, undecided, error_median and error_max of what was written there.
  const double* judge(Experiment& experiment, std::size_t peer) {
    experiment.take(peer, numbers_);
    const Judgement judged = experiment.judge();
    row_ = {static_cast<double>(judged.n), static_cast<double>(judged.wrong),
            static_cast<double>(judged.undecided), judged.error_median, judged.error_max};
    return row_.data();
  }

 private:
  std::vector<double> numbers_;
  std::array<double, 5> row_{};
};

}  // namespace ladder

#if defined(__wasm__)
#define LADDER_EXPORT(name) [[gnu::used]] __attribute__((export_name(name)))
/// Makes the module's exports from a function that returns a ladder.
#define LADDER(make)                                                                              \
  __attribute__((import_module("env"), import_name("now"))) extern "C" double ladder_now_in_ms(); \
  static auto& the_ladder() {                                                                     \
    static auto ladder = make();                                                                  \
    return ladder;                                                                                \
  }                                                                                               \
  LADDER_EXPORT("layout") const char* ladder_layout() {                                           \
    static const std::string text = ladder::layout(the_ladder());                                 \
    return text.c_str();                                                                          \
  }                                                                                               \
  LADDER_EXPORT("prepare") void ladder_prepare(int family, int n) {                               \
    the_ladder().prepare(static_cast<std::size_t>(family), static_cast<std::size_t>(n), 0);       \
  }                                                                                               \
  LADDER_EXPORT("pass") void ladder_pass(int method) {                                            \
    the_ladder().pass(static_cast<std::size_t>(method));                                          \
  }                                                                                               \
  LADDER_EXPORT("run") const double* ladder_run(int method) {                                     \
    static double row[9];                                                                         \
    ladder::run_in_page(the_ladder(), static_cast<std::size_t>(method), ladder_now_in_ms, row);   \
    return row;                                                                                   \
  }                                                                                               \
  static ladder::Exchange ladder_exchange;                                                        \
  LADDER_EXPORT("given") const double* ladder_given(int peer) {                                   \
    return ladder_exchange.given(the_ladder(), static_cast<std::size_t>(peer));                   \
  }                                                                                               \
  LADDER_EXPORT("questions") const double* ladder_questions(int peer) {                           \
    return ladder_exchange.questions(the_ladder(), static_cast<std::size_t>(peer));               \
  }                                                                                               \
  LADDER_EXPORT("answers") double* ladder_answers(int peer) {                                     \
    return ladder_exchange.answers(the_ladder(), static_cast<std::size_t>(peer));                 \
  }                                                                                               \
  LADDER_EXPORT("judge") const double* ladder_judge(int peer) {                                   \
    return ladder_exchange.judge(the_ladder(), static_cast<std::size_t>(peer));                   \
  }
#endif
