#include "rod_on_floor.hpp"

namespace exercise {

Motion after_floor(const Body& body, const Eigen::Vector2d& point, double e, double friction) {
  const Eigen::Vector2d r = point - body.centre;
  // Inverse effective mass for impulses along the floor (t) and up (n).
  const double k_tt = 1 / body.mass + r.y() * r.y() / body.inertia;
  const double k_tn = -r.x() * r.y() / body.inertia;
  const double k_nn = 1 / body.mass + r.x() * r.x() / body.inertia;
  double slip = body.velocity.x() - body.angular_velocity * r.y();
  double normal = body.velocity.y() + body.angular_velocity * r.x();
  double along = 0;
  double up = 0;
  double taken = 0;  // work that the normal impulse has absorbed and not given back
  bool restitution = false;
  bool over = !(normal < 0);

  while (!over) {
    // Friction for each unit of normal impulse.
    double pull = slip > 0 ? -friction : friction;
    double slip_rate = k_tt * pull + k_tn;
    if (slip == 0 && std::abs(k_tn) <= friction * k_tt) {
      pull = -k_tn / k_tt;
      slip_rate = 0;
    } else if (slip == 0) {
      pull = k_tn > 0 ? -friction : friction;
      slip_rate = k_tt * pull + k_tn;
    }
    const double rate = k_nn + k_tn * pull;

    // Normal impulse of this segment: to the end of the phase, or until the slip stops.
    double step = std::numeric_limits<double>::infinity();
    if (restitution) {
      step = 2 * taken / (normal + std::sqrt(normal * normal + 2 * rate * taken));
      if (!(taken > 0)) step = 0;
    } else if (rate > 0) {
      step = -normal / rate;
    }
    const bool stops = slip * slip_rate < 0 && -slip / slip_rate < step;
    if (stops) step = -slip / slip_rate;

    taken -= step * (normal + rate * step / 2);
    along += pull * step;
    up += step;
    slip = stops ? 0 : slip + slip_rate * step;
    normal += rate * step;
    if (stops) continue;
    over = restitution;
    if (!restitution) {
      restitution = true;
      normal = 0;
      taken *= e * e;
    }
  }

  const Eigen::Vector2d impulse(along, up);
  return {body.velocity + impulse / body.mass,
          body.angular_velocity + (r.x() * up - r.y() * along) / body.inertia};
}

}  // namespace exercise
