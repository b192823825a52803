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
#include <contact/scene/kept_tolerance.hpp>
#include <contact/scene/make_scene_run.hpp>
#include <contact/scene/scene_file.hpp>
#include <contact/scene/scene_runs.hpp>

#include "../commands.hpp"
#include "../terminal/terminal.hpp"
#include "run_output.hpp"
#include "simulation_report.hpp"

namespace contact::cli {

std::atomic<bool> simulate_interruption = false;

namespace {

using Options = SimulateOptions;
using Outcome = SimulateOutcome;

/// Number of steps between two checks for Ctrl-C.
constexpr std::uint64_t steps_at_a_time = 1;

/// A time for the line of progress: four digits.
std::string short_text(double seconds) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.4g", seconds);
  return text.data();
}

/// One scene.
class Simulation {
 public:
  Simulation(Options options, Scene scene, const Plan& plan, ProgressLine& line, std::size_t piece)
      : options_(std::move(options)),
        line_(line),
        piece_(piece),
        scene_(std::move(scene)),
        run_(scenes::make_run(scene_, plan, options_.event_budget)),
        plan_(plan),
        way_(flies_freely(plan) ? "all bodies fly freely, by a formula"
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
    // Output that is due once only comes after what a resumed run keeps.
    if (!options_.checkpoint.empty()) keep();
    if (events_) {
      Writer writer(*this);
      run_->report_unfinished(writer);
    }
    if (ending != Ending::interrupted && output_ && last_frame_ != run_->now()) add_frame();
    if (output_) output_->flush();
    if (events_) events_->flush();
    const KeptTolerance kept = kept_tolerance(plan_, *run_);
    Outcome outcome = reported({options_, scene_, *run_, checked_, ending, way_, kept, until_,
                                first_energy_, frames_, seconds_since(began_)});
    const bool failed = std::any_of(checked_.begin(), checked_.end(), [](const Checked& checked) {
      return checked.got && !checked.met();
    });
    if ((options_.expect && failed) || (options_.strict && !kept.whole()))
      outcome.code = exit_not_passed;
    if (ending != Ending::complete) outcome.code = exit_trouble;
    if (ending == Ending::interrupted) outcome.code = exit_interrupted;
    return outcome;
  }

 private:
  /// Writes hits as they happen.
  struct Writer final : SceneObserver {
    explicit Writer(Simulation& of) : simulation(of) {}
    Simulation& simulation;
    bool on_hit(const SceneHit& hit) override {
      simulation.events_->add(hit_line(simulation.scene_, hit));
      return true;
    }
  };

  /// The effects that are on, and the step: two runs of a scene with the same ones are equal.
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
        throw std::runtime_error(options_.resume + " was saved by a run of another scene than " +
                                 options_.scenes.front());
      }
      if (from->plan != plan_number_)
        throw std::runtime_error(options_.resume +
                                 " was saved by a run with another plan: the same " +
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
    // Reporting between two steps counts hits that the next report may not: count anew each time.
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

  Options options_;
  ProgressLine& line_;
  std::size_t piece_;
  Scene scene_;
  std::unique_ptr<SceneRun> run_;
  Plan plan_;
  std::string way_;  // how it runs if not step by step
  std::string plan_number_;
  double until_ = 0;
  double first_energy_ = 0;
  std::uint64_t frames_ = 0;  // number of those due
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
  return Simulation(options, std::move(planned.scene), planned.plan, progress, piece).go();
}

}  // namespace contact::cli
