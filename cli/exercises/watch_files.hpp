#pragma once

// Tells when files of some folders are saved. Folders are watched, not files: most editors save by
// writing a new file and renaming it over the old one, which a watch on the old file never sees.

#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

#include "../../grading/process/run_process.hpp"

namespace contact::cli {

/// Distinguishes two saved states of a file; two saves within the clock's resolution differ in
/// inode or size.
struct FileState {
  bool exists = false;
  std::uint64_t inode = 0;
  std::uint64_t size = 0;
  std::int64_t modified_ns = 0;
  bool operator==(const FileState&) const = default;
};

FileState state_of(const std::filesystem::path& file);

class FileWatcher {
 public:
  using Changed = std::function<void(const std::filesystem::path& file)>;

  /// Calls `changed` from the loop when one of `files` may have been saved. Polls the folders in
  /// which events do not arrive: a network file system, or one where a file made for the purpose is
  /// not reported.
  FileWatcher(grading::Loop& loop, std::vector<std::filesystem::path> files, bool always_poll,
              Changed changed);
  ~FileWatcher();
  FileWatcher(const FileWatcher&) = delete;
  FileWatcher& operator=(const FileWatcher&) = delete;

  /// Folders that are polled, for the reader to know.
  [[nodiscard]] std::vector<std::filesystem::path> polled() const;

 private:
  struct Folder;
  bool watch(Folder& folder);
  bool events_arrive(Folder& folder);
  void poll();

  grading::Loop& loop_;
  std::vector<std::filesystem::path> files_;
  Changed changed_;
  std::vector<std::unique_ptr<Folder>> folders_;
  std::vector<FileState> states_;
  uv_timer_t timer_{};
};

}  // namespace contact::cli
