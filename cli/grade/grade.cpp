// contact grade: marks a folder of submissions by people whom nobody need trust. What a submission
// may do is in grading/sandbox, how it is asked in grading/grade; here is the order of things.

#include <algorithm>
#include <array>
#include <atomic>
#include <exception>
#include <future>
#include <set>
#include <thread>

#include <unistd.h>
#include <nlohmann/json.hpp>

#include "../../grading/grade/calibrate.hpp"
#include "../../grading/grade/coordinator.hpp"
#include "../../grading/grade/profile.hpp"
#include "../../grading/grade/regrade.hpp"
#include "../../grading/grade/results.hpp"
#include "../../grading/grade/run_keys.hpp"
#include "../../grading/grade/sha256.hpp"
#include "../../grading/grade/slurm.hpp"
#include "../../grading/grade/unit_time.hpp"
#include "../../grading/grade/watchdog.hpp"
#include "../../grading/progress/progress.hpp"
#include "../../grading/text/shown_text.hpp"
#include "../commands.hpp"
#include "../terminal/terminal.hpp"
#include "grade_report.hpp"

namespace fs = std::filesystem;

namespace contact::cli {

namespace {

using grading::Book;
using grading::BookError;
using grading::Exercise;
using grading::Job;
using grading::RunFolder;

struct Options {
  std::string submissions;
  std::string results;
  std::vector<std::string> exercises;
  std::string ids;
  int workers = 0;
  std::string engine = "local";
  std::string seed;
  std::string private_tests;
  std::string profile;
  std::string due;
  std::vector<std::string> formats;
  std::string autograder;
  bool accept_weak = false;
  bool recalibrate = false;
  bool json = false;
  grading::SlurmOptions slurm;
};

// --- What is asked for
// --------------------------------------------------------------------------------------

bool lies_in(const fs::path& inner, const fs::path& outer) {
  const fs::path relative =
      fs::weakly_canonical(inner).lexically_relative(fs::weakly_canonical(outer));
  return !relative.empty() && *relative.begin() != "..";
}

void require_apart(const fs::path& submissions, const fs::path& results) {
  if (!fs::is_directory(submissions))
    throw grading::UnknownName("there is no folder of submissions " + submissions.string());
  if (lies_in(results, submissions) || lies_in(submissions, results))
    throw grading::UnknownName("the results, " + results.string() + ", and the submissions, " +
                               submissions.string() +
                               ", must lie apart: what is written would be graded");
}

fs::path python_of(const Book& book) {
  const fs::path own = book.root() / "build" / "venv" / "bin" / "python";
  std::error_code error;
  const bool there = fs::exists(own, error);
  if (error)
    throw BookError("the Python that writes the reports cannot be reached (" + own.string() + ": " +
                    error.message() +
                    "): grade as a user who may, or run ./contact setup as the one who grades");
  if (!there)
    throw BookError("the Python that writes the reports is not there (" + own.string() +
                    "): run ./contact setup");
  return own;
}

// --- Limits of time
// --------------------------------------------------------------------------------------

double least_test_seconds(const Exercise& exercise, const grading::GradeLimits& limits) {
  return limits.test_cpu_seconds > 0.0 ? limits.test_cpu_seconds : exercise.time_limit;
}

// What an earlier run of the same folder found, under the limits of now; nothing if it does not say
// enough.
std::optional<double> kept_seconds(const grading::Run& before, const std::string& exercise,
                                   double least) {
  const auto old_least = before.least_seconds.find(exercise);
  const auto old = before.test_seconds.find(exercise);
  if (old_least == before.least_seconds.end() || old == before.test_seconds.end()) return {};
  // The solution's time stood for the limit, or is known to be short enough for a longer one.
  if (old->second > old_least->second) return std::max(least, old->second);
  if (least >= old_least->second) return least;
  return {};
}

// --- One grading
// --------------------------------------------------------------------------------------

class Grading {
 public:
  Grading(Context& context, const Options& options)
      : options_(options),
        loop_(context.loop()),
        book_(context.book()),
        folder_(fs::absolute(options.results).lexically_normal()),
        style_(stdout) {}

  int run() {
    start_ = grading::now_utc();
    prepare();
    const std::set<std::string> ids = look();
    build();
    const grading::RunLock lock(folder_);
    require_same_class(ids);
    grading::remove_left_behind(folder_);
    set_up();
    take_in();
    calibrate();
    keep_run();
    grade();
    return finish();
  }

