#include "results.hpp"

#include "profile.hpp"

namespace contact::grading {

namespace {

constexpr const char* results_format = "contact-grade/2";

nlohmann::json exercise_json(const Exercise& exercise) {
  nlohmann::json tests = nlohmann::json::array();
  for (const TestSpec& test : exercise.tests)
    tests.push_back({{"name", test.name},
                     {"points", test.points},
                     {"visibility", key(test.visibility)},
                     {"private", test.is_private}});
  return {{"id", exercise.id()},
          {"title", exercise.title},
          {"objective", exercise.objective},
          {"max_points", exercise.max_points()},
          {"tests", std::move(tests)}};
}

nlohmann::json graded_json(const Graded& graded, const Job& job) {
  std::optional<Unit> unit = graded.folder.unit(job);
  if (!unit) throw BookError("the result of " + order_of(job) + " is gone. Run again to go on");
  return {{"status", "graded"},
          {"gradable", unit->gradable},
          {"points", unit->verdict.at("points")},
          {"key", to_json(unit->key)},
          {"verdict", std::move(unit->verdict)}};
}

nlohmann::json unit_json(const Graded& graded, const Entrant& entrant, const Exercise& exercise) {
  const Job job{entrant.id, exercise.id()};
  nlohmann::json json;
  switch (graded.of.standing(job)) {
    case Standing::handed_in:
      json = graded_json(graded, job);
      break;
    case Standing::missing:
      json = {{"status", "missing"}};
      break;
    case Standing::untouched:
      json = {{"status", "untouched"}};
      break;
    case Standing::not_graded:
      json = {
          {"status", "not_graded"}, {"problem", graded.of.troubles.at(job)}, {"points", nullptr}};
      break;
    case Standing::refused:
      json = {{"status", "refused"}, {"problem", entrant.files.at(exercise.id()).problem}};
      break;
  }
  json["id"] = exercise.id();
  json["max_points"] = exercise.max_points();
  if (!json.contains("points")) json["points"] = 0.0;
  if (!json.contains("gradable")) json["gradable"] = false;
  return json;
}

nlohmann::json submission_json(const Graded& graded, const Entrant& entrant) {
  double points = 0.0;
  bool known = true;
  double max_points = 0.0;
  nlohmann::json exercises = nlohmann::json::array();
  for (const Exercise& exercise : graded.exercises) {
    max_points += exercise.max_points();
    if (!entrant.problem.empty()) continue;
    exercises.push_back(unit_json(graded, entrant, exercise));
    const nlohmann::json& mark = exercises.back()["points"];
    known = known && !mark.is_null();
    if (!mark.is_null()) points += mark.get<double>();
  }
  nlohmann::json json = {{"id", entrant.id},           {"entry", entrant.entry},
                         {"ignored", entrant.ignored}, {"points", nullptr},
                         {"max_points", max_points},   {"exercises", std::move(exercises)}};
  if (known) json["points"] = points;
  if (!entrant.name.empty()) json["name"] = entrant.name;
  if (!entrant.problem.empty()) json["problem"] = entrant.problem;
  return json;
}

}  // namespace

Standing Class::standing(const Job& job) const {
  const auto found = standings.find(job);
  return found == standings.end() ? Standing::missing : found->second;
}

nlohmann::json results_json(const Graded& graded) {
  nlohmann::json exercises = nlohmann::json::array();
  for (const Exercise& exercise : graded.exercises) exercises.push_back(exercise_json(exercise));
  nlohmann::json submissions = nlohmann::json::array();
  for (const Entrant& entrant : graded.of.intake.entrants)
    submissions.push_back(submission_json(graded, entrant));
  return {{"format", results_format},
          {"version", graded.version},
          {"seed", graded.run.seed},
          {"limits", to_json(graded.run.limits)},
          {"machine", graded.machine},
          {"exercises", std::move(exercises)},
          {"submissions", std::move(submissions)}};
}

Summary summary_of(const nlohmann::json& results) {
  Summary summary;
  double points = 0.0;
  for (const nlohmann::json& exercise : results.at("exercises"))
    summary.max_points += exercise.at("max_points").get<double>();
  for (const nlohmann::json& submission : results.at("submissions")) {
    ++summary.submissions;
    if (submission.contains("problem")) {
      ++summary.refused;
      continue;
    }
    ++summary.graded;
    for (const nlohmann::json& unit : submission.at("exercises")) {
      summary.refused_files += unit.at("status") == "refused" ? 1 : 0;
      summary.not_graded += unit.at("status") == "not_graded" ? 1 : 0;
    }
    if (submission.at("points").is_null()) continue;
    ++summary.in_mean;
    points += submission.at("points").get<double>();
  }
  if (summary.in_mean > 0) summary.mean = points / summary.in_mean;
  return summary;
}

nlohmann::json to_json(const Summary& summary) {
  return {{"submissions", summary.submissions}, {"graded", summary.graded},
          {"refused", summary.refused},         {"refused_files", summary.refused_files},
          {"not_graded", summary.not_graded},   {"mean", summary.mean},
          {"max_points", summary.max_points}};
}

}  // namespace contact::grading
