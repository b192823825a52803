// contact simulate: runs scenes as their plans decide, by a formula, event-driven or step by step.

#include <algorithm>
#include <atomic>
#include <csignal>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include <contact/plan/plan.hpp>
#include <contact/scene/scene_file.hpp>

#include "../commands.hpp"
#include "../terminal/terminal.hpp"
#include "run_output.hpp"
#include "simulation.hpp"

namespace contact::cli {

namespace {

using Options = SimulateOptions;
using Outcome = SimulateOutcome;

extern "C" void interrupt_simulations(int /*signal*/) { simulate_interruption = true; }

/// Several scenes, some at a time; each runs alone, with the same result as by itself.
std::vector<Outcome> side_by_side(const Options& options, std::vector<Planned> all) {
  const auto cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  const std::size_t workers =
      std::min(static_cast<std::size_t>(options.jobs > 0 ? options.jobs : cores), all.size());
  std::vector<Outcome> outcomes(all.size());
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  std::exception_ptr failure;
  ProgressLine progress(all.size());
  const auto work = [&] {
    try {
      for (std::size_t i = next++; i < all.size() && !simulate_interruption; i = next++) {
        outcomes[i] = simulated(options, std::move(all[i]), progress, i);
        progress.done(i);
      }
    } catch (...) {
      const std::lock_guard<std::mutex> lock(mutex);
      if (!failure) failure = std::current_exception();
      next = all.size();
    }
  };
  {
    std::vector<std::jthread> threads;
    for (std::size_t i = 1; i < workers; ++i) threads.emplace_back(work);
    work();
  }
  if (failure) std::rethrow_exception(failure);
  return outcomes;
}

/// Options that name one file cannot serve several scenes.
void require_one_scene(const Options& options) {
  if (options.scenes.size() == 1) return;
  for (const auto& [option, text] :
       {std::pair("--output", &options.output), std::pair("--events", &options.events),
        std::pair("--checkpoint", &options.checkpoint), std::pair("--resume", &options.resume)})
    if (!text->empty())
      throw grading::UnknownName(std::string(option) + " is for one scene, and " +
                                 std::to_string(options.scenes.size()) +
                                 " are given: simulate them one by one");
}

int run(const Options& options) {
  if (!options.output.empty() && !is_trajectory_name(options.output))
    throw grading::UnknownName("--output " + options.output + " must end in .xyz or .csv");
  require_one_scene(options);
  for (const auto& [option, text] :
       {std::pair("--until", &options.until), std::pair("--every", &options.every)})
    if (!text->empty()) seconds_of(option, *text, true);
  const PlanOptions wanted = typed_plan_options(options.plan);
  std::vector<Planned> all;
  for (const std::string& name : options.scenes) {
    Scene scene = scenes::read_scene(scene_path(name));
    // The proofs hold for this duration.
    if (!options.until.empty())
      scene.duration = std::max(scene.duration, seconds_of("--until", options.until, true));
    Plan plan = plan_scene(scene, wanted);
    if (!options.until.empty()) {
      const double until = seconds_of("--until", options.until, true);
      const double every =
          options.every.empty() ? scene.output.every : seconds_of("--every", options.every, true);
      require_possible_run(until, every, plan);
    }
    all.push_back({std::move(scene), std::move(plan)});
  }
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, interrupt_simulations);
  const std::vector<Outcome> outcomes = side_by_side(options, std::move(all));
  int code = exit_passed;
  nlohmann::json several = nlohmann::json::array();
  for (const Outcome& outcome : outcomes) {
    code = std::max(code, outcome.code);
    if (!outcome.said.empty()) say(outcome.said.substr(0, outcome.said.size() - 1));
    if (!outcome.noted.empty()) note(outcome.noted.substr(0, outcome.noted.size() - 1));
    if (!outcome.json.is_null()) several.push_back(outcome.json);
  }
  if (options.json && !several.empty())
    say((outcomes.size() == 1 ? several.front() : several).dump(1));
  return simulate_interruption ? exit_interrupted : code;
}

}  // namespace

void add_simulate(Command app, Action& action) {
  auto options = std::make_shared<Options>();
  const Command command = app.add_subcommand(simulate_command);
  command
      .add_option("SCENE", options->scenes,
                  "Scene files, or names of scenes of the book; several are run side by side")
      .required();
  command.add_option("--output", options->output,
                     "Trajectories: extended XYZ (.xyz) or a table (.csv)");
  command.add_option("--every", options->every, "Seconds between two frames (default: the scene's)")
      .type_name("SECONDS");
  command.add_option("--events", options->events, "A table of all hits (.csv)");
  command.add_option("--until", options->until, "Stop at this time (default: the scene's end)")
      .type_name("SECONDS");
  command.add_option("--max-events", options->max_events, "Stop with an error after so many hits")
      .positive();
  command
      .add_option("--event-budget", options->event_budget,
                  "Event-driven: go on step by step after so many hits")
      .positive();
  add_plan_words(command, options->plan);
  command.add_option("--checkpoint", options->checkpoint,
                     "Save the state here at the end, on Ctrl-C and from time to time");
  command.add_option("--resume", options->resume,
                     "Resume from a checkpoint; --output and --events continue their files");
  command.add_option("--jobs", options->jobs, "Scenes at a time (default: one a core)")
      .between(1, 1024);
  command.add_flag("--expect", options->expect, "Compare the results with what the scene expects");
  command.add_flag("--strict", options->strict,
                   "Exit code 1 if a part of the run is not known to keep the tolerance");
  command.add_flag("--json", options->json, "Print JSON");
  command.callback([&action, options] { action = [options](Context&) { return run(*options); }; });
}

}  // namespace contact::cli
