// What the book's files must hold, whatever the answers get.

#include <algorithm>
#include <functional>
#include <map>
#include <regex>
#include <set>

#include <toml++/toml.h>

#include "../terminal/terminal.hpp"
#include "dev_check.hpp"

namespace fs = std::filesystem;

namespace contact::cli {

namespace {

using grading::Book;
using grading::Chapter;
using grading::Exercise;

using Problems = std::vector<std::string>;

bool blank(const std::string& text) {
  return text.find_first_not_of(" \t\r\n") == std::string::npos;
}

bool contains(const std::vector<std::string>& list, const std::string& item) {
  return std::find(list.begin(), list.end(), item) != list.end();
}

std::vector<fs::path> entries_of(const fs::path& folder) {
  std::vector<fs::path> entries;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
    entries.push_back(entry.path());
  std::sort(entries.begin(), entries.end());
  return entries;
}

bool left_by_a_tool(const fs::path& entry) { return entry.filename() == "__pycache__"; }

void require_only(const fs::path& folder, const std::function<bool(const fs::path&)>& allowed,
                  Problems& problems) {
  for (const fs::path& entry : entries_of(folder)) {
    if (!left_by_a_tool(entry) && !allowed(entry)) problems.push_back("stray: " + shown(entry));
  }
}

std::string text_or_empty(const fs::path& file) {
  try {
    return grading::read_text(file);
  } catch (const grading::BookError&) {
    return {};
  }
}

// `contact new` writes this where an author must write.
void check_written(const fs::path& folder, Problems& problems) {
  std::error_code error;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder, error)) {
    if (entry.is_regular_file() &&
        text_or_empty(entry.path()).find("TO WRITE") != std::string::npos)
      problems.push_back("still to write: " + shown(entry.path()));
  }
}

// Every chapter that one builds on, through others too.
std::set<std::string> foundations(const Book& book, const Chapter& chapter) {
  std::set<std::string> found;
  const std::function<void(const Chapter&)> visit = [&](const Chapter& current) {
    for (const std::string& slug : current.builds_on) {
      const Chapter* next = book.chapter_called(slug);
      if (next != nullptr && found.insert(slug).second) visit(*next);
    }
  };
  visit(chapter);
  return found;
}

struct Questions {
  std::set<std::string> ids;
  Problems problems;
};

Questions read_questions(const Chapter& chapter) {
  Questions questions;
  const fs::path file = chapter.folder / "questions.toml";
  if (!fs::exists(file)) return questions;
  try {
    const toml::table table = toml::parse_file(file.string());
    const toml::array* list = table["question"].as_array();
    if (list == nullptr) return questions;
    for (const toml::node& node : *list) {
      const toml::table* question = node.as_table();
      if (question == nullptr) continue;
      const std::string id = (*question)["id"].value_or(std::string());
      if (blank(id) || !questions.ids.insert(id).second)
        questions.problems.push_back("questions.toml: the id '" + id + "' is empty or used twice");
      const std::string objective = (*question)["objective"].value_or(std::string());
      const bool known =
          std::any_of(chapter.objectives.begin(), chapter.objectives.end(),
                      [&](const grading::Objective& entry) { return entry.id == objective; });
      if (!known)
        questions.problems.push_back("question " + id + ": there is no objective '" + objective +
                                     "'");
      const bool says_why = (*question)["kind"].value_or(std::string()) == "say-why";
      for (const char* key : {"text", says_why ? "model" : "explain"}) {
        if (blank((*question)[key].value_or(std::string())))
          questions.problems.push_back("question " + id + ": " + key + " is empty");
      }
    }
  } catch (const toml::parse_error& error) {
    questions.problems.push_back("questions.toml: " + std::string(error.description()));
  }
  return questions;
}

