#include <contact/scene/scene_run.hpp>

#include <cstddef>

#include <contact/quaternion.hpp>
#include <contact/scene/compiled.hpp>
#include <contact/scene/scene.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace detail {

CONTACT_SCENES_INLINE double energy_of_run(const Scene& scene, const SceneRun& run) {
  double sum = 0;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const SceneBody& body = scene.bodies[i];
    if (!body.moves) continue;
    const Vector3<double> v = run.velocity(i);
    const Matrix3<double> turn = matrix_of(run.orientation(i));
    const Vector3<double> angular_velocity = turn.transpose() * run.angular_velocity(i);
    const Vector3<double> momentum = body.inertia * angular_velocity;
    sum += body.mass * v.dot(v) / 2 + angular_velocity.dot(momentum) / 2 -
           body.mass * scene.gravity.dot(run.position(i));
  }
  return sum;
}

}  // namespace detail

}  // namespace contact
