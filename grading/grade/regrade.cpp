#include "regrade.hpp"

#include <algorithm>
#include <array>
#include <ctime>
#include <map>
#include <optional>
#include <set>

#include "../progress/progress.hpp"

namespace fs = std::filesystem;

namespace contact::grading {

namespace {

constexpr const char* changes_format = "contact-grade-changes/1";
constexpr const char* results_name = "results.json";
constexpr const char* changes_name = "changes.json";

// Stands where there is no unit.
const nlohmann::json none;

// One exercise of one submission.
struct Mark {
  /// Nothing if it could not be graded.
  std::optional<double> points = 0.0;
  bool refused = false;
  const nlohmann::json* unit = &none;
};

using Marks = std::map<std::pair<std::string, std::string>, Mark>;

// By submission and exercise. A submission that is refused whole has no units, and no points in any
// exercise.
Marks marks_of(const nlohmann::json& results) {
  Marks marks;
  for (const nlohmann::json& submission : results.at("submissions")) {
    const auto id = submission.at("id").get<std::string>();
    if (submission.contains("problem")) {
      for (const nlohmann::json& exercise : results.at("exercises"))
        marks[{id, exercise.at("id").get<std::string>()}] = {0.0, true, &none};
      continue;
    }
    for (const nlohmann::json& unit : submission.at("exercises")) {
      std::optional<double> points;
      if (!unit.at("points").is_null()) points = unit.at("points").get<double>();
      marks[{id, unit.at("id").get<std::string>()}] = {points, unit.at("status") == "refused",
                                                       &unit};
    }
  }
  return marks;
}

std::map<std::string, double> max_points(const nlohmann::json& results) {
  std::map<std::string, double> most;
  for (const nlohmann::json& exercise : results.at("exercises"))
    most[exercise.at("id").get<std::string>()] = exercise.at("max_points").get<double>();
  return most;
}

std::map<std::string, std::string> tests_of(const nlohmann::json& unit) {
  std::map<std::string, std::string> tests;
  if (!unit.contains("verdict")) return tests;
  for (const nlohmann::json& test : unit.at("verdict").at("tests"))
    tests[test.at("name").get<std::string>()] = test.at("status").get<std::string>();
  return tests;
}

nlohmann::json changed_tests(const nlohmann::json& before, const nlohmann::json& after) {
  const std::map<std::string, std::string> old = tests_of(before);
  const std::map<std::string, std::string> now = tests_of(after);
  std::map<std::string, std::pair<std::string, std::string>> both;
  for (const auto& [name, status] : old) both[name].first = status;
  for (const auto& [name, status] : now) both[name].second = status;
  const auto told = [](const std::string& status) {
    return status.empty() ? nlohmann::json(nullptr) : nlohmann::json(status);
  };
  nlohmann::json changed = nlohmann::json::array();
  for (const auto& [name, statuses] : both) {
    if (statuses.first != statuses.second)
      changed.push_back(
          {{"name", name}, {"before", told(statuses.first)}, {"after", told(statuses.second)}});
  }
  return changed;
}

// A file that came, went or was refused is a change of code.
std::vector<std::string> reasons(const Mark& before, const Mark& after) {
  if (!after.points) return {"could not be graded"};
  if (!before.points) return {"could not be graded before"};
  if (after.refused) return {"code", "refused"};
  const nlohmann::json& then = *before.unit;
  const nlohmann::json& now = *after.unit;
  if (!then.contains("key") || !now.contains("key")) return {"code"};
  return differences(key_from_json(then.at("key")), key_from_json(now.at("key")));
}

std::vector<std::string> reasons_to_come(const Mark& after) {
  if (!after.points) return {"new", "could not be graded"};
  if (after.refused) return {"new", "refused"};
  return {"new"};
}

nlohmann::json points_json(const Mark& mark) {
  return mark.points ? nlohmann::json(*mark.points) : none;
}

std::string date_time() { return now_utc("%Y-%m-%dT%H-%M-%SZ"); }

}  // namespace

std::optional<nlohmann::json> earlier_results(const RunFolder& folder) {
  const fs::path file = folder.results() / results_name;
  if (!fs::exists(file)) return {};
  nlohmann::json json = nlohmann::json::parse(read_text(file), nullptr, false);
  if (!json.is_object() || json.value("format", "") != "contact-grade/2")
    throw BookError(file.string() +
                    " is not as it was written. Put it away, or grade into a new folder");
  return json;
}

bool of_another_class(const nlohmann::json& earlier, const std::set<std::string>& submissions) {
  const nlohmann::json& all = earlier.at("submissions");
  return !all.empty() && std::none_of(all.begin(), all.end(), [&](const nlohmann::json& one) {
    return submissions.count(one.at("id").get<std::string>()) != 0;
  });
}

nlohmann::json changes_between(const nlohmann::json& before, const nlohmann::json& after) {
  const Marks old = marks_of(before);
  const Marks now = marks_of(after);
  const std::map<std::string, double> most = max_points(after);
  const std::map<std::string, double> max_before = max_points(before);
  std::set<std::pair<std::string, std::string>> all;
  for (const auto& entry : old) all.insert(entry.first);
  for (const auto& entry : now) all.insert(entry.first);

  nlohmann::json changes = nlohmann::json::array();
  for (const auto& which : all) {
    const auto then = old.find(which);
    const auto found = now.find(which);
    const bool was = then != old.end();
    const bool is = found != now.end();
    if (was && is && then->second.points == found->second.points) continue;
    const bool asked = most.count(which.second) != 0;
    const std::vector<std::string> why = was && is ? reasons(then->second, found->second)
                                         : is      ? reasons_to_come(found->second)
                                         : asked
                                             ? std::vector<std::string>{"not handed in any more"}
                                             : std::vector<std::string>{"not asked for any more"};
    changes.push_back({{"submission", which.first},
                       {"exercise", which.second},
                       {"before", was ? points_json(then->second) : none},
                       {"after", is ? points_json(found->second) : none},
                       {"max_points", (asked ? most : max_before).at(which.second)},
                       {"why", why},
                       {"tests", changed_tests(was ? *then->second.unit : none,
                                               is ? *found->second.unit : none)}});
  }
  return {{"format", changes_format}, {"changes", std::move(changes)}};
}

fs::path Earlier::target(const fs::path& as) {
  if (place_.empty()) {
    const fs::path all = folder_.results() / "earlier";
    fs::create_directories(all);
    const std::string stamp = date_time();
    place_ = all / stamp;
    for (int i = 2; !fs::create_directory(place_); ++i)
      place_ = all / (stamp + "-" + std::to_string(i));
  }
  fs::path target = place_ / as;
  fs::create_directories(target.parent_path());
  return target;
}

void Earlier::keep(const fs::path& file, const fs::path& as) {
  write_durably(target(as), read_text(file));
}

void Earlier::put_away(const fs::path& file, const fs::path& as) {
  std::error_code error;
  fs::rename(file, target(as), error);
  if (error) throw BookError("cannot move " + file.string() + ": " + error.message());
}

std::optional<nlohmann::json> write_results(const RunFolder& folder, const nlohmann::json& results,
                                            Earlier& earlier) {
  const std::optional<nlohmann::json> before = earlier_results(folder);
  std::optional<nlohmann::json> changes;
  const fs::path file = folder.results() / results_name;
  const fs::path changes_file = folder.results() / changes_name;
  if (before && *before == results) {
    // Nothing is new. What the last run changed stays said.
    return nlohmann::json{{"format", changes_format}, {"changes", nlohmann::json::array()}};
  }
  if (before) {
    changes = changes_between(*before, results);
    earlier.keep(file, results_name);
    for (const char* name : {changes_name, "run.json"}) {
      if (fs::exists(folder.results() / name)) earlier.keep(folder.results() / name, name);
    }
    // The changes first: if this is where the run is killed, the next finds the results as they
    // were and says the same.
    write_durably(changes_file, changes->dump(1) + "\n");
  }
  write_durably(file, results.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
  return changes;
}

}  // namespace contact::grading
