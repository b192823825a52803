#include "idle.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>

#include <dirent.h>
#include <fcntl.h>
#include <sched.h>
#include <unistd.h>

namespace contact::grading {

namespace {

using Sleepers = std::vector<IdleClock::Sleeper>;

constexpr std::chrono::milliseconds kPeriod{20};
// A sample counts for at most this time, however late it comes, unless all have slept since the
// previous sample.
constexpr double kMaxSeconds = 0.03;

std::optional<std::string> text_of(const std::string& file) {
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return std::nullopt;
  std::string text;
  std::array<char, 4096> part;
  ssize_t count = 0;
  while ((count = ::read(descriptor, part.data(), part.size())) > 0)
    text.append(part.data(), static_cast<std::size_t>(count));
  ::close(descriptor);
  if (count < 0) return std::nullopt;
  return text;
}

// Of "name:  value" lines, the value's first character on; empty if there is none.
std::string_view value_of(std::string_view status, std::string_view name) {
  const std::string line = "\n" + std::string(name) + ":\t";
  const std::size_t at = status.find(line);
  return at == std::string_view::npos ? std::string_view() : status.substr(at + line.size());
}

long long number_of(std::string_view status, std::string_view name) {
  const std::string_view value = value_of(status, name);
  return value.empty() ? -1 : std::strtoll(value.data(), nullptr, 10);
}

class Family {
 public:
  /// Adds the threads of a process and of all that it has started, as they are now.
  /// @returns false once one of them is not asleep, or cannot be seen
  bool add(int process) {
    const std::string folder = "/proc/" + std::to_string(process);
    const std::optional<std::string> status = text_of(folder + "/status");
    if (!status) return false;
    if (number_of(*status, "Threads") == 1 && state_of(*status) != 'Z')
      return add_thread(folder, process, *status);
    const std::unique_ptr<DIR, int (*)(DIR*)> threads(::opendir((folder + "/task").c_str()),
                                                      ::closedir);
    if (!threads) return false;
    while (const dirent* entry = ::readdir(threads.get())) {
      const int thread = std::atoi(entry->d_name);
      if (thread <= 0) continue;
      const std::optional<std::string> own = text_of(folder + "/task/" + entry->d_name + "/status");
      if (!own || !add_thread(folder, thread, *own)) return false;
    }
    return true;
  }

  [[nodiscard]] std::size_t size() const { return sleepers_.size(); }
  [[nodiscard]] Sleepers take() { return std::move(sleepers_); }

 private:
  static char state_of(std::string_view status) {
    const std::string_view state = value_of(status, "State");
    return state.empty() ? '?' : state.front();
  }

  bool add_thread(const std::string& folder, int thread, std::string_view status) {
    switch (state_of(status)) {
      case 'S':  // asleep until something happens
      case 'T':  // stopped by a signal
      case 't':
        break;
      case 'Z':  // ended: others may go on without it
      case 'X':
        return true;
      default:
        return false;
    }
    const long long voluntary = number_of(status, "voluntary_ctxt_switches");
    const long long forced = number_of(status, "nonvoluntary_ctxt_switches");
    if (voluntary < 0 || forced < 0) return false;
    sleepers_.push_back({thread, voluntary + forced});
    const std::optional<std::string> children =
        text_of(folder + "/task/" + std::to_string(thread) + "/children");
    if (!children) return false;
    for (const char* at = children->c_str();;) {
      char* end = nullptr;
      const long child = std::strtol(at, &end, 10);
      if (end == at) return true;
      if (!add(static_cast<int>(child))) return false;
      at = end;
    }
  }

  Sleepers sleepers_;
};

// All threads, if all are asleep.
std::optional<Sleepers> asleep(std::initializer_list<int> processes) {
  Family family;
  for (const int process : processes) {
    const std::size_t before = family.size();
    // A process that has ended has no thread any more.
    if (!family.add(process) || family.size() == before) return std::nullopt;
  }
  return family.take();
}

// How many of the same threads have been awake in between; nothing if they are others.
std::optional<std::size_t> woken(const Sleepers& before, const Sleepers& after) {
  if (before.size() != after.size()) return std::nullopt;
  std::size_t count = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (before[i].thread != after[i].thread) return std::nullopt;
    if (before[i] != after[i]) ++count;
  }
  return count;
}

// Whether all were asleep at one instant. Threads are read one after the other, so each may have
// been asleep only when it was read. But a thread without a context switch between two readings
// slept all the time between. If that holds for all threads, they slept at the same time. If it
// holds for all but one, they slept when that one was found asleep in the middle of three readings;
// this detects a thread that wakes itself every few microseconds. Two threads that wake each other
// are not detected.
std::optional<Sleepers> asleep_at_once(std::initializer_list<int> processes) {
  std::optional<Sleepers> first = asleep(processes);
  if (!first) {
    // The timer that woke this program may also have woken one that only sleeps again, which then
    // waits behind it on the same core.
    ::sched_yield();
    first = asleep(processes);
  }
  if (!first) return std::nullopt;
  const std::optional<Sleepers> second = asleep(processes);
  if (!second) return std::nullopt;
  const std::optional<std::size_t> count = woken(*first, *second);
  if (count == 0) return first;
  if (count != 1) return std::nullopt;
  const std::optional<Sleepers> third = asleep(processes);
  if (!third || woken(*first, *third).value_or(2) > 1) return std::nullopt;
  return first;
}

}  // namespace

void IdleClock::sample(std::initializer_list<int> processes, const std::function<bool()>& awaited) {
  const Clock::time_point now = Clock::now();
  if (now - last_time_ < kPeriod) return;
  const double elapsed = std::chrono::duration<double>(now - last_time_).count();
  last_time_ = now;
  std::optional<Sleepers> sleepers = asleep_at_once(processes);
  if (sleepers && awaited()) sleepers.reset();
  if (sleepers) seconds_ += sleepers == last_ ? elapsed : std::min(elapsed, kMaxSeconds);
  last_ = std::move(sleepers);
}

}  // namespace contact::grading
