#include "run_process.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <optional>
#include <stdexcept>
#include <system_error>

#include <sys/ioctl.h>
#include <sys/wait.h>
#include <unistd.h>

#ifdef __linux__
#include <sys/prctl.h>
#endif

extern char** environ;

namespace fs = std::filesystem;

namespace contact::grading {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

struct Pipe {
  Process::State* owner = nullptr;
  uv_pipe_t handle{};
  bool open = false;
  int child_end = -1;
  std::array<char, 65536> buffer{};
  std::function<void(std::string_view)> deliver;
};

std::vector<std::string> environment_with(
    const std::vector<std::pair<std::string, std::string>>& changes, bool clean) {
  std::vector<std::string> result;
  for (char** entry = environ; !clean && *entry != nullptr; ++entry) {
    const std::string_view text(*entry);
    const std::string_view name = text.substr(0, text.find('='));
    bool replaced = false;
    for (const auto& [changed, value] : changes) replaced = replaced || changed == name;
    if (!replaced) result.emplace_back(text);
  }
  for (const auto& [name, value] : changes) result.push_back(name + "=" + value);
  return result;
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> result;
  for (std::string& text : texts) result.push_back(text.data());
  result.push_back(nullptr);
  return result;
}

}  // namespace

// What the loop knows of one child. Its handles must stay where they are until the loop has closed
// them, which may be after the Process is gone; the last to be closed then deletes this.
struct Process::State {
  State(Loop& on, ProcessSpec what) : loop(on), spec(std::move(what)) {}
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  Loop& loop;
  ProcessSpec spec;
  uv_process_t process{};
  uv_timer_t timer{};
  Pipe output;
  Pipe errors;
  Pipe events;
  std::size_t output_bytes = 0;
  std::size_t error_bytes = 0;
  ProcessResult result;
  Clock::time_point start_time;
  Clock::time_point exit_time;
  std::optional<Clock::time_point> asked_to_end;
  int open_handles = 0;
  bool started = false;
  bool exited = false;
  bool ended = false;
  bool released = false;

  void start();
  void start_timer();
  void tick();
  void open(Pipe& pipe, uv_stdio_container_t& container,
            std::function<void(std::string_view)> deliver);
  void start_reading(Pipe& pipe);
  void close_child_ends();
  void close(uv_handle_t* handle);
  void close_pipe(Pipe& pipe);
  void keep(std::string& kept, std::size_t& bytes, std::string_view text);
  void end(Ended why);
  void kill_group() const;
  void end_at_once();
  void settle();
  void release();
};

void Process::State::close(uv_handle_t* handle) {
  handle->data = this;
  uv_close(handle, [](uv_handle_t* closed) {
    auto* self = static_cast<State*>(closed->data);
    --self->open_handles;
    if (self->released && self->open_handles == 0) delete self;
  });
}

void Process::State::close_pipe(Pipe& pipe) {
  if (!pipe.open) return;
  pipe.open = false;
  close(reinterpret_cast<uv_handle_t*>(&pipe.handle));
}

// A true pipe, not the socket pair that UV_CREATE_PIPE makes: a socket cannot be opened as
// /dev/fd/3.
void Process::State::open(Pipe& pipe, uv_stdio_container_t& container,
                          std::function<void(std::string_view)> deliver) {
  std::array<uv_file, 2> ends{};
  if (const int error = uv_pipe(ends.data(), UV_NONBLOCK_PIPE, 0); error != 0)
    throw std::runtime_error(std::string("cannot make a pipe: ") + uv_strerror(error));
  uv_pipe_init(loop.get(), &pipe.handle, 0);
  ++open_handles;
  uv_pipe_open(&pipe.handle, ends[0]);
  pipe.owner = this;
  pipe.handle.data = &pipe;
  pipe.open = true;
  pipe.deliver = std::move(deliver);
  pipe.child_end = ends[1];
  container.flags = UV_INHERIT_FD;
  container.data.fd = ends[1];
}

void Process::State::start_reading(Pipe& pipe) {
  uv_read_start(
      reinterpret_cast<uv_stream_t*>(&pipe.handle),
      [](uv_handle_t* handle, std::size_t, uv_buf_t* buffer) {
        auto* self = static_cast<Pipe*>(handle->data);
        *buffer = uv_buf_init(self->buffer.data(), static_cast<unsigned>(self->buffer.size()));
      },
      [](uv_stream_t* stream, ssize_t count, const uv_buf_t* buffer) {
        auto* self = static_cast<Pipe*>(stream->data);
        if (count > 0)
          self->deliver(std::string_view(buffer->base, static_cast<std::size_t>(count)));
        // The callback may have destroyed the process and so closed this pipe.
        if (count < 0 && self->open) {
          self->owner->close_pipe(*self);
          self->owner->settle();
        }
      });
}

void Process::State::close_child_ends() {
  for (Pipe* pipe : {&output, &errors, &events}) {
    if (pipe->child_end >= 0) ::close(pipe->child_end);
    pipe->child_end = -1;
  }
}

