#pragma once

// What a run of grading keeps in RESULTS/.grade, so that one that was killed goes on where it was:
//
//   RUN.json                          what is graded and how; a worker needs nothing else
//   submissions/ID/NN_slug/NAME.cpp   what was taken in
//   units/ID/NN_slug.NAME.json        a unit's result, with the key that says of what
//   log                               a line when a worker begins a unit and when it has finished
//   it lock                              held by the coordinator temporary folders elsewhere that a
//   killed run may have left

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "engine.hpp"
#include "private_tests.hpp"
#include "unit.hpp"

namespace contact::grading {

/// What a unit's result depends on, each as a SHA-256 in hexadecimal.
struct UnitKey {
  std::string code;
  std::string tests;
  std::string seed;
  std::string limits;
  std::string grader;
  friend bool operator==(const UnitKey&, const UnitKey&) = default;
};

/// The members that differ, by their names in JSON: "tests", "seed", "limits", "code", "grader".
std::vector<std::string> differences(const UnitKey& a, const UnitKey& b);

nlohmann::json to_json(const UnitKey& key);
UnitKey key_from_json(const nlohmann::json& json);

struct RunSubmission {
  std::string id;
  std::filesystem::path folder;
};

/// RUN.json, "contact-grade-run/1".
struct Run {
  std::filesystem::path root;
  /// The book's folder if `root` is a pack's, else the same.
  std::filesystem::path book_root;
  std::filesystem::path build;
  std::filesystem::path results;
  std::string seed;
  GradeLimits limits;
  bool accept_weak = false;
  /// What a test of each exercise may take at least, whatever its solution takes.
  std::map<std::string, double> min_seconds;
  /// Seconds of processor time that a test of each exercise may take.
  std::map<std::string, double> test_seconds;
  /// Seconds of elapsed time that a unit of each exercise may take, as unit_time.hpp declares them.
  std::map<std::string, double> unit_seconds;
  /// Of each exercise, all of the key but its code.
  std::map<std::string, UnitKey> keys;
  PrivateTests private_tests;
  std::vector<std::string> exercises;
  std::vector<RunSubmission> submissions;
};

nlohmann::json to_json(const Run& run);
/// @throws BookError if the file is missing or not understood.
Run read_run(const std::filesystem::path& file);

/// A unit's file, "contact-grade-unit/1".
struct Unit {
  std::string submission;
  std::string exercise;
  UnitKey key;
  bool gradable = false;
  /// Its time was too near its limit to be believed, unless it was run alone since.
  bool near_limit = false;
  int reruns = 0;
  double seconds = 0.0;
  nlohmann::json verdict;

  [[nodiscard]] bool believed() const { return !near_limit || reruns > 0; }
};

/// Where all of it lies.
class RunFolder {
 public:
  explicit RunFolder(std::filesystem::path results) : results_(std::move(results)) {}

  [[nodiscard]] const std::filesystem::path& results() const { return results_; }
  [[nodiscard]] std::filesystem::path grade() const { return results_ / ".grade"; }
  [[nodiscard]] std::filesystem::path run_file() const { return grade() / "RUN.json"; }
  [[nodiscard]] std::filesystem::path submission(const std::string& id) const {
    return grade() / "submissions" / id;
  }
  [[nodiscard]] std::filesystem::path text_file(const Job& job) const;
  [[nodiscard]] std::filesystem::path unit_file(const Job& job) const;

  /// A unit's result; nothing if there is none or it was cut off.
  [[nodiscard]] std::optional<Unit> unit(const Job& job) const;
  void write_unit(const Unit& unit) const;
  /// Adds a line to the log: what, the job, and this process.
  void log(const std::string& what, const Job& job) const;

 private:
  std::filesystem::path results_;
};

/// Makes RESULTS and holds it, so that one coordinator works in it at a time.
class RunLock {
 public:
  /// @throws BookError if the folder holds something else's files or another coordinator has it.
  explicit RunLock(const RunFolder& folder);
  ~RunLock();
  RunLock(const RunLock&) = delete;
  RunLock& operator=(const RunLock&) = delete;

 private:
  int descriptor_ = -1;
};

/// What a coordinator found out about its machine, for its workers on the same machine, which need
/// not try it all again.
nlohmann::json machine_for_workers(const Machine& machine);
/// @throws nlohmann::json::exception if it is not what machine_for_workers() makes
Machine machine_from_coordinator(const nlohmann::json& json);

/// As write_text(), and there after a power cut.
void write_durably(const std::filesystem::path& file, std::string_view text);

/// A verdict as in `check --json`, but times are in "times", so that the rest is the same each
/// time.
nlohmann::json verdict_without_times(nlohmann::json verdict);

/// 128 random bits in hexadecimal.
std::string drawn_seed();

}  // namespace contact::grading
