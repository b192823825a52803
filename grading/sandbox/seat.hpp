#pragma once

// The resources of a seat, for the sandboxes that are started on it.

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <sched.h>

#include "box.hpp"
#include "cgroup.hpp"

namespace contact::grading {

struct Seat::State {
  State() = default;
  ~State();
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  /// The user id of the boxes; -1 if they have this program's own.
  long user = -1;
  /// Reserves the user id for this program.
  int lock = -1;
  /// The reserved core of this worker; -1 if it may run on any core.
  int core = -1;
  /// Where the thread could go before it kept to one.
  cpu_set_t cores{};
  /// An empty network namespace for all sandboxes of the seat: creating one for each sandbox would
  /// take longer than everything else. -1 if each box makes its own.
  int network = -1;
  /// Groups that no box is in.
  std::vector<std::unique_ptr<BoxGroup>> groups;
  /// What compile boxes see as /usr/include, made when first asked for: the files of it, and the
  /// folders that are shown from the system itself.
  std::unique_ptr<TemporaryFolder> headers;
  std::vector<std::filesystem::path> header_folders;
  /// What they may read of the system's headers where none can be hidden, found when first asked
  /// for.
  std::vector<std::filesystem::path> searched_folders;

  /// A group for one box, which gives it back with `groups.push_back()`; null if there are none.
  std::unique_ptr<BoxGroup> take_group(const Machine& machine);
};

}  // namespace contact::grading
