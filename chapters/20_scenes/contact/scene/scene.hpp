/// @file
/// A scene as plain data: its bodies, their initial motion, how long it lasts and how accurate the
/// answer must be. SI units; one frame, the world's, right-handed.
///
/// A scene that is read from a file has been checked (contact/scene_check.hpp). A scene that a
/// program makes is checked by check_scene().
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <contact/quaternion.hpp>
#include <contact/vector.hpp>

namespace contact {

/// A ball about the body's origin.
struct BallShape {
  double radius = 0;  ///< m, greater than 0
};

/// A box about the body's origin, its edges along the body's axes.
struct BoxShape {
  Vector3<double> half_lengths = Vector3<double>::Zero();  ///< m, each greater than 0
};

/// All points at most `radius` from a segment on the body's z axis about its origin.
struct CapsuleShape {
  double radius = 0;       ///< m, greater than 0
  double half_length = 0;  ///< of the segment, m, not negative
};

/// The convex hull of points in the body's frame. Their centre of mass must be its origin.
struct HullShape {
  std::vector<Vector3<double>> points;  ///< m
};

/// All points x of the world with normal · x ≤ offset: a floor or a wall. Never moves.
struct HalfSpaceShape {
  Vector3<double> normal = Vector3<double>::UnitZ();  ///< unit normal out of the solid
  double offset = 0;                                  ///< m
};

/// The shapes of a body.
using SceneShape = std::variant<BallShape, BoxShape, CapsuleShape, HullShape, HalfSpaceShape>;

/// The material of a surface.
struct SceneMaterial {
  std::string name;        ///< the name that bodies refer to
  double restitution = 0;  ///< from 0 to 1, no unit
  double friction = 0;     ///< Coulomb's coefficient, not negative, no unit
  /// Of a compliant contact, N/m and greater than 0; without it the contact is hard.
  std::optional<double> stiffness;
  double damping = 0;  ///< of a compliant contact, N·s/m, not negative
};

/// A body: what it is, and its initial state.
struct SceneBody {
  std::string name;          ///< no other body has it
  SceneShape shape;          ///< about its origin; a half-space in the world
  std::size_t material = 0;  ///< index into Scene::materials
  bool moves = true;         ///< false: it is fixed
  double mass = 0;           ///< kg, greater than 0 if it moves; else 0
  /// About its centre of mass and its own axes, kg·m², for uniform density. Off the diagonal only
  /// for a hull.
  Matrix3<double> inertia = Matrix3<double>::Zero();
  Vector3<double> position = Vector3<double>::Zero();  ///< of its origin, m
  Quaternion<double> orientation;                      ///< rotates its axes into the world's
  Vector3<double> velocity = Vector3<double>::Zero();  ///< m/s
  Vector3<double> angular_velocity =
      Vector3<double>::Zero();  ///< angular velocity in the world, rad/s
};

/// How accurate the answer must be: one or both.
struct SceneTolerance {
  std::optional<double> position;  ///< largest error of a body's position up to the horizon, m
  bool event_order = false;        ///< the hits come in their right order
};

/// What is written while a scene runs.
struct SceneOutput {
  double every = 0;         ///< s between two frames; 0: only the last
  bool velocities = false;  ///< beside positions
  bool events = false;      ///< each hit: time, bodies, point, impulse
};

/// The expected result of a correct simulation: kept with the scenes of the book, and tested.
struct SceneExpectation {
  std::string quantity;  ///< "position.z", "velocity.x", "speed", "energy", "events", "gap", ...
  std::string body;      ///< of which body; empty for a quantity of the whole scene
  double time = 0;       ///< s; when
  double value = 0;      ///< in the quantity's SI unit
  double within = 0;     ///< how far off it may be; 0: exactly
  std::string why;       ///< where the value is from, one sentence
};

/// A scene.
struct Scene {
  std::string name;                                   ///< that of its file, without the ending
  std::string about;                                  ///< one sentence for a reader
  Vector3<double> gravity = Vector3<double>::Zero();  ///< m/s²
  std::vector<SceneMaterial> materials;               ///< at least one if there are bodies
  std::vector<SceneBody> bodies;                      ///< in the order of the file
  double duration = 0;                                ///< s, greater than 0
  SceneTolerance tolerance;                           ///< what the answer must keep
  SceneOutput output;                                 ///< what is written
  std::vector<SceneExpectation> expect;               ///< expected results, where known
};

/// The material of a contact: the less elastic and the smoother decide, and two springs act in
/// series.
struct PairMaterial {
  double restitution = 0;           ///< the smaller of the two
  double friction = 0;              ///< the smaller of the two
  std::optional<double> stiffness;  ///< N/m; absent if both are hard
  double damping = 0;               ///< N·s/m; the sum
};

/// The material of a pair. Symmetric in its arguments, bit for bit.
PairMaterial pair_material(const SceneMaterial& a, const SceneMaterial& b);

}  // namespace contact

#ifndef CONTACT_SCENES_COMPILED
#include "../../src/scene.cpp"
#endif
