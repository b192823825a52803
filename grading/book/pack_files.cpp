// What is wrong with a pack's folders and files, each fault with its file and line.

#include <algorithm>
#include <initializer_list>
#include <map>
#include <regex>
#include <set>

#include <toml++/toml.h>

#include "pack.hpp"

namespace fs = std::filesystem;

namespace contact::grading {

namespace {

using Faults = std::vector<PackFault>;
using Words = std::initializer_list<std::string_view>;

int toml_line(const toml::node& node) { return static_cast<int>(node.source().begin.line); }

std::string keys_text(Words words) {
  std::string text;
  for (const std::string_view word : words) text += (text.empty() ? "" : ", ") + std::string(word);
  return text;
}

/// The table of a file; none, and a fault, if the file is not understood.
std::optional<toml::table> parsed_file(const fs::path& file, Faults& faults) {
  try {
    const std::string text = read_text(file);
    return toml::parse(std::string_view(text), file.string());
  } catch (const toml::parse_error& error) {
    faults.push_back(
        {file, static_cast<int>(error.source().begin.line), std::string(error.description())});
  } catch (const BookError& error) {
    faults.push_back({file, 1, error.what()});
  }
  return std::nullopt;
}

void check_keys(const fs::path& file, const toml::table& table, Words needed, Words others,
                Faults& faults) {
  for (const std::string_view key : needed) {
    if (!table.contains(key))
      faults.push_back({file, 1, "the key '" + std::string(key) + "' is missing"});
  }
  const auto in = [](Words words, std::string_view key) {
    return std::find(words.begin(), words.end(), key) != words.end();
  };
  for (const auto& [key, node] : table) {
    if (!in(needed, key.str()) && !in(others, key.str()))
      faults.push_back({file, toml_line(node),
                        "unknown key '" + std::string(key.str()) + "'; there are " +
                            keys_text(needed) + ", " + keys_text(others)});
  }
}

/// Calls `visit` with each text of a list, and with the line it is in.
template <class Visit>
void each_text(const toml::table& table, std::string_view key, const Visit& visit) {
  const toml::array* list = table[key].as_array();
  if (list == nullptr) return;
  for (const toml::node& node : *list) visit(node.value_or(std::string()), toml_line(node));
}

std::vector<fs::path> pack_entries(const fs::path& folder) {
  std::vector<fs::path> entries;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    if (!entry.path().filename().string().starts_with('.')) entries.push_back(entry.path());
  }
  std::sort(entries.begin(), entries.end());
  return entries;
}

/// Names of the book that a pack may not use again.
struct TakenNames {
  explicit TakenNames(const Book& book) {
    for (const Chapter& chapter : book.chapters()) {
      numbers[chapter.slug.substr(0, 2)] = chapter.slug;
      words[chapter.slug.substr(std::min<std::size_t>(3, chapter.slug.size()))] = chapter.slug;
      for (const fs::path& header : pack_entries(chapter.folder / "contact"))
        headers[header.filename().string()] = chapter.slug;
    }
    for (const Exercise& exercise : book.exercises()) exercises[exercise.name] = exercise.id();
  }
  std::map<std::string, std::string> numbers, words, exercises, headers;
};

class PackFiles {
 public:
  explicit PackFiles(const Book& pack) : pack_(pack), taken_(*pack.base()) {}

  Faults faults() {
    for (const char* tree : {"chapters", "exercises"}) {
      if (!fs::is_directory(pack_.root() / tree))
        add(pack_.root() / "pack.toml", 1,
            "beside this file the folder " + std::string(tree) + "/ is missing: create it");
    }
    for (const fs::path& folder : pack_entries(pack_.root() / "chapters")) {
      if (fs::is_directory(folder)) check_chapter(folder);
    }
    for (const fs::path& folder : pack_entries(pack_.root() / "exercises")) {
      if (fs::is_directory(folder)) check_exercises(folder);
    }
    check_misconceptions();
    return std::move(faults_);
  }

 private:
  void add(const fs::path& file, int line, std::string what) {
    faults_.push_back({file, line, std::move(what)});
  }

  void check_chapter(const fs::path& folder) {
    const std::string slug = folder.filename().string();
    const fs::path file = folder / "chapter.toml";
    if (!fs::exists(file)) {
      add(file, 1, "this file is missing; `contact --pack FOLDER new chapter` makes a chapter");
      return;
    }
    check_slug(file, slug);
    for (const fs::path& header : pack_entries(folder / "contact")) {
      const auto taken = taken_.headers.find(header.filename().string());
      if (taken != taken_.headers.end())
        add(header, 1, "the book's " + taken->second + " has a header of this name: rename it");
    }
    const std::optional<toml::table> table = parsed_file(file, faults_);
    if (!table) return;
    check_keys(
        file, *table, {"title", "part", "status"},
        {"tooltip", "builds_on", "in_lesson", "recall", "exercises", "objectives", "sources"},
        faults_);
    check_builds_on(file, *table);
    each_text(*table, "exercises", [&](const std::string& name, int line) {
      const std::string where = "exercises/" + slug + "/" + name;
      if (!fs::is_directory(pack_.root() / where))
        add(file, line,
            "it lists the exercise " + name + ", and the folder " + where + "/ is missing");
      else if (!fs::exists(pack_.root() / where / "exercise.toml"))
        add(file, line,
            "it lists the exercise " + name + ", and " + where + "/exercise.toml is missing");
      order_[slug + "/" + name] = {file, line, {}};
    });
  }

