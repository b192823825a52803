// Tries:     makes the compiler find a hundred thousand mistakes
// Exercise:  01_planes/signed_distance
// Points:    0 of 8
// Tests:     does not compile
#include "signed_distance.hpp"

//[attack
#define TEN(x) \
  x##0;        \
  x##1;        \
  x##2;        \
  x##3;        \
  x##4;        \
  x##5;        \
  x##6;        \
  x##7;        \
  x##8;        \
  x##9;
#define HUNDRED(x) \
  TEN(x##0)        \
  TEN(x##1) TEN(x##2) TEN(x##3) TEN(x##4) TEN(x##5) TEN(x##6) TEN(x##7) TEN(x##8) TEN(x##9)
#define ALL(x) HUNDRED(x##0) HUNDRED(x##1) HUNDRED(x##2) HUNDRED(x##3) HUNDRED(x##4) HUNDRED(x##5)
#define MORE(x) ALL(x##0) ALL(x##1) ALL(x##2) ALL(x##3) ALL(x##4) ALL(x##5) ALL(x##6) ALL(x##7)
void mistakes() { MORE(a) MORE(b) MORE(c) MORE(d) MORE(e) MORE(f) MORE(g) MORE(h) }
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
