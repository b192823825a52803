#include "coordinator.hpp"

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdlib>
#include <deque>
#include <map>
#include <memory>
#include <optional>

#include <fcntl.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include "unit_time.hpp"
#include "watchdog.hpp"

namespace fs = std::filesystem;

namespace contact::grading {

namespace {

/// Seconds that a worker has to end its boxes and to clean up.
constexpr double grace = 5.0;
/// A worker sees itself that a unit outlives its time, unless it cannot: then it is ended from
/// here, this much later.
constexpr double after_its_own = 2.0;
/// Seconds that a worker has until it is ready for its first unit.
constexpr double starting = 300.0;
/// How often workers' times are looked at, in milliseconds.
constexpr std::uint64_t look = 250;

fs::path machine_file(const RunFolder& folder) { return folder.grade() / "machine.json"; }

// One worker, what it has to do and what it has said so far.
class Worker {
 public:
  Worker(Loop& loop, const RunFolder& folder) : temporary_(folder) {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw BookError("cannot make a pipe for a worker");
    orders_ = ends[1];
    ProcessSpec spec;
    // This very program, also if its file is replaced meanwhile.
    spec.command = {"/proc/" + std::to_string(::getpid()) + "/exe",
                    "grade-worker",
                    folder.run_file().string(),
                    "--temporary",
                    temporary_.path().string(),
                    "--parent",
                    std::to_string(::getpid()),
                    "--machine",
                    machine_file(folder).string()};
    spec.folder = folder.grade();
    spec.descriptors = {{ends[0], 0}};
    spec.grace = grace;
    spec.output_limit = 64u << 10;
    spec.on_output = [this](std::string_view text) { heard_ += text; };
    try {
      process_ = std::make_unique<Process>(loop, std::move(spec));
    } catch (...) {
      ::close(ends[0]);
      ::close(orders_);
      throw;
    }
    ::close(ends[0]);
  }
  ~Worker() { no_more(); }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// The next whole line that it said.
  std::optional<std::string> line() {
    const std::size_t end = heard_.find('\n');
    if (end == std::string::npos) return {};
    std::string text = heard_.substr(0, end);
    heard_.erase(0, end + 1);
    return text;
  }
  void give(const Job& job, double seconds) {
    job_ = job;
    may_take_ = clock_.tick() + seconds + after_its_own;
    const std::string order = order_of(job) + "\n";
    // Far shorter than a pipe holds. If the worker is gone, its end is told in its own time.
    if (::write(orders_, order.data(), order.size()) < 0) return;
  }
  void no_more() {
    if (orders_ >= 0) ::close(orders_);
    orders_ = -1;
  }
  Process& process() { return *process_; }

  /// What it has begun takes longer than it may. Its time does not count while this program is
  /// stopped.
  bool late() {
    const double now = clock_.tick();
    return (!ready || job_ || leaves) && !process_->ended() && now > may_take_;
  }
  /// It ends by itself now, and gets nothing more to do.
  void let_go() {
    leaves = true;
    may_take_ = clock_.tick() + grace;
  }

  bool ready = false;
  /// It was ended because it was late.
  bool ended_late = false;
  /// It will end by itself and gets nothing more to do.
  bool leaves = false;
  std::optional<Job> take_job() { return std::exchange(job_, std::nullopt); }
  [[nodiscard]] const std::optional<Job>& job() const { return job_; }

 private:
  /// Where its boxes are made.
  NotedFolder temporary_;
  std::string heard_;
  std::optional<Job> job_;
  FairClock clock_;
  double may_take_ = starting;
  int orders_ = -1;
  std::unique_ptr<Process> process_;
};

std::string how_it_ended(const ProcessResult& result) {
  std::string text = result.signal != 0
                         ? "signal " + std::to_string(result.signal) + " ended the worker"
                         : "the worker ended with code " + std::to_string(result.exit_code);
  std::string said = result.errors;
  while (!said.empty() && said.back() == '\n') said.pop_back();
  return said.empty() ? text : text + ": " + said;
}

// Calls on the loop again and again, the first time a while from now.
class Timer {
 public:
  Timer(Loop& loop, std::uint64_t first, std::uint64_t again, std::function<void()> call)
      : loop_(loop), call_(std::move(call)) {
    uv_timer_init(loop.get(), &timer_);
    timer_.data = this;
    uv_timer_start(
        &timer_, [](uv_timer_t* timer) { static_cast<Timer*>(timer->data)->call_(); }, first,
        again);
  }
  ~Timer() {
    bool closed = false;
    timer_.data = &closed;
    uv_close(reinterpret_cast<uv_handle_t*>(&timer_),
             [](uv_handle_t* handle) { *static_cast<bool*>(handle->data) = true; });
    while (!closed) uv_run(loop_.get(), UV_RUN_NOWAIT);
  }
  Timer(const Timer&) = delete;
  Timer& operator=(const Timer&) = delete;

