// contact dev registry: what this program reads of the chapters' and exercises' files, in the shape
// of build/book.json. The two read the same files, and a test holds them equal.

#include <nlohmann/json.hpp>

#include "../commands.hpp"
#include "../terminal/terminal.hpp"
#include "dev_registry.hpp"

namespace contact::cli {

namespace {

using nlohmann::json;

json registry_of(const grading::Chapter& chapter) {
  json objectives = json::array();
  for (const grading::Objective& objective : chapter.objectives)
    objectives.push_back({{"id", objective.id}, {"text", objective.text}});
  return {{"title", chapter.title},         {"part", chapter.part},
          {"status", chapter.status},       {"tooltip", chapter.tooltip},
          {"builds_on", chapter.builds_on}, {"recall", chapter.recall},
          {"objectives", objectives},       {"exercises", chapter.exercise_names}};
}

json registry_of(const grading::Exercise& exercise) {
  json tests = json::array();
  for (const grading::TestSpec& test : exercise.tests)
    tests.push_back({{"name", test.name},
                     {"points", test.points},
                     {"requires", test.needs},
                     {"visibility", grading::key(test.visibility)},
                     {"solution_seconds", test.solution_seconds}});
  return {{"title", exercise.title},
          {"objective", exercise.objective},
          {"kind", exercise.kind},
          {"minutes", exercise.minutes},
          {"brief", exercise.brief},
          {"hints", exercise.hints},
          {"misconceptions", exercise.misconceptions},
          {"breaks", exercise.breaks},
          {"time_limit", exercise.time_limit},
          {"tests", tests}};
}

int run(Context& context) {
  const grading::Book& book = context.book();
  json registry = {{"chapters", json::object()},
                   {"exercises", json::object()},
                   {"misconceptions", json::object()}};
  for (const grading::Chapter& chapter : book.chapters())
    registry["chapters"][chapter.slug] = registry_of(chapter);
  for (const grading::Exercise& exercise : book.exercises())
    registry["exercises"][exercise.id()] = registry_of(exercise);
  for (const auto& [id, misconception] : book.misconceptions())
    registry["misconceptions"][id] = {{"summary", misconception.summary},
                                      {"hint", misconception.hint}};
  say(registry.dump(1));
  return exit_passed;
}

}  // namespace

void add_dev_registry(Command dev, Action& action) {
  const Command command =
      dev.add_subcommand("registry", "Print what the files of chapters and exercises say, as JSON");
  command.callback([&action] { action = [](Context& context) { return run(context); }; });
}

}  // namespace contact::cli
