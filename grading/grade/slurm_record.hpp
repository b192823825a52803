#pragma once

// What is known of a run's job arrays in RESULTS/.grade, so that a coordinator that was killed
// takes them over:
//
//   slurm.json          the arrays, and of which RUN.json they are
//   slices/NAME/N.tsv   the orders of task N of the array NAME, one a line
//   slices/NAME/N.log   what that task said

#include <filesystem>
#include <string>
#include <vector>

#include "run_state.hpp"

namespace contact::grading {

struct SlurmArrayRecord {
  /// Drawn by lot, so that the array is found in the queue by it.
  std::string name;
  /// Slurm's number; empty from just before the array is submitted until Slurm has said it.
  std::string job;
};

class SlurmRecord {
 public:
  /// Reads what an earlier coordinator left; none if there is nothing or it is not understood.
  explicit SlurmRecord(const RunFolder& folder);

  /// Of RUN.json as it was when the arrays were submitted.
  [[nodiscard]] const std::string& run() const { return run_; }
  [[nodiscard]] const std::vector<SlurmArrayRecord>& arrays() const { return arrays_; }

  void set_run(std::string run) { run_ = std::move(run); }
  /// Draws a name, writes the slices of a new array and keeps it in mind before it is submitted.
  const SlurmArrayRecord& add(const std::vector<std::vector<Job>>& slices);
  void submitted(const std::string& name, const std::string& job);
  /// Forgets an array. Its logs stay if `keep_logs`.
  void remove(const std::string& name, bool keep_logs);
  /// Forgets all and removes every slice and log.
  void clear();

  [[nodiscard]] std::filesystem::path slices(const std::string& name) const {
    return folder_.grade() / "slices" / name;
  }
  /// The orders of each task; empty where a slice cannot be read.
  [[nodiscard]] std::vector<std::vector<Job>> jobs_of(const std::string& name) const;
  [[nodiscard]] std::filesystem::path log(const std::string& name, int task) const;

 private:
  void save() const;
  [[nodiscard]] std::filesystem::path file() const { return folder_.grade() / "slurm.json"; }

  RunFolder folder_;
  std::string run_;
  std::vector<SlurmArrayRecord> arrays_;
};

}  // namespace contact::grading
