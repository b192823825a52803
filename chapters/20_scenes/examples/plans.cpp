// Which effects the planner leaves out of six scenes, before any of them runs.
#include <algorithm>
#include <cmath>
#include <contact/plan/plan.hpp>
#include <contact/scene/scene_file.hpp>
#include <cstdio>
#include <string>
#include <vector>

namespace {

struct Column {
  std::string name;
  contact::Plan plan;
};

void print(const Column& column, const std::string& text) {
  std::printf("%*s", static_cast<int>(std::max<std::size_t>(column.name.size(), 8) + 1),
              text.c_str());
}

std::string measured(double value, const char* unit) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g %s", value, unit);
  return text;
}

}  // namespace

int main() {
  std::vector<Column> columns;
  for (const char* name : {"high_drop", "billiards_break", "elastic_spheres", "bullet_and_wall",
                           "stack_of_ten", "ball_pit"}) {
    const std::string file = std::string(CONTACT_SCENES) + name + ".json";
    columns.push_back({name, contact::plan_scene(contact::scenes::read_scene(file))});
  }
  std::printf("%-20s", "");
  for (const Column& column : columns) print(column, column.name);
  for (const contact::Effect effect : contact::all_effects) {
    std::printf("\n%-20s", std::string(contact::effect_name(effect)).c_str());
    for (const Column& column : columns) {
      const contact::Decision& decision = contact::decision_on(column.plan, effect);
      const std::string on = decision.value ? measured(*decision.value, "s") : "on";
      print(column, decision.on ? on : "-");
    }
  }
  std::printf("\n%-20s", "errors");
  for (const Column& column : columns) {
    const double error = column.plan.error;
    print(column, std::isfinite(error) ? measured(error, "m") : "no bound");
  }
  std::printf("\n%-20s", "tolerance");
  for (const Column& column : columns) print(column, measured(column.plan.tolerance, "m"));
  std::printf("\n");
}
