#include "session.hpp"

#include <algorithm>
#include <array>
#include <future>
#include <thread>

#include <unistd.h>

#include "../progress/progress.hpp"
#include "coordinator.hpp"
#include "intake_texts.hpp"
#include "machines.hpp"
#include "profile.hpp"
#include "run_keys.hpp"
#include "slurm.hpp"
#include "solution_times.hpp"

namespace fs = std::filesystem;

namespace contact::grading {

namespace {

bool lies_in(const fs::path& inner, const fs::path& outer) {
  const fs::path relative =
      fs::weakly_canonical(inner).lexically_relative(fs::weakly_canonical(outer));
  return !relative.empty() && *relative.begin() != "..";
}

void require_apart(const fs::path& submissions, const fs::path& results) {
  if (!fs::is_directory(submissions))
    throw UnknownName("there is no folder of submissions " + submissions.string());
  if (lies_in(results, submissions) || lies_in(submissions, results))
    throw UnknownName("the results, " + results.string() + ", and the submissions, " +
                      submissions.string() + ", must lie apart: what is written would be graded");
}

fs::path absolute(const std::string& given) { return fs::absolute(given).lexically_normal(); }

}  // namespace

Session::Session(Loop& loop, const Book& book, const SessionSettings& settings,
                 SessionListener& listener)
    : loop_(loop),
      book_(book),
      settings_(settings),
      listener_(listener),
      folder_(absolute(settings.results)),
      reports_(book, settings.reports) {}

const SessionOutcome& Session::grade() {
  start_ = now_utc();
  prepare();
  const std::set<std::string> ids = look();
  build();
  lock_.emplace(folder_);
  require_same_class(ids);
  remove_left_behind(folder_);
  set_up();
  take_in();
  calibrate();
  // From here on a run that is killed goes on where it was.
  write_durably(folder_.run_file(), to_json(run_).dump(1) + "\n");
  grade_all();
  write_results();
  return outcome_;
}

// --- What is asked for
// --------------------------------------------------------------------------------------

// What can be wrong with the command itself, before anything is made or waited for.
void Session::prepare() {
  require_apart(absolute(settings_.submissions), folder_.results());
  exercises_ = book_.chosen(settings_.exercises);
  if (exercises_.empty()) throw BookError("the book has no exercises");
  if (!settings_.profile.empty()) run_.limits = read_profile(settings_.profile);
  if (!settings_.ids.empty()) ids_.emplace(settings_.ids);
}

Intake Session::intake(const std::function<void(const Entrant&)>& keep) const {
  return grading::take_in(book_, settings_.submissions, ids_ ? &*ids_ : nullptr,
                          exercises_.size() == 1 ? exercises_.front() : nullptr, keep);
}

// Whose submissions these are. All is read once before anything is made of it: a wrong folder or
// table of ids would else leave a class of zeros.
std::set<std::string> Session::look() const {
  const Intake found = intake([](const Entrant&) {});
  if (found.entrants.empty())
    throw UnknownName("there is no submission in " + settings_.submissions);
  const std::string mistake = mistaken_for_submissions(found, settings_.submissions);
  if (!mistake.empty()) throw BookError(mistake);
  std::set<std::string> ids;
  for (const Entrant& entrant : found.entrants) ids.insert(entrant.id);
  return ids;
}

void Session::require_same_class(const std::set<std::string>& ids) const {
  const std::optional<nlohmann::json> earlier = earlier_results(folder_);
  if (earlier && of_another_class(*earlier, ids))
    throw BookError(folder_.results().string() +
                    " holds marks, and none of them is of a submission in " +
                    settings_.submissions +
                    ". Is this another class? Then give another folder with -o. Nothing is graded");
}

// --- What everything is graded with
// --------------------------------------------------------------------------------------

// While it is seen to that the exercises are built, Python starts.
void Session::build() {
  std::future<void> reports = std::async(std::launch::async, [this] { reports_.require(); });
  build_ = current_build(loop_, book_, exercises_);
  reports.get();
}

void Session::set_up() {
  if (fs::exists(folder_.run_file())) before_ = read_run(folder_.run_file());
  machine_ = examine_machine(loop_);
  if (machine_.level == Level::none && !settings_.accept_weak)
    throw BookError(
        "this machine cannot isolate a submission; `contact doctor` says "
        "what is missing. Nothing is graded. With --accept-weak it would be, and every report "
        "would say so");
  if (machine_.level != Level::full) listener_.on_weak_machine(machine_.level);
  run_.root = book_.root();
  run_.book_root = book_.book_root();
  run_.build = book_.build_dir();
  run_.results = folder_.results();
  run_.accept_weak = settings_.accept_weak;
  run_.seed = !settings_.seed.empty() ? settings_.seed : before_ ? before_->seed : drawn_seed();
  if (!settings_.private_tests.empty())
    run_.private_tests = load_private_tests(
        loop_, book_, build_, machine_,
        {fs::absolute(settings_.private_tests), fs::absolute(settings_.submissions),
         folder_.grade() / "private", settings_.accept_weak});
  for (const Exercise* exercise : exercises_) {
    run_.exercises.push_back(exercise->id());
    with_private_.push_back(with_private_tests(*exercise, run_.private_tests));
  }
}

void Session::take_in() {
  class_.intake = intake([this](const Entrant& entrant) {
    keep_texts(entrant, exercises_, folder_, earlier_, class_);
  });
  for (const Entrant& entrant : class_.intake.entrants) {
    if (entrant.problem.empty())
      run_.submissions.push_back({entrant.id, folder_.submission(entrant.id)});
  }
  if (!class_.intake.passed_over.empty()) listener_.on_passed_over(class_.intake.passed_over);
  if (!class_.intake.absent.empty()) listener_.on_absent(class_.intake.absent);
}

void Session::calibrate() {
  const Run* before = before_ && !settings_.recalibrate ? &*before_ : nullptr;
  set_times(loop_,
            {book_, build_, machine_, folder_, with_private_, before, workers_here(),
             [this] { listener_.on_measuring(); },
             [this](const std::string& what) { listener_.on_hang(what); }},
            run_);
}

// --- Grading
// --------------------------------------------------------------------------------------

bool Session::has_result(const Job& job) const {
  const std::optional<Unit> unit = folder_.unit(job);
  if (!unit || (job.alone && unit->reruns == 0)) return false;
  UnitKey key = run_.keys.at(job.exercise);
  key.code = class_.codes.at(job);
  return unit->key == key;
}

std::vector<Job> Session::handed_in() const {
  std::vector<Job> jobs;
  for (const RunSubmission& submission : run_.submissions) {
    for (const std::string& exercise : run_.exercises) {
      Job job{submission.id, exercise};
      if (class_.standing(job) == Standing::handed_in) jobs.push_back(std::move(job));
    }
  }
  return jobs;
}

int Session::workers_here() const {
  const int cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  const bool given = settings_.workers > 0 && settings_.engine == "local";
  return std::min(given ? settings_.workers : cores, std::max(1, machine_.max_workers));
}

std::unique_ptr<Engine> Session::local_engine() {
  const int workers = workers_here();
  if (workers < settings_.workers) listener_.on_fewer_workers(workers);
  return std::make_unique<LocalEngine>(loop_, folder_, machine_, workers, [this](const Job& job) {
    return run_.unit_seconds.at(job.exercise);
  });
}

std::unique_ptr<Engine> Session::slurm_engine() {
  SlurmSetting setting;
  setting.worker = {own_program().string(), "grade-worker", folder_.run_file().string()};
  setting.memory_mb = run_.limits.memory_mb + run_.limits.compile_memory_mb;
  setting.time = [this](const Job& job) { return run_.unit_seconds.at(job.exercise); };
  setting.has_result = [this](const Job& job) { return has_result(job); };
  setting.note = [this](const std::string& text) { listener_.on_note(text); };
  SlurmOptions slurm = settings_.slurm;
  slurm.tasks_at_a_time = settings_.workers;
  return std::make_unique<SlurmEngine>(loop_, folder_, slurm, std::move(setting));
}

void Session::grade_all() {
  // It first ends what another run has on a cluster, which could still write results.
  const std::unique_ptr<Engine> engine =
      settings_.engine == "slurm" ? slurm_engine() : local_engine();
  engine_ = engine->name();
  workers_ = engine->workers();
  const std::vector<Job> all = handed_in();
  std::vector<Job> jobs;
  std::copy_if(all.begin(), all.end(), std::back_inserter(jobs),
               [this](const Job& job) { return !has_result(job); });
  outcome_.reused = all.size() - jobs.size();
  if (outcome_.reused > 0) listener_.on_reused(outcome_.reused, all.size());
  graded_by(*engine, jobs);

  // A time that comes near its limit beside others is only believed of a unit that ran alone.
  std::vector<Job> again;
  for (Job job : all) {
    if (!has_result(job) || folder_.unit(job)->believed()) continue;
    job.alone = true;
    again.push_back(std::move(job));
  }
  if (!again.empty()) listener_.on_once_more(again.size());
  graded_by(*engine, again);

  for (const Job& job : all) {
    if (has_result(job) && folder_.unit(job)->believed()) {
      class_.troubles.erase(job);
      continue;
    }
    class_.standings[job] = Standing::not_graded;
    class_.troubles.emplace(job, "its result is gone from " + folder_.grade().string());
  }
}

void Session::graded_by(Engine& engine, const std::vector<Job>& jobs) {
  if (jobs.empty()) return;
  listener_.on_begin(jobs.size(), jobs.front().alone ? 1 : engine.workers());
  const auto finished = [this](const Job& job) {
    ++(job.alone ? outcome_.alone : outcome_.graded);
    listener_.on_graded(job);
  };
  try {
    for (const JobTrouble& trouble : engine.run(jobs, finished))
      class_.troubles[trouble.job] = trouble.what;
  } catch (...) {
    listener_.on_end();
    throw;
  }
  listener_.on_end();
}

// --- What is written
// --------------------------------------------------------------------------------------

void Session::write_results() {
  const nlohmann::json machine = weakest_machine(machine_, folder_);
  outcome_.results =
      results_json({class_, run_, folder_, with_private_, machine, settings_.version});
  outcome_.changes = grading::write_results(folder_, outcome_.results, earlier_);
  outcome_.summary = summary_of(outcome_.results);
  outcome_.troubles = class_.troubles;
  outcome_.seed = run_.seed;
  outcome_.earlier = earlier_.place();
}

void Session::write_reports() {
  reports_.write(loop_, folder_,
                 class_.troubles.empty() ? std::nullopt : std::optional(settings_.again));
}

void Session::write_record() const {
  std::array<char, 256> host{};
  ::gethostname(host.data(), host.size() - 1);
  nlohmann::json record = {{"format", "contact-grade-record/1"},
                           {"version", settings_.version},
                           {"submissions", absolute(settings_.submissions).string()},
                           {"started", start_},
                           {"finished", now_utc()},
                           {"engine", engine_},
                           {"workers", workers_},
                           {"host", host.data()},
                           {"counts", to_json(outcome_.summary)},
                           {"units", units_json(outcome_)}};
  if (!outcome_.earlier.empty()) record["earlier"] = outcome_.earlier.string();
  write_text(folder_.results() / "run.json", record.dump(1) + "\n");
}

nlohmann::json units_json(const SessionOutcome& outcome) {
  return {{"graded", outcome.graded}, {"reused", outcome.reused}, {"alone", outcome.alone}};
}

}  // namespace contact::grading
