/// @file
/// A simulation of hard balls as its user sees it, whatever it is composed of.
/// What a simulation of hard, smooth balls is given, and two families of such setups of any size.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <contact/vector.hpp>

namespace contact {

// [effects]
/// Of which effects a simulation of hard balls is composed. One that is off costs no byte of a
/// ball's state and no instruction.
struct HardSphereEffects {
  int dimension = 3;        ///< how many coordinates move: 1, 2 or 3
  bool gravity = true;      ///< paths bend, and balls may come to lie on a wall
  bool sizes = true;        ///< radii or masses differ
  bool restitution = true;  ///< not everything is elastic
  bool grid = true;         ///< balls ask their neighbours; off: everybody asks everybody

  /// Whether two compositions are the same.
  friend constexpr bool operator==(const HardSphereEffects&, const HardSphereEffects&) = default;
};
// [/effects]

/// How a run ended.
enum class HardSphereEnd {
  reached,        ///< the time that was asked for
  out_of_events,  ///< the budget of hits is used up; the run can go on
  stopped,        ///< the observer said so; the run can go on
  endless_hits    ///< no bound on the number of hits was found; see HardSphereCounts
};

/// What a run has done so far.
struct HardSphereCounts {
  std::uint64_t hits = 0;        ///< of balls with balls and walls
  std::uint64_t crossings = 0;   ///< from cell to cell
  std::uint64_t stale = 0;       ///< predictions that another hit had made void
  std::uint64_t rests = 0;       ///< how often a ball lay down on a wall
  double largest_overlap = 0;    ///< of any two that hit, at the moment of a hit, m: rounding alone
  double rest_error = 0;         ///< how far lying down has put a path off at most, m, in all
  std::size_t endless_ball = 0;  ///< after endless_hits: who hit too often
  std::int32_t endless_partner = -1;  ///< and whom it hit last
};

/// A hit, just after it.
struct HardSphereHit {
  double time = 0;          ///< s
  std::size_t ball = 0;     ///< who; of two balls that with the lower number
  std::size_t partner = 0;  ///< whom: a ball, or the number of balls and the wall's number
  Vector3<double> impulse = Vector3<double>::Zero();  ///< on the first, N·s
};

/// Is told of each hit.
class HardSphereObserver {
 public:
  HardSphereObserver() = default;
  HardSphereObserver(const HardSphereObserver&) = delete;
  HardSphereObserver& operator=(const HardSphereObserver&) = delete;
  virtual ~HardSphereObserver() = default;
  /// @return whether to go on
  virtual bool on_hit(const HardSphereHit& hit) = 0;
};

/// All that a run needs to go on with the same bits.
struct HardSphereCheckpoint {
  /// A ball at its last hit.
  struct Ball {
    Vector3<double> position = Vector3<double>::Zero();  ///< m; 0 along axes that do not count
    Vector3<double> velocity = Vector3<double>::Zero();  ///< m/s
    double time = 0;                                     ///< s
    std::int32_t last = -1;                              ///< whom it hit last, or −1
    std::int32_t lies_on = -1;                           ///< wall, or −1
    std::int32_t short_flights = 0;                      ///< hits in a row within the cutoff
  };
  double now = 0;             ///< s
  std::uint64_t at_once = 0;  ///< hits since time last went on
  HardSphereCounts counts;    ///< so far
  std::vector<Ball> balls;    ///< in order
};

/// A simulation of hard balls.
class HardSphereRun {
 public:
  /// @param effects of which it is composed
  /// @param axes which of the world's axes count, the first `effects.dimension` entries
  HardSphereRun(const HardSphereEffects& effects, const std::array<int, 3>& axes)
      : effects_(effects), axes_(axes) {}
  HardSphereRun(const HardSphereRun&) = delete;
  HardSphereRun& operator=(const HardSphereRun&) = delete;
  virtual ~HardSphereRun() = default;

  /// Of which effects it is composed.
  const HardSphereEffects& effects() const { return effects_; }
  /// Which of the world's axes count.
  const std::array<int, 3>& axes() const { return axes_; }

