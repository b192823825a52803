/// @file
/// Every composition of hard balls, one of which is made at run time. A program that includes this
/// compiles all of them; do it in one file.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <utility>

#include <contact/events/hard_sphere_compose.hpp>
#include <contact/events/hard_sphere_run.hpp>
#include <contact/events/hard_spheres.hpp>

namespace contact {

namespace detail {

constexpr HardSphereEffects numbered_effects(std::size_t number) {
  return {static_cast<int>(number / 16) + 1, (number & 1) != 0, (number & 2) != 0,
          (number & 4) != 0, (number & 8) != 0};
}

template <std::size_t Number>
std::unique_ptr<HardSphereRun> make_numbered(const HardSphereSetup& setup,
                                             const std::array<int, 3>& axes) {
  return std::make_unique<HardSpheres<numbered_effects(Number)>>(setup, axes);
}

template <std::size_t... Number>
constexpr auto makers(std::index_sequence<Number...> /*numbers*/) {
  return std::array{&make_numbered<Number>...};
}

}  // namespace detail

/// A run with a composition.
/// @throws std::invalid_argument if the setup is none, or calls for an effect that is off
std::unique_ptr<HardSphereRun> make_hard_spheres(const HardSphereSetup& setup,
                                                 const HardSphereComposition& composition);

/// A run with the least composition.
/// @throws std::invalid_argument if the setup is none
std::unique_ptr<HardSphereRun> make_hard_spheres(const HardSphereSetup& setup);

}  // namespace contact

#ifndef CONTACT_SCENES_COMPILED
#include "../../src/hard_sphere_make.cpp"
#endif
