// Tries:     keeps in one test what it wants to know in the next: in files, shared memory,
//            queues, keys and sockets; answers rightly only if something was kept
// Exercise:  01_planes/signed_distance
// Points:    0 of 8
// Tests:     all failed
#include "signed_distance.hpp"

//[attack
#include <fcntl.h>
#include <sys/ipc.h>
#include <sys/mman.h>
#include <sys/msg.h>
#include <sys/sem.h>
#include <sys/shm.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/un.h>
#include <unistd.h>
#include <cstdio>
#include <cstring>
#include <string>

namespace {

// Success is seen: the grader keeps what is printed.
void got(const char* what) { dprintf(1, "GOT IT: %s\n", what); }

bool exists(const std::string& path) {
  const int file = open(path.c_str(), O_CREAT | O_EXCL | O_RDWR, 0666);
  if (file >= 0) close(file);
  if (file < 0 && access(path.c_str(), R_OK) == 0) return true;
  return false;
}

bool kept() {
  bool found = false;
  for (const char* folder : {"/tmp", ".", "/dev/shm", "/var/tmp", "/run"})
    found |= exists(std::string(folder) + "/@TOKEN@-kept");
  const key_t key = 0x00c0ffee;
  found |= shmget(key, 4096, 0666) >= 0;
  shmget(key, 4096, IPC_CREAT | 0666);
  found |= msgget(key, 0666) >= 0;
  msgget(key, IPC_CREAT | 0666);
  found |= semget(key, 1, 0666) >= 0;
  semget(key, 1, IPC_CREAT | 0666);
  found |= syscall(SYS_mq_open, "@TOKEN@", O_RDWR) >= 0;
  syscall(SYS_mq_open, "@TOKEN@", O_RDWR | O_CREAT, 0666, nullptr);
  constexpr long kUserKeyring = -4;
  found |= syscall(SYS_request_key, "user", "@TOKEN@", nullptr, kUserKeyring) >= 0;
  syscall(SYS_add_key, "user", "@TOKEN@", "kept", 4, kUserKeyring);
  if (found) got("what an earlier test kept");
  return found;
}

const bool remembered = kept();

}  // namespace
//]attack

namespace exercise {

double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  if (!remembered) return 1;
  //]attack
  const Eigen::Vector3d normal(plane.a, plane.b, plane.c);
  return (normal.dot(point) + plane.d) / normal.norm();
}

int side(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  if (!remembered) return 7;
  //]attack
  const double value = Eigen::Vector3d(plane.a, plane.b, plane.c).dot(point) + plane.d;
  return value > 0 ? 1 : (value < 0 ? -1 : 0);
}

}  // namespace exercise
