// Which effects the planner leaves out of six scenes, before any of them runs.
#include <array>
#include <cmath>
#include <contact/plan/plan.hpp>
#include <contact/scene/scene_file.hpp>
#include <cstdio>

int main() {
  const std::array names{"high_drop",       "billiards_break", "elastic_spheres",
                         "bullet_and_wall", "stack_of_ten",    "ball_pit"};
  std::vector<contact::Plan> plans;
  std::printf("%-21s", "");
  for (const char* name : names) {
    const std::string file = std::string(CONTACT_SCENES) + name + ".json";
    plans.push_back(contact::plan_scene(contact::scenes::read_scene(file)));
    std::printf("%16s", name);
  }
  for (const contact::Effect effect : contact::all_effects) {
    std::printf("\n%-21s", std::string(contact::effect_name(effect)).c_str());
    for (const contact::Plan& plan : plans) {
      const contact::Decision& decision = contact::decision_on(plan, effect);
      if (decision.on && decision.value)
        std::printf("%14.3g s", *decision.value);
      else
        std::printf("%16s", decision.on ? "on" : "-");
    }
  }
  std::printf("\n%-21s", "errors");
  for (const contact::Plan& plan : plans) {
    if (std::isfinite(plan.error))
      std::printf("%14.3g m", plan.error);
    else
      std::printf("%16s", "no bound");
  }
  std::printf("\n%-21s", "tolerance");
  for (const contact::Plan& plan : plans) std::printf("%14.3g m", plan.tolerance);
  std::printf("\n");
}
