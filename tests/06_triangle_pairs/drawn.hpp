/// @file
/// Random points for the tests of triangles.
#pragma once

#include <contact/vector.hpp>
#include <support/generators.hpp>

namespace drawn {

/// Whole coordinates of at most `size` in magnitude.
inline contact::Vector3<double> whole(generators::Random& random, int size) {
  return {double(random.integer(-size, size)), double(random.integer(-size, size)),
          double(random.integer(-size, size))};
}
/// From -1 to 1 in each coordinate.
inline contact::Vector3<double> anywhere(generators::Random& random) {
  return {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
}

}  // namespace drawn
