#include "slurm.hpp"

#include <algorithm>
#include <fstream>
#include <utility>

#include "slurm_log.hpp"
#include "slurm_slices.hpp"
#include "unit_time.hpp"

namespace fs = std::filesystem;

namespace contact::grading {

namespace {

using Duration = std::chrono::duration<double>;

// A worker ends itself if a unit outlives its time, unless it cannot: then its task is cancelled
// from here, this much later. A shared folder may show late what a worker has done.
constexpr double after_its_own = 20.0;
// Seconds of a task that runs until its worker says that it is ready.
constexpr double starting = 600.0;
// The queue is asked more often than this; a longer step was one in which this program was stopped.
constexpr double max_between_looks = 20.0;
// A shared folder may show a file some seconds after it was written elsewhere.
constexpr Duration patience{5.0};
// Controllers are restarted now and then; jobs go on meanwhile.
constexpr Duration silence{600.0};

std::string count_of(std::size_t count, const char* what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

// Makes a shared file system look at the server again: a change of ours brings back the folder's
// state, with the changes of others.
void refresh(const fs::path& folder) {
  const fs::path file = folder / ".look";
  std::ofstream(file) << "";
  std::error_code ignored;
  fs::remove(file, ignored);
}

std::set<std::string> names_in(const fs::path& folder) {
  std::set<std::string> names;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error))
    names.insert(entry->path().filename().string());
  return names;
}

}  // namespace

SlurmEngine::SlurmEngine(Loop& loop, const RunFolder& folder, const SlurmOptions& options,
                         SlurmSetting setting)
    : loop_(loop),
      folder_(folder),
      commands_(loop, options),
      setting_(std::move(setting)),
      record_(folder),
      began_(Clock::now()) {
  split_words(options.more);
  try {
    commands_.require();
    max_tasks_ = commands_.max_tasks();
    look_back();
  } catch (const SlurmError& error) {
    throw BookError(error.what());
  }
}

std::vector<JobTrouble> SlurmEngine::run(const std::vector<Job>& jobs,
                                         const std::function<void(const Job&)>& finished) {
  finished_ = finished;
  tasks_.clear();
  waiting_.clear();
  failures_.clear();
  barren_.clear();
  troubles_.clear();
  results_ = 0;
  began_ = Clock::now();
  for (const Job& job : jobs) waiting_[job];
  try {
    grade();
  } catch (const Interrupted&) {
    withdraw();
    throw;
  } catch (const SlurmError& error) {
    if (record_.arrays().empty()) throw BookError(error.what());
    throw BookError(std::string(error.what()) +
                    ". What is in the queue goes on; the same command takes it over");
  }
  return std::move(troubles_);
}

void SlurmEngine::grade() {
  take_over();
  std::vector<Job> unheld;
  for (const auto& [job, task] : waiting_) {
    if (!task) unheld.push_back(job);
  }
  submit(unheld);
  while (!waiting_.empty()) {
    pause();
    ask_queue();
    collect(false);
    end_late();
    submit(settle());
  }
  wait_for_rest();
  forget_arrays();
}

void SlurmEngine::watch(const SlurmArrayRecord& array,
                        const std::vector<std::vector<Job>>& slices) {
  for (std::size_t index = 0; index < slices.size(); ++index) {
    Task task;
    task.array = array.name;
    task.job = array.job;
    task.index = static_cast<int>(index);
    task.state = {"PENDING", ""};
    task.results_before = results_;
    task.quiet_clock = FairClock(max_between_looks);
    for (const Job& job : slices[index]) {
      const auto found = waiting_.find(job);
      // The same unit may have been asked for alone since.
      if (found == waiting_.end() || found->first.alone != job.alone) continue;
      task.jobs.push_back(job);
      found->second = tasks_.size();
    }
    tasks_.push_back(std::move(task));
  }
}

void SlurmEngine::submit(const std::vector<Job>& jobs) {
  for (const bool alone : {false, true}) {
    std::vector<Job> chosen;
    for (const Job& job : jobs) {
      if (job.alone == alone) chosen.push_back(job);
    }
    if (!chosen.empty())
      submit_array(cut_into_slices(chosen, failures_, max_tasks_, commands_.options()), alone);
  }
}

