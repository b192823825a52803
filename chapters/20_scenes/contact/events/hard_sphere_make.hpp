/// @file
/// Every composition of hard balls, one of which is made at run time. Without the chapter's library
/// all of them are compiled where this is included; do it in one file.
#pragma once

#include <memory>

#include <contact/events/hard_sphere_compose.hpp>
#include <contact/events/hard_sphere_run.hpp>

namespace contact {

/// A run with a composition.
/// @throws std::invalid_argument if the setup is not valid, or needs an effect that is off
std::unique_ptr<HardSphereRun> make_hard_spheres(const HardSphereSetup& setup,
                                                 const HardSphereComposition& composition);

/// A run with the least composition.
/// @throws std::invalid_argument if the setup is not valid
std::unique_ptr<HardSphereRun> make_hard_spheres(const HardSphereSetup& setup);

}  // namespace contact

#ifndef CONTACT_SCENES_COMPILED
#include "../../src/hard_sphere_make.cpp"
#endif
