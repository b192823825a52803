#include "plan_measure.hpp"

#include <time.h>

#include <algorithm>
#include <array>
#include <limits>
#include <memory>

#include <contact/plan/plan.hpp>
#include <contact/scene/scene_run.hpp>
#include <contact/scene/scene_runs.hpp>
#include <contact/scene/scene_solids.hpp>

namespace contact::cli {

using scenes::MeasuredEffect;
using scenes::MeasuredHorizon;

namespace {

constexpr int rounds = 5;
constexpr int pieces = 256;  // in which a scene's duration is run

double processor_seconds() {
  timespec now{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// How far a run gets with so many seconds of processor time; a piece that was begun is finished.
double time_within(const Scene& scene, const Plan& plan, double seconds) {
  const auto run = scenes::make_run(scene, plan);
  const double began = processor_seconds();
  for (int piece = 1; piece <= pieces; ++piece) {
    run->advance(scene.duration * piece / pieces);
    if (processor_seconds() - began > seconds) break;
  }
  return run->now();
}

/// Processor time for a second of the scene, s, from its start to a time.
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

/// The plan with one effect switched, and with the same step.
Plan turned_round(const Scene& scene, const Plan& plan, PlanOptions options, Effect effect) {
  const bool on = decision_on(plan, effect).on;
  auto& to = on ? options.overrides.without : options.overrides.with;
  auto& from = on ? options.overrides.with : options.overrides.without;
  from.erase(std::remove(from.begin(), from.end(), effect), from.end());
  to.push_back(effect);
  if (plan.step > 0 && effect != Effect::event_driven) options.step = plan.step;
  return plan_scene(scene, options);
}

/// The scene an ulp away: the speeds of moving bodies are changed by an ulp, up and down in turns;
/// bodies at rest start higher by an ulp of the largest coordinate. It moves in the same plane or
/// on the same line.
Scene twin_of(Scene scene) {
  const double ulp = std::numeric_limits<double>::epsilon();
  double size = 0;
  for (const SceneBody& body : scene.bodies)
    if (body.moves) size = std::max(size, body.position.cwiseAbs().maxCoeff());
  const double g = scene.gravity.norm();
  double sign = 1;
  for (SceneBody& body : scene.bodies) {
    if (!body.moves) continue;
    if (body.velocity != Vector3<double>::Zero())
      body.velocity *= 1 + sign * ulp;
    else if (g > 0)
      body.position -= scene.gravity * (size * ulp / g);
    sign = -sign;
  }
  return scene;
}

/// Runs a scene and its twin until they have diverged, or for so many seconds of processor time.
MeasuredHorizon measured_horizon(const Scene& scene, const Plan& plan, double seconds) {
  MeasuredHorizon measured;
  measured.allowed = std::numeric_limits<double>::infinity();
  for (const SceneBody& body : scene.bodies)
    if (body.moves) measured.allowed = std::min(measured.allowed, bounding_radius(body.shape));
  measured.allowed = scene.tolerance.position.value_or(measured.allowed);
  const auto run = scenes::make_run(scene, plan);
  const auto twin = scenes::make_run(twin_of(scene), plan);
  const double began = processor_seconds();
  for (int piece = 1; piece <= pieces && !measured.diverged(); ++piece) {
    if (processor_seconds() - began > seconds) break;
    measured.time = scene.duration * piece / pieces;
    run->advance(measured.time);
    twin->advance(measured.time);
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      const Vector3<double> apart = run->position(i) - twin->position(i);
      measured.apart = std::max(measured.apart, apart.norm());
    }
  }
  return measured;
}

}  // namespace

std::vector<MeasuredEffect> measure_effects(const Scene& scene, const Plan& plan,
                                            const PlanOptions& options, ProgressLine& progress) {
  std::vector<MeasuredEffect> all;
  for (const Effect effect : all_effects) {
    if (effect == Effect::step_size) continue;
    MeasuredEffect& measured = all.emplace_back();
    measured.effect = effect;
    progress.tell(0, "measuring " + std::string(effect_name(effect)));
    if (effect == Effect::horizon) {
      measured.horizon = measured_horizon(scene, plan, 2);
      continue;
    }
    const Plan other = turned_round(scene, plan, options, effect);
    {
      const auto as_planned = scenes::make_run(scene, plan);
      const auto otherwise = scenes::make_run(scene, other);
      measured.planned_bytes = as_planned->bytes_per_body();
      measured.other_bytes = otherwise->bytes_per_body();
      // Friction and restitution are numbers of the solver, not stages.
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

}  // namespace contact::cli
