#include "break_the_horizon.hpp"

namespace exercise {

// The line of flight passes the centre of the post (0, 0) at 0.4 m − 1e-11 m, so that it is hit at
// a cosine of 7e-6. The next post is half a metre away.
Start apart_by_hit_7() {
  const double side = (0.4 - 1e-11) / std::sqrt(2.0);
  return {{side - 0.2, side + 0.2}, {1, -1}};
}

// Head on between the posts (0, 0) and (2, 1), which are 1.436 m apart. The line between them
// passes the posts beside it at 0.447 m.
Start without_oblique_hits() { return {{1, 0.5}, {2, 1}}; }

// Head on between the posts (0, 0) and (1, 1), which are 0.614 m apart. After the first hits the
// factor is 1 + x + √(x² + 2x) = 4.86, with x = 0.614/0.4. The code's is 4.11.
Start without_long_flights() { return {{0.5, 0.5}, {1, 1}}; }

}  // namespace exercise
