#pragma once

// Sandboxes: processes that run untrusted programs. A sandbox sees only the files that it is given,
// has no network, no environment and no privilege, and ends with the process that started it.
// machine.hpp reports what the machine cannot enforce.

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "../process/run_process.hpp"
#include "machine.hpp"

namespace contact::grading {

struct BoxLimits {
  /// Seconds of processor time of the whole box. The kernel counts whole seconds, rounded up.
  double cpu_seconds = 5.0;
  /// Seconds of elapsed time; for what waits without working.
  double wall_seconds = 30.0;
  /// Seconds in which everything in it may be asleep (idle.hpp); 0 for no limit.
  double idle_seconds = 0.0;
  int memory_mb = 512;
  /// Number of processes and threads. 1 lets the box start none at all.
  int processes = 1;
  /// Bytes of standard output and error together; beyond that the box is ended.
  std::size_t output_bytes = 1u << 20;
  /// The private /tmp: megabytes (also the most that one file may hold) and files.
  int files_mb = 16;
  int files = 64;
};

/// The purpose of a sandbox determines its system calls.
enum class BoxKind {
  compile,  ///< the compiler and the linker: they start processes and write files
  answer,   ///< a submission: one program linked statically, a socket, and nothing else
  judge     ///< the tests: they calculate, write events and ask for submissions
};

struct BoxMount {
  std::filesystem::path host;
  std::filesystem::path box;
};

/// Paths are as the box sees them. Without namespaces it sees the machine's own: paths in
/// `command`, `folder` and `environment` are then put into those, and back in what it prints.
struct BoxSpec {
  BoxKind kind = BoxKind::answer;
  /// The program with its whole path.
  std::vector<std::string> command;
  std::vector<BoxMount> read_only;
  /// One folder of the host that the box may write to; none if both paths are empty.
  BoxMount writable;
  /// Also the system, read-only: its libraries for a judge that is linked dynamically; for the
  /// compiler its programs too, and of /usr/include the standard libraries and Eigen. There is no
  /// /usr/local, no /usr/share, no /usr/src. Without namespaces it has all that is installed where
  /// a compiler searches for headers, /usr/local/include as well.
  bool system = false;
  /// The whole environment, except PATH=/usr/bin:/bin when it compiles and PWD, which bubblewrap
  /// sets.
  std::vector<std::pair<std::string, std::string>> environment;
  /// Folder to start in, as the box sees it.
  std::filesystem::path folder = "/";
  /// Descriptors that it gets besides 0, 1 and 2: ours, and their number there.
  std::vector<std::pair<int, int>> descriptors;
  BoxLimits limits;
  /// Receives standard output as it comes; it is then not stored.
  std::function<void(std::string_view)> on_output;
  /// Called on the loop once it has ended.
  std::function<void()> on_end;
};

/// One place among the workers: the user id and control groups that its boxes have, held until
/// destroyed. Two seats never share them, in this program or in another on this machine.
class Seat {
 public:
  /// @throws BookError if the machine lends none.
  explicit Seat(const Machine& machine);
  ~Seat();
  Seat(const Seat&) = delete;
  Seat& operator=(const Seat&) = delete;

  struct State;
  [[nodiscard]] State& state() const { return *state_; }
  /// Gives a file or folder to the user of this seat's boxes, so that they can read or write it.
  void give(const std::filesystem::path& path) const;

 private:
  std::unique_ptr<State> state_;
};

/// Reports the end of a sandbox to the caller.
struct BoxEnd {
  ProcessResult process;
  /// It was ended for want of memory (known where control groups count it).
  bool out_of_memory = false;
  double cpu_seconds = 0.0;
};

/// A running box.
class Box {
 public:
  Box(Loop& loop, const Machine& machine, const Seat& seat, BoxSpec spec);
  /// Ends it and everything in it, and waits until it is gone.
  ~Box();
  Box(const Box&) = delete;
  Box& operator=(const Box&) = delete;

  [[nodiscard]] bool ended() const;
  /// Processor time used so far by everything in it.
  [[nodiscard]] double cpu_seconds() const;
  /// The process that keeps it; all that is in it was started by that one.
  [[nodiscard]] int pid() const;
  /// Whether it has written what is not read yet.
  [[nodiscard]] bool has_unread_output() const;
  /// Ends it now.
  void end(Ended why);
  /// Turns the loop until it has ended.
  /// @throws BookError if the machine could not make the box; Interrupted and Cancelled as a
  /// Process
  BoxEnd wait();

  struct State;

 private:
  std::unique_ptr<State> state_;
};

/// What a box exits with if the kernel did not start an answer's program.
inline constexpr int not_started = 127;

/// Runs a box to its end. @throws as Box::wait().
BoxEnd run_box(Loop& loop, const Machine& machine, const Seat& seat, BoxSpec spec);

}  // namespace contact::grading