 private:
  // What can be wrong with the command itself, before anything is made or waited for.
  void prepare() {
    const fs::path submissions = fs::absolute(options_.submissions).lexically_normal();
    require_apart(submissions, folder_.results());
    exercises_ = book_.chosen(options_.exercises);
    if (exercises_.empty()) throw BookError("the book has no exercises");
    if (!options_.profile.empty()) run_.limits = grading::read_profile(options_.profile);
    if (!options_.ids.empty()) ids_.emplace(options_.ids);
  }

  grading::Intake intake(const std::function<void(const grading::Entrant&)>& keep) const {
    return grading::take_in(book_, options_.submissions, ids_ ? &*ids_ : nullptr,
                            exercises_.size() == 1 ? exercises_.front() : nullptr, keep);
  }

  // Whose submissions these are. All is read once before anything is made of it: a wrong folder or
  // table of ids would else leave a class of zeros.
  std::set<std::string> look() const {
    const grading::Intake found = intake([](const grading::Entrant&) {});
    if (found.entrants.empty())
      throw grading::UnknownName("there is no submission in " + options_.submissions);
    const std::string mistake = grading::mistaken_for_submissions(found, options_.submissions);
    if (!mistake.empty()) throw BookError(mistake);
    std::set<std::string> ids;
    for (const grading::Entrant& entrant : found.entrants) ids.insert(entrant.id);
    return ids;
  }

  void require_same_class(const std::set<std::string>& ids) const {
    const std::optional<nlohmann::json> earlier = grading::earlier_results(folder_);
    if (earlier && grading::of_another_class(*earlier, ids))
      throw BookError(
          folder_.results().string() + " holds marks, and none of them is of a submission in " +
          options_.submissions +
          ". Is this another class? Then give another folder with -o. Nothing is graded");
  }

  // While it is seen to that the exercises are built, Python starts.
  void build() {
    std::future<void> reports = std::async(std::launch::async, [this] { require_reports(); });
    build_ = grading::current_build(loop_, book_, exercises_);
    reports.get();
  }

  // What everything is graded with.
  void set_up() {
    if (fs::exists(folder_.run_file())) before_ = grading::read_run(folder_.run_file());
    machine_ = grading::examine_machine(loop_);
    if (machine_.level == grading::Level::none && !options_.accept_weak)
      throw BookError(
          "this machine cannot keep a submission apart from everything else; `contact doctor` says "
          "what is missing. Nothing is graded. With --accept-weak it would be, and every report "
          "would say so");
    if (machine_.level != grading::Level::full)
      note(style_.warn("This machine enforces less than it should (" +
                       std::string(grading::words(machine_.level)) +
                       "); `contact doctor` says what, and so do the reports."));
    run_.root = book_.root();
    run_.build = book_.build_dir();
    run_.results = folder_.results();
    run_.accept_weak = options_.accept_weak;
    run_.seed = !options_.seed.empty() ? options_.seed
                : before_              ? before_->seed
                                       : grading::drawn_seed();
    if (!options_.private_tests.empty())
      run_.private_tests = grading::load_private_tests(
          loop_, book_, build_, machine_,
          {fs::absolute(options_.private_tests), fs::absolute(options_.submissions),
           folder_.grade() / "private", options_.accept_weak});
    for (const Exercise* exercise : exercises_) {
      run_.exercises.push_back(exercise->id());
      with_private_.push_back(grading::with_private_tests(*exercise, run_.private_tests));
    }
  }

  void take_in() {
    class_.intake = intake([this](const grading::Entrant& entrant) { keep(entrant); });
    for (const grading::Entrant& entrant : class_.intake.entrants) {
      if (entrant.problem.empty())
        run_.submissions.push_back({entrant.id, folder_.submission(entrant.id)});
    }
    if (!class_.intake.passed_over.empty())
      note("Passed over, as nobody's submission: " + listed(class_.intake.passed_over));
    if (!class_.intake.absent.empty())
      note("Named in " + options_.ids + " and not there: " + listed(class_.intake.absent));
  }

  static std::string listed(const std::vector<std::string>& names) {
    constexpr std::size_t most = 10;
    std::string text;
    for (std::size_t i = 0; i < names.size() && i < most; ++i)
      text += (i == 0 ? "" : ", ") + grading::escaped(names[i]);
    return names.size() > most ? text + " and " + std::to_string(names.size() - most) + " more"
                               : text;
  }

