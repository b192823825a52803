// A ball that loses a fifth of its speed at each bounce, for 20 s: where its events end, how many
// there are, and the error.
#include <contact/events/hard_sphere_scene.hpp>
#include <contact/events/hard_spheres.hpp>
#include <contact/plan/plan.hpp>
#include <contact/plan/plan_rules.hpp>
#include <contact/scene/scene_file.hpp>
#include <cstdio>

int main() {
  contact::Scene scene =
      contact::scenes::read_scene(std::string(CONTACT_SCENES) + "bouncing_ball.json");
  scene.duration = 20;
  for (const double tolerance : {1e-3, 1e-6, 1e-9}) {
    scene.tolerance.position = tolerance;
    // [cutoff]
    const contact::Plan plan = contact::plan_scene(scene);
    const contact::Decision& events = contact::decision_on(plan, contact::Effect::event_driven);
    contact::HardSphereSetup setup = contact::hard_sphere_setup(scene).setup;
    setup.cutoff = contact::contact_time_cutoff(tolerance, 10);
    constexpr contact::HardSphereEffects on_a_line{.dimension = 1, .sizes = false, .grid = false};
    contact::HardSpheres<on_a_line> run(setup, {2, 0, 1});
    run.advance(scene.duration);
    // [/cutoff]
    std::printf("tolerance %.0e m: events %s, bounces from %.1e s on followed, %2d hits\n",
                tolerance, events.on ? "on" : "off", setup.cutoff,
                static_cast<int>(run.counts().hits));
    std::printf("    accepted %.1e m, left out %.1e m; height at the end %.9f m\n", events.error,
                run.counts().rest_error, run.position(0).z());
  }
}
