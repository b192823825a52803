/// @file
/// Runs of small scenes that share no code with the book's: from event to event in extended
/// precision for balls among flat walls, round posts and on a line; leapfrog for springs.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace hypotheses {

using Real = long double;

/// More hits than a run in these tests has, unless its impacts accumulate.
inline constexpr int max_hits = 20000;

/// A vector in the plane of motion.
struct Flat {
  Real x = 0, y = 0;
};
inline Flat operator+(Flat a, Flat b) { return {a.x + b.x, a.y + b.y}; }
inline Flat operator-(Flat a, Flat b) { return {a.x - b.x, a.y - b.y}; }
inline Flat operator*(Real s, Flat a) { return {s * a.x, s * a.y}; }
inline Real dot(Flat a, Flat b) { return a.x * b.x + a.y * b.y; }
inline Real length(Flat a) { return std::sqrt(dot(a, a)); }

/// The time at which gap + rate t + a t²/2 closes; nothing if it never does.
inline std::optional<Real> closes(Real gap, Real rate, Real a) {
  gap = std::max(gap, Real(0));
  if (gap == 0 && rate < 0) return Real(0);
  const Real square = rate * rate - 2 * a * gap;
  if (square < 0) return std::nullopt;
  const Real root = std::sqrt(square);
  if (rate < 0 && (a <= 0 || gap > 0)) return 2 * gap / (root - rate);
  if (!(a < 0)) return std::nullopt;
  return (rate + root) / -a;
}

/// A wall: a half-plane.
struct Wall {
  Flat normal;
  Real offset = 0;
};

/// A ball of mass 1 among flat walls, in a plane, with friction and rotation.
struct BallAmongWalls {
  std::vector<Wall> walls;
  Flat gravity, position, velocity;
  Real radius = 0, restitution = 1, friction = 0;
  Real angular_velocity = 0;
  Real now = 0;

  /// Flies to the next hit and takes it, if it comes before `until`.
  /// @return the flight's duration; nothing if there is no hit before
  std::optional<Real> hit(Real until) {
    std::optional<Real> soonest;
    std::size_t at = 0;
    for (std::size_t k = 0; k < walls.size(); ++k) {
      Real gap = dot(walls[k].normal, position) - walls[k].offset - radius;
      if (last_ && *last_ == k) gap = 0;  // just left
      const auto time = closes(gap, dot(walls[k].normal, velocity), dot(walls[k].normal, gravity));
      if (time && (!soonest || *time < *soonest)) {
        soonest = time;
        at = k;
      }
    }
    if (!soonest || now + *soonest > until) return std::nullopt;
    fly(now + *soonest);
    const Flat n = walls[at].normal;
    const Flat along{-n.y, n.x};
    // Rounding may have reversed the speed of a graze.
    const Real pressed = std::max(Real(0), -(1 + restitution) * dot(n, velocity));
    const Real slides = dot(along, velocity) - angular_velocity * radius;
    const Real held = std::clamp(-slides / Real(3.5), -friction * pressed, friction * pressed);
    velocity = velocity + pressed * n + held * along;
    angular_velocity -= held / (Real(0.4) * radius);
    last_ = at;
    return soonest;
  }

  void fly(Real until) {
    const Real t = until - now;
    position = position + t * velocity + t * t / 2 * gravity;
    velocity = velocity + t * gravity;
    now = until;
  }

  /// @return whether it took fewer than `max_hits`; otherwise impacts accumulate
  bool advance(Real until) {
    for (int k = 0; k < max_hits; ++k) {
      if (hit(until)) continue;
      fly(until);
      return true;
    }
    return false;
  }

 private:
  std::optional<std::size_t> last_;  // of walls: the last one that was hit
};

/// An elastic ball, as a point, among round posts that have the sum of both radii.
struct BallAmongPosts {
  std::vector<Flat> posts;
  Real radius = 0;
  Flat position, velocity;
  Real now = 0;

