#include "plan_measure.hpp"

#include <time.h>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>

#include <contact/plan.hpp>
#include <contact/scene_run.hpp>

#include "plan_report.hpp"
#include "scenes/scene_runs.hpp"

namespace contact::cli {

namespace {

constexpr int rounds = 5;
constexpr int pieces = 256;  // in which a scene's duration is run

double processor_seconds() {
  timespec now{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// How far a run comes with so many seconds of the processor; a piece that was begun is finished.
double time_within(const Scene& scene, const Plan& plan, double seconds) {
  const auto run = scenes::make_run(scene, plan);
  const double began = processor_seconds();
  for (int piece = 1; piece <= pieces; ++piece) {
    run->advance(scene.duration * piece / pieces);
    if (processor_seconds() - began > seconds) break;
  }
  return run->now();
}

/// Seconds of the processor for a second of the scene, from its beginning to a time.
double cost_until(const Scene& scene, const Plan& plan, double until) {
  const auto run = scenes::make_run(scene, plan);
  const double began = processor_seconds();
  run->advance(until);
  return (processor_seconds() - began) / until;
}

double median(std::array<double, rounds> values) {
  std::sort(values.begin(), values.end());
  return values[rounds / 2];
}

bool composed_alike(const SceneRun& one, const SceneRun& other) {
  const auto stages = one.stages();
  const auto others = other.stages();
  return one.step() == other.step() && one.bytes_per_body() == other.bytes_per_body() &&
         std::equal(stages.begin(), stages.end(), others.begin(), others.end(),
                    [](const SceneStage& a, const SceneStage& b) {
                      return a.name == b.name && a.detail == b.detail;
                    });
}

/// The plan with one effect the other way round, and with the same step.
Plan turned_round(const Scene& scene, const Plan& plan, PlanOptions options, Effect effect) {
  const bool on = decision_on(plan, effect).on;
  auto& to = on ? options.overrides.without : options.overrides.with;
  auto& from = on ? options.overrides.with : options.overrides.without;
  from.erase(std::remove(from.begin(), from.end(), effect), from.end());
  to.push_back(effect);
  if (plan.step > 0 && effect != Effect::event_driven) options.step = plan.step;
  return plan_scene(scene, options);
}

}  // namespace

std::vector<MeasuredEffect> measure_effects(const Scene& scene, const Plan& plan,
                                            const PlanOptions& options) {
  std::vector<MeasuredEffect> all;
  const std::optional<std::string> refusal = scenes::run_refusal(scene, plan);
  for (const Effect effect : all_effects) {
    if (!can_be_switched(effect)) continue;
    MeasuredEffect& measured = all.emplace_back();
    measured.effect = effect;
    const Plan other = turned_round(scene, plan, options, effect);
    const auto other_refusal = scenes::run_refusal(scene, other);
    if (refusal || other_refusal) {
      measured.refused = refusal ? *refusal : *other_refusal;
      continue;
    }
    {
      const auto as_planned = scenes::make_run(scene, plan);
      const auto otherwise = scenes::make_run(scene, other);
      measured.planned_bytes = as_planned->bytes_per_body();
      measured.other_bytes = otherwise->bytes_per_body();
      // Friction and restitution are numbers of the solver, and no stages.
      const bool number = effect == Effect::friction || effect == Effect::restitution;
      measured.same_stages =
          composed_alike(*as_planned, *otherwise) && (as_planned->event_driven() || !number);
    }
    if (measured.same_stages) continue;
    // The same part of the scene for both, since its beginning may cost more than the rest.
    const double until = std::min(time_within(scene, plan, 0.02), time_within(scene, other, 0.2));
    std::array<double, rounds> planned_costs{};
    std::array<double, rounds> other_costs{};
    for (std::size_t round = 0; round < rounds; ++round) {
      planned_costs[round] = cost_until(scene, plan, until);
      other_costs[round] = cost_until(scene, other, until);
    }
    measured.planned_seconds = median(planned_costs);
    measured.other_seconds = median(other_costs);
  }
  return all;
}

std::string measured_text(const MeasuredEffect& measured, bool on) {
  if (!measured.refused.empty()) return "Not measured: " + measured.refused + ".";
  const std::string other = on ? "without" : "with";
  if (measured.same_stages) return "Measured: the run " + other + " it is composed alike.";
  const auto milliseconds = [](double seconds) { return plan_number(1000 * seconds) + " ms"; };
  std::string text = "Measured: " + milliseconds(measured.planned_seconds) +
                     " of the processor a second as planned, " +
                     milliseconds(measured.other_seconds) + " " + other + " it (" +
                     plan_number(measured.other_seconds / measured.planned_seconds) + " times)";
  if (measured.planned_bytes != measured.other_bytes)
    text += "; " + std::to_string(measured.planned_bytes) + " and " +
            std::to_string(measured.other_bytes) + " bytes a body";
  return text + ".";
}

}  // namespace contact::cli
