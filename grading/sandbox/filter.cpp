#include "filter.hpp"

#include <array>
#include <cerrno>
#include <map>
#include <memory>
#include <mutex>
#include <string_view>
#include <tuple>
#include <vector>

#include <fcntl.h>
#include <sched.h>
#include <seccomp.h>
#include <sys/mman.h>
#include <unistd.h>

#include "../book/book.hpp"

namespace contact::grading {

namespace {

using Names = std::vector<const char*>;

// Its own memory, time and end; what it was given to read and write; to wait for a child, which
// bubblewrap does under the same filter. None of these names a file or another process. Names that
// an architecture does not have are passed over.
const Names& own_affairs() {
  static const Names names = {
      "brk", "mmap", "mmap2", "munmap", "mremap", "mprotect", "madvise", "arch_prctl",
      "set_tid_address", "set_robust_list", "get_robust_list", "rseq", "getrandom", "futex",
      "futex_time64",
      // Time.
      "clock_gettime", "clock_gettime64", "clock_getres", "clock_getres_time64", "clock_nanosleep",
      "clock_nanosleep_time64", "nanosleep", "gettimeofday", "time", "times", "getrusage",
      "sched_yield", "sched_getaffinity", "getcpu", "sysinfo", "uname", "pause",
      // Who it is.
      "getpid", "gettid", "getppid", "getuid", "geteuid", "getgid", "getegid", "getresuid",
      "getresgid", "getpgrp", "getgroups", "getrlimit",
      // Signals to itself.
      "rt_sigaction", "rt_sigprocmask", "rt_sigreturn", "rt_sigpending", "rt_sigtimedwait",
      "rt_sigsuspend", "sigaltstack", "restart_syscall", "tgkill",
      // What it holds already.
      "read", "readv", "write", "writev", "close", "close_range", "lseek", "_llseek", "fstat",
      "fstat64", "poll", "ppoll", "ppoll_time64", "select", "pselect6", "recvfrom", "recvmsg",
      "shutdown", "wait4", "exit", "exit_group"};
  return names;
}

// Files, where those in sight are the box's own.
const Names& files() {
  static const Names names = {
      "open",       "openat",          "openat2",   "creat",      "stat",
      "stat64",     "lstat",           "lstat64",   "newfstatat", "fstatat64",
      "statx",      "access",          "faccessat", "faccessat2", "readlink",
      "readlinkat", "getcwd",          "chdir",     "fchdir",     "pread64",
      "preadv",     "pwrite64",        "pwritev",   "ftruncate",  "ftruncate64",
      "truncate",   "fallocate",       "unlink",    "unlinkat",   "rename",
      "renameat",   "renameat2",       "mkdir",     "mkdirat",    "rmdir",
      "getdents64", "getdents",        "dup",       "dup2",       "dup3",
      "fsync",      "fdatasync",       "umask",     "statfs",     "fstatfs",
      "fadvise64",  "copy_file_range", "sendfile"};
  return names;
}

// What a compiler and a linker need besides.
const Names& building() {
  static const Names names = {"execve",
                              "execveat",
                              "wait4",
                              "waitid",
                              "pipe",
                              "pipe2",
                              "kill",
                              "prlimit64",
                              "setrlimit",
                              "fcntl",
                              "fcntl64",
                              "flock",
                              "chmod",
                              "fchmod",
                              "fchmodat",
                              "utimensat",
                              "utime",
                              "utimes",
                              "symlink",
                              "symlinkat",
                              "link",
                              "linkat",
                              "ioctl",
                              "membarrier",
                              "msync",
                              "mincore",
                              "mlock",
                              "munlock",
                              "sched_setaffinity",
                              "sched_getparam",
                              "sched_getscheduler",
                              "sched_get_priority_max",
                              "sched_get_priority_min",
                              "setpgid",
                              "getpgid",
                              "getsid",
                              "getpriority",
                              "eventfd2",
                              "epoll_create1",
                              "epoll_ctl",
                              "epoll_wait",
                              "epoll_pwait",
                              "memfd_create",
                              "chown",
                              "fchown",
                              "lchown",
                              "fchownat",
                              "sync_file_range",
                              "splice",
                              "tee",
                              "timer_create",
                              "timer_settime",
                              "timer_delete",
                              "prctl"};
  return names;
}

class Filter {
 public:
  Filter() : context_(seccomp_init(SCMP_ACT_ERRNO(EPERM)), seccomp_release) {
    if (!context_) throw BookError("the filter of system calls cannot be made");
    // Calls of another architecture have other numbers; no honest program makes them.
    check(seccomp_attr_set(context_.get(), SCMP_FLTATR_ACT_BADARCH, SCMP_ACT_KILL_PROCESS));
  }

