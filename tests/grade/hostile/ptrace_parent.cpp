// Tries:     attaches to its parent and to every other process, reads and writes their memory
//            and takes their descriptors, to find the tests there
// Exercise:  01_planes/signed_distance
// Points:    0 of 8
// Tests:     all failed
#include "signed_distance.hpp"

//[attack
#include <fcntl.h>
#include <sys/ptrace.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>
#include <cstdio>
#include <string>

namespace {

// Success is seen: the grader keeps what is printed.
void got(const char* what) { dprintf(1, "GOT IT: %s\n", what); }

void look_into(pid_t other) {
  char bytes[4096];
  iovec here{bytes, sizeof bytes}, there{reinterpret_cast<void*>(0x400000), sizeof bytes};
  if (ptrace(PTRACE_ATTACH, other, nullptr, nullptr) == 0) got("attached");
  if (ptrace(PTRACE_SEIZE, other, nullptr, nullptr) == 0) got("seized");
  if (process_vm_readv(other, &here, 1, &there, 1, 0) > 0) got("memory read");
  if (process_vm_writev(other, &here, 1, &there, 1, 0) > 0) got("memory written");
  if (open(("/proc/" + std::to_string(other) + "/mem").c_str(), O_RDWR) >= 0) got("memory opened");
  const long process = syscall(SYS_pidfd_open, other, 0);
  for (int i = 0; process >= 0 && i < 64; ++i) {
    if (syscall(SYS_pidfd_getfd, process, i, 0) >= 0) got("a descriptor");
  }
}

}  // namespace
//]attack

namespace exercise {

double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  look_into(getppid());
  for (pid_t other = 1; other < 3000; ++other) {
    if (other != getpid()) look_into(other);
  }
  return 1;
  //]attack
  const Eigen::Vector3d normal(plane.a, plane.b, plane.c);
  return (normal.dot(point) + plane.d) / normal.norm();
}

int side(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  look_into(getppid());
  return 1;
  //]attack
  const double value = Eigen::Vector3d(plane.a, plane.b, plane.c).dot(point) + plane.d;
  return value > 0 ? 1 : (value < 0 ? -1 : 0);
}

}  // namespace exercise