  // Nothing if it cannot be read, which is no reason to grade nobody.
  static std::optional<std::string> readable_text(const fs::path& file) {
    try {
      return grading::read_text(file);
    } catch (const BookError&) {
      return {};
    }
  }

  // A text that gives way to another was handed in once, so it is kept.
  void keep(const grading::Entrant& entrant) {
    for (const Exercise* exercise : exercises_) {
      const Job job{entrant.id, exercise->id()};
      const fs::path file = folder_.text_file(job);
      const auto found = entrant.files.find(job.exercise);
      const bool taken = found != entrant.files.end() && found->second.problem.empty();
      const bool there = fs::exists(file);
      const std::optional<std::string> before = there ? readable_text(file) : std::nullopt;
      const bool same = taken && before && *before == found->second.text;
      if (there && !same) {
        const fs::path as = fs::path("submissions") / job.submission / (job.exercise + ".cpp");
        if (before)
          earlier_.keep(file, as);
        else
          earlier_.put_away(file, as);
        if (!taken) fs::remove(file);
      }
      if (found == entrant.files.end()) continue;
      if (!taken) {
        class_.standings[job] = grading::Standing::refused;
        continue;
      }
      const std::string& text = found->second.text;
      const bool untouched = text == grading::read_text(exercise->stub);
      class_.standings[job] =
          untouched ? grading::Standing::untouched : grading::Standing::handed_in;
      class_.codes[job] = grading::sha256(text);
      if (same) continue;
      fs::create_directories(file.parent_path());
      grading::write_text(file, text);
    }
  }

  // What a test may take, from what the book's own solutions take here. That is measured once for a
  // folder of results, so that a regrade compares like with like.
  void calibrate() {
    const grading::RunKeys keys(loop_, build_);
    std::vector<Solution> solutions;
    for (const Exercise& exercise : with_private_) {
      const std::string id = exercise.id();
      Solution solution{&exercise, {}, {}};
      solution.settings.seed = run_.seed;
      solution.settings.limits = run_.limits;
      const grading::PrivateExercise* more = run_.private_tests.of(id);
      if (more != nullptr) solution.settings.more_tests.push_back(more->program);
      run_.least_seconds[id] = least_test_seconds(exercise, run_.limits);
      if (before_ && !options_.recalibrate)
        solution.seconds = kept_seconds(*before_, id, run_.least_seconds[id]);
      if (solution.seconds) {
        settle(keys, solution);
        // Its solution is known to get full marks under all that a unit depends on.
        if (before_->keys.count(id) != 0 && before_->keys.at(id) == run_.keys[id]) continue;
      }
      solutions.push_back(std::move(solution));
    }
    if (solutions.empty()) return;
    note("Grading the book's own solutions, to see what they take here ...");
    measure(solutions);
    for (const Solution& solution : solutions) settle(keys, solution);
  }

  // One exercise's solution, and the seconds that a test may take, once they are known.
  struct Solution {
    const Exercise* exercise;
    grading::UnitSettings settings;
    std::optional<double> seconds;
  };

  void settle(const grading::RunKeys& keys, const Solution& solution) {
    const std::string id = solution.exercise->id();
    run_.test_seconds[id] = *solution.seconds;
    grading::UnitSettings settings = solution.settings;
    settings.test_cpu_seconds = *solution.seconds;
    run_.unit_seconds[id] = grading::declared_seconds(*solution.exercise, settings);
    run_.keys[id] = keys.of(*solution.exercise, run_.private_tests.of(id), run_.seed, run_.limits,
                            *solution.seconds);
  }

  // Nothing can end a thread that hangs, so the whole program ends. Boxes end with it, and the next
  // run removes their folder.
  [[noreturn]] static void end_out_of_time(const std::string& what) {
    if (::write(STDERR_FILENO, what.data(), what.size()) < 0) {
      // Nobody reads it; the exit code says that nothing was graded.
    }
    ::_exit(exit_trouble);
  }

