#include "progress_record.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace contact::grading {

namespace {

constexpr const char* format_name = "contact-progress/1";

void require_shape(const nlohmann::json& data) {
  if (!data.is_object() || data.value("format", "") != format_name || !data.contains("exercises") ||
      !data["exercises"].is_object())
    throw std::runtime_error(std::string("it is not ") + format_name);
  for (const auto& [id, entry] : data["exercises"].items()) {
    if (!entry.is_object()) throw std::runtime_error("the entry of " + id + " is not an object");
    if (entry.contains("tests") && !entry["tests"].is_object())
      throw std::runtime_error("the tests of " + id + " are not an object");
  }
}

// A value of the wrong type (a file edited by hand) reads as if it were not there.
template <typename T>
T read(const nlohmann::json& entry, const char* name, T otherwise) {
  try {
    return entry.value(name, otherwise);
  } catch (const nlohmann::json::exception&) {
    return otherwise;
  }
}

// Nothing more is said after so many.
constexpr std::size_t max_texts = 8;

// Of a file that was edited by hand, what is not as it should be is passed over.
std::vector<std::string> texts_of(const nlohmann::json& entry, const std::string& test) {
  std::vector<std::string> texts;
  const auto failing = entry.find("failing");
  if (failing == entry.end() || !failing->is_object()) return texts;
  const auto list = failing->find(test);
  if (list == failing->end() || !list->is_array()) return texts;
  for (const nlohmann::json& text : *list) {
    if (text.is_string()) texts.push_back(text.get<std::string>());
  }
  return texts;
}

nlohmann::json failing_after(const nlohmann::json& entry, const Verdict& verdict) {
  nlohmann::json failing = nlohmann::json::object();
  for (const TestVerdict& test : verdict.tests) {
    std::vector<std::string> texts = texts_of(entry, test.name);
    const bool fails = test.status == TestStatus::failed || test.status == TestStatus::stopped;
    if (fails && std::find(texts.begin(), texts.end(), verdict.code) == texts.end())
      texts.push_back(verdict.code);
    if (texts.size() > max_texts) texts.erase(texts.begin());
    if (test.status != TestStatus::passed && !texts.empty()) failing[test.name] = texts;
  }
  return failing;
}

std::string form_of(const nlohmann::json& entry) {
  const std::string form = read(entry, "form", std::string("write"));
  return is_form(form) ? form : "write";
}

}  // namespace

ProgressRecord::ProgressRecord()
    : data_({{"format", format_name}, {"exercises", nlohmann::json::object()}}) {}

ProgressRecord::ProgressRecord(nlohmann::json document) {
  require_shape(document);
  data_ = std::move(document);
}

ExerciseProgress ProgressRecord::of(const std::string& exercise) const {
  ExerciseProgress progress;
  const auto found = data_["exercises"].find(exercise);
  if (found == data_["exercises"].end()) return progress;
  progress.attempts = read(*found, "attempts", 0);
  progress.best_points = read(*found, "best_points", 0.0);
  progress.max_points = read(*found, "max_points", 0.0);
  progress.passed = read(*found, "passed", std::string());
  progress.last_checked = read(*found, "last_checked", std::string());
  progress.hints_shown = read(*found, "hints_shown", 0);
  progress.solution_shown = read(*found, "solution_shown", false);
  progress.form = form_of(*found);
  if (const auto as = found->find("passed_as"); as != found->end() && as->is_object()) {
    for (const auto& [form, time] : as->items()) {
      if (is_form(form) && time.is_string()) progress.passed_as[form] = time.get<std::string>();
    }
  }
  if (found->contains("tests")) {
    for (const auto& [name, status] : (*found)["tests"].items()) {
      if (status.is_string()) progress.tests[name] = status.get<std::string>();
    }
  }
  if (const auto failing = found->find("failing");
      failing != found->end() && failing->is_object()) {
    for (const auto& [name, texts] : failing->items())
      progress.failing[name] = texts_of(*found, name);
  }
  return progress;
}

