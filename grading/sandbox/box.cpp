#include "box.hpp"

#include <algorithm>
#include <csignal>
#include <fstream>
#include <optional>
#include <sstream>

#include <sys/mman.h>
#include <unistd.h>

#include "../book/book.hpp"
#include "box_command.hpp"
#include "filter.hpp"
#include "idle.hpp"
#include "seat.hpp"

namespace fs = std::filesystem;

namespace contact::grading {

namespace {

// The filter as a file without a name, which the loader reads from its start.
class FilterFile {
 public:
  explicit FilterFile(const std::string& code)
      : descriptor_(::memfd_create("filter", MFD_CLOEXEC)) {
    if (descriptor_ < 0 ||
        ::write(descriptor_, code.data(), code.size()) != static_cast<ssize_t>(code.size()) ||
        ::lseek(descriptor_, 0, SEEK_SET) != 0)
      throw BookError("the filter of system calls cannot be handed on");
  }
  ~FilterFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  FilterFile(const FilterFile&) = delete;
  FilterFile& operator=(const FilterFile&) = delete;
  [[nodiscard]] int descriptor() const { return descriptor_; }

 private:
  int descriptor_;
};

// What contact-box and bubblewrap say on the way, one line each.
struct Report {
  std::string text;
  std::string failure;
  bool command_started = false;
  bool complete = false;
  bool by_signal = false;
  int status = 0;
  double cpu_seconds = 0.0;

  void read() {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      if (line.rfind("failed ", 0) == 0) failure = line.substr(7);
      if (line.rfind('{', 0) == 0 && line.find("\"exit-code\"") != std::string::npos)
        command_started = true;
      if (line.rfind("ended ", 0) != 0) continue;
      std::istringstream words(line.substr(6));
      std::string how;
      long long microseconds = 0;
      words >> how >> status >> microseconds;
      complete = !words.fail();
      by_signal = how == "signal";
      cpu_seconds = 1e-6 * static_cast<double>(microseconds);
    }
  }
};

// Seconds of processor time of a process and all below it, those that have ended included.
double family_seconds(int pid) {
  std::ifstream stat("/proc/" + std::to_string(pid) + "/stat");
  std::string text;
  std::getline(stat, text);
  const std::size_t name_end = text.rfind(')');
  if (name_end == std::string::npos) return 0.0;
  std::istringstream fields(text.substr(name_end + 1));
  std::string skipped;
  for (int field = 3; field < 14; ++field) fields >> skipped;
  double ticks = 0.0;
  for (int field = 14; field < 18; ++field) {
    double value = 0.0;
    fields >> value;
    ticks += value;
  }
  double seconds = ticks / static_cast<double>(::sysconf(_SC_CLK_TCK));
  std::ifstream children("/proc/" + std::to_string(pid) + "/task/" + std::to_string(pid) +
                         "/children");
  for (int child = 0; children >> child;) seconds += family_seconds(child);
  return seconds;
}

}  // namespace

struct Box::State {
  State(const Machine& on, const Seat& from, BoxSpec what)
      : machine(on), seat(from), spec(std::move(what)) {}
  ~State() {
    process.reset();
    if (!group) return;
    group->end_all();
    seat.state().groups.push_back(std::move(group));
  }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  const Machine& machine;
  const Seat& seat;
  BoxSpec spec;
  std::unique_ptr<BoxGroup> group;
  std::unique_ptr<TemporaryFolder> temporary;
  PathNames names;
  Report report;
  double cpu_seconds = 0.0;
  int turns = 0;
  IdleClock idle;
  std::unique_ptr<Process> process;

  void start(Loop& loop);
  [[nodiscard]] std::vector<std::string> command();
  [[nodiscard]] bool in_namespaces() const { return machine.namespaces; }
  void measure(int pid);
  [[nodiscard]] Ended limit_met(int pid);
  void finish(BoxEnd& end);
};

std::vector<std::string> Box::State::command() {
  if (in_namespaces()) return command_in_namespaces(machine, seat.state(), group.get(), spec);
  for (const BoxMount& mount : spec.read_only) names.add(mount.host.string(), mount.box.string());
  if (!spec.writable.host.empty())
    names.add(spec.writable.host.string(), spec.writable.box.string());
  if (spec.kind != BoxKind::answer && spec.limits.files > 0) {
    temporary = std::make_unique<TemporaryFolder>();
    seat.give(temporary->path());
    names.add_temporary(temporary->path().string());
  }
  return command_without_namespaces(machine, seat.state(), group.get(), spec, names,
                                    temporary ? temporary->path().string() : "");
}

