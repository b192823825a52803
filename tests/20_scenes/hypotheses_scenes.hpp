/// @file
/// The scenes that refute a proof without one of its hypotheses, and plans that drop one.
#pragma once

#include <catch2/catch_test_macros.hpp>
#include <contact/plan/plan.hpp>
#include <contact/plan/plan_hypotheses.hpp>
#include <contact/scene/scene_file.hpp>
#include <filesystem>
#include <string>
#include <string_view>

#include "hypotheses_oracle.hpp"
#include "plan_scenes.hpp"

namespace hypotheses {

using contact::Decision;
using contact::Effect;
using contact::PlanOptions;
using contact::Scene;

inline std::filesystem::path folder() {
  return std::filesystem::path(CONTACT_SOURCE_DIR) / "tests" / "20_scenes" / "scenes";
}

inline Scene refuting(std::string_view name) {
  return contact::scenes::read_scene(folder() / (std::string(name) + ".json"));
}

inline PlanOptions without(std::string_view id) {
  PlanOptions options;
  options.dropped = {std::string(id)};
  return options;
}

inline std::string_view proof_of(std::string_view id) { return id.substr(0, id.find('/')); }

/// The effect that a proof switches off.
inline Effect effect_of(std::string_view proof) {
  if (proof == "one-contact") return Effect::several_contacts;
  if (proof == "mirror") return Effect::third_dimension;
  if (proof == "flat-walls" || proof == "one-line" || proof == "first-hits") return Effect::horizon;
  return Effect::resting;
}

/// The plane's coordinates of a vector of the scene: x and another axis.
inline Flat flat(const plan_scenes::Point& p, int axis) {
  return {static_cast<Real>(p.x()), static_cast<Real>(p(axis))};
}

/// A scene of one ball among half-spaces, in the plane of x and an axis, for the oracle.
inline BallAmongWalls ball_among_walls(const Scene& scene, int axis) {
  BallAmongWalls run;
  run.gravity = flat(scene.gravity, axis);
  for (const auto& body : scene.bodies) {
    if (const auto* wall = std::get_if<contact::HalfSpaceShape>(&body.shape)) {
      run.walls.push_back({flat(wall->normal, axis), static_cast<Real>(wall->offset)});
      continue;
    }
    run.position = flat(body.position, axis);
    run.velocity = flat(body.velocity, axis);
    run.radius = static_cast<Real>(std::get<contact::BallShape>(body.shape).radius);
    run.restitution = static_cast<Real>(scene.materials[body.material].restitution);
    run.friction = static_cast<Real>(scene.materials[body.material].friction);
  }
  return run;
}

/// A scene of one ball among posts of one size, in the plane of x and y, for the oracle.
inline BallAmongPosts ball_among_posts(const Scene& scene) {
  BallAmongPosts run;
  Real post = 0;
  for (const auto& body : scene.bodies) {
    const Real radius = static_cast<Real>(std::get<contact::BallShape>(body.shape).radius);
    if (body.moves) {
      run.position = flat(body.position, 1);
      run.velocity = flat(body.velocity, 1);
      run.radius += radius;
    } else {
      run.posts.push_back(flat(body.position, 1));
      post = radius;
    }
  }
  run.radius += post;
  return run;
}

/// Balls of one size on a line along an axis, in the order of the scene, for the oracle.
inline BallsOnLine balls_on_line(const Scene& scene, int axis) {
  BallsOnLine run;
  run.gravity = static_cast<Real>(-scene.gravity(axis));
  run.restitution = static_cast<Real>(scene.materials[0].restitution);
  for (const auto& body : scene.bodies) {
    if (const auto* wall = std::get_if<contact::HalfSpaceShape>(&body.shape)) {
      const bool below = wall->normal(axis) > 0;
      (below ? run.floor : run.ceiling) = static_cast<Real>(below ? wall->offset : -wall->offset);
      continue;
    }
    run.place.push_back(static_cast<Real>(body.position(axis)));
    run.velocity.push_back(static_cast<Real>(body.velocity(axis)));
    run.mass.push_back(static_cast<Real>(body.mass));
    run.radius = static_cast<Real>(std::get<contact::BallShape>(body.shape).radius);
  }
  return run;
}

inline Real distance(const BallAmongWalls& a, const BallAmongWalls& b) {
  return length(a.position - b.position);
}
inline Real distance(const BallAmongPosts& a, const BallAmongPosts& b) {
  return length(a.position - b.position);
}
inline Real distance(const BallsOnLine& a, const BallsOnLine& b) {
  Real most = 0;
  for (std::size_t k = 0; k < a.place.size(); ++k)
    most = std::max(most, std::abs(a.place[k] - b.place[k]));
  return most;
}

/// The largest distance of two twins at a time; 0 if the impacts of one accumulate before.
/// @param change moves a run by so many ulps in one direction
template <class Run, class Change>
double twins_apart(const Run& run, double time, const Change& change) {
  Run one = run;
  Run other = run;
  change(one, Real(0x1p-52));
  change(other, -Real(0x1p-52));
  const Real end = static_cast<Real>(time);
  if (!one.advance(end) || !other.advance(end)) return 0;
  return static_cast<double>(distance(one, other));
}

}  // namespace hypotheses
