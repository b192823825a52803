#pragma once

// Grading on a cluster: units are cut into slices, one job array grades them, and their files in
// RESULTS, which every node must see, say what is done. Slurm's queue is asked only to know which
// tasks still may write, so a coordinator that is started again takes over what runs.

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "engine.hpp"
#include "run_state.hpp"
#include "slurm_commands.hpp"
#include "slurm_record.hpp"
#include "watchdog.hpp"

namespace contact::grading {

struct SlurmSetting {
  /// What a task starts, with orders on its standard input: the program, grade-worker, RUN.json.
  std::vector<std::string> worker;
  /// What one worker with its boxes may need.
  int memory_mb = 0;
  TimeOfJob time;
  /// Whether a unit's file holds what the run asks for.
  std::function<bool(const Job&)> has_result;
  /// Receives lines of information for the instructor.
  std::function<void(const std::string&)> note;
};

class SlurmEngine final : public Engine {
 public:
  /// RUN.json must exist. Jobs that a different earlier run has in the queue are cancelled before
  /// results are read.
  /// @throws BookError if Slurm's commands are not here or the cluster does not answer
  SlurmEngine(Loop& loop, const RunFolder& folder, const SlurmOptions& options,
              SlurmSetting setting);

  [[nodiscard]] std::string name() const override { return "slurm"; }
  /// 0 if the cluster decides.
  [[nodiscard]] int workers() const override { return commands_.options().tasks_at_a_time; }

  /// Jobs that are `alone` get a node to themselves, several of them perhaps at a time. Ctrl-C
  /// cancels all that is in the queue; any other end of this program leaves it there for the next
  /// run, which takes it over if RUN.json is the same.
  std::vector<JobTrouble> run(const std::vector<Job>& jobs,
                              const std::function<void(const Job&)>& finished) override;

 private:
  using Clock = std::chrono::steady_clock;

  // A task that may hold jobs that wait for their results.
  struct Task {
    std::string array;
    std::string job;
    int index = 0;
    std::vector<Job> jobs;
    SlurmTask state;
    std::optional<Clock::time_point> ended;
    /// It is known what became of each of its jobs.
    bool settled = false;
    /// How many results there were when it was submitted.
    std::size_t results_before = 0;
    /// Time in which it ran and was done with no unit, and how long its log was then.
    FairClock quiet_clock;
    double quiet_since = 0.0;
    std::uintmax_t told = 0;
    /// Cancelled from here, because it was quiet for longer than a unit may take.
    bool late = false;
  };

  void grade();
  void look_back();
  void take_over();
  void submit(const std::vector<Job>& jobs);
  void submit_array(const std::vector<std::vector<Job>>& slices, bool alone);
  void watch(const SlurmArrayRecord& array, const std::vector<std::vector<Job>>& slices);

  void pause();
  void ask_queue();
  void end_late();
  void collect(bool all);
  std::vector<Job> settle();
  std::vector<Job> lost(const Task& task, const std::vector<Job>& jobs);
  [[nodiscard]] std::vector<Job> waiting_in(const Task& task) const;
  void give_up(const Job& job, const std::string& why);
  [[nodiscard]] std::string end_of(const Task& task) const;
  SlurmTask forgotten(const Task& task);
  void wait_for_rest();
  void forget_arrays();

  /// Cancels every array on record and waits until nothing of them runs.
  void cancel_all(SlurmCommands& commands, Loop& loop);
  /// The same on the way out, when the loop has been interrupted.
  void withdraw();

  Loop& loop_;
  RunFolder folder_;
  SlurmCommands commands_;
  SlurmSetting setting_;
  SlurmRecord record_;
  int max_tasks_ = 0;
  /// An earlier coordinator had something in the queue.
  bool left_behind_ = false;

  std::function<void(const Job&)> finished_;
  std::vector<Task> tasks_;
  /// Jobs without a result, and the task that has each; none before it is submitted.
  std::map<Job, std::optional<std::size_t>> waiting_;
  /// How often a task ended at this job.
  std::map<Job, int> failures_;
  /// In how many tasks running nothing at all was finished while the job was in the queue.
  std::map<Job, int> barren_;
  std::size_t results_ = 0;
  std::vector<JobTrouble> troubles_;
  Clock::time_point began_;
  std::optional<Clock::time_point> silent_since_;
};

}  // namespace contact::grading
