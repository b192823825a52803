#include "submission.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <memory>
#include <set>

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace fs = std::filesystem;

namespace contact::grading {

namespace {

constexpr int deepest = 32;

std::vector<std::string> parts_of(const std::string& path) {
  std::vector<std::string> parts;
  std::size_t start = 0;
  while (start <= path.size()) {
    const std::size_t end = std::min(path.find('/', start), path.size());
    const std::string part = path.substr(start, end - start);
    if (!part.empty() && part != ".") parts.push_back(part);
    start = end + 1;
  }
  return parts;
}

std::string joined(const std::vector<std::string>& parts) {
  std::string path;
  for (const std::string& part : parts) path += (path.empty() ? "" : "/") + part;
  return path;
}

bool starts_with_drive(std::string_view name) {
  return name.size() > 1 && name[1] == ':' &&
         ((name[0] >= 'a' && name[0] <= 'z') || (name[0] >= 'A' && name[0] <= 'Z'));
}

// Nothing is unpacked here, but who looks at the submission may well unpack it, on any system: both
// slashes count, and so do spaces at the end of a name, which Windows drops.
void require_harmless(std::string_view name) {
  if (name.find('\0') != std::string_view::npos)
    throw ArchiveError("the name " + shown_name(name) + " has a zero byte in it");
  bool outside = name.starts_with('/') || name.starts_with('\\') || starts_with_drive(name);
  int depth = 0;
  for (std::string_view rest = name; !rest.empty() && !outside;) {
    const std::string_view part = rest.substr(0, rest.find_first_of("/\\"));
    rest.remove_prefix(std::min(part.size() + 1, rest.size()));
    outside = part.substr(0, part.find_last_not_of(' ') + 1) == "..";
    if (!part.empty() && part != "." && ++depth > deepest)
      throw ArchiveError("its folders lie more than " + std::to_string(deepest) + " deep");
  }
  if (outside) throw ArchiveError(shown_name(name) + " would lie outside of it");
}

bool looks_like_chapter(const std::string& name) {
  return name.size() > 3 && name[0] >= '0' && name[0] <= '9' && name[1] >= '0' && name[1] <= '9' &&
         name[2] == '_';
}

// What the archive of the page and of `contact export` holds besides copies.
bool is_of_export(const std::vector<std::string>& parts) {
  return parts.back() == "contact-submission.json" ||
         (parts.size() > 1 && parts[parts.size() - 2] == "work" && parts.back() == "progress.json");
}

class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  [[nodiscard]] int number() const { return number_; }

