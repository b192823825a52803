// misconception: break-outside-the-region
// caught by: a line is accepted
// seen: https://github.com/JuliaGeometry/GeometricalPredicates.jl/issues/12
//   takes a point beside a line for one on it
#include "break_the_epsilon.hpp"

namespace exercise {

Points plane_refused() { return {{0, 0, 0}, {1, 0, 0}, {2, 1e-7, 0}}; }

Points small_triangle_refused() { return {{0, 0, 0}, {0.0005, 0, 0}, {0, 0.0005, 0}}; }

Points line_accepted() { return {{0, 0, 0}, {0.1, 0.2, 0.3}, {100000, 200000, 300000.001}}; }

}  // namespace exercise
