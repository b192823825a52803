// Tries:     makes the compiler calculate without end
// Exercise:  01_planes/signed_distance
// Points:    0 of 8
// Tests:     does not compile
#include "signed_distance.hpp"

//[attack
constexpr long turn(long n) {
  long sum = 0;
  for (long i = 0; i < 200000; ++i) sum += i ^ n;
  return sum;
}
template <long... N>
constexpr long all(std::integer_sequence<long, N...>) {
  constexpr long sums[] = {std::integral_constant<long, turn(N)>::value...};
  return sums[0];
}
static_assert(all(std::make_integer_sequence<long, 100000>{}) != 1);
//]attack

namespace exercise {

double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  const Eigen::Vector3d normal(plane.a, plane.b, plane.c);
  return (normal.dot(point) + plane.d) / normal.norm();
}

int side(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  const double value = Eigen::Vector3d(plane.a, plane.b, plane.c).dot(point) + plane.d;
  return value > 0 ? 1 : (value < 0 ? -1 : 0);
}

}  // namespace exercise
