// contact new: folders for a chapter, an exercise or a pack that build, and whose checks fail only
// for want of content.

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <regex>

#include "../../grading/book/pack.hpp"
#include "../commands.hpp"
#include "../program.hpp"
#include "../terminal/terminal.hpp"

namespace fs = std::filesystem;

namespace contact::cli {

namespace {

struct Names {
  std::string slug;  ///< 03_polygons
  std::string stem;  ///< polygons
  std::string name;  ///< an exercise's or a pack's name; empty for a chapter
  /// Of a pack: the versions of the book that it needs, and who writes it.
  std::string book;
  std::string author;
};

std::string titled(const std::string& name) {
  std::string title = name;
  std::replace(title.begin(), title.end(), '_', ' ');
  std::replace(title.begin(), title.end(), '-', ' ');
  if (!title.empty())
    title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
  return title;
}

std::string filled(std::string text, const Names& names) {
  const std::pair<std::string, std::string> tokens[] = {
      {"@SLUG@", names.slug}, {"@STEM@", names.stem},
      {"@NAME@", names.name}, {"@TITLE@", titled(names.name.empty() ? names.stem : names.name)},
      {"@BOOK@", names.book}, {"@AUTHOR@", names.author},
  };
  for (const auto& [token, value] : tokens) {
    for (std::size_t at = 0; (at = text.find(token, at)) != std::string::npos; at += value.size())
      text.replace(at, token.size(), value);
  }
  return text;
}

// The templates are in cli/authors/templates/KIND, with the paths that they will have under
// `target_root`, and with tokens in names and text.
std::vector<fs::path> copy_templates(const grading::Book& book, const std::string& kind,
                                     const Names& names, const fs::path& target_root) {
  const fs::path templates = book.book_root() / "cli" / "authors" / "templates" / kind;
  std::vector<std::pair<fs::path, fs::path>> copies;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(templates)) {
    if (!entry.is_regular_file()) continue;
    std::string target = filled(entry.path().lexically_relative(templates).string(), names);
    // Named so that neither the build nor a linter takes a template for a source.
    if (target.ends_with(".in")) target.resize(target.size() - 3);
    copies.emplace_back(entry.path(), target_root / target);
  }
  std::sort(copies.begin(), copies.end());
  for (const auto& [from, to] : copies) {
    if (fs::exists(to))
      throw grading::BookError(shown(to) + " already exists; nothing was created");
  }
  std::vector<fs::path> made;
  for (const auto& [from, to] : copies) {
    fs::create_directories(to.parent_path());
    grading::write_text(to, filled(grading::read_text(from), names));
    made.push_back(to);
  }
  return made;
}

// The chapter says the order of its exercises, so a new one goes to the end of its line.
void append_to_chapter(const grading::Chapter& chapter, const std::string& name) {
  const fs::path file = chapter.folder / "chapter.toml";
  std::string text = grading::read_text(file);
  static const std::regex line(R"((^|\n)exercises\s*=\s*\[([^\]]*)\])");
  std::smatch match;
  if (!std::regex_search(text, match, line))
    throw grading::BookError(shown(file) + " has no line `exercises = [...]` to add " + name +
                             " to");
  std::string inside = match[2];
  while (!inside.empty() && (inside.back() == ' ' || inside.back() == ',' || inside.back() == '\n'))
    inside.pop_back();
  const std::string replacement = std::string(match[1]) + "exercises = [" + inside +
                                  (inside.empty() ? "" : ", ") + "\"" + name + "\"]";
  text.replace(static_cast<std::size_t>(match.position(0)),
               static_cast<std::size_t>(match.length(0)), replacement);
  grading::write_text(file, text);
}

void say_made(const std::vector<fs::path>& made) {
  for (const fs::path& file : made) say("  " + shown(file));
}

void require_new_chapter(const grading::Book& book, const std::string& slug) {
  const std::string of = book.base() != nullptr ? " in the pack" : "";
  for (const grading::Chapter& chapter : book.chapters()) {
    if (chapter.slug.substr(0, 2) == slug.substr(0, 2))
      throw grading::BookError("there is a chapter of that number" + of + ": " + chapter.slug);
    if (chapter.slug.substr(3) == slug.substr(3))
      throw grading::BookError("there is a chapter of that name" + of + ": " + chapter.slug);
  }
}

void require_new_exercise(const grading::Book& book, const std::string& name) {
  for (const grading::Exercise& exercise : book.exercises()) {
    if (exercise.name == name)
      throw grading::BookError("there is an exercise of that name: " + exercise.id() +
                               "; short names are unique across the book");
  }
}

int new_chapter(Context& context, const std::string& slug) {
  static const std::regex pattern(R"(\d\d_[a-z][a-z0-9_]*)");
  if (!std::regex_match(slug, pattern))
    throw grading::UnknownName(
        "a chapter's name is two digits and a word, such as 03_polygons; not '" + slug + "'");
  const grading::Book& book = context.book();
  const bool in_pack = book.base() != nullptr;
  require_new_chapter(book, slug);
  if (in_pack) require_new_chapter(*book.base(), slug);
  const std::vector<fs::path> made = copy_templates(
      book, in_pack ? "pack_chapter" : "chapter", {slug, slug.substr(3), "", "", ""}, book.root());
  say("Made " + slug + ":");
  say_made(made);
  say(in_pack ? "It builds. `" + program_as_typed() + " dev check` says what it still lacks; `" +
                    program_as_typed() + " new exercise " + slug + "/NAME` adds an exercise."
              : "It builds. `contact dev check` and `contact test` say what it still lacks.");
  return exit_passed;
}

int new_exercise(Context& context, const std::string& id) {
  static const std::regex pattern(R"((\d\d_[a-z][a-z0-9_]*)/([a-z][a-z0-9_]*))");
  std::smatch match;
  if (!std::regex_match(id, match, pattern))
    throw grading::UnknownName(
        "an exercise's name is its chapter and a word, such as 02_triangles/ray_triangle; not '" +
        id + "'");
  const grading::Book& book = context.book();
  const std::string slug = match[1];
  const std::string name = match[2];
  const grading::Chapter* chapter = book.find_chapter(slug);
  if (chapter == nullptr)
    throw grading::UnknownName("there is no chapter " + slug + "; `" + program_as_typed() +
                               " new chapter " + slug + "` makes it");
  require_new_exercise(book, name);
  if (book.base() != nullptr) require_new_exercise(*book.base(), name);
  const std::vector<fs::path> made =
      copy_templates(book, "exercise", {slug, slug.substr(3), name, "", ""}, book.root());
  append_to_chapter(*chapter, name);
  say("Made " + id + ":");
  say_made(made);
  say("and added it to " + shown(chapter->folder / "chapter.toml") +
      ". Write the contract first, then its tests.");
  say("`" + program_as_typed() + " dev check " + name + "` says what it still lacks.");
  return exit_passed;
}

// "My Course 2" gives "my-course-2".
std::string pack_name(const fs::path& folder) {
  std::string name;
  for (const char c : folder.filename().string()) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 128 && std::isalnum(byte) != 0)
      name += static_cast<char>(std::tolower(byte));
    else if (!name.empty() && name.back() != '-')
      name += '-';
  }
  while (!name.empty() && name.back() == '-') name.pop_back();
  return !name.empty() && std::isalpha(static_cast<unsigned char>(name.front())) != 0
             ? name
             : "pack" + (name.empty() ? "" : "-" + name);
}

