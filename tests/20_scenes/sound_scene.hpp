/// @file
/// A scene without a fault, and distances of bodies in it.
#pragma once

#include <contact/scene/scene.hpp>
#include <contact/scene/scene_solids.hpp>
#include <limits>
#include <string>

namespace sound_scene {

using contact::SceneBody;
using contact::Vector3;

inline constexpr double u = 0x1p-53;
inline constexpr double infinity = std::numeric_limits<double>::infinity();

inline SceneBody body_of(const std::string& name, const contact::SceneShape& shape,
                         const Vector3<double>& position, bool moves = true) {
  SceneBody body;
  body.name = name;
  body.shape = shape;
  body.position = position;
  body.moves = moves;
  if (moves) {
    body.mass = 1;
    body.inertia = contact::solid_inertia(shape, 1);
  }
  return body;
}

}  // namespace sound_scene
