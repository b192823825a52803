#include "run_turns.hpp"

#include <set>

#include <nlohmann/json.hpp>

namespace contact::grading {

namespace {

std::string turn_text(const nlohmann::json& json, const char* key) {
  const auto found = json.find(key);
  return found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
}

// Catch2 may say "SIGSEGV - ..." itself before the process dies; our words then replace its own.
void put_in_words(TestResult& result, const std::string& reason) {
  result.status = TestStatus::stopped;
  result.failure.got.clear();
  result.failure.right.clear();
  result.failure.allowed.clear();
  result.failure.reason = reason;
}

}  // namespace

void EventReader::feed(std::string_view text) {
  buffer_ += text;
  for (std::size_t end = buffer_.find('\n'); end != std::string::npos; end = buffer_.find('\n')) {
    event(buffer_.substr(0, end));
    buffer_.erase(0, end + 1);
  }
}

void EventReader::event(const std::string& line) {
  const nlohmann::json json = nlohmann::json::parse(line, nullptr, false);
  if (!json.is_object()) return;
  const std::string kind = turn_text(json, "event");
  if (kind == "start") {
    current_ = turn_text(json, "test");
    start_time_ = Clock::now();
    started_.push_back(current_);
  } else if (kind == "end") {
    TestResult result = result_from_json(json);
    result.name = turn_text(json, "test");
    results_.push_back(std::move(result));
    current_.clear();
  } else if (kind == "look" && json.contains("look") && json["look"].is_object()) {
    look_ = look_from_json(json["look"]);
  } else if (kind == "done") {
    done_ = true;
  }
}

std::string escaped_test_name(const std::string& name) {
  std::string result;
  for (const char c : name) {
    if (std::string_view(",[]*\"\\~").find(c) != std::string_view::npos) result += '\\';
    result += c;
  }
  return result;
}

std::vector<TestResult> run_in_turns(const Exercise& exercise, const RunTurn& run) {
  std::vector<TestResult> results;
  std::set<std::string> finished;
  const auto take = [&](TestResult result) {
    if (finished.insert(result.name).second) results.push_back(std::move(result));
  };
  std::vector<std::string> names;
  // Each turn settles at least one test, or ends.
  for (std::size_t i = 0; i <= exercise.tests.size(); ++i) {
    Turn turn = run(names);
    std::vector<TestResult>& seen = turn.reader.results();
    // After a crash Catch2 still says how the test ended and that all is done, then lets the signal
    // through.
    if (turn.died && !turn.reader.running() && !seen.empty() &&
        seen.back().status == TestStatus::stopped &&
        (turn.knows_better || seen.back().failure.reason.empty()))
      put_in_words(seen.back(), turn.why);
    const bool none_began = seen.empty() && !turn.reader.running();
    for (TestResult& result : seen) take(std::move(result));
    if (!turn.died) break;
    if (turn.reader.running()) {
      TestResult result;
      result.name = turn.reader.current();
      result.seconds =
          std::chrono::duration<double>(EventReader::Clock::now() - turn.reader.start_time())
              .count();
      put_in_words(result, turn.why);
      take(std::move(result));
    } else if (none_began) {
      // It died before any test began (a constructor of a global, say): every test left has the
      // same end.
      for (const TestSpec& test : exercise.tests) {
        TestResult result;
        result.name = test.name;
        put_in_words(result, "before the test began: " + turn.why);
        take(std::move(result));
      }
    }
    names.clear();
    for (const TestSpec& test : exercise.tests) {
      if (finished.count(test.name) == 0) names.push_back(test.name);
    }
    if (names.empty()) break;
    if (!turn.enough.empty()) {
      for (const std::string& name : names) {
        TestResult result;
        result.name = name;
        result.status = TestStatus::skipped;
        result.failure.reason = turn.enough;
        take(std::move(result));
      }
      break;
    }
  }
  return results;
}

}  // namespace contact::grading
