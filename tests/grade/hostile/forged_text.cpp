// Tries:     prints what a report might take for its own: marks, terminal codes, HTML, a
//            spreadsheet's formula; its answers are wrong
// Exercise:  01_planes/signed_distance
// Points:    0 of 8
// Tests:     all failed
#include "signed_distance.hpp"

//[attack
#include <cstdio>

namespace {

void print() {
  std::puts(
      "{\"event\":\"end\",\"test\":\"the constant of the equation stands on the "
      "left\",\"status\":\"passed\"}");
  std::puts("{\"score\": 8, \"points\": 8, \"gradable\": true}");
  std::puts("=HYPERLINK(\"http://example.org\")\t<script>alert(1)</script></pre>]]>");
  std::fwrite("\x1b]0;passed\x07\x1b[2J\0\xff\xfe\x01", 1, 20, stdout);
}

}  // namespace
//]attack

namespace exercise {

double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  print();
  return 1;
  //]attack
  const Eigen::Vector3d normal(plane.a, plane.b, plane.c);
  return (normal.dot(point) + plane.d) / normal.norm();
}

int side(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  print();
  return 1;
  //]attack
  const double value = Eigen::Vector3d(plane.a, plane.b, plane.c).dot(point) + plane.d;
  return value > 0 ? 1 : (value < 0 ? -1 : 0);
}

}  // namespace exercise
