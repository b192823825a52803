/// @file
/// What spreads neighbouring paths apart from round bodies: hits at the same instant, whose order
/// decides; walls at an angle; bounces that graze a ceiling; springs; and the first hits, where
/// they are more oblique than on average. All of it is computed from the scene, before it runs.
#pragma once

#include <cstddef>
#include <vector>

namespace contact {

struct PlanInput;  // plan_rules.hpp

/// The number of pairs with friction where a body may meet more than one other.
/// @return 0 on a line, where nothing slides
double rough_pairs_beside_others(const PlanInput& q);

/// The number of compliant pairs where a body may meet more than one other. A single ball on a
/// single spring has a period that depends on its energy, so a difference only grows with time.
double springs_beside_others(const PlanInput& q);

/// Pairs of half-spaces that one body may meet, and whose corner it may leave in two directions:
/// which wall it hits first decides.
///
/// At a right angle the hits change different components, so the order does not matter, whatever is
/// lost. At π/k (k = 3, 4, ...) without loss both orders are the same reflection. Parallel walls
/// are not hit at one instant. Right angles and parallels are compared exactly, π/k up to rounding,
/// which adds to the direction no more than a hit does.
double corners_of_two_ways(const PlanInput& q);

/// Bodies on a line that two others may hit at one instant, so that the order decides.
///
/// Equal masses with e = 1 exchange their velocities, as if they passed through each other: each
/// velocity arrives where it would arrive, in whatever order. Walls only reverse such a velocity,
/// with any loss. With e = 0 bodies stay together, and their momentum decides. A body alone between
/// fixed ones cannot hit both at one instant.
double hit_from_two_sides(const PlanInput& q);

/// Bodies whose rise comes within 1 % of the energy at which they graze a ceiling, in any bounce: a
/// flight that just touches it is shorter than one that just does not, by the root of the
/// difference. Between a floor and a ceiling perpendicular to gravity the sequence of energies is
/// known: a hit leaves e² of the kinetic energy.
double ceilings_grazed(const PlanInput& q);

/// No body is hit by two others at one instant before this time, by the speeds that energy allows.
/// @return s; 0 for a crowd
double earliest_hits_at_once(const PlanInput& q);

/// Pairs, half-spaces excluded, that touch at the start beside other partners, or whose first hits
/// are at the same instant; only where a hit rebounds.
double hits_at_once(const PlanInput& q);

/// The first hit of two balls, if nothing disturbs them before.
struct FirstHit {
  std::size_t a = 0;    ///< index of a body
  std::size_t b = 0;    ///< index of the other
  double time = 0;      ///< s; of a near miss, of the least distance
  double speed = 0;     ///< relative, m/s
  double radius = 0;    ///< sum of the radii, m
  double distance = 0;  ///< of the relative path from the other's centre: impact parameter, m
};

/// The first hits of pairs of balls, and misses by less than `margin`. None of a crowd, nor on a
/// fixed ball under gravity, where a path is a parabola.
/// @param margin m
std::vector<FirstHit> first_hits(const PlanInput& q, double margin);

/// By how much an error of the impact parameter rotates the direction after a hit: the deflection
/// is π − 2 asin(b/R), and 0 for a miss.
/// @param error m
/// @return the largest difference of two deflections, rad
double spread_of_deflection(const FirstHit& hit, double error);

/// The first time at which first hits of one body are at the same instant, or one of them meets a
/// body that touches a third.
/// @return s; ∞ if there is none
double first_hits_at_once(const PlanInput& q, const std::vector<FirstHit>& hits);

/// Whether there is one pair of smooth hard balls without gravity, which meets at most once: then
/// the horizon is a bound, since the only hit is computed. Otherwise it is an estimate for typical
/// hits.
bool at_most_one_hit(const PlanInput& q);

}  // namespace contact

#ifndef CONTACT_SCENES_COMPILED
#include "../../src/plan_spreading.cpp"
#endif
