// The right answer is computed from symmetry (Noether's theorem) and not from forces: momentum is
// kept along the directions in which the scene can be moved, angular momentum about the axes about
// which it can be rotated. In the last test runs alone say what is kept. Every test asks for at
// least two different answers, so that no constant passes it.
#include "what_is_kept.hpp"

#include <22_horizon/kept_runs.hpp>
#include <support/exercise.hpp>
#include <support/generators.hpp>

namespace {

using namespace contact::testing;
using exercise::Kept;
using exercise::Scene;
using Vector = Eigen::Vector3d;

/// The right answer, and its mistakes.
enum class Way {
  right,
  no_walls,
  loss,
  friction,
  orbits,
  kinetic,
  no_torque,
  like_force,
  smooth,
  slips,
  elastic_order,
  not_zero,
  epsilon
};

/// Whether a vector is what it was after a quarter turn about the axis: y and z become z and −y.
bool is_turned_into_itself(const Vector& v, int axis, double nothing) {
  const double y = v((axis + 1) % 3), z = v((axis + 2) % 3);
  return std::abs(y - z) <= nothing && std::abs(z - -y) <= nothing;
}

/// Whether a plane with this normal, or a field along it, is the same after a move along the axis.
bool is_moved_into_itself(const Vector& v, int axis, double nothing) {
  const Vector moved = Vector::Unit(axis);
  return std::abs(v.dot(moved)) <= nothing;
}

Kept kept(const Scene& scene, Way way) {
  const double nothing = way == Way::epsilon ? 1e-6 : 0;
  const bool lost = way == Way::loss && !scene.elastic;
  const bool rubbed = way == Way::friction && scene.friction;
  const bool spun = way == Way::orbits && scene.friction && !scene.on_z_axis;
  const bool slides = scene.friction && (!scene.on_z_axis || way == Way::slips);
  Kept kept{};
  kept.energy = scene.elastic && (!slides || way == Way::smooth) &&
                (way != Way::kinetic || scene.gravity.isZero(0));
  kept.order = scene.on_z_axis && (way != Way::elastic_order || scene.elastic);
  for (int k = 0; k < 3; ++k) {
    const auto i = static_cast<std::size_t>(k);
    bool moves = is_moved_into_itself(scene.gravity, k, nothing);
    bool turns = is_turned_into_itself(scene.gravity, k, nothing);
    if (way == Way::no_torque) turns = scene.gravity.isZero(0);
    for (const Vector& normal : scene.normals) {
      if (way == Way::no_walls) continue;
      moves = moves && is_moved_into_itself(normal, k, nothing);
      turns = turns && is_turned_into_itself(normal, k, nothing);
    }
    if (way == Way::like_force) turns = moves;
    kept.momentum[i] = moves && !lost && !rubbed;
    kept.angular_momentum[i] =
        (turns && !lost && !rubbed && !spun) || (scene.on_z_axis && way != Way::not_zero);
  }
  return kept;
}

void check(const Scene& scene, const Kept& right) {
  const auto like = [&scene](Way way) { return [&scene, way] { return kept(scene, way); }; };
  ask("What is kept in every scene of this kind?")
      .given("scene", scene)
      .suspect("walls-left-out", like(Way::no_walls))
      .suspect("loss-takes-momentum", like(Way::loss))
      .suspect("friction-takes-momentum", like(Way::friction))
      .suspect("rotation-has-no-angular-momentum", like(Way::orbits))
      .suspect("gravity-takes-energy", like(Way::kinetic))
      .suspect("gravity-takes-all-angular-momentum", like(Way::no_torque))
      .suspect("torque-like-force", like(Way::like_force))
      .suspect("friction-costs-nothing", like(Way::smooth))
      .suspect("friction-without-slip", like(Way::slips))
      .suspect("order-takes-elastic-impacts", like(Way::elastic_order))
      .suspect("zero-is-not-kept", like(Way::not_zero))
      .suspect("absolute-epsilon", like(Way::epsilon))
      .answer([&] { return exercise::what_is_kept(scene); })
      .equals(right);
}

void check(const Scene& scene) { check(scene, kept(scene, Way::right)); }

const Vector none(0, 0, 0);
const Vector down(0, 0, -9.81);
const Vector up(0, 0, 1);

/// A random unit vector: along an axis, in a plane of two axes, or in none.
Vector random_direction(generators::Random& random, bool oblique) {
  const int axis = random.integer(0, 2);
  if (!oblique && random.chance(0.5)) return (random.chance(0.5) ? 1 : -1) * Vector::Unit(axis);
  const double angle = random.uniform(0.2, 1.3);
  const double tilt = random.chance(0.3) ? random.uniform(0.2, 1.3) : 0;
  Vector v;
  v(axis) = std::cos(angle) * std::cos(tilt);
  v((axis + 1) % 3) = std::sin(angle) * std::cos(tilt);
  v((axis + 2) % 3) = std::sin(tilt);
  return v;
}

/// A random scene. Gravity or a normal differs under each seed: scenes without both are few, and
/// are asked for by the tests above.
Scene random_scene(generators::Random& random) {
  const bool line = random.chance(0.25);
  Scene scene{none, {}, random.chance(0.5), random.chance(0.5), line};
  const bool weightless = !line && random.chance(0.4);
  if (!weightless) {
    // In statements of their own: the order of the factors' draws would be the compiler's choice.
    const double size = random.uniform(1, 5);
    scene.gravity = size * (line ? up : random_direction(random, false));
  }
  const int walls = std::max(weightless ? 1 : 0, random.integer(-2, 2));
  for (int i = 0; i < walls; ++i) {
    const bool oblique = weightless && i == 0;
    scene.normals.push_back(line ? (i == 0 ? up : Vector(-up)) : random_direction(random, oblique));
  }
  return scene;
}

/// What runs keep. Rounding changes what is kept by less than 1e-10; what is not kept, some of a
/// dozen runs change by more than 1e-6.
Kept measured(const Scene& scene, generators::Random& random) {
  const kept_runs::Changes most = kept_runs::changes(
      {scene.gravity, scene.normals, scene.elastic, scene.friction, scene.on_z_axis}, 12, random);
  const auto same = [](double change) { return change < 1e-8; };
  Kept kept{same(most.energy), {}, {}, same(most.order)};
  for (std::size_t k = 0; k < 3; ++k) {
    kept.momentum[k] = same(most.momentum[k]);
    kept.angular_momentum[k] = same(most.angular_momentum[k]);
  }
  return kept;
}

}  // namespace

