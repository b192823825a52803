#include "slurm.hpp"

#include <algorithm>
#include <fstream>
#include <utility>

#include "sha256.hpp"
#include "unit_time.hpp"

namespace fs = std::filesystem;

namespace contact::grading {

namespace {

using Names = std::vector<std::string>;
using Duration = std::chrono::duration<double>;

// A worker ends itself if a unit outlives its time, unless it cannot: then its task is cancelled
// from here, this much later. A shared folder may show late what a worker has done.
constexpr double after_its_own = 20.0;
// Seconds of a task that runs until its worker says that it is ready.
constexpr double starting = 600.0;
// The queue is asked more often than this; a longer step was one in which this program was stopped.
constexpr double most_between_looks = 20.0;
// A shared folder may show a file some seconds after it was written elsewhere.
constexpr Duration patience{5.0};
// Controllers are restarted now and then; jobs go on meanwhile.
constexpr Duration silence{600.0};
// Tasks that are cancelled have Slurm's KillWait to end, which is 30 seconds if unset.
constexpr Duration cancelling{120.0};
// Without a limit on tasks at a time, units are cut as if for so many.
constexpr std::size_t assumed_tasks = 32;
constexpr std::size_t most_units_a_task = 64;

// The units of a task follow each other in one worker. The script is the same for every run; what
// it needs comes as arguments, so that no path is ever read by a shell.
constexpr const char* task_script = R"(#!/bin/sh
# A task of a job array of `contact grade`: SLICES WORKER... grades the units of its slice.
slice=$1/$SLURM_ARRAY_TASK_ID.tsv
log=$1/$SLURM_ARRAY_TASK_ID.log
shift
# A shared folder may show the slice here later than where it was written.
tries=0
until [ -r "$slice" ] || [ "$tries" -ge 30 ]; do
  tries=$((tries + 1))
  sleep 1
done
exec > "$log" 2>&1
# Folders of tasks that were killed with all that belonged to them.
folders=${TMPDIR:-/tmp}/contact-grade-slurm
for old in "$folders"-*; do
  pid=${old#"$folders"-}
  kill -0 "${pid%%-*}" 2> /dev/null || rm -rf "$old"
done
# The worker removes its folder itself, unless it is killed. When the task is to end, it is told so
# too, and waited for.
temporary=$(mktemp -d "$folders-$$-XXXXXX") || exit 1
# Where boxes have no view of files of their own, their users must get through.
chmod 711 "$temporary"
trap 'rm -rf "$temporary"' EXIT
trap : HUP INT TERM
"$@" --temporary "$temporary" --parent "$$" < "$slice"
)";

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
    most_tasks_ = commands_.most_tasks();
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
    const SlurmQueue queue = commands_.queue(job.empty() ? Names{} : Names{job});
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
  Names jobs;
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

void SlurmEngine::watch(const SlurmArrayRecord& array,
                        const std::vector<std::vector<Job>>& slices) {
  for (std::size_t index = 0; index < slices.size(); ++index) {
    Task task;
    task.array = array.name;
    task.job = array.job;
    task.index = static_cast<int>(index);
    task.state = {"PENDING", ""};
    task.results_before = results_;
    task.quiet_clock = FairClock(most_between_looks);
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
    if (!chosen.empty()) submit_array(cut(chosen), alone);
  }
}

// A job at which a task ended goes by itself, so that it takes no other with it again.
std::vector<std::vector<Job>> SlurmEngine::cut(const std::vector<Job>& jobs) const {
  std::vector<std::vector<Job>> slices;
  std::vector<Job> rest;
  for (const Job& job : jobs) {
    const auto found = failures_.find(job);
    if (found != failures_.end() && found->second > 0 &&
        slices.size() + 1 < static_cast<std::size_t>(most_tasks_))
      slices.push_back({job});
    else
      rest.push_back(job);
  }
  if (rest.empty()) return slices;
  const std::size_t places = static_cast<std::size_t>(most_tasks_) - slices.size();
  const SlurmOptions& options = commands_.options();
  std::size_t size = static_cast<std::size_t>(options.units_a_task);
  if (size == 0) {
    const std::size_t tasks = options.tasks_at_a_time > 0
                                  ? static_cast<std::size_t>(options.tasks_at_a_time)
                                  : assumed_tasks;
    // Some four a task at a time, so that the last ones end together.
    size =
        std::clamp((rest.size() + 4 * tasks - 1) / (4 * tasks), std::size_t{1}, most_units_a_task);
  }
  size = std::max(size, (rest.size() + places - 1) / places);
  for (std::size_t begin = 0; begin < rest.size(); begin += size) {
    const std::size_t end = std::min(begin + size, rest.size());
    slices.emplace_back(rest.begin() + static_cast<std::ptrdiff_t>(begin),
                        rest.begin() + static_cast<std::ptrdiff_t>(end));
  }
  return slices;
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
  write_text(script, task_script);
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

// What is left of a task goes into the queue again, but not for ever.
std::vector<Job> SlurmEngine::lost(const Task& task, const std::vector<Job>& jobs) {
  const bool barren = results_ == task.results_before;
  const std::map<Job, Told> told = troubles_of(task);
  // A worker takes its orders in turn: if it did not end itself, it was at the first unit that has
  // no result and of which it has said nothing.
  const bool ended_itself =
      std::any_of(told.begin(), told.end(), [](const auto& one) { return one.second.out_of_time; });
  const auto at =
      std::find_if(jobs.begin(), jobs.end(), [&](const Job& job) { return !told.contains(job); });
  std::vector<Job> again;
  for (const Job& job : jobs) {
    // Whoever cancels a job does not want it submitted again.
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
    if (failures_[job] >= most_tries) {
      give_up(job, said   ? found->second.what
                   : hung ? out_of_time_words(setting_.time(job))
                          : end_of(task));
      continue;
    }
    barren_[job] = barren ? barren_[job] + 1 : 0;
    if (barren_[job] >= most_tries) {
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

// The units that a worker could not grade, and what it said about each.
std::map<Job, SlurmEngine::Told> SlurmEngine::troubles_of(const Task& task) const {
  std::map<Job, Told> troubles;
  std::ifstream stream(record_.log(task.array, task.index));
  for (std::string line; std::getline(stream, line);) {
    const nlohmann::json said = nlohmann::json::parse(line, nullptr, false);
    if (said.is_object() && said.value("event", "") == "trouble")
      troubles[{said.value("submission", ""), said.value("exercise", "")}] = {
          said.value("what", "it does not say why"), said.value("out_of_time", false)};
  }
  return troubles;
}

// How a task ended, and the last that it said besides its events.
std::string SlurmEngine::end_of(const Task& task) const {
  constexpr std::size_t most = 300;
  const std::string end =
      "task " + task.job + "_" + std::to_string(task.index) + " of Slurm " +
      (task.state.state.empty() ? "is gone from the queue" : "ended as " + task.state.state);
  std::ifstream stream(record_.log(task.array, task.index));
  std::string last;
  for (std::string line; std::getline(stream, line);) {
    if (!line.empty() && !nlohmann::json::accept(line)) last = std::move(line);
  }
  if (last.empty()) return end;
  if (last.size() > most) last = "..." + last.substr(last.size() - most);
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