 private:
  int number_;
};

// A plain file of one name, opened without following a link and without waiting for a pipe's other
// end.
std::string read_plain(int folder, const std::string& name, const std::string& path,
                       std::string& problem) {
  const Descriptor file(
      ::openat(folder, name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  if (file.number() < 0)
    throw ArchiveError(shown_name(path) +
                       (errno == ELOOP ? " is a link, not a plain file"
                                       : std::string(" cannot be read: ") + std::strerror(errno)));
  struct stat status {};
  if (::fstat(file.number(), &status) != 0 || !S_ISREG(status.st_mode))
    throw ArchiveError(shown_name(path) + " is a device or a pipe, not a plain file");
  if (status.st_nlink > 1)
    throw ArchiveError(shown_name(path) +
                       " is a hard link: another name of the same file may lie anywhere. Copy the "
                       "submission, and grade the copy");
  std::string text;
  std::array<char, 65536> part{};
  while (text.size() <= max_in_file) {
    const ssize_t count = ::read(file.number(), part.data(), part.size());
    if (count < 0)
      throw ArchiveError(shown_name(path) + " cannot be read: " + std::strerror(errno));
    if (count == 0) break;
    text.append(part.data(), static_cast<std::size_t>(count));
  }
  problem = problem_of_text(text);
  if (!problem.empty()) text.clear();
  return text;
}

}  // namespace

bool is_junk(std::string_view name) {
  return name.starts_with(".") || name == "__MACOSX" || name == "Thumbs.db" ||
         name == "desktop.ini" || name == "__pycache__";
}

std::vector<std::string> unique_names(const Book& book) {
  std::map<std::string, int> counts;
  for (const Exercise& exercise : book.exercises()) ++counts[exercise.name];
  std::vector<std::string> names;
  for (const auto& [name, count] : counts) {
    if (count == 1) names.push_back(name);
  }
  return names;
}

const Exercise* SubmissionFiles::exercise_of(const std::string& path) const {
  if (!path.ends_with(".cpp")) return nullptr;
  const std::vector<std::string> parts = parts_of(path);
  if (parts.empty()) return nullptr;
  const std::string name = parts.back().substr(0, parts.back().size() - 4);
  const std::string folder = parts.size() > 1 ? parts[parts.size() - 2] : "";
  const Exercise* by_name = nullptr;
  int named_so = 0;
  for (const Exercise& exercise : book_.exercises()) {
    if (exercise.name != name) continue;
    if (exercise.chapter == folder) return &exercise;
    by_name = &exercise;
    ++named_so;
  }
  return named_so == 1 && !looks_like_chapter(folder) ? by_name : nullptr;
}

void SubmissionFiles::add(const Exercise& exercise, Found found) {
  // A student who hands in the whole book hands in its stubs and solutions, which are not answers.
  const std::string in_book = exercise.chapter + "/" + exercise.name + "/" + exercise.name + ".cpp";
  const auto is_books = [&](const char* folder, const fs::path& own) {
    const std::string place = std::string(folder) + "/" + in_book;
    return (found.path == place || found.path.ends_with("/" + place)) &&
           found.text == read_text(own);
  };
  if (is_books("exercises", exercise.stub) || is_books("solutions", exercise.solution)) return;
  found_[exercise.id()].push_back(std::move(found));
}

// A folder, walked by descriptors, so that no name in it can lead elsewhere.
class SubmissionFiles::Folder {
 public:
  explicit Folder(SubmissionFiles& files) : files_(files) {}

  void walk(int parent, const std::string& name, const std::string& path, int depth) {
    const int descriptor =
        ::openat(parent, name.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (descriptor < 0)
      throw ArchiveError(
          shown_name(path.empty() ? name : path) + " cannot be read: " +
          (errno == ELOOP || errno == ENOTDIR ? "it is a link" : std::strerror(errno)));
    if (depth > deepest) {
      ::close(descriptor);
      throw ArchiveError("its folders lie more than " + std::to_string(deepest) + " deep");
    }
    const std::unique_ptr<DIR, int (*)(DIR*)> folder(::fdopendir(descriptor), &::closedir);
    if (!folder) {
      ::close(descriptor);
      throw ArchiveError("its folders cannot be read: " + std::string(std::strerror(errno)));
    }
    std::vector<std::string> names;
    while (const dirent* entry = ::readdir(folder.get())) {
      const std::string found = entry->d_name;
      if (found == "." || found == ".." || is_junk(found)) continue;
      if (++entries_ > max_entries)
        throw ArchiveError("it has more than " + std::to_string(max_entries) + " entries");
      names.push_back(found);
    }
    std::sort(names.begin(), names.end());
    for (const std::string& found : names)
      enter(descriptor, found, path.empty() ? found : path + "/" + found, depth);
  }

 private:
  void enter(int folder, const std::string& name, const std::string& path, int depth) {
    struct stat status {};
    if (::fstatat(folder, name.c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0)
      throw ArchiveError(shown_name(path) + " cannot be read: " + std::strerror(errno));
    if (S_ISDIR(status.st_mode)) {
      walk(folder, name, path, depth + 1);
      return;
    }
    if (!S_ISREG(status.st_mode))
      throw ArchiveError(shown_name(path) + " is a link or a device, not a plain file");
    if (const Exercise* exercise = files_.exercise_of(path)) {
      Found found{as_utf8(path), "", ""};
      found.text = read_plain(folder, name, path, found.problem);
      total_ += found.text.size();
      if (total_ > max_in_all)
        throw ArchiveError("it holds more than " + mebibytes(max_in_all) + ", at " +
                           shown_name(path));
      files_.add(*exercise, std::move(found));
    } else if (!is_of_export(parts_of(path))) {
      files_.ignored_.push_back(as_utf8(path));
    }
  }

  SubmissionFiles& files_;
  std::size_t entries_ = 0;
  std::size_t total_ = 0;
};

void SubmissionFiles::add_folder(const fs::path& folder) {
  Folder(*this).walk(AT_FDCWD, folder.string(), "", 1);
}

void SubmissionFiles::add_archive(const fs::path& file) {
  const std::string bytes = packed(file);
  ArchiveEntries entries(bytes);
  std::set<std::string> seen;
  while (entries.next()) {
    for (const std::string& name : entries.readings()) require_harmless(name);
    const std::vector<std::string> parts = parts_of(entries.path());
    if (entries.is_folder()) continue;
    const std::string path = as_utf8(joined(parts));
    const Exercise* exercise = exercise_of(path);
    for (const std::string& name : entries.readings()) {
      if (exercise_of(name) != exercise)
        throw ArchiveError(shown_name(path) + " has another name in it too, " + shown_name(name) +
                           ": programs that unpack it do not agree on which counts. Pack it anew");
    }
    // A link in .venv is not followed either, so it need not be plain.
    if (parts.empty() || std::any_of(parts.begin(), parts.end(), is_junk)) {
      entries.pass();
      continue;
    }
    entries.require_plain();
    if (exercise == nullptr) {
      entries.pass();
      if (!is_of_export(parts)) ignored_.push_back(path);
      continue;
    }
    if (!seen.insert(path).second) throw ArchiveError(shown_name(path) + " is in it twice");
    Found found{path, "", ""};
    if (entries.size() > max_in_file) {
      entries.pass();
      found.problem = "is larger than " + mebibytes(max_in_file);
    } else {
      found.text = entries.read();
      found.problem = problem_of_text(found.text);
    }
    add(*exercise, std::move(found));
  }
  std::sort(ignored_.begin(), ignored_.end());
}

bool SubmissionFiles::add_file(const fs::path& file, const std::string& name,
                               const Exercise* only) {
  const Exercise* exercise = exercise_of(name);
  if (exercise == nullptr) exercise = only;
  if (exercise == nullptr) return false;
  Found found{as_utf8(name), "", ""};
  found.text = read_plain(AT_FDCWD, file.string(), name, found.problem);
  add(*exercise, std::move(found));
  return true;
}

std::map<std::string, TakenFile> SubmissionFiles::taken() const {
  std::map<std::string, TakenFile> result;
  for (const auto& [exercise, found] : found_) {
    TakenFile& file = result[exercise];
    file.path = found.front().path;
    if (found.size() > 1) {
      file.problem =
          "two files answer to it, " + shown_name(found[0].path) + " and " +
          shown_name(found[1].path) +
          (found.size() > 2 ? " (and " + std::to_string(found.size() - 2) + " more)" : "") +
          ": which of them counts is not said";
    } else if (!found.front().problem.empty()) {
      file.problem = shown_name(file.path) + " " + found.front().problem;
    } else {
      file.text = found.front().text;
    }
  }
  return result;
}

}  // namespace contact::grading