  bool advance(Real until) {
    for (int k = 0;; ++k) {
      if (k == max_hits) return false;
      Real soonest = std::numeric_limits<Real>::infinity();
      Flat centre;
      for (const Flat post : posts) {
        const Flat off = position - post;
        const Real along = dot(off, velocity);
        const Real v = dot(velocity, velocity);
        // (R − D)(R + D) v² with the impact parameter D.
        const Real cross = off.x * velocity.y - off.y * velocity.x;
        const Real square = (radius * std::sqrt(v) - cross) * (radius * std::sqrt(v) + cross);
        if (!(along < 0) || square < 0) continue;
        const Real time = std::max(Real(0), (-along - std::sqrt(square)) / v);
        if (time >= soonest) continue;
        soonest = time;
        centre = post;
      }
      if (now + soonest > until) break;
      position = position + soonest * velocity;
      now += soonest;
      const Flat n = 1 / length(position - centre) * (position - centre);
      velocity = velocity - 2 * dot(n, velocity) * n;
    }
    position = position + (until - now) * velocity;
    now = until;
    return true;
  }
};

/// Balls on a vertical or horizontal line between a floor at 0 and perhaps a ceiling.
struct BallsOnLine {
  std::vector<Real> place, velocity, mass;  // from the floor upwards
  Real radius = 0, gravity = 0, restitution = 1;
  Real floor = -std::numeric_limits<Real>::infinity();
  Real ceiling = std::numeric_limits<Real>::infinity();
  Real now = 0;

  std::optional<Real> hit(Real until) {
    const std::size_t n = place.size();
    std::optional<Real> soonest;
    std::size_t at = 0;
    const auto offer = [&](std::size_t k, std::optional<Real> time) {
      if (!time || (soonest && *time >= *soonest)) return;
      soonest = time;
      at = k;
    };
    // Hit k is between the balls k − 1 and k; 0 the floor's, n the ceiling's.
    for (std::size_t k = 1; k < n; ++k) {
      const Real gap = last_ == k ? 0 : place[k] - place[k - 1] - 2 * radius;
      offer(k, closes(gap, velocity[k] - velocity[k - 1], 0));
    }
    if (std::isfinite(floor))
      offer(0, closes(last_ == 0U ? 0 : place[0] - radius - floor, velocity[0], -gravity));
    if (std::isfinite(ceiling))
      offer(n, closes(last_ == n ? 0 : ceiling - radius - place[n - 1], -velocity[n - 1], gravity));
    if (!soonest || now + *soonest > until) return std::nullopt;
    fly(now + *soonest);
    last_ = at;
    if (at == 0 || at == n) {
      Real& v = velocity[at == 0 ? 0 : n - 1];
      v *= -restitution;
      return soonest;
    }
    const Real m = mass[at - 1];
    const Real other = mass[at];
    const Real push =
        (1 + restitution) * (velocity[at - 1] - velocity[at]) * m * other / (m + other);
    velocity[at - 1] -= push / m;
    velocity[at] += push / other;
    return soonest;
  }

  void fly(Real until) {
    const Real t = until - now;
    for (std::size_t k = 0; k < place.size(); ++k) {
      place[k] += velocity[k] * t - gravity * t * t / 2;
      velocity[k] -= gravity * t;
    }
    now = until;
  }

  /// @return whether it took fewer than `max_hits`; otherwise impacts accumulate
  bool advance(Real until) {
    for (int k = 0; k < max_hits; ++k) {
      if (hit(until)) continue;
      fly(until);
      return true;
    }
    return false;
  }

 private:
  std::optional<std::size_t> last_;
};

/// Velocity Verlet of coordinates of given masses.
/// @param force writes the forces of positions and velocities
template <class Force>
void leapfrog(std::vector<double>& x, std::vector<double>& v, const std::vector<double>& mass,
              double step, int steps, const Force& force) {
  std::vector<double> f(x.size());
  force(x, v, f);
  for (int n = 0; n < steps; ++n) {
    for (std::size_t k = 0; k < x.size(); ++k) {
      v[k] += f[k] / mass[k] * step / 2;
      x[k] += v[k] * step;
    }
    force(x, v, f);
    for (std::size_t k = 0; k < x.size(); ++k) v[k] += f[k] / mass[k] * step / 2;
  }
}

}  // namespace hypotheses
