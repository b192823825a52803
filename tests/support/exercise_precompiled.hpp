// What the tests of exercises include; compiled once.
#pragma once
#include <catch2/catch_test_macros.hpp>

#include <contact/exact.hpp>
#include <contact/prelude.hpp>
#include <contact/shapes.hpp>
#include <support/exercise.hpp>
#include <support/generators.hpp>