  // Several at a time, each thread with a loop and a seat of its own. The first in the book's order
  // that went wrong is told.
  void measure(std::vector<Solution>& solutions) const {
    const grading::NotedFolder temporary(folder_);
    const grading::TemporaryPlace place(temporary.path());
    std::vector<std::exception_ptr> wrong(solutions.size());
    std::atomic<std::size_t> next{0};
    grading::Watchdog watchdog(end_out_of_time);
    const auto work = [&] {
      std::size_t at = next++;
      try {
        grading::Loop loop;
        const grading::Seat seat(machine_);
        for (; at < solutions.size(); at = next++) {
          Solution& solution = solutions[at];
          const double may_take =
              grading::calibrating_seconds(*solution.exercise, solution.settings);
          const grading::Watchdog::Watch watch(
              watchdog, may_take,
              "contact: the book's own solution of " + solution.exercise->id() +
                  " cannot be graded here, so nothing is: " + grading::out_of_time_words(may_take) +
                  "\n");
          const double measured = grading::calibrate(loop, book_, build_, machine_, seat,
                                                     *solution.exercise, solution.settings);
          if (!solution.seconds) solution.seconds = measured;
        }
      } catch (...) {
        if (at < wrong.size()) wrong[at] = std::current_exception();
        next = solutions.size();
      }
    };
    {
      std::vector<std::jthread> threads;
      const auto count =
          std::min<std::size_t>(static_cast<std::size_t>(workers_here()), solutions.size());
      for (std::size_t i = 0; i < count; ++i) threads.emplace_back(work);
    }
    for (const std::exception_ptr& one : wrong) {
      if (one) std::rethrow_exception(one);
    }
  }

  // From here on a run that is killed goes on where it was.
  void keep_run() {
    grading::write_durably(folder_.run_file(), grading::to_json(run_).dump(1) + "\n");
  }

  grading::UnitKey key_of(const Job& job) const {
    grading::UnitKey key = run_.keys.at(job.exercise);
    key.code = class_.codes.at(job);
    return key;
  }

  bool has_result(const Job& job) const {
    const std::optional<grading::Unit> unit = folder_.unit(job);
    return unit && unit->key == key_of(job) && (!job.alone || unit->reruns > 0);
  }

  std::vector<Job> handed_in() const {
    std::vector<Job> jobs;
    for (const grading::RunSubmission& submission : run_.submissions) {
      for (const std::string& exercise : run_.exercises) {
        Job job{submission.id, exercise};
        if (class_.standing(job) == grading::Standing::handed_in) jobs.push_back(std::move(job));
      }
    }
    return jobs;
  }

  int workers_here() const {
    const int cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    const bool given = options_.workers > 0 && options_.engine == "local";
    return std::min(given ? options_.workers : cores, std::max(1, machine_.most_workers));
  }

  std::unique_ptr<grading::Engine> engine() {
    if (options_.engine == "slurm") {
      grading::SlurmSetting setting;
      setting.worker = {grading::own_program().string(), "grade-worker",
                        folder_.run_file().string()};
      setting.memory_mb = run_.limits.memory_mb + run_.limits.compile_memory_mb;
      setting.time = [this](const Job& job) { return run_.unit_seconds.at(job.exercise); };
      setting.has_result = [this](const Job& job) { return has_result(job); };
      setting.note = [this](const std::string& text) {
        if (progress_)
          progress_->say_beside(text);
        else
          note(text);
      };
      grading::SlurmOptions slurm = options_.slurm;
      slurm.tasks_at_a_time = options_.workers;
      return std::make_unique<grading::SlurmEngine>(loop_, folder_, slurm, std::move(setting));
    }
    const int workers = workers_here();
    if (workers < options_.workers)
      note("Only " + std::to_string(workers) +
           " at a time: on this machine more would share a quota, and marks would vary.");
    return std::make_unique<grading::LocalEngine>(
        loop_, folder_, machine_, workers,
        [this](const Job& job) { return run_.unit_seconds.at(job.exercise); });
  }

  void grade() {
    // It first ends what another run has on a cluster, which could still write results.
    const std::unique_ptr<grading::Engine> engine = this->engine();
    engine_ = engine->name();
    workers_ = engine->workers();
    const std::vector<Job> all = handed_in();
    std::vector<Job> jobs;
    std::copy_if(all.begin(), all.end(), std::back_inserter(jobs),
                 [this](const Job& job) { return !has_result(job); });
    reused_ = all.size() - jobs.size();
    if (reused_ > 0)
      note(std::to_string(reused_) + " of " + std::to_string(all.size()) +
           " units are graded already.");
    graded_by(*engine, jobs);

    // A time that comes near its limit beside others is only believed of a unit that ran alone.
    std::vector<Job> again;
    for (Job job : all) {
      if (!has_result(job) || folder_.unit(job)->believed()) continue;
      job.alone = true;
      again.push_back(std::move(job));
    }
    if (!again.empty())
      note(std::to_string(again.size()) + (again.size() == 1 ? " unit was" : " units were") +
           " near a limit of time: once more, alone ...");
    graded_by(*engine, again);

    for (const Job& job : all) {
      if (has_result(job) && folder_.unit(job)->believed()) {
        class_.troubles.erase(job);
        continue;
      }
      class_.standings[job] = grading::Standing::not_graded;
      class_.troubles.emplace(job, "its result is gone from " + folder_.grade().string());
    }
  }

