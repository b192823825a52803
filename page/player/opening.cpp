// The scene that a page with the scene player opens with: elastic balls in a plane, from event to
// event, in a module that is small enough to be loaded without asking. The page reads the scene and
// writes its numbers here; the simulation is one of the compositions of player_run.cpp.

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include <contact/events/hard_sphere_run.hpp>
#include <contact/events/hard_spheres.hpp>
#include <contact/vector.hpp>

#define CONTACT_OPENING_EXPORT(name) __attribute__((export_name(name)))

namespace contact::scenes {

namespace {

/// As the player composes such a scene. Without the grid: its search gives the same bits.
constexpr HardSphereEffects opening_effects{
    .dimension = 2, .gravity = false, .sizes = true, .restitution = true, .grid = false};

/// Of a ball: position and velocity (three each), radius, mass.
constexpr std::size_t ball_size = 8;
/// Of a wall: unit normal (three), offset.
constexpr std::size_t wall_size = 4;

/// The scene that is open, and its run.
struct Opening {
  std::size_t balls = 0;
  std::size_t walls = 0;
  std::vector<double> given;
  std::vector<double> frame;
  std::unique_ptr<HardSphereRun> run;
};

Opening& opening() {
  static Opening the_opening;
  return the_opening;
}

Vector3<double> vector_at(const double* x) { return {x[0], x[1], x[2]}; }

/// As hard_sphere_setup() makes it of a scene whose contacts are all elastic.
HardSphereSetup setup_of(const Opening& scene) {
  HardSphereSetup setup;
  setup.cutoff = 0x1p-30;
  const double* x = scene.given.data();
  for (std::size_t i = 0; i < scene.balls; ++i, x += ball_size)
    setup.balls.push_back({vector_at(x), vector_at(x + 3), x[6], x[7], 0, true});
  for (std::size_t i = 0; i < scene.walls; ++i, x += wall_size)
    setup.walls.push_back({vector_at(x), x[3], 0});
  return setup;
}

}  // namespace

}  // namespace contact::scenes

/// Room for a scene's numbers, to be written before opening_begin(): eight for each ball (position
/// and velocity, radius, mass), then four for each wall (unit normal, offset). All balls move, and
/// in the plane of x and y.
extern "C" CONTACT_OPENING_EXPORT("opening_room") double* opening_room(std::size_t balls,
                                                                       std::size_t walls) {
  using namespace contact::scenes;
  Opening& scene = opening();
  scene.run.reset();
  scene.balls = balls;
  scene.walls = walls;
  scene.given.assign(balls * ball_size + walls * wall_size, 0.0);
  return scene.given.data();
}

/// Puts the scene at its start, as often as it is called. Stops with a sentence if the numbers are
/// none of a scene.
extern "C" CONTACT_OPENING_EXPORT("opening_begin") void opening_begin() {
  using namespace contact::scenes;
  Opening& scene = opening();
  scene.run = std::make_unique<contact::HardSpheres<opening_effects>>(setup_of(scene),
                                                                      std::array<int, 3>{0, 1, 2});
}

/// Runs until a time, or for so many hits, after opening_begin().
/// @return 0: reached; 1: the budget is used up; 2: infinitely many hits at one instant
extern "C" CONTACT_OPENING_EXPORT("opening_advance") int opening_advance(double until,
                                                                         double budget) {
  using contact::HardSphereEnd;
  contact::HardSphereRun& run = *contact::scenes::opening().run;
  const HardSphereEnd end = run.advance(until, static_cast<std::uint64_t>(budget), nullptr);
  return end == HardSphereEnd::reached ? 0 : end == HardSphereEnd::out_of_events ? 1 : 2;
}

/// The time, the number of hits so far, and three numbers for each ball: its position.
/// @return address of the numbers, valid until the next call
extern "C" CONTACT_OPENING_EXPORT("opening_frame") const double* opening_frame() {
  using namespace contact::scenes;
  Opening& scene = opening();
  scene.frame.clear();
  scene.frame.push_back(scene.run->now());
  scene.frame.push_back(static_cast<double>(scene.run->counts().hits));
  for (std::size_t i = 0; i < scene.balls; ++i) {
    const contact::Vector3<double> x = scene.run->position(i);
    for (int k = 0; k < 3; ++k) scene.frame.push_back(x(k));
  }
  return scene.frame.data();
}
