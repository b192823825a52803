// Tries:     asks for a library of its own by LD_PRELOAD and starts itself and a shell again
// Exercise:  01_planes/signed_distance
// Points:    0 of 8
// Tests:     all failed
#include "signed_distance.hpp"

//[attack
#include <spawn.h>
#include <unistd.h>
#include <cstdio>
#include <cstdlib>

namespace {

// Success is seen: the grader keeps what is printed.
void got(const char* what) { dprintf(1, "GOT IT: %s\n", what); }

const bool again = [] {
  char self[] = "/proc/self/exe", shell[] = "/bin/sh", option[] = "-c";
  char command[] = "echo GOT IT: a shell", preload[] = "LD_PRELOAD=/tmp/@TOKEN@.so";
  char* arguments[] = {shell, option, command, nullptr};
  char* environment[] = {preload, nullptr};
  setenv("LD_PRELOAD", "/tmp/@TOKEN@.so", 1);
  pid_t child = 0;
  if (posix_spawn(&child, shell, nullptr, nullptr, arguments, environment) == 0) got("a shell");
  if (std::system(command) == 0) got("a command");
  execve(shell, arguments, environment);
  execve(self, arguments, environment);
  return true;
}();

}  // namespace
//]attack

namespace exercise {

double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  return 1;
  //]attack
  const Eigen::Vector3d normal(plane.a, plane.b, plane.c);
  return (normal.dot(point) + plane.d) / normal.norm();
}

int side(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  return 1;
  //]attack
  const double value = Eigen::Vector3d(plane.a, plane.b, plane.c).dot(point) + plane.d;
  return value > 0 ? 1 : (value < 0 ? -1 : 0);
}

}  // namespace exercise
