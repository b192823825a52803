#pragma once

// Control groups, if the machine provides them: limits on the memory and processes of a whole
// sandbox, and its usage.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "machine.hpp"

namespace contact::grading {

/// The groups of one box, below those that this program is in; removed when destroyed.
class BoxGroup {
 public:
  /// Creates the groups, or as many as possible, after removing those of programs that have ended.
  BoxGroup();
  ~BoxGroup();
  BoxGroup(const BoxGroup&) = delete;
  BoxGroup& operator=(const BoxGroup&) = delete;

  [[nodiscard]] ControlGroups kind() const { return kind_; }
  [[nodiscard]] bool has_pids() const { return !pids_.empty(); }
  [[nodiscard]] bool has_memory() const { return !memory_.empty(); }
  [[nodiscard]] bool has_clock() const { return !clock_.empty(); }

  /// The files that a process writes 0 to, to enter.
  [[nodiscard]] std::vector<std::string> entrances() const;
  /// Before a box is started in it: the limits, and all counts from nothing.
  void prepare(int memory_mb, int processes);
  /// Seconds of processor time since then, of everything that was ever in it.
  [[nodiscard]] double cpu_seconds() const;
  /// Whether something in it was ended for want of memory since then.
  [[nodiscard]] bool out_of_memory() const;
  /// Ends whatever is in it.
  void end_all() const;

 private:
  static std::string next_name();
  void make_v1(const std::string& name);
  void make_v2(const std::string& name);
  [[nodiscard]] double clock() const;
  [[nodiscard]] long memory_kills() const;
  [[nodiscard]] std::vector<std::filesystem::path> folders() const;

  ControlGroups kind_ = ControlGroups::none;
  std::filesystem::path pids_;
  std::filesystem::path memory_;
  std::filesystem::path clock_;
  double clock_before_ = 0.0;
  long kills_before_ = 0;
};

}  // namespace contact::grading
