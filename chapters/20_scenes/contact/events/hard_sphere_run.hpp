/// @file
/// The interface of a simulation of hard, smooth balls, whatever it is composed of; its setup, and
/// two families of setups of any size.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <contact/vector.hpp>

namespace contact {

// [effects]
/// The effects of which a simulation of hard balls is composed. An effect that is off costs no byte
/// of a ball's state and no instruction.
struct HardSphereEffects {
  int dimension = 3;        ///< number of coordinates that change: 1, 2 or 3
  bool gravity = true;      ///< paths are parabolas, and balls may rest on a wall
  bool sizes = true;        ///< radii or masses differ
  bool restitution = true;  ///< not all contacts are elastic
  bool grid = true;         ///< balls test their neighbours; off: all pairs are tested

  /// Whether two compositions are equal.
  friend constexpr bool operator==(const HardSphereEffects&, const HardSphereEffects&) = default;
};
// [/effects]

/// How a run ended.
enum class HardSphereEnd {
  reached,        ///< the time that was asked for
  out_of_events,  ///< the budget of hits is used up; the run can go on
  stopped,        ///< the observer asked to stop; the run can go on
  endless_hits    ///< no bound on the number of hits was found; see HardSphereCounts
};

/// What a run has done so far.
struct HardSphereCounts {
  std::uint64_t hits = 0;        ///< of balls with balls and walls
  std::uint64_t crossings = 0;   ///< from cell to cell
  std::uint64_t stale = 0;       ///< predictions that another hit had invalidated
  std::uint64_t rests = 0;       ///< how often a ball came to rest on a wall
  double largest_overlap = 0;    ///< of two bodies that hit, at the hit, m: rounding alone
  double rest_error = 0;         ///< largest displacement of paths by coming to rest, m, in all
  std::size_t endless_ball = 0;  ///< after endless_hits: the ball that hit too often
  std::int32_t endless_partner = -1;  ///< and what it hit last
};

/// A hit, just after it.
struct HardSphereHit {
  double time = 0;          ///< s
  std::size_t ball = 0;     ///< index; of two balls the lower one
  std::size_t partner = 0;  ///< of the other ball, or the number of balls plus the wall's index
  Vector3<double> impulse = Vector3<double>::Zero();  ///< on the first, N·s
};

/// A ball's next event as it is stored in the queue, to be looked at.
struct HardSpherePrediction {
  double time = std::numeric_limits<double>::infinity();  ///< of the event, s; infinite: none
  bool crossing = false;  ///< the ball leaves its cell before the hit, or there is no hit
  double hit_time = std::numeric_limits<double>::infinity();  ///< of the earliest hit known, s
  /// The other ball, or the number of balls plus the wall's index; −1: no hit is known.
  std::int32_t partner = -1;
  bool is_void = false;  ///< the partner was hit after the prediction, so the hit will not happen
};

/// Receives each hit.
class HardSphereObserver {
 public:
  HardSphereObserver() = default;
  HardSphereObserver(const HardSphereObserver&) = delete;
  HardSphereObserver& operator=(const HardSphereObserver&) = delete;
  virtual ~HardSphereObserver() = default;
  /// @return whether to go on
  virtual bool on_hit(const HardSphereHit& hit) = 0;
};

/// The complete state, from which a run goes on with the same bits.
struct HardSphereCheckpoint {
  /// A ball at its last hit.
  struct Ball {
    Vector3<double> position = Vector3<double>::Zero();  ///< m; 0 along axes that do not change
    Vector3<double> velocity = Vector3<double>::Zero();  ///< m/s
    double time = 0;                                     ///< s
    std::int32_t last = -1;                              ///< what it hit last, or −1
    std::int32_t rests_on = -1;                          ///< wall, or −1
    std::int32_t short_flights = 0;                      ///< hits in a row within the cutoff
  };
  double now = 0;                  ///< s
  std::uint64_t simultaneous = 0;  ///< hits at the present instant
  HardSphereCounts counts;         ///< so far
  std::vector<Ball> balls;         ///< in order
};

/// A simulation of hard balls.
class HardSphereRun {
 public:
  /// @param effects of which it is composed
  /// @param axes the world's axes along which balls move, the first `effects.dimension` entries
  HardSphereRun(const HardSphereEffects& effects, const std::array<int, 3>& axes)
      : effects_(effects), axes_(axes) {}
  HardSphereRun(const HardSphereRun&) = delete;
  HardSphereRun& operator=(const HardSphereRun&) = delete;
  virtual ~HardSphereRun() = default;

  /// The effects of which it is composed.
  const HardSphereEffects& effects() const { return effects_; }
  /// The world's axes along which balls move.
  const std::array<int, 3>& axes() const { return axes_; }

  /// Simulates until a time.
  /// @param until s; nothing happens if it is past
  /// @param budget of hits
  /// @param observer receives each hit, or null
  virtual HardSphereEnd advance(double until, std::uint64_t budget,
                                HardSphereObserver* observer) = 0;
  /// The same without a limit and without an observer.
  HardSphereEnd advance(double until) {
    return advance(until, std::numeric_limits<std::uint64_t>::max(), nullptr);
  }