  void check_slug(const fs::path& file, const std::string& slug) {
    static const std::regex pattern(R"(\d\d_[a-z][a-z0-9_]*)");
    if (!std::regex_match(slug, pattern)) {
      add(file, 1,
          "a chapter's folder is two digits and a name, such as 50_my_chapter; not '" + slug + "'");
      return;
    }
    if (const auto taken = taken_.words.find(slug.substr(3)); taken != taken_.words.end())
      add(file, 1, "the book has a chapter of this name, " + taken->second + ": rename the folder");
    else if (const auto number = taken_.numbers.find(slug.substr(0, 2));
             number != taken_.numbers.end())
      add(file, 1,
          "the book has a chapter of this number, " + number->second +
              ": take another, the book leaves those from 50 to packs");
  }

  void check_builds_on(const fs::path& file, const toml::table& table) {
    if (const toml::array* list = table["builds_on"].as_array();
        list != nullptr && list->source().begin.line != list->source().end.line)
      add(file, toml_line(*list), "builds_on must be written on one line");
    each_text(table, "builds_on", [&](const std::string& slug, int line) {
      if (pack_.chapter_called(slug) == nullptr)
        add(file, line, "it builds on " + slug + ", which neither the pack nor the book has");
    });
  }

  void check_exercises(const fs::path& chapter) {
    const std::string slug = chapter.filename().string();
    for (const fs::path& folder : pack_entries(chapter)) {
      if (!fs::is_directory(folder)) continue;
      const fs::path file = folder / "exercise.toml";
      if (!fs::exists(pack_.root() / "chapters" / slug / "chapter.toml"))
        add(file, 1, "the chapter of this exercise is missing: chapters/" + slug + "/chapter.toml");
      else if (fs::exists(file))
        check_exercise(file, slug, folder.filename().string());
    }
  }

  void check_exercise(const fs::path& file, const std::string& slug, const std::string& name) {
    static const std::regex pattern("[a-z][a-z0-9_]*");
    if (!std::regex_match(name, pattern))
      add(file, 1,
          "an exercise's folder is a lower-case word such as ray_triangle; not '" + name + "'");
    if (const auto taken = taken_.exercises.find(name); taken != taken_.exercises.end()) {
      PackFault fault{file, 1, {}};
      if (const auto line = order_.find(slug + "/" + name); line != order_.end())
        fault = line->second;
      add(fault.file, fault.line,
          "the book has an exercise called " + name + ", " + taken->second + ": rename this one");
    }
    const std::optional<toml::table> table = parsed_file(file, faults_);
    if (!table) return;
    check_keys(file, *table, {"title", "objective", "kind", "brief", "tests"},
               {"minutes", "hints", "misconceptions", "breaks", "inputs", "time_limit"}, faults_);
    try {
      const Exercise exercise = read_exercise(pack_.root(), slug, name);
      for (const fs::path& part :
           {exercise.contract, exercise.stub, exercise.solution, exercise.test_source}) {
        if (!fs::exists(part))
          add(file, 1,
              "a file of this exercise is missing: " +
                  part.lexically_relative(pack_.root()).string());
      }
    } catch (const BookError& error) {
      add_said(file, error.what());
    }
  }

  // Some messages begin with the file, or with the file and the line.
  void add_said(const fs::path& file, std::string what) {
    int line = 1;
    if (what.starts_with(file.string() + ":")) {
      what.erase(0, file.string().size() + 1);
      if (const std::size_t digits = what.find_first_not_of("0123456789");
          digits > 0 && digits != std::string::npos && what[digits] == ':') {
        line = std::stoi(what.substr(0, digits));
        what.erase(0, digits + 1);
      }
      what.erase(0, what.find_first_not_of(' '));
    }
    add(file, line, std::move(what));
  }

  void check_misconceptions() {
    const fs::path file = pack_.root() / "chapters" / "misconceptions.toml";
    if (!fs::exists(file)) return;
    const std::optional<toml::table> table = parsed_file(file, faults_);
    if (!table) return;
    for (const auto& [key, node] : *table) {
      const std::string id(key.str());
      if (pack_.base()->misconceptions().count(id) != 0)
        add(file, toml_line(node),
            "the book has a misconception called " + id +
                ": use it without an entry here, or rename this one");
      if (const toml::table* entry = node.as_table())
        check_keys(file, *entry, {"hint"}, {"summary"}, faults_);
      else
        add(file, toml_line(node), id + " must be a table with summary and hint");
    }
  }

  const Book& pack_;
  TakenNames taken_;
  /// Exercises that chapters list, with the line where they do.
  std::map<std::string, PackFault> order_;
  Faults faults_;
};

}  // namespace

std::vector<PackFault> faults_of_files(const Book& pack) { return PackFiles(pack).faults(); }

}  // namespace contact::grading
