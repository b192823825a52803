// contact-box: starts a box and ends it.
//
// The started process stays outside and waits. Its child gives up, one after another, all rights
// that a sandbox must not have, and becomes bubblewrap or, without namespaces, the command itself.
// When contact-box ends, all processes of the sandbox have ended: the sandbox is a process
// namespace, which the kernel clears with its first process; without namespaces, this process
// adopts all its orphans and ends them.

#include "launcher.hpp"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <fcntl.h>
#include <grp.h>
#include <poll.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

namespace contact::launcher {

void fail(const Settings& settings, const std::string& what) {
  const std::string line =
      "failed " + what + (errno != 0 ? std::string(": ") + std::strerror(errno) : "") + "\n";
  if (::write(settings.report, line.data(), line.size()) < 0) {
    // The reader is gone.
  }
  ::_exit(125);
}

namespace {

std::uint64_t number(const char* text) { return std::strtoull(text, nullptr, 10); }

Settings read_settings(int count, char** words) {
  Settings settings;
  int at = 1;
  const auto next = [&] { return at < count ? words[at++] : const_cast<char*>(""); };
  while (at < count) {
    const std::string word = next();
    if (word == "--") {
      while (at < count) settings.command.push_back(next());
    } else if (word == "--parent") {
      settings.parent = static_cast<pid_t>(number(next()));
    } else if (word == "--report") {
      settings.report = static_cast<int>(number(next()));
    } else if (word == "--group") {
      settings.groups.emplace_back(next());
    } else if (word == "--user") {
      settings.user = static_cast<long>(number(next()));
    } else if (word == "--keep") {
      settings.kept.push_back(static_cast<int>(number(next())));
    } else if (word == "--status") {
      settings.status = static_cast<int>(number(next()));
    } else if (word == "--network") {
      settings.network = static_cast<int>(number(next()));
    } else if (word == "--namespaces") {
      settings.namespaces = true;
    } else if (word == "--read" || word == "--write") {
      Staged staged;
      staged.kind = word == "--read" ? Staged::Kind::read : Staged::Kind::write;
      staged.host = next();
      staged.name = next();
      settings.staged.push_back(staged);
    } else if (word == "--temporary") {
      Staged staged;
      staged.kind = Staged::Kind::temporary;
      staged.bytes = number(next());
      staged.files = number(next());
      staged.name = next();
      settings.staged.push_back(staged);
    } else if (word == "--filter") {
      settings.filter = static_cast<int>(number(next()));
    } else if (word == "--close-files") {
      settings.files_closed = true;
    } else if (word == "--open" || word == "--open-write" || word == "--open-run") {
      settings.opened.push_back({next(), word == "--open-write", word == "--open-run"});
    } else if (word == "--program") {
      settings.program = static_cast<int>(number(next()));
    } else if (word == "--folder") {
      settings.folder = next();
    } else if (word == "--cpu") {
      settings.cpu_seconds = number(next());
    } else if (word == "--memory") {
      settings.memory = number(next());
    } else if (word == "--file-bytes") {
      settings.file_bytes = number(next());
    } else if (word == "--descriptors") {
      settings.descriptors = number(next());
    } else if (word == "--processes") {
      settings.processes = number(next());
    } else {
      errno = 0;
      fail(settings, "contact-box does not know " + word);
    }
  }
  settings.command.push_back(nullptr);
  return settings;
}

void write_file(const Settings& settings, const std::string& path, const std::string& text) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (file < 0 || ::write(file, text.data(), text.size()) < 0) fail(settings, "writing " + path);
  ::close(file);
}

void limit(const Settings& settings, __rlimit_resource_t resource, rlim_t soft, rlim_t hard) {
  rlimit now{};
  ::getrlimit(resource, &now);
  rlimit wanted{soft, hard};
  wanted.rlim_max = std::min(wanted.rlim_max, now.rlim_max);
  wanted.rlim_cur = std::min(wanted.rlim_cur, wanted.rlim_max);
  if (::setrlimit(resource, &wanted) != 0) fail(settings, "setting a limit");
}

void set_limits(const Settings& settings) {
  constexpr rlim_t mebibyte = 1u << 20;
  const auto both = [&](__rlimit_resource_t resource, rlim_t value) {
    limit(settings, resource, value, value);
  };
  limit(settings, RLIMIT_CPU, settings.cpu_seconds, settings.cpu_seconds + 1);
  both(RLIMIT_AS, settings.memory);
  both(RLIMIT_FSIZE, settings.file_bytes);
  both(RLIMIT_NOFILE, settings.descriptors);
  both(RLIMIT_CORE, 0);
  both(RLIMIT_MEMLOCK, 0);
  both(RLIMIT_MSGQUEUE, 0);
  both(RLIMIT_RTPRIO, 0);
  limit(settings, RLIMIT_STACK, 8 * mebibyte, 64 * mebibyte);
  if (settings.processes > 0) both(RLIMIT_NPROC, settings.processes);
}

void make_namespaces(const Settings& settings) {
  const uid_t user = ::getuid();
  const gid_t group = ::getgid();
  if (user == 0) {
    if (::unshare(CLONE_NEWNS | CLONE_NEWPID) != 0) fail(settings, "making namespaces");
    return;
  }
  if (::unshare(CLONE_NEWUSER | CLONE_NEWNS | CLONE_NEWPID) != 0)
    fail(settings, "making namespaces");
  const auto itself = [](unsigned id) {
    return std::to_string(id) + " " + std::to_string(id) + " 1\n";
  };
  write_file(settings, "/proc/self/setgroups", "deny");
  write_file(settings, "/proc/self/uid_map", itself(user));
  write_file(settings, "/proc/self/gid_map", itself(group));
}

void become(const Settings& settings) {
  if (settings.user < 0) return;
  const auto id = static_cast<uid_t>(settings.user);
  if (::setgroups(0, nullptr) != 0 || ::setresgid(id, id, id) != 0 || ::setresuid(id, id, id) != 0)
    fail(settings, "becoming user " + std::to_string(id));
}

// Ends with the keeper. It may have ended before the kernel was asked to say so; from inside a
// process namespace only the other end of a pipe shows it.
void end_with_keeper(const Settings& settings, int keeper) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  pollfd closed{keeper, POLLIN, 0};
  errno = 0;
  if (::poll(&closed, 1, 0) != 0) fail(settings, "contact-box was ended");
}

