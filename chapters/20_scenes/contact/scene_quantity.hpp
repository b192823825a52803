/// @file
/// What a scene expects, measured on a run of it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>

#include <contact/scene.hpp>
#include <contact/scene_run.hpp>
#include <contact/stage_contacts.hpp>
#include <contact/stepped_state.hpp>

namespace contact {

namespace detail {

/// Energy, momentum or angular momentum of a body.
inline double mechanical_quantity(const Scene& scene, const SceneRun& run, std::size_t i,
                                  const std::string& quantity) {
  const SceneBody& body = scene.bodies[i];
  const Vector3<double> x = run.position(i);
  const Vector3<double> v = run.velocity(i);
  const Matrix3<double> turn = matrix_of(run.orientation(i));
  const Vector3<double> seen = turn.transpose() * run.spin(i);
  const Vector3<double> own = body.inertia * seen;
  const int axis = quantity.back() - 'x';
  if (quantity == "energy")
    return body.mass * v.dot(v) / 2 + seen.dot(own) / 2 - body.mass * scene.gravity.dot(x);
  if (quantity.starts_with("momentum")) return body.mass * v(axis);
  const Vector3<double> turning = turn * own;
  return Vector3<double>(x.cross(v) * body.mass + turning)(axis);
}

/// The least distance of a body to any other, less than 0 where they overlap.
inline double least_gap(const Scene& scene, const SceneRun& run, std::size_t i) {
  const auto shape = [&](std::size_t k) {
    return shape_in_world(stepped_body(scene.bodies[k], k), run.position(k), run.orientation(k));
  };
  const StepShape own = shape(i);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    if (k == i) continue;
    // Centres that are farther apart than this are not asked more closely.
    if (!is_half_space(scene.bodies[k])) {
      const Vector3<double> apart = run.position(k) - run.position(i);
      const double reach =
          outer_radius(scene.bodies[k].shape) + outer_radius(scene.bodies[i].shape);
      if (size_of(apart) - reach > least) continue;
    }
    least = std::min(least, gap_of_shapes(own, shape(k)).distance);
  }
  return least;
}

}  // namespace detail

// [scene-quantity]
/// A quantity that a scene expects, as a run has it now. Names and units as in scene_quantities.
/// @return in SI units; not a number if it names a body that is not there
inline double scene_quantity(const Scene& scene, const SceneRun& run,
                             const SceneExpectation& wanted) {
  const std::string& quantity = wanted.quantity;
  if (quantity == "events") return static_cast<double>(run.counts().hits);
  const bool gap = quantity == "gap";
  const bool sum = quantity == "energy" || quantity.find("momentum") != std::string::npos;
  double result = gap ? std::numeric_limits<double>::infinity() : 0;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const SceneBody& body = scene.bodies[i];
    if (wanted.body.empty() ? !body.moves : body.name != wanted.body) continue;
    if (gap) {
      result = std::min(result, detail::least_gap(scene, run, i));
    } else if (sum) {
      if (body.moves) result += detail::mechanical_quantity(scene, run, i, quantity);
    } else {
      if (quantity == "speed") return size_of(run.velocity(i));
      const int axis = quantity.back() - 'x';
      if (quantity.starts_with("position")) return run.position(i)(axis);
      if (quantity.starts_with("velocity")) return run.velocity(i)(axis);
      return run.spin(i)(axis);
    }
  }
  return gap || sum ? result : std::numeric_limits<double>::quiet_NaN();
}
// [/scene-quantity]

}  // namespace contact
