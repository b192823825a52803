#pragma once

// Where units are graded: on this machine or on a cluster's. An engine starts workers
// (`contact grade-worker`), gives them units and says when each is done; it knows nothing of marks.

#include <functional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace contact::grading {

/// One exercise of one submission.
struct Job {
  std::string submission;
  std::string exercise;
  /// The worker's orders, one a line: "SUBMISSION\tEXERCISE", and "\talone" if nothing else runs.
  bool alone = false;
  friend bool operator<(const Job& a, const Job& b) {
    return std::tie(a.submission, a.exercise) < std::tie(b.submission, b.exercise);
  }
};

std::string order_of(const Job& job);
/// @throws BookError if the line is no order.
Job job_from_order(std::string_view line);

/// A unit that no worker could grade, through no fault of the submission: its mark is not known.
struct JobTrouble {
  Job job;
  std::string what;
};

/// How often a job that fails is given before it is a JobTrouble. A job that outlives its time
/// counts twice, since each time costs as long as a unit may take at most.
inline constexpr int max_tries = 3;
inline constexpr int tries_out_of_time = 2;

/// The seconds on the clock that a job may take.
using TimeOfJob = std::function<double(const Job&)>;

class Engine {
 public:
  Engine() = default;
  virtual ~Engine() = default;
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  /// "local" or "slurm", for the record of the run.
  [[nodiscard]] virtual std::string name() const = 0;
  /// How many units are graded at a time.
  [[nodiscard]] virtual int workers() const = 0;

  /// Has every job graded: its unit file is written and holds the key that the run asks for. A
  /// worker that dies is replaced and its job given again, at most twice; one whose job outlives
  /// its time is ended, and that job given again once at most. Jobs that are `alone` are graded one
  /// after the other with nothing beside them.
  /// @param finished called when a unit's file is there
  /// @returns jobs without a result, and why
  /// @throws Interrupted on Ctrl-C, after every worker is gone; BookError if none can be started
  virtual std::vector<JobTrouble> run(const std::vector<Job>& jobs,
                                      const std::function<void(const Job&)>& finished) = 0;
};

}  // namespace contact::grading
