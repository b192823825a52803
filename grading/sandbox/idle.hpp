#pragma once

// Time during which processes only wait: for a time to pass, for a lock that none of them will
// release, for bytes that no process sends.

#include <chrono>
#include <functional>
#include <initializer_list>
#include <optional>
#include <vector>

namespace contact::grading {

/// Adds up the time in which every thread of some processes is asleep at once.
///
/// A process that is kept from a core by others is runnable, and one that waits for a disk is in an
/// uninterruptible sleep: neither is asleep here. So the time does not grow with the machine's
/// load. It is sampled every 20 ms, and a sample counts only if the kernel's counters of context
/// switches prove that all were asleep at one instant; where two processes answer each other,
/// one of them always is runnable.
class IdleClock {
 public:
  /// Samples these processes and all that they have started, unless the last sample is too recent.
  /// @param awaited whether one of them may be waiting for this program (for what it printed to be
  /// read, say): then the sample does not count
  void sample(std::initializer_list<int> processes, const std::function<bool()>& awaited);

  [[nodiscard]] double seconds() const { return seconds_; }

  struct Sleeper {
    int thread = 0;
    long long switches = 0;
    bool operator==(const Sleeper&) const = default;
  };

 private:
  using Clock = std::chrono::steady_clock;

  double seconds_ = 0.0;
  Clock::time_point last_time_ = Clock::now();
  /// The processes that slept at the last sample; none if that did not count.
  std::optional<std::vector<Sleeper>> last_;
};

}  // namespace contact::grading
