#include "verdict.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
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

std::vector<std::string> texts_at(const nlohmann::json& json, const char* key) {
  std::vector<std::string> texts;
  const auto found = json.find(key);
  if (found == json.end() || !found->is_array()) return texts;
  for (const nlohmann::json& text : *found) {
    if (text.is_string()) texts.push_back(text.get<std::string>());
  }
  return texts;
}

double number_at(const nlohmann::json& json, const char* key) {
  const auto found = json.find(key);
  return found != json.end() && found->is_number() ? found->get<double>() : 0.0;
}

CloserLook::Inputs inputs_from(const nlohmann::json& json) {
  CloserLook::Inputs inputs;
  if (!json.is_array()) return inputs;
  for (const nlohmann::json& input : json) {
    if (input.is_object()) inputs.emplace_back(text_at(input, "name"), text_at(input, "text"));
  }
  return inputs;
}

nlohmann::json to_json(const CloserLook::Inputs& inputs) {
  nlohmann::json json = nlohmann::json::array();
  for (const auto& [name, value] : inputs) json.push_back({{"name", name}, {"text", value}});
  return json;
}

Failure failure_from(const nlohmann::json& json) {
  Failure failure;
  failure.asked = text_at(json, "asked");
  failure.got = text_at(json, "got");
  failure.right = text_at(json, "right");
  failure.allowed = text_at(json, "allowed");
  failure.misconceptions = texts_at(json, "misconceptions");
  failure.hint = text_at(json, "observed");
  failure.reason = text_at(json, "reason");
  if (const auto inputs = json.find("inputs"); inputs != json.end())
    failure.inputs = inputs_from(*inputs);
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

// A hint states what went wrong. If several mistakes give the same answer, nobody knows which one
// this is, so each becomes a question.
void give_hint(Failure& failure, const Book& book) {
  if (failure.misconceptions.size() == 1)
    failure.hint = book.hint_for(failure.misconceptions.front());
  if (failure.misconceptions.size() < 2) return;
  for (const std::string& id : failure.misconceptions) {
    if (const std::string summary = book.summary_of(id); !summary.empty())
      failure.questions.push_back(summary + "?");
  }
}

// What made a test fail, as far as it is known: equal for two tests that fail for the same cause.
// Two wrong answers that nothing explains may have two causes.
std::string cause_of(const TestVerdict& test) {
  const Failure& failure = test.failure;
  if (test.status == TestStatus::failed)
    return failure.misconceptions.size() == 1 ? failure.misconceptions.front() : std::string();
  if (test.status != TestStatus::stopped || failure.reason.empty()) return {};
  // How long a test was waited for differs from one to the next.
  constexpr std::string_view late = "no answer after";
  const std::string reason = failure.reason.starts_with(late) ? std::string(late) : failure.reason;
  return failure.asked + '\n' + reason;
}

void find_same_causes(std::vector<TestVerdict>& tests) {
  std::map<std::string, std::string> first;
  for (TestVerdict& test : tests) {
    // No name of a test that a student must not see goes into another's report.
    const std::string cause = test.visibility == Visibility::shown ? cause_of(test) : "";
    if (cause.empty()) continue;
    const auto [found, is_new] = first.emplace(cause, test.name);
    if (!is_new) test.same_as = found->second;
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
      test.processor_seconds = found->second->processor_seconds;
      if (spec.visibility == Visibility::shown) test.look = found->second->look;
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
    give_hint(test.failure, book);
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
  find_same_causes(verdict.tests);
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

std::vector<std::string> same_mistake(const Verdict& verdict, const TestVerdict& test) {
  std::vector<std::string> names;
  for (const TestVerdict& other : verdict.tests) {
    if (!test.name.empty() && other.same_as == test.name) names.push_back(other.name);
  }
  return names;
}

std::string code_of(std::string_view text) {
  // FNV-1a, as of any other text: nothing depends on who can find two texts with one name.
  std::uint64_t hash = 0xcbf29ce484222325u;
  bool comment = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    comment = c != '\n' && (comment || text.substr(i, 2) == "//");
    if (comment || c == ' ' || c == '\t' || c == '\n' || c == '\r') continue;
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  }
  std::array<char, 20> name{};
  std::snprintf(name.data(), name.size(), "%016llx", static_cast<unsigned long long>(hash));
  return name.data();
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
  result.seconds = number_at(json, "seconds");
  result.processor_seconds = number_at(json, "processor_seconds");
  if (const auto failure = json.find("failure"); failure != json.end() && failure->is_object())
    result.failure = failure_from(*failure);
  if (const auto look = json.find("look"); look != json.end() && look->is_object())
    result.look = look_from_json(*look);
  if (const auto finding = json.find("finding"); finding != json.end() && finding->is_object())
    result.finding = failure_from(*finding);
  return result;
}

CloserLook look_from_json(const nlohmann::json& json) {
  CloserLook look;
  look.right = static_cast<int>(number_at(json, "right"));
  look.wrong = static_cast<int>(number_at(json, "wrong"));
  const auto read = [&](const char* name, std::vector<CloserLook::Inputs>& into) {
    const auto list = json.find(name);
    if (list == json.end() || !list->is_array()) return;
    for (const nlohmann::json& inputs : *list) into.push_back(inputs_from(inputs));
  };
  read("right_inputs", look.right_inputs);
  read("wrong_inputs", look.wrong_inputs);
  if (const auto smaller = json.find("smaller"); smaller != json.end() && smaller->is_object())
    look.smaller = failure_from(*smaller);
  look.hint_number = static_cast<int>(number_at(json, "hint_number"));
  look.hint = text_at(json, "hint");
  return look;
}

nlohmann::json to_json(const CloserLook& look) {
  nlohmann::json json = {{"right", look.right}, {"wrong", look.wrong}};
  const auto write = [&](const char* name, const std::vector<CloserLook::Inputs>& list) {
    json[name] = nlohmann::json::array();
    for (const CloserLook::Inputs& inputs : list) json[name].push_back(to_json(inputs));
  };
  write("right_inputs", look.right_inputs);
  write("wrong_inputs", look.wrong_inputs);
  if (look.smaller) json["smaller"] = to_json(*look.smaller);
  if (look.hint_number > 0) {
    json["hint_number"] = look.hint_number;
    json["hint"] = look.hint;
  }
  return json;
}

nlohmann::json to_json(const Failure& failure) {
  nlohmann::json json = {{"asked", failure.asked}, {"inputs", to_json(failure.inputs)}};
  const auto put = [&](const char* name, const std::string& value) {
    if (!value.empty()) json[name] = value;
  };
  put("got", failure.got);
  put("right", failure.right);
  put("allowed", failure.allowed);
  if (!failure.misconceptions.empty()) json["misconceptions"] = failure.misconceptions;
  put("hint", failure.hint);
  if (!failure.questions.empty()) json["questions"] = failure.questions;
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
    if (!test.same_as.empty()) entry["same_as"] = test.same_as;
    if (test.look) entry["look"] = to_json(*test.look);
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
  if (!verdict.code.empty()) json["code"] = verdict.code;
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
  verdict.code = text_at(json, "code");
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
    if (const auto look = entry.find("look"); look != entry.end())
      test.look = look_from_json(*look);
    verdict.tests.push_back(std::move(test));
  }
  return verdict;
}

}  // namespace contact::grading