void Box::State::start(Loop& loop) {
  group = seat.state().take_group(machine);
  if (group)
    group->prepare(spec.limits.memory_mb + spec.limits.files_mb + 16, spec.limits.processes);
  ProcessSpec started;
  started.command = command();
  started.clean_environment = true;
  // A compiler looks for its linker there.
  if (spec.kind == BoxKind::compile) started.environment.emplace_back("PATH", "/usr/bin:/bin");
  for (const auto& [name, value] : spec.environment)
    started.environment.emplace_back(name, names.in_machine(value));
  if (temporary) started.environment.emplace_back("TMPDIR", temporary->path().string());
  started.descriptors = spec.descriptors;
  std::optional<FilterFile> filter;
  if (machine.system_call_filter) {
    const bool alone = !in_namespaces() && spec.kind != BoxKind::compile;
    filter.emplace(filter_of({spec.kind, spec.kind == BoxKind::compile || spec.limits.processes > 1,
                              in_namespaces(), alone ? program_descriptor : -1}));
    started.descriptors.emplace_back(filter->descriptor(), filter_descriptor);
  }
  if (in_namespaces() && seat.state().network >= 0)
    started.descriptors.emplace_back(seat.state().network, network_descriptor);
  started.time_limit = spec.limits.wall_seconds;
  started.output_limit = spec.limits.output_bytes;
  started.output_stop = spec.limits.output_bytes;
  started.output_in_all = true;
  started.on_output = spec.on_output;
  started.on_events = [this](std::string_view text) { report.text += text; };
  started.events_descriptor = report_descriptor;
  started.on_end = spec.on_end;
  started.watchdog = [this](int pid) {
    // Every other tick, which comes each hundredth of a second.
    if (++turns % 2 == 0) measure(pid);
    return limit_met(pid);
  };
  started.grace = 2.0;
  started.keeps_others = true;
  process = std::make_unique<Process>(loop, std::move(started));
}

void Box::State::measure(int pid) {
  if (group && group->has_clock())
    cpu_seconds = group->cpu_seconds();
  else
    cpu_seconds = std::max(cpu_seconds, family_seconds(pid));
}

Ended Box::State::limit_met(int pid) {
  if (cpu_seconds > spec.limits.cpu_seconds) return Ended::time;
  if (spec.limits.idle_seconds <= 0.0) return Ended::by_itself;
  idle.sample({pid}, [this] { return process->has_unread_output(); });
  return idle.seconds() > spec.limits.idle_seconds ? Ended::idle : Ended::by_itself;
}

void Box::State::finish(BoxEnd& end) {
  report.read();
  measure(0);
  end.cpu_seconds = std::max(cpu_seconds, report.cpu_seconds);
  end.out_of_memory = group && group->out_of_memory();
  end.process.output = names.in_box(std::move(end.process.output));
  end.process.errors = names.in_box(std::move(end.process.errors));
  const bool asked_to_end = end.process.ended != Ended::by_itself;
  if (!report.failure.empty() && !asked_to_end)
    throw BookError("a box could not be started: " + report.failure);
  if (!report.complete) {
    if (!asked_to_end) throw BookError("a box was ended from outside");
    end.process.exit_code = 0;
    end.process.signal = SIGKILL;
    return;
  }
  if (in_namespaces() && !report.command_started && !asked_to_end && !end.out_of_memory) {
    // A submission may be linked such that no kernel starts it; then its box was there.
    if (spec.kind != BoxKind::answer || !end.process.errors.starts_with("bwrap: execvp "))
      throw BookError("a box could not be started: " + end.process.errors);
    end.process.signal = 0;
    end.process.exit_code = not_started;
    end.process.errors.clear();
    end.process.bytes_printed = 0;
    return;
  }
  // bubblewrap says as a shell does that a signal ended the command.
  const bool in_code = in_namespaces() && !report.by_signal && report.status > 128 &&
                       report.status <= 128 + SIGRTMAX;
  end.process.signal = report.by_signal ? report.status : in_code ? report.status - 128 : 0;
  end.process.exit_code = end.process.signal != 0 ? 0 : report.status;
  // The kernel counts whole seconds of processor time and ends by a signal of its own, which a
  // compiler tells in its own way.
  if (!asked_to_end && !end.process.succeeded() && end.cpu_seconds >= spec.limits.cpu_seconds)
    end.process.ended = Ended::time;
  if (!asked_to_end && end.process.signal == SIGXCPU) end.process.ended = Ended::time;
}

Box::Box(Loop& loop, const Machine& machine, const Seat& seat, BoxSpec spec)
    : state_(std::make_unique<State>(machine, seat, std::move(spec))) {
  state_->start(loop);
}

Box::~Box() = default;

bool Box::ended() const { return state_->process->ended(); }

double Box::cpu_seconds() const {
  if (!ended()) state_->measure(state_->process->pid());
  return state_->cpu_seconds;
}

int Box::pid() const { return state_->process->pid(); }

bool Box::has_unread_output() const { return state_->process->has_unread_output(); }

void Box::end(Ended why) { state_->process->end(why); }

BoxEnd Box::wait() {
  BoxEnd end;
  end.process = state_->process->wait();
  state_->finish(end);
  return end;
}

BoxEnd run_box(Loop& loop, const Machine& machine, const Seat& seat, BoxSpec spec) {
  return Box(loop, machine, seat, std::move(spec)).wait();
}

}  // namespace contact::grading
