#pragma once

// Ends this process if something in it takes longer than it may, whatever it does: an endless loop
// of our own, a lock that is never let go, a wait for what never comes.

#include <condition_variable>
#include <functional>
#include <mutex>
#include <set>
#include <string>
#include <thread>

namespace contact::grading {

/// Seconds that were counted on the clock, in small steps. A longer step, in which this process was
/// stopped or had no processor, counts as a small one, so a program that was suspended and goes on
/// is given the time that it has missed.
class FairClock {
 public:
  explicit FairClock(double max_in_a_step = 1.0) : max_in_a_step_(max_in_a_step) {}
  /// Counts what has passed since the last call. @returns the seconds counted so far
  double tick();
  /// What passes before the next call does not count.
  void pause() { last_ = -1.0; }

 private:
  double max_in_a_step_;
  double last_ = -1.0;
  double seconds_ = 0.0;
};

class Watchdog {
 public:
  /// @param out_of_time called in a thread of the watchdog with the name of what has taken too
  /// long; it must end the process and take no lock that another thread may hold forever
  explicit Watchdog(std::function<void(const std::string& what)> out_of_time);
  ~Watchdog();
  Watchdog(const Watchdog&) = delete;
  Watchdog& operator=(const Watchdog&) = delete;

  /// While it lives, the time counts. Several may live at once, one in each thread.
  class Watch {
   public:
    Watch(Watchdog& dog, double seconds, std::string what);
    ~Watch();
    Watch(const Watch&) = delete;
    Watch& operator=(const Watch&) = delete;

   private:
    friend class Watchdog;
    Watchdog& dog_;
    double until_ = 0.0;
    std::string what_;
  };

 private:
  void run();

  std::function<void(const std::string&)> out_of_time_;
  std::mutex mutex_;
  std::condition_variable wake_;
  FairClock clock_;
  std::set<Watch*> watches_;
  bool over_ = false;
  std::thread thread_;
};

}  // namespace contact::grading
