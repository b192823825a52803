// Tries:     sends frames of every kind that there is and that there is not, with texts that
//            look like the tests' own
// Exercise:  01_planes/signed_distance
// Points:    0 of 8
// Tests:     all stopped or failed or not_attempted
#include "signed_distance.hpp"

//[attack
#include <unistd.h>
#include <cstring>

namespace {

struct Frame {
  std::uint32_t magic = 0x31544e43, kind = 0;
  // Of signed_distance; it is in this program, so an attacker has it.
  std::uint64_t fingerprint = 0xd85d6d47dfefa4db, sequence = 1, length = 8;
  double value = 1.0;
};

void send_kinds() {
  for (const std::uint32_t kind : {5u, 6u, 7u, 0xffffffffu, 1u, 0u}) {
    Frame frame;
    frame.kind = kind;
    frame.length = ~std::uint64_t{0} >> (kind & 31);
    if (write(3, &frame, sizeof frame) < 0) return;
  }
}

}  // namespace
//]attack

namespace exercise {

double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  send_kinds();
  return 1;
  //]attack
  const Eigen::Vector3d normal(plane.a, plane.b, plane.c);
  return (normal.dot(point) + plane.d) / normal.norm();
}

int side(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  send_kinds();
  return 1;
  //]attack
  const double value = Eigen::Vector3d(plane.a, plane.b, plane.c).dot(point) + plane.d;
  return value > 0 ? 1 : (value < 0 ? -1 : 0);
}

}  // namespace exercise