void SlurmEngine::submit_array(const std::vector<std::vector<Job>>& slices, bool alone) {
  std::size_t count = 0;
  for (const std::vector<Job>& slice : slices) {
    count += slice.size();
    // So that no machine remembers that there was no such folder.
    for (const Job& job : slice) fs::create_directories(folder_.unit_file(job).parent_path());
  }
  const std::string name = record_.add(slices).name;
  const fs::path script = record_.slices(name) / "task.sh";
  write_text(script, slurm_task_script);
  SlurmArray array;
  array.name = name;
  array.command = {script.string(), record_.slices(name).string()};
  array.command.insert(array.command.end(), setting_.worker.begin(), setting_.worker.end());
  array.tasks = static_cast<int>(slices.size());
  array.exclusive = alone;
  array.memory_mb = setting_.memory_mb;
  std::string job;
  try {
    job = commands_.submit(array);
  } catch (const SlurmError&) {
    // The controller may have taken it and been too busy to say so.
    job = commands_.find(name).value_or("");
    if (job.empty()) {
      record_.remove(name, false);
      throw;
    }
  }
  record_.submitted(name, job);
  watch({name, job}, slices);
  setting_.note("Slurm job " + job + ": " + count_of(count, "unit") + " in " +
                count_of(slices.size(), "task") + (alone ? ", each with a node to itself." : "."));
}

// Seldom enough not to be a burden on the controller of a long run.
void SlurmEngine::pause() {
  const double running = Duration(Clock::now() - began_).count();
  const Duration interval{std::clamp(running / 30.0, 1.0, 10.0)};
  const Clock::time_point start = Clock::now();
  while (Clock::now() - start < interval) {
    loop_.poll();
    uv_sleep(50);
  }
}

void SlurmEngine::ask_queue() {
  std::set<std::string> jobs;
  for (const Task& task : tasks_) {
    if (!task.ended) jobs.insert(task.job);
  }
  if (jobs.empty()) return;
  SlurmQueue queue;
  try {
    queue = commands_.queue({jobs.begin(), jobs.end()});
  } catch (const SlurmError& error) {
    if (!silent_since_) {
      silent_since_ = Clock::now();
      setting_.note(std::string(error.what()) + ". It is asked again.");
    }
    if (Clock::now() - *silent_since_ > silence) throw;
    return;
  }
  for (Task& task : tasks_) {
    if (task.ended) continue;
    const auto found = queue.find({task.job, task.index});
    task.state = found != queue.end() ? found->second : forgotten(task);
    if (found == queue.end() || !task.state.live()) task.ended = Clock::now();
  }
  if (silent_since_) setting_.note("Slurm answers again.");
  silent_since_.reset();
}

// A task that runs and whose worker says nothing for longer than a unit may take hangs, and its
// worker does not end it: it may be stopped, or its node be in trouble.
void SlurmEngine::end_late() {
  for (Task& task : tasks_) {
    if (task.ended || task.late) continue;
    if (task.state.state != "RUNNING") {
      task.quiet_clock.pause();
      continue;
    }
    const double now = task.quiet_clock.tick();
    std::error_code error;
    const std::uintmax_t size = fs::file_size(record_.log(task.array, task.index), error);
    const std::uintmax_t told = error ? 0 : size;
    if (told != task.told) {
      task.told = told;
      task.quiet_since = now;
    }
    double may_take = told == 0 ? starting : 0.0;
    for (const Job& job : waiting_in(task))
      may_take = std::max(may_take, setting_.time(job) + after_its_own);
    if (may_take == 0.0 || now - task.quiet_since <= may_take) continue;
    task.late = true;
    setting_.note("Task " + task.job + "_" + std::to_string(task.index) +
                  " of Slurm takes longer than a unit may, and is cancelled.");
    try {
      commands_.cancel({task.job + "_" + std::to_string(task.index)});
    } catch (const SlurmError&) {
      // The controller does not answer; the next look finds the task as late as this one.
      task.late = false;
    }
  }
}

// How a task ended that the queue has no more.
SlurmTask SlurmEngine::forgotten(const Task& task) {
  if (const auto accounted = commands_.accounted(task.job, task.index)) return *accounted;
  // What has run stays in the queue for minutes. What has not goes at once when it is cancelled, or
  // if a controller was restarted that did not know of it yet.
  if (task.state.state == "PENDING" && !silent_since_) return {"CANCELLED", ""};
  return {"", ""};
}

// Looks for results. Folders are listed rather than files asked for: a shared file system may
// remember for long that a file was not there.
void SlurmEngine::collect(bool all) {
  std::map<fs::path, std::vector<Job>> folders;
  std::set<fs::path> stale;
  for (const auto& [job, holder] : waiting_) {
    const fs::path folder = folder_.unit_file(job).parent_path();
    const bool held = holder.has_value();
    if (!all && (!held || tasks_[*holder].state.state == "PENDING")) continue;
    folders[folder].push_back(job);
    if (all || (held && tasks_[*holder].ended)) stale.insert(folder);
  }
  for (const auto& [folder, jobs] : folders) {
    if (stale.contains(folder)) refresh(folder);
    const std::set<std::string> names = names_in(folder);
    for (const Job& job : jobs) {
      if (!names.contains(folder_.unit_file(job).filename().string())) continue;
      if (!setting_.has_result(job)) continue;
      waiting_.erase(job);
      ++results_;
      finished_(job);
    }
  }
}

