#pragma once

#include <memory>

#include <contact/hard_sphere_run.hpp>
#include <contact/hard_sphere_setup.hpp>

namespace contact::cli {

/// The least composition that simulates a setup. Here, and not in the header that makes it, so that
/// all 96 compositions are compiled in one file.
std::unique_ptr<HardSphereRun> compose_run(const HardSphereSetup& setup);

}  // namespace contact::cli
