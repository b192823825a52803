/// @file
/// The parts of a condition's sentence that the table of a plan uses too.
#pragma once

#include <array>
#include <string>

#include <contact/plan/plan_types.hpp>

namespace contact::scenes::detail {

/// A number with its unit; without one if it is not finite.
std::string with_unit(double x, const std::string& unit);

/// Both sides of a condition with their unit: with all digits where four do not tell them apart.
std::array<std::string, 2> sides_of(const Inequality& condition);

/// The relation that holds between the sides, between spaces: of a condition that fails, the
/// opposite one.
const char* sign_of_sides(const Inequality& condition);

}  // namespace contact::scenes::detail
