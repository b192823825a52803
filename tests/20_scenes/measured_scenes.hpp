/// @file
/// Scenes of one to three bodies whose end is known, and the runs of them that the ladder measures.
#pragma once

#include <20_scenes/measured_truth.hpp>
#include <support/generators.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <contact/events/hard_sphere_compose.hpp>
#include <contact/events/hard_spheres.hpp>
#include <contact/inertia.hpp>
#include <contact/plan/plan.hpp>
#include <contact/quaternion.hpp>
#include <contact/scene/make_scene_run.hpp>
#include <contact/scene/scene.hpp>

namespace measured_scenes {

/// How a scene is run.
enum class Run { default_60, default_240, all_60, planned };
inline constexpr std::array<Run, 4> all_runs{Run::default_60, Run::default_240, Run::all_60,
                                             Run::planned};

/// The position of a body's centre, and where it is a vertex too, at the end of a run, m.
struct Answer {
  std::array<Vector3<double>, 5> points;
  std::size_t count = 0;
  void add(const Vector3<double>& x) { points[count++] = x; }
};

/// A scene with its plans and its truth.
struct Input {
  contact::Scene scene;
  std::array<contact::Plan, all_runs.size()> plans;  ///< by Run
  Answer truth;
  bool plate = false;  ///< the scene is that of the figure `passing`
};

// ---------------------------------------------------------------- plans and runs

/// What `contact simulate` gets from --step, --with and --without. "Default" is every effect but
/// continuous detection; a step turns event-driven simulation off.
inline contact::PlanOptions options_of(Run run) {
  contact::PlanOptions options;
  if (run == Run::planned) return options;
  options.step = run == Run::default_240 ? 1.0 / 240 : 1.0 / 60;
  for (const contact::Effect effect : contact::all_effects) {
    if (!contact::can_be_switched(effect) || effect == contact::Effect::event_driven) continue;
    const bool off = effect == contact::Effect::continuous_detection && run != Run::all_60;
    (off ? options.overrides.without : options.overrides.with).push_back(effect);
  }
  return options;
}

/// A plan without its sentences, which no run reads: they would take most of the memory.
inline contact::Plan without_sentences(contact::Plan plan) {
  for (contact::Decision& decision : plan.decisions) {
    decision.why = decision.error_is = decision.changes_nothing = decision.saving.is = {};
    decision.because = {};
    decision.tried = {};
  }
  plan.notices = {};
  return plan;
}

template <contact::HardSphereEffects E>
std::unique_ptr<contact::HardSphereRun> composed(const contact::HardSphereSetup& setup,
                                                 const std::array<int, 3>& axes) {
  return std::make_unique<contact::HardSpheres<E>>(setup, axes);
}

/// The least composition of the families below that go from event to event, and for any other setup
/// the one with all effects: the page need not have every composition.
inline std::unique_ptr<contact::HardSphereRun> compose(const contact::HardSphereSetup& setup) {
  constexpr contact::HardSphereEffects bouncing{.dimension = 2, .sizes = false, .grid = false};
  constexpr contact::HardSphereEffects on_line{
      .dimension = 1, .gravity = false, .restitution = false, .grid = false};
  const contact::HardSphereComposition made = contact::compose_hard_spheres(setup);
  if (made.effects == bouncing) return composed<bouncing>(setup, made.axes);
  if (made.effects == on_line) return composed<on_line>(setup, made.axes);
  return composed<contact::HardSphereEffects{}>(setup, {0, 1, 2});
}

/// A vertex of a cube, from its centre.
inline Vector3<double> vertex_of(const contact::BoxShape& box) { return box.half_lengths; }

/// Whether a body's rotation is asked for: in scenes with a cube that rotates.
inline bool asks_for_vertex(const contact::SceneBody& body) {
  return std::holds_alternative<contact::BoxShape>(body.shape) && !body.angular_velocity.isZero(0);
}

/// Makes the run of a plan, and goes to the scene's end.
inline Answer run(const contact::Scene& scene, const contact::Plan& plan) {
  const std::unique_ptr<contact::SceneRun> run = contact::make_scene_run(scene, plan, &compose);
  run->advance(scene.duration);
  Answer answer;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const contact::SceneBody& body = scene.bodies[i];
    if (!body.moves) continue;
    const Vector3<double> centre = run->position(i);
    answer.add(centre);
    if (!asks_for_vertex(body)) continue;
    const Vector3<double> vertex = vertex_of(std::get<contact::BoxShape>(body.shape));
    answer.add(centre + contact::matrix_of(run->orientation(i)) * vertex);
  }
  return answer;
}

