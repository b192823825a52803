/// @file
/// What one of each thing costs that a run is made of: the unit costs of a plan's estimates.
///
/// The unit is an instruction of this book's own code as g++ makes it for x86-64 at -O2. Each was
/// counted by valgrind: benchmarks/scene_stages.py prints the counts of its stage and of whole runs
/// beside the estimates, and fails if they are more than a factor apart. None decides anything but
/// whether a broad phase pays.
#pragma once

#include <cstddef>

namespace contact::cost {

// [unit-costs]
// Of each part of a step, whatever is in it.
inline constexpr double part = 600;    ///< its bookkeeping
inline constexpr double placed = 400;  ///< the same where nothing may meet anything

// Of each body that moves, in each part.
inline constexpr double motion = 140;            ///< its place from its velocities
inline constexpr double gravity = 25;            ///< the term g t; as much once for the stage
inline constexpr double turn_at_rest = 440;      ///< to turn by a spin of 0
inline constexpr double turn = 820;              ///< to turn by another: a sine and a cosine
inline constexpr double gyroscopic_look = 3600;  ///< a part of a turn with the gyroscopic term
inline constexpr double gyroscopic_round = 100;  ///< to see that one does not need it
inline constexpr double sleep = 430;             ///< to ask whether it is slow, and who touches it
inline constexpr double sleep_stage = 250;       ///< the stage itself
inline constexpr double bounce_stages = 55;      ///< two stages that find nothing has bounced
inline constexpr double spring_stage = 40;       ///< a stage that finds nothing gives way
inline constexpr double coordinate = 40;         ///< a coordinate more of its place and velocity

// The search for pairs that are near, in each part.
inline constexpr double swept_box = 1600;   ///< the box about a body's way
inline constexpr double box_test = 40;      ///< to compare two boxes
inline constexpr double grid = 4000;        ///< to lay a grid and sort into it nothing
inline constexpr double grid_sorting = 90;  ///< of each entry in a cell, for each step of sorting

// Of each pair that is near, in each part: gap and points of contact, and when it comes to touch.
inline constexpr double round_gap = 2200;       ///< of a ball and anything
inline constexpr double floor_gap = 7500;       ///< of a body with corners and a half-space
inline constexpr double corner_gap = 25000;     ///< of two bodies with corners
inline constexpr double round_impact = 3400;    ///< of two of which one is a ball
inline constexpr double corner_impact = 21000;  ///< of others
inline constexpr double looking = 100;          ///< to look for impacts where there are none
inline constexpr double wide_gap = 390;  ///< points that may come to touch, of a pair that does

// Of each point of contact, in each part.
inline constexpr double contact = 9600;            ///< all impulses there, in some sweeps
inline constexpr double pressed = 2000;            ///< more of these where gravity presses
inline constexpr double friction = 2500;           ///< and two more along the surface
inline constexpr double turned_contact = 700;      ///< what spins change there
inline constexpr double idle_turned_contact = 60;  ///< what spins change where nothing turns
inline constexpr double contact_coordinate = 31;   ///< a coordinate more of its bodies
inline constexpr double finish = 40;   ///< to ask whether what sweeps have left is to be finished
inline constexpr double spring = 950;  ///< its push, where it gives way

// From event to event.
inline constexpr double hit = 1000;       ///< two new velocities, two places in the queue
inline constexpr double asked = 80;       ///< when a ball meets another one, or a wall
inline constexpr double crossing = 1500;  ///< a ball goes from cell to cell, and asks who is there
inline constexpr double asked_in_gravity = 1.0 / 3;     ///< more of it, where paths bend
inline constexpr double crossing_in_gravity = 0.15;     ///< the same of a crossing
inline constexpr double asked_in_coordinate = 1.0 / 4;  ///< more of it, a coordinate more
/// So many balls ask everybody after a hit at less cost than they go from cell to cell: by counts,
/// 15 where a fifth of the room is full, 35 where a fiftieth is.
inline constexpr std::size_t most_asked_by_all = 24;
// [/unit-costs]

}  // namespace contact::cost
