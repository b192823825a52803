// A ball on a floor that is compliant like a spring: the length of the substeps, their estimated
// error, and their error when the ball lands for the second time.
#include <cmath>
#include <contact/plan/plan.hpp>
#include <contact/scene/scene_file.hpp>
#include <contact/scene/scene_runs.hpp>
#include <contact/trampoline.hpp>
#include <cstdio>

int main() {
  contact::Scene scene =
      contact::scenes::read_scene(std::string(CONTACT_SCENES) + "penalty_trampoline.json");
  // 1 kg on 1000 N/m, from 1.25 m: half a flight, a contact, a whole flight.
  const auto jump = contact::trampoline_jump(contact::trampoline(1.0, 1000.0, 10.0, 1.25));
  const double again = 1.5 * jump.air_time + jump.contact_time;
  for (const double tolerance : {1e-2, 1e-4, 1e-6}) {
    scene.tolerance.position = tolerance;
    const contact::Plan plan = contact::plan_scene(scene);
    const auto& springs = contact::decision_on(plan, contact::Effect::penalty_contact);
    const auto run = contact::scenes::make_run(scene, plan);
    run->advance(again);
    std::printf("tolerance %.0e m: substeps of %.1e s, error estimated %.1e m, found %.1e m\n",
                tolerance, plan.spring_substep, springs.error,
                std::abs(run->position(1).z() - 0.25));
  }
}
