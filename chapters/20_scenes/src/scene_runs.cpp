#include <contact/scene/scene_runs.hpp>

#include <cstdint>
#include <memory>
#include <optional>

#include <contact/events/hard_sphere_make.hpp>
#include <contact/scene/compiled.hpp>
#include <contact/scene/make_scene_run.hpp>

namespace contact::scenes {

CONTACT_SCENES_INLINE std::unique_ptr<SceneRun> make_run(const Scene& scene, const Plan& plan,
                                                         std::uint64_t event_budget) {
  return make_scene_run(scene, plan, make_hard_spheres, event_budget);
}

CONTACT_SCENES_INLINE std::optional<HardSphereEffects> hard_sphere_effects(const SceneRun& run) {
  const auto* events = dynamic_cast<const FallbackRun*>(&run);
  if (events == nullptr || !run.event_driven()) return std::nullopt;
  return events->effects();
}

}  // namespace contact::scenes
