#include "simulation.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>

#include <contact/plan/plan.hpp>
#include <contact/scene/free_flight_run.hpp>
#include <contact/scene/make_scene_run.hpp>
#include <contact/scene/scene_file.hpp>
#include <contact/scene/scene_runs.hpp>

#include "../commands.hpp"
#include "../terminal/terminal.hpp"
#include "run_output.hpp"

namespace contact::cli {

std::atomic<bool> simulate_interruption = false;

namespace {

using Options = SimulateOptions;
using Outcome = SimulateOutcome;

/// How many steps between two looks for Ctrl-C.
constexpr std::uint64_t steps_at_a_time = 1;

/// A time for the line of progress: four digits.
std::string short_text(double seconds) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.4g", seconds);
  return text.data();
}

/// How a simulation ended, and what it found.
enum class Ending { complete, out_of_events, endless_hits, interrupted };

struct Checked {
  const SceneExpectation* wanted;
  std::optional<double> got;  // nothing: its time was before the run was resumed, or never came

  [[nodiscard]] bool met() const { return got && std::abs(*got - wanted->value) <= wanted->within; }
};

/// One scene.
class Simulation {
 public:
  Simulation(Options options, Scene scene, const Plan& plan, ProgressLine& line, std::size_t piece)
      : options_(std::move(options)),
        line_(line),
        piece_(piece),
        scene_(std::move(scene)),
        run_(scenes::make_run(scene_, plan, options_.event_budget)),
        way_(flies_freely(plan) ? "everything flies freely, by a formula"
                                : "hard, smooth balls from event to event"),
        plan_number_(plan_number(plan)) {
    if (!options_.every.empty()) scene_.output.every = seconds_of("--every", options_.every, true);
    until_ = options_.until.empty() ? scene_.duration : seconds_of("--until", options_.until, true);
    first_energy_ = run_->energy();
    open_files();
    for (const SceneExpectation& wanted : scene_.expect) checked_.push_back({&wanted, {}});
  }

  Outcome go() {
    const Ending ending = advance_to_end();
    // What is due once only comes after what a resumed run keeps.
    if (!options_.checkpoint.empty()) keep();
    if (events_) {
      Writer writer(*this);
      run_->tell_unfinished(writer);
    }
    if (ending != Ending::interrupted && output_ && last_frame_ != run_->now()) add_frame();
    if (output_) output_->flush();
    if (events_) events_->flush();
    Outcome outcome = report(ending);
    const bool failed = std::any_of(checked_.begin(), checked_.end(), [](const Checked& checked) {
      return checked.got && !checked.met();
    });
    if (options_.expect && failed) outcome.code = exit_not_passed;
    if (ending != Ending::complete) outcome.code = exit_trouble;
    if (ending == Ending::interrupted) outcome.code = exit_interrupted;
    return outcome;
  }

 private:
  /// Writes hits as they come.
  struct Writer final : SceneObserver {
    explicit Writer(Simulation& of) : simulation(of) {}
    Simulation& simulation;
    bool on_hit(const SceneHit& hit) override {
      simulation.events_->add(hit_line(simulation.scene_, hit));
      return true;
    }
  };

  /// What is on, and the step: two runs of a scene with the same move alike.
  static std::string plan_number(const Plan& plan) {
    std::string number = shortest_text(plan.step);
    for (const Decision& decision : plan.decisions) {
      number += decision.on ? "1" : "0";
      if (decision.overridden) number += "!";
    }
    return number;
  }

  [[nodiscard]] RunView view() const { return {scene_, *run_}; }