 private:
  Loop& loop_;
  std::function<void()> call_;
  uv_timer_t timer_{};
};

// Gives the jobs out and keeps as many workers as there is work for.
class Crew {
 public:
  Crew(Loop& loop, const RunFolder& folder, int most, const std::vector<Job>& jobs,
       const TimeOfJob& time, const std::function<void(const Job&)>& finished)
      : loop_(loop),
        folder_(folder),
        most_(static_cast<std::size_t>(most)),
        waiting_(jobs.begin(), jobs.end()),
        time_(time),
        finished_(finished) {}

  std::vector<JobTrouble> run() {
    try {
      const Timer looks(loop_, look, look, [] {});
      while (!waiting_.empty() || under_way() > 0) {
        hire();
        loop_.run_once();
        attend();
      }
    } catch (...) {
      dismiss();
      throw;
    }
    dismiss();
    return std::move(troubles_);
  }

 private:
  [[nodiscard]] std::size_t under_way() const {
    return static_cast<std::size_t>(
        std::count_if(workers_.begin(), workers_.end(),
                      [](const auto& worker) { return worker->job().has_value(); }));
  }

  void hire() {
    try {
      while (workers_.size() < most_ && workers_.size() < waiting_.size() + under_way())
        workers_.push_back(std::make_unique<Worker>(loop_, folder_));
    } catch (const std::exception&) {
      // Fewer do the work too, if there are any.
      if (workers_.empty()) throw;
      most_ = workers_.size();
    }
  }

  void attend() {
    for (const std::unique_ptr<Worker>& worker : workers_) {
      while (const std::optional<std::string> line = worker->line()) hear(*worker, *line);
      if (worker->process().ended()) {
        bury(*worker);
      } else if (worker->late()) {
        worker->ended_late = worker->leaves = true;
        worker->process().end(Ended::time);
      } else if (worker->ready && !worker->leaves && !worker->job() && !waiting_.empty()) {
        worker->give(waiting_.front(), time_(waiting_.front()));
        waiting_.pop_front();
      }
    }
    std::erase_if(workers_, [](const auto& worker) { return worker->process().ended(); });
  }

  void hear(Worker& worker, const std::string& line) {
    const nlohmann::json json = nlohmann::json::parse(line, nullptr, false);
    const std::string event = json.is_object() ? json.value("event", "") : "";
    if (event == "ready") {
      worker.ready = true;
      any_was_ready_ = true;
      failed_starts_ = 0;
    }
    if (event != "finished" && event != "trouble") return;
    const std::optional<Job> job = worker.take_job();
    if (!job) return;
    if (event == "finished") {
      finished_(*job);
      return;
    }
    const bool out_of_time = json.value("out_of_time", false);
    if (out_of_time) worker.let_go();
    give_again(*job, json.value("what", "it does not say why"),
               out_of_time ? tries_out_of_time : 1);
  }

  void bury(Worker& worker) {
    const ProcessResult result = worker.process().wait();
    if (const std::optional<Job> job = worker.take_job()) {
      if (worker.ended_late)
        give_again(*job, out_of_time_words(time_(*job)), tries_out_of_time);
      else
        give_again(*job, how_it_ended(result), 1);
    } else if (!worker.ready && ++failed_starts_ >= max_tries) {
      std::string said = result.errors;
      while (!said.empty() && said.back() == '\n') said.pop_back();
      if (const std::size_t colon = said.find(": "); said.starts_with("contact:"))
        said = said.substr(colon + 2);
      if (said.empty()) said = "no worker can be started: " + how_it_ended(result);
      if (!any_was_ready_) throw BookError(said);
      // Others have worked here: what they did counts, and the rest is told one by one.
      for (const Job& left : waiting_) troubles_.push_back({left, said});
      waiting_.clear();
    }
  }

