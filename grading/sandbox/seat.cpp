#include "seat.hpp"

#include <cerrno>
#include <thread>

#include <fcntl.h>
#include <pwd.h>
#include <sched.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "../book/book.hpp"

namespace fs = std::filesystem;

namespace contact::grading {

namespace {

constexpr long first_user = 64000;
constexpr long last_user = 64999;

// One folder for all programs on the machine. In /tmp any user could have created it, so it must be
// owned by this user and writable by no other.
fs::path lock_folder() {
  for (const fs::path base : {"/run/lock", "/tmp"}) {
    const fs::path folder = base / "contact-hours";
    ::mkdir(folder.c_str(), 0700);
    struct stat found {};
    if (::lstat(folder.c_str(), &found) == 0 && S_ISDIR(found.st_mode) && found.st_uid == 0 &&
        (found.st_mode & 0022) == 0)
      return folder;
  }
  throw BookError(
      "user ids of boxes cannot be locked: neither /run/lock/contact-hours nor "
      "/tmp/contact-hours can be made a folder of root's alone; remove what has that name");
}

bool is_known(long user) {
  errno = 0;
  return ::getpwuid(static_cast<uid_t>(user)) != nullptr;
}

// A thread leaves the network of the others, and what it made outlives it. -1 if it may not.
int empty_network() {
  int network = -1;
  std::thread([&network] {
    if (::unshare(CLONE_NEWNET) == 0)
      network = ::open("/proc/thread-self/ns/net", O_RDONLY | O_CLOEXEC);
  }).join();
  return network;
}

// A lock held as long as it is open; -1 if another process holds it.
int locked(const fs::path& file) {
  const int lock = ::open(file.c_str(), O_CREAT | O_RDWR | O_CLOEXEC | O_NOFOLLOW, 0600);
  if (lock < 0 || ::flock(lock, LOCK_EX | LOCK_NB) == 0) return lock;
  ::close(lock);
  return -1;
}

// A worker keeps to a core, so that what it does at the same time (the linker's threads, the next
// box that is made ready) takes nothing from the worker beside it. With more workers than cores,
// those that come last go where there is room. Holds for this thread and what it starts, as long as
// the lock that is returned is open.
int own_core(const fs::path& folder, cpu_set_t& all) {
  CPU_ZERO(&all);
  if (::sched_getaffinity(0, sizeof all, &all) != 0) return -1;
  for (int core = 0; core < CPU_SETSIZE; ++core) {
    if (!CPU_ISSET(core, &all)) continue;
    const int lock = locked(folder / ("core-" + std::to_string(core)));
    if (lock < 0) continue;
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(core, &one);
    ::sched_setaffinity(0, sizeof one, &one);
    return lock;
  }
  return -1;
}

// A process of that user could be signalled from a box that has no namespaces.
bool has_processes(long user) {
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator("/proc", error)) {
    struct stat found {};
    const std::string name = entry.path().filename().string();
    if (name.find_first_not_of("0123456789") == std::string::npos &&
        ::stat(entry.path().c_str(), &found) == 0 && found.st_uid == static_cast<uid_t>(user))
      return true;
  }
  return false;
}

}  // namespace

Seat::State::~State() {
  groups.clear();
  if (core >= 0) ::sched_setaffinity(0, sizeof cores, &cores);
  for (const int held : {network, lock, core}) {
    if (held >= 0) ::close(held);
  }
}

std::unique_ptr<BoxGroup> Seat::State::take_group(const Machine& machine) {
  if (machine.control_groups == ControlGroups::none) return nullptr;
  if (groups.empty()) return std::make_unique<BoxGroup>();
  std::unique_ptr<BoxGroup> group = std::move(groups.back());
  groups.pop_back();
  return group;
}

Seat::Seat(const Machine& machine) : state_(std::make_unique<State>()) {
  if (!machine.own_user_ids) return;
  if (machine.namespaces) state_->network = empty_network();
  const fs::path folder = lock_folder();
  for (long user = first_user; user <= last_user; ++user) {
    const int lock = locked(folder / std::to_string(user));
    if (lock < 0) continue;
    if (!is_known(user) && !has_processes(user)) {
      state_->user = user;
      state_->lock = lock;
      state_->core = own_core(folder, state_->cores);
      return;
    }
    ::close(lock);
  }
  throw BookError("no user id from " + std::to_string(first_user) + " to " +
                  std::to_string(last_user) + " is free for a box: is another grading under way?");
}

Seat::~Seat() = default;

void Seat::give(const fs::path& path) const {
  if (state_->user < 0) return;
  const auto give_one = [this](const fs::path& what) {
    const auto user = static_cast<uid_t>(state_->user);
    if (::lchown(what.c_str(), user, user) != 0)
      throw BookError("cannot give " + what.string() + " to the user of a box");
  };
  give_one(path);
  if (!fs::is_directory(fs::symlink_status(path))) return;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(path))
    give_one(entry.path());
}

}  // namespace contact::grading