void Process::State::start() {
  std::vector<std::string> arguments = spec.command;
  std::vector<char*> argument_pointers = pointers(arguments);
  std::vector<std::string> environment = environment_with(spec.environment, spec.clean_environment);
  std::vector<char*> environment_pointers = pointers(environment);
  const std::string folder = spec.folder.string();

  int stdio_count = 3;
  if (spec.on_events) stdio_count = std::max(stdio_count, spec.events_descriptor + 1);
  for (const auto& [ours, theirs] : spec.descriptors)
    stdio_count = std::max(stdio_count, theirs + 1);
  std::vector<uv_stdio_container_t> stdio(static_cast<std::size_t>(stdio_count));
  const auto place = [&](int number) -> uv_stdio_container_t& {
    return stdio[static_cast<std::size_t>(number)];
  };
  for (uv_stdio_container_t& container : stdio) container.flags = UV_IGNORE;
  if (spec.inherit) {
    for (int i = 0; i < 3; ++i) {
      place(i).flags = UV_INHERIT_FD;
      place(i).data.fd = i;
    }
  } else {
    open(output, place(1), [this](std::string_view text) {
      if (spec.on_output) spec.on_output(text);
      keep(result.output, output_bytes, text);
    });
    open(errors, place(2),
         [this](std::string_view text) { keep(result.errors, error_bytes, text); });
  }
  if (spec.on_events) open(events, place(spec.events_descriptor), spec.on_events);
  for (const auto& [ours, theirs] : spec.descriptors) {
    place(theirs).flags = UV_INHERIT_FD;
    place(theirs).data.fd = ours;
  }

  uv_process_options_t options{};
  options.file = arguments.front().c_str();
  options.args = argument_pointers.data();
  options.env = environment_pointers.data();
  if (!folder.empty()) options.cwd = folder.c_str();
  options.stdio = stdio.data();
  options.stdio_count = stdio_count;
  // A group of its own; one that shares the terminal must stay in ours, or it could not be
  // interrupted from there.
  if (!spec.inherit) options.flags = UV_PROCESS_DETACHED;
  options.exit_cb = [](uv_process_t* child, std::int64_t code, int signal) {
    auto* self = static_cast<State*>(child->data);
    self->exited = true;
    self->exit_time = Clock::now();
    self->result.exit_code = static_cast<int>(code);
    self->result.signal = signal;
    self->result.seconds = seconds_since(self->start_time);
    // The leader is gone; what it left behind goes too, or it would hold the pipes open.
    self->kill_group();
    self->start_timer();
    self->settle();
  };
  process.data = this;
  start_time = Clock::now();
  started = true;
  ++open_handles;
  const int error = uv_spawn(loop.get(), &process, &options);
  close_child_ends();
  if (error != 0) {
    exited = true;
    throw std::runtime_error("cannot start " + arguments.front() + ": " + uv_strerror(error));
  }
  for (Pipe* pipe : {&output, &errors, &events}) {
    if (pipe->open) start_reading(*pipe);
  }
  if (spec.time_limit > 0.0 || spec.watchdog) start_timer();
}

void Process::State::start_timer() {
  if (timer.loop != nullptr) return;
  uv_timer_init(loop.get(), &timer);
  ++open_handles;
  timer.data = this;
  uv_timer_start(
      &timer, [](uv_timer_t* rung) { static_cast<State*>(rung->data)->tick(); }, 10, 10);
}

void Process::State::tick() {
  if (exited)
    settle();
  else if (asked_to_end) {
    if (seconds_since(*asked_to_end) > spec.grace) kill_group();
  } else if (spec.time_limit > 0.0 && seconds_since(start_time) > spec.time_limit)
    end(Ended::time);
  else if (spec.watchdog)
    end(spec.watchdog(process.pid));
}

// Once it has exited and its pipes are empty, or held open by something that left the group, it has
// ended. Nothing may follow a call of this, because the callback may destroy the process.
void Process::State::settle() {
  if (!exited || ended) return;
  if ((output.open || errors.open || events.open) && seconds_since(exit_time) < 1.0) return;
  for (Pipe* pipe : {&output, &errors, &events}) close_pipe(*pipe);
  if (timer.loop != nullptr) uv_timer_stop(&timer);
  ended = true;
  if (spec.on_end) spec.on_end();
}

void Process::State::keep(std::string& kept, std::size_t& bytes, std::string_view text) {
  bytes += text.size();
  result.bytes_printed = output_bytes + error_bytes;
  const bool passed_on = &kept == &result.output && spec.on_output;
  if (!passed_on && kept.size() < spec.output_limit)
    kept.append(text.substr(0, spec.output_limit - kept.size()));
  const std::size_t counted = spec.output_in_all ? output_bytes + error_bytes : bytes;
  if (spec.output_stop > 0 && counted > spec.output_stop) end(Ended::output);
}

