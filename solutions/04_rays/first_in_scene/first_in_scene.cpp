#include "first_in_scene.hpp"

namespace exercise {
namespace {

// The first t from 0 to 1 at which from + t path is in the ball.
std::optional<double> entry(const Ball& ball, const Eigen::Vector3d& from,
                            const Eigen::Vector3d& path) {
  const Eigen::Vector3d m = from - ball.centre;
  const double a = path.dot(path), b = path.dot(m);
  const double c = m.dot(m) - ball.radius * ball.radius;
  if (c <= 0) return 0.0;
  const double discriminant = a * ball.radius * ball.radius - path.cross(m).squaredNorm();
  if (discriminant < 0 || b >= 0) return std::nullopt;
  const double t = c / (-b + std::sqrt(discriminant));
  if (t > 1) return std::nullopt;
  return t;
}

// The same for a box.
std::optional<double> entry(const Box& box, const Eigen::Vector3d& from,
                            const Eigen::Vector3d& path) {
  double first = 0, last = 1;
  for (int i = 0; i < 3; ++i) {
    if (path[i] == 0) {
      if (from[i] < box.low[i] || from[i] > box.high[i]) return std::nullopt;
      continue;
    }
    double in = (box.low[i] - from[i]) / path[i], out = (box.high[i] - from[i]) / path[i];
    if (path[i] < 0) std::swap(in, out);
    first = std::max(first, in);
    last = std::min(last, out);
  }
  if (first > last) return std::nullopt;
  return first;
}

}  // namespace

std::optional<FirstHit> first_in_scene(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                       const std::vector<Body>& bodies) {
  std::optional<FirstHit> first;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    // Seen from the body, the bullet moves by the difference of the two displacements.
    const Eigen::Vector3d path = to - from - bodies[i].displacement;
    const auto t =
        std::visit([&](const auto& shape) { return entry(shape, from, path); }, bodies[i].shape);
    if (t && (!first || *t < first->t)) first = FirstHit{static_cast<int>(i), *t};
  }
  return first;
}

}  // namespace exercise
