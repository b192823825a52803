// contact dev grade-unit and call-time: grading looked at from close by, one unit or one call at a
// time.

#include <algorithm>

#include <nlohmann/json.hpp>

#include "../../grading/grade/broker.hpp"
#include "../../grading/grade/calibrate.hpp"
#include "../../grading/grade/profile.hpp"
#include "../commands.hpp"
#include "../exercises/report.hpp"
#include "../terminal/terminal.hpp"

namespace fs = std::filesystem;

namespace contact::cli {

namespace {

using grading::Exercise;

struct Options {
  std::vector<std::string> files;
  std::string exercise;
  std::string seed;
  std::string profile;
  double seconds = 0.0;
  double compile_seconds = 0.0;
  bool json = false;
  bool as_built = false;
};

int grade_units(Context& context, const Options& options) {
  const grading::Book& book = context.book();
  std::vector<const Exercise*> exercises;
  for (const std::string& file : options.files)
    exercises.push_back(&book.exercise(options.exercise.empty() ? file : options.exercise));
  std::vector<const Exercise*> once = exercises;
  std::sort(once.begin(), once.end());
  once.erase(std::unique(once.begin(), once.end()), once.end());
  const grading::BuildDescription build = options.as_built
                                              ? grading::read_build_description(book.build_dir())
                                              : grading::ready_to_grade(context.loop(), book, once);
  const grading::Machine machine = grading::examine_machine(context.loop());
  const grading::Seat seat(machine);

  bool passed = true;
  nlohmann::json results = nlohmann::json::array();
  for (std::size_t i = 0; i < options.files.size(); ++i) {
    const Exercise& exercise = *exercises[i];
    grading::UnitSettings settings;
    settings.seed = options.seed;
    if (!options.profile.empty()) settings.limits = grading::read_profile(options.profile);
    if (options.compile_seconds > 0.0)
      settings.limits.compile_cpu_seconds = options.compile_seconds;
    settings.test_cpu_seconds = options.seconds > 0.0 ? options.seconds : exercise.time_limit;
    const grading::UnitResult unit =
        grading::grade_unit(context.loop(), book, build, machine, seat, exercise,
                            grading::read_text(options.files[i]), settings);
    passed = passed && unit.verdict.outcome == grading::Outcome::passed;
    if (!options.json) {
      say(report(unit.verdict, Style(stdout), {}));
      continue;
    }
    nlohmann::json result = grading::to_json(unit.verdict);
    result["near_limit"] = unit.near_limit;
    result["slowest_test"] = unit.slowest_test;
    result["seconds"]["unit"] = unit.seconds;
    results.push_back(std::move(result));
  }
  if (options.json)
    say(nlohmann::json{{"format", "contact-dev-grade-unit/1"},
                       {"level", grading::words(machine.level)},
                       {"results", results}}
            .dump(1, ' ', false, nlohmann::json::error_handler_t::replace));
  return passed ? exit_passed : exit_not_passed;
}

// The same program asks, once directly and once with a sandbox around each process.
int call_time(Context& context, bool json) {
  const grading::Book& book = context.book();
  grading::build_target(context.loop(), book,
                        {"remote_calls", "remote_specimen", "contact-box", "contact-explain"});
  const fs::path asks = book.build_dir() / "bin" / "remote_calls";
  const fs::path answers = book.build_dir() / "bin" / "remote_specimen";

  grading::ProcessSpec bare;
  bare.command = {asks.string()};
  bare.environment = {{"CONTACT_SERVER", "[\"" + answers.string() + "\", \"behaves\"]"}};
  const grading::ProcessResult unboxed = grading::run_process(context.loop(), bare);

  const grading::Machine machine = grading::examine_machine(context.loop());
  const grading::Seat seat(machine);
  grading::BoxSpec answer;
  answer.command = {"/answer", "behaves"};
  answer.read_only = {{answers, "/answer"}};
  grading::AnswerTime time;
  time.cpu_seconds = 60.0;
  grading::Broker broker(context.loop(), machine, seat, answer, time);
  grading::BoxSpec judge;
  judge.kind = grading::BoxKind::judge;
  judge.command = {"/tests"};
  judge.read_only = {{asks, "/tests"}};
  judge.environment = {{"CONTACT_BROKER", "3"}};
  judge.descriptors = {{broker.judge_end(), 3}};
  grading::Box box(context.loop(), machine, seat, judge);
  broker.let_go_of_judge_end();
  while (!box.ended()) {
    context.loop().run_once();
    broker.serve(box);
  }
  const grading::ProcessResult boxed = box.wait().process;
  for (const grading::ProcessResult* ran : {&unboxed, &boxed}) {
    if (!ran->succeeded())
      throw grading::BookError("the calls were not answered: " + ran->output + ran->errors);
  }
  const double without = std::stod(unboxed.output), with = std::stod(boxed.output);
  if (json)
    say(nlohmann::json{{"format", "contact-dev-call-time/1"},
                       {"level", grading::words(machine.level)},
                       {"microseconds", {{"without_boxes", without}, {"in_boxes", with}}}}
            .dump(1));
  else
    say("A call across the proxy takes " + grading::points_text(with) + " microseconds in boxes, " +
        grading::points_text(without) + " without (medians).");
  return exit_passed;
}

}  // namespace

void add_dev_grade(Command dev, Action& action) {
  auto options = std::make_shared<Options>();
  const Command unit = dev.add_subcommand(
      "grade-unit", "Grade files as `contact grade` does: compiled, run and judged in sandboxes");
  unit.add_option("file", options->files, "Answers; a path that names its exercise says which")
      .required()
      .existing_file();
  unit.add_option("--exercise", options->exercise, "The exercise that all of them answer");
  unit.add_option("--seed", options->seed, "Seed of the random cases");
  unit.add_option("--profile", options->profile, "Limits, as `contact grade` takes them")
      .existing_file();
  unit.add_option("--seconds", options->seconds, "Processor time of a test");
  unit.add_option("--compile-seconds", options->compile_seconds,
                  "Processor time of the compiler and of the linker");
  unit.add_flag("--as-built", options->as_built, "Build nothing before");
  unit.add_flag("--json", options->json, "Print JSON");
  unit.callback([&action, options] {
    action = [options](Context& context) { return grade_units(context, *options); };
  });
  const Command call =
      dev.add_subcommand("call-time", "Measure a call from the tests to a submission");
  call.add_flag("--json", options->json, "Print JSON");
  call.callback([&action, options] {
    action = [options](Context& context) { return call_time(context, options->json); };
  });
}

}  // namespace contact::cli
