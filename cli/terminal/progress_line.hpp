#pragma once

// The progress of long work: one line on standard error that is overwritten, on a terminal only.

#include <chrono>
#include <cstddef>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

namespace contact::cli {

/// The line for several concurrent pieces of work. Any thread may report on any piece.
class ProgressLine {
 public:
  /// @param pieces how many; with more than one the line begins with how many of them are done
  explicit ProgressLine(std::size_t pieces);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// Whether to print now: four times a second, and only to a terminal.
  [[nodiscard]] bool due() const;
  /// The progress of a piece of work, in a few words.
  void tell(std::size_t piece, std::string text);
  /// A piece is over: nothing more is said of it.
  void done(std::size_t piece);

 private:
  void write(std::string_view line);

  using Clock = std::chrono::steady_clock;
  bool watched_;
  mutable std::mutex mutex_;
  std::vector<std::string> texts_;
  std::size_t done_ = 0;
  std::size_t width_ = 0;  // of what stands in the line
  Clock::time_point told_;
};

}  // namespace contact::cli
