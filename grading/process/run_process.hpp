#pragma once

// Child processes, each the leader of its own group, so that nothing it starts outlives it.

#include <array>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <uv.h>

namespace contact::grading {

/// Ctrl-C (or SIGTERM, SIGHUP) arrived: unwind, so that every temporary folder is removed on the
/// way out.
class Interrupted {};

/// The current work is obsolete (the file was saved again): unwind and start again.
class Cancelled {};

/// The event loop that processes, timers and file events of one thread share.
class Loop {
 public:
  Loop();
  ~Loop();
  Loop(const Loop&) = delete;
  Loop& operator=(const Loop&) = delete;

  [[nodiscard]] uv_loop_t* get() { return &loop_; }

  /// Handles one batch of events. @throws Interrupted.
  void run_once();
  /// The same, but returns at once if nothing has happened.
  void poll();

  /// From a callback on this loop: the process that runs now is ended and run_process() throws
  /// Cancelled.
  void cancel() { cancelled_ = true; }
  void clear_cancel() { cancelled_ = false; }
  [[nodiscard]] bool cancelled() const { return cancelled_; }

  void interrupt() { interrupted_ = true; }
  [[nodiscard]] bool interrupted() const { return interrupted_; }

 private:
  uv_loop_t loop_{};
  std::array<uv_signal_t, 3> signals_{};
  bool interrupted_ = false;
  bool cancelled_ = false;
};

/// Why a process was ended from outside.
enum class Ended { by_itself, time, idle, output, unwanted };

struct ProcessSpec {
  std::vector<std::string> command;
  std::filesystem::path folder;
  /// Set on top of the environment that this program has.
  std::vector<std::pair<std::string, std::string>> environment;
  /// The child has only what `environment` says.
  bool clean_environment = false;
  /// Descriptors that it gets besides 0, 1 and 2: ours, and their number there.
  std::vector<std::pair<int, int>> descriptors;
  /// Wall seconds; 0 means no limit.
  double time_limit = 0.0;
  /// Bytes of standard output and error kept, each.
  std::size_t output_limit = 64u << 20;
  /// Past this many bytes the process is ended; 0 means that the rest is read and dropped.
  std::size_t output_stop = 0;
  /// Both streams together count towards `output_stop`, not each by itself.
  bool output_in_all = false;
  /// Receives standard output as it comes; it is then not stored.
  std::function<void(std::string_view)> on_output;
  /// Gives the child a pipe as descriptor `events_descriptor` and passes on what it writes there.
  std::function<void(std::string_view)> on_events;
  int events_descriptor = 3;
  /// Called on the loop once the process has ended and all that it wrote is read.
  std::function<void()> on_end;
  /// Asked every few milliseconds; anything but by_itself ends the process.
  std::function<Ended(int pid)> watchdog;
  /// Seconds between asking a process that is out of time or output to end (SIGTERM, so that it can
  /// still say where it was) and ending it; 0 ends it at once.
  double grace = 0.0;
  /// It keeps others that must end with it, so it is asked to end even where others are ended at
  /// once.
  bool keeps_others = false;
  /// Standard input, output and error are this program's own.
  bool inherit = false;
};

struct ProcessResult {
  int exit_code = -1;
  /// The signal that ended it; 0 if it exited.
  int signal = 0;
  Ended ended = Ended::by_itself;
  std::string output;
  std::string errors;
  /// Of both together, kept or not.
  std::size_t bytes_printed = 0;
  double seconds = 0.0;
  [[nodiscard]] bool succeeded() const {
    return exit_code == 0 && signal == 0 && ended == Ended::by_itself;
  }
};

/// A running child. Several may run concurrently on one loop, and one may be started or destroyed
/// from a callback of another.
class Process {
 public:
  /// Starts it. @throws std::runtime_error if it cannot be started.
  Process(Loop& loop, ProcessSpec spec);
  /// Ends it and its group at once if it still runs, and waits until the kernel says so.
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  [[nodiscard]] int pid() const;
  /// Whether it has ended and all that it wrote is read.
  [[nodiscard]] bool ended() const;
  /// Whether it has written what is not read yet, so that it may be waiting for a full pipe.
  [[nodiscard]] bool has_unread_output() const;
  /// Ends it, as the specification's `grace` says; the first reason given is the one told.
  void end(Ended why);
  /// Turns the loop until it has ended.
  /// @throws Interrupted on Ctrl-C and Cancelled if the loop says so, both after ending it.
  ProcessResult wait();

  struct State;

 private:
  State* state_;
};

/// Runs a command to its end and leaves none of its group behind.
/// @throws std::runtime_error if it cannot be started; Interrupted on Ctrl-C and Cancelled if the
/// loop says so, both after ending it.
ProcessResult run_process(Loop& loop, const ProcessSpec& spec);

/// Seconds of processor time a running process has used; negative if the system does not say.
double processor_seconds(int pid);

/// Asks the kernel to end this process when its parent ends. Call it first; if the parent has
/// already ended, this does not return.
/// @param parent the process id that the parent had when it started this one
void end_with_parent(int parent);

/// A private folder that is removed with everything in it.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace contact::grading
