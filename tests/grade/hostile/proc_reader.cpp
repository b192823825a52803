// Tries:     reads command lines, environments and open files of all processes, its own included
// Exercise:  01_planes/signed_distance
// Points:    0 of 8
// Tests:     all failed
#include "signed_distance.hpp"

//[attack
#include <dirent.h>
#include <fcntl.h>
#include <unistd.h>
#include <cstdio>
#include <string>

namespace {

// Success is seen: the grader keeps what is printed.
void got(const char* what) { dprintf(1, "GOT IT: %s\n", what); }

void look(const std::string& process) {
  char bytes[256];
  for (const char* file :
       {"cmdline", "environ", "maps", "status", "mountinfo", "cgroup", "stack"}) {
    const int opened = open(("/proc/" + process + "/" + file).c_str(), O_RDONLY);
    if (opened >= 0 && read(opened, bytes, sizeof bytes) > 0)
      got(("/proc/" + process + "/" + file).c_str());
  }
  for (const char* link : {"exe", "cwd", "root", "fd/0", "fd/1", "fd/3"}) {
    const int opened = open(("/proc/" + process + "/" + link).c_str(), O_RDONLY);
    if (opened >= 0) got(("/proc/" + process + "/" + link).c_str());
  }
}

}  // namespace
//]attack

namespace exercise {

double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  if (opendir("/proc") != nullptr) got("/proc");
  look("self");
  for (int other = 1; other < 2000; ++other) look(std::to_string(other));
  return 1;
  //]attack
  const Eigen::Vector3d normal(plane.a, plane.b, plane.c);
  return (normal.dot(point) + plane.d) / normal.norm();
}

int side(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  look("self");
  look("1");
  return 1;
  //]attack
  const double value = Eigen::Vector3d(plane.a, plane.b, plane.c).dot(point) + plane.d;
  return value > 0 ? 1 : (value < 0 ? -1 : 0);
}

}  // namespace exercise
