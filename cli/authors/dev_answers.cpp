// What stubs, solutions, wrong answers and null answers must get.

#include <ctime>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <regex>
#include <sstream>

#include "../python.hpp"
#include "../terminal/terminal.hpp"
#include "dev_check.hpp"

namespace fs = std::filesystem;

namespace contact::cli {

namespace {

using grading::Exercise;
using grading::TestStatus;
using grading::TestVerdict;
using grading::Verdict;

// As grading/contract/null_answers.hpp knows them; an answer that is asked for another crashes.
constexpr std::array null_kinds{"zeros", "nan",    "infinity", "minus_infinity",
                                "huge",  "random", "echo"};

std::string told(const TestVerdict& test) {
  std::string text = "'" + test.name + "' is " + std::string(grading::words(test.status));
  if (!test.failure.reason.empty())
    text += " (" + test.failure.reason + ")";
  else if (!test.failure.got.empty())
    text += " (got " + test.failure.got + ", right " + test.failure.right + ")";
  return text;
}

void check_stub(const Verdict& verdict, std::vector<std::string>& problems) {
  for (const TestVerdict& test : verdict.tests) {
    if (test.status != TestStatus::not_attempted)
      problems.push_back(told(test) + "; a stub is not attempted");
  }
}

// A student with a similar answer would be told of a mistake in C++ that is not theirs, or not the
// one that the answer is about.
void check_silence(const Verdict& verdict, std::vector<std::string>& problems) {
  for (const grading::Remark& remark : verdict.remarks)
    problems.push_back("line " + std::to_string(remark.line) +
                       " would be remarked upon: " + remark.words);
}

// A reader's machine may be slower, and a right answer too.
constexpr double min_margin = 8.0;

// Processor time of slowness()'s loop, measured: the median of five on an otherwise idle machine
// with two cores of an AMD EPYC.
constexpr double usual_seconds = 0.018;

double processor_seconds() {
  timespec now{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// How many times as long as usual this machine takes now to fill a map; at least 1. Where other
// systems share its memory, that can be three times, though plain arithmetic is as quick as ever.
double slowness() {
  const double began = processor_seconds();
  std::map<std::uint64_t, int> filled;
  std::uint64_t state = 88172645463325252U;
  for (int i = 0; i < 50'000; ++i) {
    state ^= state << 13U;
    state ^= state >> 7U;
    state ^= state << 17U;
    filled[state] = i;
  }
  return std::max(1.0, (processor_seconds() - began) / usual_seconds);
}

void check_solution_time(const Exercise& exercise, const TestVerdict& test,
                         std::vector<std::string>& problems) {
  for (const grading::TestSpec& spec : exercise.tests) {
    const double may_take = exercise.check_seconds(spec);
    if (spec.name != test.name || min_margin * test.processor_seconds <= may_take) continue;
    if (min_margin * test.processor_seconds <= may_take * slowness()) continue;
    problems.push_back("'" + spec.name + "' takes " + grading::points_text(test.processor_seconds) +
                       " s, and a reader's answer only has " + grading::points_text(may_take) +
                       " s: ask less, or give the test its solution_seconds (20 times as much is "
                       "allowed, up to 3 s)");
  }
}

void check_solution(const Exercise& exercise, const Verdict& verdict,
                    std::vector<std::string>& problems) {
  for (const TestVerdict& test : verdict.tests) {
    if (test.status != TestStatus::passed) problems.push_back(told(test));
    check_solution_time(exercise, test, problems);
  }
  for (const std::string& name : verdict.missing_tests)
    problems.push_back("exercise.toml lists a test that is not compiled: '" + name + "'");
  for (const std::string& name : verdict.unlisted_tests)
    problems.push_back("a compiled test is not in exercise.toml: '" + name + "'");
  if (!verdict.in_order)
    problems.push_back("exercise.toml lists the tests in another order than they run");
  if (verdict.points != verdict.max_points) problems.push_back("it does not earn every point");
  if (!verdict.warnings.empty())
    problems.push_back("the compiler warns: " + verdict.warnings.front());
}

std::string inputs_of(const grading::Failure& failure) {
  std::string text;
  for (const auto& [name, value] : failure.inputs)
    text += (text.empty() ? "" : ", ") + name + " = " + value;
  return text;
}

// A wrong answer is told its own mistake and no other, from the first question that it gets wrong.
// So any two with different mistakes are told apart there.
void check_recognised(const WrongAnswer& wrong, const TestVerdict& caught,
                      std::vector<std::string>& problems) {
  const std::vector<std::string>& seen = caught.failure.misconceptions;
  const std::string where = "'" + caught.name + "', asked with " + inputs_of(caught.failure) + ", ";
  if (wrong.misconception == no_misconception) {
    for (const std::string& id : seen) problems.push_back(where + "recognises " + id + ", untruly");
    return;
  }
  if (std::find(seen.begin(), seen.end(), wrong.misconception) == seen.end())
    problems.push_back(where + "does not recognise " + wrong.misconception);
  for (const std::string& id : seen) {
    if (id != wrong.misconception)
      problems.push_back(where + "cannot tell " + wrong.misconception + " from " + id);
  }
}

void check_wrong(const grading::Book& book, const AnswerJob& job, const Verdict& verdict,
                 std::vector<std::string>& problems) {
  const WrongAnswer wrong = read_wrong_answer(job.file);
  const auto caught =
      std::find_if(verdict.tests.begin(), verdict.tests.end(),
                   [&](const TestVerdict& test) { return test.name == wrong.caught_by; });
  if (caught == verdict.tests.end()) {
    problems.push_back("the test that it names does not exist: '" + wrong.caught_by + "'");
    return;
  }
  if (caught->status != TestStatus::failed) {
    problems.push_back("it should fail where it does not: " + told(*caught));
    return;
  }
  if (const TestVerdict* first = grading::first_failure(verdict); first->name != wrong.caught_by)
    problems.push_back("an earlier test catches it: " + told(*first));
  check_recognised(wrong, *caught, problems);
  if (wrong.misconception != no_misconception && book.hint_for(wrong.misconception).empty())
    problems.push_back("there is no hint for " + wrong.misconception);
}

void check_null(const Verdict& verdict, std::vector<std::string>& problems) {
  for (const TestVerdict& test : verdict.tests) {
    if (test.points > 0.0)
      problems.push_back("it earns " + grading::points_text(test.points) + " for '" + test.name +
                         "': let that test require another, or ask for more");
    if (test.status == TestStatus::stopped) problems.push_back(told(test));
  }
}

void check_verdict(const grading::Book& book, const AnswerJob& job, const Verdict& verdict,
                   std::vector<std::string>& problems) {
  if (job.kind == "form to fill") {
    if (!verdict.compile_error) problems.emplace_back("it compiles although its gaps are empty");
    return;
  }
  if (verdict.compile_error) {
    problems.push_back("it does not compile: " + verdict.compile_error->message + " (" +
                       shown(verdict.compile_error->file) + ":" +
                       std::to_string(verdict.compile_error->line) + ")");
    return;
  }
  if (job.kind == "solution" || job.kind == "wrong answer") check_silence(verdict, problems);
  if (job.kind == "stub" || job.kind == "form to order") {
    check_stub(verdict, problems);
  } else if (job.kind == "solution") {
    check_solution(*job.exercise, verdict, problems);
  } else if (job.kind == "wrong answer") {
    check_wrong(book, job, verdict, problems);
  } else {
    check_null(verdict, problems);
  }
}

bool same_text(const fs::path& a, const fs::path& b) {
  try {
    return grading::read_text(a) == grading::read_text(b);
  } catch (const grading::BookError&) {
    return false;
  }
}

bool is_patch(const fs::path& file) { return file.extension() == ".patch"; }

// The null answer, and the generated proxy and server again, to compare with those of the build.
std::vector<std::string> generate(grading::Loop& loop, const grading::Book& book,
                                  const Exercise& exercise, const fs::path& folder) {
  const fs::path python = python_of(book);
  const fs::path generators = book.book_root() / "grading" / "contract";
  const fs::path proxy = folder / "proxy";
  const fs::path server = folder / "server";
  const std::vector<std::vector<std::string>> commands = {
      {python.string(), (generators / "null_answers.py").string(), exercise.contract.string(),
       "--output", folder.string()},
      {python.string(), (generators / "contract_generator.py").string(), exercise.contract.string(),
       "--proxy", proxy.string(), "--server", server.string()}};
  std::vector<std::string> problems;
  for (const std::vector<std::string>& command : commands) {
    const grading::ProcessResult result = run_python(loop, command);
    if (!result.succeeded()) {
      problems.push_back(fs::path(command[1]).filename().string() + " failed: " + result.errors +
                         result.output);
      return problems;
    }
  }
  const fs::path built = book.build_dir() / "exercises" / exercise.chapter / exercise.name;
  if (!same_text(proxy, built / (exercise.name + ".proxy.cpp")) ||
      !same_text(server, built / (exercise.name + ".server.cpp")))
    problems.push_back("the generated proxy or server in the build is not current");
  return problems;
}

}  // namespace

WrongAnswer read_wrong_answer(const fs::path& file) {
  std::istringstream text(grading::read_text(file));
  WrongAnswer wrong;
  wrong.file = file;
  const auto value = [&](const std::string& mark) {
    std::string line;
    std::getline(text, line);
    if (!line.starts_with(mark) || line.size() == mark.size())
      throw grading::BookError("it must begin with `" + mark + "...`, but the line is `" + line +
                               "`");
    return line.substr(mark.size());
  };
  wrong.misconception = value("// misconception: ");
  wrong.caught_by = value("// caught by: ");
  wrong.seen = value("// seen: ");
  static const std::regex names(
      R"(https?://\S+.*|(L20|FCA|GP3), (a )?slide.*|a first reader .*|this book before [0-9a-f]{8,}.*|not found)");
  if (!std::regex_match(wrong.seen, names))
    throw grading::BookError("`// seen: " + wrong.seen +
                             "` names no place: an address, a lecture and its slide, `a first "
                             "reader of ...`, `this book before COMMIT`, or `not found`");
  return wrong;
}

std::vector<fs::path> wrong_answer_files(const Exercise& exercise) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(exercise.wrong_answers, error)) {
    if (entry.path().extension() == ".cpp" || is_patch(entry.path())) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<DevResult> apply_patches(grading::Loop& loop, const grading::Book& book,
                                     const std::vector<const Exercise*>& exercises,
                                     const fs::path& folder) {
  std::vector<std::string> command{python_of(book).string(),
                                   (book.book_root() / "grading/book/wrong_answers.py").string(),
                                   "--root",
                                   book.root().string(),
                                   "--output",
                                   (folder / "wrong").string()};
  std::vector<std::pair<std::string, fs::path>> patches;
  for (const Exercise* exercise : exercises) {
    const std::vector<fs::path> files = wrong_answer_files(*exercise);
    if (std::none_of(files.begin(), files.end(), is_patch)) continue;
    command.push_back(exercise->id());
    for (const fs::path& file : files) {
      if (is_patch(file)) patches.emplace_back(exercise->id() + "/" + file.stem().string(), file);
    }
  }
  if (patches.empty()) return {};
  const grading::ProcessResult result = run_python(loop, command);
  std::vector<DevResult> results;
  for (const auto& [name, file] : patches) {
    if (fs::exists(folder / "wrong" / (name + ".cpp"))) continue;
    // It prints `FILE: WHY`, a line each, with the file as seen from the root.
    const std::string begin = file.lexically_relative(book.root()).string() + ": ";
    DevResult refused{"wrong answer", name, {}};
    std::istringstream lines(result.output);
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with(begin))
        refused.problems.push_back(shown(file) + ": " + line.substr(begin.size()));
    }
    if (refused.problems.empty())
      refused.problems.push_back("wrong_answers.py failed: " + result.errors + result.output);
    results.push_back(std::move(refused));
  }
  return results;
}

std::vector<DevResult> write_forms(grading::Loop& loop, const grading::Book& book,
                                   const std::vector<const Exercise*>& exercises,
                                   const fs::path& folder) {
  std::vector<std::string> command{python_of(book).string(),
                                   (book.book_root() / "grading/book/forms.py").string(),
                                   "--root",
                                   book.root().string(),
                                   "--check",
                                   "--output",
                                   (folder / "forms").string()};
  for (const Exercise* exercise : exercises) command.push_back(exercise->id());
  const grading::ProcessResult result = run_python(loop, command);
  if (!result.errors.empty()) return {{"marks", "forms.py", {"it failed: " + result.errors}}};
  std::vector<DevResult> results;
  for (const Exercise* exercise : exercises) {
    // It prints `EXERCISE: WHY`, a line each.
    DevResult marks{"marks", exercise->id(), {}};
    std::istringstream lines(result.output);
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with(exercise->id() + ": "))
        marks.problems.push_back(line.substr(exercise->id().size() + 2));
    }
    if (!marks.problems.empty() || fs::exists(folder / "forms" / exercise->id()))
      results.push_back(std::move(marks));
  }
  return results;
}

