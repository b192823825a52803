// How contact-box makes the private view of files, and what it does instead where it cannot.

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstring>

#include <fcntl.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/mount.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "launcher.hpp"

namespace contact::launcher {

namespace {

// Of the kernel's headers only old ones can be counted on.
constexpr unsigned tree_clone = 1;           // OPEN_TREE_CLONE
constexpr unsigned tree_recursive = 0x8000;  // AT_RECURSIVE
constexpr unsigned tree_close_on_exec = O_CLOEXEC;
constexpr unsigned move_from_descriptor = 4;  // MOVE_MOUNT_F_EMPTY_PATH
constexpr long nr_open_tree = 428;
constexpr long nr_move_mount = 429;
constexpr long nr_landlock_create_ruleset = 444;
constexpr long nr_landlock_add_rule = 445;
constexpr long nr_landlock_restrict_self = 446;

bool is_folder(const std::string& path) {
  struct stat found {};
  return ::stat(path.c_str(), &found) == 0 && S_ISDIR(found.st_mode);
}

}  // namespace

void stage(const Settings& settings, uid_t user, gid_t group) {
  if (::mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0)
    fail(settings, "making a private view of files");
  // bubblewrap looks processes up by their numbers in this namespace. Where a container forbids the
  // mount, the one that is there stays.
  ::mount("proc", "/proc", "proc", MS_NOSUID | MS_NODEV | MS_NOEXEC, nullptr);
  // Taken before /tmp is covered: what is staged may lie there.
  std::vector<int> trees;
  for (const Staged& staged : settings.staged) {
    int tree = -1;
    if (staged.kind != Staged::Kind::temporary) {
      tree = static_cast<int>(::syscall(nr_open_tree, AT_FDCWD, staged.host.c_str(),
                                        tree_clone | tree_recursive | tree_close_on_exec));
      if (tree < 0) fail(settings, "showing " + staged.host);
    }
    trees.push_back(tree);
  }
  std::vector<bool> folders;
  for (const Staged& staged : settings.staged)
    folders.push_back(staged.kind == Staged::Kind::temporary || is_folder(staged.host));

  if (::mount("tmpfs", "/tmp", "tmpfs", MS_NOSUID | MS_NODEV, "size=1m,mode=0755") != 0)
    fail(settings, "covering /tmp");
  for (std::size_t i = 0; i < settings.staged.size(); ++i) {
    const Staged& staged = settings.staged[i];
    const std::string place = "/tmp/" + staged.name;
    if (folders[i]) {
      if (::mkdir(place.c_str(), 0755) != 0) fail(settings, "making " + place);
    } else {
      const int file = ::open(place.c_str(), O_CREAT | O_WRONLY | O_CLOEXEC, 0644);
      if (file < 0) fail(settings, "making " + place);
      ::close(file);
    }
    if (staged.kind == Staged::Kind::temporary) {
      const std::string options = "size=" + std::to_string(staged.bytes) +
                                  ",nr_inodes=" + std::to_string(staged.files + 1) +
                                  ",mode=0700,uid=" + std::to_string(user) +
                                  ",gid=" + std::to_string(group);
      if (::mount("tmpfs", place.c_str(), "tmpfs", MS_NOSUID | MS_NODEV | MS_NOEXEC,
                  options.c_str()) != 0)
        fail(settings, "making a private /tmp");
    } else if (::syscall(nr_move_mount, trees[i], "", AT_FDCWD, place.c_str(),
                         move_from_descriptor) != 0) {
      fail(settings, "showing " + staged.host);
    }
  }
}

// Landlock, by the kernel's numbers: https://docs.kernel.org/userspace-api/landlock.html
int rules_of_files(const Settings& settings) {
  struct {
    std::uint64_t files;
    std::uint64_t network;
    std::uint64_t scope;
  } closed{};
  struct [[gnu::packed]] {
    std::uint64_t allowed;
    std::int32_t parent;
  } rule{};
  constexpr std::uint64_t run = 1u << 0;
  constexpr std::uint64_t read = 1u << 2;
  constexpr std::uint64_t list = 1u << 3;
  constexpr std::uint64_t of_a_file = run | read | (1u << 1) | (1u << 14);
  constexpr std::uint64_t version_question = 1;
  const long version =
      ::syscall(nr_landlock_create_ruleset, nullptr, 0, static_cast<unsigned>(version_question));
  if (version < 1) fail(settings, "closing the files");
  constexpr std::uint64_t everything_at[] = {0x1fff, 0x3fff, 0x7fff, 0x7fff, 0xffff};
  closed.files = everything_at[std::min<long>(version, 5) - 1];
  std::size_t size = 8;
  if (version >= 4) {
    closed.network = 3;
    size = 16;
  }
  if (version >= 6) {
    closed.scope = 3;
    size = 24;
  }
  const int rules = static_cast<int>(::syscall(nr_landlock_create_ruleset, &closed, size, 0));
  if (rules < 0) fail(settings, "closing the files");
  for (const Opened& opened : settings.opened) {
    const int path = ::open(opened.path.c_str(), O_PATH | O_CLOEXEC);
    if (path < 0) continue;
    rule.allowed = read | list;
    if (opened.run) rule.allowed |= run;
    if (opened.write) rule.allowed = closed.files & ~run;
    if (!is_folder(opened.path)) rule.allowed &= of_a_file;
    rule.allowed &= closed.files;
    rule.parent = path;
    if (::syscall(nr_landlock_add_rule, rules, 1, &rule, 0) != 0)
      fail(settings, "opening " + opened.path);
    ::close(path);
  }
  return rules;
}

void close_files(const Settings& settings, int rules) {
  if (::syscall(nr_landlock_restrict_self, rules, 0) != 0) fail(settings, "closing the files");
  ::close(rules);
}

void load_filter(const Settings& settings) {
  std::vector<sock_filter> program;
  sock_filter one{};
  ::lseek(settings.filter, 0, SEEK_SET);
  while (::read(settings.filter, &one, sizeof one) == static_cast<ssize_t>(sizeof one))
    program.push_back(one);
  ::close(settings.filter);
  errno = 0;
  if (program.empty()) fail(settings, "reading the filter of system calls");

  // Other processes of the same user are in sight: a signal may go to the process itself only,
  // which keeps its number through exec.
  const auto own = static_cast<std::uint32_t>(::getpid());
  constexpr auto number_at = static_cast<std::uint32_t>(offsetof(seccomp_data, nr));
  constexpr auto first_argument = static_cast<std::uint32_t>(offsetof(seccomp_data, args));
  constexpr std::uint32_t refuse = SECCOMP_RET_ERRNO | EPERM;
  sock_filter signals[] = {
      {BPF_LD | BPF_W | BPF_ABS, 0, 0, number_at},
      {BPF_JMP | BPF_JEQ | BPF_K, 1, 0, SYS_tgkill},
      {BPF_RET | BPF_K, 0, 0, SECCOMP_RET_ALLOW},
      {BPF_LD | BPF_W | BPF_ABS, 0, 0, first_argument},
      {BPF_JMP | BPF_JEQ | BPF_K, 0, 1, own},
      {BPF_RET | BPF_K, 0, 0, SECCOMP_RET_ALLOW},
      {BPF_RET | BPF_K, 0, 0, refuse},
  };
  const bool whole = settings.program >= 0;
  sock_fprog own_signals{static_cast<unsigned short>(std::size(signals)), signals};
  if (whole && ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &own_signals) != 0)
    fail(settings, "loading the filter of signals");
  sock_fprog filter{static_cast<unsigned short>(program.size()), program.data()};
  if (::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter) != 0)
    fail(settings, "loading the filter of system calls");
}

}  // namespace contact::launcher