std::vector<Job> SlurmEngine::waiting_in(const Task& task) const {
  const std::size_t index = static_cast<std::size_t>(&task - tasks_.data());
  std::vector<Job> jobs;
  for (const Job& job : task.jobs) {
    const auto found = waiting_.find(job);
    if (found != waiting_.end() && found->second == index) jobs.push_back(job);
  }
  return jobs;
}

// What is to be submitted again, of tasks that ended before their work was done.
std::vector<Job> SlurmEngine::settle() {
  std::vector<Job> again;
  std::vector<std::string> ends;
  for (Task& task : tasks_) {
    if (task.settled || !task.ended) continue;
    const std::vector<Job> left = waiting_in(task);
    if (!left.empty() && Clock::now() - *task.ended < patience) continue;
    task.settled = true;
    if (left.empty()) continue;
    const std::vector<Job> of_task = lost(task, left);
    again.insert(again.end(), of_task.begin(), of_task.end());
    ends.push_back(end_of(task));
  }
  if (!again.empty())
    setting_.note(
        ends.front() +
        (ends.size() > 1 ? ", and so did " + count_of(ends.size() - 1, "other task") : "") + "; " +
        count_of(again.size(), "unit") + (again.size() == 1 ? " is" : " are") +
        " submitted again.");
  return again;
}

// The rest of a task is submitted again, but not without limit.
std::vector<Job> SlurmEngine::lost(const Task& task, const std::vector<Job>& jobs) {
  const bool barren = results_ == task.results_before;
  const std::map<Job, SlurmTrouble> told = troubles_in(record_.log(task.array, task.index));
  // A worker takes its orders in turn: if it did not end itself, it was at the first unit that has
  // no result and of which it has said nothing.
  const bool ended_itself =
      std::any_of(told.begin(), told.end(), [](const auto& one) { return one.second.out_of_time; });
  const auto at =
      std::find_if(jobs.begin(), jobs.end(), [&](const Job& job) { return !told.contains(job); });
  std::vector<Job> again;
  for (const Job& job : jobs) {
    // A job that was cancelled by hand is not submitted again.
    if (task.state.state == "CANCELLED" && !task.late) {
      give_up(job, end_of(task) + ". It was cancelled from outside");
      continue;
    }
    const auto found = told.find(job);
    const bool said = found != told.end();
    const bool ended_here = !said && !ended_itself && at != jobs.end() && &job == &*at;
    const bool hung = ended_here && task.late;
    if (said || ended_here)
      failures_[job] += hung || (said && found->second.out_of_time) ? tries_out_of_time : 1;
    if (failures_[job] >= max_tries) {
      give_up(job, said   ? found->second.what
                   : hung ? out_of_time_words(setting_.time(job))
                          : end_of(task));
      continue;
    }
    barren_[job] = barren ? barren_[job] + 1 : 0;
    if (barren_[job] >= max_tries) {
      give_up(job, "nothing gets done on the cluster: " + end_of(task) +
                       ". Every node must see the results' folder and this program's under the "
                       "same path, and have what `contact doctor` asks for");
      continue;
    }
    waiting_[job].reset();
    again.push_back(job);
  }
  return again;
}

void SlurmEngine::give_up(const Job& job, const std::string& why) {
  troubles_.push_back({job, why});
  waiting_.erase(job);
}

// How a task ended, and the last that it said besides its events.
std::string SlurmEngine::end_of(const Task& task) const {
  const std::string end =
      "task " + task.job + "_" + std::to_string(task.index) + " of Slurm " +
      (task.state.state.empty() ? "is gone from the queue" : "ended as " + task.state.state);
  const std::string last = last_words(record_.log(task.array, task.index));
  if (last.empty()) return end;
  return end + " (it said last: " + last + ")";
}

// A worker that has written its last result still has to end.
void SlurmEngine::wait_for_rest() {
  const Clock::time_point start = Clock::now();
  const auto running = [](const Task& task) { return !task.ended; };
  while (std::any_of(tasks_.begin(), tasks_.end(), running) &&
         Clock::now() - start < 2 * patience) {
    ask_queue();
    if (std::any_of(tasks_.begin(), tasks_.end(), running)) pause();
  }
}

}  // namespace contact::grading
