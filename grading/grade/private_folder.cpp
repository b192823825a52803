#include "private_folder.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <sys/stat.h>

namespace fs = std::filesystem;

namespace contact::grading {

namespace {

bool hidden_file(const fs::path& path) { return path.filename().string().starts_with('.'); }

std::vector<fs::path> entries_of(const fs::path& folder) {
  std::vector<fs::path> entries;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (!hidden_file(entry.path())) entries.push_back(entry.path());
  }
  std::sort(entries.begin(), entries.end());
  return entries;
}

mode_t mode_of(const fs::path& path) {
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0 ? status.st_mode : 0;
}

// Whether users other than its owner and group can enter the folder.
bool open_to_others(const fs::path& folder) {
  const fs::path whole = fs::canonical(folder);
  if ((mode_of(whole) & (S_IROTH | S_IXOTH)) == 0) return false;
  for (fs::path above = whole.parent_path();; above = above.parent_path()) {
    if ((mode_of(above) & S_IXOTH) == 0) return false;
    if (above == above.root_path()) return true;
  }
}

void check_tests(const PrivateFolder& found) {
  const fs::path file = found.folder / "tests.toml";
  std::set<std::string> known;
  for (const TestSpec& test : found.exercise->tests) known.insert(test.name);
  for (const TestSpec& test : found.tests) {
    if (test.name.empty()) throw BookError(file.string() + ": a test has no name");
    if (!known.insert(test.name).second)
      throw BookError(file.string() + ": there is more than one test called '" + test.name +
                      "'; the book's count too");
    if (!(test.points > 0.0) || !std::isfinite(test.points))
      throw BookError(file.string() + ": the test '" + test.name +
                      "' needs points, a number above zero");
  }
  for (const TestSpec& test : found.tests) {
    for (const std::string& need : test.needs) {
      if (known.count(need) == 0 || need == test.name)
        throw BookError(file.string() + ": the test '" + test.name +
                        "' requires one that does not exist: '" + need + "'");
    }
  }
}

PrivateFolder read_exercise_folder(const Exercise& exercise, const fs::path& folder) {
  PrivateFolder found{&exercise, folder, {}, {}};
  for (const fs::path& file : entries_of(folder)) {
    if (file.filename().string().ends_with("_test.cpp")) {
      found.sources.push_back(file);
    } else if (file.extension() == ".cpp") {
      throw BookError(file.string() + " would not be compiled: call it " + file.stem().string() +
                      "_test.cpp");
    }
  }
  if (!fs::exists(folder / "tests.toml"))
    throw BookError(folder.string() +
                    " has no tests.toml, which lists its tests and their points as "
                    "exercise.toml does");
  if (found.sources.empty())
    throw BookError(folder.string() + " has no " + exercise.name + "_test.cpp");
  found.tests = read_test_list(folder / "tests.toml", true);
  check_tests(found);
  return found;
}

}  // namespace

void check_apart(const fs::path& folder, const fs::path& submissions) {
  if (!fs::is_directory(folder))
    throw BookError("--private " + folder.string() + ": there is no such folder");
  if (submissions.empty() || !fs::exists(submissions)) return;
  const fs::path inside = fs::canonical(folder).lexically_relative(fs::canonical(submissions));
  if (!inside.empty() && *inside.begin() != "..")
    throw BookError("--private " + folder.string() + " is inside " + submissions.string() +
                    ", so it would be graded as a submission: move it out of there");
}

// Where a box holds only the files that were put into it, or the kernel closes all others to it, a
// submission cannot read these. Else its compiler is another user's process on this very file
// system, and `#include` opens what that user may read.
void check_unreadable(const Machine& machine, const PrivateTestsPlace& place) {
  if (machine.level == Level::full || machine.closed_files || place.accept_weak) return;
  const std::string level(words(machine.level));
  if (!machine.own_user_ids)
    throw BookError("--private " + place.folder.string() + ": at level " + level +
                    " submissions are compiled as the user that you are, who can read these tests. "
                    "Grade as root, or on a machine of which `contact doctor` says \"full\"; "
                    "--accept-weak goes on all the same");
  if (open_to_others(place.folder))
    throw BookError("--private " + place.folder.string() + ": at level " + level +
                    " a submission could read these tests while it is compiled. Close the folder "
                    "first: chmod o-rwx " +
                    place.folder.string());
}

std::vector<PrivateFolder> read_private_folder(const Book& book, const fs::path& folder) {
  std::vector<std::string> ids;
  for (const Exercise& exercise : book.exercises()) ids.push_back(exercise.id());
  std::vector<PrivateFolder> all;
  for (const fs::path& chapter : entries_of(folder)) {
    if (!fs::is_directory(chapter)) continue;
    for (const fs::path& inner : entries_of(chapter)) {
      if (!fs::is_directory(inner)) continue;
      const std::string id = chapter.filename().string() + "/" + inner.filename().string();
      const auto exercise =
          std::find_if(book.exercises().begin(), book.exercises().end(),
                       [&](const Exercise& candidate) { return candidate.id() == id; });
      if (exercise == book.exercises().end()) {
        const std::vector<std::string> near = nearest(id, ids);
        throw BookError(inner.string() + ": there is no exercise " + id +
                        (near.empty() ? "" : "; did you mean " + near.front() + "?"));
      }
      all.push_back(read_exercise_folder(*exercise, inner));
    }
  }
  if (all.empty())
    throw BookError("--private " + folder.string() +
                    " holds no tests: they lie in NN_slug/NAME/, as exercises do in the book");
  return all;
}

}  // namespace contact::grading
