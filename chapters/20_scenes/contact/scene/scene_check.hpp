/// @file
/// What makes a scene a scene: every number in its range, every name found, nothing inside anything
/// else.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <contact/scene/scene.hpp>

namespace contact {

// [scene-limits]
/// The least size, mass, time or other number of a scene that must be greater than 0, in its SI
/// unit. No product that a simulation makes of such numbers vanishes.
inline constexpr double scene_least = 1e-30;
/// The largest size that any number of a scene may have, in its SI unit. No product that a
/// simulation makes of such numbers overflows.
inline constexpr double scene_most = 1e30;
/// How far the square of a unit vector's or unit quaternion's length may be from 1: what 13 digits
/// say, and more than rounding makes.
inline constexpr double scene_unit_slack = 1e-12;
/// The most bodies of a scene.
inline constexpr std::size_t scene_most_bodies = 1'000'000;
// [/scene-limits]

/// Something that a scene may not be.
struct SceneFault {
  std::string path;     ///< where, as in the file: "bodies[3].mass"
  std::string value;    ///< what is there; empty if nothing is
  std::string allowed;  ///< what may be there
};

/// A fault as a line: "bodies[3].mass = -1: must be from 1e-30 to 1e+30 kg".
inline std::string fault_text(const SceneFault& fault) {
  if (fault.value.empty()) return fault.path + ": " + fault.allowed;
  return fault.path + " = " + fault.value + ": " + fault.allowed;
}

/// A number as its shortest text that gives the same bits back; "NaN", "Infinity" or "-Infinity" if
/// it is none.
std::string shortest_text(double x);

// [scene-quantities]
/// Of what a quantity is.
enum class QuantityOf {
  body,   ///< of one body, which must be named
  scene,  ///< of the whole scene: no body may be named
  either  ///< of one body, or of all
};

/// A quantity that a scene may expect.
struct SceneQuantity {
  std::string_view name;  ///< as in the file
  QuantityOf of;          ///< of what it is
  std::string_view unit;  ///< SI
};

/// Every quantity that a scene may expect. The energy is ½ m v² + ½ ω · I ω − m g · x, of all that
/// moves if no body is named; angular momentum is about the world's origin; events are the hits
/// from the beginning to the time; the gap is the least distance from the body (or any that moves)
/// to any other, and less than 0 where they overlap.
inline constexpr std::array<SceneQuantity, 19> scene_quantities{{
    {"position.x", QuantityOf::body, "m"},
    {"position.y", QuantityOf::body, "m"},
    {"position.z", QuantityOf::body, "m"},
    {"velocity.x", QuantityOf::body, "m/s"},
    {"velocity.y", QuantityOf::body, "m/s"},
    {"velocity.z", QuantityOf::body, "m/s"},
    {"spin.x", QuantityOf::body, "rad/s"},
    {"spin.y", QuantityOf::body, "rad/s"},
    {"spin.z", QuantityOf::body, "rad/s"},
    {"speed", QuantityOf::body, "m/s"},
    {"energy", QuantityOf::either, "J"},
    {"momentum.x", QuantityOf::either, "kg m/s"},
    {"momentum.y", QuantityOf::either, "kg m/s"},
    {"momentum.z", QuantityOf::either, "kg m/s"},
    {"angular_momentum.x", QuantityOf::either, "kg m^2/s"},
    {"angular_momentum.y", QuantityOf::either, "kg m^2/s"},
    {"angular_momentum.z", QuantityOf::either, "kg m^2/s"},
    {"events", QuantityOf::scene, "1"},
    {"gap", QuantityOf::either, "m"},
}};
// [/scene-quantities]

/// Everything that is wrong with a scene; nothing if it can be simulated.
///
/// Numbers that are not finite or out of range, directions and rotations not of length 1, a hull
/// that is flat or not about its centre of mass, mass and inertia that do not belong to the shape,
/// names that stand twice or for nothing, expectations after the end, and bodies that overlap. A
/// shape that some method cannot yet treat is no fault of the scene.
/// @return in the order of the file; overlaps last
std::vector<SceneFault> check_scene(const Scene& scene);

}  // namespace contact

#ifndef CONTACT_SCENES_COMPILED
#include "../../src/scene_check.cpp"
#endif