void Process::State::end(Ended why) {
  if (why == Ended::by_itself || exited || result.ended != Ended::by_itself) return;
  result.ended = why;
  if (spec.grace > 0.0) {
    asked_to_end = Clock::now();
    start_timer();
    ::kill(-process.pid, SIGTERM);
  } else {
    kill_group();
  }
}

void Process::State::kill_group() const {
  if (process.pid <= 0) return;
  if (spec.inherit) {
    if (!exited) ::kill(process.pid, SIGTERM);
  } else {
    ::kill(-process.pid, SIGKILL);
  }
}

// It is gone when the kernel says so, not when the signal is sent.
void Process::State::end_at_once() {
  bool asked = spec.keeps_others && process.pid > 0;
  if (asked)
    ::kill(-process.pid, SIGTERM);
  else
    kill_group();
  const Clock::time_point kill_time = Clock::now();
  while (!exited && seconds_since(kill_time) < 2.0 + spec.grace) {
    if (asked && seconds_since(kill_time) > spec.grace) {
      asked = false;
      kill_group();
    }
    int status = 0;
    if (::waitpid(process.pid, &status, WNOHANG) != 0) {
      exited = true;
      result.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
      result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 0;
    } else {
      uv_sleep(1);
    }
  }
}

void Process::State::release() {
  if (started && !exited) end_at_once();
  if (started) close(reinterpret_cast<uv_handle_t*>(&process));
  if (timer.loop != nullptr) close(reinterpret_cast<uv_handle_t*>(&timer));
  close_child_ends();
  for (Pipe* pipe : {&output, &errors, &events}) close_pipe(*pipe);
  released = true;
  if (open_handles == 0) delete this;
}

Process::Process(Loop& loop, ProcessSpec spec) : state_(new State(loop, std::move(spec))) {
  try {
    state_->start();
  } catch (...) {
    state_->release();
    throw;
  }
}

Process::~Process() { state_->release(); }

int Process::pid() const { return state_->process.pid; }

bool Process::ended() const { return state_->ended; }

bool Process::has_unread_output() const {
  for (const Pipe* pipe : {&state_->output, &state_->errors, &state_->events}) {
    uv_os_fd_t descriptor = -1;
    int bytes = 0;
    if (pipe->open &&
        uv_fileno(reinterpret_cast<const uv_handle_t*>(&pipe->handle), &descriptor) == 0 &&
        ::ioctl(descriptor, FIONREAD, &bytes) == 0 && bytes > 0)
      return true;
  }
  return false;
}

void Process::end(Ended why) { state_->end(why); }

ProcessResult Process::wait() {
  Loop& loop = state_->loop;
  while (!state_->ended && !loop.interrupted() && !loop.cancelled())
    uv_run(loop.get(), UV_RUN_ONCE);
  if (!state_->ended) {
    state_->end_at_once();
    if (loop.interrupted()) throw Interrupted{};
    throw Cancelled{};
  }
  return std::move(state_->result);
}

Loop::Loop() {
  uv_loop_init(&loop_);
  constexpr std::array<int, 3> numbers{SIGINT, SIGTERM, SIGHUP};
  for (std::size_t i = 0; i < signals_.size(); ++i) {
    uv_signal_init(&loop_, &signals_[i]);
    signals_[i].data = this;
    uv_signal_start(
        &signals_[i],
        [](uv_signal_t* signal, int) { static_cast<Loop*>(signal->data)->interrupt(); },
        numbers[i]);
    uv_unref(reinterpret_cast<uv_handle_t*>(&signals_[i]));
  }
}

Loop::~Loop() {
  for (uv_signal_t& signal : signals_) uv_close(reinterpret_cast<uv_handle_t*>(&signal), nullptr);
  uv_run(&loop_, UV_RUN_DEFAULT);
  uv_loop_close(&loop_);
}

void Loop::run_once() {
  uv_run(&loop_, UV_RUN_ONCE);
  if (interrupted_) throw Interrupted{};
}

void Loop::poll() {
  uv_run(&loop_, UV_RUN_NOWAIT);
  if (interrupted_) throw Interrupted{};
}

ProcessResult run_process(Loop& loop, const ProcessSpec& spec) {
  return Process(loop, spec).wait();
}

double processor_seconds(int pid) {
#ifdef __linux__
  clockid_t clock{};
  timespec time{};
  if (clock_getcpuclockid(pid, &clock) != 0 || clock_gettime(clock, &time) != 0) return -1.0;
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
#else
  (void)pid;
  return -1.0;
#endif
}

void end_with_parent(int parent) {
#ifdef __linux__
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
  // It may have ended before the kernel was asked.
  if (::getppid() != parent) std::_Exit(128 + SIGKILL);
}

TemporaryFolder::TemporaryFolder() {
  std::string pattern = (fs::temp_directory_path() / "contact-XXXXXX").string();
  if (::mkdtemp(pattern.data()) == nullptr)
    throw std::system_error(errno, std::generic_category(),
                            "cannot make a folder in " + fs::temp_directory_path().string());
  path_ = pattern;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

}  // namespace contact::grading
