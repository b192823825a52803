#include "book.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <numeric>
#include <set>
#include <sstream>

#include <toml++/toml.h>

namespace fs = std::filesystem;

namespace contact::grading {

namespace {

toml::table parse(const fs::path& file) {
  const std::string text = read_text(file);
  try {
    return toml::parse(std::string_view(text), file.string());
  } catch (const toml::parse_error& error) {
    throw BookError(file.string() + ":" + std::to_string(error.source().begin.line) + ": " +
                    std::string(error.description()));
  }
}

std::string text_of(const toml::table& table, std::string_view key) {
  return table[key].value_or(std::string());
}

std::vector<std::string> texts_of(const toml::table& table, std::string_view key) {
  std::vector<std::string> result;
  if (const toml::array* list = table[key].as_array()) {
    for (const toml::node& node : *list) result.push_back(node.value_or(std::string()));
  }
  return result;
}

std::vector<fs::path> folders_in(const fs::path& parent) {
  std::vector<fs::path> result;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(parent, error)) {
    if (entry.is_directory() && entry.path().filename().string().front() != '.')
      result.push_back(entry.path());
  }
  std::sort(result.begin(), result.end());
  return result;
}

struct VisibilityName {
  Visibility visibility;
  std::string_view key;
};

constexpr std::array<VisibilityName, 4> visibility_names{{
    {Visibility::shown, "shown"},
    {Visibility::after_due, "after_due"},
    {Visibility::values_withheld, "values_withheld"},
    {Visibility::hidden, "hidden"},
}};

std::string place(const fs::path& file, const toml::node& node) {
  return file.string() + ":" + std::to_string(node.source().begin.line) + ": ";
}

Visibility read_visibility(const fs::path& file, const toml::node& node, bool is_private) {
  const std::string text = node.value_or(std::string());
  const std::optional<Visibility> visibility = visibility_from_key(text);
  if (!visibility)
    throw BookError(place(file, node) +
                    "visibility is \"shown\", \"after_due\", \"values_withheld\" or \"hidden\"" +
                    (text.empty() ? "" : ", not \"" + text + "\""));
  // Every reader of the book has its tests, and runs them with `contact check`.
  if (!is_private && (*visibility == Visibility::hidden || *visibility == Visibility::after_due))
    throw BookError(place(file, node) + "visibility \"" + text +
                    "\" is for private tests (contact grade --private): every reader has this "
                    "one. \"values_withheld\" is possible");
  return *visibility;
}

TestSpec read_test(const fs::path& file, const toml::table& table, bool is_private) {
  static constexpr std::array<std::string_view, 5> known{"name", "points", "requires", "visibility",
                                                         "solution_seconds"};
  for (const auto& [key, node] : table) {
    if (std::find(known.begin(), known.end(), key.str()) == known.end())
      throw BookError(place(file, node) + "a test has no '" + std::string(key.str()) +
                      "': it has name, points, requires, visibility and solution_seconds");
  }
  TestSpec test{text_of(table, "name"), table["points"].value_or(0.0), texts_of(table, "requires"),
                is_private ? Visibility::hidden : Visibility::shown, is_private};
  if (const toml::node* node = table.get("visibility"))
    test.visibility = read_visibility(file, *node, is_private);
  test.solution_seconds = table["solution_seconds"].value_or(test.solution_seconds);
  if (!(test.solution_seconds >= TestSpec{}.solution_seconds))
    throw BookError(file.string() + ": solution_seconds of '" + test.name + "' must be " +
                    "at least 0.05, which is what a test without it has");
  return test;
}

std::vector<TestSpec> tests_of(const fs::path& file, const toml::table& table, bool is_private) {
  std::vector<TestSpec> tests;
  if (const toml::array* list = table["tests"].as_array()) {
    for (const toml::node& node : *list) {
      const toml::table* test = node.as_table();
      if (test == nullptr) throw BookError(place(file, node) + "each of [[tests]] must be a table");
      tests.push_back(read_test(file, *test, is_private));
    }
  }
  if (tests.empty()) throw BookError(file.string() + ": it lists no [[tests]]");
  return tests;
}

Chapter read_chapter(const fs::path& folder) {
  const toml::table table = parse(folder / "chapter.toml");
  Chapter chapter;
  chapter.slug = folder.filename().string();
  chapter.folder = folder;
  chapter.title = text_of(table, "title");
  chapter.status = text_of(table, "status");
  chapter.tooltip = text_of(table, "tooltip");
  chapter.part = table["part"].value_or(0);
  chapter.builds_on = texts_of(table, "builds_on");
  chapter.recall = texts_of(table, "recall");
  chapter.exercise_names = texts_of(table, "exercises");
  if (const toml::array* list = table["objectives"].as_array()) {
    for (const toml::node& node : *list) {
      if (const toml::table* objective = node.as_table()) {
        chapter.objectives.push_back({text_of(*objective, "id"), text_of(*objective, "text")});
      }
    }
  }
  return chapter;
}

std::string without_number(std::string_view slug) {
  const std::size_t underscore = slug.find('_');
  return std::string(underscore == std::string_view::npos ? slug : slug.substr(underscore + 1));
}

bool all_digits(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

}  // namespace

double Exercise::max_points() const {
  return std::accumulate(tests.begin(), tests.end(), 0.0,
                         [](double sum, const TestSpec& test) { return sum + test.points; });
}

double Exercise::check_seconds(const TestSpec& test) const {
  return std::min({20.0 * test.solution_seconds, 3.0, time_limit});
}

std::string_view key(Visibility visibility) {
  return visibility_names[static_cast<std::size_t>(visibility)].key;
}

std::optional<Visibility> visibility_from_key(std::string_view key) {
  for (const VisibilityName& name : visibility_names) {
    if (name.key == key) return name.visibility;
  }
  return std::nullopt;
}

std::vector<TestSpec> read_test_list(const fs::path& file, bool is_private) {
  return tests_of(file, parse(file), is_private);
}

Exercise read_exercise(const fs::path& root, const std::string& chapter, const std::string& name) {
  Exercise exercise;
  exercise.chapter = chapter;
  exercise.name = name;
  exercise.folder = root / "exercises" / chapter / name;
  exercise.contract = exercise.folder / (name + ".hpp");
  exercise.stub = exercise.folder / (name + ".cpp");
  exercise.solution = root / "solutions" / chapter / name / (name + ".cpp");
  exercise.wrong_answers = root / "solutions" / chapter / name / "wrong";
  exercise.test_source = root / "tests" / chapter / (name + "_test.cpp");

  const fs::path file = exercise.folder / "exercise.toml";
  const toml::table table = parse(file);
  exercise.title = text_of(table, "title");
  exercise.objective = text_of(table, "objective");
  exercise.kind = text_of(table, "kind");
  exercise.brief = text_of(table, "brief");
  exercise.minutes = table["minutes"].value_or(0.0);
  exercise.hints = texts_of(table, "hints");
  exercise.misconceptions = texts_of(table, "misconceptions");
  exercise.breaks = text_of(table, "breaks");
  if (!exercise.breaks.empty()) exercise.given = exercise.folder / exercise.breaks;
  exercise.time_limit = table["time_limit"].value_or(exercise.time_limit);
  if (!(exercise.time_limit > 0.0))
    throw BookError(file.string() + ": time_limit must be above zero");
  exercise.tests = tests_of(file, table, false);
  return exercise;
}

Book::Book(fs::path root, fs::path work, std::shared_ptr<const Book> base)
    : root_(std::move(root)), work_(std::move(work)), base_(std::move(base)) {
  read_chapters();
  read_exercises();
  read_misconceptions();
}

void Book::read_chapters() {
  for (const fs::path& folder : folders_in(root_ / "chapters")) {
    if (!fs::exists(folder / "chapter.toml")) continue;
    try {
      chapters_.push_back(read_chapter(folder));
    } catch (const BookError& error) {
      problems_.push_back({folder / "chapter.toml", error.what()});
    }
  }
}

void Book::read_exercises() {
  // The chapter says the order; a folder that it does not mention comes after, so that nothing is
  // invisible.
  std::vector<std::string> slugs;
  for (const fs::path& folder : folders_in(root_ / "exercises"))
    slugs.push_back(folder.filename().string());
  for (const std::string& slug : slugs) {
    std::vector<std::string> names;
    const auto chapter =
        std::find_if(chapters_.begin(), chapters_.end(),
                     [&](const Chapter& candidate) { return candidate.slug == slug; });
    std::set<std::string> seen;
    if (chapter != chapters_.end()) {
      for (const std::string& name : chapter->exercise_names) {
        if (fs::exists(root_ / "exercises" / slug / name / "exercise.toml") &&
            seen.insert(name).second)
          names.push_back(name);
      }
    }
    for (const fs::path& folder : folders_in(root_ / "exercises" / slug)) {
      const std::string name = folder.filename().string();
      if (fs::exists(folder / "exercise.toml") && seen.insert(name).second) names.push_back(name);
    }
    for (const std::string& name : names) {
      try {
        exercises_.push_back(read_exercise(root_, slug, name));
      } catch (const BookError& error) {
        problems_.push_back({root_ / "exercises" / slug / name / "exercise.toml", error.what()});
      }
    }
  }
}

void Book::read_misconceptions() {
  const fs::path file = root_ / "chapters" / "misconceptions.toml";
  if (!fs::exists(file)) return;
  try {
    for (const auto& [key, node] : parse(file)) {
      if (const toml::table* entry = node.as_table()) {
        const std::string id(key.str());
        misconceptions_[id] = {id, text_of(*entry, "summary"), text_of(*entry, "hint")};
      }
    }
  } catch (const BookError& error) {
    problems_.push_back({file, error.what()});
  }
}

fs::path Book::work_file(const Exercise& exercise) const {
  return work_ / exercise.chapter / (exercise.name + ".cpp");
}

bool Book::started(const Exercise& exercise) const { return fs::exists(work_file(exercise)); }

const Exercise* Book::find_exercise(std::string_view name) const {
  std::vector<const Exercise*> found;
  for (const Exercise& exercise : exercises_) {
    if (exercise.id() == name) return &exercise;
    if (exercise.name == name) found.push_back(&exercise);
  }
  if (found.size() == 1) return found.front();
  if (found.size() > 1) {
    std::string text = "more than one exercise is called '" + std::string(name) + "': ";
    for (const Exercise* exercise : found) text += exercise->id() + " ";
    throw UnknownName(text + "(give the chapter too)");
  }
  // A path: the last component that names an exercise wins, read together with a chapter folder
  // before it.
  const fs::path path{std::string(name)};
  std::vector<std::string> parts;
  for (const fs::path& part : path) parts.push_back(part.string());
  if (parts.empty()) return nullptr;
  parts.back() = path.filename().stem().string();
  for (std::size_t i = parts.size(); i-- > 0;) {
    for (const Exercise& exercise : exercises_) {
      if (exercise.name != parts[i]) continue;
      for (std::size_t j = 0; j < i; ++j) {
        if (const Chapter* chapter = find_chapter(parts[j]);
            chapter != nullptr && chapter->slug == exercise.chapter)
          return &exercise;
      }
    }
  }
  return parts.size() > 1 ? find_exercise(parts.back()) : nullptr;
}

const Exercise& Book::exercise(std::string_view name) const {
  if (const Exercise* found = find_exercise(name)) return *found;
  throw_unknown(name, "exercise", {});
}

namespace {

// " The exercises of 08_convex_hull are a, b and c."
std::string exercises_text(const Chapter& chapter, const std::vector<const Exercise*>& exercises) {
  if (exercises.empty()) return " " + chapter.slug + " has no exercises.";
  std::string text = " The exercises of " + chapter.slug + " are ";
  if (exercises.size() == 1) text = " The exercise of " + chapter.slug + " is ";
  for (std::size_t i = 0; i < exercises.size(); ++i) {
    const bool last = i + 1 == exercises.size();
    text += (i == 0 ? "" : last ? " and " : ", ") + exercises[i]->name;
  }
  return text + ".";
}

}  // namespace

void Book::throw_unknown(std::string_view name, const std::string& kind,
                         std::vector<std::string> names) const {
  for (const BookProblem& problem : problems_) {
    const fs::path folder = problem.file.parent_path();
    if (folder.filename() == fs::path(std::string(name)).stem()) throw BookError(problem.what);
  }
  for (const Exercise& candidate : exercises_) {
    names.push_back(candidate.name);
    names.push_back(candidate.id());
  }
  std::string text = "there is no " + kind + " called '" + std::string(name) + "'.";
  const std::vector<std::string> near = nearest(name, names);
  if (!near.empty()) {
    text += " Did you mean ";
    for (std::size_t i = 0; i < near.size(); ++i) text += (i ? " or " : "") + near[i];
    text += "?";
  } else if (const std::size_t slash = name.rfind('/'); slash != std::string_view::npos) {
    if (const Chapter* chapter = find_chapter(name.substr(0, slash)))
      text += exercises_text(*chapter, exercises_of(*chapter));
  }
  throw UnknownName(text + " `contact list` shows all.");
}

const Chapter* Book::find_chapter(std::string_view name) const {
  while (!name.empty() && name.back() == '/') name.remove_suffix(1);
  if (const std::size_t slash = name.rfind('/'); slash != std::string_view::npos)
    name.remove_prefix(slash + 1);
  for (const Chapter& chapter : chapters_) {
    if (chapter.slug == name || without_number(chapter.slug) == name) return &chapter;
    if (all_digits(name) && name.size() <= 4 && all_digits(chapter.slug.substr(0, 2)) &&
        std::stoi(std::string(name)) == std::stoi(chapter.slug.substr(0, 2)))
      return &chapter;
  }
  return nullptr;
}

const Chapter* Book::chapter_called(std::string_view slug) const {
  for (const Chapter& chapter : chapters_) {
    if (chapter.slug == slug) return &chapter;
  }
  return base_ ? base_->chapter_called(slug) : nullptr;
}

std::vector<const Exercise*> Book::exercises_of(const Chapter& chapter) const {
  std::vector<const Exercise*> result;
  for (const Exercise& exercise : exercises_) {
    if (exercise.chapter == chapter.slug) result.push_back(&exercise);
  }
  return result;
}

std::vector<const Exercise*> Book::meant_by(std::string_view name) const {
  if (const Exercise* found = find_exercise(name)) return {found};
  if (const Chapter* chapter = find_chapter(name)) return exercises_of(*chapter);
  std::vector<std::string> slugs;
  for (const Chapter& chapter : chapters_) {
    slugs.push_back(chapter.slug);
    slugs.push_back(without_number(chapter.slug));
  }
  throw_unknown(name, "exercise or chapter", std::move(slugs));
}

std::vector<const Exercise*> Book::chosen(const std::vector<std::string>& names) const {
  std::vector<const Exercise*> wanted;
  for (const std::string& name : names) {
    for (const Exercise* exercise : meant_by(name)) wanted.push_back(exercise);
  }
  // In the book's order, each once.
  std::vector<const Exercise*> result;
  for (const Exercise& candidate : exercises_) {
    if (names.empty() || std::find(wanted.begin(), wanted.end(), &candidate) != wanted.end())
      result.push_back(&candidate);
  }
  return result;
}

std::string Book::hint_for(const std::string& misconception) const {
  const auto found = misconceptions_.find(misconception);
  if (found != misconceptions_.end()) return found->second.hint;
  return base_ ? base_->hint_for(misconception) : std::string();
}

std::string Book::summary_of(const std::string& misconception) const {
  const auto found = misconceptions_.find(misconception);
  if (found != misconceptions_.end()) return found->second.summary;
  return base_ ? base_->summary_of(misconception) : std::string();
}

std::string read_text(const fs::path& file) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream(std::fopen(file.c_str(), "rb"),
                                                               &std::fclose);
  std::string text;
  std::array<char, 16384> part{};
  while (stream && std::feof(stream.get()) == 0 && std::ferror(stream.get()) == 0)
    text.append(part.data(), std::fread(part.data(), 1, part.size(), stream.get()));
  if (!stream || std::ferror(stream.get()) != 0) throw BookError("cannot read " + file.string());
  return text;
}

std::string solution_text(const Exercise& exercise) {
  std::istringstream lines(read_text(exercise.solution));
  std::string text;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t first = line.find_first_not_of(' ');
    if (first == std::string::npos || line.compare(first, 3, "//?") != 0) text += line + "\n";
  }
  return text;
}

}  // namespace contact::grading
