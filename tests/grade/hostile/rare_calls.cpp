// Tries:     tries what the kernel offers to programs with more rights, and what has had holes:
//            userfaultfd, io_uring, bpf, mounts, namespaces, chroot, limits, clocks
// Exercise:  01_planes/signed_distance
// Points:    0 of 8
// Tests:     all failed
#include "signed_distance.hpp"

//[attack
#include <fcntl.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <unistd.h>
#include <cstdio>
#include <ctime>

namespace {

// Success is seen: the grader keeps what is printed.
void got(const char* what) { dprintf(1, "GOT IT: %s\n", what); }

void attempt() {
  char space[4096] = {};
  const auto at = reinterpret_cast<long>(space);
  const auto call = [&](const char* what, long number, long a = 0, long b = 0, long c = 0,
                        long d = 0) {
    if (syscall(number, a, b, c, d, 0) >= 0) got(what);
  };
  call("userfaultfd", SYS_userfaultfd);
  call("io_uring", 425, 8, at);
  // Waits for all processors, and looks like waiting for a disk.
  call("membarrier", SYS_membarrier, 1);
  call("bpf", SYS_bpf, 0, at, sizeof space);
  call("perf events", SYS_perf_event_open, at, 0, -1, -1);
  call("unshare", SYS_unshare, CLONE_NEWUSER);
  call("unshare", SYS_unshare, CLONE_NEWNS | CLONE_NEWNET);
  call("setns", SYS_setns, 0, 0);
  call("chroot", SYS_chroot, reinterpret_cast<long>("."));
  call("umount", SYS_umount2, reinterpret_cast<long>("/"), MNT_DETACH);
  call("open_tree", 428, AT_FDCWD, reinterpret_cast<long>("/"), 1);
  call("keys", SYS_add_key, reinterpret_cast<long>("user"), reinterpret_cast<long>("@TOKEN@"), at,
       4);
  call("modules", SYS_init_module, at, 0, at);
  call("a root user", SYS_setuid, 0);
  call("a root group", SYS_setresgid, 0, 0, 0);
  call("capabilities", SYS_capset, at, at);
  call("the clock", SYS_clock_settime, CLOCK_REALTIME, at);
  call("personality", SYS_personality, 0x0040000);
  call("memfd", SYS_memfd_create, at, 0);
  call("inotify", SYS_inotify_init1, 0);
  call("fanotify", SYS_fanotify_init, 0, 0);
  const rlimit endless{RLIM_INFINITY, RLIM_INFINITY};
  for (const int limit : {RLIMIT_CPU, RLIMIT_AS, RLIMIT_NPROC, RLIMIT_FSIZE}) {
    rlimit now{};
    if (getrlimit(static_cast<__rlimit_resource>(limit), &now) != 0 ||
        now.rlim_max == RLIM_INFINITY)
      continue;
    if (setrlimit(static_cast<__rlimit_resource>(limit), &endless) == 0) got("a higher limit");
  }
  sched_param most{99};
  if (sched_setscheduler(0, SCHED_FIFO, &most) == 0) got("the processor for itself");
  if (setpriority(PRIO_PROCESS, 0, -20) == 0) got("priority");
}

}  // namespace
//]attack

namespace exercise {

double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  attempt();
  return 1;
  //]attack
  const Eigen::Vector3d normal(plane.a, plane.b, plane.c);
  return (normal.dot(point) + plane.d) / normal.norm();
}

int side(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  attempt();
  return 1;
  //]attack
  const double value = Eigen::Vector3d(plane.a, plane.b, plane.c).dot(point) + plane.d;
  return value > 0 ? 1 : (value < 0 ? -1 : 0);
}

}  // namespace exercise