  void allow(const Names& names) {
    for (const char* name : names) rule(SCMP_ACT_ALLOW, name, {});
  }
  void allow(const char* name, const std::vector<scmp_arg_cmp>& where = {}) {
    rule(SCMP_ACT_ALLOW, name, where);
  }
  void refuse(const char* name, int error) {
    rule(SCMP_ACT_ERRNO(static_cast<unsigned>(error)), name, {});
  }

  [[nodiscard]] std::string code() const {
    const int file = ::memfd_create("filter", MFD_CLOEXEC);
    std::string text;
    if (file < 0 || seccomp_export_bpf(context_.get(), file) != 0)
      throw BookError("the filter of system calls cannot be written");
    ::lseek(file, 0, SEEK_SET);
    std::array<char, 4096> part{};
    for (ssize_t count = 0; (count = ::read(file, part.data(), part.size())) > 0;)
      text.append(part.data(), static_cast<std::size_t>(count));
    ::close(file);
    return text;
  }

 private:
  static void check(int error) {
    if (error < 0 && error != -EEXIST)
      throw BookError("the filter of system calls cannot be made: error " + std::to_string(-error));
  }
  void rule(std::uint32_t action, const char* name, const std::vector<scmp_arg_cmp>& where) {
    const int number = seccomp_syscall_resolve_name(name);
    if (number == __NR_SCMP_ERROR || number < 0) return;
    check(seccomp_rule_add_array(context_.get(), action, number,
                                 static_cast<unsigned>(where.size()), where.data()));
  }

  std::unique_ptr<void, void (*)(scmp_filter_ctx)> context_;
};

scmp_arg_cmp equal(unsigned argument, std::uint64_t value) {
  return {argument, SCMP_CMP_EQ, value, 0};
}

// Threads and processes, but no namespaces: CLONE_NEWTIME to CLONE_NEWNET. A process that calls
// vfork sleeps until the child has ended, and the kernel shows it as waiting for a disk. Only a
// compiler, which starts programs in that way, may do so.
void allow_processes(Filter& filter, BoxKind kind) {
  constexpr std::uint64_t namespaces = 0x7e020080;
  const bool compiles = kind == BoxKind::compile;
  const std::uint64_t refused = namespaces | (compiles ? 0 : CLONE_VFORK);
  filter.allow("clone", {{0, SCMP_CMP_MASKED_EQ, refused, 0}});
  filter.allow("fork");
  if (compiles) filter.allow("vfork");
  filter.allow("waitid");
}

std::string make(const FilterSpec& spec) {
  Filter filter;
  filter.allow(own_affairs());
  // Its own limits; those of another process, which may be of the same user, are not its to change.
  filter.allow("prlimit64", {equal(0, 0)});
  for (const std::uint64_t command : {F_GETFD, F_SETFD, F_GETFL}) {
    filter.allow("fcntl", {equal(1, command)});
    filter.allow("fcntl64", {equal(1, command)});
  }
  // To the connected peer of the socket, not to an address.
  filter.allow("sendto", {equal(4, 0)});
  if (spec.private_files || spec.kind != BoxKind::answer) filter.allow(files());
  if (spec.program >= 0) {
    // It is closed in the program that is started, which therefore can start nothing.
    filter.allow("execveat",
                 {equal(0, static_cast<std::uint64_t>(spec.program)), equal(4, AT_EMPTY_PATH)});
  } else {
    filter.allow("execve");
  }
  if (spec.kind == BoxKind::compile) filter.allow(building());
  if (spec.kind == BoxKind::judge) filter.allow(Names{"sendmsg", "socketpair", "pipe", "pipe2"});
  // The C library asks for the newer call first and takes this answer for an older kernel.
  filter.refuse("clone3", ENOSYS);
  if (spec.processes) {
    allow_processes(filter, spec.kind);
  } else {
    for (const char* name : {"clone", "fork", "vfork"}) filter.refuse(name, EAGAIN);
  }
  return filter.code();
}

}  // namespace

const std::string& filter_of(const FilterSpec& spec) {
  static std::mutex mutex;
  static std::map<std::tuple<int, bool, bool, int>, std::string> made;
  const std::lock_guard<std::mutex> lock(mutex);
  std::string& code =
      made[{static_cast<int>(spec.kind), spec.processes, spec.private_files, spec.program}];
  if (code.empty()) code = make(spec);
  return code;
}

}  // namespace contact::grading