  void graded_by(grading::Engine& engine, const std::vector<Job>& jobs) {
    if (jobs.empty()) return;
    progress_.emplace(jobs.size(), jobs.front().alone ? 1 : engine.workers());
    const auto finished = [this](const Job& job) {
      ++(job.alone ? alone_ : graded_);
      progress_->finished(job);
    };
    try {
      for (const grading::JobTrouble& trouble : engine.run(jobs, finished))
        class_.troubles[trouble.job] = trouble.what;
      progress_.reset();
    } catch (...) {
      progress_.reset();
      throw;
    }
  }

  void tell_troubles() const {
    for (const auto& [job, what] : class_.troubles)
      note(style_.bad("contact: ") + printable(job.submission) + ", " + job.exercise +
           " could not be graded: " + printable(what));
    const bool one = class_.troubles.size() == 1;
    note(std::string(one ? "That is" : "Those are") +
         " not the student's fault and no mark: reports leave it empty. All other marks are "
         "written. Once the cause is mended, this grades what is missing and nothing else:\n  " +
         command_again(book_.root()));
  }

  // The weakest of the machines that graded a part.
  nlohmann::json machine_json() const {
    nlohmann::json weakest = grading::to_json(machine_);
    std::error_code error;
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry :
         fs::directory_iterator(folder_.grade() / "machines", error))
      files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    for (const fs::path& file : files) {
      const nlohmann::json other = nlohmann::json::parse(grading::read_text(file), nullptr, false);
      if (!other.is_object()) continue;
      const auto rank = [](const nlohmann::json& machine) {
        const std::string level = machine.at("level").get<std::string>();
        return level == "full" ? 2 : level == "reduced" ? 1 : 0;
      };
      if (rank(other) < rank(weakest)) weakest["level"] = other.at("level");
      for (const nlohmann::json& measure : other.at("measures")) {
        for (nlohmann::json& own : weakest["measures"]) {
          if (own.at("what") == measure.at("what") && !measure.at("enforced").get<bool>())
            own = measure;
        }
      }
    }
    return weakest;
  }

  int finish() {
    const nlohmann::json machine = machine_json();
    const nlohmann::json results =
        grading::results_json({class_, run_, folder_, with_private_, machine, CONTACT_VERSION});
    const std::optional<nlohmann::json> changes =
        grading::write_results(folder_, results, earlier_);
    try {
      write_reports();
    } catch (const BookError&) {
      if (!class_.troubles.empty()) tell_troubles();
      throw;
    }
    const grading::Summary summary = grading::summary_of(results);
    write_record(summary);
    tell(results, summary, changes);
    if (!class_.troubles.empty()) {
      tell_troubles();
      return exit_trouble;
    }
    return summary.refused + summary.refused_files > 0 ? exit_not_passed : exit_passed;
  }

  nlohmann::json units_json() const {
    return {{"graded", graded_}, {"reused", reused_}, {"alone", alone_}};
  }

  nlohmann::json troubles_json() const {
    nlohmann::json troubles = nlohmann::json::array();
    for (const auto& [job, what] : class_.troubles)
      troubles.push_back(
          {{"submission", job.submission}, {"exercise", job.exercise}, {"problem", what}});
    return troubles;
  }

  void write_record(const grading::Summary& summary) {
    std::array<char, 256> host{};
    ::gethostname(host.data(), host.size() - 1);
    nlohmann::json record = {
        {"format", "contact-grade-record/1"},
        {"version", CONTACT_VERSION},
        {"submissions", fs::absolute(options_.submissions).lexically_normal().string()},
        {"started", start_},
        {"finished", grading::now_utc()},
        {"engine", engine_},
        {"workers", workers_},
        {"host", host.data()},
        {"counts", grading::to_json(summary)},
        {"units", units_json()}};
    if (!earlier_.place().empty()) record["earlier"] = earlier_.place().string();
    grading::write_text(folder_.results() / "run.json", record.dump(1) + "\n");
  }