void check_recall(const Book& book, const Chapter& chapter, Problems& problems) {
  for (const std::string& reference : chapter.recall) {
    const std::size_t slash = reference.find('/');
    const Chapter* other = book.chapter_called(reference.substr(0, slash));
    if (slash == std::string::npos || other == nullptr ||
        read_questions(*other).ids.count(reference.substr(slash + 1)) == 0)
      problems.push_back("recall names a question that does not exist: " + reference);
  }
}

void check_exercise_list(const Book& book, const Chapter& chapter, Problems& problems) {
  for (const std::string& name : chapter.exercise_names) {
    if (!fs::exists(book.root() / "exercises" / chapter.slug / name / "exercise.toml"))
      problems.push_back("it lists the exercise " + name + ", which does not exist");
  }
  for (const char* tree : {"exercises", "solutions"}) {
    for (const fs::path& folder : entries_of(book.root() / tree / chapter.slug)) {
      if (!contains(chapter.exercise_names, folder.filename().string()))
        problems.push_back("stray: " + shown(folder) + " is not listed in chapter.toml");
    }
  }
}

std::vector<fs::path> headers_of(const Chapter& chapter) {
  std::vector<fs::path> headers;
  std::error_code error;
  for (const fs::directory_entry& entry :
       fs::recursive_directory_iterator(chapter.folder / "contact", error)) {
    if (entry.path().extension() == ".hpp") headers.push_back(entry.path());
  }
  return headers;
}

void check_includes(const Book& book, const Chapter& chapter,
                    const std::map<std::string, std::string>& home, Problems& problems) {
  std::set<std::string> allowed = foundations(book, chapter);
  allowed.insert(chapter.slug);
  static const std::regex pattern(R"(#\s*include\s*<contact/([\w/]+\.hpp)>)");
  std::error_code error;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(chapter.folder, error)) {
    const std::string extension = entry.path().extension().string();
    if (extension != ".hpp" && extension != ".cpp") continue;
    const std::string text = text_or_empty(entry.path());
    for (std::sregex_iterator it(text.begin(), text.end(), pattern), end; it != end; ++it) {
      const std::string header = (*it)[1];
      const auto found = home.find(fs::path(header).filename().string());
      // What belongs to no chapter is the figure's machinery or the like; the compiler says if it
      // is missing.
      if (found != home.end() && allowed.count(found->second) == 0)
        problems.push_back(shown(entry.path()) + " includes <contact/" + header + "> of " +
                           found->second + ", which the chapter does not build on");
    }
  }
}

void require_only_parts(const Book& book, const Chapter& chapter, Problems& problems) {
  static const std::set<std::string> known{
      "chapter.toml",      "lesson.md",      "contact",    "src",
      "figures",           "examples",       "ladder.cpp", "scenes",
      "scene.schema.json", "questions.toml", "lectures"};
  require_only(
      chapter.folder,
      [](const fs::path& entry) { return known.count(entry.filename().string()) != 0; }, problems);
  require_only(
      chapter.folder / "scenes", [](const fs::path& entry) { return entry.extension() == ".json"; },
      problems);
  require_only(
      book.root() / "tests" / chapter.slug,
      [](const fs::path& entry) {
        const std::string name = entry.filename().string();
        return name.ends_with("_test.cpp") || name.ends_with(".hpp") || name == "hard_cases.cpp" ||
               name.ends_with(".json") || name == "scenes";
      },
      problems);
  require_only(
      book.root() / "tests" / chapter.slug / "scenes",
      [](const fs::path& entry) { return entry.extension() == ".json"; }, problems);
}

// Only what is used: nothing builds examples, ladders and tests of references of a pack.
void require_only_parts_of_pack(const Book& pack, const Chapter& chapter, Problems& problems) {
  static const std::set<std::string> known{"chapter.toml", "lesson.md", "contact", "figures",
                                           "questions.toml"};
  for (const fs::path& entry : entries_of(chapter.folder)) {
    if (!left_by_a_tool(entry) && known.count(entry.filename().string()) == 0)
      problems.push_back(shown(entry) + ": nothing uses this in a pack");
  }
  for (const fs::path& entry : entries_of(pack.root() / "tests" / chapter.slug)) {
    const std::string name = entry.filename().string();
    const bool of_an_exercise =
        std::any_of(chapter.exercise_names.begin(), chapter.exercise_names.end(),
                    [&](const std::string& exercise) { return name == exercise + "_test.cpp"; });
    if (!of_an_exercise && !name.ends_with(".hpp"))
      problems.push_back(shown(entry) +
                         ": it belongs to no exercise of the chapter, so nothing runs it");
  }
}

