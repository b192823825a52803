// misconception: break-differences-are-exact
// caught by: a line is accepted
// seen: https://github.com/dimforge/parry/issues/99
//   with shorter coordinates the reporter's test does not fail
#include "break_the_epsilon.hpp"

namespace exercise {

Points plane_refused() { return {{0, 0, 0}, {1, 0, 0}, {2, 1e-7, 0}}; }

Points small_triangle_refused() { return {{0, 0, 0}, {0.0005, 0, 0}, {0, 0.0005, 0}}; }

Points line_accepted() { return {{1, 2, 3}, {1000001, 2000002, 3000003}, {-5, -10, -15}}; }

}  // namespace exercise
