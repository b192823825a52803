#include "verdict.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <functional>
#include <map>
#include <set>

#include <nlohmann/json.hpp>

namespace contact::grading {

namespace {

struct StatusName {
  TestStatus status;
  std::string_view key;
  std::string_view words;
};

constexpr std::array<StatusName, 5> status_names{{
    {TestStatus::passed, "passed", "passed"},
    {TestStatus::failed, "failed", "failed"},
    {TestStatus::not_attempted, "not_attempted", "not attempted"},
    {TestStatus::stopped, "stopped", "stopped"},
    {TestStatus::skipped, "skipped", "skipped"},
}};

struct OutcomeName {
  Outcome outcome;
  std::string_view key;
  std::string_view words;
};

constexpr std::array<OutcomeName, 4> outcome_names{{
    {Outcome::passed, "passed", "passed"},
    {Outcome::failed, "failed", "failed"},
    {Outcome::not_attempted, "not_attempted", "not attempted"},
    {Outcome::does_not_compile, "does_not_compile", "does not compile"},
}};

std::string text_at(const nlohmann::json& json, const char* key) {
  const auto found = json.find(key);
  return found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
}

Failure failure_from(const nlohmann::json& json) {
  Failure failure;
  failure.asked = text_at(json, "asked");
  failure.got = text_at(json, "got");
  failure.right = text_at(json, "right");
  failure.allowed = text_at(json, "allowed");
  failure.misconception = text_at(json, "misconception");
  failure.reason = text_at(json, "reason");
  if (const auto inputs = json.find("inputs"); inputs != json.end() && inputs->is_array()) {
    for (const nlohmann::json& input : *inputs) {
      if (input.is_object())
        failure.inputs.emplace_back(text_at(input, "name"), text_at(input, "text"));
    }
  }
  return failure;
}

const TestSpec* spec_of(const Exercise& exercise, const std::string& name) {
  const auto found = std::find_if(exercise.tests.begin(), exercise.tests.end(),
                                  [&](const TestSpec& test) { return test.name == name; });
  return found == exercise.tests.end() ? nullptr : &*found;
}

// A test counts only if all that it requires, directly or through others, passed.
std::string unmet_need(const Exercise& exercise, const TestSpec& test,
                       const std::map<std::string, TestStatus>& status) {
  std::set<std::string> visited;
  const std::function<std::string(const TestSpec&)> search =
      [&](const TestSpec& current) -> std::string {
    for (const std::string& need : current.needs) {
      if (!visited.insert(need).second) continue;
      const auto found = status.find(need);
      if (found == status.end() || found->second != TestStatus::passed) return need;
      if (const TestSpec* next = spec_of(exercise, need)) {
        if (std::string deeper = search(*next); !deeper.empty()) return deeper;
      }
    }
    return {};
  };
  return search(test);
}

// Only private tests are hidden or await the due date, and no student ever has a verdict on these;
// if one did, it would say nothing.
void withhold(TestVerdict& test) {
  if (test.visibility != Visibility::shown) test.finding = Failure{};
  Failure& failure = test.failure;
  if (test.visibility == Visibility::values_withheld) {
    failure.inputs.clear();
    failure.got.clear();  // which may be the input, handed back
    failure.right.clear();
    failure.allowed.clear();
    // Why an input does not break the code is told by its values.
    if (test.status == TestStatus::failed) failure.reason.clear();
  } else if (test.visibility != Visibility::shown) {
    failure = Failure{};
  }
}

Outcome outcome_of(const std::vector<TestVerdict>& tests) {
  const auto all = [&](auto predicate) {
    return std::all_of(tests.begin(), tests.end(), predicate);
  };
  if (all([](const TestVerdict& test) { return test.status == TestStatus::passed; }))
    return Outcome::passed;
  if (all([](const TestVerdict& test) { return test.status == TestStatus::not_attempted; }))
    return Outcome::not_attempted;
  return Outcome::failed;
}

}  // namespace

Verdict judge(const Exercise& exercise, const Book& book, const std::vector<TestResult>& results,
              Reader reader) {
  std::map<std::string, const TestResult*> by_name;
  std::map<std::string, TestStatus> status;
  for (const TestResult& result : results) {
    by_name[result.name] = &result;
    status[result.name] = result.status;
  }
  Verdict verdict;
  verdict.exercise = exercise.id();
  verdict.max_points = exercise.max_points();
  for (const TestSpec& spec : exercise.tests) {
    TestVerdict test;
    test.name = spec.name;
    test.max_points = spec.points;
    test.visibility = spec.visibility;
    const auto found = by_name.find(spec.name);
    if (found == by_name.end()) {
      test.status = TestStatus::stopped;
      test.failure.reason = "this test did not run";
      verdict.missing_tests.push_back(spec.name);
    } else {
      test.status = found->second->status;
      test.failure = found->second->failure;
      if (test.status == TestStatus::passed) test.finding = found->second->finding;
      test.seconds = found->second->seconds;
      if (test.status != TestStatus::not_attempted) {
        if (const std::string need = unmet_need(exercise, spec, status); !need.empty()) {
          test.status = TestStatus::skipped;
          test.finding = Failure{};
          test.failure = Failure{};
          test.failure.reason = "it counts once this passes: " + need;
        }
      }
    }
    if (test.status == TestStatus::passed) test.points = spec.points;
    if (reader == Reader::student) withhold(test);
    if (!test.failure.misconception.empty())
      test.failure.hint = book.hint_for(test.failure.misconception);
    verdict.points += test.points;
    verdict.tests.push_back(std::move(test));
  }
  for (const TestResult& result : results) {
    if (spec_of(exercise, result.name) == nullptr) verdict.unlisted_tests.push_back(result.name);
  }
  std::vector<std::string> ran;
  std::vector<std::string> listed;
  for (const TestResult& result : results) {
    if (spec_of(exercise, result.name) != nullptr) ran.push_back(result.name);
  }
  for (const TestSpec& spec : exercise.tests) {
    if (by_name.count(spec.name) != 0) listed.push_back(spec.name);
  }
  verdict.in_order = ran == listed;
  verdict.outcome = outcome_of(verdict.tests);
  return verdict;
}

Verdict judge_uncompiled(const Exercise& exercise, CompileError error) {
  Verdict verdict;
  verdict.exercise = exercise.id();
  verdict.outcome = Outcome::does_not_compile;
  verdict.max_points = exercise.max_points();
  verdict.compile_error = std::move(error);
  for (const TestSpec& spec : exercise.tests) {
    TestVerdict test;
    test.name = spec.name;
    test.max_points = spec.points;
    test.visibility = spec.visibility;
    verdict.tests.push_back(std::move(test));
  }
  return verdict;
}

const TestVerdict* first_failure(const Verdict& verdict) {
  const auto found =
      std::find_if(verdict.tests.begin(), verdict.tests.end(), [](const TestVerdict& test) {
        return test.status == TestStatus::failed || test.status == TestStatus::stopped;
      });
  return found == verdict.tests.end() ? nullptr : &*found;
}

std::string_view words(TestStatus status) {
  return status_names[static_cast<std::size_t>(status)].words;
}
std::string_view key(TestStatus status) {
  return status_names[static_cast<std::size_t>(status)].key;
}
std::string_view words(Outcome outcome) {
  return outcome_names[static_cast<std::size_t>(outcome)].words;
}
std::string_view key(Outcome outcome) {
  return outcome_names[static_cast<std::size_t>(outcome)].key;
}

std::optional<TestStatus> status_from_key(std::string_view key) {
  for (const StatusName& name : status_names) {
    if (name.key == key) return name.status;
  }
  return std::nullopt;
}

std::string points_text(double points) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.4g", points);
  return text.data();
}

