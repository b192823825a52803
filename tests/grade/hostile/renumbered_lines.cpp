// Tries:     gives each message a line of two thousand million, which costs time to look for
// Exercise:  01_planes/signed_distance
// Points:    0 of 8
// Tests:     does not compile
// Says:      not declared
#include "signed_distance.hpp"

//[attack
#line 2147483000
int a0 = nobody_declared_0;
int a1 = nobody_declared_1;
int a2 = nobody_declared_2;
int a3 = nobody_declared_3;
int a4 = nobody_declared_4;
int a5 = nobody_declared_5;
int a6 = nobody_declared_6;
int a7 = nobody_declared_7;
int a8 = nobody_declared_8;
int a9 = nobody_declared_9;
int a10 = nobody_declared_10;
int a11 = nobody_declared_11;
int a12 = nobody_declared_12;
int a13 = nobody_declared_13;
int a14 = nobody_declared_14;
int a15 = nobody_declared_15;
int a16 = nobody_declared_16;
int a17 = nobody_declared_17;
int a18 = nobody_declared_18;
int a19 = nobody_declared_19;
int a20 = nobody_declared_20;
int a21 = nobody_declared_21;
int a22 = nobody_declared_22;
int a23 = nobody_declared_23;
int a24 = nobody_declared_24;
int a25 = nobody_declared_25;
int a26 = nobody_declared_26;
int a27 = nobody_declared_27;
int a28 = nobody_declared_28;
int a29 = nobody_declared_29;
int a30 = nobody_declared_30;
int a31 = nobody_declared_31;
int a32 = nobody_declared_32;
int a33 = nobody_declared_33;
int a34 = nobody_declared_34;
int a35 = nobody_declared_35;
int a36 = nobody_declared_36;
int a37 = nobody_declared_37;
int a38 = nobody_declared_38;
int a39 = nobody_declared_39;
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
