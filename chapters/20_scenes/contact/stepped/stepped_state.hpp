/// @file
/// Many vectors of which only the coordinates are kept that may change.
/// How the impacts of a step are taken: each at its own time, or many at once.
/// What a stepped run knows of a scene: what never changes, what changes from step to step, and
/// what one part of a step hands from stage to stage.
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
#include <contact/gap.hpp>
#include <contact/inertia.hpp>
#include <contact/plan/plan_bounds.hpp>
#include <contact/rotation.hpp>
#include <contact/scene/scene.hpp>
#include <contact/scene/scene_run.hpp>
#include <contact/vector.hpp>

namespace contact {

/// Which coordinates of a run change: all three, two in a plane, or one on a line.
struct KeptAxes {
  std::array<int, 3> axes{0, 1, 2};  ///< the first `count` are kept
  std::size_t count = 3;             ///< 1, 2 or 3
  std::array<bool, 3> held{};        ///< of those kept, which stay as they were put in
};

// [kept-vectors]
/// A vector for each body, with only the coordinates that change: a body on a line has one number.
class KeptVectors {
 public:
  KeptVectors() = default;
  /// @param kept of every vector
  explicit KeptVectors(const KeptAxes& kept) : kept_(kept) {}

  /// The vector with that index; what is not kept is 0.
  Vector3<double> operator[](std::size_t i) const { return over(i, Vector3<double>::Zero()); }

  /// The vector with that index; what is not kept is as in `rest`.
  Vector3<double> over(std::size_t i, Vector3<double> rest) const {
    const double* from = numbers_.data() + i * kept_.count;
    for (std::size_t k = 0; k < kept_.count; ++k) rest(kept_.axes[k]) = from[k];
    return rest;
  }

  /// Puts a vector there; of coordinates that are not kept nothing is seen again.
  void set(std::size_t i, const Vector3<double>& v) {
    double* to = numbers_.data() + i * kept_.count;
    for (std::size_t k = 0; k < kept_.count; ++k)
      if (!kept_.held[k]) to[k] = v(kept_.axes[k]);
  }

  /// Adds to the vector with that index.
  void add(std::size_t i, const Vector3<double>& v) {
    double* to = numbers_.data() + i * kept_.count;
    for (std::size_t k = 0; k < kept_.count; ++k)
      if (!kept_.held[k]) to[k] += v(kept_.axes[k]);
  }

  /// One more, at the end.
  void push_back(const Vector3<double>& v) {
    for (std::size_t k = 0; k < kept_.count; ++k) numbers_.push_back(v(kept_.axes[k]));
  }

  /// How many there are.
  std::size_t size() const { return numbers_.size() / kept_.count; }
  /// Of memory, its spare room included.
  std::size_t bytes() const { return numbers_.capacity() * sizeof(double); }