  /// The time that was reached, s.
  virtual double now() const = 0;
  /// The number of balls that move; they come first.
  virtual std::size_t moving() const = 0;
  /// Position of a ball's centre now, m.
  virtual Vector3<double> position(std::size_t ball) const = 0;
  /// Velocity of a ball now, m/s.
  virtual Vector3<double> velocity(std::size_t ball) const = 0;
  /// The wall on which a ball lies, or −1.
  virtual std::int32_t rests_on(std::size_t ball) const = 0;
  /// Kinetic and potential energy (0 at the origin) of all balls, J, by recursive summation.
  virtual double energy() const = 0;
  /// What it has done so far.
  virtual HardSphereCounts counts() const = 0;
  /// Bytes that it holds.
  virtual std::size_t bytes() const = 0;
  /// Bytes of one ball's state.
  virtual std::size_t bytes_per_state() const = 0;
  /// The present state.
  virtual HardSphereCheckpoint checkpoint() const = 0;
  /// Restores a state of the same setup, earlier or later.
  /// @throws std::invalid_argument if it has another number of balls
  virtual void restore(const HardSphereCheckpoint& from) = 0;

 private:
  HardSphereEffects effects_;
  std::array<int, 3> axes_;
};

/// A smooth ball. It does not rotate, since no torque acts on it.
struct HardBall {
  Vector3<double> position = Vector3<double>::Zero();  ///< of its centre, m
  Vector3<double> velocity = Vector3<double>::Zero();  ///< m/s; 0 if it does not move
  double radius = 0;                                   ///< m, greater than 0
  double mass = 0;                                     ///< kg, greater than 0 if it moves
  std::size_t material = 0;                            ///< row of HardSphereSetup::restitution
  bool moves = true;                                   ///< false: it is fixed
};

/// A smooth wall or floor: no point of a ball may have normal · x < offset. Never moves.
struct HardWall {
  Vector3<double> normal = Vector3<double>::UnitZ();  ///< unit vector, towards the balls
  double offset = 0;                                  ///< m
  std::size_t material = 0;                           ///< row of HardSphereSetup::restitution
};

/// Balls, walls, and coefficients of restitution. Balls may touch at the start, but not overlap.
struct HardSphereSetup {
  Vector3<double> gravity = Vector3<double>::Zero();  ///< m/s²
  std::vector<HardBall> balls;                        ///< moving ones first, then fixed ones
  std::vector<HardWall> walls;                        ///< fixed half-spaces
  /// Coefficients of restitution, from 0 to 1, a symmetric square table: row and column by
  /// material.
  std::vector<double> restitution{1.0};
  /// s. A ball whose next bounce on a wall would be shorter is set to rest on it: its path is then
  /// displaced by at most (pull towards the wall) cutoff² / 8. A ball that hits otherwise more
  /// often than 1,000 times in a row, each time sooner than this, ends the run.
  double cutoff = 0x1p-20;
};

/// How many of the balls move.
inline std::size_t moving_balls(const HardSphereSetup& setup) {
  std::size_t count = 0;
  while (count < setup.balls.size() && setup.balls[count].moves) ++count;
  return count;
}

/// Throws std::invalid_argument unless a setup is valid: finite numbers, radii and masses greater
/// than 0, unit normals, coefficients from 0 to 1, materials that are in the table, at least one
/// moving ball, and fixed balls after all moving ones. Overlaps are not checked.
void require_hard_sphere_setup(const HardSphereSetup& setup);

namespace detail {

/// n balls of radius 0.5 and mass 1 on a lattice, each randomly shifted, with velocities drawn from
/// a ball, in a box round the lattice that is `higher` times as high.
HardSphereSetup balls_on_lattice(std::size_t n, std::uint64_t seed, double spacing, double jitter,
                                 double speed, double higher);

}  // namespace detail

// [elastic-lattice]
/// Elastic balls under gravity in a box: the scene on which engines gain energy. n balls of radius
/// 0.5 m and mass 1 kg on a jittered lattice of spacing 1.2 m, speeds up to 3 m/s, in a box 1.5
/// times as high as the lattice, with g = 10 m/s².
inline HardSphereSetup elastic_lattice(std::size_t n, std::uint64_t seed) {
  HardSphereSetup setup = detail::balls_on_lattice(n, seed, 1.2, 0.09, 3, 1.5);
  setup.gravity = {0, 0, -10};
  return setup;
}

/// A dilute gas without gravity: n balls of radius 0.5 m, one in each cube of edge 5 m (0.4 % of
/// the room), speeds up to 3 m/s, in a box. Its density does not depend on n.
inline HardSphereSetup dilute_gas(std::size_t n, std::uint64_t seed) {
  return detail::balls_on_lattice(n, seed, 5, 1.9, 3, 1);
}
// [/elastic-lattice]

}  // namespace contact

#ifndef CONTACT_SCENES_COMPILED
#include "../../src/hard_sphere_run.cpp"
#endif
