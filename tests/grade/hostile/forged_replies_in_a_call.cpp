// Tries:     answers the call itself and the calls to come by its own frames, then returns
// Exercise:  01_planes/signed_distance
// Points:    0 of 8
// Tests:     all stopped or failed
#include "signed_distance.hpp"

//[attack
#include <unistd.h>

namespace {

struct Frame {
  std::uint32_t magic = 0x31544e43, kind = 0;
  // Of signed_distance; it is in this program, so an attacker has it.
  std::uint64_t fingerprint = 0xd85d6d47dfefa4db, sequence = 1, length = 8;
  double value = 1.0;
};

void answer_ahead() {
  for (std::uint64_t call = 1; call <= 100; ++call) {
    Frame frame;
    frame.sequence = call;
    if (write(3, &frame, sizeof frame) < 0) return;
  }
}

}  // namespace
//]attack

namespace exercise {

double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  answer_ahead();
  return 1;
  //]attack
  const Eigen::Vector3d normal(plane.a, plane.b, plane.c);
  return (normal.dot(point) + plane.d) / normal.norm();
}

int side(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  answer_ahead();
  return 1;
  //]attack
  const double value = Eigen::Vector3d(plane.a, plane.b, plane.c).dot(point) + plane.d;
  return value > 0 ? 1 : (value < 0 ? -1 : 0);
}

}  // namespace exercise
