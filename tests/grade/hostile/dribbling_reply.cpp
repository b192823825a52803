// Tries:     sends the beginning of a long answer, a byte now and then, so that something always
//            arrives
// Exercise:  01_planes/signed_distance
// Points:    0 of 8
// Tests:     all stopped
#include "signed_distance.hpp"

//[attack
#include <sys/socket.h>
#include <unistd.h>
#include <cstring>
#include <ctime>

namespace {

struct Frame {
  std::uint32_t magic, kind;
  std::uint64_t fingerprint, sequence, length;
};

// The request that is being answered is not known here; its fingerprint is in our own program, so
// that an attacker has it. Sequence 1 is the first call.
void dribble() {
  const Frame frame{0x31544e43, 0, 0xd85d6d47dfefa4db, 1, 1 << 20};
  send(3, &frame, sizeof frame, MSG_NOSIGNAL);
  for (const timespec nap{0, 50'000'000};; nanosleep(&nap, nullptr)) {
    if (send(3, "x", 1, MSG_NOSIGNAL) < 0) sleep(1000);
  }
}

}  // namespace
//]attack

namespace exercise {

double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  dribble();
  //]attack
  const Eigen::Vector3d normal(plane.a, plane.b, plane.c);
  return (normal.dot(point) + plane.d) / normal.norm();
}

int side(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  dribble();
  //]attack
  const double value = Eigen::Vector3d(plane.a, plane.b, plane.c).dot(point) + plane.d;
  return value > 0 ? 1 : (value < 0 ? -1 : 0);
}

}  // namespace exercise