// Inside a text of TOML, so without what would end it.
std::string author_of(Context& context, std::string name) {
  if (name.empty()) {
    grading::ProcessSpec spec;
    spec.command = {"git", "config", "user.name"};
    spec.time_limit = 10.0;
    try {
      name = grading::run_process(context.loop(), spec).output;
    } catch (const std::exception&) {
      // There is no git.
    }
  }
  std::erase_if(
      name, [](char c) { return c == '"' || c == '\\' || static_cast<unsigned char>(c) < ' '; });
  const char* user = std::getenv("USER");
  if (name.empty() && user != nullptr) name = user;
  return name.empty() ? "Unknown" : name;
}

int new_pack(Context& context, const std::string& given, const std::string& author) {
  const grading::Book& book = context.book();
  fs::path folder = fs::absolute(given).lexically_normal();
  if (!folder.has_filename()) folder = folder.parent_path();
  const fs::path inside = folder.lexically_relative(book.book_root());
  if (!inside.empty() && *inside.begin() != "..")
    throw grading::UnknownName(folder.string() +
                               " is inside the book: a pack is a folder of its own elsewhere");
  if (fs::exists(folder) && !(fs::is_directory(folder) && fs::is_empty(folder)))
    throw grading::BookError(folder.string() +
                             " already exists and is no empty folder; nothing was created");
  const Names names{"", "", pack_name(folder), grading::range_from(program_version()),
                    author_of(context, author)};
  const std::vector<fs::path> made = copy_templates(book, "pack", names, folder);
  say("Made the pack " + names.name + " in " + folder.string() + ":");
  for (const fs::path& file : made) say("  " + file.lexically_relative(folder).string());
  say("It needs version " + names.book + " of the book, and has one exercise as an example. Next:");
  for (const char* command : {"list", "dev check", "new chapter 51_my_chapter"})
    say("  ./contact --pack " + quoted_for_shell(folder.string()) + " " + command);
  return exit_passed;
}

}  // namespace

void add_new(Command app, Action& action) {
  const Command command = app.add_subcommand(new_command);
  command.require_subcommand();
  auto slug = std::make_shared<std::string>();
  const Command chapter = command.add_subcommand(
      "chapter", "Create a chapter that builds, with templates for its content");
  chapter.add_option("slug", *slug, "Two digits and a name: 03_polygons").required();
  chapter.callback([&action, slug] {
    action = [slug](Context& context) { return new_chapter(context, *slug); };
  });
  auto folder = std::make_shared<std::string>();
  auto author = std::make_shared<std::string>();
  const Command pack = command.add_subcommand(
      "pack", "Create a pack: a folder outside the book for chapters and exercises of your own");
  pack.add_option("folder", *folder, "A folder that does not exist yet, or is empty").required();
  pack.add_option("--author", *author, "Who writes it (default: git's user.name)");
  pack.callback([&action, folder, author] {
    action = [folder, author](Context& context) { return new_pack(context, *folder, *author); };
  });
  auto id = std::make_shared<std::string>();
  const Command exercise = command.add_subcommand(
      "exercise", "Create an exercise that builds, with templates for its content");
  exercise.add_option("id", *id, "Chapter and name: 03_polygons/point_in_polygon").required();
  exercise.callback(
      [&action, id] { action = [id](Context& context) { return new_exercise(context, *id); }; });
}

}  // namespace contact::cli
