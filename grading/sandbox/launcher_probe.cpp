// What contact-box tries from inside a box, to find out what a box is kept from here. Each probe is
// an honest attempt: it fails only if something stops it.

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <string>

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/mount.h>
#include <sys/ptrace.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "launcher.hpp"

namespace contact::launcher {

namespace {

constexpr std::size_t mebibyte = 1u << 20;

int number(const char* text) { return static_cast<int>(std::strtol(text, nullptr, 10)); }

// A connection to a port on which a process outside listens.
bool reaches_network(const char* port) {
  const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
  if (socket < 0) return false;
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(number(port)));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return ::connect(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
}

bool can_signal(const char* process) { return ::kill(number(process), 0) == 0; }

bool can_open(const char* file) { return ::open(file, O_RDONLY | O_CLOEXEC) >= 0; }

bool can_fork() {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(0);
  return child > 0;
}

// More processes at a time than it may have.
bool can_fork_many(int count) {
  for (int i = 0; i < count; ++i) {
    const pid_t child = ::fork();
    if (child == 0) {
      ::pause();
      ::_exit(0);
    }
    if (child < 0) return false;
  }
  return true;
}

bool can_allocate(std::size_t megabytes) {
  void* memory = ::mmap(nullptr, megabytes * mebibyte, PROT_READ | PROT_WRITE,
                        MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) return false;
  for (std::size_t at = 0; at < megabytes * mebibyte; at += 4096)
    static_cast<volatile char*>(memory)[at] = 1;
  return true;
}

// Several processes, none of which has too much by itself.
bool can_allocate_together(std::size_t megabytes, int count) {
  bool all = true;
  for (int i = 0; i < count; ++i) {
    int ends[2];
    if (::pipe(ends) != 0) return false;
    const pid_t child = ::fork();
    if (child < 0) return false;
    if (child == 0) {
      ::close(ends[0]);
      if (!can_allocate(megabytes)) ::_exit(1);
      if (::write(ends[1], "", 1) != 1) ::_exit(1);
      ::pause();
    }
    ::close(ends[1]);
    char done = 0;
    all = ::read(ends[0], &done, 1) == 1 && all;
  }
  return all;
}

bool can_write(std::size_t megabytes, const std::string& folder) {
  const int file = ::open((folder + "/large").c_str(), O_CREAT | O_WRONLY | O_CLOEXEC, 0600);
  if (file < 0) return false;
  static char block[mebibyte];
  for (std::size_t i = 0; i < megabytes; ++i) {
    if (::write(file, block, sizeof block) != static_cast<ssize_t>(sizeof block)) return false;
  }
  return true;
}

bool can_make_files(int count, const std::string& folder) {
  for (int i = 0; i < count; ++i) {
    const int file = ::open((folder + "/" + std::to_string(i)).c_str(), O_CREAT | O_CLOEXEC, 0600);
    if (file < 0) return false;
    ::close(file);
  }
  return true;
}

bool has_environment() {
  for (char** entry = environ; *entry != nullptr; ++entry) {
    if (std::strcmp(*entry, "PWD=/") != 0) return true;
  }
  return false;
}

bool has_rights() {
  return ::mount("none", "/", "tmpfs", 0, nullptr) == 0 || ::unshare(CLONE_NEWUSER) == 0 ||
         ::setuid(0) == 0 || ::ptrace(PTRACE_TRACEME, 0, nullptr, nullptr) == 0;
}

}  // namespace

int probe(const char* name, int count, char** values) {
  const std::string what = name;
  // Past the largest file a signal would come first.
  ::signal(SIGXFSZ, SIG_IGN);
  const char* value = count > 0 ? values[0] : "0";
  const std::string folder = count > 1 ? values[1] : "/tmp";
  bool managed = true;
  if (what == "nothing") managed = false;
  if (what == "network") managed = reaches_network(value);
  if (what == "signal") managed = can_signal(value);
  if (what == "file") managed = can_open(value);
  if (what == "fork") managed = can_fork();
  if (what == "fork-many") managed = can_fork_many(number(value));
  if (what == "memory") managed = can_allocate(static_cast<std::size_t>(number(value)));
  if (what == "memory-together") managed = can_allocate_together(32, 4);
  if (what == "file-size") managed = can_write(static_cast<std::size_t>(number(value)), folder);
  if (what == "files") managed = can_make_files(number(value), folder);
  if (what == "environment") managed = has_environment();
  if (what == "rights") managed = has_rights();
  if (what == "root") managed = ::getuid() == 0 || ::geteuid() == 0;
  if (what == "user") managed = ::getuid() == static_cast<uid_t>(number(value));
  if (what == "spin") {
    for (;;) {
      volatile int turn = 0;
      static_cast<void>(turn);
    }
  }
  return managed ? 1 : 0;
}

}  // namespace contact::launcher
