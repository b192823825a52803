/// @file
/// Exercise: how stiff a contact must be, and which step it then needs.
///
/// A body falls from rest onto a surface. Its lowest point is at the given height above the surface
/// at first; for a height of 0 it touches. The contact is a spring without a damper: it pushes with
/// the force k d while the body overlaps by d. Gravity acts all the time, also during the contact.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// The stiffness k with which the greatest overlap is the given one, in N/m.
///
/// @param mass kg, greater than 0
/// @param height m, 0 or more
/// @param gravity m/s², greater than 0
/// @param overlap greatest overlap, m, greater than 0
double stiffness_for_overlap(double mass, double height, double gravity, double overlap);

/// The step, in s, of which the first contact takes the given number: it lasts as long as so many
/// steps together. The contact begins when the body touches the surface and ends when it no longer
/// overlaps.
///
/// @param mass, height, gravity as above
/// @param stiffness k, N/m, greater than 0
/// @param steps 1 or more
double step_for_contact(double mass, double height, double gravity, double stiffness, int steps);

}  // namespace exercise
