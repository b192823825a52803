#pragma once

// Starts submissions for a judge, which cannot start processes in its sandbox; each start has a
// sandbox of its own. The judge asks over a socket (grading/contact/remote_broker.hpp) and gets the
// near end of a socket to the submission. The broker limits the submission, ends it, and reports
// why it ended.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "../sandbox/box.hpp"

namespace contact::grading {

/// How long the submissions that one unit starts, one a test, may take.
struct AnswerTime {
  /// Seconds of processor time of one.
  double cpu_seconds = 5.0;
  /// Seconds in which one may only wait (sandbox/idle.hpp), and in which all may before the next
  /// has a tenth: one that sleeps in every test must not take as long as all its tests together.
  double idle_seconds = 1.0;
  double idle_seconds_in_all = 6.0;
  /// What all have waited so far.
  double idle_so_far = 0.0;
};

/// A submission that was started, and how it ended.
struct Answered {
  /// For which test, counted from 1 as they began in the judge.
  std::uint64_t test = 0;
  BoxEnd end;
};

class Broker {
 public:
  /// @param answer the submission's sandbox, except for the socket on which it answers
  /// @param time outlives this, which adds to what all have waited
  Broker(Loop& loop, const Machine& machine, const Seat& seat, BoxSpec answer, AnswerTime& time);
  ~Broker();
  Broker(const Broker&) = delete;
  Broker& operator=(const Broker&) = delete;

  /// The judge's end of the socket: for its box, and to be let go once that is started.
  [[nodiscard]] int judge_end() const;
  void let_go_of_judge_end();

  /// Does what the judge has asked for, and ends a submission that is out of time or only waits
  /// while the judge, too, waits. To be called after every turn of the loop, which returns every
  /// few milliseconds while there is a broker.
  /// @throws BookError if a submission cannot be started
  void serve(const Box& judge);

  /// Ends the submission that still runs, if any, and returns all that there were, in order.
  std::vector<Answered> finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace contact::grading