  void open_files() {
    std::optional<RunCheckpoint> from;
    if (!options_.resume.empty()) {
      from = read_checkpoint(options_.resume);
      if (from->scene != scene_number(scene_)) {
        throw std::runtime_error(options_.resume + " was kept by a run of another scene than " +
                                 options_.scenes.front());
      }
      if (from->plan != plan_number_)
        throw std::runtime_error(options_.resume +
                                 " was kept by a run with another plan: the same " +
                                 "--with, --without and --step go on with it");
      run_->restore(from->state);
      frames_ = from->frames;
      resumed_at_ = from->state.now;
      if (frames_ > 0) last_frame_ = static_cast<double>(frames_ - 1) * scene_.output.every;
    }
    if (!options_.output.empty()) {
      output_.emplace(options_.output, from ? std::optional(from->output_size) : std::nullopt);
      if (output_->size() == 0) output_->add(trajectory_heading(options_.output, scene_));
    }
    if (!options_.events.empty()) {
      events_.emplace(options_.events, from ? std::optional(from->events_size) : std::nullopt);
      if (events_->size() == 0) events_->add(hits_heading());
    }
  }

  /// The time of the next frame that is due.
  [[nodiscard]] double next_frame() const {
    if (!(scene_.output.every > 0)) return std::numeric_limits<double>::infinity();
    return static_cast<double>(frames_) * scene_.output.every;
  }

  [[nodiscard]] double next_expectation() const {
    double next = std::numeric_limits<double>::infinity();
    for (const Checked& checked : checked_) {
      const double time = checked.wanted->time;
      if (!checked.got && time >= run_->now() && !(resumed_at_ && time < *resumed_at_))
        next = std::min(next, time);
    }
    return next;
  }

  Ending advance_to_end() {
    Writer writer(*this);
    SceneObserver* const observer = events_ ? &writer : nullptr;
    const std::uint64_t begun = run_->counts().hits;
    // A look between two steps counts hits that the next look may not: count anew each time.
    const auto left = [&] {
      const std::uint64_t hits = run_->counts().hits;
      const std::uint64_t done = hits > begun ? hits - begun : 0;
      return options_.max_events - std::min(options_.max_events, done);
    };
    for (;;) {
      const double target = std::min({until_, next_frame(), next_expectation()});
      for (;;) {
        if (simulate_interruption) return Ending::interrupted;
        const std::uint64_t slice =
            run_->event_driven() ? std::min<std::uint64_t>(left(), 4096) : steps_at_a_time;
        const SceneRunEnd end = run_->advance(target, slice, observer);
        if (end == SceneRunEnd::endless_hits) return Ending::endless_hits;
        if (end == SceneRunEnd::reached) break;
        if (left() == 0) return Ending::out_of_events;
        progress();
      }
      progress();
      for (Checked& checked : checked_)
        if (checked.wanted->time == target && !checked.got)
          checked.got = contact::scene_quantity(scene_, *run_, *checked.wanted);
      if (target == next_frame()) {
        ++frames_;
        if (output_) add_frame();
        last_frame_ = target;
      }
      if (target >= until_) return Ending::complete;
      if (!run_->event_driven() && left() == 0) return Ending::out_of_events;
      if (!options_.checkpoint.empty() && seconds_since(kept_) > 30) keep();
    }
  }

  void add_frame() { output_->add(trajectory_frame(options_.output, view())); }

  void keep() {
    if (output_) output_->flush();
    if (events_) events_->flush();
    write_checkpoint(options_.checkpoint,
                     {run_->checkpoint(), scene_number(scene_), plan_number_, frames_,
                      output_ ? output_->size() : 0, events_ ? events_->size() : 0});
    kept_ = std::chrono::steady_clock::now();
  }

  using Clock = std::chrono::steady_clock;
  static double seconds_since(Clock::time_point then) {
    return std::chrono::duration<double>(Clock::now() - then).count();
  }

  void progress() {
    if (!line_.due()) return;
    line_.tell(piece_, scene_.name + " " + short_text(run_->now()) + " of " + short_text(until_) +
                           " s, " + std::to_string(run_->counts().hits) + " hits");
  }

  [[nodiscard]] std::string trouble(Ending ending) const {
    const SceneRunCounts counts = run_->counts();
    const std::string at = " at " + shortest_text(run_->now()) + " s of " + shortest_text(until_);
    if (ending == Ending::out_of_events)
      return "the budget of " + std::to_string(options_.max_events) + " hits ran out" + at +
             " s: what comes later is not simulated";
    if (ending == Ending::endless_hits)
      return "no bound on the number of hits: " + scene_.bodies[counts.endless_first].name +
             " hits " + scene_.bodies[counts.endless_second].name +
             " again and again without time going on" + at + " s";
    return "";
  }

