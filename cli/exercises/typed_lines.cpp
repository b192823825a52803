#include "typed_lines.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <utility>

#include <unistd.h>

#include "../../grading/process/run_process.hpp"
#include "../terminal/terminal.hpp"

namespace contact::cli {

namespace {

volatile std::sig_atomic_t interrupted = 0;

void note_interrupt(int /*signal*/) { interrupted = 1; }

constexpr std::array<int, 3> signals{SIGINT, SIGTERM, SIGHUP};
std::array<struct sigaction, signals.size()> before;

}  // namespace

TypedLines::TypedLines() : terminal_(::isatty(STDIN_FILENO) != 0) {
  struct sigaction action {};
  action.sa_handler = note_interrupt;
  ::sigemptyset(&action.sa_mask);
  // No SA_RESTART: a read that waits must end.
  for (std::size_t i = 0; i < signals.size(); ++i) ::sigaction(signals[i], &action, &before[i]);
}

TypedLines::~TypedLines() {
  for (std::size_t i = 0; i < signals.size(); ++i) ::sigaction(signals[i], &before[i], nullptr);
}

std::optional<std::string> TypedLines::next(const std::string& prompt) {
  std::fputs((prompt + " ").c_str(), stdout);
  std::fflush(stdout);
  std::optional<std::string> line = read();
  if (!terminal_) say(line ? printable(*line) : "");
  if (!line) return line;
  const std::size_t first = line->find_first_not_of(" \t\r");
  if (first == std::string::npos) return std::string();
  return line->substr(first, line->find_last_not_of(" \t\r") - first + 1);
}

std::optional<std::string> TypedLines::read() {
  for (;;) {
    if (const std::size_t end = buffer_.find('\n'); end != std::string::npos) {
      std::string line = buffer_.substr(0, end);
      buffer_.erase(0, end + 1);
      return line;
    }
    if (ended_) {
      if (buffer_.empty()) return {};
      return std::exchange(buffer_, {});
    }
    if (interrupted != 0) throw grading::Interrupted{};
    std::array<char, 4096> bytes{};
    const ssize_t count = ::read(STDIN_FILENO, bytes.data(), bytes.size());
    if (count > 0)
      buffer_.append(bytes.data(), static_cast<std::size_t>(count));
    else if (count == 0 || errno != EINTR)
      ended_ = true;
  }
}

}  // namespace contact::cli
