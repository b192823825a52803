/// @file
/// From a setup of hard balls to the least composition that simulates it, with the proof of each
/// effect that is left out.
#pragma once

#include <array>

#include <contact/events/hard_sphere_run.hpp>

namespace contact {

/// Effects that a setup calls for, and the axes along which something can move.
struct HardSphereComposition {
  HardSphereEffects effects;         ///< those that are on
  std::array<int, 3> axes{0, 1, 2};  ///< the first `effects.dimension` count
};

/// Which effects a setup calls for. An effect is off where it is proved that it does nothing: the
/// run has the same bits as one with all effects.
///
/// The grid is no effect, but a way to ask; with few balls asking everybody is quicker.
HardSphereComposition compose_hard_spheres(const HardSphereSetup& setup);

}  // namespace contact

#ifndef CONTACT_SCENES_COMPILED
#include "../../src/hard_sphere_compose.cpp"
#endif
