// contact scene: the contents of a scene file, its faults, and the list of the book's scenes.

#include <algorithm>
#include <system_error>

#include <nlohmann/json.hpp>

#include <contact/scene/scene_file.hpp>
#include "../commands.hpp"
#include "../terminal/terminal.hpp"

namespace contact::cli {

namespace {

namespace fs = std::filesystem;

fs::path folder_of(const fs::path& root) { return root / "chapters" / "20_scenes" / "scenes"; }

std::string count_of(std::size_t count, const char* one, const char* many) {
  return std::to_string(count) + ' ' + (count == 1 ? one : many);
}

std::size_t moving(const Scene& scene) {
  return static_cast<std::size_t>(std::count_if(scene.bodies.begin(), scene.bodies.end(),
                                                [](const SceneBody& body) { return body.moves; }));
}

std::string tolerance_of(const Scene& scene) {
  std::string words;
  if (scene.tolerance.position)
    words = "positions to " + shortest_text(*scene.tolerance.position) + " m";
  if (scene.tolerance.event_order)
    words += (words.empty() ? "" : " and ") + std::string("hits in order");
  return words;
}

std::string summary(const Scene& scene) {
  return count_of(scene.bodies.size(), "body", "bodies") + " (" + std::to_string(moving(scene)) +
         " moving), " + shortest_text(scene.duration) + " s, " + tolerance_of(scene) + ", " +
         count_of(scene.expect.size(), "expectation", "expectations");
}

nlohmann::json json_of(const fs::path& file, const Scene& scene) {
  nlohmann::json json{{"file", file.string()},
                      {"ok", true},
                      {"name", scene.name},
                      {"about", scene.about},
                      {"bodies", scene.bodies.size()},
                      {"moving", moving(scene)},
                      {"duration", scene.duration},
                      {"event_order", scene.tolerance.event_order},
                      {"expectations", scene.expect.size()}};
  json["position_tolerance"] = nullptr;
  if (scene.tolerance.position) json["position_tolerance"] = *scene.tolerance.position;
  return json;
}

nlohmann::json json_of(const fs::path& file, const scenes::SceneFileError& error) {
  nlohmann::json faults = nlohmann::json::array();
  for (const scenes::FileFault& found : error.faults()) {
    faults.push_back({{"line", found.line},
                      {"path", found.fault.path},
                      {"value", found.fault.value},
                      {"allowed", found.fault.allowed}});
  }
  return {{"file", file.string()}, {"ok", false}, {"faults", faults}};
}

int check(const std::vector<std::string>& words, bool json) {
  const Style style(stdout);
  nlohmann::json all = nlohmann::json::array();
  int code = exit_passed;
  std::vector<fs::path> files;
  for (const std::string& word : words) files.push_back(scene_path(word));
  for (const fs::path& file : files) {
    try {
      const Scene scene = scenes::read_scene(file);
      all.push_back(json_of(file, scene));
      if (!json) say(style.good(scene.name) + ": " + summary(scene));
    } catch (const scenes::SceneFileError& error) {
      all.push_back(json_of(file, error));
      code = exit_not_passed;
      if (!json) say(error.what());
    }
  }
  if (json) {
    say(nlohmann::json{{"format", "contact-scene-check/1"}, {"scenes", all}}.dump(
        1, ' ', false, nlohmann::json::error_handler_t::replace));
  }
  return code;
}

int list(bool json) {
  const Style style(stdout);
  nlohmann::json all = nlohmann::json::array();
  const std::vector<fs::path> files = scenes::scenes_in(folder_of(grading::find_root()));
  std::size_t width = 0;
  for (const fs::path& file : files) width = std::max(width, file.stem().string().size());
  for (const fs::path& file : files) {
    const Scene scene = scenes::read_scene(file);
    all.push_back(json_of(file, scene));
    if (json) continue;
    say(style.bold(padded(scene.name, width + 2)) + summary(scene));
    say(wrapped(scene.about, width + 2));
  }
  if (json) say(nlohmann::json{{"format", "contact-scene-list/1"}, {"scenes", all}}.dump(1));
  return exit_passed;
}

}  // namespace

fs::path scene_path(const std::string& word) {
  const fs::path file(word);
  std::error_code no_name;  // of a file, such as one that is too long
  if (fs::exists(file, no_name)) return file;
  const bool name = word.find_first_of("/\\.") == std::string::npos;
  if (!name) throw grading::UnknownName(shortened(word) + ": there is no such file");
  const fs::path folder = folder_of(grading::find_root());
  fs::path of_book = folder / (word + ".json");
  if (fs::exists(of_book, no_name)) return of_book;
  std::vector<std::string> names;
  for (const fs::path& known : scenes::scenes_in(folder)) names.push_back(known.stem().string());
  std::string near;
  for (const std::string& candidate : grading::nearest(word, names))
    near += (near.empty() ? "; near it are " : ", ") + candidate;
  throw grading::UnknownName(shortened(word) + ": neither a file nor a scene of the book" + near);
}

void add_scene(Command app, Action& action) {
  const Command command = app.add_subcommand(scene_command);
  command.require_subcommand();
  const auto json = std::make_shared<bool>(false);
  const auto files = std::make_shared<std::vector<std::string>>();

  const Command checking = command.add_subcommand(
      "check", "Describes a scene, or reports all of its faults, one on a line");
  checking.add_option("FILE", *files, "A scene file, or the name of a scene of the book")
      .required();
  checking.add_flag("--json", *json, "Print JSON");
  checking.callback(
      [&action, json, files] { action = [=](Context&) { return check(*files, *json); }; });

  const Command listing = command.add_subcommand("list", "The scenes of the book");
  listing.add_flag("--json", *json, "Print JSON");
  listing.callback([&action, json] { action = [=](Context&) { return list(*json); }; });
}

}  // namespace contact::cli
