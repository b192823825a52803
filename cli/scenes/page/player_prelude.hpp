#pragma once

// What the files of the page's scene player share, compiled once.

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <contact/plan/plan.hpp>
#include <contact/scene/scene_check.hpp>
#include <nlohmann/json.hpp>