[[noreturn]] void be_the_box(const Settings& settings, int keeper) {
  end_with_keeper(settings, keeper);
  ::setsid();
  for (const std::string& group : settings.groups) write_file(settings, group, "0");
  if (settings.namespaces) {
    stage(settings, settings.user < 0 ? ::getuid() : static_cast<uid_t>(settings.user),
          settings.user < 0 ? ::getgid() : static_cast<gid_t>(settings.user));
  }
  // Its inputs may be in a folder that its new user cannot enter.
  if (!settings.folder.empty() && ::chdir(settings.folder.c_str()) != 0)
    fail(settings, "going to " + settings.folder);
  if (settings.program >= 0) {
    const int program = ::open(settings.command[0], O_RDONLY | O_CLOEXEC);
    if (program < 0 || ::dup3(program, settings.program, O_CLOEXEC) < 0)
      fail(settings, std::string("opening ") + settings.command[0]);
    ::close(program);
  }
  const int rules = settings.files_closed ? rules_of_files(settings) : -1;
  become(settings);
  // A change of user takes the request back.
  end_with_keeper(settings, keeper);
  ::umask(022);
  if (settings.status >= 0 && ::dup2(settings.report, settings.status) < 0)
    fail(settings, "handing on the report");
  set_limits(settings);
  sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  // A sleep may last a millisecond longer than requested. A process that sleeps repeatedly for a
  // few microseconds would seldom be asleep at a sample (idle.hpp).
  ::prctl(PR_SET_TIMERSLACK, 1'000'000, 0, 0, 0);
  if (settings.files_closed || settings.filter >= 0) ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  if (settings.files_closed) close_files(settings, rules);
  if (settings.filter >= 0) load_filter(settings);
  if (settings.program >= 0) {
    ::syscall(SYS_execveat, settings.program, "", settings.command.data(), environ, AT_EMPTY_PATH);
    // A submission may be linked such that no kernel starts it, for whatever reason: that is its
    // own end, and contact-box has nothing to say of it.
    ::_exit(not_started);
  } else {
    ::execv(settings.command[0], settings.command.data());
  }
  fail(settings, std::string("starting ") + settings.command[0]);
}

