#include "watch_files.hpp"

#include <algorithm>
#include <fstream>
#include <set>

#include <sys/stat.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/vfs.h>
#endif

namespace fs = std::filesystem;

namespace contact::cli {

namespace {

constexpr std::uint64_t poll_milliseconds = 200;
constexpr std::uint64_t probe_milliseconds = 300;

// File systems on which another machine may write: the kernel here hears nothing of that.
bool is_remote(const fs::path& folder) {
#ifdef __linux__
  struct statfs info {};
  if (::statfs(folder.c_str(), &info) != 0) return false;
  constexpr std::uint32_t nfs = 0x6969, smb = 0x517B, smb2 = 0xFE534D42, cifs = 0xFF534D42,
                          nine_p = 0x01021997, fuse = 0x65735546, ceph = 0x00C36400;
  const auto type = static_cast<std::uint32_t>(info.f_type);
  return type == nfs || type == smb || type == smb2 || type == cifs || type == nine_p ||
         type == fuse || type == ceph;
#else
  (void)folder;
  return false;
#endif
}

}  // namespace

FileState state_of(const fs::path& file) {
  struct stat info {};
  FileState state;
  if (::stat(file.c_str(), &info) != 0) return state;
  state.exists = true;
  state.inode = info.st_ino;
  state.size = static_cast<std::uint64_t>(info.st_size);
#ifdef __APPLE__
  const timespec time = info.st_mtimespec;
#else
  const timespec time = info.st_mtim;
#endif
  state.modified_ns = static_cast<std::int64_t>(time.tv_sec) * 1'000'000'000 + time.tv_nsec;
  return state;
}

struct FileWatcher::Folder {
  FileWatcher* owner = nullptr;
  fs::path path;
  std::string probe;
  bool probe_seen = false;
  bool watched = false;
  bool polled = false;
  uv_fs_event_t event{};
};

FileWatcher::FileWatcher(grading::Loop& loop, std::vector<fs::path> files, bool always_poll,
                         Changed changed)
    : loop_(loop), files_(std::move(files)), changed_(std::move(changed)) {
  std::set<fs::path> paths;
  for (const fs::path& file : files_) {
    paths.insert(file.parent_path());
    states_.push_back(state_of(file));
  }
  uv_timer_init(loop_.get(), &timer_);
  timer_.data = this;
  for (const fs::path& path : paths) {
    folders_.push_back(std::make_unique<Folder>());
    Folder& folder = *folders_.back();
    folder.owner = this;
    folder.path = path;
    folder.polled = always_poll || is_remote(path) || !watch(folder) || !events_arrive(folder);
  }
  if (!polled().empty())
    uv_timer_start(
        &timer_, [](uv_timer_t* timer) { static_cast<FileWatcher*>(timer->data)->poll(); },
        poll_milliseconds, poll_milliseconds);
}

FileWatcher::~FileWatcher() {
  uv_close(reinterpret_cast<uv_handle_t*>(&timer_), nullptr);
  for (const std::unique_ptr<Folder>& folder : folders_) {
    if (folder->watched) uv_close(reinterpret_cast<uv_handle_t*>(&folder->event), nullptr);
  }
  for (int turn = 0; turn < 3; ++turn) uv_run(loop_.get(), UV_RUN_NOWAIT);
}

std::vector<fs::path> FileWatcher::polled() const {
  std::vector<fs::path> result;
  for (const std::unique_ptr<Folder>& folder : folders_) {
    if (folder->polled) result.push_back(folder->path);
  }
  return result;
}

bool FileWatcher::watch(Folder& folder) {
  uv_fs_event_init(loop_.get(), &folder.event);
  folder.watched = true;
  folder.event.data = &folder;
  const auto happened = [](uv_fs_event_t* handle, const char* name, int, int status) {
    auto* self = static_cast<Folder*>(handle->data);
    if (status < 0) return;
    if (name != nullptr && self->probe == name) self->probe_seen = true;
    for (const fs::path& file : self->owner->files_) {
      if (file.parent_path() == self->path && (name == nullptr || file.filename() == name))
        self->owner->changed_(file);
    }
  };
  return uv_fs_event_start(&folder.event, happened, folder.path.c_str(), 0) == 0;
}

// Makes a file and waits to hear of it.
bool FileWatcher::events_arrive(Folder& folder) {
  folder.probe = ".contact-probe-" + std::to_string(::getpid());
  const fs::path file = folder.path / folder.probe;
  { std::ofstream made(file); }
  const std::uint64_t start = uv_hrtime();
  while (!folder.probe_seen && uv_hrtime() - start < probe_milliseconds * 1'000'000) {
    loop_.poll();
    if (!folder.probe_seen) ::usleep(1000);
  }
  std::error_code ignored;
  fs::remove(file, ignored);
  return folder.probe_seen;
}

void FileWatcher::poll() {
  const std::vector<fs::path> folders = polled();
  for (std::size_t i = 0; i < files_.size(); ++i) {
    if (std::find(folders.begin(), folders.end(), files_[i].parent_path()) == folders.end())
      continue;
    const FileState now = state_of(files_[i]);
    if (now == states_[i]) continue;
    states_[i] = now;
    changed_(files_[i]);
  }
}

}  // namespace contact::cli
