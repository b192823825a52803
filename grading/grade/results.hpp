#pragma once

// RESULTS/results.json, "contact-grade/1": every mark of a run, from which all reports are made.

#include <map>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "intake.hpp"
#include "run_state.hpp"

namespace contact::grading {

/// What is known of one exercise of one submission before anything is graded.
enum class Standing {
  missing,    ///< no file answers to it
  untouched,  ///< the file is as the book gives it
  refused,    ///< there is a file, and it cannot be taken
  handed_in   ///< to be graded
};

/// The submissions of a run and what each holds.
struct Class {
  Intake intake;
  std::map<Job, Standing> standings;
  /// SHA-256 of the text of what is handed in.
  std::map<Job, std::string> codes;

  [[nodiscard]] Standing standing(const Job& job) const;
};

/// Everything that a run's results are made of.
struct Graded {
  const Class& of;
  const Run& run;
  const RunFolder& folder;
  /// With their private tests.
  const std::vector<Exercise>& exercises;
  /// {"level", "measures"}
  const nlohmann::json& machine;
  std::string version;
};

/// @throws BookError if a unit that must be there is not
nlohmann::json results_json(const Graded& graded);

struct Summary {
  int submissions = 0;
  int graded = 0;   ///< submissions that were not refused whole
  int refused = 0;  ///< submissions
  int refused_files = 0;
  double mean = 0.0;  ///< points of those that were not refused
  double max_points = 0.0;
};
Summary summary_of(const nlohmann::json& results);
nlohmann::json to_json(const Summary& summary);

}  // namespace contact::grading
