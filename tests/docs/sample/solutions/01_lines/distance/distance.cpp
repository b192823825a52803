#include "distance.hpp"

namespace exercise {

double distance(double a, double b, double c, double x, double y) {
  return std::abs(a * x + b * y - c) / std::hypot(a, b);
}

}  // namespace exercise
