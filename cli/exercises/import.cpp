// contact import: takes the work in an archive, from the page or from another machine, into the
// student's folder. Replaced files are kept.

#include <cerrno>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include "../../grading/archive/archive.hpp"
#include "../../grading/progress/progress.hpp"
#include "../../grading/progress/progress_merge.hpp"
#include "../commands.hpp"
#include "../terminal/terminal.hpp"

namespace fs = std::filesystem;

namespace contact::cli {

namespace {

using grading::ArchivedCopy;
using grading::Book;

enum class Fate { fresh, same, yours_stays, replaced };

std::string_view key(Fate fate) {
  switch (fate) {
    case Fate::fresh:
      return "new";
    case Fate::same:
      return "same";
    case Fate::yours_stays:
      return "yours_stays";
    case Fate::replaced:
      return "replaced";
  }
  return "";
}

struct Step {
  const ArchivedCopy* copy;
  fs::path target;
  bool known = false;
  Fate fate = Fate::fresh;
  /// What is there now and must not be lost; empty if the book can give it again.
  std::string mine;
  fs::path staged;
  fs::path kept;
  [[nodiscard]] bool writes() const { return fate == Fate::fresh || fate == Fate::replaced; }
};

// A folder beside the copies for their replacements, so that a full disk is noticed before any copy
// is changed. Only one import runs at a time; the next import removes the folder of one that was
// killed.
class Staging {
 public:
  explicit Staging(const fs::path& work) : folder_(work / ".import") {
    fs::create_directories(work);
    const fs::path file = work / ".import.lock";
    descriptor_ = ::open(file.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0644);
    if (descriptor_ < 0) throw grading::BookError("cannot write to " + work.string());
    while (::flock(descriptor_, LOCK_EX) != 0 && errno == EINTR) {
    }
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~Staging() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
    ::close(descriptor_);
  }
  Staging(const Staging&) = delete;
  Staging& operator=(const Staging&) = delete;
  [[nodiscard]] const fs::path& folder() const { return folder_; }

 private:
  fs::path folder_;
  int descriptor_ = -1;
};

Step step_for(const Book& book, const ArchivedCopy& copy) {
  Step step;
  step.copy = &copy;
  step.target = book.work() / copy.chapter / (copy.name + ".cpp");
  std::string stub;
  for (const grading::Exercise& exercise : book.exercises()) {
    if (exercise.id() != copy.id()) continue;
    step.known = true;
    stub = grading::read_text(exercise.stub);
  }
  if (!fs::exists(step.target)) return step;
  if (!fs::is_regular_file(step.target))
    throw grading::BookError(step.target.string() + " exists and is not a file");
  step.mine = grading::read_text(step.target);
  if (step.mine == copy.text) {
    step.fate = Fate::same;
  } else if (step.known && copy.text == stub) {
    step.fate = Fate::yours_stays;
  } else {
    step.fate = Fate::replaced;
    if (step.known && step.mine == stub) step.mine.clear();
  }
  return step;
}

// All that can fail comes first; then each copy changes in one rename, from the old text to the
// new.
void put_in_place(Context& context, std::vector<Step>& steps) {
  const Book& book = context.book();
  const Staging staging(book.work());
  for (std::size_t i = 0; i < steps.size(); ++i) {
    Step& step = steps[i];
    // What is there is read under the lock; an import that ran meanwhile changes the answer.
    step = step_for(book, *step.copy);
    if (!step.writes()) continue;
    step.staged = staging.folder() / std::to_string(i);
    grading::write_text(step.staged, step.copy->text);
    fs::create_directories(step.target.parent_path());
  }
  for (Step& step : steps) {
    if (step.fate == Fate::replaced && !step.mine.empty())
      step.kept = keep_aside(book, step.copy->chapter, step.copy->name, step.mine);
  }
  // The last moment for Ctrl-C; what follows takes milliseconds.
  context.loop().poll();
  for (const Step& step : steps) {
    if (step.writes()) fs::rename(step.staged, step.target);
  }
}

std::string in_words(const Step& step) {
  std::string text;
  switch (step.fate) {
    case Fate::fresh:
      text = "taken; you had none";
      break;
    case Fate::same:
      text = "the same as yours";
      break;
    case Fate::yours_stays:
      text = "unchanged in the archive, so yours stays";
      break;
    case Fate::replaced:
      text = step.kept.empty() ? "taken; yours was unchanged"
                               : "taken; yours is kept as " + shown(step.kept);
      break;
  }
  return text + (step.known ? "" : " (an exercise that this book does not have)");
}

void print(const grading::Submission& submission, const fs::path& file,
           const std::vector<Step>& steps, const std::vector<std::string>& progressed) {
  const Style style(stdout);
  std::string head = style.bold(shown(file));
  if (!submission.from.empty())
    head += submission.from == "page" ? ", from the page" : ", from `contact export`";
  if (!submission.exported.empty()) head += ", of " + submission.exported;
  say(head);
  std::size_t width = 0;
  for (const Step& step : steps) width = std::max(width, step.copy->id().size() + 2);
  for (const Step& step : steps) say("  " + padded(step.copy->id(), width) + in_words(step));
  if (steps.empty()) say("  It holds no copies.");
  std::string names;
  for (const std::string& id : progressed) names += (names.empty() ? "" : ", ") + id;
  if (!submission.progress)
    say("Progress: the archive has none; yours stays.");
  else
    say("Progress: " +
        (names.empty() ? "nothing that you did not have." : "more of " + names + "."));
}

nlohmann::json json_of(const grading::Submission& submission, const fs::path& file,
                       const std::vector<Step>& steps, const std::vector<std::string>& progressed) {
  nlohmann::json results = nlohmann::json::array();
  for (const Step& step : steps) {
    nlohmann::json result = {{"exercise", step.copy->id()},
                             {"file", step.target.string()},
                             {"known", step.known},
                             {"status", key(step.fate)}};
    if (!step.kept.empty()) result["kept"] = step.kept.string();
    results.push_back(std::move(result));
  }
  return {
      {"format", "contact-import/1"}, {"archive", file.string()}, {"exported", submission.exported},
      {"from", submission.from},      {"results", results},       {"progress", progressed}};
}

int run(Context& context, const std::string& name, bool json) {
  const Book& book = context.book();
  const fs::path file = fs::absolute(name).lexically_normal();
  if (!fs::exists(file)) throw grading::UnknownName("there is no file " + name);
  const grading::Submission submission = grading::read_submission(file);
  std::vector<Step> steps;
  for (const ArchivedCopy& copy : submission.copies) steps.push_back(step_for(book, copy));
  put_in_place(context, steps);

  std::vector<std::string> progressed;
  if (submission.progress) {
    grading::Progress progress(book.work());
    progressed = progress.merge(*submission.progress);
    if (!progress.notice().empty()) note(progress.notice());
  }
  if (json)
    say(json_of(submission, file, steps, progressed)
            .dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
  else
    print(submission, file, steps, progressed);
  return exit_passed;
}

}  // namespace

void add_import(Command app, Action& action) {
  auto file = std::make_shared<std::string>();
  auto json = std::make_shared<bool>(false);
  const Command command =
      app.add_subcommand("import", "Import the work in an archive; your own files are kept");
  command.add_option("file", *file, "A zip file that the page or `contact export` wrote")
      .option_text("FILE.zip")
      .required();
  command.add_flag("--json", *json, "Print JSON");
  command.callback([&action, file, json] {
    action = [file, json](Context& context) { return run(context, *file, *json); };
  });
}

}  // namespace contact::cli
