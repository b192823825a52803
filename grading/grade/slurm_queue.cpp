// What stays in Slurm's queue from one run to the next: found, taken over, forgotten, cancelled.

#include <algorithm>

#include "sha256.hpp"
#include "slurm.hpp"

namespace contact::grading {

namespace {

using Duration = std::chrono::duration<double>;

// Tasks that are cancelled have Slurm's KillWait to end, which is 30 seconds if unset.
constexpr Duration cancelling{120.0};

}  // namespace

// Arrays that an earlier coordinator left: those of this very run stay if something of them is in
// the queue.
void SlurmEngine::look_back() {
  const std::string run = sha256(read_text(folder_.run_file()));
  left_behind_ = !record_.arrays().empty();
  if (left_behind_ && record_.run() != run) {
    setting_.note(
        "What is asked for has changed since the last run; its jobs in Slurm's queue are cancelled "
        "first.");
    cancel_all(commands_, loop_);
  }
  if (record_.run() != run) {
    record_.clear();
    record_.set_run(run);
  }
  for (const SlurmArrayRecord& array : std::vector<SlurmArrayRecord>(record_.arrays())) {
    std::string job = array.job;
    // The coordinator was gone before Slurm had answered.
    if (job.empty()) job = commands_.find(array.name).value_or("");
    const SlurmQueue queue =
        commands_.queue(job.empty() ? std::vector<std::string>{} : std::vector<std::string>{job});
    const bool live = std::any_of(queue.begin(), queue.end(),
                                  [](const auto& entry) { return entry.second.live(); });
    if (live)
      record_.submitted(array.name, job);
    else
      record_.remove(array.name, false);
  }
}

void SlurmEngine::take_over() {
  if (!left_behind_) return;
  std::vector<std::string> jobs;
  for (const SlurmArrayRecord& array : record_.arrays()) {
    watch(array, record_.jobs_of(array.name));
    jobs.push_back(array.job);
    setting_.note("Slurm job " + array.job + " of the last run goes on and is taken over.");
  }
  // A task that has ended already holds nothing; what it did is seen here, the rest is submitted.
  const SlurmQueue queue = commands_.queue(jobs);
  for (Task& task : tasks_) {
    const auto found = queue.find({task.job, task.index});
    if (found != queue.end() && found->second.live()) continue;
    for (const Job& job : waiting_in(task)) waiting_[job].reset();
    task.settled = true;
    task.ended = Clock::now();
  }
  collect(true);
}

// What this call saw the end of; arrays that are for another call stay on record.
void SlurmEngine::forget_arrays() {
  std::set<std::string> seen;
  for (const Task& task : tasks_) seen.insert(task.array);
  for (const Task& task : tasks_) {
    if (!task.ended) seen.erase(task.array);
  }
  for (const std::string& array : seen) record_.remove(array, !troubles_.empty());
  if (record_.arrays().empty() && troubles_.empty()) record_.clear();
}

void SlurmEngine::cancel_all(SlurmCommands& commands, Loop& loop) {
  std::vector<std::string> jobs;
  for (const SlurmArrayRecord& array : record_.arrays()) {
    const std::string job = array.job.empty() ? commands.find(array.name).value_or("") : array.job;
    if (!job.empty()) jobs.push_back(job);
  }
  const Clock::time_point start = Clock::now();
  while (true) {
    // Again each time: an array may have been on its way into the queue.
    commands.cancel(jobs);
    const SlurmQueue queue = commands.queue(jobs);
    const auto live =
        std::find_if(queue.begin(), queue.end(), [](const auto& e) { return e.second.live(); });
    if (live == queue.end()) break;
    if (Clock::now() - start > cancelling)
      throw SlurmError("Slurm's job " + live->first.first + " is cancelled but does not end (" +
                       live->second.state + ")");
    const Clock::time_point asked = Clock::now();
    while (Clock::now() - asked < Duration(0.5)) {
      loop.poll();
      uv_sleep(20);
    }
  }
  record_.clear();
}

void SlurmEngine::withdraw() {
  if (record_.arrays().empty()) return;
  setting_.note("Cancelling what is in Slurm's queue; Ctrl-C again leaves it there.");
  try {
    Loop loop;
    SlurmCommands commands(loop, commands_.options());
    cancel_all(commands, loop);
  } catch (const Interrupted&) {
    setting_.note("It is left to end by itself; the next run looks after it.");
  } catch (const SlurmError& error) {
    setting_.note(std::string(error.what()) + ". The next run looks after it.");
  }
}

}  // namespace contact::grading