nlohmann::json& ProgressRecord::entry_of(const std::string& exercise) {
  nlohmann::json& entry = data_["exercises"][exercise];
  if (entry.is_null()) entry = nlohmann::json::object();
  return entry;
}

void ProgressRecord::record(const Verdict& verdict, const std::string& now) {
  if (!is_attempt(verdict)) return;
  nlohmann::json& entry = entry_of(verdict.exercise);
  entry["attempts"] = read(entry, "attempts", 0) + 1;
  entry["best_points"] = std::max(read(entry, "best_points", 0.0), verdict.points);
  entry["max_points"] = verdict.max_points;
  entry["last_checked"] = now;
  if (verdict.outcome == Outcome::passed && read(entry, "passed", std::string()).empty())
    entry["passed"] = now;
  if (verdict.outcome == Outcome::passed) {
    nlohmann::json& as = entry["passed_as"];
    if (!as.is_object()) as = nlohmann::json::object();
    if (const std::string form = form_of(entry); !as.contains(form)) as[form] = now;
  }
  entry["tests"] = nlohmann::json::object();
  for (const TestVerdict& test : verdict.tests) {
    entry["tests"][test.name] = key(test.status);
    if (test.look && test.look->hint_number > read(entry, "hints_shown", 0))
      entry["hints_shown"] = test.look->hint_number;
  }
  if (!verdict.code.empty()) entry["failing"] = failing_after(entry, verdict);
}

int ProgressRecord::record_hint(const std::string& exercise) {
  nlohmann::json& entry = entry_of(exercise);
  const int shown = read(entry, "hints_shown", 0) + 1;
  entry["hints_shown"] = shown;
  return shown;
}

void ProgressRecord::record_solution_shown(const std::string& exercise) {
  entry_of(exercise)["solution_shown"] = true;
}

void ProgressRecord::record_form(const std::string& exercise, const std::string& form) {
  if (!is_form(form)) throw std::invalid_argument("there is no form '" + form + "'");
  entry_of(exercise)["form"] = form;
}

bool is_form(const std::string& name) {
  return std::find(forms.begin(), forms.end(), name) != forms.end();
}

std::optional<QuestionProgress> ProgressRecord::answer_to(const std::string& question) const {
  const auto all = data_.find("questions");
  if (all == data_.end() || !all->is_object()) return {};
  const auto found = all->find(question);
  if (found == all->end() || !found->is_object() || !found->contains("answer")) return {};
  QuestionProgress given{
      read(*found, "kind", std::string()), (*found)["answer"], read(*found, "right", false), {}};
  if (const auto marks = found->find("marks"); marks != found->end() && marks->is_array()) {
    for (const nlohmann::json& mark : *marks) given.marks.push_back(mark == true);
  }
  return given;
}

void ProgressRecord::record_answer(const std::string& question, const QuestionProgress& given,
                                   const std::string& now) {
  nlohmann::json& all = data_["questions"];
  if (!all.is_object()) all = nlohmann::json::object();
  const auto before = all.find(question);
  const int tries = before != all.end() && before->is_object() ? read(*before, "tries", 0) : 0;
  nlohmann::json entry = {{"kind", given.kind},
                          {"answer", given.answer},
                          {"right", given.right},
                          {"tries", tries + 1},
                          {"at", now}};
  if (!given.marks.empty()) entry["marks"] = given.marks;
  all[question] = std::move(entry);
}

void ProgressRecord::record_marks(const std::string& question, const std::vector<bool>& marks,
                                  const std::string& now) {
  if (!answer_to(question)) return;
  data_["questions"][question]["marks"] = marks;
  data_["questions"][question]["at"] = now;
}

bool is_attempt(const Verdict& verdict) {
  return verdict.outcome != Outcome::does_not_compile && verdict.outcome != Outcome::not_attempted;
}

}  // namespace contact::grading