TestResult result_from_json(const nlohmann::json& json) {
  TestResult result;
  result.name = text_at(json, "name");
  result.status = status_from_key(text_at(json, "status")).value_or(TestStatus::stopped);
  if (const auto seconds = json.find("seconds"); seconds != json.end() && seconds->is_number())
    result.seconds = seconds->get<double>();
  if (const auto failure = json.find("failure"); failure != json.end() && failure->is_object())
    result.failure = failure_from(*failure);
  if (const auto finding = json.find("finding"); finding != json.end() && finding->is_object())
    result.finding = failure_from(*finding);
  return result;
}

nlohmann::json to_json(const Failure& failure) {
  nlohmann::json inputs = nlohmann::json::array();
  for (const auto& [name, value] : failure.inputs)
    inputs.push_back({{"name", name}, {"text", value}});
  nlohmann::json json = {{"asked", failure.asked}, {"inputs", inputs}};
  const auto put = [&](const char* name, const std::string& value) {
    if (!value.empty()) json[name] = value;
  };
  put("got", failure.got);
  put("right", failure.right);
  put("allowed", failure.allowed);
  put("misconception", failure.misconception);
  put("hint", failure.hint);
  put("reason", failure.reason);
  return json;
}

nlohmann::json to_json(const Remark& remark) {
  nlohmann::json json = {{"file", remark.file},
                         {"line", remark.line},
                         {"column", remark.column},
                         {"end_line", remark.end_line},
                         {"end_column", remark.end_column},
                         {"severity", remark.severity},
                         {"message", remark.message},
                         {"words", remark.words}};
  if (!remark.mistake.empty()) json["mistake"] = remark.mistake;
  return json;
}

