// Tries:     connects to sockets of this machine: abstract ones, which no file system hides, and
//            named ones
// Exercise:  01_planes/signed_distance
// Points:    0 of 8
// Tests:     all failed
#include "signed_distance.hpp"

//[attack
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <string>

namespace {

// Success is seen: the grader keeps what is printed.
void got(const char* what) { dprintf(1, "GOT IT: %s\n", what); }

void connect_to(const std::string& name) {
  const int socket_ = socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un there{};
  there.sun_family = AF_UNIX;
  name.copy(there.sun_path, sizeof there.sun_path - 1);
  const auto length = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + name.size());
  if (connect(socket_, reinterpret_cast<sockaddr*>(&there), length) == 0) got("connected");
  // Also without a connection of its own: the socket that it was given.
  if (sendto(3, "", 0, MSG_NOSIGNAL, reinterpret_cast<sockaddr*>(&there), length) > 0) got("sent");
}

void call() {
  connect_to(std::string("\0@TOKEN@", 1 + sizeof "@TOKEN@" - 1));
  connect_to("@UNIX_SOCKET@");
  for (const char* path :
       {"/run/dbus/system_bus_socket", "/var/run/docker.sock", "/run/munge/munge.socket.2"})
    connect_to(path);
}

}  // namespace
//]attack

namespace exercise {

double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  call();
  return 1;
  //]attack
  const Eigen::Vector3d normal(plane.a, plane.b, plane.c);
  return (normal.dot(point) + plane.d) / normal.norm();
}

int side(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  call();
  return 1;
  //]attack
  const double value = Eigen::Vector3d(plane.a, plane.b, plane.c).dot(point) + plane.d;
  return value > 0 ? 1 : (value < 0 ? -1 : 0);
}

}  // namespace exercise
