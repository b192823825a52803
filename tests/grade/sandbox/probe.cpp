// What a hostile submission tries, one thing a run: `probe WHAT [VALUE]`. Prints "managed" if it
// worked, "refused" and the error if not, and exits with 0 either way; some never come back.

#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <new>
#include <string>
#include <thread>
#include <vector>

#include <arpa/inet.h>
#include <dirent.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/prctl.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

int value = 0;
std::string text;

long forked(long child) {
  if (child == 0) _exit(0);
  return child;
}

// Several at a time, all of which stay.
long fork_many() {
  for (int i = 0; i < value; ++i) {
    const pid_t child = fork();
    if (child == 0) {
      pause();
      _exit(0);
    }
    if (child < 0) return -1;
  }
  return 0;
}

// Leaves a process behind that has left its session and its parent.
long leave_behind() {
  const pid_t child = fork();
  if (child < 0) return -1;
  if (child > 0) return waitpid(child, nullptr, 0);
  setsid();
  if (fork() != 0) _exit(0);
  for (const int number : {0, 1, 2}) close(number);
  for (;;) pause();
}

long use_memory() {
  std::vector<char> memory(static_cast<std::size_t>(value) << 20, 'x');
  return memory[memory.size() / 2] == 'x' ? 0 : -1;
}

long write_file() {
  signal(SIGXFSZ, SIG_IGN);
  const int file = open("/tmp/file", O_CREAT | O_WRONLY, 0600);
  static char block[1 << 20];
  for (int i = 0; i < value; ++i) {
    if (file < 0 || write(file, block, sizeof block) != sizeof block) return -1;
  }
  return 0;
}

long make_files() {
  for (int i = 0; i < value; ++i) {
    const int file = open(("/tmp/" + std::to_string(i)).c_str(), O_CREAT | O_WRONLY, 0600);
    if (file < 0) return -1;
    close(file);
  }
  return 0;
}

long list_descriptors() {
  for (int number = 0; number < 1024; ++number) {
    if (fcntl(number, F_GETFD) >= 0) std::printf("descriptor %d\n", number);
  }
  return 0;
}

long list_environment() {
  for (char** entry = environ; *entry != nullptr; ++entry) std::printf("variable %s\n", *entry);
  return 0;
}

// Of the files that a list names, those that are in sight and cannot be read.
long open_all() {
  std::ifstream list(text);
  int seen = 0;
  for (std::string name; std::getline(list, name);) {
    struct stat found {};
    if (stat(name.c_str(), &found) != 0) continue;
    ++seen;
    const int file = open(name.c_str(), O_RDONLY);
    if (file < 0) std::printf("closed %s: %s\n", name.c_str(), std::strerror(errno));
    if (file >= 0) close(file);
  }
  std::printf("seen %d\n", seen);
  return 0;
}

long connect_out() {
  const int socket_number = socket(AF_INET, SOCK_STREAM, 0);
  if (socket_number < 0) return -1;
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(value));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return connect(socket_number, reinterpret_cast<sockaddr*>(&address), sizeof address);
}

long raise_limit() {
  const rlimit more{RLIM_INFINITY, RLIM_INFINITY};
  return setrlimit(RLIMIT_AS, &more);
}

// Asks the kernel to send a signal to another process when a pipe is ready.
long signal_by_pipe() { return fcntl(0, F_SETOWN, value != 0 ? value : getppid()); }

#ifdef __x86_64__
// getpid by the gate of another architecture.
long call_32_bit() {
  long result = 20;
  __asm__ volatile("int $0x80" : "+a"(result) : : "memory");
  return result;
}
long call_x32() { return syscall(0x40000000 | SYS_getpid); }
#endif

long do_arithmetic() {
  double sum = 0.0;
  for (int i = 1; i < 1000; ++i) sum += std::sqrt(static_cast<double>(i)) / i;
  std::cout << "sum " << (sum > 60.0) << '\n';
  return 0;
}

long start_thread() {
  int answer = 0;
  try {
    std::thread([&answer] { answer = 42; }).join();
  } catch (const std::exception&) {
    return -1;
  }
  return answer == 42 ? 0 : -1;
}

// Works in one thread while another waits for it.
long work_beside() {
  try {
    std::thread([] {
      timespec used{};
      do clock_gettime(CLOCK_THREAD_CPUTIME_ID, &used);
      while (used.tv_nsec < 900'000'000);
    }).join();
  } catch (const std::exception&) {
    return -1;
  }
  return 0;
}

// Ends its first thread, so that only another is left to sleep.
long sleep_beside() {
  std::thread([] { sleep(1000); }).detach();
  return syscall(SYS_exit, 0);
}

// Naps for as many microseconds, works a little, and again.
long nap_and_work() {
  for (;;) {
    usleep(static_cast<useconds_t>(value));
    for (volatile int i = 0; i < 1000; ++i) static_cast<void>(i);
  }
}

int overflow(int depth) {
  if (depth < 0) return 0;
  volatile char frame[4096]{};
  frame[0] = static_cast<char>(depth);
  return overflow(depth + 1) + frame[0];
}

[[noreturn]] void flood(int number) {
  static char line[4096];
  std::memset(line, 'x', sizeof line);
  for (;;) {
    if (write(number, line, sizeof line) < 0) _exit(9);
  }
}

