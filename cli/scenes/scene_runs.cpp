#include "scene_runs.hpp"

#include <contact/events/hard_sphere_scene.hpp>
#include <contact/scene/free_flight_run.hpp>
#include <contact/scene/make_scene_run.hpp>
#include <contact/stepped/stepped_run.hpp>

#include "run_hard_spheres.hpp"

namespace contact::scenes {

std::unique_ptr<SceneRun> make_run(const Scene& scene, const Plan& plan,
                                   std::uint64_t event_budget) {
  return make_scene_run(scene, plan, compose_run, event_budget);
}

std::optional<std::string> run_refusal(const Scene& scene, const Plan& plan) {
  if (flies_freely(plan)) return std::nullopt;
  if (decision_on(plan, Effect::event_driven).on &&
      !hard_sphere_refusal(scene_without_effects(scene, plan)))
    return std::nullopt;
  return stepped_refusal(scene, plan);
}

double quantity_of_run(const Scene& scene, const SceneRun& run, const SceneExpectation& wanted) {
  return scene_quantity(scene, run, wanted);
}

std::optional<HardSphereEffects> hard_sphere_effects(const SceneRun& run) {
  const auto* events = dynamic_cast<const FallbackRun*>(&run);
  if (events == nullptr || !run.event_driven()) return std::nullopt;
  return events->effects();
}

}  // namespace contact::scenes