  std::vector<std::string> report_options() const {
    std::vector<std::string> words;
    if (!options_.formats.empty()) {
      std::string list;
      for (const std::string& format : options_.formats) list += (list.empty() ? "" : ",") + format;
      words.insert(words.end(), {"--formats", list});
    }
    if (!options_.due.empty()) words.insert(words.end(), {"--due", options_.due});
    if (!class_.troubles.empty()) words.push_back("--again=" + command_again(book_.root()));
    return words;
  }

  grading::ProcessResult reports(grading::Loop& loop, const fs::path& of) const {
    grading::ProcessSpec spec;
    spec.command = {python_of(book_).string(), "-m", "reports", of.string()};
    const std::vector<std::string> more = report_options();
    spec.command.insert(spec.command.end(), more.begin(), more.end());
    spec.folder = book_.root();
    spec.environment = {{"PYTHONPATH", (book_.root() / "grading").string()},
                        {"PYTHONDONTWRITEBYTECODE", "1"}};
    return grading::run_process(loop, spec);
  }

  // The reports can be written, and what they are asked for is understood, now or not at all: where
  // there are no results, all that they do is say so.
  void require_reports() const {
    grading::Loop loop;
    const grading::TemporaryFolder empty;
    const grading::ProcessResult result = reports(loop, empty.path());
    constexpr int not_understood = 2;
    constexpr int no_results = 3;
    if (result.exit_code == not_understood) throw grading::UnknownName(last_line(result.errors));
    if (result.exit_code != no_results)
      throw BookError("the Python that writes the reports, " + python_of(book_).string() +
                      ", does not do so (" +
                      (result.errors.empty() ? "it says nothing" : last_line(result.errors)) +
                      "): run ./contact setup");
  }

  void write_reports() {
    const grading::ProcessResult result = reports(loop_, folder_.results());
    if (!result.succeeded())
      throw BookError("the marks are in " + (folder_.results() / "results.json").string() +
                      ", but the reports could not be written: " + result.errors);
  }

  static std::string last_line(std::string text) {
    while (!text.empty() && text.back() == '\n') text.pop_back();
    const std::size_t start = text.rfind('\n');
    text = start == std::string::npos ? text : text.substr(start + 1);
    const std::size_t error = text.find("error: ");
    return error == std::string::npos ? text : text.substr(error + 7);
  }