inline Answer run_of(const Input& input, Run which) {
  return run(input.scene, input.plans[static_cast<std::size_t>(which)]);
}

/// The planner's work included.
inline Answer plan_and_run(const Input& input) {
  return run(input.scene, contact::plan_scene(input.scene));
}

// ---------------------------------------------------------------- scenes

inline constexpr double gravity = 9.81;
inline constexpr double tolerance = 0.001;

/// An empty scene with one material, in which a position may be wrong by the tolerance.
inline contact::Scene empty_scene(double duration, double restitution, double friction) {
  contact::Scene scene;
  scene.name = "ladder";
  contact::SceneMaterial& stone = scene.materials.emplace_back();
  stone.name = "stone";
  stone.restitution = restitution;
  stone.friction = friction;
  scene.duration = duration;
  scene.tolerance.position = tolerance;
  return scene;
}

inline contact::SceneBody ball(std::string name, double radius, double mass,
                               const Vector3<double>& position, const Vector3<double>& velocity) {
  contact::SceneBody body;
  body.name = std::move(name);
  body.shape = contact::BallShape{radius};
  body.mass = mass;
  body.inertia = contact::sphere_inertia(mass, radius);
  body.position = position;
  body.velocity = velocity;
  return body;
}

inline contact::SceneBody box(std::string name, const Vector3<double>& half, double mass,
                              const Vector3<double>& position, const Vector3<double>& velocity) {
  contact::SceneBody body;
  body.name = std::move(name);
  body.shape = contact::BoxShape{half};
  body.mass = mass;
  body.inertia = contact::box_inertia<double>(mass, 2 * half);
  body.position = position;
  body.velocity = velocity;
  return body;
}

/// The half-space z ≤ 0.
inline contact::SceneBody ground() {
  contact::SceneBody body;
  body.name = "ground";
  body.shape = contact::HalfSpaceShape{};
  body.moves = false;
  return body;
}

/// Makes the plans of a scene.
inline Input planned(contact::Scene scene, const Answer& truth, bool plate = false) {
  Input input;
  for (const Run run : all_runs) {
    input.plans[static_cast<std::size_t>(run)] =
        without_sentences(contact::plan_scene(scene, options_of(run)));
  }
  input.scene = std::move(scene);
  input.truth = truth;
  input.plate = plate;
  return input;
}

inline Vector3<double> any_vector(generators::Random& random, double size) {
  const double x = random.uniform(-size, size);
  const double y = random.uniform(-size, size);
  const double z = random.uniform(-size, size);
  return {x, y, z};
}

/// Two cubes and a ball, thrown side by side over the ground, rotating, and in the air to the end.
inline Input stones(generators::Random& random) {
  contact::Scene scene = empty_scene(random.uniform(0.5, 1), 0.3, 0.5);
  scene.gravity = {0, 0, -gravity};
  scene.bodies.push_back(ground());
  Answer truth;
  for (int i = 0; i < 3; ++i) {
    const double size = random.uniform(0.02, 0.1);
    const double mass = random.uniform(0.1, 2);
    const Vector3<double> position{i * 4.0, 0, random.uniform(8, 12)};
    const Vector3<double> velocity = any_vector(random, 1.5);
    const std::string name = "stone " + std::to_string(i + 1);
    contact::SceneBody body =
        i == 0 ? ball(name, size, mass, position, velocity)
               : box(name, Vector3<double>::Constant(size), mass, position, velocity);
    body.angular_velocity = any_vector(random, 10);
    const Point centre = thrown(position, velocity, scene.gravity, scene.duration);
    truth.add(rounded(centre));
    if (asks_for_vertex(body)) {
      Point vertex = rotated(body.angular_velocity,
                             vertex_of(std::get<contact::BoxShape>(body.shape)), scene.duration);
      for (std::size_t k = 0; k < 3; ++k) vertex[k] = vertex[k] + centre[k];
      truth.add(rounded(vertex));
    }
    scene.bodies.push_back(std::move(body));
  }
  return planned(std::move(scene), truth);
}

