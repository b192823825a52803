// What nearly every test includes; compiled once.
#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <boost/multiprecision/gmp.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>