std::vector<AnswerJob> answer_jobs(const std::vector<const Exercise*>& exercises,
                                   const fs::path& folder) {
  std::vector<AnswerJob> jobs;
  for (const Exercise* exercise : exercises) {
    jobs.push_back({"stub", exercise->id(), exercise, exercise->stub});
    jobs.push_back({"solution", exercise->id(), exercise, exercise->solution});
    for (const fs::path& file : wrong_answer_files(*exercise)) {
      const std::string answer = exercise->id() + "/" + file.stem().string();
      const fs::path whole = is_patch(file) ? folder / "wrong" / (answer + ".cpp") : file;
      if (fs::exists(whole)) jobs.push_back({"wrong answer", answer, exercise, whole});
    }
    for (const std::string form : {"order", "fill"}) {
      const fs::path file = folder / "forms" / exercise->id() / (form + ".cpp");
      if (fs::exists(file)) jobs.push_back({"form to " + form, exercise->id(), exercise, file});
    }
    jobs.push_back({"null answer", exercise->id(), exercise,
                    folder / exercise->chapter / exercise->name / "null.cpp"});
  }
  return jobs;
}

std::vector<DevResult> check_answer(grading::Loop& loop, const grading::Book& book,
                                    const grading::BuildDescription& build, const AnswerJob& job,
                                    const grading::Limits& limits) {
  const bool null = job.kind == "null answer";
  std::vector<DevResult> results;
  std::vector<std::string> more_include;
  std::vector<grading::Environment> environments;
  if (null) {
    fs::create_directories(job.file.parent_path());
    results.push_back(
        {"generated code", job.name, generate(loop, book, *job.exercise, job.file.parent_path())});
    more_include.push_back((book.book_root() / "grading").string());
    for (const char* kind : null_kinds) environments.push_back({{"CONTACT_NULL_ANSWER", kind}});
  } else {
    environments.emplace_back();
  }
  std::vector<Verdict> verdicts;
  try {
    verdicts = grading::check_file_in_each(loop, book, build, *job.exercise, job.file, limits,
                                           more_include, environments);
  } catch (const grading::BookError& error) {
    results.push_back({job.kind, job.name, {error.what()}});
  }
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    DevResult result{job.kind, job.name, {}};
    if (null) result.name += std::string("/") + null_kinds.at(i);
    try {
      check_verdict(book, job, verdicts[i], result.problems);
    } catch (const grading::BookError& error) {
      result.problems.emplace_back(error.what());
    }
    results.push_back(std::move(result));
  }
  return results;
}

}  // namespace contact::cli