DevResult check_chapter(const Book& book, const Chapter& chapter,
                        const std::map<std::string, std::string>& home) {
  DevResult result{"chapter", chapter.slug, {}};
  Problems& problems = result.problems;
  if (blank(chapter.title)) problems.push_back("it has no title");
  if (blank(chapter.tooltip)) problems.push_back("it has no tooltip");
  if (chapter.part < 0 || chapter.part > 3) problems.push_back("part must be 0, 1, 2 or 3");
  if (chapter.status != "lesson" && chapter.status != "reference")
    problems.push_back("status must be \"lesson\" or \"reference\", not \"" + chapter.status +
                       "\"");
  if (chapter.status == "lesson" && !fs::exists(chapter.folder / "lesson.md"))
    problems.push_back("it has no lesson.md");
  std::set<std::string> ids;
  for (const grading::Objective& objective : chapter.objectives) {
    if (blank(objective.id) || !ids.insert(objective.id).second)
      problems.push_back("the objective '" + objective.id + "' has no id of its own");
    if (blank(objective.text)) problems.push_back("the objective " + objective.id + " has no text");
  }
  if (chapter.objectives.empty()) problems.push_back("it has no objectives");
  for (const std::string& slug : chapter.builds_on) {
    if (book.chapter_called(slug) == nullptr)
      problems.push_back("it builds on " + slug + ", which does not exist");
  }
  if (foundations(book, chapter).count(chapter.slug) != 0)
    problems.push_back("it builds on itself, through others");
  check_exercise_list(book, chapter, problems);
  check_recall(book, chapter, problems);
  const Questions questions = read_questions(chapter);
  problems.insert(problems.end(), questions.problems.begin(), questions.problems.end());
  check_includes(book, chapter, home, problems);
  check_written(chapter.folder, problems);
  for (const fs::path& file : entries_of(book.root() / "tests" / chapter.slug)) {
    if (text_or_empty(file).find("TO WRITE") != std::string::npos)
      problems.push_back("still to write: " + shown(file));
  }
  if (book.base() == nullptr)
    require_only_parts(book, chapter, problems);
  else
    require_only_parts_of_pack(book, chapter, problems);
  return result;
}

void check_tests(const Exercise& exercise, Problems& problems) {
  std::set<std::string> names;
  for (const grading::TestSpec& test : exercise.tests) {
    if (blank(test.name)) problems.push_back("a test has no name");
    if (!names.insert(test.name).second)
      problems.push_back("two tests are called '" + test.name + "'");
    if (!(test.points > 0.0)) problems.push_back("the test '" + test.name + "' is worth no points");
  }
  for (const grading::TestSpec& test : exercise.tests) {
    for (const std::string& need : test.needs) {
      if (names.count(need) == 0 || need == test.name)
        problems.push_back("the test '" + test.name + "' requires one that does not exist: '" +
                           need + "'");
    }
  }
}

void check_hints(const Exercise& exercise, Problems& problems) {
  if (exercise.kind == "transfer" && !exercise.hints.empty())
    problems.push_back("a transfer exercise is done without hints");
  if (exercise.kind != "transfer" && exercise.hints.empty()) problems.push_back("it has no hints");
  for (const std::string& hint : exercise.hints) {
    if (blank(hint)) problems.push_back("a hint is empty");
  }
}