const std::map<std::string, std::function<long()>> attempts = {
    {"arithmetic", do_arithmetic},
    {"fork", [] { return forked(fork()); }},
    {"vfork",
     [] { return forked(syscall(SYS_clone, CLONE_VM | CLONE_VFORK | SIGCHLD, 0, 0, 0, 0)); }},
    {"clone3",
     [] {
       struct {
         unsigned long long flags, pidfd, child, parent, signal, stack, size, tls;
       } wanted{};
       wanted.signal = SIGCHLD;
       return forked(syscall(SYS_clone3, &wanted, sizeof wanted));
     }},
    {"thread", start_thread},
    {"fork-many", fork_many},
    {"leave-behind", leave_behind},
    {"exec", [] { return static_cast<long>(execl("/bin/sh", "sh", "-c", "echo shell", nullptr)); }},
    {"exec-itself",
     [] { return static_cast<long>(execl("/program", "/program", "arithmetic", nullptr)); }},
    {"socket", [] { return static_cast<long>(socket(AF_INET, SOCK_DGRAM, 0)); }},
    {"unix-socket", [] { return static_cast<long>(socket(AF_UNIX, SOCK_STREAM, 0)); }},
    {"netlink", [] { return static_cast<long>(socket(AF_NETLINK, SOCK_RAW, 0)); }},
    {"connect", connect_out},
    {"open", [] { return static_cast<long>(open(text.c_str(), O_RDONLY)); }},
    {"open-all", open_all},
    {"list", [] { return opendir(text.c_str()) != nullptr ? 0L : -1L; }},
    {"create", [] { return static_cast<long>(open(text.c_str(), O_CREAT | O_WRONLY, 0600)); }},
    {"write-file", write_file},
    {"make-files", make_files},
    {"memory", use_memory},
    {"descriptors", list_descriptors},
    {"environment", list_environment},
    {"kill", [] { return static_cast<long>(kill(value, SIGKILL)); }},
    {"kill-parent", [] { return static_cast<long>(kill(getppid(), SIGKILL)); }},
    {"kill-all", [] { return static_cast<long>(kill(-1, SIGKILL)); }},
    {"tgkill", [] { return syscall(SYS_tgkill, value, value, SIGKILL); }},
    {"signal-by-pipe", signal_by_pipe},
    {"ptrace", [] { return ptrace(PTRACE_ATTACH, value, nullptr, nullptr); }},
    {"read-process",
     [] { return syscall(SYS_process_vm_readv, value, nullptr, 0UL, nullptr, 0UL, 0UL); }},
    {"limit-other",
     [] {
       rlimit limits{1, 1};
       return syscall(SYS_prlimit64, value, RLIMIT_CPU, &limits, nullptr);
     }},
    {"raise-limit", raise_limit},
    {"become-root", [] { return static_cast<long>(setuid(0)); }},
    {"who", [] { return static_cast<long>(std::printf("user %d %d\n", getuid(), geteuid())); }},
    {"mount", [] { return static_cast<long>(mount("none", "/", "tmpfs", 0, nullptr)); }},
    {"chroot", [] { return static_cast<long>(chroot("/")); }},
    {"unshare", [] { return static_cast<long>(unshare(CLONE_NEWUSER)); }},
    {"setsid", [] { return static_cast<long>(setsid()); }},
    {"io-uring", [] { return syscall(425, 1, nullptr); }},
    {"bpf", [] { return syscall(SYS_bpf, 0, nullptr, 0); }},
    {"keyctl", [] { return syscall(SYS_keyctl, 0, 0, 0, 0, 0); }},
    {"userfaultfd", [] { return syscall(SYS_userfaultfd, 0); }},
    {"perf", [] { return syscall(SYS_perf_event_open, nullptr, 0, -1, -1, 0); }},
    {"memory-file", [] { return syscall(SYS_memfd_create, "x", 0); }},
    {"new-privileges", [] { return static_cast<long>(prctl(PR_SET_DUMPABLE, 1)); }},
#ifdef __x86_64__
    {"32-bit", call_32_bit},
    {"x32", call_x32},
#endif
    {"sleep", [] { return static_cast<long>(sleep(1000)); }},
    {"stop", [] { return static_cast<long>(raise(SIGSTOP)); }},
    {"membarrier", [] { return syscall(SYS_membarrier, 1, 0, 0); }},
    {"interval-timer",
     [] {
       const itimerval often{{0, 50}, {0, 50}};
       return static_cast<long>(setitimer(ITIMER_REAL, &often, nullptr));
     }},
    {"nap-and-work", nap_and_work},
    {"work-beside", work_beside},
    {"sleep-beside", sleep_beside},
    {"nap", [] { return static_cast<long>(usleep(1000)); }},
    {"spin",
     []() -> long {
       for (;;) {
         volatile int turn = 0;
         static_cast<void>(turn);
       }
     }},
    {"flood", []() -> long { flood(1); }},
    {"flood-errors", []() -> long { flood(2); }},
    {"overflow", [] { return static_cast<long>(overflow(0)); }},
    {"abort", []() -> long { std::abort(); }},
    {"segfault",
     [] {
       volatile int* nowhere = nullptr;
       *nowhere = 1;
       return 0L;
     }},
    {"exit", []() -> long { std::exit(value); }},
};

}  // namespace

int main(int count, char** words) {
  const auto attempt = attempts.find(count > 1 ? words[1] : "");
  if (attempt == attempts.end()) return 2;
  if (count > 2) text = words[2];
  value = std::atoi(text.c_str());
  errno = 0;
  try {
    if (attempt->second() >= 0)
      std::puts("managed");
    else
      std::printf("refused: %s\n", std::strerror(errno));
  } catch (const std::bad_alloc&) {
    std::puts("refused: bad_alloc");
  }
}
