#include "advance_safely.hpp"

namespace exercise {

double distance_at(const Rod& rod, const Disc& disc, double t) {
  const double angle = rod.angle + rod.angular_velocity * t;
  const Eigen::Vector2d along(std::cos(angle), std::sin(angle));
  const Eigen::Vector2d to_disc = disc.centre - (rod.centre + t * rod.velocity);
  const double nearest = std::clamp(to_disc.dot(along), -rod.half_length, rod.half_length);
  return (to_disc - nearest * along).norm() - disc.radius;
}

double speed_bound(const Rod& rod) {
  return rod.velocity.norm() + std::abs(rod.angular_velocity) * rod.half_length;
}

Advance advance_safely(const Rod& rod, const Disc& disc, double duration, double tolerance) {
  const double bound = speed_bound(rod);
  std::vector<double> times;
  double t = 0;
  for (;;) {
    times.push_back(t);
    const double distance = distance_at(rod, disc, t);
    if (distance <= tolerance) return {times, true};
    if (t == duration) return {times, false};
    t = std::min(t + distance / bound, duration);  // at once to the end if nothing moves
  }
}

}  // namespace exercise
