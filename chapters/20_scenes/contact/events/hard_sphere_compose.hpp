/// @file
/// From a setup of hard balls to the least composition that simulates it, with the proof of each
/// effect that is left out.
#pragma once

#include <array>

#include <contact/events/hard_sphere_run.hpp>

namespace contact {

/// The effects that a setup needs, and the axes along which balls can move.
struct HardSphereComposition {
  HardSphereEffects effects;         ///< those that are on
  std::array<int, 3> axes{0, 1, 2};  ///< the first `effects.dimension` count
};

/// The effects that a setup needs. An effect is off where it is proven inactive: the run has the
/// same bits as one with all effects.
///
/// The grid is not an effect but a search method; with few balls, testing all pairs is faster.
HardSphereComposition compose_hard_spheres(const HardSphereSetup& setup);

}  // namespace contact

#ifndef CONTACT_SCENES_COMPILED
#include "../../src/hard_sphere_compose.cpp"
#endif
