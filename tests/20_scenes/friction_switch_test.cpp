// The right answer scales the slip by the share that friction leaves of it. Where friction is left
// out, the velocities of named tests are exact. Every test asks for at least two different answers,
// so that no constant passes it.
#include "friction_switch.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>

namespace {

using namespace contact::testing;
using exercise::Block;
using exercise::Stepped;
using Vector = Eigen::Vector3d;
using Blocks = std::vector<Block>;

/// The right step, and its mistakes.
enum class Way { right, any_smooth, velocity_alone, rougher, weight, glued, pushes_on };

Stepped stepped(const Blocks& blocks, const Vector& gravity, double step, Way way) {
  const auto mu = [way](const Block& block) {
    const auto [smaller, larger] = std::minmax(block.friction, block.surface_friction);
    return way == Way::rougher ? larger : smaller;
  };
  const auto along = [](const Block& block, const Vector& v) {
    return Vector(v - block.normal.dot(v) * block.normal);
  };
  std::size_t idle = 0;
  for (const Block& block : blocks) {
    const bool still = block.normal.cross(block.velocity).isZero(0);
    const bool level = way == Way::velocity_alone || block.normal.cross(gravity).isZero(0);
    if (mu(block) == 0 || (still && level)) ++idle;
  }
  Stepped result{way == Way::any_smooth ? idle == 0 : idle < blocks.size(), {}};
  for (const Block& block : blocks) {
    Vector v = block.velocity + gravity * step;
    const double pressed = -block.normal.dot(v);
    if (pressed > 0) {
      v = along(block, v);
      double limit = mu(block) * (way == Way::weight ? -block.normal.dot(gravity) * step : pressed);
      if (way == Way::glued && limit > 0) limit = std::numeric_limits<double>::infinity();
      const double left = v.norm() - std::max(0.0, limit);
      if (result.friction && limit > 0 && v.norm() > 0) {
        const double share = left / v.norm();
        v = (way == Way::pushes_on ? share : std::max(0.0, share)) * v;
      }
    }
    result.velocities.push_back(v);
  }
  return result;
}

void check(const Blocks& blocks, const Vector& gravity, double step) {
  const auto like = [&](Way way) {
    return [&blocks, &gravity, step, way] { return stepped(blocks, gravity, step, way); };
  };
  const Stepped right = like(Way::right)();
  ask("Does the scene need friction, and how do its blocks move after a step?")
      .given("blocks", blocks)
      .given("gravity", gravity)
      .given("step", step)
      .suspect("one-smooth-for-all", like(Way::any_smooth))
      .suspect("rest-for-no-slip", like(Way::velocity_alone))
      .suspect("larger-coefficient-of-the-pair", like(Way::rougher))
      .suspect("cone-of-the-weight", like(Way::weight))
      .suspect("cone-left-out", like(Way::glued))
      .suspect("friction-turns-back", like(Way::pushes_on))
      .suspect_if("friction-left-out",
                  [&](const Stepped& got) {
                    return !got.friction && right.friction && like(Way::any_smooth)().friction &&
                           like(Way::velocity_alone)().friction;
                  })
      .answer([&] { return exercise::step_blocks(blocks, gravity, step); })
      // Velocities below 100 m/s, and some twenty roundings; without friction nothing rounds here.
      .close_to(right, right.friction ? within(1e-12) : Within({0}, ""));
}

const Vector up(0, 0, 1);
const Vector down(0, 0, -8);  // gravity
/// Rises by 3 in 4.
const Vector slope(-0.6, 0, 0.8);

}  // namespace

TEST_CASE("smooth pairs need no friction") {
  check({{Vector(4, 0, -1), up, 0, 0}}, down, 0.25);
  check({{Vector(4, 0, -1), up, 0.5, 0}}, down, 0.25);
  check({{Vector(4, 0, -1), up, 0, 0.5}, {Vector(1, 0, 0), up, 2, 0}}, down, 0.25);
  check({{Vector(4, 0, -1), up, 0.5, 0.25}}, down, 0.25);
}

TEST_CASE("one smooth pair is not enough") {
  check({{Vector(4, 0, 0), up, 0.5, 0}, {Vector(4, 0, 0), up, 0.5, 0.5}}, down, 0.25);
  check({{Vector(4, 0, 0), up, 1, 0.25}, {Vector(0, 2, 0), up, 0, 1}}, down, 0.25);
  // One that never slides beside one that does.
  check({{Vector(0, 0, 0), up, 1, 1}, {Vector(4, 0, 0), up, 1, 0.25}}, down, 0.25);
}

TEST_CASE("a block at rest on a slope may slide") {
  check({{Vector(0, 0, 0), slope, 0.5, 0.5}}, down, 0.25);  // too steep for 0.5: it slides
  check({{Vector(0, 0, 0), slope, 1, 0.875}}, down, 0.25);  // without friction it would slide
  check({{Vector(0, 0, 0), up, 0.25, 1}}, Vector(8, 0, -8), 0.25);
  check({{Vector(0, 0, -1), up, 0.25, 1}}, Vector(0, 1e-9, -8), 0.25);
}

TEST_CASE("a block that never slides needs no friction") {
  check({{Vector(0, 0, 0), up, 1, 1}}, down, 0.25);
  check({{Vector(0, 0, -3), up, 1, 1}, {Vector(0, 0, 4), up, 0.5, 1}}, down, 0.25);
  check({{Vector(2, 0, 0), Vector(-1, 0, 0), 1, 1}}, Vector(0, 0, 0), 0.25);
  check({{Vector(2, 0, 0), Vector(-1, 0, 0), 1, 1}}, down, 0.25);
}

TEST_CASE("an impact presses harder than the weight") {
  check({{Vector(8, 0, -2), up, 0.5, 0.5}}, down, 0.25);
  check({{Vector(8, 0, -4), up, 0.5, 0.25}}, Vector(0, 0, 0), 0.25);
  check({{Vector(8, 0, 1), up, 0.5, 0.5}}, down, 0.25);  // a block that was separating presses less
  check({{Vector(8, 0, 4), up, 0.5, 0.5}}, down, 0.25);  // it separates, and nothing presses
}

TEST_CASE("friction stops and does not reverse") {
  check({{Vector(0.5, 0, 0), up, 0.5, 0.5}}, down, 0.25);
  check({{Vector(0.25, 0, -8), up, 0.5, 0.5}}, down, 0.25);
  check({{Vector(0, -3, 0), up, 0.5, 0.5}}, down, 0.25);
}

TEST_CASE("random scenes agree") {
  generators::Random random(seed(0));
  const auto vector = [&random](double size) {
    const double x = random.uniform(-size, size);
    const double y = random.uniform(-size, size);
    const double z = random.uniform(-size, size);
    return Vector(x, y, z);
  };
  for (int asked = 0; asked < 300; ++asked) {
    Blocks blocks;
    bool rough = false;
    const int count = random.integer(1, 3);
    for (int i = 0; i < count; ++i) {
      Vector normal = up;
      do normal = vector(1);
      while (normal.norm() < 0.2);
      normal.normalize();
      const Vector velocity = vector(8);
      const double friction = random.chance(0.3) ? 0 : random.uniform(0.05, 1.5);
      const double surface = random.chance(0.3) ? 0 : random.uniform(0.05, 1.5);
      rough = rough || (friction > 0 && surface > 0);
      blocks.push_back({velocity, normal, friction, surface});
    }
    if (!rough) blocks.push_back({vector(8), up, 0.5, 0.75});
    const Vector gravity = vector(10);
    check(blocks, gravity, random.uniform(0.05, 0.5));
  }
}
