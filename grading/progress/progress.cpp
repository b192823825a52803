#include "progress.hpp"

#include <array>
#include <ctime>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include "progress_merge.hpp"

namespace fs = std::filesystem;

namespace contact::grading {

namespace {

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

}  // namespace

std::string now_utc(const char* format) {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  gmtime_r(&now, &parts);
  std::array<char, 40> text{};
  std::strftime(text.data(), text.size(), format, &parts);
  return text.data();
}

Progress::Progress(const fs::path& work) : file_(work / "progress.json") { load(); }

void Progress::load() {
  record_ = ProgressRecord();
  if (!fs::exists(file_)) return;
  try {
    record_ = ProgressRecord(nlohmann::json::parse(read_text(file_)));
  } catch (const std::exception& error) {
    fs::path aside = file_;
    aside += now_utc(".broken-%Y%m%d-%H%M%S");
    std::error_code failed;
    fs::rename(file_, aside, failed);
    if (failed)
      throw BookError(file_.string() + " could not be read (" + error.what() +
                      ") nor put aside: " + failed.message());
    notice_ = file_.string() + " could not be read (" + error.what() + "). It is kept as " +
              aside.string() + ", and progress starts anew.";
  }
}

template <typename Change>
void Progress::change(Change apply) {
  fs::create_directories(file_.parent_path());
  const FileLock lock(file_.parent_path() / ".progress.lock");
  const std::string earlier_notice = notice_;
  load();
  if (notice_.empty()) notice_ = earlier_notice;
  apply(record_);
  write_text(file_, record_.document().dump(2) + "\n");
}

void Progress::record(const Verdict& verdict) {
  if (!is_attempt(verdict)) return;
  change([&](ProgressRecord& record) { record.record(verdict, now_utc()); });
}

int Progress::record_hint(const std::string& exercise) {
  int shown = 0;
  change([&](ProgressRecord& record) { shown = record.record_hint(exercise); });
  return shown;
}

void Progress::record_solution_shown(const std::string& exercise) {
  change([&](ProgressRecord& record) { record.record_solution_shown(exercise); });
}

void Progress::record_answer(const std::string& question, const QuestionProgress& given) {
  change([&](ProgressRecord& record) { record.record_answer(question, given, now_utc()); });
}

void Progress::record_marks(const std::string& question, const std::vector<bool>& marks) {
  change([&](ProgressRecord& record) { record.record_marks(question, marks, now_utc()); });
}

std::vector<std::string> Progress::merge(const ProgressRecord& theirs) {
  std::vector<std::string> changed;
  change([&](ProgressRecord& record) {
    ProgressRecord both = merged(record, theirs);
    changed = changed_entries(record, both);
    record = std::move(both);
  });
  return changed;
}

}  // namespace contact::grading
