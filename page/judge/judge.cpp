// The judge of the page: the library under `contact check`, compiled to WebAssembly. The page hands
// in what happened as JSON and gets back what the program would say. The book's files are given as
// a tree of files, which Book reads as it reads the disk.

#include <cstdlib>
#include <exception>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "../../grading/book/book.hpp"
#include "../../grading/diagnosis/diagnosis.hpp"
#include "../../grading/diagnosis/exercise_contract.hpp"
#include "../../grading/progress/again.hpp"
#include "../../grading/progress/progress_record.hpp"
#include "../../grading/progress/progress_report.hpp"
#include "../../grading/verdict/verdict.hpp"

namespace contact::grading {

namespace {

using nlohmann::json;

const Book& book() {
  static const Book the_book("", "work");
  return the_book;
}

std::string text(const json& request, const char* name) { return request.value(name, ""); }

const Exercise& exercise_of(const json& request) {
  return book().exercise(request.at("exercise").get<std::string>());
}

// The student's file lies in the root, under the name of its contract.
Diagnosis diagnosis_of(const json& request) {
  const Exercise& exercise = exercise_of(request);
  return {exercise.name + ".cpp", text(request, "source"), contract_of(exercise)};
}

// As in a check: what cannot be explained is shown in the compiler's own words.
Explained said_of_compile(const Diagnosis& diagnosis, const std::string& log, bool failed) {
  try {
    return diagnosis.of_compile(log, failed, Columns::bytes);
  } catch (const std::exception&) {
    return unexplained(log, failed, diagnosis.file());
  }
}

Explained said_of_link(const Diagnosis& diagnosis, const std::string& log) {
  try {
    return diagnosis.of_link(log);
  } catch (const std::exception&) {
    return unexplained(log, true, diagnosis.file());
  }
}

json told(Verdict verdict, Explained said, const std::string& file) {
  verdict.file = file;
  verdict.warnings = std::move(said.warnings);
  verdict.remarks = std::move(said.remarks);
  return to_json(verdict);
}

json uncompiled(const json& request) {
  const Diagnosis diagnosis = diagnosis_of(request);
  const std::string log = text(request, "log");
  Explained said = text(request, "step") == "link" ? said_of_link(diagnosis, log)
                                                   : said_of_compile(diagnosis, log, true);
  CompileError error = *said.error;
  return told(judge_uncompiled(exercise_of(request), std::move(error)), std::move(said),
              diagnosis.file());
}

// The tests in their order, each with what it may take in a check of one's own.
json timed_tests(const json& request) {
  const Exercise& exercise = exercise_of(request);
  json list = json::array();
  for (const TestSpec& test : exercise.tests)
    list.push_back({{"name", test.name}, {"seconds", exercise.check_seconds(test)}});
  return list;
}

Verdict verdict_on(const json& request) {
  const Exercise& exercise = exercise_of(request);
  std::vector<TestResult> results;
  for (const json& result : request.at("results")) results.push_back(result_from_json(result));
  Verdict verdict = judge(exercise, book(), results);
  if (request.contains("source")) verdict.code = code_of(text(request, "source"));
  return verdict;
}

// The test of which more is to be found out, since it has failed before; null if there is none.
json again(const json& request) {
  const auto failed = failed_again(ProgressRecord(request.at("progress")), verdict_on(request));
  if (!failed || failed->look.empty()) return nullptr;
  return {{"test", failed->test}, {"look", failed->look}};
}

json judged(const json& request) {
  Verdict verdict = verdict_on(request);
  if (request.contains("progress"))
    add_next_hint(exercise_of(request), ProgressRecord(request["progress"]), verdict);
  verdict.output = text(request, "output");
  const Diagnosis diagnosis = diagnosis_of(request);
  return told(std::move(verdict), diagnosis.of_compile(text(request, "log"), false, Columns::bytes),
              diagnosis.file());
}

json recorded(const json& request) {
  ProgressRecord record(request.at("progress"));
  record.record(verdict_from_json(request.at("verdict")), text(request, "now"));
  return record.document();
}

json hint_recorded(const json& request) {
  ProgressRecord record(request.at("progress"));
  record.record_hint(text(request, "exercise"));
  return record.document();
}

json solution_recorded(const json& request) {
  ProgressRecord record(request.at("progress"));
  record.record_solution_shown(text(request, "exercise"));
  return record.document();
}

json problems() {
  json list = json::array();
  for (const BookProblem& problem : book().problems()) list.push_back(problem.what);
  return list;
}

json answer(const json& request) {
  const std::string what = request.at("do").get<std::string>();
  if (what == "tests") return timed_tests(request);
  if (what == "again") return again(request);
  if (what == "judge") return judged(request);
  if (what == "uncompiled") return uncompiled(request);
  if (what == "record") return recorded(request);
  if (what == "record_hint") return hint_recorded(request);
  if (what == "record_solution_shown") return solution_recorded(request);
  if (what == "empty_progress") return ProgressRecord().document();
  if (what == "report") return progress_report(book(), ProgressRecord(request.at("progress")));
  if (what == "problems") return problems();
  throw std::runtime_error("the judge does not know how to '" + what + "'");
}

std::string answer_text(std::string_view request) {
  json reply;
  try {
    reply = {{"ok", answer(json::parse(request))}};
  } catch (const std::exception& error) {
    reply = {{"error", error.what()}};
  }
  return reply.dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace

}  // namespace contact::grading

/// Room for a request of this many bytes; judge_answer frees it.
extern "C" __attribute__((export_name("judge_room"))) char* judge_room(std::size_t bytes) {
  return static_cast<char*>(std::malloc(bytes));
}

/// Takes a request, {"do": ..., ...}, and gives back {"ok": ...} or {"error": "..."}, which stays
/// until the next call.
extern "C" __attribute__((export_name("judge_answer"))) const char* judge_answer(
    char* request, std::size_t bytes) {
  static std::string reply;
  reply = contact::grading::answer_text({request, bytes});
  std::free(request);
  return reply.c_str();
}
