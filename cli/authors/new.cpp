// contact new: folders for a chapter or an exercise that build, and whose checks fail only for want
// of content.

#include <algorithm>
#include <regex>

#include "../commands.hpp"
#include "../terminal/terminal.hpp"

namespace fs = std::filesystem;

namespace contact::cli {

namespace {

struct Names {
  std::string slug;  ///< 03_polygons
  std::string stem;  ///< polygons
  std::string name;  ///< an exercise's name; empty for a chapter
};

std::string titled(const std::string& name) {
  std::string title = name;
  std::replace(title.begin(), title.end(), '_', ' ');
  if (!title.empty())
    title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
  return title;
}

std::string filled(std::string text, const Names& names) {
  const std::pair<std::string, std::string> tokens[] = {
      {"@SLUG@", names.slug},
      {"@STEM@", names.stem},
      {"@NAME@", names.name},
      {"@TITLE@", titled(names.name.empty() ? names.stem : names.name)},
  };
  for (const auto& [token, value] : tokens) {
    for (std::size_t at = 0; (at = text.find(token, at)) != std::string::npos; at += value.size())
      text.replace(at, token.size(), value);
  }
  return text;
}

// The templates are in cli/authors/templates/KIND, with the paths that they will have under the
// root, and with tokens in names and text.
std::vector<fs::path> copy_templates(const grading::Book& book, const std::string& kind,
                                     const Names& names) {
  const fs::path templates = book.root() / "cli" / "authors" / "templates" / kind;
  std::vector<std::pair<fs::path, fs::path>> copies;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(templates)) {
    if (!entry.is_regular_file()) continue;
    std::string target = filled(entry.path().lexically_relative(templates).string(), names);
    // Named so that neither the build nor a linter takes a template for a source.
    if (target.ends_with(".in")) target.resize(target.size() - 3);
    copies.emplace_back(entry.path(), book.root() / target);
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

int new_chapter(Context& context, const std::string& slug) {
  static const std::regex pattern(R"(\d\d_[a-z][a-z0-9_]*)");
  if (!std::regex_match(slug, pattern))
    throw grading::UnknownName(
        "a chapter's name is two digits and a word, such as 03_polygons; not '" + slug + "'");
  const grading::Book& book = context.book();
  for (const grading::Chapter& chapter : book.chapters()) {
    if (chapter.slug.substr(0, 2) == slug.substr(0, 2))
      throw grading::BookError("there is a chapter of that number: " + chapter.slug);
    if (chapter.slug.substr(3) == slug.substr(3))
      throw grading::BookError("there is a chapter of that name: " + chapter.slug);
  }
  const std::vector<fs::path> made = copy_templates(book, "chapter", {slug, slug.substr(3), ""});
  say("Made " + slug + ":");
  say_made(made);
  say("It builds. `contact dev check` and `contact test` say what it still lacks.");
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
    throw grading::UnknownName("there is no chapter " + slug + "; `contact new chapter " + slug +
                               "` makes it");
  if (const grading::Exercise* same = book.find_exercise(name);
      same != nullptr && same->name == name)
    throw grading::BookError("there is an exercise of that name: " + same->id() +
                             "; short names are unique across the book");
  const std::vector<fs::path> made = copy_templates(book, "exercise", {slug, slug.substr(3), name});
  append_to_chapter(*chapter, name);
  say("Made " + id + ":");
  say_made(made);
  say("and added it to " + shown(chapter->folder / "chapter.toml") +
      ". Write the contract first, then its tests.");
  say("`contact dev check " + name + "` says what it still lacks.");
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
  auto id = std::make_shared<std::string>();
  const Command exercise = command.add_subcommand(
      "exercise", "Create an exercise that builds, with templates for its content");
  exercise.add_option("id", *id, "Chapter and name: 03_polygons/point_in_polygon").required();
  exercise.callback(
      [&action, id] { action = [id](Context& context) { return new_exercise(context, *id); }; });
}

}  // namespace contact::cli
