#pragma once

#include <memory>

#include <contact/events/hard_sphere_compose.hpp>
#include <contact/events/hard_sphere_run.hpp>

namespace contact::scenes {

/// make_hard_spheres() of contact/hard_sphere_make.hpp: here all compositions are compiled, once.
std::unique_ptr<HardSphereRun> compose_run(const HardSphereSetup& setup,
                                           const HardSphereComposition& composition);

/// The least composition that simulates a setup.
std::unique_ptr<HardSphereRun> compose_run(const HardSphereSetup& setup);

}  // namespace contact::scenes