  [[nodiscard]] nlohmann::json effects_json() const {
    const auto on = scenes::hard_sphere_effects(*run_);
    if (!on) return nullptr;
    return {{"dimension", on->dimension},
            {"gravity", on->gravity},
            {"sizes", on->sizes},
            {"restitution", on->restitution},
            {"grid", on->grid}};
  }

  [[nodiscard]] nlohmann::json stages_json() const {
    nlohmann::json stages = nlohmann::json::array();
    for (const SceneStage& stage : run_->stages())
      stages.push_back({{"name", stage.name}, {"detail", stage.detail}});
    return stages;
  }

  [[nodiscard]] auto count_bodies(bool balls_only) const {
    return std::count_if(scene_.bodies.begin(), scene_.bodies.end(), [&](const SceneBody& body) {
      return balls_only ? std::holds_alternative<BallShape>(body.shape) : body.moves;
    });
  }

  [[nodiscard]] nlohmann::json fallback_json() const {
    const auto fallback = run_->fallback();
    if (!fallback) return nullptr;
    return {{"time", fallback->time}, {"why", fallback->why}};
  }

  [[nodiscard]] Outcome report(Ending ending) const {
    Outcome outcome;
    const SceneRunCounts counts = run_->counts();
    const double energy = run_->energy();
    const Style style(stdout);
    if (options_.json) {
      nlohmann::json expectations = nlohmann::json::array();
      for (const Checked& checked : checked_) {
        const SceneExpectation& wanted = *checked.wanted;
        nlohmann::json entry{{"quantity", wanted.quantity},
                             {"body", wanted.body},
                             {"time", wanted.time},
                             {"value", wanted.value},
                             {"within", wanted.within},
                             {"met", nullptr},
                             {"got", nullptr}};
        if (checked.got) {
          entry["met"] = checked.met();
          entry["got"] = *checked.got;
        }
        expectations.push_back(entry);
      }
      constexpr const char* endings[] = {"complete", "out_of_events", "endless_hits",
                                         "interrupted"};
      nlohmann::json json{{"format", "contact-simulate/1"},
                          {"scene", scene_.name},
                          {"end", endings[static_cast<int>(ending)]},
                          {"time", run_->now()},
                          {"until", until_},
                          {"effects", effects_json()},
                          {"event_driven", run_->event_driven()},
                          {"step", run_->step()},
                          {"stages", stages_json()},
                          {"fallback", fallback_json()},
                          {"balls", count_bodies(true)},
                          {"bodies", scene_.bodies.size()},
                          {"moving", count_bodies(false)},
                          {"steps", counts.steps},
                          {"parts", counts.parts},
                          {"crowded_steps", counts.crowded_steps},
                          {"most_impacts", counts.most_impacts},
                          {"pairs", counts.pairs},
                          {"contacts", counts.contacts},
                          {"sweeps", counts.sweeps},
                          {"hits", counts.hits},
                          {"crossings", counts.crossings},
                          {"largest_overlap", counts.largest_overlap},
                          {"rests", counts.rests},
                          {"rest_error", counts.rest_error},
                          {"energy", {{"first", first_energy_}, {"last", energy}}},
                          {"frames", frames_},
                          {"bytes", run_->bytes()},
                          {"bytes_per_state", run_->bytes_per_body()},
                          {"seconds", seconds_since(began_)},
                          {"expectations", expectations}};
      if (const std::string what = trouble(ending); !what.empty()) json["trouble"] = what;
      outcome.json = std::move(json);
    } else {
      std::string stages;
      for (const SceneStage& stage : run_->stages())
        stages += (stages.empty() ? "" : ", ") + stage.name;
      outcome.say(style.bold(scene_.name) + ": " +
                  (run_->event_driven()
                       ? way_
                       : "step by step, " + shortest_text(run_->step()) + " s each") +
                  " (" + stages + ")");
      outcome.say("  " + shortest_text(run_->now()) + " s, " + std::to_string(counts.hits) +
                  " hits, " + std::to_string(run_->bytes_per_body()) + " bytes a body's state");
      if (!run_->event_driven())
        outcome.say("  " + std::to_string(counts.steps) + " steps in " +
                    std::to_string(counts.parts) + " parts, " + std::to_string(counts.pairs) +
                    " pairs looked at, " + std::to_string(counts.contacts) +
                    " contacts solved in " + std::to_string(counts.sweeps) + " sweeps");
      outcome.say("  energy " + shortest_text(first_energy_) + " J, then " + shortest_text(energy) +
                  " J; largest overlap " + shortest_text(counts.largest_overlap) + " m");
      if (counts.rests > 0)
        outcome.say("  lay down " + std::to_string(counts.rests) + " times" +
                    (run_->event_driven() ? ", which puts paths off by " +
                                                shortest_text(counts.rest_error) + " m at most"
                                          : ""));
      if (counts.crowded_steps > 0)
        outcome.say(
            "  " + style.warn(std::to_string(counts.crowded_steps) + " steps") +
            " had more impacts than " + std::to_string(counts.most_impacts) +
            "; what was left of them was taken at once, in parts in which a pair bounces once");
      if (const auto fallback = run_->fallback())
        outcome.say("  " + style.warn("step by step") + " from " + shortest_text(fallback->time) +
                    " s on: " + fallback->why);
      if (options_.expect) {
        for (const Checked& checked : checked_) {
          const SceneExpectation& wanted = *checked.wanted;
          const std::string what = wanted.quantity +
                                   (wanted.body.empty() ? "" : " of " + wanted.body) + " at " +
                                   shortest_text(wanted.time) + " s: ";
          const std::string right =
              shortest_text(wanted.value) + " within " + shortest_text(wanted.within);
          if (!checked.got)
            outcome.say("  " + style.warn("not looked at") + "  " + what + right);
          else
            outcome.say("  " +
                        (checked.met() ? style.good("as expected  ") : style.bad("not expected ")) +
                        "  " + what + shortest_text(*checked.got) + ", expected " + right);
        }
      }
    }
    const Style errors(stderr);
    if (ending == Ending::interrupted)
      outcome.note(
          "Stopped at " + shortest_text(run_->now()) + " s" +
          (options_.checkpoint.empty() ? "" : "; --resume " + options_.checkpoint + " goes on"));
    else if (const std::string what = trouble(ending); !what.empty())
      outcome.note(errors.bad("contact: ") + what);
    return outcome;
  }

