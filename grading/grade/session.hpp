#pragma once

// One grading, from a folder of submissions to results.json and its reports. Nothing is printed
// here: the caller of a session receives its events.

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "engine.hpp"
#include "intake.hpp"
#include "regrade.hpp"
#include "report_writer.hpp"
#include "results.hpp"
#include "run_state.hpp"
#include "slurm_commands.hpp"

namespace contact::grading {

/// What is asked of a session.
struct SessionSettings {
  /// Folders and files as they were given, relative to the present folder or not.
  std::string submissions;
  std::string results;
  std::string ids;
  std::string private_tests;
  std::string profile;
  /// Exercises or chapters; all of the book, if there are none.
  std::vector<std::string> exercises;
  /// Units at a time; 0 chooses.
  int workers = 0;
  /// "local" or "slurm".
  std::string engine = "local";
  SlurmOptions slurm;
  /// The folder's own if empty, drawn the first time.
  std::string seed;
  ReportOptions reports;
  /// Grades although the machine keeps submissions apart from nothing.
  bool accept_weak = false;
  /// Measures the solutions' times again.
  bool recalibrate = false;
  /// The program's, for the results.
  std::string version;
  /// How the same is asked for again, for the reports of what could not be graded.
  std::string again;
};

/// Receives the progress of a session.
class SessionListener {
 public:
  SessionListener() = default;
  virtual ~SessionListener() = default;
  SessionListener(const SessionListener&) = delete;
  SessionListener& operator=(const SessionListener&) = delete;

  /// This machine enforces less than it should.
  virtual void on_weak_machine(Level level) = 0;
  /// Entries that are not submissions.
  virtual void on_passed_over(const std::vector<std::string>& entries) = 0;
  /// Entries that the table of ids names and that are not there.
  virtual void on_absent(const std::vector<std::string>& entries) = 0;
  /// The book's own solutions are graded now.
  virtual void on_measuring() = 0;
  /// Fewer than were asked for: more would share a quota.
  virtual void on_fewer_workers(int workers) = 0;
  /// Units whose results are kept.
  virtual void on_reused(std::size_t units, std::size_t of) = 0;
  /// Units that were near a time limit and are graded again, alone.
  virtual void on_once_more(std::size_t units) = 0;
  /// Units are graded from here to on_end(). @param workers 0 if a cluster decides
  virtual void on_begin(std::size_t units, int workers) = 0;
  virtual void on_graded(const Job& job) = 0;
  virtual void on_end() = 0;
  /// Progress reports of an engine.
  virtual void on_note(const std::string& text) = 0;
  /// A solution hangs, and with it a thread that nothing can end: the process must be ended, from
  /// whatever thread this is called in.
  virtual void on_hang(const std::string& what) = 0;
};

/// What a session found.
struct SessionOutcome {
  nlohmann::json results;  ///< as in results.json
  Summary summary;
  /// Against the results that were there before; nothing if there were none.
  std::optional<nlohmann::json> changes;
  /// What could not be graded, and why.
  std::map<Job, std::string> troubles;
  std::string seed;
  std::size_t graded = 0;
  std::size_t reused = 0;
  std::size_t alone = 0;
  /// Where the results of before are kept; empty if none were.
  std::filesystem::path earlier;
};

/// Holds the folder of results from grade() until it is destroyed.
class Session {
 public:
  /// All of these must outlive it.
  Session(Loop& loop, const Book& book, const SessionSettings& settings, SessionListener& listener);

  [[nodiscard]] const RunFolder& folder() const { return folder_; }
  /// Grades the class and writes results.json. What an earlier session graded already is not graded
  /// again.
  /// @throws UnknownName or BookError, before anything is graded, if what is asked for is wrong or
  /// the machine cannot do it; Interrupted on Ctrl-C: all that was graded is kept
  const SessionOutcome& grade();
  /// After grade(). @throws BookError if they cannot be written
  void write_reports();
  /// After grade(): RESULTS/run.json, what this run was.
  void write_record() const;

 private:
  void prepare();
  [[nodiscard]] Intake intake(const std::function<void(const Entrant&)>& keep) const;
  [[nodiscard]] std::set<std::string> look() const;
  void build();
  void require_same_class(const std::set<std::string>& ids) const;
  void set_up();
  void take_in();
  void calibrate();
  void grade_all();
  void graded_by(Engine& engine, const std::vector<Job>& jobs);
  void write_results();

  [[nodiscard]] bool has_result(const Job& job) const;
  [[nodiscard]] std::vector<Job> handed_in() const;
  [[nodiscard]] int workers_here() const;
  std::unique_ptr<Engine> local_engine();
  std::unique_ptr<Engine> slurm_engine();

  Loop& loop_;
  const Book& book_;
  const SessionSettings& settings_;
  SessionListener& listener_;
  RunFolder folder_;
  ReportWriter reports_;
  std::string start_;
  std::vector<const Exercise*> exercises_;
  std::vector<Exercise> with_private_;
  std::optional<IdTable> ids_;
  std::optional<RunLock> lock_;
  std::optional<Run> before_;
  Run run_;
  BuildDescription build_;
  Machine machine_;
  Class class_;
  Earlier earlier_{folder_};
  std::string engine_;
  int workers_ = 0;
  SessionOutcome outcome_;
};

/// Units by how they came to their marks, for JSON.
nlohmann::json units_json(const SessionOutcome& outcome);

}  // namespace contact::grading
