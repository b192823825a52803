#include "machine.hpp"

#include <array>
#include <cstdlib>
#include <functional>
#include <optional>
#include <string_view>

#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include "../book.hpp"
#include "box.hpp"
#include "cgroup.hpp"

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

// Tries things in boxes.
class Examiner {
 public:
  Examiner(Loop& loop, const Machine& machine) : loop_(loop), machine_(machine), seat_(machine) {}

  [[nodiscard]] BoxSpec spec(std::vector<std::string> probe, BoxKind kind = BoxKind::answer) const {
    BoxSpec spec;
    spec.kind = kind;
    spec.command = {"/probe", "--probe"};
    spec.command.insert(spec.command.end(), probe.begin(), probe.end());
    spec.read_only = {{machine_.launcher, "/probe"}};
    spec.limits.cpu_seconds = 2.0;
    spec.limits.wall_seconds = 10.0;
    spec.limits.memory_mb = 64;
    spec.limits.files_mb = 1;
    spec.limits.files = 8;
    return spec;
  }
  BoxEnd run(BoxSpec spec) { return run_box(loop_, machine_, seat_, std::move(spec)); }

  /// Whether the attempt was stopped.
  bool kept_from(const BoxSpec& spec) {
    const BoxEnd end = run(spec);
    return end.process.exit_code == 0 || end.process.signal != 0;
  }
  bool kept_from(std::vector<std::string> probe) { return kept_from(spec(std::move(probe))); }

 private:
  Loop& loop_;
  const Machine& machine_;
  Seat seat_;
};

// Somebody listens here who would be reached if the network were in sight.
class Listener {
 public:
  Listener() : socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    address_.sin_family = AF_INET;
    address_.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address_;
    if (socket_ >= 0 &&
        ::bind(socket_, reinterpret_cast<const sockaddr*>(&address_), sizeof address_) == 0 &&
        ::listen(socket_, 1) == 0)
      ::getsockname(socket_, reinterpret_cast<sockaddr*>(&address_), &size);
  }
  ~Listener() {
    if (socket_ >= 0) ::close(socket_);
  }
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;
  [[nodiscard]] std::string port() const { return std::to_string(ntohs(address_.sin_port)); }

 private:
  int socket_;
  sockaddr_in address_{};
};

// Whether a box of that kind starts at all; what was said if not.
std::optional<std::string> refusal(Loop& loop, const Machine& machine) {
  try {
    Examiner examiner(loop, machine);
    const BoxEnd end = examiner.run(examiner.spec({"nothing"}));
    if (end.process.succeeded()) return std::nullopt;
    return "a box that does nothing ended with code " + std::to_string(end.process.exit_code) +
           " and signal " + std::to_string(end.process.signal);
  } catch (const BookError& error) {
    return error.what();
  }
}

// The best that starts: with namespaces, without them, with nothing but limits.
void find_level(Loop& loop, Machine& machine, Level highest, std::string& why) {
  machine.system_call_filter = highest != Level::none;
  machine.closed_files = highest != Level::none && kernel_can_close_files();
  const auto starts = [&] {
    const std::optional<std::string> said = refusal(loop, machine);
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

Machine examine_machine(Loop& loop) {
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
  std::string why;
  find_level(loop, machine, highest, why);
  if (!why.empty()) machine.measures.push_back({"namespaces of its own", false, why});
  machine.most_workers = machine.own_user_ids || machine.system_call_filter ? 1000 : 1;
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
