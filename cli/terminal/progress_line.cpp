#include "progress_line.hpp"

#include <algorithm>
#include <cstdio>

#include <sys/ioctl.h>
#include <unistd.h>

#include "terminal.hpp"

namespace contact::cli {

namespace {

/// As many characters as a line of the terminal on standard error takes without breaking.
std::size_t terminal_width() {
  winsize size{};
  if (::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col < 2) return 79;
  return size.ws_col - 1U;
}

}  // namespace

ProgressLine::ProgressLine(std::size_t pieces)
    : watched_(::isatty(STDERR_FILENO) == 1), texts_(pieces), told_(Clock::now()) {}

ProgressLine::~ProgressLine() {
  if (width_ > 0) write("");
}

bool ProgressLine::due() const {
  if (!watched_) return false;
  const std::lock_guard<std::mutex> lock(mutex_);
  return Clock::now() - told_ >= std::chrono::milliseconds(250);
}

void ProgressLine::tell(std::size_t piece, std::string text) {
  if (!watched_) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  texts_[piece] = std::move(text);
  std::string line;
  if (texts_.size() > 1)
    line = std::to_string(done_) + " of " + std::to_string(texts_.size()) + " done";
  for (const std::string& part : texts_) {
    if (!part.empty()) line += (line.empty() ? "" : "; ") + part;
  }
  write(line);
  told_ = Clock::now();
}

void ProgressLine::done(std::size_t piece) {
  const std::lock_guard<std::mutex> lock(mutex_);
  texts_[piece].clear();
  ++done_;
}

void ProgressLine::write(std::string_view line) {
  const std::string_view seen = line.substr(0, terminal_width());
  const std::string blank(width_ > seen.size() ? width_ - seen.size() : 0, ' ');
  std::fprintf(stderr, "\r%.*s%s%s", static_cast<int>(seen.size()), seen.data(), blank.c_str(),
               seen.empty() ? "\r" : "");
  std::fflush(stderr);
  width_ = seen.size();
}

}  // namespace contact::cli
