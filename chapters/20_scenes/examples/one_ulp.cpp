// Billiards on a level table, and the same with one ball an ulp higher: an effect that is no longer
// proven inactive is on.
#include <cmath>
#include <contact/plan/plan.hpp>
#include <contact/plan/plan_report.hpp>
#include <contact/scene/scene_file.hpp>
#include <cstdio>

int main() {
  // [raise]
  contact::Scene scene =
      contact::scenes::read_scene(std::string(CONTACT_SCENES) + "billiards_break.json");
  const contact::Plan level = contact::plan_scene(scene);
  contact::SceneBody& ball = scene.bodies.back();
  ball.position.z() = std::nextafter(ball.position.z(), 1.0);
  const contact::Plan raised = contact::plan_scene(scene);
  // [/raise]

  for (const contact::Effect effect : contact::all_effects) {
    const contact::Decision& before = contact::decision_on(level, effect);
    const contact::Decision& after = contact::decision_on(raised, effect);
    if (before.on == after.on) continue;
    std::printf("%s: %s, then %s\n", std::string(contact::effect_name(effect)).c_str(),
                before.on ? "on" : "off", after.on ? "on" : "off");
    for (const contact::Inequality& failed : after.because)
      std::printf("    %s\n", contact::scenes::condition_text(failed).c_str());
  }
}