/// A smooth ball that flies over a floor and bounces with e < 1, from half the time until it rests
/// to half of that time later.
inline Input bouncing(generators::Random& random) {
  const double e = random.uniform(0.3, 0.8);
  const double radius = random.uniform(0.05, 0.2);
  const double height = random.uniform(0.5, 2);
  const double down = random.uniform(0, 3);
  const double along = random.uniform(-3, 3);
  const double hit = std::sqrt(down * down + 2 * gravity * height);
  const double rest = (hit - down) / gravity + 2 * e * hit / (gravity * (1 - e));
  contact::Scene scene = empty_scene(rest * random.uniform(0.5, 1.5), e, 0);
  scene.gravity = {0, 0, -gravity};
  scene.bodies = {ground(), ball("ball", radius, random.uniform(0.1, 2), {0, 0, radius + height},
                                 {along, 0, -down})};
  scene.bodies.back().angular_velocity = any_vector(random, 10);
  const double z = scene.bodies.back().position.z();
  const DoubleDouble low = DoubleDouble(z) - DoubleDouble(radius);
  Answer truth;
  truth.add(rounded({DoubleDouble(along) * DoubleDouble(scene.duration), DoubleDouble(0),
                     DoubleDouble(radius) + bounced(low, down, gravity, e, scene.duration)}));
  return planned(std::move(scene), truth);
}

/// A flat block that slides over a level floor, from half the time until it stops to half of that
/// time later. It is low enough not to tip over.
inline Input sliding(generators::Random& random) {
  const double friction = random.uniform(0.4, 0.8);
  const Vector3<double> half{random.uniform(0.3, 0.6), random.uniform(0.2, 0.4),
                             random.uniform(0.05, 0.2)};
  const double speed = random.uniform(0.5, 1.5);
  contact::Scene scene =
      empty_scene(speed / (friction * gravity) * random.uniform(0.5, 1.5), 0, friction);
  scene.gravity = {0, 0, -gravity};
  scene.bodies = {ground(),
                  box("block", half, random.uniform(1, 5), {0, 0, half.z()}, {speed, 0, 0})};
  Answer truth;
  truth.add({slid(speed, friction, gravity, scene.duration).high(), 0, half.z()});
  return planned(std::move(scene), truth);
}

/// Two or three smooth elastic balls on a line that approach each other.
inline Input on_line(generators::Random& random) {
  const int count = random.integer(2, 3);
  contact::Scene scene = empty_scene(1.5, 1, 0);
  std::vector<OnLine> balls;
  for (int i = 0; i < count; ++i) {
    const double radius = random.uniform(0.05, 0.3);
    const double mass = random.uniform(0.2, 4);
    const double position = i + random.uniform(-0.15, 0.15);
    const double velocity = (count - 1) / 2.0 - i + random.uniform(-0.4, 0.4);
    scene.bodies.push_back(ball("ball " + std::to_string(i + 1), radius, mass, {position, 0, 0},
                                {3 * velocity, 0, 0}));
    balls.push_back({position, 3 * velocity, mass, radius});
  }
  Answer truth;
  for (const OnLine& there : collided(balls, scene.duration))
    truth.add({there.position.high(), 0, 0});
  return planned(std::move(scene), truth);
}

/// A fast smooth ball that falls onto a thin fixed plate and bounces back, elastic: the scene of
/// the figure `passing`, in which y is up.
inline Input at_plate(generators::Random& random) {
  const double thick = random.uniform(0.01, 0.1);
  const double height = random.uniform(1, 2);
  const double speed = random.uniform(5, 40);
  constexpr double radius = 0.1;
  contact::Scene scene = empty_scene(0.5, 1, 0);
  scene.gravity = {0, -gravity, 0};
  contact::SceneBody plate;
  plate.name = "plate";
  plate.shape = contact::BoxShape{{4, thick / 2, 4}};
  plate.moves = false;
  scene.bodies = {ball("ball", radius, 1, {0, height, 0}, {0, -speed, 0}), plate};
  const DoubleDouble touching = DoubleDouble(thick / 2) + DoubleDouble(radius);
  Answer truth;
  truth.add(
      {0,
       (touching + bounced(DoubleDouble(height) - touching, speed, gravity, 1, scene.duration))
           .high(),
       0});
  return planned(std::move(scene), truth, true);
}

}  // namespace measured_scenes
