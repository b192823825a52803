#include "watchdog.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <utility>

namespace contact::grading {

namespace {

constexpr std::chrono::milliseconds step{100};

// The kernel's signals are for the thread that has the loop.
class WithoutSignals {
 public:
  WithoutSignals() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before_);
  }
  ~WithoutSignals() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  WithoutSignals(const WithoutSignals&) = delete;
  WithoutSignals& operator=(const WithoutSignals&) = delete;

 private:
  sigset_t before_{};
};

}  // namespace

double FairClock::tick() {
  const double now =
      std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  if (last_ >= 0.0) seconds_ += std::clamp(now - last_, 0.0, max_in_a_step_);
  last_ = now;
  return seconds_;
}

Watchdog::Watchdog(std::function<void(const std::string&)> out_of_time)
    : out_of_time_(std::move(out_of_time)) {
  const WithoutSignals masked;
  thread_ = std::thread([this] { run(); });
}

Watchdog::~Watchdog() {
  {
    const std::lock_guard lock(mutex_);
    over_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

void Watchdog::run() {
  std::unique_lock lock(mutex_);
  while (!over_) {
    if (watches_.empty())
      wake_.wait(lock);
    else
      wake_.wait_for(lock, step);
    const double now = clock_.tick();
    for (const Watch* watch : watches_) {
      if (now > watch->until_) out_of_time_(watch->what_);
    }
  }
}

Watchdog::Watch::Watch(Watchdog& dog, double seconds, std::string what)
    : dog_(dog), what_(std::move(what)) {
  {
    const std::lock_guard lock(dog_.mutex_);
    until_ = dog_.clock_.tick() + seconds;
    dog_.watches_.insert(this);
  }
  dog_.wake_.notify_all();
}

Watchdog::Watch::~Watch() {
  const std::lock_guard lock(dog_.mutex_);
  dog_.watches_.erase(this);
}

}  // namespace contact::grading