nlohmann::json to_json(const Verdict& verdict) {
  nlohmann::json diagnostics = nlohmann::json::array();
  for (const Remark& remark : verdict.remarks) diagnostics.push_back(to_json(remark));
  nlohmann::json tests = nlohmann::json::array();
  for (const TestVerdict& test : verdict.tests) {
    nlohmann::json entry = {{"name", test.name},
                            {"status", key(test.status)},
                            {"points", test.points},
                            {"max_points", test.max_points},
                            {"seconds", test.seconds}};
    if (test.visibility != Visibility::shown) entry["visibility"] = key(test.visibility);
    if (test.status == TestStatus::failed || test.status == TestStatus::stopped ||
        test.status == TestStatus::skipped)
      entry["failure"] = to_json(test.failure);
    if (!test.finding.asked.empty()) entry["finding"] = to_json(test.finding);
    tests.push_back(std::move(entry));
  }
  nlohmann::json json = {{"exercise", verdict.exercise},
                         {"file", verdict.file},
                         {"verdict", key(verdict.outcome)},
                         {"points", verdict.points},
                         {"max_points", verdict.max_points},
                         {"tests", std::move(tests)},
                         {"warnings", verdict.warnings},
                         {"diagnostics", std::move(diagnostics)},
                         {"output", verdict.output},
                         {"seconds",
                          {{"compile", verdict.seconds.compile},
                           {"link", verdict.seconds.link},
                           {"run", verdict.seconds.run}}}};
  if (verdict.compile_error) {
    const CompileError& error = *verdict.compile_error;
    nlohmann::json contract = nlohmann::json::array();
    for (const ContractLine& line : error.contract)
      contract.push_back({{"file", line.file}, {"line", line.line}, {"text", line.text}});
    json["compile_error"] = {{"file", error.file},       {"line", error.line},
                             {"column", error.column},   {"message", error.message},
                             {"excerpt", error.excerpt}, {"explanation", error.explanation},
                             {"contract", contract},     {"full", error.full}};
  }
  return json;
}

Verdict verdict_from_json(const nlohmann::json& json) {
  Verdict verdict;
  verdict.exercise = json.at("exercise").get<std::string>();
  const std::string outcome = json.at("verdict").get<std::string>();
  for (const OutcomeName& name : outcome_names) {
    if (name.key == outcome) verdict.outcome = name.outcome;
  }
  verdict.points = json.at("points").get<double>();
  verdict.max_points = json.at("max_points").get<double>();
  for (const nlohmann::json& entry : json.at("tests")) {
    TestVerdict test;
    test.name = entry.at("name").get<std::string>();
    test.status =
        status_from_key(entry.at("status").get<std::string>()).value_or(TestStatus::stopped);
    test.points = entry.at("points").get<double>();
    test.max_points = entry.at("max_points").get<double>();
    verdict.tests.push_back(std::move(test));
  }
  return verdict;
}

}  // namespace contact::grading
