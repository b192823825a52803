// contact dev mutants: whether the tests of exercises catch small changes of their solutions, and
// what they say of them. The mutants are made at the syntax tree, by grading/mutants in Python.

#include "dev_mutants.hpp"

#include <cstdio>

#include "../python.hpp"
#include "../terminal/terminal.hpp"
#include "dev_check.hpp"

namespace contact::cli {

namespace {

struct Options {
  std::vector<std::string> names;
  bool json = false;
  unsigned jobs = 0;
  double limit = 0.0;
  unsigned sample = 0;
  std::string seed;
  std::string write;
  std::string hints;
  bool keep = false;
};

int run(Context& context, const Options& options) {
  const grading::Book& book = context.book();
  const std::vector<const grading::Exercise*> exercises = book.chosen(options.names);
  grading::ready_build(context.loop(), book, exercises);
  grading::ProcessSpec spec;
  spec.command = {python_of(book).string(),
                  (book.root() / "grading/mutants/mutants.py").string(),
                  "--root",
                  book.root().string(),
                  "--build",
                  book.build_dir().string()};
  const auto add = [&](bool wanted, const std::string& option, const std::string& value) {
    if (wanted) spec.command.insert(spec.command.end(), {option, value});
  };
  add(options.jobs > 0, "--jobs", std::to_string(options.jobs));
  add(options.limit > 0, "--limit", std::to_string(options.limit));
  add(options.sample > 0, "--sample", std::to_string(options.sample));
  add(!options.seed.empty(), "--seed", options.seed);
  add(!options.write.empty(), "--write", options.write);
  add(!options.hints.empty(), "--hints", options.hints);
  if (options.keep) spec.command.emplace_back("--keep");
  if (options.json) spec.command.emplace_back("--json");
  for (const grading::Exercise* exercise : exercises) spec.command.push_back(exercise->id());
  spec.environment = {{"PYTHONDONTWRITEBYTECODE", "1"}};
  spec.on_output = [](std::string_view text) {
    std::fwrite(text.data(), 1, text.size(), stdout);
    std::fflush(stdout);
  };
  const grading::ProcessResult done = grading::run_process(context.loop(), spec);
  if (done.succeeded()) return exit_passed;
  std::fputs(done.errors.c_str(), stderr);
  return exit_not_passed;
}

}  // namespace

void add_dev_mutants(Command dev, Action& action) {
  auto options = std::make_shared<Options>();
  const Command command = dev.add_subcommand(
      "mutants", "Try small changes of solutions: which do the tests catch, and with which hint");
  command.add_option("exercise", options->names,
                     "Only these exercises, or those of these chapters");
  command.add_option("--jobs", options->jobs, "Mutants tried in parallel (default: one per core)");
  command.add_option("--limit", options->limit,
                     "Begin no exercise after so many seconds of processor time");
  command.add_option("--sample", options->sample, "Draw so many hints, for a reader to judge");
  command.add_option("--seed", options->seed, "Draw them by this text");
  command.add_option("--write", options->write, "Write them to this file");
  command.add_option("--hints", options->hints,
                     "Write all hints to this file, one JSON object a line");
  command.add_flag("--keep", options->keep, "Store the counts in grading/mutants/kept");
  command.add_flag("--json", options->json, "Print JSON");
  command.callback([&action, options] {
    action = [options](Context& context) { return run(context, *options); };
  });
}

}  // namespace contact::cli
