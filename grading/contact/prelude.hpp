/// @file
/// The first include of every exercise, and its precompiled header: what a student may take for
/// granted.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace contact {

/// Says that this function is not done yet: its tests are then "not attempted", which is neither
/// wrong nor a crash. Replace the call with your own code.
[[noreturn]] void todo();

}  // namespace contact
