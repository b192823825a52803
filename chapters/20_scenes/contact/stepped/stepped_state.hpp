/// @file
/// The data of a stepped run: what never changes, what changes from step to step, and what one
/// substep passes from stage to stage. Vectors that store only the coordinates that change, and the
/// limits of impacts in a step: each at its own time, or many at once.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <variant>
#include <vector>

#include <contact/contact_manifold.hpp>
#include <contact/contact_solver.hpp>
#include <contact/convex_shapes.hpp>
#include <contact/inertia.hpp>
#include <contact/plan/plan_bounds.hpp>
#include <contact/quaternion.hpp>
#include <contact/rotation.hpp>
#include <contact/scene/scene.hpp>
#include <contact/scene/scene_run.hpp>
#include <contact/signed_distance.hpp>
#include <contact/vector.hpp>

namespace contact {

/// The coordinates of a run that change: all three, two in a plane, or one on a line.
struct ActiveAxes {
  std::array<int, 3> axes{0, 1, 2};  ///< the first `count` are kept
  std::size_t count = 3;             ///< 1, 2 or 3
  std::array<bool, 3> held{};        ///< of those kept, which keep their initial value
};

// [kept-vectors]
/// A vector for each body, with only the coordinates that change: a body on a line has one number.
class ActiveVectors {
 public:
  ActiveVectors() = default;
  /// @param active of every vector
  explicit ActiveVectors(const ActiveAxes& active) : active_(active) {}

  /// The vector with that index; coordinates that are not kept are 0.
  Vector3<double> operator[](std::size_t i) const { return over(i, Vector3<double>::Zero()); }

  /// The vector with that index; coordinates that are not kept are those of `rest`.
  Vector3<double> over(std::size_t i, Vector3<double> rest) const {
    const double* from = numbers_.data() + i * active_.count;
    for (std::size_t k = 0; k < active_.count; ++k) rest(active_.axes[k]) = from[k];
    return rest;
  }

  /// Stores a vector; coordinates that are not kept are lost.
  void set(std::size_t i, const Vector3<double>& v) {
    double* to = numbers_.data() + i * active_.count;
    for (std::size_t k = 0; k < active_.count; ++k)
      if (!active_.held[k]) to[k] = v(active_.axes[k]);
  }

  /// Adds to the vector with that index.
  void add(std::size_t i, const Vector3<double>& v) {
    double* to = numbers_.data() + i * active_.count;
    for (std::size_t k = 0; k < active_.count; ++k)
      if (!active_.held[k]) to[k] += v(active_.axes[k]);
  }

  /// Appends a vector.
  void push_back(const Vector3<double>& v) {
    for (std::size_t k = 0; k < active_.count; ++k) numbers_.push_back(v(active_.axes[k]));
  }

  /// The number of vectors.
  std::size_t size() const { return numbers_.size() / active_.count; }
  /// Of memory, including spare capacity.
  std::size_t bytes() const { return numbers_.capacity() * sizeof(double); }

