// Tries:     leaves a process in the background that has a session of its own, ignores signals
//            and goes on writing and calling; answers rightly
// Exercise:  01_planes/signed_distance
// Points:    8 of 8
// Tests:     all passed
#include "signed_distance.hpp"

//[attack
#include <fcntl.h>
#include <sched.h>
#include <unistd.h>
#include <csignal>
#include <cstdio>

namespace {

// Success is seen: the grader keeps what is printed.
void got(const char* what) { dprintf(1, "GOT IT: %s\n", what); }

void leave() {
  if (const pid_t child = fork(); child != 0) {
    if (child > 0) got("a process");
    return;
  }
  setsid();
  if (fork() != 0) _exit(0);
  for (int number = 1; number < 65; ++number) std::signal(number, SIG_IGN);
  for (;;) {
    const int file = open("/tmp/@TOKEN@-leftover", O_CREAT | O_WRONLY, 0666);
    if (file >= 0) close(file);
    if (write(3, "passed", 6) < 0) usleep(1000);
  }
}

}  // namespace
//]attack

namespace exercise {

double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  [[maybe_unused]] static const bool once = (leave(), true);
  //]attack
  const Eigen::Vector3d normal(plane.a, plane.b, plane.c);
  return (normal.dot(point) + plane.d) / normal.norm();
}

int side(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  leave();
  //]attack
  const double value = Eigen::Vector3d(plane.a, plane.b, plane.c).dot(point) + plane.d;
  return value > 0 ? 1 : (value < 0 ? -1 : 0);
}

}  // namespace exercise
