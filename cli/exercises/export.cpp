// contact export: the copies and the record of progress as one zip file, for the page, another
// machine or a grader.

#include <algorithm>
#include <array>
#include <ctime>
#include <optional>
#include <set>

#include <nlohmann/json.hpp>

#include "../../grading/archive/archive.hpp"
#include "../../grading/progress/progress.hpp"
#include "../commands.hpp"
#include "../terminal/terminal.hpp"

namespace fs = std::filesystem;

namespace contact::cli {

namespace {

using grading::ArchivedCopy;
using grading::Book;
using grading::Exercise;

struct Options {
  std::vector<std::string> words;
  bool force = false;
  bool json = false;
};

std::string today() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  localtime_r(&now, &parts);
  std::array<char, 16> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%d", &parts);
  return text.data();
}

struct Work {
  std::vector<ArchivedCopy> copies;
  grading::ProgressRecord record;
  /// Files of the student's folder that an archive has no place for.
  std::vector<fs::path> left_out;
};

// What begins with a dot is ours or an editor's.
std::vector<fs::path> visible(const fs::path& folder) {
  std::vector<fs::path> paths;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    if (entry.path().filename().string().front() != '.') paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

// Every copy there is, also of exercises that this book does not have.
Work all_work(const Book& book, const grading::ProgressRecord& record) {
  Work work;
  work.record = record;
  for (const fs::path& chapter : visible(book.work())) {
    if (!fs::is_directory(chapter)) {
      // Also those that were broken and put aside.
      if (!chapter.filename().string().starts_with("progress.json"))
        work.left_out.push_back(chapter);
      continue;
    }
    for (const fs::path& file : visible(chapter)) {
      std::optional<ArchivedCopy> copy =
          grading::copy_from_id(chapter.filename().string() + "/" + file.stem().string());
      if (copy && file.extension() == ".cpp" && fs::is_regular_file(file)) {
        copy->text = grading::read_text(file);
        work.copies.push_back(std::move(*copy));
      } else {
        work.left_out.push_back(file);
      }
    }
  }
  return work;
}

// What each name means; of a chapter, what has been begun.
std::vector<const Exercise*> chosen(const Book& book, const std::vector<std::string>& names) {
  std::vector<const Exercise*> exercises;
  for (const std::string& name : names) {
    const bool one = book.find_exercise(name) != nullptr;
    for (const Exercise* exercise : book.meant_by(name)) {
      if (one || book.started(*exercise)) exercises.push_back(exercise);
    }
  }
  return exercises;
}

// The copies of these exercises and what the record says of them, and nothing else.
std::optional<Work> some_work(const Book& book, const std::vector<std::string>& names,
                              const grading::ProgressRecord& record) {
  Work work;
  nlohmann::json document = work.record.document();
  const nlohmann::json& all = record.document()["exercises"];
  std::set<std::string> seen;
  for (const Exercise* exercise : chosen(book, names)) {
    const std::string id = exercise->id();
    if (!book.started(*exercise)) {
      note("You have not started " + id + " yet, so nothing is exported: " + program_as_typed() +
           " start " + exercise->name);
      return {};
    }
    if (!seen.insert(id).second) continue;
    work.copies.push_back(
        {exercise->chapter, exercise->name, grading::read_text(book.work_file(*exercise))});
    if (all.contains(id)) document["exercises"][id] = all[id];
  }
  work.record = grading::ProgressRecord(std::move(document));
  return work;
}

// What is at `file` stays under another name; returns that name.
fs::path put_aside(const fs::path& file) {
  fs::path aside;
  for (int i = 1; aside.empty() || fs::exists(aside); ++i)
    aside = file.parent_path() /
            (file.stem().string() + ".old-" + std::to_string(i) + file.extension().string());
  // A copy, so that at no moment is there no archive under the name.
  fs::copy_file(file, aside);
  return aside;
}

// Where to write, which is free unless --force was given.
fs::path target(const fs::path& name, bool force) {
  fs::path file = fs::absolute(name).lexically_normal();
  if (!fs::is_directory(file.parent_path()))
    throw grading::BookError("there is no folder " + shown(file.parent_path()));
  if (fs::exists(file) && !fs::is_regular_file(file))
    throw grading::BookError(shown(file) + " exists and is not a file");
  if (fs::exists(file) && !force)
    throw grading::BookError(shown(file) +
                             " already exists. Give another name, or --force, which keeps it "
                             "under another name");
  return file;
}

nlohmann::json json_of(const Work& work, const fs::path& file, const fs::path& aside) {
  nlohmann::json ids = nlohmann::json::array();
  for (const ArchivedCopy& copy : work.copies) ids.push_back(copy.id());
  nlohmann::json left_out = nlohmann::json::array();
  for (const fs::path& path : work.left_out) left_out.push_back(path.string());
  nlohmann::json document = {{"format", "contact-export/1"},
                             {"file", file.string()},
                             {"exercises", ids},
                             {"left_out", left_out}};
  if (!aside.empty()) document["kept"] = aside.string();
  return document;
}

int run(Context& context, const Options& options) {
  const Book& book = context.book();
  std::vector<std::string> names = options.words;
  fs::path file = "contact-work-" + today() + ".zip";
  if (!names.empty() && names.front().ends_with(".zip")) {
    file = names.front();
    names.erase(names.begin());
  }
  file = target(file, options.force);

  const grading::Progress progress(book.work());
  if (!progress.notice().empty()) note(progress.notice());
  const std::optional<Work> work =
      names.empty() ? all_work(book, progress.known()) : some_work(book, names, progress.known());
  if (!work) return exit_not_passed;
  grading::Submission submission{grading::now_utc(), "contact", {}, work->copies};
  if (work->record.document() != grading::ProgressRecord().document())
    submission.progress = work->record;
  if (submission.copies.empty() && !submission.progress) {
    note("Nothing is started yet, so there is nothing to export.");
    return exit_not_passed;
  }

  const std::string bytes = grading::submission_bytes(submission);
  const fs::path aside = fs::exists(file) ? put_aside(file) : fs::path();
  grading::write_text(file, bytes);

  if (options.json) {
    say(json_of(*work, file, aside).dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
    return exit_passed;
  }
  for (const fs::path& path : work->left_out)
    note("Not in the archive, because it is not a copy of an exercise: " + printable(shown(path)));
  if (!aside.empty()) say("The existing archive is kept as " + shown(aside));
  say(shown(file) + ": " + std::to_string(work->copies.size()) +
      (work->copies.size() == 1 ? " copy" : " copies") +
      (submission.progress ? " and your progress, " : ", ") +
      std::to_string((bytes.size() + 1023) / 1024) + " KiB");
  return exit_passed;
}

}  // namespace

void add_export(Command app, Action& action) {
  auto options = std::make_shared<Options>();
  const Command command =
      app.add_subcommand("export", "Your copies and progress as one zip file (never overwrites)");
  command
      .add_option("file_and_exercises", options->words,
                  "The file, ending in .zip (contact-work-DATE.zip if none is named), then "
                  "exercises or chapters; all your copies if none is named")
      .option_text("[FILE.zip] [EXERCISE ...]");
  command.add_flag("--force", options->force,
                   "Replace an existing file, which is kept as NAME.old-1.zip");
  command.add_flag("--json", options->json, "Print JSON");
  command.callback([&action, options] {
    action = [options](Context& context) { return run(context, *options); };
  });
}

}  // namespace contact::cli
