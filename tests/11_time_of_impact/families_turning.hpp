/// @file
/// Families of two boxes that translate and turn.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>

#include "families.hpp"

namespace families {

/// Two boxes that translate and turn at constant rates during a step of 1 s.
struct TurningBoxes {
  std::array<V, 2> position;              ///< of the centres at the start, m
  std::array<V, 2> rotation;              ///< orientation at the start: axis times angle, rad
  std::array<V, 2> half_lengths;          ///< m
  std::array<V, 2> displacement;          ///< of the centres in the step, m
  std::array<V, 2> angular_displacement;  ///< axis times angle in the step, rad, in the world
};

/// The families of boxes that turn.
enum class Turning {
  random,    ///< any motion; about half of them aimed at each other
  in_plane,  ///< about z only, equally thick there: a motion in the plane
  rods,      ///< long and thin
  plates,    ///< flat, and turning fast
  spinning,  ///< almost half a turn in the step, no displacement
  graze,     ///< a vertex passes close to a face
  bullet,    ///< a small one through a thin plate
  far        ///< close to each other and far from the origin
};

inline constexpr std::array<Turning, 8> all_turning{
    Turning::random,   Turning::in_plane, Turning::rods,   Turning::plates,
    Turning::spinning, Turning::graze,    Turning::bullet, Turning::far};

inline constexpr std::string_view name(Turning family) {
  constexpr std::array<std::string_view, 8> names{"random",   "in the plane", "rods",   "plates",
                                                  "spinning", "graze",        "bullet", "far away"};
  return names[static_cast<std::size_t>(family)];
}

/// A vector in any direction of a length in a range: a rotation, or a distance.
inline V any_turn(Random& random, double least, double most) {
  const V axis = in_box(random, 1).normalized();
  return axis * random.uniform(least, most);
}

/// Turning boxes of a family. No box turns by more than 3 rad, so that its poses at the start and
/// at the end determine the motion.
inline TurningBoxes turning_boxes(Random& random, Turning family) {
  TurningBoxes pair;
  for (std::size_t k = 0; k < 2; ++k) {
    pair.position[k] = in_box(random, 3);
    pair.rotation[k] = in_box(random, 1.5);
    pair.half_lengths[k] = in_box(random, 0.9).cwiseAbs() + V::Constant(0.1);
    pair.displacement[k] = in_box(random, 3);
    pair.angular_displacement[k] = in_box(random, 1.5);
  }
  if (random.chance(0.5)) {
    pair.displacement[1] =
        pair.displacement[0] + (pair.position[0] - pair.position[1]) * random.uniform(0.5, 1.5);
  }
  switch (family) {
    case Turning::in_plane:
      for (std::size_t k = 0; k < 2; ++k) {
        pair.position[k].z() = pair.displacement[k].z() = 0;
        pair.rotation[k] = V{0, 0, random.uniform(-3, 3)};
        pair.angular_displacement[k] = V{0, 0, random.uniform(-2.9, 2.9)};
        pair.half_lengths[k].z() = 1;
      }
      break;
    case Turning::rods:
      for (V& h : pair.half_lengths) h = V{random.uniform(0.5, 2), 0.02, 0.02};
      break;
    case Turning::plates:
      for (std::size_t k = 0; k < 2; ++k) {
        pair.half_lengths[k] = V{random.uniform(0.5, 1.5), random.uniform(0.5, 1.5), 0.01};
        pair.angular_displacement[k] = any_turn(random, 1, 2.9);
      }
      break;
    case Turning::spinning: {
      for (std::size_t k = 0; k < 2; ++k) {
        pair.displacement[k] = V::Zero();
        pair.angular_displacement[k] = any_turn(random, 2.9, 2.9);
      }
      const double reach = pair.half_lengths[0].norm() + pair.half_lengths[1].norm();
      const V apart = any_turn(random, 0.5, 1.2);
      pair.position[1] = pair.position[0] + apart * reach;
      break;
    }
    case Turning::graze: {
      // A large plate at rest; the other box turns about its centre so that its half diagonal is
      // about as long as its height over the plate.
      pair.half_lengths[0] = V{8, 8, 0.5};
      pair.position[0] = V{0, 0, -0.5};
      pair.rotation[0] = pair.displacement[0] = pair.angular_displacement[0] = V::Zero();
      pair.displacement[1].z() = 0;
      pair.position[1].z() = pair.half_lengths[1].norm() * (1 + random.magnitude(-20, -2));
      pair.angular_displacement[1] = any_turn(random, 1, 2.9);
      break;
    }
    case Turning::bullet:
      pair.half_lengths[0] = V{4, 4, 0.005};
      pair.position[0] = V::Zero();
      pair.displacement[0] = V::Zero();
      pair.half_lengths[1] = V{0.01, 0.01, 0.03};
      pair.position[1] = V{random.uniform(-4, 4), random.uniform(-4, 4), random.uniform(1, 9)};
      pair.displacement[1] =
          V{random.uniform(-1, 1), random.uniform(-1, 1), -random.uniform(5, 400)};
      pair.angular_displacement[0] *= 0.1;
      pair.rotation[0] *= 0.1;
      break;
    case Turning::far: {
      const V shift = in_box(random, 1e6);
      for (V& c : pair.position) c += shift;
      break;
    }
    case Turning::random:
      break;
  }
  return pair;
}

}  // namespace families
