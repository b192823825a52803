#pragma once

// Which restrictions this machine can impose on a submission, determined by trying them.

#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "../process/run_process.hpp"

namespace contact::grading {

/// How well submissions can be isolated.
enum class Level {
  full,     ///< namespaces of their own (files, processes, network, users), filtered system calls,
            ///< limits
  reduced,  ///< no namespaces: another user id, filtered system calls, limits; a submission opens
            ///< no file at all
  none      ///< less than that: refused unless accepted by name
};

/// One restriction of a sandbox, whether it works here, and how it was tried or what is missing.
struct Measure {
  std::string what;
  bool enforced = false;
  std::string how;
};

enum class ControlGroups { none, v1, v2 };

struct Machine {
  Level level = Level::none;
  std::vector<Measure> measures;
  /// This program may change its user id, so every seat gets one of its own.
  bool own_user_ids = false;
  bool namespaces = false;
  /// Processes can be counted for each seat or box by itself: another user id, or a kernel that
  /// counts them in each user namespace.
  bool own_process_count = false;
  bool system_call_filter = false;
  /// The kernel can close all files to a process but those named (Landlock): what is left where
  /// there are no namespaces.
  bool closed_files = false;
  ControlGroups control_groups = ControlGroups::none;
  /// What of them can be limited here.
  bool group_pids = false;
  bool group_memory = false;
  /// bubblewrap and contact-box, as they are started.
  std::string bubblewrap;
  std::string launcher;
  /// How many seats may work side by side without sharing a quota.
  int max_workers = 1;
};

/// Tries each measure in a box of its own; takes less than a second. CONTACT_BOX_LEVEL, `reduced`
/// or `none`, makes it go without what a higher level has: for tests, and never to have more.
Machine examine_machine(Loop& loop);
/// The same without the measures: finds the level only, in one box or a few.
Machine find_machine(Loop& loop);

std::string_view words(Level level);  ///< "full", "reduced" or "none"
/// {"level", "measures": [{"what", "enforced", "how"}]}
nlohmann::json to_json(const Machine& machine);

}  // namespace contact::grading