  /// Simulates until a time.
  /// @param until s; nothing happens if it is past
  /// @param budget of hits
  /// @param observer told of each hit, or null
  virtual HardSphereEnd advance(double until, std::uint64_t budget,
                                HardSphereObserver* observer) = 0;
  /// The same without a limit, and nobody is told.
  HardSphereEnd advance(double until) {
    return advance(until, std::numeric_limits<std::uint64_t>::max(), nullptr);
  }

  /// The time that was reached, s.
  virtual double now() const = 0;
  /// How many balls move; they are the first.
  virtual std::size_t moving() const = 0;
  /// Where a ball's centre is now, m.
  virtual Vector3<double> position(std::size_t ball) const = 0;
  /// How a ball moves now, m/s.
  virtual Vector3<double> velocity(std::size_t ball) const = 0;
  /// The wall on which a ball lies, or −1.
  virtual std::int32_t lies_on(std::size_t ball) const = 0;
  /// Kinetic energy and that in gravity (0 at the origin) of all balls, J, in order.
  virtual double energy() const = 0;
  /// What it has done so far.
  virtual HardSphereCounts counts() const = 0;
  /// Bytes that it holds.
  virtual std::size_t bytes() const = 0;
  /// Bytes of one ball's state.
  virtual std::size_t bytes_per_state() const = 0;
  /// The present state.
  virtual HardSphereCheckpoint checkpoint() const = 0;
  /// Goes back, or on, to a state of the same setup.
  /// @throws std::invalid_argument if it has another number of balls
  virtual void restore(const HardSphereCheckpoint& from) = 0;

 private:
  HardSphereEffects effects_;
  std::array<int, 3> axes_;
};

/// A smooth ball. It does not turn: nothing could turn it.
struct HardBall {
  Vector3<double> position = Vector3<double>::Zero();  ///< of its centre, m
  Vector3<double> velocity = Vector3<double>::Zero();  ///< m/s; 0 if it does not move
  double radius = 0;                                   ///< m, greater than 0
  double mass = 0;                                     ///< kg, greater than 0 if it moves
  std::size_t material = 0;                            ///< row of HardSphereSetup::restitution
  bool moves = true;                                   ///< false: nothing moves it
};

/// A smooth wall or floor: no point of a ball may have normal · x < offset. Never moves.
struct HardWall {
  Vector3<double> normal = Vector3<double>::UnitZ();  ///< unit vector, towards the balls
  double offset = 0;                                  ///< m
  std::size_t material = 0;                           ///< row of HardSphereSetup::restitution
};

/// Balls, walls, and what makes them bounce. Balls may touch at first, and not overlap.
struct HardSphereSetup {
  Vector3<double> gravity = Vector3<double>::Zero();  ///< m/s²
  std::vector<HardBall> balls;                        ///< those that move first, then the others
  std::vector<HardWall> walls;                        ///< half-spaces that do not move
  /// Coefficients of restitution, from 0 to 1, a symmetric square table: row and column by
  /// material.
  std::vector<double> restitution{1.0};
  /// s. A ball whose next hop on a wall would be shorter lies down on it: its path is then off by
  /// at most (pull towards the wall) cutoff² / 8. A ball that without that hits more often than
  /// 1,000 times in a row, each time sooner than this, ends the run.
  double cutoff = 0x1p-20;
};

/// How many of the balls move.
inline std::size_t moving_balls(const HardSphereSetup& setup) {
  std::size_t count = 0;
  while (count < setup.balls.size() && setup.balls[count].moves) ++count;
  return count;
}

/// Throws std::invalid_argument unless a setup is one: finite numbers, radii and masses greater
/// than 0, unit normals, coefficients from 0 to 1, materials that are in the table, at least one
/// ball that moves, and those that do not after all that do. Overlaps are not looked for.
void require_hard_sphere_setup(const HardSphereSetup& setup);

namespace detail {

/// n balls of radius 0.5 and mass 1 on a lattice, each moved off its place, with velocities drawn
/// from a ball, in a box round the lattice that is `higher` times as high.
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