TEST_CASE("gravity alone") {
  check({none, {}, true, false, false});
  check({down, {}, true, false, false});
  check({Vector(0, 5, 0), {}, true, false, false});
  check({Vector(0, 3, -4), {}, true, false, false});
}

TEST_CASE("smooth walls") {
  check({none, {up}, true, false, false});
  check({none, {up, -up}, true, false, false});
  check({down, {up}, true, false, false});
  check({down, {Vector(1, 0, 0)}, true, false, false});
  check({none, {Vector(0, 0.6, 0.8)}, true, false, false});
  check({none, {Vector(1, 0, 0), Vector(0, 1, 0)}, true, false, false});
  // The pushes of opposite walls do not cancel: they act at different times.
  check({none, {Vector(0, 0.6, 0.8), Vector(0, 0.6, -0.8)}, true, false, false});
}

TEST_CASE("impacts that lose energy") {
  check({none, {}, false, false, false});
  check({none, {}, true, true, false});
  check({none, {}, false, true, false});
  check({down, {up}, false, true, false});
  check({down, {up}, true, true, false});
}

TEST_CASE("balls on a line") {
  check({none, {}, true, false, true});
  check({none, {}, false, false, true});
  check({none, {}, true, true, true});
  check({down, {}, true, false, true});
  check({down, {up}, true, true, true});
  check({down, {up, -up}, false, true, true});
  check({none, {up}, true, true, true});
}

TEST_CASE("the smallest component counts") {
  const double little = 0x1p-40;
  check({Vector(0, little, -9.81), {}, true, false, false});
  check({down, {Vector(little, 0, 1)}, true, false, false});
  check({none, {Vector(0, 1, little)}, true, false, false});
  // Zero has two signs.
  check({Vector(-0.0, 0, -9.81), {Vector(0, -0.0, 1)}, true, false, false});
}

TEST_CASE("random scenes have the symmetry") {
  generators::Random random(seed(0));
  for (int asked = 0; asked < 300; ++asked) check(random_scene(random));
}

TEST_CASE("runs keep it, and change all else") {
  generators::Random random(seed(1));
  for (int asked = 0; asked < 60; ++asked) {
    const Scene scene = random_scene(random);
    check(scene, measured(scene, random));
  }
}
