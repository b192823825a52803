#include "progress.hpp"

#include <algorithm>
#include <array>
#include <ctime>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace fs = std::filesystem;

namespace contact::grading {

namespace {

constexpr const char* format_name = "contact-progress/1";

// Two programs may record at once (a watch and a check): the file is read, changed and written
// under this lock.
class FileLock {
 public:
  explicit FileLock(const fs::path& file)
      : descriptor_(::open(file.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0644)) {
    if (descriptor_ >= 0) ::flock(descriptor_, LOCK_EX);
  }
  ~FileLock() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

 private:
  int descriptor_;
};

std::string formatted_time(const char* format) {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  gmtime_r(&now, &parts);
  std::array<char, 40> text{};
  std::strftime(text.data(), text.size(), format, &parts);
  return text.data();
}

nlohmann::json empty_document() {
  return {{"format", format_name}, {"exercises", nlohmann::json::object()}};
}

void require_shape(const nlohmann::json& data) {
  if (!data.is_object() || data.value("format", "") != format_name || !data.contains("exercises") ||
      !data["exercises"].is_object())
    throw std::runtime_error(std::string("it is not ") + format_name);
  for (const auto& [id, entry] : data["exercises"].items()) {
    if (!entry.is_object()) throw std::runtime_error("the entry of " + id + " is not an object");
    if (entry.contains("tests") && !entry["tests"].is_object())
      throw std::runtime_error("the tests of " + id + " are not an object");
  }
}

// A value of the wrong type (a file edited by hand) reads as if it were not there.
template <typename T>
T read(const nlohmann::json& entry, const char* name, T otherwise) {
  try {
    return entry.value(name, otherwise);
  } catch (const nlohmann::json::exception&) {
    return otherwise;
  }
}

}  // namespace

std::string now_utc() { return formatted_time("%Y-%m-%dT%H:%M:%SZ"); }

Progress::Progress(const fs::path& work) : file_(work / "progress.json") { load(); }

void Progress::load() {
  data_ = empty_document();
  if (!fs::exists(file_)) return;
  try {
    nlohmann::json data = nlohmann::json::parse(read_text(file_));
    require_shape(data);
    data_ = std::move(data);
  } catch (const std::exception& error) {
    fs::path aside = file_;
    aside += formatted_time(".broken-%Y%m%d-%H%M%S");
    std::error_code failed;
    fs::rename(file_, aside, failed);
    if (failed)
      throw BookError(file_.string() + " could not be read (" + error.what() +
                      ") nor put aside: " + failed.message());
    notice_ = file_.string() + " could not be read (" + error.what() + "). It is kept as " +
              aside.string() + ", and progress starts anew.";
  }
}

ExerciseProgress Progress::of(const std::string& exercise) const {
  ExerciseProgress progress;
  const auto found = data_["exercises"].find(exercise);
  if (found == data_["exercises"].end()) return progress;
  progress.attempts = read(*found, "attempts", 0);
  progress.best_points = read(*found, "best_points", 0.0);
  progress.max_points = read(*found, "max_points", 0.0);
  progress.passed = read(*found, "passed", std::string());
  progress.last_checked = read(*found, "last_checked", std::string());
  progress.hints_shown = read(*found, "hints_shown", 0);
  progress.solution_shown = read(*found, "solution_shown", false);
  if (found->contains("tests")) {
    for (const auto& [name, status] : (*found)["tests"].items()) {
      if (status.is_string()) progress.tests[name] = status.get<std::string>();
    }
  }
  return progress;
}

template <typename Change>
void Progress::change(const std::string& exercise, Change apply) {
  fs::create_directories(file_.parent_path());
  const FileLock lock(file_.parent_path() / ".progress.lock");
  const std::string earlier_notice = notice_;
  load();
  if (notice_.empty()) notice_ = earlier_notice;
  nlohmann::json& entry = data_["exercises"][exercise];
  if (entry.is_null()) entry = nlohmann::json::object();
  apply(entry);
  write_text(file_, data_.dump(2) + "\n");
}

void Progress::record(const Verdict& verdict) {
  // What does not compile, and what still says todo() everywhere, is no attempt.
  if (verdict.outcome == Outcome::does_not_compile || verdict.outcome == Outcome::not_attempted)
    return;
  change(verdict.exercise, [&](nlohmann::json& entry) {
    entry["attempts"] = read(entry, "attempts", 0) + 1;
    entry["best_points"] = std::max(read(entry, "best_points", 0.0), verdict.points);
    entry["max_points"] = verdict.max_points;
    entry["last_checked"] = now_utc();
    if (verdict.outcome == Outcome::passed && read(entry, "passed", std::string()).empty())
      entry["passed"] = now_utc();
    entry["tests"] = nlohmann::json::object();
    for (const TestVerdict& test : verdict.tests) entry["tests"][test.name] = key(test.status);
  });
}

int Progress::record_hint(const std::string& exercise) {
  int shown = 0;
  change(exercise, [&](nlohmann::json& entry) {
    shown = read(entry, "hints_shown", 0) + 1;
    entry["hints_shown"] = shown;
  });
  return shown;
}

void Progress::record_solution_shown(const std::string& exercise) {
  change(exercise, [&](nlohmann::json& entry) { entry["solution_shown"] = true; });
}

}  // namespace contact::grading
