#include <contact/scene/free_flight_run.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>

#include <contact/plan/plan_types.hpp>
#include <contact/scene/compiled.hpp>
#include <contact/scene/scene.hpp>
#include <contact/scene/scene_run.hpp>
#include <contact/vector.hpp>

namespace contact {

CONTACT_SCENES_INLINE std::unique_ptr<SceneRun> make_free_flight_run(const Scene& scene,
                                                                     const Plan& plan) {
  const auto on = [&](Effect effect) { return decision_on(plan, effect).on; };
  Scene used = scene;
  if (!on(Effect::gravity)) used.gravity.setZero();
  std::array<int, 3> axes{};
  std::size_t changing = 0;
  std::size_t fixed = 3;
  for (int k = 2; k >= 0; --k) {
    bool changes = used.gravity(k) != 0;
    for (const SceneBody& body : used.bodies)
      changes = changes || (body.moves && body.velocity(k) != 0);
    if (!changes) axes[--fixed] = k;
  }
  for (int k = 0; k < 3; ++k) {
    if (std::find(axes.begin() + static_cast<std::ptrdiff_t>(fixed), axes.end(), k) == axes.end())
      axes[changing++] = k;
  }
  const std::size_t planned = on(Effect::third_dimension)    ? 3
                              : on(Effect::second_dimension) ? 2
                                                             : 1;
  const auto make = [&]<class S>(S /*type*/) -> std::unique_ptr<SceneRun> {
    const bool turning = on(Effect::rotation);
    switch (std::max(changing, planned)) {
      case 1:
        return std::make_unique<FreeFlightRun<S, 1>>(used, axes, turning);
      case 2:
        return std::make_unique<FreeFlightRun<S, 2>>(used, axes, turning);
      default:
        return std::make_unique<FreeFlightRun<S, 3>>(used, axes, turning);
    }
  };
  return on(Effect::double_precision) ? make(double()) : make(float());
}

}  // namespace contact
