#include "scenes/run_hard_spheres.hpp"

#include <contact/events/hard_sphere_make.hpp>

namespace contact::scenes {

std::unique_ptr<HardSphereRun> compose_run(const HardSphereSetup& setup,
                                           const HardSphereComposition& composition) {
  return make_hard_spheres(setup, composition);
}

std::unique_ptr<HardSphereRun> compose_run(const HardSphereSetup& setup) {
  return make_hard_spheres(setup);
}

}  // namespace contact::scenes
