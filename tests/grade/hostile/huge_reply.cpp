// Tries:     announces an answer of 2^60 bytes and another of 15 MB that it never sends
// Exercise:  01_planes/signed_distance
// Points:    1 of 8
// Tests:     1-4 stopped, 5 passed, 6 stopped
// Says:      more than is allowed | waited for 1 second in all and did nothing
// Seconds:   10
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

// The request is on the caller's stack; a reply must repeat its number.
std::uint64_t number_of_the_request() {
  Frame frame;
  const auto* at = reinterpret_cast<const char*>(__builtin_frame_address(0));
  for (int i = 0; i < 4096; i += 8) {
    std::memcpy(&frame, at + i, sizeof frame);
    if (frame.magic == 0x31544e43 && frame.fingerprint == 0xd85d6d47dfefa4db) break;
  }
  return frame.sequence;
}

void announce(std::uint64_t length) {
  Frame frame;
  frame.sequence = number_of_the_request();
  frame.length = length;
  if (write(3, &frame, sizeof frame) < 0) return;
  sleep(1000);
}

}  // namespace
//]attack

namespace exercise {

double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  announce(std::uint64_t{1} << 60);
  //]attack
  const Eigen::Vector3d normal(plane.a, plane.b, plane.c);
  return (normal.dot(point) + plane.d) / normal.norm();
}

int side(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  if (plane.d == 14) announce(15 << 20);
  //]attack
  const double value = Eigen::Vector3d(plane.a, plane.b, plane.c).dot(point) + plane.d;
  return value > 0 ? 1 : (value < 0 ? -1 : 0);
}

}  // namespace exercise