 private:
  ActiveAxes active_;
  std::vector<double> numbers_;
};
// [/kept-vectors]

/// How many impacts of a step are taken each at its own time. The rest of the step is then taken in
/// crowd_substeps substeps or more, and in each of them a pair bounces once. Balls hit as often as
/// their speeds say, and the cost of an impact is proportional to the number of pairs: one ball may
/// have 65,536, 64 of them 16 together. Bodies with vertices hit again and again, and all contacts
/// are solved anew for each: if they rotate they have 4. Where infinitely many hits come in a
/// finite time, this limit ends them.
/// @param edges whether a body rotates that is not a ball
inline int max_impacts(std::size_t movers, bool edges) {
  const std::size_t many = std::max<std::size_t>(movers, 1);
  return edges ? 4 : static_cast<int>(std::max<std::size_t>(65536 / (many * many), 4));
}
/// The largest number of moving bodies for which impacts are taken one by one, each at its own
/// time.
inline constexpr std::size_t max_one_by_one = 64;
/// The number of substeps of a step in which more bodies move, or hit more often; a power of two.
inline constexpr int crowd_substeps = 4;
/// How often in a row a substep is repeated because a body is thrown at another one.
inline constexpr int max_retries = 32;

/// The vertices of a convex hull.
struct HullVertices {
  std::vector<Vector3<double>> points;  ///< m
};

/// A shape, in its body's axes or in the world.
using StepShape = std::variant<Sphere<double>, Capsule<double>, OrientedBox<double>,
                               HalfSpace<double>, HullVertices>;

// [stepped-body]
/// The data of a body that never change.
struct SteppedBody {
  std::size_t body = 0;        ///< index into Scene::bodies
  StepShape shape;             ///< in the body's axes; a half-space in the world
  std::size_t material = 0;    ///< index into Scene::materials
  double mass = 0;             ///< kg; 0: fixed
  double bounding_radius = 0;  ///< bounding radius: no point of it is farther from its origin, m
  double rotation_radius = 0;  ///< lever arm with which rotation moves its points, m; 0 for a ball
  double core = 0;             ///< half its thickness, m; ∞ if unknown
  Vector3<double> moments = Vector3<double>::Zero();   ///< about its principal axes, kg·m²
  Matrix3<double> axes = Matrix3<double>::Identity();  ///< columns: its principal axes
  bool round = false;                                  ///< all its moments of inertia are equal
};
// [/stepped-body]

// [stepped-state]
/// The data that change, each in an array of its own, for moving bodies only. Without rotation
/// there are no orientations and no angular velocities, without sleep no times of rest: these
/// arrays are empty. Positions, velocities and angular velocities have only the coordinates that
/// change.
struct SteppedState {
  std::uint64_t step = 0;                       ///< number of steps done
  ActiveVectors position;                       ///< of each mover's origin, m
  ActiveVectors velocity;                       ///< m/s
  std::vector<Quaternion<double>> orientation;  ///< rotates a body's axes into the world's
  ActiveVectors angular_velocity;               ///< in the world, rad/s
  std::vector<double> slow_since;               ///< how long it has been slower than sleep_speed, s
  std::vector<std::int32_t> sleeps_with;        ///< the sleepers' group; −1: awake
  std::vector<BodyContact<double>> touched;     ///< contacts with a force in the last substep
  std::vector<ContactImpulse<double>> last_impulses;  ///< and the force of each, N
  SceneRunCounts counts;                              ///< so far
};
// [/stepped-state]

/// All data of a stepped run that never change.
struct SteppedSetup {
  Scene scene;                         ///< with its names and materials
  std::vector<SteppedBody> bodies;     ///< movers, then fixed bodies, half-spaces last
  std::vector<std::size_t> slot_of;    ///< of each of the scene's bodies in that list
  std::size_t movers = 0;              ///< number of bodies that move
  std::size_t bounded = 0;             ///< number of bodies other than half-spaces
  std::vector<PairMaterial> material;  ///< of each pair of materials, row after row
  double step = 0;                     ///< s
  double rest_height = 0;              ///< bounces no higher than this are left out, m
  double slow_speed = 0;               ///< slower approaches are rounding errors, m/s
  double sleep_speed = 0;              ///< slower bodies may sleep, m/s
  double thinnest = 0;                 ///< no body is thinner, m
  double spring_substep = 0;           ///< s; longest substep while a spring may push
  bool rotation = false;               ///< bodies rotate
  bool gyroscopic = false;             ///< angular velocities change without torque
  bool line = false;                   ///< two mirrors leave a line, and no rotation
  bool smooth = false;                 ///< no two materials have friction
  bool continuous = false;             ///< nothing passes through anything between two tests
  bool edges = false;                  ///< a body that is not a ball may rotate
  bool one_by_one = false;             ///< impacts each at its own time; else all at once
  int max_impacts = 0;                 ///< of a step, if one by one; then at once
  bool together = false;               ///< a body's contacts are solved together, iterated
  ActiveAxes active;                   ///< of positions and velocities
  ActiveAxes active_rotation;          ///< of angular velocities
  std::array<bool, 3> rotates{true, true,
                              true};  ///< about which axes angular velocities may change
  SolverSettings<double> solver;      ///< of the solver
};

/// Two bodies that may touch in a substep, and where.
struct NearPair {
  std::size_t a = 0;            ///< position of the one in the list; always a mover
  std::size_t b = 0;            ///< position of the other in the list
  PairMaterial material;        ///< of both
  double touch = 0;             ///< they touch if their distance is at most this, m
  double near = 0;              ///< the same, enlarged where a heavy body lies on a light one, m
  double closing_distance = 0;  ///< how far they may approach each other in this substep, m
  double distance = 0;          ///< now, m
  double slow = 0;              ///< slower approaches are rounding errors, m/s
  bool touching = false;        ///< now
  bool leaving = false;         ///< touching, and separating at every point
  ContactManifold<double> manifold;  ///< of touching pairs; of all, if all are solved at once
};

/// A contact that has pushed where all hits are taken at once, and its bounce.
struct StepBounce {
  BodyContact<double> contact;  ///< with the speed at which it leaves, or 0
  ContactImpulse<double> stop;  ///< impulse that has stopped it, N·s
};

/// The state with which a mover leaves a substep in which it bounces.
struct BouncedBody {
  std::size_t slot = 0;                                        ///< of the mover
  Vector3<double> velocity = Vector3<double>::Zero();          ///< m/s
  Vector3<double> angular_velocity = Vector3<double>::Zero();  ///< in that orientation, rad/s
  Quaternion<double> orientation;                              ///< before the substep
};

/// The search for the instant at which a sliding contact comes to rest, over repetitions of one
/// substep.
struct SlideSearch {
  /// Where the search is.
  enum class Stage {
    none,     ///< nothing is searched for
    shorter,  ///< the last substep was shortened, so that all contacts slide until its end
    found     ///< the last substep ends when sliding ends
  };
  Stage stage = Stage::none;  ///< of this substep
  double too_long = 0;        ///< a length in which sliding ends, s
};

/// The data that the stages of one substep pass on. Its arrays keep their capacity from substep to
/// substep.
struct Substep {
  double whole = 0;                    ///< length of the step, s
  double left = 0;                     ///< rest of the step, s
  double planned = 0;                  ///< its length without impacts, s; for the end velocities
  double length = 0;                   ///< length of this substep, s
  int cuts = 0;                        ///< number of substeps of this step that an impact has ended
  int events = 0;                      ///< number of those that an event of a contact has ended
  bool simultaneous = false;           ///< all impacts of the rest of the step at once
  double repeat_with = 0;              ///< repeat the substep with this length, s; 0: do not
  SlideSearch slide_search;            ///< over repetitions of this substep
  std::vector<StepBounce> pushing;     ///< contacts that carry a force, and their impulses
  std::vector<NearPair> pairs;         ///< in increasing order
  std::vector<StepShape> shapes;       ///< of each body in a pair, in the world
  ActiveVectors end_velocity;          ///< of each mover, m/s
  ActiveVectors end_angular_velocity;  ///< of each mover, rad/s; empty without rotation
  std::vector<bool> at_start;          ///< movers on which contacts act at the start of the substep
  /// Of these, the change of velocity by constant forces that no contact balances, m/s. Empty if
  /// there are none.
  std::vector<Vector3<double>> even;
  std::vector<bool> contacted;  ///< movers on which a contact acts in this substep
  std::vector<SceneHit> hits;   ///< of this step
  ActiveVectors free_velocity;  ///< of each mover at the end of the substep without contacts, m/s
  // Where all hits are taken at once:
  std::vector<StepBounce> bounces;      ///< contacts that have pushed
  std::vector<BouncedBody> bounced;     ///< bodies that leave with other velocities
  ActiveVectors free_angular_velocity;  ///< without contacts, rad/s; empty without rotation
  /// Of each mover, how far a push may displace it from the path of its velocity, m. Empty until a
  /// body is thrown farther than was tested.
  std::vector<double> deflection;
};

// [stage]
/// The type of every stage: a function of what never changes, what changes, and the substep.
using StepStage = void (*)(const SteppedSetup&, SteppedState&, Substep&);
// [/stage]

namespace detail {

SteppedBody stepped_body(const SceneBody& from, std::size_t index);

}  // namespace detail

/// Whether a body, by its index in the list, sleeps.
inline bool sleeps(const SteppedState& state, std::size_t slot) {
  return slot < state.sleeps_with.size() && state.sleeps_with[slot] >= 0;
}
/// Position of a body's origin, m.
inline Vector3<double> position_of(const SteppedSetup& setup, const SteppedState& state,
                                   std::size_t slot) {
  const Vector3<double>& start = setup.scene.bodies[setup.bodies[slot].body].position;
  return slot < setup.movers ? state.position.over(slot, start) : start;
}
/// Orientation of a body.
inline Quaternion<double> orientation_of(const SteppedSetup& setup, const SteppedState& state,
                                         std::size_t slot) {
  if (slot < state.orientation.size()) return state.orientation[slot];
  return setup.scene.bodies[setup.bodies[slot].body].orientation;
}
/// Velocity of a body, m/s.
inline Vector3<double> velocity_of(const SteppedSetup& setup, const SteppedState& state,
                                   std::size_t slot) {
  return slot < setup.movers ? state.velocity[slot] : Vector3<double>::Zero();
}
/// Angular velocity of a body, rad/s; 0 without rotation.
inline Vector3<double> angular_velocity_of(const SteppedState& state, std::size_t slot) {
  return slot < state.angular_velocity.size() ? state.angular_velocity[slot]
                                              : Vector3<double>::Zero();
}
/// Whether contacts depend on a mover's angular velocity: not for a smooth ball, where every
/// contact force acts through the centre, and not on a line.
inline bool rotated_by_contacts(const SteppedSetup& setup, std::size_t slot) {
  return setup.rotation && !setup.line && slot < setup.movers &&
         !(setup.smooth && setup.bodies[slot].rotation_radius == 0);
}
/// The velocity of a mover at the start of a substep, after the contacts that act at the start,
/// m/s.
inline Vector3<double> first_velocity(const SteppedState& state, const Substep& substep,
                                      std::size_t slot) {
  if (!substep.at_start[slot]) return state.velocity[slot];
  if (substep.even.empty()) return substep.end_velocity[slot];
  return substep.end_velocity[slot] - substep.even[slot];
}
/// The time at which a substep begins, s.
inline double time_of_substep(const SteppedSetup& setup, const SteppedState& state,
                              const Substep& substep) {
  return static_cast<double>(state.step) * setup.step + (substep.whole - substep.left);
}
/// A displacement in a step that is too small to matter, m: a part of the tolerance, or of 1e-6 m
/// if the scene has none.
inline double min_error(const SteppedSetup& setup) {
  return setup.scene.tolerance.position.value_or(1e-6) * 0x1p-10;
}
/// The size of a vector, m or m/s.
inline double size_of(const Vector3<double>& v) { return std::sqrt(v.dot(v)); }

/// Relative error by rounding of a velocity that impulses change.
inline constexpr double rounding_of_impulses = 0x1p-44;
/// The overlap above which the residual of the iterations is removed by an exact solve: a small
/// part of the thinnest body's thickness, m.
inline double max_residual(const SteppedSetup& setup) { return setup.thinnest / 1024; }
/// How far a body may be thrown off its path before its possible partners are searched again, m.
inline double max_deflection(const SteppedSetup& setup) { return setup.thinnest / 64; }

// [slowest-bounce]
/// The slowest impact that bounces: the speed of a bounce that is as long as a step, or as high as
/// may be left out, whichever is slower. A bounce at v rises v²/(2 g) along the contact's normal,
/// with the component of gravity that presses along it. A body that gravity does not press back
/// never comes back, and leaving out its bounce would change its path for good. Along a wall beside
/// which bodies fall, or under a ceiling, only rounding errors do not bounce.
/// @param still whether the other body is fixed; otherwise each may lie on the other
/// @param normal unit, from the other body
/// @return m/s; at least SteppedSetup::slow_speed
inline double slowest_bounce(const SteppedSetup& setup, bool still, const Vector3<double>& normal) {
  const double along = -normal.dot(setup.scene.gravity);
  const double g = still ? std::max(along, 0.0) : std::abs(along);
  const double bounce = std::min(g * setup.step / 2, std::sqrt(2 * g * setup.rest_height));
  return std::max(bounce, setup.slow_speed);
}
// [/slowest-bounce]

}  // namespace contact

#ifndef CONTACT_SCENES_COMPILED
#include "../../src/stepped_state.cpp"
#endif
