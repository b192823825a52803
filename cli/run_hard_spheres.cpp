#include "run_hard_spheres.hpp"

#include <contact/hard_sphere_compose.hpp>

namespace contact::cli {

std::unique_ptr<HardSphereRun> compose_run(const HardSphereSetup& setup) {
  return make_hard_spheres(setup);
}

}  // namespace contact::cli