  void tell(const nlohmann::json& results, const grading::Summary& summary,
            const std::optional<nlohmann::json>& changes) {
    if (options_.json) {
      nlohmann::json document = grading::to_json(summary);
      document["format"] = "contact-grade-summary/1";
      document["results"] = folder_.results().string();
      document["machine"] = results.at("machine");
      document["units"] = units_json();
      document["could_not_be_graded"] = troubles_json();
      if (!class_.troubles.empty()) document["again"] = command_again(book_.root());
      if (changes) document["changes"] = changes->at("changes");
      say(document.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
      return;
    }
    say(grade_summary(results, summary, style_));
    if (const std::string refused = refusals(results); !refused.empty())
      say(style_.bad("Refused:") + "\n" + refused);
    if (changes) say(changes_table(*changes, style_));
    if (!earlier_.place().empty()) say("The earlier results: " + shown(earlier_.place()));
    say("Seed: " + run_.seed + ". Reports: " + shown(folder_.results() / "class.html") + ", " +
        shown(folder_.results() / "gradebook.csv") + ", " + shown(folder_.results() / "students") +
        "/");
  }

  const Options& options_;
  grading::Loop& loop_;
  const Book& book_;
  RunFolder folder_;
  Style style_;
  std::string start_;
  std::vector<const Exercise*> exercises_;
  std::vector<Exercise> with_private_;
  std::optional<grading::IdTable> ids_;
  std::optional<grading::Run> before_;
  grading::Run run_;
  grading::BuildDescription build_;
  grading::Machine machine_;
  grading::Class class_;
  grading::Earlier earlier_{folder_};
  std::optional<GradeProgress> progress_;
  std::string engine_;
  int workers_ = 0;
  std::size_t reused_ = 0;
  std::size_t graded_ = 0;
  std::size_t alone_ = 0;
};

// Packs this book and what is asked for into an archive that a school's system grades with. The
// reports' Python does it, which also runs there.
int pack_autograder(Context& context, const Options& options) {
  const Book& book = context.book();
  grading::ProcessSpec spec;
  spec.command = {python_of(book).string(), "-m", "reports.autograder",
                  fs::absolute(options.autograder).lexically_normal().string()};
  const auto give = [&](const std::string& name, const std::string& value) {
    if (!value.empty()) spec.command.insert(spec.command.end(), {name, value});
  };
  std::string exercises;
  if (!options.exercises.empty()) {
    for (const Exercise* exercise : book.chosen(options.exercises))
      exercises += (exercises.empty() ? "" : ",") + exercise->id();
  }
  const auto file = [](const std::string& name) {
    return name.empty() ? name : fs::absolute(name).lexically_normal().string();
  };
  give("--exercises", exercises);
  give("--private", file(options.private_tests));
  give("--profile", file(options.profile));
  give("--seed", options.seed);
  give("--due", options.due);
  if (options.accept_weak) spec.command.emplace_back("--accept-weak");
  spec.folder = book.root();
  spec.environment = {{"CONTACT_ROOT", book.root().string()},
                      {"PYTHONPATH", (book.root() / "grading").string()},
                      {"PYTHONDONTWRITEBYTECODE", "1"}};
  const grading::ProcessResult result = grading::run_process(context.loop(), spec);
  std::string words = result.errors;
  while (!words.empty() && words.back() == '\n') words.pop_back();
  note(words);
  return result.exit_code;
}

int run(Context& context, const Options& options) {
  if (!options.autograder.empty()) return pack_autograder(context, options);
  try {
    return Grading(context, options).run();
  } catch (const grading::Interrupted&) {
    note("Stopped. What is graded is kept: the same command goes on where it was.");
    throw;
  }
}

}  // namespace

void add_grade(Command app, Action& action) {
  auto options = std::make_shared<Options>();
  const Command command = app.add_subcommand(grade_command);
  const Option submissions =
      command.add_option("submissions", options->submissions,
                         "A folder; each entry is a student's folder, .zip, .tar.gz or .cpp");
  const Option output =
      command.add_option("-o,--output", options->results,
                         "Folder for the results; run again with the same to go on or to regrade");
  command
      .add_option("--exercises", options->exercises,
                  "Exercises or chapters, separated by commas; all of the book if not given")
      .separated_by(',');
  command.add_option("--ids", options->ids,
                     "CSV with columns entry and id, and name if you like: who handed in what");
  command.add_option("--workers", options->workers, "Units at a time; one a core if not given")
      .between(1, 1024);
  command.add_option("--engine", options->engine, "local (this machine) or slurm (a cluster)")
      .one_of({"local", "slurm"});
  command.add_option(
      "--seed", options->seed,
      "Seed of the random cases; the folder's own if not given, drawn the first time");
  command.add_option("--private", options->private_tests,
                     "Folder of tests that are not in the book");
  command.add_option("--profile", options->profile, "TOML file that sets limits");
  command.add_option("--due", options->due,
                     "When work is due: what is shown after that stays hidden before");
  command.add_option("--formats", options->formats, "Reports to write; all if not given")
      .separated_by(',');
  command
      .add_option("--autograder", options->autograder,
                  "Grade nothing: write FILE.zip, an autograder for Gradescope or PrairieLearn")
      .excludes(submissions)
      .excludes(output);
  command.add_flag("--accept-weak", options->accept_weak,
                   "Grade although this machine cannot keep submissions apart");
  command.add_flag("--recalibrate", options->recalibrate,
                   "Measure the solutions' time anew, and with it the limits of time");
  command.add_flag("--json", options->json, "Print JSON");
  command.add_option("--partition", options->slurm.partition, "Slurm: the partition");
  command.add_option("--account", options->slurm.account, "Slurm: the account");
  command.add_option("--time", options->slurm.time, "Slurm: a task's time limit");
  command.add_option("--units-a-task", options->slurm.units_a_task, "Slurm: units in one task");
  command.add_option("--slurm-options", options->slurm.more, "Slurm: more options of sbatch");
  command.callback([&action, options] {
    if (options->autograder.empty() && options->submissions.empty())
      throw MissingOption("submissions");
    if (options->autograder.empty() && options->results.empty()) throw MissingOption("--output");
    action = [options](Context& context) { return run(context, *options); };
  });
}

}  // namespace contact::cli
