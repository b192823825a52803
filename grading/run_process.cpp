#include "run_process.hpp"

#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <optional>
#include <stdexcept>
#include <system_error>

#include <unistd.h>

extern char** environ;

namespace fs = std::filesystem;

namespace contact::grading {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

struct Pipe {
  uv_pipe_t handle{};
  bool open = false;
  int child_end = -1;
  std::array<char, 65536> buffer{};
  std::function<void(std::string_view)> deliver;
};

void close_pipe(Pipe& pipe) {
  if (!pipe.open) return;
  pipe.open = false;
  uv_close(reinterpret_cast<uv_handle_t*>(&pipe.handle), nullptr);
}

void start_reading(Pipe& pipe) {
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
        if (count < 0) close_pipe(*self);
      });
}

std::vector<std::string> environment_with(
    const std::vector<std::pair<std::string, std::string>>& changes) {
  std::vector<std::string> result;
  for (char** entry = environ; *entry != nullptr; ++entry) {
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

// The state of one child while it runs. Its handles live here, so it must not move.
class Child {
 public:
  Child(Loop& loop, const ProcessSpec& spec) : loop_(loop), spec_(spec) {}
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  ~Child() {
    if (started_ && !exited_) kill_group();
    if (started_) uv_close(reinterpret_cast<uv_handle_t*>(&process_), nullptr);
    if (timing_) uv_close(reinterpret_cast<uv_handle_t*>(&timer_), nullptr);
    close_child_ends();
    for (Pipe* pipe : {&output_, &errors_, &events_}) close_pipe(*pipe);
    // Close callbacks run on the loop; the handles must outlive them.
    for (int turn = 0; turn < 3; ++turn) uv_run(loop_.get(), UV_RUN_NOWAIT);
  }

  ProcessResult run() {
    start();
    while (!exited_ && !loop_.interrupted() && !loop_.cancelled()) turn();
    if (loop_.interrupted() || loop_.cancelled()) {
      kill_group();
      // It is gone when the kernel says so, not when the signal is sent.
      const Clock::time_point kill_time = Clock::now();
      while (!exited_ && seconds_since(kill_time) < 2.0) {
        uv_run(loop_.get(), UV_RUN_NOWAIT);
        if (!exited_) uv_sleep(1);
      }
      if (loop_.interrupted()) throw Interrupted{};
      throw Cancelled{};
    }
    // The leader is gone; what it left behind goes too, or it would hold the pipes open.
    kill_group();
    const Clock::time_point exit_time = Clock::now();
    while ((output_.open || errors_.open || events_.open) && seconds_since(exit_time) < 1.0) turn();
    return std::move(result_);
  }

 private:
  void start() {
    std::vector<std::string> arguments = spec_.command;
    std::vector<char*> argument_pointers = pointers(arguments);
    std::vector<std::string> environment = environment_with(spec_.environment);
    std::vector<char*> environment_pointers = pointers(environment);
    const std::string folder = spec_.folder.string();

    std::array<uv_stdio_container_t, 4> stdio{};
    stdio[0].flags = UV_IGNORE;
    int stdio_count = 3;
    if (spec_.inherit) {
      for (int i = 0; i < 3; ++i) {
        stdio[static_cast<std::size_t>(i)].flags = UV_INHERIT_FD;
        stdio[static_cast<std::size_t>(i)].data.fd = i;
      }
    } else {
      open(output_, stdio[1],
           [this](std::string_view text) { keep(result_.output, output_bytes_, text); });
      open(errors_, stdio[2],
           [this](std::string_view text) { keep(result_.errors, error_bytes_, text); });
    }
    if (spec_.on_events) {
      open(events_, stdio[3], spec_.on_events);
      stdio_count = 4;
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
    if (!spec_.inherit) options.flags = UV_PROCESS_DETACHED;
    options.exit_cb = [](uv_process_t* process, std::int64_t code, int signal) {
      auto* self = static_cast<Child*>(process->data);
      self->exited_ = true;
      self->result_.exit_code = static_cast<int>(code);
      self->result_.signal = signal;
      self->result_.seconds = seconds_since(self->start_time_);
    };
    process_.data = this;
    start_time_ = Clock::now();
    started_ = true;
    const int error = uv_spawn(loop_.get(), &process_, &options);
    close_child_ends();
    if (error != 0) {
      exited_ = true;
      throw std::runtime_error("cannot start " + arguments.front() + ": " + uv_strerror(error));
    }
    for (Pipe* pipe : {&output_, &errors_, &events_}) {
      if (pipe->open) start_reading(*pipe);
    }
    start_timer();
  }

  void start_timer() {
    if (spec_.time_limit <= 0.0 && !spec_.watchdog) return;
    uv_timer_init(loop_.get(), &timer_);
    timing_ = true;
    timer_.data = this;
    uv_timer_start(
        &timer_,
        [](uv_timer_t* timer) {
          auto* self = static_cast<Child*>(timer->data);
          if (self->asked_to_end_) {
            if (seconds_since(*self->asked_to_end_) > self->spec_.grace) self->kill_group();
          } else if (self->spec_.time_limit > 0.0 &&
                     seconds_since(self->start_time_) > self->spec_.time_limit)
            self->end(Ended::time);
          else if (self->spec_.watchdog)
            self->end(self->spec_.watchdog(self->process_.pid));
        },
        10, 10);
  }

  // A true pipe, not the socket pair that UV_CREATE_PIPE makes: a socket cannot be opened as
  // /dev/fd/3.
  void open(Pipe& pipe, uv_stdio_container_t& container,
            std::function<void(std::string_view)> deliver) {
    std::array<uv_file, 2> ends{};
    if (const int error = uv_pipe(ends.data(), UV_NONBLOCK_PIPE, 0); error != 0)
      throw std::runtime_error(std::string("cannot make a pipe: ") + uv_strerror(error));
    uv_pipe_init(loop_.get(), &pipe.handle, 0);
    uv_pipe_open(&pipe.handle, ends[0]);
    pipe.handle.data = &pipe;
    pipe.open = true;
    pipe.deliver = std::move(deliver);
    pipe.child_end = ends[1];
    container.flags = UV_INHERIT_FD;
    container.data.fd = ends[1];
  }

  void close_child_ends() {
    for (Pipe* pipe : {&output_, &errors_, &events_}) {
      if (pipe->child_end >= 0) ::close(pipe->child_end);
      pipe->child_end = -1;
    }
  }

  void keep(std::string& kept, std::size_t& bytes, std::string_view text) {
    bytes += text.size();
    if (kept.size() < spec_.output_limit)
      kept.append(text.substr(0, spec_.output_limit - kept.size()));
    if (spec_.output_stop > 0 && bytes > spec_.output_stop) end(Ended::output);
  }

  void end(Ended why) {
    if (why == Ended::by_itself || exited_ || result_.ended != Ended::by_itself) return;
    result_.ended = why;
    if (spec_.grace > 0.0) {
      asked_to_end_ = Clock::now();
      ::kill(-process_.pid, SIGTERM);
    } else {
      kill_group();
    }
  }

  void kill_group() {
    if (process_.pid <= 0) return;
    if (spec_.inherit) {
      if (!exited_) ::kill(process_.pid, SIGTERM);
    } else {
      ::kill(-process_.pid, SIGKILL);
    }
  }

  void turn() { uv_run(loop_.get(), UV_RUN_ONCE); }

  Loop& loop_;
  const ProcessSpec& spec_;
  uv_process_t process_{};
  uv_timer_t timer_{};
  Pipe output_;
  Pipe errors_;
  Pipe events_;
  std::size_t output_bytes_ = 0;
  std::size_t error_bytes_ = 0;
  ProcessResult result_;
  Clock::time_point start_time_;
  std::optional<Clock::time_point> asked_to_end_;
  bool started_ = false;
  bool exited_ = false;
  bool timing_ = false;
};

}  // namespace

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

ProcessResult run_process(Loop& loop, const ProcessSpec& spec) { return Child(loop, spec).run(); }

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
