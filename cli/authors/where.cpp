// contact where: every file of an exercise or a chapter.

#include <algorithm>
#include <set>
#include <system_error>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "../commands.hpp"
#include "../terminal/terminal.hpp"

namespace fs = std::filesystem;

namespace contact::cli {

namespace {

using grading::Book;
using grading::Chapter;
using grading::Exercise;

/// What there is of something, each file once, in the order in which it is found.
class Files {
 public:
  explicit Files(const Book& book) : book_(book) {}

  void add(const std::string& kind, const fs::path& file) {
    std::error_code error;
    if (!fs::is_regular_file(file, error) || !known_.insert(file).second) return;
    found_.emplace_back(kind, file);
  }
  void add_all(const std::string& kind, const fs::path& folder) {
    std::error_code error;
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder, error))
      files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    for (const fs::path& file : files) add(kind, file);
  }

  void add(const Exercise& exercise) {
    add("contract", exercise.contract);
    add("stub", exercise.stub);
    if (!exercise.given.empty()) add("code to break", exercise.given);
    add_all("exercise", exercise.folder);
    add("copy", book_.work_file(exercise));
    add("solution", exercise.solution);
    add("mutants that are no mistakes", exercise.solution.parent_path() / "equivalent.toml");
    add_all("wrong answer", exercise.wrong_answers);
    add("tests", exercise.test_source);
    const fs::path tests = exercise.test_source.parent_path();
    for (const char* file : {"hard_cases.json", "hard_cases.cpp"}) add("hard cases", tests / file);
    add_page(exercise.chapter);
  }

  void add(const Chapter& chapter) {
    add("chapter", chapter.folder / "chapter.toml");
    add("lesson", chapter.folder / "lesson.md");
    add_all("errata of a lecture", chapter.folder / "lectures");
    add_all("reference", chapter.folder / "contact");
    add_all("reference", chapter.folder / "src");
    add_all("figure", chapter.folder / "figures");
    add("questions", chapter.folder / "questions.toml");
    add("ladder", chapter.folder / "ladder.cpp");
    add_all("example", chapter.folder / "examples");
    add_all("scene", chapter.folder / "scenes");
    for (const Exercise* exercise : book_.exercises_of(chapter)) add(*exercise);
    add_all("tests", book_.root() / "tests" / chapter.slug);
    add_page(chapter.slug);
  }

  [[nodiscard]] const std::vector<std::pair<std::string, fs::path>>& found() const {
    return found_;
  }
  [[nodiscard]] std::string shown(const fs::path& file) const {
    const fs::path inside = file.lexically_relative(book_.root());
    return inside.empty() || inside.string().starts_with("..") ? file.string() : inside.string();
  }

 private:
  void add_page(const std::string& slug) {
    add("page", book_.root() / "build" / "site" / "chapters" / (slug + ".html"));
  }

  const Book& book_;
  std::set<fs::path> known_;
  std::vector<std::pair<std::string, fs::path>> found_;
};

int run(Context& context, const std::string& name, bool json) {
  const Book& book = context.book();
  Files files(book);
  if (const Exercise* const exercise = book.find_exercise(name))
    files.add(*exercise);
  else if (const Chapter* const chapter = book.find_chapter(name))
    files.add(*chapter);
  else
    (void)book.meant_by(name);  // throws, with the nearest names
  nlohmann::json list = nlohmann::json::array();
  for (const auto& [kind, file] : files.found()) {
    if (json)
      list.push_back({{"kind", kind}, {"file", files.shown(file)}});
    else
      say(files.shown(file));
  }
  if (json) say(list.dump(2));
  return exit_passed;
}

}  // namespace

void add_where(Command app, Action& action) {
  auto name = std::make_shared<std::string>();
  auto json = std::make_shared<bool>(false);
  const Command command = app.add_subcommand(where_command);
  command.add_option("name", *name, "The exercise or the chapter").required();
  command.add_flag("--json", *json, "Print JSON, with the kind of each file");
  command.callback([&action, name, json] {
    action = [name, json](Context& context) { return run(context, *name, *json); };
  });
}

}  // namespace contact::cli
