/// @file
/// What makes a scene valid: every number in its range, every name found, no overlap.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <contact/scene/scene.hpp>

namespace contact {

// [scene-limits]
/// The smallest value of any number of a scene that must be greater than 0, in its SI unit. No
/// product of such numbers in a simulation underflows to 0.
inline constexpr double min_scene_value = 1e-30;
/// The largest size of any number of a scene, in its SI unit. No product of such numbers in a
/// simulation overflows.
inline constexpr double max_scene_value = 1e30;
/// How far the squared length of a unit vector or unit quaternion may be from 1: the error of 13
/// digits, which is more than rounding makes.
inline constexpr double scene_unit_slack = 1e-12;
/// The largest number of bodies of a scene.
inline constexpr std::size_t max_scene_bodies = 1'000'000;
// [/scene-limits]

/// A value for an error message: itself, or so many of its bytes that it has at most `most` with
/// the three points at its end. A character of several bytes is not divided.
/// @param most at least 3
inline std::string shortened(const std::string& value, std::size_t most = 200) {
  if (value.size() <= most) return value;
  std::size_t end = most - 3;
  while (end > 0 && (static_cast<unsigned char>(value[end]) & 0xc0U) == 0x80U) --end;
  return value.substr(0, end) + "...";
}

/// A fault of a scene.
struct SceneFault {
  std::string path;     ///< where, as in the file: "bodies[3].mass"
  std::string value;    ///< the value; empty if there is none
  std::string allowed;  ///< what is allowed
};

/// A fault as a line: "bodies[3].mass = -1: must be from 1e-30 to 1e+30 kg". Of a long path or
/// value, 200 characters.
inline std::string fault_text(const SceneFault& fault) {
  if (fault.value.empty()) return shortened(fault.path) + ": " + fault.allowed;
  return shortened(fault.path) + " = " + shortened(fault.value) + ": " + fault.allowed;
}

/// A number as the shortest text from which the same bits are read; "NaN", "Infinity" or
/// "-Infinity" if it is not finite.
std::string shortest_text(double x);

// [scene-quantities]
/// What a quantity belongs to.
enum class QuantityOf {
  body,   ///< of one body, which must be named
  scene,  ///< of the whole scene: no body may be named
  either  ///< of one body, or of all
};

/// A quantity that a scene may expect.
struct SceneQuantity {
  std::string_view name;  ///< as in the file
  QuantityOf of;          ///< what it belongs to
  std::string_view unit;  ///< SI
};

/// Every quantity that a scene may expect. The energy is ½ m v² + ½ ω · I ω − m g · x, of all
/// moving bodies if no body is named; angular momentum is about the world's origin; events are the
/// hits from the start to the time; the gap is the smallest signed distance from the body (or any
/// that moves) to any other, negative where they overlap.
inline constexpr std::array<SceneQuantity, 19> scene_quantities{{
    {"position.x", QuantityOf::body, "m"},
    {"position.y", QuantityOf::body, "m"},
    {"position.z", QuantityOf::body, "m"},
    {"velocity.x", QuantityOf::body, "m/s"},
    {"velocity.y", QuantityOf::body, "m/s"},
    {"velocity.z", QuantityOf::body, "m/s"},
    {"angular_velocity.x", QuantityOf::body, "rad/s"},
    {"angular_velocity.y", QuantityOf::body, "rad/s"},
    {"angular_velocity.z", QuantityOf::body, "rad/s"},
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

/// All faults of a scene; none if it can be simulated.
///
/// Numbers that are not finite or out of range, directions and rotations not of length 1, a hull
/// that is flat or not about its centre of mass, mass and inertia that do not belong to the shape,
/// duplicate and unknown names, expectations after the end, and bodies that overlap. A shape that
/// some method does not support yet is not a fault of the scene.
/// @return in the order of the file; overlaps last
std::vector<SceneFault> check_scene(const Scene& scene);

}  // namespace contact

#ifndef CONTACT_SCENES_COMPILED
#include "../../src/scene_check.cpp"
#endif
