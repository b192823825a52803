// The right answer is computed from mirror images: each quantity is reflected in the plane through
// the first centre, coordinate by coordinate, and compared with itself. Every test asks for at
// least two different answers, so that no constant passes it.
#include "stays_in_a_plane.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>

namespace {

using namespace contact::testing;
using exercise::Ball;
using exercise::Scene;
using Still = std::array<bool, 3>;
using Vector = Eigen::Vector3d;

/// The right rule, and its mistakes.
enum class Way { right, forces, walls, centres, epsilon, sums, origin };

bool is_still(const Scene& scene, int k, Way way) {
  const double nothing = way == Way::epsilon ? 1e-6 : 0;
  const double height = way == Way::origin ? 0 : scene.balls[0].centre(k);
  // An image has the opposite component, and a centre is as far below the plane as it was above.
  const auto is_own_image = [nothing](double x) { return std::abs(x - -x) <= nothing; };
  bool own = way == Way::forces || is_own_image(scene.gravity(k));
  double normals = 0;
  double velocities = 0;
  for (const Vector& normal : scene.normals) {
    normals += normal(k);
    own = own &&
          (way == Way::forces || way == Way::walls || way == Way::sums || is_own_image(normal(k)));
  }
  for (const Ball& ball : scene.balls) {
    velocities += ball.velocity(k);
    own = own && (way == Way::sums || is_own_image(ball.velocity(k))) &&
          (way == Way::centres || is_own_image(ball.centre(k) - height));
  }
  return own && (way != Way::sums || (normals == 0 && velocities == 0));
}

void check(const Scene& scene) {
  const auto like = [&scene](Way way) {
    return [&scene, way] {
      return Still{is_still(scene, 0, way), is_still(scene, 1, way), is_still(scene, 2, way)};
    };
  };
  ask("Along which axes is it proven that nothing ever moves?")
      .given("scene", scene)
      .suspect("absolute-epsilon", like(Way::epsilon))
      .suspect("balanced-for-still", like(Way::sums))
      .suspect("walls-left-out", like(Way::walls))
      .suspect("centres-left-out", like(Way::centres))
      .suspect("forces-left-out", like(Way::forces))
      .suspect("plane-through-origin", like(Way::origin))
      .answer([&] { return exercise::inactive_axes(scene); })
      .equals(like(Way::right)());
}

const Vector none(0, 0, 0);

}  // namespace

TEST_CASE("one ball and gravity") {
  check({Vector(0, 0, -9.81), {{Vector(1, 2, 3), none}}, {}});
  check({Vector(0, 0, -9.81), {{Vector(1, 2, 3), Vector(4, 0, 0)}}, {}});
  check({none, {{Vector(1, 2, 3), Vector(4, 0, 0)}}, {}});
  check({Vector(0, -3, 4), {{Vector(1, 2, 3), none}}, {}});
  check({none, {{Vector(1, 2, 3), none}}, {}});
}

TEST_CASE("walls push along their normals") {
  check({none, {{none, Vector(0, 3, 0)}}, {Vector(0, 1, 0), Vector(0, -1, 0)}});
  check({none, {{none, Vector(0, 3, 0)}}, {Vector(0, 0.8, 0.6)}});
  check({none, {{none, Vector(2, 3, 0)}}, {Vector(0, 1, 0), Vector(0.6, -0.8, 0)}});
  check({Vector(0, 0, -10), {{none, none}}, {Vector(0, 0, 1), Vector(-1, 0, 0)}});
  check({none, {{none, none}}, {Vector(0, 0.8, 0.6), Vector(0.8, 0, 0.6)}});
}

TEST_CASE("balls push along the line of their centres") {
  const Vector right(5, 0, 0);
  check({none, {{Vector(0, 2, 1), right}, {Vector(3, 2, 1), none}}, {}});
  check({none, {{Vector(0, 2, 1), right}, {Vector(3, 2, 1.25), none}}, {}});
  check({none, {{Vector(0, 2, 1), right}, {Vector(3, 2.5, 1), none}}, {Vector(0, 1, 0)}});
  // The last is far away; the rule does not depend on distance.
  check({none,
         {{Vector(0, 2, 1), right}, {Vector(3, 2, 1), none}, {Vector(900, 7, 1), none}},
         {Vector(1, 0, 0)}});
}

TEST_CASE("each ball is its own image") {
  // As a whole the scene is its own image, but the image of each ball is the other ball.
  check({none, {{Vector(0, 0, 1), Vector(3, 0, -2)}, {Vector(0, 0, -1), Vector(3, 0, 2)}}, {}});
  check({none, {{Vector(0, 0, 0), Vector(3, 0, -2)}, {Vector(4, 0, 0), Vector(-3, 0, 2)}}, {}});
  check({none,
         {{Vector(1, 0, 0), Vector(0, 5, 0)}, {Vector(1, 4, 0), Vector(0, -5, 0)}},
         {Vector(0, 0.6, 0.8), Vector(0, 0.6, -0.8)}});
  check({none, {{Vector(0, 0, 0), Vector(3, 0, 0)}, {Vector(4, 0, 0), Vector(-3, 0, 0)}}, {}});
}

TEST_CASE("the smallest component counts") {
  const double little = 0x1p-40;
  check({Vector(0, little, -9.81), {{none, Vector(1, 0, 0)}}, {}});
  check({Vector(0, 0, -9.81), {{none, Vector(little, 0, 0)}}, {}});
  check({none, {{none, none}}, {Vector(1, 0, little)}});
  check({none, {{Vector(1, 1, 1), none}, {Vector(2, 1, 1 + 0x1p-52), none}}, {}});
  // Zero has two signs, which are the same position.
  check({Vector(-0.0, 0, -9.81), {{Vector(0.0, 1, 2), none}, {Vector(-0.0, 1, 2), none}}, {}});
}

TEST_CASE("random scenes agree") {
  generators::Random random(seed(0));
  for (int asked = 0; asked < 400; ++asked) {
    // An axis is spoilt in one place or in none.
    std::array<int, 3> spoilt{};
    for (int& place : spoilt) place = random.integer(0, 8);
    Scene scene{none, {}, {}};
    const int balls = random.integer(1, 4);
    const int walls = random.integer(0, 4);
    Vector common = none;
    for (double& x : common) x = random.uniform(-5, 5);
    for (int i = 0; i < balls; ++i) scene.balls.push_back({common, none});
    for (int i = 0; i < walls; ++i) scene.normals.emplace_back(none);
    for (int k = 0; k < 3; ++k) {
      const double much = random.magnitude(-50, 3);
      const int place = spoilt[static_cast<std::size_t>(k)];
      const auto ball = static_cast<std::size_t>(random.integer(0, balls - 1));
      if (place == 0) scene.gravity(k) = much;
      if (place == 1) scene.balls[ball].velocity(k) = much;
      if (place == 2) scene.balls[ball].centre(k) += random.uniform(1, 2);
      if (place == 3 && walls > 0) {
        const auto wall = static_cast<std::size_t>(random.integer(0, walls - 1));
        scene.normals[wall](k) = random.uniform(0.1, 1);
      }
      if (place == 4) {
        // Everything at once.
        for (Ball& each : scene.balls) each.centre(k) = random.uniform(-5, 5);
        for (Ball& each : scene.balls) each.velocity(k) = random.uniform(-5, 5);
        scene.gravity(k) = much;
      }
    }
    for (Vector& normal : scene.normals) {
      if (normal.isZero(0)) normal(random.integer(0, 2)) = 1;
      normal.normalize();
    }
    check(scene);
  }
}
