/// @file
/// The cost of one of each thing in a run: the unit costs of a plan's estimates.
///
/// The unit is an instruction of this book's own code, compiled by g++ for x86-64 at -O2. Each was
/// counted with valgrind: benchmarks/scene_stages.py prints the counts of its stage and of whole
/// runs beside the estimates, and fails if they differ by more than a factor. They only decide
/// whether a broad phase pays.
#pragma once

#include <cstddef>

namespace contact::cost {

// [unit-costs]
// Of each substep, whatever is in it.
inline constexpr double substep = 600;  ///< its bookkeeping
inline constexpr double placed = 400;   ///< the same where nothing may meet

// Of each body that moves, in each substep.
inline constexpr double motion = 140;               ///< its position from its velocities
inline constexpr double gravity = 25;               ///< the term g t; as much once for the stage
inline constexpr double rotation_at_rest = 440;     ///< to rotate by an angular velocity of 0
inline constexpr double rotation = 820;             ///< to rotate by another: a sine and a cosine
inline constexpr double gyroscopic_substep = 3600;  ///< a substep with the gyroscopic term
inline constexpr double gyroscopic_check = 100;     ///< to find that a body does not need it
inline constexpr double sleep = 430;                ///< to test its speed, and what touches it
inline constexpr double sleep_stage = 250;          ///< the stage itself
inline constexpr double bounce_stages = 55;         ///< two stages, if nothing has bounced
inline constexpr double spring_stage = 40;          ///< the stage, if no contact is compliant
inline constexpr double coordinate = 40;            ///< one more coordinate of its state

// The search for near pairs, in each substep.
inline constexpr double swept_box = 1600;   ///< the bounding box of a body's path
inline constexpr double box_test = 40;      ///< to compare two boxes
inline constexpr double grid = 4000;        ///< to set up an empty grid
inline constexpr double grid_sorting = 90;  ///< of each entry in a cell, for each step of sorting

// Of each near pair, in each substep: distance, contact points, and when it comes to touch.
inline constexpr double sphere_gap = 2200;      ///< of a ball and anything
inline constexpr double half_space_gap = 7500;  ///< of a body with vertices and a half-space
inline constexpr double corner_gap = 25000;     ///< of two bodies with vertices
inline constexpr double sphere_impact = 3400;   ///< of two of which one is a ball
inline constexpr double corner_impact = 21000;  ///< of others
inline constexpr double impact_search = 100;    ///< to search for impacts where there are none
inline constexpr double wide_gap = 390;  ///< points that may come to touch, of a touching pair

// Of each contact point, in each substep.
inline constexpr double contact = 9600;              ///< all impulses there, in some iterations
inline constexpr double pressed = 2000;              ///< more of these where gravity presses
inline constexpr double friction = 2500;             ///< and two tangential ones
inline constexpr double rotating_contact = 700;      ///< the changes of angular velocities
inline constexpr double idle_rotating_contact = 60;  ///< the same where nothing rotates
inline constexpr double contact_coordinate = 31;     ///< one more coordinate of its bodies
inline constexpr double exact_solve = 40;            ///< to test whether an exact solve is needed
inline constexpr double spring = 950;                ///< its force, if it is compliant

// From event to event.
inline constexpr double hit = 1000;       ///< two new velocities, two updates of the queue
inline constexpr double prediction = 80;  ///< when a ball meets another one, or a wall
inline constexpr double crossing = 1500;  ///< a ball changes cells, and tests its neighbours
inline constexpr double prediction_in_gravity = 1.0 / 3;  ///< more of it, on parabolas
inline constexpr double crossing_in_gravity = 0.15;       ///< the same of a crossing
inline constexpr double prediction_in_coordinate =
    1.0 / 4;  ///< more of it, for each further coordinate
/// Up to so many balls, testing all others after a hit costs less than cells: by counts, 15 where a
/// fifth of the room is full, 35 where a fiftieth is.
inline constexpr std::size_t max_balls_without_cells = 24;
// [/unit-costs]

}  // namespace contact::cost