 private:
  KeptAxes kept_;
  std::vector<double> numbers_;
};
// [/kept-vectors]

/// How many impacts of a step are taken each at its own time. What is left of it then is taken in
/// crowd_parts parts or more, and in each of them a pair bounces once. Balls meet as often as their
/// speeds say, and each impact costs as much as there are pairs: one ball may have 65536, 64 of
/// them 16 together. Corners chatter, and all that touches is solved anew for each: what turns and
/// has some has 4. Where infinitely many hits come in a finite time it is this that ends them.
/// @param edges whether something turns that is no ball
inline int most_impacts(std::size_t movers, bool edges) {
  const std::size_t many = std::max<std::size_t>(movers, 1);
  return edges ? 4 : static_cast<int>(std::max<std::size_t>(65536 / (many * many), 4));
}
/// How many bodies may move for impacts to be taken one by one, each at its own time.
inline constexpr std::size_t most_one_by_one = 64;
/// In how many parts a step is taken in which more bodies move, or hit more often; a power of two.
inline constexpr int crowd_parts = 4;
/// How often in a row a part is taken anew because somebody is flung at somebody else.
inline constexpr int most_anew = 32;

/// The corners of a convex hull.
struct HullCorners {
  std::vector<Vector3<double>> points;  ///< m
};

/// A shape, in its body's axes or in the world.
using StepShape = std::variant<Sphere<double>, Capsule<double>, OrientedBox<double>,
                               HalfSpace<double>, HullCorners>;

// [stepped-body]
/// What never changes of a body.
struct SteppedBody {
  std::size_t body = 0;      ///< index into Scene::bodies
  StepShape shape;           ///< in the body's axes; a half-space in the world
  std::size_t material = 0;  ///< index into Scene::materials
  double mass = 0;           ///< kg; 0: nothing moves it
  double reach = 0;          ///< no point of it is farther from its origin, m
  double spin_arm = 0;       ///< how far turning can take a point of it, m; 0 for a ball
  double core = 0;           ///< half its thickness, m; ∞ if that is not known
  Vector3<double> moments = Vector3<double>::Zero();   ///< about its principal axes, kg·m²
  Matrix3<double> axes = Matrix3<double>::Identity();  ///< columns: its principal axes
  bool round = false;                                  ///< all its moments are equal
};
// [/stepped-body]

// [stepped-state]
/// What changes, each in an array of its own: only the movers have it. Without rotation there are
/// no orientations and no spins, without sleep no time of rest: the arrays are empty. Of places and
/// velocities, and of spins, only the coordinates are there that change.
struct SteppedState {
  std::uint64_t step = 0;                      ///< how many are done
  KeptVectors position;                        ///< of each mover's origin, m
  KeptVectors velocity;                        ///< m/s
  std::vector<Rotor<double>> orientation;      ///< turns a body's axes into the world's
  KeptVectors spin;                            ///< in the world, rad/s
  std::vector<double> slow_since;              ///< how long it has been as slow as rest, s
  std::vector<std::int32_t> sleeps_with;       ///< the sleepers' group; −1: awake
  std::vector<BodyContact<double>> touched;    ///< contacts that carried a force in the last part
  std::vector<ContactImpulse<double>> pushed;  ///< and the force of each, N
  SceneRunCounts counts;                       ///< so far
};
// [/stepped-state]

/// All that never changes of a stepped run.
struct SteppedSetup {
  Scene scene;                         ///< with its names and materials
  std::vector<SteppedBody> bodies;     ///< movers, then what stands still, half-spaces last
  std::vector<std::size_t> place;      ///< of each of the scene's bodies in that list
  std::size_t movers = 0;              ///< how many move
  std::size_t bounded = 0;             ///< how many are no half-spaces
  std::vector<PairMaterial> material;  ///< of each pair of materials, row after row
  double step = 0;                     ///< s
  double rest_height = 0;              ///< hops no higher than this are left out, m
  double slow_speed = 0;               ///< slower approaches are rounding, m/s
  double sleep_speed = 0;              ///< slower bodies may sleep, m/s
  double thinnest = 0;                 ///< no body is thinner, m
  double spring_part = 0;              ///< s; no part is longer while a spring may push
  bool rotation = false;               ///< bodies turn
  bool gyroscopic = false;             ///< spins change though nothing pushes
  bool line = false;                   ///< two mirrors leave a line, and no spin
  bool smooth = false;                 ///< no two materials rub
  bool continuous = false;             ///< nothing passes through anything between two looks
  bool edges = false;                  ///< somebody may turn who is no ball
  bool one_by_one = false;             ///< impacts each at its own time; else all of a step at once
  int most_impacts = 0;                ///< of a step, if one by one; then at once
  bool together = false;               ///< a body's contacts are solved together, in many sweeps
  KeptAxes kept;                       ///< of places and velocities
  KeptAxes kept_spins;                 ///< of spins
  std::array<bool, 3> turns{true, true, true};  ///< about which axes spins may change
  SweepLimits<double> sweeps;                   ///< of the solver
};

/// Two bodies that may touch in a part of a step, and where.
struct NearPair {
  std::size_t a = 0;      ///< place of the one; always a mover
  std::size_t b = 0;      ///< place of the other
  PairMaterial material;  ///< of both
  double touch = 0;       ///< they touch if they are no farther apart, m
  double near = 0;        ///< rounding may have left them so far apart where much lies on little, m
  double reach = 0;       ///< how far they may come towards each other in this part, m
  double distance = 0;    ///< now, m
  double slow = 0;        ///< slower approaches are rounding, m/s
  bool touching = false;  ///< now
  bool leaving = false;   ///< touching, and every point of it parts
  ContactManifold<double> manifold;  ///< of those that touch; of all, if all are solved at once
};

/// A contact that has pushed where all hits are taken at once, and how it bounces then.
struct StepBounce {
  BodyContact<double> contact;  ///< with the speed at which it leaves, or 0
  ContactImpulse<double> stop;  ///< what has stopped it, N·s
};

/// How a mover leaves a part in which it bounces.
struct BouncedBody {
  std::size_t place = 0;                               ///< of the mover
  Vector3<double> velocity = Vector3<double>::Zero();  ///< m/s
  Vector3<double> spin = Vector3<double>::Zero();      ///< as it lay before the part, rad/s
  Rotor<double> orientation;                           ///< how it lay
};

/// What the stages of one part of a step hand on. Its arrays keep their room from part to part.
struct StepPart {
  double whole = 0;      ///< how long the step is, s
  double left = 0;       ///< of the step, s
  double planned = 0;    ///< how long this part is without impacts, s; the end velocities are then
  double length = 0;     ///< how long it is, s
  int cuts = 0;          ///< how many parts of this step an impact has ended
  bool at_once = false;  ///< all impacts of what is left of the step at once
  std::vector<NearPair> pairs;    ///< in increasing order
  std::vector<StepShape> shapes;  ///< of each body in a pair, in the world
  KeptVectors end_velocity;       ///< of each mover, m/s
  KeptVectors end_spin;           ///< of each mover, rad/s; empty without rotation
  std::vector<bool> at_start;     ///< movers on which contacts act at the start of the part
  /// Of these, what changes their velocities evenly all the same, m/s: what no contact holds back.
  /// Empty if there are none.
  std::vector<Vector3<double>> even;
  std::vector<bool> pushed;    ///< movers on which a contact acts in this part
  std::vector<SceneHit> hits;  ///< of this step
  KeptVectors free_velocity;   ///< of each mover at the end of the part, had nothing pushed it, m/s
  // Where all hits are taken at once:
  std::vector<StepBounce> bounces;   ///< what has pushed
  std::vector<BouncedBody> bounced;  ///< who leaves otherwise than its forces say
  KeptVectors free_spin;             ///< of spins, rad/s; empty without rotation
  /// Of each mover, how far it may come off the way that its velocity says, because somebody pushes
  /// it, m. Empty until somebody is flung farther than was looked for.
  std::vector<double> flung;
};

// [stage]
/// What every stage is: a function of what never changes, what changes, and the part at hand.
using StepStage = void (*)(const SteppedSetup&, SteppedState&, StepPart&);
// [/stage]

namespace detail {

SteppedBody stepped_body(const SceneBody& from, std::size_t index);

}  // namespace detail

/// Whether a body, by its place, sleeps.
inline bool sleeps(const SteppedState& state, std::size_t place) {
  return place < state.sleeps_with.size() && state.sleeps_with[place] >= 0;
}
/// Where a body's origin is, m.
inline Vector3<double> position_of(const SteppedSetup& setup, const SteppedState& state,
                                   std::size_t place) {
  const Vector3<double>& start = setup.scene.bodies[setup.bodies[place].body].position;
  return place < setup.movers ? state.position.over(place, start) : start;
}
/// How a body lies.
inline Rotor<double> orientation_of(const SteppedSetup& setup, const SteppedState& state,
                                    std::size_t place) {
  if (place < state.orientation.size()) return state.orientation[place];
  return setup.scene.bodies[setup.bodies[place].body].orientation;
}
/// How fast a body is, m/s.
inline Vector3<double> velocity_of(const SteppedSetup& setup, const SteppedState& state,
                                   std::size_t place) {
  return place < setup.movers ? state.velocity[place] : Vector3<double>::Zero();
}
/// How a body turns, rad/s; 0 without rotation.
inline Vector3<double> spin_of(const SteppedState& state, std::size_t place) {
  return place < state.spin.size() ? state.spin[place] : Vector3<double>::Zero();
}
/// Whether contacts change a mover's spin, or ask it: not of a smooth ball, of which every
/// contact's force runs through the middle, and nobody's on a line.
inline bool turned_by_contacts(const SteppedSetup& setup, std::size_t place) {
  return setup.rotation && !setup.line && place < setup.movers &&
         !(setup.smooth && setup.bodies[place].spin_arm == 0);
}
/// With what velocity a mover begins a part, once contacts have acted that act at the start, m/s.
inline Vector3<double> first_velocity(const SteppedState& state, const StepPart& part,
                                      std::size_t place) {
  if (!part.at_start[place]) return state.velocity[place];
  if (part.even.empty()) return part.end_velocity[place];
  return part.end_velocity[place] - part.even[place];
}
/// The size of a vector, m or m/s.
inline double size_of(const Vector3<double>& v) { return std::sqrt(v.dot(v)); }

/// By how much of the velocity that impulses change it may be wrong, by rounding.
inline constexpr double rounding_of_impulses = 0x1p-44;
/// How far bodies may come into each other before what sweeps have left is finished: a small part
/// of the thinnest one, m.
inline double most_left(const SteppedSetup& setup) { return setup.thinnest / 1024; }
/// How far somebody may be flung off its way before it is asked whom it may meet there, m.
inline double most_flung(const SteppedSetup& setup) { return setup.thinnest / 64; }

// [slowest-bounce]
/// How fast an impact must be to bounce: as fast as a hop needs that is as long as a step, or as
/// high as may be left out, whichever is slower. What leaves at v rises v²/(2 g) along the
/// contact's normal, with the g that presses along it. So gravity decides: what it does not press
/// back never comes back, and not to bounce would be no hop less but another way. Along a wall
/// beside which all falls, or under a ceiling, only what rounding makes does not bounce.
/// @param still whether the other body stands still; else each may lie on the other
/// @param normal unit, from the other body
/// @return m/s; SteppedSetup::slow_speed at least
inline double slowest_bounce(const SteppedSetup& setup, bool still, const Vector3<double>& normal) {
  const double along = -normal.dot(setup.scene.gravity);
  const double g = still ? std::max(along, 0.0) : std::abs(along);
  const double hop = std::min(g * setup.step / 2, std::sqrt(2 * g * setup.rest_height));
  return std::max(hop, setup.slow_speed);
}
// [/slowest-bounce]

}  // namespace contact

#ifndef CONTACT_SCENES_COMPILED
#include "../../src/stepped_state.cpp"
#endif
