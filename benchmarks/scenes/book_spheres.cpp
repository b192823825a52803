// The book's hard balls, with only the effects that these scenes call for.
#include <array>
#include <contact/events/hard_spheres.hpp>

#include "programs.hpp"

namespace {

using contact::Vector3;
using scene_programs::Balls;
using scene_programs::Column;
using scene_programs::Motion;

Vector3<double> vector(const Column& c) { return {c[0], c[1], c[2]}; }
Column column(const Vector3<double>& v) { return {v.x(), v.y(), v.z()}; }

contact::HardSphereSetup setup(const Balls& scene) {
  contact::HardSphereSetup made;
  made.gravity = {0, 0, -scene.gravity};
  made.cutoff = 0x1p-30;
  for (const scene_programs::Wall& wall : scene.walls)
    made.walls.push_back({vector(wall.normal), wall.offset, 0});
  // The ball comes from below 0 along x, and only the front of the plate is ever met.
  if (scene.plate > 0) made.walls.push_back({{-1, 0, 0}, scene.plate / 2, 0});
  for (const Motion& motion : scene.balls) {
    contact::HardBall ball;
    ball.position = vector(motion.place);
    ball.velocity = vector(motion.velocity);
    ball.radius = scene.radius;
    ball.mass = 1;
    made.balls.push_back(ball);
  }
  return made;
}

template <contact::HardSphereEffects E>
class BookRun final : public scene_programs::Run {
 public:
  explicit BookRun(const Balls& scene)
      : run_(setup(scene), E.dimension == 3 ? std::array{0, 1, 2} : std::array{0, 2, 1}) {}

  void step(double seconds) override {
    ++steps_;
    run_.advance(static_cast<double>(steps_) * seconds);
  }
  std::vector<Motion> read() const override {
    std::vector<Motion> all;
    for (std::size_t i = 0; i < run_.moving(); ++i)
      all.push_back({column(run_.position(i)), column(run_.velocity(i))});
    return all;
  }
  double overlap_between_steps() const override { return run_.counts().largest_overlap; }

 private:
  contact::HardSpheres<E> run_;
  long long steps_ = 0;
};

constexpr contact::HardSphereEffects effects(int dimension, bool grid) {
  return {dimension, true, false, false, grid};
}

}  // namespace

std::unique_ptr<scene_programs::Run> scene_programs::book(const Balls& scene) {
  if (scene.dimension == 2) return std::make_unique<BookRun<effects(2, true)>>(scene);
  if (scene.balls.size() == 1) return std::make_unique<BookRun<effects(3, false)>>(scene);
  return std::make_unique<BookRun<effects(3, true)>>(scene);
}
