#include "progress_merge.hpp"

#include <algorithm>
#include <regex>
#include <set>

namespace contact::grading {

namespace {

using nlohmann::json;

// No reader has tried a million times; a number that no int holds would read as nonsense later.
constexpr double max_counted = 1e6;

bool is_time(const json& value) {
  static const std::regex pattern(R"(\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d(\.\d{1,9})?Z)");
  return value.is_string() && value.get_ref<const std::string&>().size() < 40 &&
         std::regex_match(value.get_ref<const std::string&>(), pattern);
}

// A time is compared without its fraction, which only the page writes.
std::string time_in(const json& entry, const char* name) {
  const auto found = entry.find(name);
  return found != entry.end() && is_time(*found) ? found->get<std::string>().substr(0, 19) : "";
}

double number_in(const json& entry, const char* name) {
  const auto found = entry.find(name);
  return found != entry.end() && found->is_number()
             ? std::clamp(found->get<double>(), 0.0, max_counted)
             : 0.0;
}

json sound_times(const json& passed_as) {
  json result = json::object();
  for (const auto& [form, time] : passed_as.items()) {
    if (is_form(form) && is_time(time)) result[form] = time;
  }
  return result;
}

// Members of the right type, and all unknown members.
json sound(const json& entry) {
  static const std::set<std::string> known{
      "attempts",     "hints_shown",    "best_points", "max_points", "passed",   "failing",
      "last_checked", "solution_shown", "tests",       "form",       "passed_as"};
  json result = json::object();
  for (const auto& [name, value] : entry.items()) {
    const bool number = name == "best_points" || name == "max_points";
    const bool count = name == "attempts" || name == "hints_shown";
    const bool time = name == "passed" || name == "last_checked";
    if (count && value.is_number())
      result[name] = static_cast<int>(number_in(entry, name.c_str()));
    else if (number && value.is_number())
      result[name] = number_in(entry, name.c_str());
    else if (name == "form" && value.is_string() && is_form(value.get<std::string>()))
      result[name] = value;
    else if (name == "passed_as" && value.is_object())
      result[name] = sound_times(value);
    else if ((time && is_time(value)) || (name == "solution_shown" && value.is_boolean()) ||
             ((name == "tests" || name == "failing") && value.is_object()))
      result[name] = value;
    else if (!known.contains(name))
      result[name] = value;
  }
  return result;
}

json merged_entry(const json& ours, const json& theirs) {
  const bool theirs_is_later = time_in(theirs, "last_checked") > time_in(ours, "last_checked");
  json result = theirs_is_later ? ours : theirs;
  result.update(theirs_is_later ? theirs : ours);
  for (const char* name : {"attempts", "best_points", "hints_shown"}) {
    if (number_in(theirs, name) > number_in(ours, name))
      result[name] = theirs[name];
    else if (ours.contains(name))
      result[name] = ours[name];
  }
  const std::string our_pass = time_in(ours, "passed");
  const std::string their_pass = time_in(theirs, "passed");
  if (!our_pass.empty() && (their_pass.empty() || our_pass <= their_pass))
    result["passed"] = ours["passed"];
  else if (!their_pass.empty())
    result["passed"] = theirs["passed"];
  json as = json::object();
  for (const json* entry : {&ours, &theirs}) {
    const auto found = entry->find("passed_as");
    if (found == entry->end() || !found->is_object()) continue;
    for (const auto& [form, time] : sound_times(*found).items()) {
      if (!as.contains(form) || time_in(*found, form.c_str()) < time_in(as, form.c_str()))
        as[form] = time;
    }
  }
  if (!as.empty()) result["passed_as"] = as;
  for (const json* entry : {&ours, &theirs}) {
    if (const auto found = entry->find("solution_shown"); found != entry->end() && *found == true)
      result["solution_shown"] = true;
  }
  return result;
}

bool names_exercise(const std::string& key) {
  static const std::regex pattern(R"(\d\d_[a-z][a-z0-9_]*/[a-z][a-z0-9_]*)");
  return key.size() < 120 && std::regex_match(key, pattern);
}

bool names_question(const std::string& key) {
  static const std::regex pattern(R"(\d\d_[a-z][a-z0-9_]*/[a-z0-9][a-z0-9_-]*)");
  return key.size() < 120 && std::regex_match(key, pattern);
}

// A reader writes a few sentences; a longer answer is not one.
constexpr std::size_t longest_answer = 20'000;

bool is_answer(const json& entry) {
  const auto holds = [&](const char* name, bool (json::*is)() const noexcept) {
    const auto found = entry.find(name);
    return found != entry.end() && ((*found).*is)();
  };
  return entry.is_object() && holds("kind", &json::is_string) &&
         holds("right", &json::is_boolean) && holds("tries", &json::is_number) &&
         entry.contains("answer") && !time_in(entry, "at").empty() &&
         entry.dump(-1, ' ', true, json::error_handler_t::replace).size() <= longest_answer;
}

// The later answer to each question, with the larger number of tries.
void merge_answers(json& ours, const json& theirs) {
  if (!ours.is_object()) ours = json::object();
  for (const auto& [id, entry] : theirs.items()) {
    if (!names_question(id) || !is_answer(entry)) continue;
    const auto found = ours.find(id);
    const bool known = found != ours.end() && is_answer(*found);
    const double tries =
        std::max(number_in(entry, "tries"), known ? number_in(*found, "tries") : 0.0);
    if (!known || time_in(entry, "at") > time_in(*found, "at")) ours[id] = entry;
    ours[id]["tries"] = static_cast<int>(tries);
  }
}

}  // namespace

ProgressRecord merged(const ProgressRecord& ours, const ProgressRecord& theirs) {
  json document = ours.document();
  for (const auto& [name, value] : theirs.document().items()) {
    if (!document.contains(name) && name != "questions") document[name] = value;
  }
  if (const auto answers = theirs.document().find("questions");
      answers != theirs.document().end() && answers->is_object())
    merge_answers(document["questions"], *answers);
  json& exercises = document["exercises"];
  for (const auto& [id, entry] : theirs.document()["exercises"].items()) {
    if (!names_exercise(id)) continue;
    const auto found = exercises.find(id);
    exercises[id] = found == exercises.end() ? sound(entry) : merged_entry(*found, sound(entry));
  }
  return ProgressRecord(std::move(document));
}

std::vector<std::string> changed_entries(const ProgressRecord& before,
                                         const ProgressRecord& after) {
  std::vector<std::string> changed;
  const json& earlier = before.document()["exercises"];
  for (const auto& [id, entry] : after.document()["exercises"].items()) {
    const auto found = earlier.find(id);
    if (found == earlier.end() || *found != entry) changed.push_back(id);
  }
  return changed;
}

}  // namespace contact::grading
