#include "cgroup.hpp"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include <fcntl.h>
#include <unistd.h>

namespace fs = std::filesystem;

namespace contact::grading {

namespace {

std::string read_all(const fs::path& file) {
  std::ifstream stream(file);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

// One write, and whether the kernel took it.
bool write(const fs::path& file, const std::string& text) {
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor < 0) return false;
  const bool taken = ::write(descriptor, text.data(), text.size()) >= 0;
  return ::close(descriptor) == 0 && taken;
}

// "key number" lines.
double value_of(const std::string& text, const std::string& key) {
  std::istringstream lines(text);
  std::string word;
  double value = 0.0;
  while (lines >> word >> value) {
    if (word == key) return value;
  }
  return 0.0;
}

bool lists(const std::string& words, const std::string& wanted, char separator) {
  std::istringstream stream(words);
  for (std::string word; std::getline(stream, word, separator);) {
    while (!word.empty() && word.back() == '\n') word.pop_back();
    if (word == wanted) return true;
  }
  return false;
}

// A mounted hierarchy and the group of it that this program is in.
struct Hierarchy {
  fs::path top;
  fs::path own;
};

// Where a hierarchy is mounted, and which part of it that shows: a container sees a part only.
std::optional<Hierarchy> hierarchy(const std::string& controller) {
  std::string own;
  std::istringstream groups(read_all("/proc/self/cgroup"));
  for (std::string line; std::getline(groups, line);) {
    const std::size_t first = line.find(':');
    const std::size_t second = line.find(':', first + 1);
    if (second == std::string::npos) continue;
    const std::string controllers = line.substr(first + 1, second - first - 1);
    if (controller.empty() ? controllers.empty() : lists(controllers, controller, ','))
      own = line.substr(second + 1);
  }
  if (own.empty()) return std::nullopt;
  std::istringstream mounts(read_all("/proc/self/mountinfo"));
  for (std::string line; std::getline(mounts, line);) {
    std::istringstream words(line);
    std::string id, parent, device, root, point, word, type, source, options;
    words >> id >> parent >> device >> root >> point;
    while (words >> word && word != "-") {
    }
    words >> type >> source >> options;
    if (controller.empty() ? type != "cgroup2"
                           : type != "cgroup" || !lists(options, controller, ','))
      continue;
    if (root != "/") {
      if (own.compare(0, root.size(), root) != 0) continue;
      own = own.substr(root.size());
    }
    return Hierarchy{point, fs::path(point + "/" + own).lexically_normal()};
  }
  return std::nullopt;
}

// Ends whatever is in a group.
void end_all_in(const fs::path& folder) {
  for (int turn = 0; turn < 100; ++turn) {
    std::istringstream processes(read_all(folder / "cgroup.procs"));
    int process = 0;
    bool any = false;
    while (processes >> process) any = (process > 0 && ::kill(process, SIGKILL) == 0) || any;
    if (!any) return;
    ::usleep(500);
  }
}

void remove_group(const fs::path& folder) {
  end_all_in(folder);
  // What was just ended may still be on its way out.
  for (int turn = 0; turn < 200 && ::rmdir(folder.c_str()) != 0 && errno == EBUSY; ++turn)
    ::usleep(1000);
}

// Groups of a program that was killed are still there, perhaps with something in them.
void sweep(const fs::path& beside) {
  std::error_code error;
  std::vector<fs::path> left;
  for (const fs::directory_entry& entry : fs::directory_iterator(beside, error)) {
    const std::string name = entry.path().filename().string();
    int owner = 0;
    if (std::sscanf(name.c_str(), "contact-hours-%d-", &owner) == 1 && owner > 0 &&
        ::kill(owner, 0) != 0 && errno == ESRCH)
      left.push_back(entry.path());
  }
  for (const fs::path& folder : left) remove_group(folder);
}

bool make_folder(const fs::path& folder) {
  std::error_code error;
  return fs::create_directory(folder, error) && !error;
}

}  // namespace

BoxGroup::BoxGroup() {
  const std::string name = next_name();
  make_v1(name);
  if (kind_ == ControlGroups::none) make_v2(name);
}

BoxGroup::~BoxGroup() {
  for (const fs::path& folder : folders()) remove_group(folder);
}

void BoxGroup::make_v1(const std::string& name) {
  const auto make = [&](const char* controller, const char* file, const char* probe,
                        fs::path& place) {
    const std::optional<Hierarchy> found = hierarchy(controller);
    if (!found) return;
    sweep(found->own);
    if (!make_folder(found->own / name)) return;
    place = found->own / name;
    if (*probe != '\0' && !write(place / file, probe)) {
      ::rmdir(place.c_str());
      place.clear();
    }
  };
  make("memory", "memory.limit_in_bytes", "1073741824", memory_);
  make("pids", "pids.max", "64", pids_);
  if (const auto both = hierarchy("cpuacct");
      both && !memory_.empty() && both->own / name == memory_)
    clock_ = memory_;
  else
    make("cpuacct", "", "", clock_);
  if (!folders().empty()) kind_ = ControlGroups::v1;
}

// A group that contains processes cannot give controllers to groups below it, so the nearest
// ancestor that can is taken. If a group contains only this program, moving the program into a
// child group enables it.
void BoxGroup::make_v2(const std::string& name) {
  const std::optional<Hierarchy> found = hierarchy("");
  if (!found) return;
  const auto gives = [](const fs::path& group, const char* controller) {
    if (lists(read_all(group / "cgroup.subtree_control"), controller, ' ')) return true;
    return lists(read_all(group / "cgroup.controllers"), controller, ' ') &&
           write(group / "cgroup.subtree_control", std::string("+") + controller);
  };
  const fs::path own = found->own;
  if (read_all(own / "cgroup.procs") == std::to_string(::getpid()) + "\n" &&
      !lists(read_all(own / "cgroup.subtree_control"), "memory", ' ')) {
    const fs::path below = own / "contact-hours";
    if (make_folder(below) && !write(below / "cgroup.procs", "0")) ::rmdir(below.c_str());
  }
  fs::path group = own;
  for (;; group = group.parent_path()) {
    const bool memory = gives(group, "memory");
    const bool pids = gives(group, "pids");
    if (memory || pids) sweep(group);
    if ((memory || pids) && make_folder(group / name)) {
      const fs::path place = group / name;
      if (::access((place / "cgroup.procs").c_str(), W_OK) == 0 &&
          ::access((group / "cgroup.procs").c_str(), W_OK) == 0) {
        kind_ = ControlGroups::v2;
        clock_ = place;
        if (memory) memory_ = place;
        if (pids) pids_ = place;
        return;
      }
      ::rmdir(place.c_str());
    }
    if (group == found->top || group == group.root_path()) return;
  }
}

std::vector<fs::path> BoxGroup::folders() const {
  std::vector<fs::path> result;
  for (const fs::path& folder : {pids_, memory_, clock_}) {
    if (!folder.empty() && std::find(result.begin(), result.end(), folder) == result.end())
      result.push_back(folder);
  }
  return result;
}

std::vector<std::string> BoxGroup::entrances() const {
  // The process that enters has one thread and writes its own thread id. The kernel moves a thread
  // at once; to move a process it first waits about ten milliseconds until no other can be forking.
  const char* file = kind_ == ControlGroups::v1 ? "tasks" : "cgroup.procs";
  std::vector<std::string> result;
  for (const fs::path& folder : folders()) result.push_back((folder / file).string());
  return result;
}

void BoxGroup::prepare(int memory_mb, int processes) {
  const std::string bytes = std::to_string(static_cast<long long>(memory_mb) << 20);
  if (kind_ == ControlGroups::v1) {
    // Memory and swap together may not be less than memory alone, so whichever grows goes first.
    for (int turn = 0; turn < 2 && has_memory(); ++turn) {
      write(memory_ / "memory.memsw.limit_in_bytes", bytes);
      write(memory_ / "memory.limit_in_bytes", bytes);
    }
  } else if (has_memory()) {
    write(memory_ / "memory.max", bytes);
    write(memory_ / "memory.swap.max", "0");
  }
  // Those that start the box are counted too: two of bubblewrap's.
  if (has_pids()) write(pids_ / "pids.max", std::to_string(processes + 2));
  clock_before_ = clock();
  kills_before_ = memory_kills();
}

double BoxGroup::clock() const {
  if (clock_.empty()) return 0.0;
  if (kind_ == ControlGroups::v2)
    return 1e-6 * value_of(read_all(clock_ / "cpu.stat"), "usage_usec");
  return 1e-9 * std::strtod(read_all(clock_ / "cpuacct.usage").c_str(), nullptr);
}

long BoxGroup::memory_kills() const {
  if (memory_.empty()) return 0;
  const char* file = kind_ == ControlGroups::v2 ? "memory.events" : "memory.oom_control";
  return static_cast<long>(value_of(read_all(memory_ / file), "oom_kill"));
}

double BoxGroup::cpu_seconds() const { return clock() - clock_before_; }

bool BoxGroup::out_of_memory() const { return memory_kills() > kills_before_; }

void BoxGroup::end_all() const {
  for (const fs::path& folder : folders()) end_all_in(folder);
}

std::string BoxGroup::next_name() {
  static std::atomic<int> count{0};
  return "contact-hours-" + std::to_string(::getpid()) + "-" + std::to_string(count++);
}

}  // namespace contact::grading
