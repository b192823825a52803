/// @file
/// From a scene to a setup of hard, smooth balls, or the reason why it is not one.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <contact/hard_sphere_setup.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/scene.hpp>

namespace contact {

/// Hard, smooth balls, and which body of the scene each is.
struct HardSphereScene {
  HardSphereSetup setup;               ///< what runs
  std::vector<std::size_t> ball_body;  ///< index into Scene::bodies of each ball
  std::vector<std::size_t> wall_body;  ///< the same of each wall
};

namespace detail {

inline std::string body_text(const Scene& scene, std::size_t body) {
  return "bodies[" + std::to_string(body) + "] (" + scene.bodies[body].name + ")";
}

/// Bodies that show every kind of contact a scene can have: of each material the first two that
/// move and the first that does not.
inline std::vector<std::size_t> one_of_each(const Scene& scene) {
  std::vector<std::size_t> moving(scene.materials.size(), 0);
  std::vector<std::size_t> standing(scene.materials.size(), 0);
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const SceneBody& body = scene.bodies[i];
    const std::size_t seen = (body.moves ? moving : standing)[body.material]++;
    if (seen < (body.moves ? 2u : 1u)) chosen.push_back(i);
  }
  return chosen;
}

}  // namespace detail

// [refusal]
/// Why a scene is not one of hard, smooth balls, or nothing if it is: its bodies are balls and
/// half-spaces, at least one ball moves, no half-space moves, and no contact has friction or gives
/// way. Without friction nothing turns a ball, so that its spin is nobody's business.
/// @param scene checked
inline std::optional<std::string> hard_sphere_refusal(const Scene& scene) {
  bool moves = false;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const SceneBody& body = scene.bodies[i];
    const bool ball = std::holds_alternative<BallShape>(body.shape);
    if (!ball && !std::holds_alternative<HalfSpaceShape>(body.shape))
      return detail::body_text(scene, i) + " is neither a ball nor a half-space";
    moves = moves || (ball && body.moves);
  }
  if (!moves) return "no ball moves";
  const std::vector<std::size_t> bodies = detail::one_of_each(scene);
  for (const std::size_t i : bodies) {
    for (const std::size_t k : bodies) {
      if (k <= i) continue;
      if (!scene.bodies[i].moves && !scene.bodies[k].moves) continue;
      const PairMaterial pair = pair_material(scene.materials[scene.bodies[i].material],
                                              scene.materials[scene.bodies[k].material]);
      const std::string both = detail::body_text(scene, i) + " and " + detail::body_text(scene, k);
      if (pair.friction > 0)
        return both + " rub: their coefficient of friction is " + number_text(pair.friction);
      if (pair.stiffness)
        return both + " give way: their stiffness is " + number_text(*pair.stiffness) + " N/m";
    }
  }
  return std::nullopt;
}
// [/refusal]

/// The setup of a scene for which hard_sphere_refusal() has nothing to say.
/// @throws std::invalid_argument if it has
inline HardSphereScene hard_sphere_setup(const Scene& scene) {
  if (const auto refusal = hard_sphere_refusal(scene))
    throw_invalid_argument("scene", scene.name, *refusal);
  HardSphereScene made;
  made.setup.gravity = scene.gravity;
  for (const bool moving : {true, false}) {
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      const SceneBody& body = scene.bodies[i];
      const auto* ball = std::get_if<BallShape>(&body.shape);
      if (ball == nullptr || body.moves != moving) continue;
      made.setup.balls.push_back(
          {body.position, body.velocity, ball->radius, body.mass, body.material, moving});
      made.ball_body.push_back(i);
    }
  }
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    if (const auto* wall = std::get_if<HalfSpaceShape>(&scene.bodies[i].shape)) {
      made.setup.walls.push_back({wall->normal, wall->offset, scene.bodies[i].material});
      made.wall_body.push_back(i);
    }
  }
  made.setup.restitution.clear();
  bool elastic = true;
  for (const SceneMaterial& a : scene.materials) {
    for (const SceneMaterial& b : scene.materials) {
      made.setup.restitution.push_back(pair_material(a, b).restitution);
      elastic = elastic && made.setup.restitution.back() == 1;
    }
  }
  if (elastic) made.setup.cutoff = 0x1p-30;
  return made;
}

}  // namespace contact
