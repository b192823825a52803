#include <contact/events/hard_sphere_times.hpp>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>

#include <contact/scene/compiled.hpp>

namespace contact {

// [wall]
CONTACT_SCENES_INLINE Arrival arrival_at_plane(double gap, double velocity, double acceleration) {
  if (gap <= 0 && velocity < 0) return {0, -velocity};
  if (acceleration == 0) {
    if (!(velocity < 0)) return {};
    return {gap / -velocity, -velocity};
  }
  const double energy = velocity * velocity - 2 * acceleration * gap;
  if (acceleration > 0) {
    if (!(velocity < 0) || energy < 0) return {};
    const double speed = std::sqrt(energy);
    return {2 * gap / (speed - velocity), speed};
  }
  if (!(energy > 0))
    return {std::max(0.0, velocity / -acceleration), 0};  // still inside at the apex
  const double speed = std::sqrt(energy);
  if (velocity < 0) return {2 * gap / (speed - velocity), speed};
  return {(speed + velocity) / -acceleration, speed};
}
// [/wall]

namespace detail {

CONTACT_SCENES_INLINE Quartic derivative_of(const Quartic& p) {
  return {p[1], 2 * p[2], 3 * p[3], 4 * p[4], 0};
}

CONTACT_SCENES_INLINE double sign_change(const Quartic& p, double low, double high) {
  const bool positive = value_at(p, low) > 0;
  for (;;) {
    const double middle = low + (high - low) / 2;
    if (!(low < middle && middle < high)) return high;
    ((value_at(p, middle) > 0) == positive ? low : high) = middle;
  }
}

CONTACT_SCENES_INLINE Pieces monotone_pieces(const Quartic& p, double end, int degree) {
  Pieces pieces;
  pieces.ends[pieces.count++] = 0;
  if (degree > 1) {
    const Quartic slope = derivative_of(p);
    const Pieces of_slope = monotone_pieces(slope, end, degree - 1);
    for (std::size_t i = 0; i + 1 < of_slope.count; ++i) {
      const double low = of_slope.ends[i];
      const double high = of_slope.ends[i + 1];
      if ((value_at(slope, low) > 0) != (value_at(slope, high) > 0))
        pieces.ends[pieces.count++] = sign_change(slope, low, high);
    }
  }
  pieces.ends[pieces.count++] = end;
  return pieces;
}

}  // namespace detail

}  // namespace contact
