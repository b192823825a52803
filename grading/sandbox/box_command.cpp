#include "box_command.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include <sys/stat.h>
#include <unistd.h>

#include "../book/book.hpp"
#include "headers.hpp"

namespace fs = std::filesystem;

namespace contact::grading {

namespace {

using Words = std::vector<std::string>;

void add(Words& words, std::initializer_list<std::string> more) {
  words.insert(words.end(), more.begin(), more.end());
}

// Programs, libraries and what finds them; the compiler has all of it, others the libraries.
std::vector<fs::path> system_folders(BoxKind kind) {
  std::vector<fs::path> result = {"/usr/lib", "/usr/lib32", "/usr/lib64", "/usr/libx32"};
  if (kind == BoxKind::compile) {
    for (const char* more : {"/usr/bin", "/usr/libexec", "/etc/alternatives"})
      result.emplace_back(more);
  }
  result.emplace_back("/etc/ld.so.cache");
  std::erase_if(result, [](const fs::path& path) { return !fs::exists(path); });
  return result;
}

// Where /lib and the like are still folders of their own they are shown too.
std::vector<fs::path> top_folders(BoxKind kind) {
  std::vector<fs::path> result = {"/lib", "/lib32", "/lib64", "/libx32"};
  if (kind == BoxKind::compile) result.emplace_back("/bin");
  std::erase_if(result, [](const fs::path& path) { return !fs::exists(fs::symlink_status(path)); });
  return result;
}

// What limits and watches a box whether it has namespaces or not.
Words common_words(const Machine& machine, const Seat::State& seat, const BoxGroup* group,
                   const BoxSpec& spec) {
  Words words = {machine.launcher, "--parent", std::to_string(::getpid()), "--report",
                 std::to_string(report_descriptor)};
  if (group != nullptr) {
    for (const std::string& entrance : group->entrances()) add(words, {"--group", entrance});
  }
  for (const auto& [ours, number] : spec.descriptors)
    add(words, {"--keep", std::to_string(number)});
  if (seat.user >= 0) add(words, {"--user", std::to_string(seat.user)});
  const auto megabytes = [](long long count) { return std::to_string(count << 20); };
  add(words, {"--cpu", std::to_string(std::lround(std::ceil(spec.limits.cpu_seconds)))});
  add(words, {"--memory", megabytes(spec.limits.memory_mb)});
  add(words, {"--file-bytes", megabytes(spec.limits.files_mb)});
  add(words, {"--descriptors", spec.kind == BoxKind::compile ? "512" : "64"});
  // The concurrent sandboxes of a seat, and bubblewrap's processes in each, are counted too.
  if (machine.own_process_count)
    add(words, {"--processes", std::to_string(spec.limits.processes + 16)});
  return words;
}

void show_headers(Seat::State& seat, Words& launcher, Words& inside) {
  if (!seat.headers) {
    const SystemHeaders headers = system_headers();
    seat.headers = std::make_unique<TemporaryFolder>();
    copy_headers(headers, seat.headers->path());
    seat.header_folders = headers.folders;
  }
  add(launcher, {"--read", seat.headers->path().string(), "headers"});
  add(inside, {"--ro-bind", "/tmp/headers", "/usr/include"});
  for (const fs::path& folder : seat.header_folders)
    add(inside, {"--ro-bind", folder.string(), folder.string()});
}

void show_system(Seat::State& seat, BoxKind kind, Words& launcher, Words& inside) {
  for (const fs::path& path : system_folders(kind))
    add(inside, {"--ro-bind", path.string(), path.string()});
  for (const fs::path& path : top_folders(kind)) {
    if (fs::is_symlink(path))
      add(inside, {"--symlink", fs::read_symlink(path).string(), path.string()});
    else
      add(inside, {"--ro-bind", path.string(), path.string()});
  }
  if (kind == BoxKind::compile) show_headers(seat, launcher, inside);
  add(inside, {"--dev-bind", "/dev/null", "/dev/null"});
}

// @throws BookError naming the folder that does not let the box's user through
void check_way_to(const fs::path& path, long user) {
  for (fs::path folder = path.parent_path(); folder != folder.root_path();
       folder = folder.parent_path()) {
    struct stat found {};
    if (::stat(folder.c_str(), &found) != 0) continue;
    const bool open = found.st_uid == static_cast<uid_t>(user) ? (found.st_mode & S_IXUSR) != 0
                                                               : (found.st_mode & S_IXOTH) != 0;
    if (!open)
      throw BookError(
          "a box of user " + std::to_string(user) + " cannot reach " + path.string() +
          ", because " + folder.string() +
          " is closed to other users: without namespaces it must be open (chmod o+x), or "
          "the folder must be elsewhere (TMPDIR)");
  }
}

}  // namespace

void PathNames::add(std::string machine, std::string box) {
  names_.emplace_back(std::move(machine), std::move(box));
  // The longest first: one folder may stand in another.
  std::stable_sort(names_.begin(), names_.end(), [](const auto& one, const auto& other) {
    return one.second.size() > other.second.size();
  });
}

void PathNames::add_temporary(std::string machine) { temporary_ = std::move(machine); }

std::string PathNames::in_machine(const std::string& word) const {
  if (word == "/tmp" && !temporary_.empty()) return temporary_;
  for (const auto& [machine, box] : names_) {
    for (std::size_t at = word.find(box); at != std::string::npos; at = word.find(box, at + 1)) {
      const std::size_t end = at + box.size();
      const bool starts =
          at == 0 || word[at - 1] == '=' || word[at - 1] == ',' || (at == 2 && word[0] == '-');
      if (starts && (end == word.size() || word[end] == '/' || word[end] == ','))
        return word.substr(0, at) + machine + word.substr(end);
    }
  }
  return word;
}

std::string PathNames::in_box(std::string text) const {
  const auto replace = [&text](const std::string& machine, const std::string& box) {
    for (std::size_t at = text.find(machine); at != std::string::npos;
         at = text.find(machine, at + box.size()))
      text.replace(at, machine.size(), box);
  };
  for (const auto& [machine, box] : names_) replace(machine, box);
  if (!temporary_.empty()) replace(temporary_, "/tmp");
  return text;
}

std::vector<std::string> command_in_namespaces(const Machine& machine, Seat::State& seat,
                                               const BoxGroup* group, const BoxSpec& spec) {
  Words launcher = common_words(machine, seat, group, spec);
  add(launcher, {"--namespaces", "--status", std::to_string(status_descriptor), "--keep",
                 std::to_string(filter_descriptor)});
  Words inside;
  // First, since what is shown may itself lie in /tmp.
  if (spec.limits.files > 0) {
    add(launcher,
        {"--temporary", std::to_string(static_cast<long long>(spec.limits.files_mb) << 20),
         std::to_string(spec.limits.files), "temporary"});
    add(inside, {"--bind", "/tmp/temporary", "/tmp"});
  }
  if (spec.system) show_system(seat, spec.kind, launcher, inside);
  int count = 0;
  for (const BoxMount& mount : spec.read_only) {
    const std::string name = std::to_string(count++);
    add(launcher, {"--read", mount.host.string(), name});
    add(inside, {"--ro-bind", "/tmp/" + name, mount.box.string()});
  }
  if (!spec.writable.host.empty()) {
    add(launcher, {"--write", spec.writable.host.string(), "writable"});
    add(inside, {"--bind", "/tmp/writable", spec.writable.box.string()});
  }
  if (seat.network >= 0) add(launcher, {"--network", std::to_string(network_descriptor)});
  add(launcher, {"--", machine.bubblewrap, "--unshare-user", "--unshare-all", "--die-with-parent",
                 "--new-session", "--json-status-fd", std::to_string(status_descriptor)});
  // It is already in the seat's empty network.
  if (seat.network >= 0) add(launcher, {"--share-net"});
  // bubblewrap reads it; contact-box only keeps it.
  if (machine.system_call_filter) add(launcher, {"--seccomp", std::to_string(filter_descriptor)});
  launcher.insert(launcher.end(), inside.begin(), inside.end());
  add(launcher, {"--remount-ro", "/", "--chdir", spec.folder.string(), "--"});
  launcher.insert(launcher.end(), spec.command.begin(), spec.command.end());
  return launcher;
}

std::vector<std::string> command_without_namespaces(const Machine& machine, Seat::State& seat,
                                                    const BoxGroup* group, const BoxSpec& spec,
                                                    const PathNames& names,
                                                    const std::string& temporary) {
  // A compiler goes to its files by their paths; other programs are opened before.
  if (spec.kind == BoxKind::compile && seat.user >= 0) {
    for (const BoxMount& mount : spec.read_only) check_way_to(mount.host, seat.user);
    if (!spec.writable.host.empty()) check_way_to(spec.writable.host, seat.user);
  }
  Words words = common_words(machine, seat, group, spec);
  if (machine.closed_files) {
    add(words, {"--close-files"});
    for (const BoxMount& mount : spec.read_only) add(words, {"--open-run", mount.host.string()});
    if (!spec.writable.host.empty()) add(words, {"--open-write", spec.writable.host.string()});
    if (!temporary.empty()) add(words, {"--open-write", temporary});
    if (spec.system) {
      for (const fs::path& path : system_folders(spec.kind))
        add(words, {"--open-run", path.string()});
      for (const fs::path& path : top_folders(spec.kind)) add(words, {"--open-run", path.string()});
      add(words, {"--open-write", "/dev/null"});
      if (spec.kind == BoxKind::compile) {
        if (seat.searched_folders.empty()) seat.searched_folders = searched_folders();
        for (const fs::path& path : seat.searched_folders) add(words, {"--open", path.string()});
      }
    }
  }
  if (machine.system_call_filter) {
    add(words, {"--filter", std::to_string(filter_descriptor)});
    if (spec.kind != BoxKind::compile)
      add(words, {"--program", std::to_string(program_descriptor)});
  }
  add(words, {"--folder", names.in_machine(spec.folder.string()), "--"});
  for (const std::string& word : spec.command) words.push_back(names.in_machine(word));
  return words;
}

}  // namespace contact::grading