  Options options_;
  ProgressLine& line_;
  std::size_t piece_;
  Scene scene_;
  std::unique_ptr<SceneRun> run_;
  std::string way_;  // it goes if it does not go step by step
  std::string plan_number_;
  double until_ = 0;
  double first_energy_ = 0;
  std::uint64_t frames_ = 0;  // of those that are due
  double last_frame_ = -1;    // when, s
  std::optional<double> resumed_at_;
  std::vector<Checked> checked_;
  std::optional<GrowingFile> output_;
  std::optional<GrowingFile> events_;
  Clock::time_point began_ = Clock::now();
  Clock::time_point kept_ = began_;
};

}  // namespace

SimulateOutcome simulated(const SimulateOptions& options, Planned planned, ProgressLine& progress,
                          std::size_t piece) {
  if (const auto refusal = scenes::run_refusal(planned.scene, planned.plan)) {
    Outcome outcome;
    outcome.note(Style(stderr).bad("contact: ") + planned.scene.name +
                 " cannot be simulated: " + *refusal);
    outcome.json = {{"format", "contact-simulate/1"},
                    {"scene", planned.scene.name},
                    {"end", "refused"},
                    {"trouble", *refusal}};
    outcome.code = exit_trouble;
    return outcome;
  }
  return Simulation(options, std::move(planned.scene), planned.plan, progress, piece).go();
}

}  // namespace contact::cli