void check_wrong_answers(const Book& book, const Exercise& exercise, Problems& problems) {
  std::set<std::string> shown_by_an_answer;
  for (const fs::path& file : wrong_answer_files(exercise)) {
    // `contact check PATH` takes the last name of an exercise in a path of its chapter.
    for (const Exercise& other : book.exercises()) {
      if (other.chapter == exercise.chapter && other.name == file.stem())
        problems.push_back(shown(file) + ": " + other.id() +
                           " has this name: a program that is given the path would take the wrong "
                           "answer for one of that exercise");
    }
    try {
      const WrongAnswer wrong = read_wrong_answer(file);
      if (wrong.misconception == no_misconception) continue;
      shown_by_an_answer.insert(wrong.misconception);
      if (!contains(exercise.misconceptions, wrong.misconception))
        problems.push_back(shown(file) + ": exercise.toml does not list " + wrong.misconception);
    } catch (const grading::BookError& error) {
      problems.push_back(shown(file) + ": " + error.what());
    }
  }
  if (shown_by_an_answer.empty()) problems.push_back("it has no wrong answer");
  for (const std::string& misconception : exercise.misconceptions) {
    if (blank(book.hint_for(misconception)))
      problems.push_back("chapters/misconceptions.toml has no hint for " + misconception);
    if (shown_by_an_answer.count(misconception) == 0)
      problems.push_back("no wrong answer shows the misconception " + misconception);
  }
}

void check_sources(const Exercise& exercise, Problems& problems) {
  check_written(exercise.folder, problems);
  check_written(exercise.solution.parent_path(), problems);
  const std::string contract = text_or_empty(exercise.contract);
  const std::string stub = text_or_empty(exercise.stub);
  if (contract.empty()) problems.push_back("there is no " + shown(exercise.contract));
  if (!contract.empty() && contract.find("///") == std::string::npos)
    problems.push_back("the contract has no doc comment");
  if (stub.find("todo()") == std::string::npos)
    problems.push_back("the stub does not say contact::todo()");
  if (stub.find("\"" + exercise.contract.filename().string() + "\"") == std::string::npos)
    problems.push_back("the stub does not include the contract");
  for (const fs::path& file : {exercise.solution, exercise.test_source}) {
    if (!fs::exists(file)) problems.push_back("there is no " + shown(file));
  }
  const std::set<std::string> own{exercise.name + ".hpp", exercise.name + ".cpp", "exercise.toml",
                                  exercise.breaks};
  require_only(
      exercise.folder,
      [&](const fs::path& entry) { return own.count(entry.filename().string()) != 0; }, problems);
  require_only(
      exercise.solution.parent_path(),
      [&](const fs::path& entry) {
        return entry == exercise.solution || entry.filename() == "equivalent.toml" ||
               (entry.filename() == "wrong" && fs::is_directory(entry));
      },
      problems);
  require_only(
      exercise.wrong_answers,
      [](const fs::path& entry) {
        return entry.extension() == ".cpp" || entry.extension() == ".patch";
      },
      problems);
}

// An exercise of the kind "break" gives code that is wrong. That it is wrong is shown by its
// solution, whose inputs break it, and that it is not wrong everywhere by its wrong answers.
void check_given(const Exercise& exercise, Problems& problems) {
  if (exercise.breaks.empty()) {
    if (exercise.kind == "break") problems.push_back("it does not say what it breaks");
    return;
  }
  if (exercise.kind != "break") problems.push_back("only an exercise of kind break has `breaks`");
  if (exercise.breaks.find('/') != std::string::npos || !exercise.breaks.ends_with(".hpp") ||
      exercise.given == exercise.contract)
    problems.push_back("`breaks` is a header of its own in the exercise's folder, not '" +
                       exercise.breaks + "'");
  const std::string given = text_or_empty(exercise.given);
  if (given.empty()) problems.push_back("there is no " + shown(exercise.given));
  if (given.find("namespace given") == std::string::npos)
    problems.push_back("the code to break is not in the namespace `given`");
  if (text_or_empty(exercise.test_source).find('"' + exercise.breaks + '"') == std::string::npos)
    problems.push_back("the tests do not include " + exercise.breaks);
}