// Every process that is left over from the box is a child of this one by now.
void end_orphans() {
  for (int turn = 0; turn < 1000; ++turn) {
    const std::string list = "/proc/self/task/" + std::to_string(::getpid()) + "/children";
    if (FILE* file = std::fopen(list.c_str(), "re"); file != nullptr) {
      int child = 0;
      while (std::fscanf(file, "%d", &child) == 1) ::kill(child, SIGKILL);
      std::fclose(file);
    }
    if (::waitpid(-1, nullptr, WNOHANG) < 0) return;
    ::usleep(500);
  }
}

int keep(const Settings& settings, pid_t box) {
  sigset_t awaited;
  ::sigemptyset(&awaited);
  for (const int signal : {SIGCHLD, SIGTERM, SIGINT, SIGHUP}) ::sigaddset(&awaited, signal);
  int status = 0;
  rusage used{};
  for (;;) {
    siginfo_t signal{};
    if (::sigwaitinfo(&awaited, &signal) < 0) continue;
    if (signal.si_signo != SIGCHLD) ::kill(box, SIGKILL);
    // A process that was orphaned in the box may end first.
    pid_t ended = 0;
    do {
      ended = ::wait4(-1, &status, WNOHANG, &used);
    } while (ended > 0 && ended != box);
    if (ended == box) break;
  }
  if (!settings.namespaces) end_orphans();
  const auto microseconds = [](const timeval& time) {
    return static_cast<long long>(time.tv_sec) * 1'000'000 + time.tv_usec;
  };
  char line[160];
  const int size = std::snprintf(
      line, sizeof line, "ended %s %d %lld %ld\n", WIFSIGNALED(status) ? "signal" : "exit",
      WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status),
      microseconds(used.ru_utime) + microseconds(used.ru_stime), used.ru_maxrss);
  if (::write(settings.report, line, static_cast<std::size_t>(size)) < 0) return 125;
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

// Closes all descriptors but the standard three and these. The process that started the grader may
// have left descriptors open that a sandbox must not have.
void keep_only(std::vector<int> kept) {
  std::sort(kept.begin(), kept.end());
  unsigned from = 3;
  const auto close_between = [](unsigned first, unsigned last) {
    if (first > last) return;
    if (::syscall(SYS_close_range, first, last, 0) == 0) return;
    for (unsigned number = first; number <= std::min(last, 65535u); ++number)
      ::close(static_cast<int>(number));
  };
  for (const int number : kept) {
    if (number < 3) continue;
    close_between(from, static_cast<unsigned>(number) - 1);
    from = static_cast<unsigned>(number) + 1;
  }
  close_between(from, ~0u);
}

int run(int count, char** words) {
  if (count > 2 && std::strcmp(words[1], "--probe") == 0)
    return probe(words[2], count - 3, words + 3);
  const Settings settings = read_settings(count, words);
  if (settings.report < 0 || settings.command.size() < 2) {
    std::fputs("contact-box starts the boxes of `contact grade`; it is not meant to be called.\n",
               stderr);
    return 2;
  }
  std::vector<int> kept = settings.kept;
  kept.insert(kept.end(), {settings.report, settings.filter, settings.network});
  keep_only(kept);
  ::fcntl(settings.report, F_SETFD, FD_CLOEXEC);
  sigset_t awaited;
  ::sigemptyset(&awaited);
  for (const int signal : {SIGCHLD, SIGTERM, SIGINT, SIGHUP}) ::sigaddset(&awaited, signal);
  ::sigprocmask(SIG_BLOCK, &awaited, nullptr);
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  errno = 0;
  if (::getppid() != settings.parent)
    fail(settings, "the process that started the sandbox is gone");
  ::prctl(PR_SET_CHILD_SUBREAPER, 1);
  if (settings.network >= 0) {
    if (::setns(settings.network, CLONE_NEWNET) != 0) fail(settings, "entering an empty network");
    ::close(settings.network);
  }
  if (settings.namespaces) make_namespaces(settings);
  int alive[2];
  if (::pipe2(alive, O_CLOEXEC) != 0) fail(settings, "making a pipe");
  const pid_t box = ::fork();
  if (box < 0) fail(settings, "starting a process");
  if (box == 0) {
    ::close(alive[1]);
    be_the_box(settings, alive[0]);
  }
  // The box's descriptors are the box's: a pipe held open here would never end.
  for (int number = 0; number < 3; ++number) ::close(number);
  keep_only({settings.report, alive[1]});
  return keep(settings, box);
}

}  // namespace

}  // namespace contact::launcher

int main(int count, char** words) { return contact::launcher::run(count, words); }
