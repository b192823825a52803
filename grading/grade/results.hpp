#pragma once

// RESULTS/results.json, "contact-grade/2": every mark of a run, from which all reports are made. A
// unit that could not be graded has no points (null), and neither has its submission: no sum can
// take that for a zero.

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
  handed_in,  ///< to be graded
  not_graded  ///< handed in, and it could not be graded for a reason that is not the student's
};

/// The submissions of a run and what each holds.
struct Class {
  Intake intake;
  std::map<Job, Standing> standings;
  /// SHA-256 of the text of what is handed in.
  std::map<Job, std::string> codes;
  /// Why what is not graded could not be.
  std::map<Job, std::string> troubles;

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
  int not_graded = 0;  ///< units that could not be graded
  /// Points of those that were not refused and have a mark for everything.
  double mean = 0.0;
  int in_mean = 0;  ///< of how many that is the mean
  double max_points = 0.0;
};
Summary summary_of(const nlohmann::json& results);
nlohmann::json to_json(const Summary& summary);

}  // namespace contact::grading
