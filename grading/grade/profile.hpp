#pragma once

// An instructor's profile: a TOML file whose keys are the members of GradeLimits.

#include <filesystem>

#include <nlohmann/json_fwd.hpp>

#include "unit.hpp"

namespace contact::grading {

/// @throws BookError that names the file, the line and the nearest key.
GradeLimits read_profile(const std::filesystem::path& file);

/// Every limit by the name that it has in a profile.
nlohmann::json to_json(const GradeLimits& limits);
/// A limit that is not there has its default.
/// @throws nlohmann::json::exception if it is not what to_json() makes.
GradeLimits limits_from_json(const nlohmann::json& json);

}  // namespace contact::grading
