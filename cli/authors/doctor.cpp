// contact doctor: what is installed, what is missing, and what to do about it.

#include <regex>

#include <unistd.h>
#include <nlohmann/json.hpp>

#include "../../grading/build/build.hpp"
#include "../../grading/run/run.hpp"
#ifdef CONTACT_GRADE
#include "../../grading/sandbox/machine.hpp"
#endif
#include "../commands.hpp"
#include "../exercises/watch_files.hpp"
#include "../terminal/terminal.hpp"

namespace fs = std::filesystem;

namespace contact::cli {

namespace {

enum class Standing { good, advice, missing };

struct Finding {
  std::string what;
  Standing standing = Standing::good;
  std::string found;
  /// What to do; empty if nothing.
  std::string remedy;
};

struct Tool {
  std::string name;
  std::vector<std::string> command;
  std::vector<int> least;
  bool needed;
  std::string used_for;
};

std::vector<int> version_in(const std::string& text) {
  static const std::regex pattern(R"((\d+)\.(\d+)(?:\.(\d+))?)");
  std::smatch match;
  if (!std::regex_search(text, match, pattern)) return {};
  std::vector<int> version;
  for (std::size_t i = 1; i < match.size(); ++i) {
    if (match[i].matched) version.push_back(std::stoi(match[i]));
  }
  return version;
}

std::string text_of(const std::vector<int>& version) {
  std::string text;
  for (const int part : version) text += (text.empty() ? "" : ".") + std::to_string(part);
  return text;
}

Finding look_for(grading::Loop& loop, const Tool& tool) {
  Finding finding;
  finding.what = tool.name + " (" + tool.used_for + ")";
  const Standing otherwise = tool.needed ? Standing::missing : Standing::advice;
  grading::ProcessSpec spec;
  spec.command = tool.command;
  spec.time_limit = 20.0;
  std::vector<int> version;
  try {
    const grading::ProcessResult result = grading::run_process(loop, spec);
    if (result.succeeded()) version = version_in(result.output + result.errors);
  } catch (const std::runtime_error&) {
    // Not there: said below.
  }
  if (version.empty()) {
    finding.standing = otherwise;
    finding.found = "not found";
    finding.remedy = "./contact setup installs it";
    return finding;
  }
  finding.found = text_of(version);
  if (version < tool.least) {
    finding.standing = otherwise;
    finding.remedy = "version " + text_of(tool.least) + " or later is needed";
  }
  return finding;
}

void look_at_build(Context& context, std::vector<Finding>& findings) {
  const grading::Book& book = context.book();
  Finding finding;
  finding.what = "the build of the exercises";
  try {
    const grading::BuildDescription build = grading::read_build_description(book.build_dir());
    std::size_t stale = 0;
    for (const grading::Exercise& exercise : book.exercises())
      stale += grading::tests_are_stale(book, build, exercise) ? 1 : 0;
    finding.found = std::to_string(book.exercises().size() - stale) + " of " +
                    std::to_string(book.exercises().size()) + " exercises have their tests built";
    if (stale > 0) finding.remedy = "the rest is built when first checked";
  } catch (const grading::BookError& error) {
    finding.standing = Standing::missing;
    finding.found = "not there";
    finding.remedy = error.what();
  }
  findings.push_back(finding);
}

void look_at_book(Context& context, std::vector<Finding>& findings) {
  const grading::Book& book = context.book();
  Finding finding;
  finding.what = book.base() == nullptr ? "the book" : "the pack";
  finding.found = std::to_string(book.chapters().size()) + " chapters, " +
                  std::to_string(book.exercises().size()) + " exercises in " + book.root().string();
  findings.push_back(finding);
  for (const grading::BookProblem& problem : book.problems())
    findings.push_back({shown(problem.file), Standing::missing, "cannot be read", problem.what});
}

void look_at_work(Context& context, std::vector<Finding>& findings) {
  const fs::path work = context.book().work();
  Finding finding{"your copies", Standing::good, shown(work), ""};
  std::error_code error;
  fs::create_directories(work, error);
  if (error || ::access(work.c_str(), W_OK) != 0) {
    finding.standing = Standing::missing;
    finding.remedy = "the folder cannot be written to; set CONTACT_WORK to one that can";
  } else {
    const FileWatcher watcher(context.loop(), {work / "probe.cpp"}, false, [](const fs::path&) {});
    finding.found += watcher.polled().empty()
                         ? ": the system reports saves"
                         : ": no events arrive from there, so the files are polled";
  }
  findings.push_back(finding);
}

void look_at_limits(std::vector<Finding>& findings) {
  Finding finding{"temporary files and limits", Standing::good, "", ""};
  try {
    const grading::TemporaryFolder folder;
    const fs::space_info space = fs::space(folder.path());
    finding.found = shown(folder.path().parent_path()) + ": " +
                    std::to_string(space.available >> 20) + " MB free; your program may use " +
                    std::to_string(grading::limits_from_environment().memory_mb) + " MB of memory";
    if (space.available < (200u << 20)) {
      finding.standing = Standing::advice;
      finding.remedy = "a check needs space there: free some, or set TMPDIR";
    }
  } catch (const std::exception& error) {
    finding.standing = Standing::missing;
    finding.remedy = error.what();
  }
  findings.push_back(finding);
}

#ifdef CONTACT_GRADE
// What a submission could do to this machine if it were graded here.
nlohmann::json look_at_grading(Context& context, std::vector<Finding>& findings) {
  Finding finding{"grading untrusted submissions", Standing::good, "", ""};
  nlohmann::json report = nullptr;
  try {
    const grading::Machine machine = grading::examine_machine(context.loop());
    report = grading::to_json(machine);
    std::size_t held = 0;
    for (const grading::Measure& measure : machine.measures) {
      held += measure.enforced ? 1 : 0;
      if (!measure.enforced)
        finding.remedy += (finding.remedy.empty() ? "not enforced: " : "; ") + measure.what + " (" +
                          measure.how + ")";
    }
    finding.found = "level " + std::string(grading::words(machine.level)) + ", " +
                    std::to_string(held) + " of " + std::to_string(machine.measures.size()) +
                    " measures hold, each tried";
    if (machine.level != grading::Level::full) finding.standing = Standing::advice;
  } catch (const std::runtime_error& error) {
    finding.standing = Standing::advice;
    finding.found = "cannot be tried";
    finding.remedy = error.what();
  }
  findings.push_back(finding);
  return report;
}
#else
nlohmann::json look_at_grading(Context& /*context*/, std::vector<Finding>& findings) {
  findings.push_back({"grading untrusted submissions", Standing::advice, "not here",
                      "`contact grade` needs Linux"});
  return nullptr;
}
#endif

int run(Context& context, bool json) {
  std::string compiler = "c++";
  try {
    compiler = grading::read_build_description(context.book().build_dir()).compiler;
  } catch (const grading::BookError&) {
    // Said by look_at_build; the system's own compiler is looked at instead.
  }
  const std::string python =
      (context.book().book_root() / "build" / "venv" / "bin" / "python").string();
  const std::vector<Tool> tools = {
      {"C++ compiler", {compiler, "--version"}, {12}, true, "exercises"},
      {"CMake", {"cmake", "--version"}, {3, 25}, true, "exercises"},
      {"Ninja", {"ninja", "--version"}, {1, 10}, true, "exercises"},
      {"Python", {"python3", "--version"}, {3, 11}, true, "exercises and the book"},
      {"Python packages in build/venv",
       {python, "--version"},
       {3, 11},
       true,
       "exercises and the book"},
      {"nm", {"nm", "--version"}, {2}, false, "better messages when a function is missing"},
      {"Node", {"node", "--version"}, {18}, false, "the book's page"},
      {"Doxygen", {"doxygen", "--version"}, {1, 9}, false, "the book's API pages"},
  };
  std::vector<Finding> findings;
  look_at_book(context, findings);
  for (const Tool& tool : tools) findings.push_back(look_for(context.loop(), tool));
  look_at_build(context, findings);
  look_at_work(context, findings);
  look_at_limits(findings);
  const nlohmann::json grading = look_at_grading(context, findings);

  const Style style(stdout);
  nlohmann::json list = nlohmann::json::array();
  bool missing = false;
  for (const Finding& finding : findings) {
    missing = missing || finding.standing == Standing::missing;
    const std::string word = finding.standing == Standing::good     ? "ok"
                             : finding.standing == Standing::advice ? "advice"
                                                                    : "missing";
    if (json) {
      list.push_back({{"what", finding.what},
                      {"standing", word},
                      {"found", finding.found},
                      {"remedy", finding.remedy}});
      continue;
    }
    const std::string mark = padded(word, 9);
    say((finding.standing == Standing::good     ? style.good(mark)
         : finding.standing == Standing::advice ? style.warn(mark)
                                                : style.bad(mark)) +
        finding.what + ": " + finding.found);
    if (!finding.remedy.empty()) say(wrapped(finding.remedy, 11));
  }
  if (json)
    say(nlohmann::json{{"format", "contact-doctor/1"}, {"findings", list}, {"grading", grading}}
            .dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
  if (missing && !json)
    say("\nSomething is missing: ./contact setup installs what it can and says the rest.");
  return missing ? exit_trouble : exit_passed;
}

}  // namespace

void add_doctor(Command app, Action& action) {
  auto json = std::make_shared<bool>(false);
  const Command command = app.add_subcommand(doctor_command);
  command.add_flag("--json", *json, "Print JSON");
  command.callback(
      [&action, json] { action = [json](Context& context) { return run(context, *json); }; });
}

}  // namespace contact::cli
