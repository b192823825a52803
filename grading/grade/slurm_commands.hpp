#pragma once

// Slurm's commands, each started without a shell, so that no path and no option needs quoting.
// Where one fails, the sentence names it and says what it said.

#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "../process/run_process.hpp"

namespace contact::grading {

/// What an instructor may ask of the cluster.
struct SlurmOptions {
  std::string partition;
  std::string account;
  /// A task's time limit as Slurm writes it: "30", "1:00:00", "1-12".
  std::string time;
  /// More options of sbatch, as one would type them.
  std::string more;
  /// Tasks at a time; 0 leaves it to the cluster.
  int tasks_at_a_time = 0;
  /// Units a task; 0 chooses.
  int units_a_task = 0;
};

/// Splits a text as a shell would: at spaces, except those in quotes or after a backslash. No other
/// character is special. @throws BookError if a quote is not closed.
std::vector<std::string> split_words(std::string_view text);

/// A job array to submit.
struct SlurmArray {
  /// Nothing else in the queue has this name.
  std::string name;
  /// The script and what it is given.
  std::vector<std::string> command;
  int tasks = 1;
  /// Each task has a node to itself.
  bool exclusive = false;
  /// What one task may need.
  int memory_mb = 0;
};

/// The state of a task of an array.
struct SlurmTask {
  /// In Slurm's words: PENDING, RUNNING, COMPLETED, NODE_FAIL, ...
  std::string state;
  /// Why it waits or failed, in Slurm's words; may be empty or "None".
  std::string reason;

  /// It has not ended and may still write results.
  [[nodiscard]] bool live() const;
};

/// Tasks by their job and their place in the array.
using SlurmQueue = std::map<std::pair<std::string, int>, SlurmTask>;

/// A command of Slurm's that failed; the text is a sentence.
class SlurmError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// All functions throw SlurmError, and Interrupted as run_process() does.
class SlurmCommands {
 public:
  SlurmCommands(Loop& loop, SlurmOptions options) : loop_(loop), options_(std::move(options)) {}

  [[nodiscard]] const SlurmOptions& options() const { return options_; }
  /// That the commands are here and the cluster answers.
  void require();
  /// How many tasks the cluster allows in an array.
  int max_tasks();
  /// Returns the job's id.
  std::string submit(const SlurmArray& array);
  /// Every task of these jobs that the controller remembers; one that has ended is forgotten after
  /// some minutes.
  SlurmQueue queue(const std::vector<std::string>& jobs);
  /// The job with this name, if the controller knows one.
  std::optional<std::string> find(const std::string& name);
  /// How a task ended that the controller has forgotten, where the cluster keeps accounts; else
  /// nothing.
  std::optional<SlurmTask> accounted(const std::string& job, int task);
  void cancel(const std::vector<std::string>& jobs);

 private:
  std::string run(const std::vector<std::string>& command);

  Loop& loop_;
  SlurmOptions options_;
};

}  // namespace contact::grading