DevResult check_exercise(const Book& book, const Exercise& exercise) {
  DevResult result{"exercise", exercise.id(), {}};
  Problems& problems = result.problems;
  if (blank(exercise.title)) problems.push_back("it has no title");
  if (blank(exercise.brief)) problems.push_back("it has no brief");
  if (!(exercise.minutes > 0.0)) problems.push_back("it does not say how many minutes it takes");
  if (!contains({"worked", "completion", "blank", "transfer", "break"}, exercise.kind))
    problems.push_back("kind must be worked, completion, blank, transfer or break, not '" +
                       exercise.kind + "'");
  const Chapter* chapter = book.chapter_called(exercise.chapter);
  const bool objective_known =
      chapter != nullptr &&
      std::any_of(chapter->objectives.begin(), chapter->objectives.end(),
                  [&](const grading::Objective& objective) {
                    return exercise.objective == objective.id ||
                           exercise.objective == chapter->slug + "/" + objective.id;
                  });
  if (!objective_known)
    problems.push_back("its chapter has no objective '" + exercise.objective + "'");
  check_tests(exercise, problems);
  check_hints(exercise, problems);
  check_wrong_answers(book, exercise, problems);
  check_sources(exercise, problems);
  check_given(exercise, problems);
  return result;
}

std::vector<DevResult> check_misconceptions(const Book& book) {
  std::set<std::string> used;
  for (const Exercise& exercise : book.exercises())
    used.insert(exercise.misconceptions.begin(), exercise.misconceptions.end());
  static const std::regex kebab("[a-z0-9]+(-[a-z0-9]+)*");
  std::vector<DevResult> results;
  for (const auto& [id, misconception] : book.misconceptions()) {
    DevResult result{"misconception", id, {}};
    if (!std::regex_match(id, kebab)) result.problems.push_back("its id is not written like-this");
    if (blank(misconception.summary)) result.problems.push_back("it has no summary");
    if (blank(misconception.hint)) result.problems.push_back("it has no hint");
    if (used.count(id) == 0) result.problems.push_back("no exercise knows it");
    results.push_back(std::move(result));
  }
  return results;
}

}  // namespace

std::vector<DevResult> check_book_files(const Book& book) {
  std::vector<DevResult> results;
  for (const grading::BookProblem& problem : book.problems())
    results.push_back({"file", shown(problem.file), {problem.what}});

  std::map<std::string, std::string> home;
  Problems names;
  if (book.base() != nullptr) {
    for (const Chapter& chapter : book.base()->chapters()) {
      for (const fs::path& header : headers_of(chapter))
        home.emplace(header.filename().string(), chapter.slug);
    }
  }
  for (const Chapter& chapter : book.chapters()) {
    for (const fs::path& path : headers_of(chapter)) {
      const std::string header = path.filename().string();
      const auto [earlier, is_new] = home.emplace(header, chapter.slug);
      if (!is_new)
        names.push_back(header + " is in " + earlier->second + " and in " + chapter.slug);
    }
  }
  results.push_back({"header names", "chapters", names});

  for (const Chapter& chapter : book.chapters())
    results.push_back(check_chapter(book, chapter, home));
  Problems without_chapter;
  for (const char* tree : {"chapters", "exercises", "solutions"}) {
    for (const fs::path& folder : entries_of(book.root() / tree)) {
      if (fs::is_directory(folder) && !left_by_a_tool(folder) &&
          book.chapter_called(folder.filename().string()) == nullptr)
        without_chapter.push_back("stray: " + shown(folder) +
                                  " has no chapter.toml that can be read");
    }
  }
  results.push_back({"folders", "chapters, exercises, solutions", without_chapter});
  for (const Exercise& exercise : book.exercises())
    results.push_back(check_exercise(book, exercise));
  for (DevResult& result : check_misconceptions(book)) results.push_back(std::move(result));
  return results;
}

}  // namespace contact::cli
