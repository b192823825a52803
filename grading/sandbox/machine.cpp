#include "machine.hpp"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string_view>

#include <sys/syscall.h>
#include <sys/utsname.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include "../book/book.hpp"
#include "cgroup.hpp"
#include "measures.hpp"

namespace fs = std::filesystem;

namespace contact::grading {

namespace {

Level highest_level() {
  const char* text = std::getenv("CONTACT_BOX_LEVEL");
  if (text == nullptr || *text == '\0' || std::string_view(text) == "full") return Level::full;
  if (std::string_view(text) == "reduced") return Level::reduced;
  if (std::string_view(text) == "none") return Level::none;
  throw BookError("CONTACT_BOX_LEVEL is '" + std::string(text) +
                  "'; it must be full, reduced or none");
}

std::string find_bubblewrap() {
  for (const char* folder : {"/usr/bin", "/usr/local/bin", "/bin"}) {
    const fs::path program = fs::path(folder) / "bwrap";
    if (::access(program.c_str(), X_OK) == 0) return program.string();
  }
  return {};
}

bool kernel_can_close_files() {
  constexpr long create_ruleset = 444;
  constexpr unsigned version_question = 1;
  return ::syscall(create_ruleset, nullptr, 0, version_question) >= 1;
}

// Before Linux 5.14 a limit of processes counted all of a user, in whatever namespace.
bool kernel_counts_in_namespaces() {
  utsname system{};
  if (::uname(&system) != 0) return false;
  int major = 0;
  int minor = 0;
  if (std::sscanf(system.release, "%d.%d", &major, &minor) != 2) return false;
  return major > 5 || (major == 5 && minor >= 14);
}

// The best that starts: with namespaces, without them, with nothing but limits.
void find_level(Loop& loop, Machine& machine, Level highest, std::string& why) {
  machine.system_call_filter = highest != Level::none;
  machine.closed_files = highest != Level::none && kernel_can_close_files();
  const auto starts = [&] {
    const std::optional<std::string> said = why_no_box(loop, machine);
    if (said && why.empty()) why = *said;
    return !said;
  };
  if (highest == Level::full && machine.bubblewrap.empty()) {
    why = "bubblewrap is not installed: ./contact setup installs it";
  } else if (highest == Level::full) {
    machine.namespaces = true;
    machine.level = Level::full;
    if (starts()) return;
    machine.namespaces = false;
  } else {
    why = "CONTACT_BOX_LEVEL says so";
  }
  machine.level = Level::reduced;
  if (machine.system_call_filter && (machine.own_user_ids || machine.closed_files) && starts())
    return;
  machine.closed_files = false;
  if (machine.system_call_filter && machine.own_user_ids && starts()) return;
  machine.level = Level::none;
  machine.system_call_filter = false;
  starts();
}

}  // namespace

namespace {

Machine find(Loop& loop, std::string& why) {
  Machine machine;
  const Level highest = highest_level();
  std::error_code error;
  machine.launcher =
      (fs::read_symlink("/proc/self/exe", error).parent_path() / "contact-box").string();
  if (::access(machine.launcher.c_str(), X_OK) != 0)
    throw BookError(machine.launcher + " is not there: ./contact setup builds it");
  machine.bubblewrap = find_bubblewrap();
  machine.own_user_ids = ::geteuid() == 0;
  {
    const BoxGroup group;
    machine.control_groups = group.kind();
    machine.group_pids = group.has_pids();
    machine.group_memory = group.has_memory();
  }
  find_level(loop, machine, highest, why);
  machine.own_process_count =
      machine.own_user_ids || (machine.namespaces && kernel_counts_in_namespaces());
  machine.max_workers = machine.own_process_count || machine.system_call_filter ? 1000 : 1;
  return machine;
}

}  // namespace

Machine find_machine(Loop& loop) {
  std::string why;
  return find(loop, why);
}

Machine examine_machine(Loop& loop) {
  std::string why;
  Machine machine = find(loop, why);
  machine.measures = try_measures(loop, machine, why);
  return machine;
}

std::string_view words(Level level) {
  switch (level) {
    case Level::full:
      return "full";
    case Level::reduced:
      return "reduced";
    case Level::none:
      break;
  }
  return "none";
}

nlohmann::json to_json(const Machine& machine) {
  nlohmann::json measures = nlohmann::json::array();
  for (const Measure& measure : machine.measures)
    measures.push_back(
        {{"what", measure.what}, {"enforced", measure.enforced}, {"how", measure.how}});
  return {{"level", words(machine.level)}, {"measures", measures}};
}

}  // namespace contact::grading