  void give_again(const Job& job, const std::string& why, int counts) {
    if ((tries_[job] += counts) < max_tries)
      waiting_.push_front(job);
    else
      troubles_.push_back({job, why});
  }

  // Ends what still runs, and waits until it is gone.
  void dismiss() {
    for (const std::unique_ptr<Worker>& worker : workers_) {
      worker->no_more();
      if (worker->job() || !worker->ready) worker->process().end(Ended::time);
    }
    const Timer deadline(loop_, static_cast<std::uint64_t>(1000.0 * grace), 0, [this] {
      for (const std::unique_ptr<Worker>& worker : workers_) worker->process().end(Ended::time);
    });
    while (std::any_of(workers_.begin(), workers_.end(),
                       [](const auto& worker) { return !worker->process().ended(); }))
      uv_run(loop_.get(), UV_RUN_ONCE);
    workers_.clear();
  }

  Loop& loop_;
  const RunFolder& folder_;
  std::size_t most_;
  std::deque<Job> waiting_;
  const TimeOfJob& time_;
  const std::function<void(const Job&)>& finished_;
  std::vector<std::unique_ptr<Worker>> workers_;
  std::map<Job, int> tries_;
  std::vector<JobTrouble> troubles_;
  /// Since the last worker that got ready.
  int failed_starts_ = 0;
  bool any_was_ready_ = false;
};

}  // namespace

std::vector<JobTrouble> LocalEngine::run(const std::vector<Job>& jobs,
                                         const std::function<void(const Job&)>& finished) {
  write_text(machine_file(folder_), machine_for_workers(machine_).dump() + "\n");
  std::vector<JobTrouble> troubles;
  std::vector<Job> beside;
  std::vector<Job> alone;
  for (const Job& job : jobs) (job.alone ? alone : beside).push_back(job);
  for (const auto& [some, most] : {std::pair(&beside, workers_), std::pair(&alone, 1)}) {
    if (some->empty()) continue;
    for (JobTrouble& trouble : Crew(loop_, folder_, most, *some, time_, finished).run())
      troubles.push_back(std::move(trouble));
  }
  return troubles;
}

NotedFolder::NotedFolder(const RunFolder& folder) {
  std::string pattern = (fs::temp_directory_path() / "contact-grade-XXXXXX").string();
  if (::mkdtemp(pattern.data()) == nullptr)
    throw BookError("cannot make a folder in " + fs::temp_directory_path().string());
  path_ = pattern;
  // Boxes of another user id find their own folder in it, and see no name.
  fs::permissions(path_, fs::perms::owner_all | fs::perms::group_exec | fs::perms::others_exec);
  note_ = folder.grade() / "temporary" / path_.filename();
  fs::create_directories(note_.parent_path());
  write_text(note_, path_.string());
}

NotedFolder::~NotedFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
  fs::remove(note_, ignored);
}

TemporaryPlace::TemporaryPlace(const fs::path& path) {
  if (const char* before = std::getenv("TMPDIR")) before_ = before;
  ::setenv("TMPDIR", path.c_str(), 1);
}

TemporaryPlace::~TemporaryPlace() {
  if (before_)
    ::setenv("TMPDIR", before_->c_str(), 1);
  else
    ::unsetenv("TMPDIR");
}

void remove_left_behind(const RunFolder& folder) {
  std::error_code error;
  for (const fs::directory_entry& note :
       fs::directory_iterator(folder.grade() / "temporary", error)) {
    const fs::path path = read_text(note.path());
    std::error_code ignored;
    if (path.is_absolute() && path.filename().string().starts_with("contact-grade-"))
      fs::remove_all(path, ignored);
    fs::remove(note.path(), ignored);
  }
}

}  // namespace contact::grading
