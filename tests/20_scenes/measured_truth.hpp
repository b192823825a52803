/// @file
/// Where bodies are at the end, by closed forms and in double-double: the truths of the ladder.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <contact/double_double.hpp>
#include <contact/vector.hpp>

namespace measured_scenes {

using contact::DoubleDouble;
using contact::Vector3;
using Point = std::array<DoubleDouble, 3>;

/// x + v t + a t²/2.
inline DoubleDouble thrown(DoubleDouble x, DoubleDouble v, DoubleDouble a, DoubleDouble t) {
  return x + t * (v + DoubleDouble(0.5) * a * t);
}

/// The same for each coordinate.
inline Point thrown(const Vector3<double>& x, const Vector3<double>& v, const Vector3<double>& a,
                    double t) {
  return {thrown(x(0), v(0), a(0), t), thrown(x(1), v(1), a(1), t), thrown(x(2), v(2), a(2), t)};
}

struct Turn {
  DoubleDouble sine, cosine;
};

/// Sine and cosine: the series of a small part of the angle, doubled again and again.
inline Turn sine_and_cosine(DoubleDouble angle) {
  int halvings = 0;
  while (std::abs(angle.high()) > 0x1p-6) {
    angle = angle * DoubleDouble(0.5);
    ++halvings;
  }
  constexpr int terms = 20;  // the first one left out is below 2^-106 of the sum
  DoubleDouble term(1);
  DoubleDouble sine(0);
  DoubleDouble cosine(1);
  for (int n = 1; n < terms; ++n) {
    term = term * angle / DoubleDouble(n);
    DoubleDouble& sum = n % 2 == 1 ? sine : cosine;
    sum = n % 4 < 2 ? sum + term : sum - term;
  }
  for (; halvings > 0; --halvings) {
    const DoubleDouble half = sine;
    sine = DoubleDouble(2) * half * cosine;
    cosine = DoubleDouble(1) - DoubleDouble(2) * half * half;
  }
  return {sine, cosine};
}

/// A point of a body that begins unrotated and keeps its angular velocity, by Rodrigues' formula.
/// @param angular_velocity not 0, rad/s
/// @param from_centre at the start, m
/// @return from the centre, m
inline Point rotated(const Vector3<double>& angular_velocity, const Vector3<double>& from_centre,
                     double t) {
  Point w, r;
  DoubleDouble square(0);
  DoubleDouble along(0);
  for (std::size_t k = 0; k < 3; ++k) {
    w[k] = angular_velocity(static_cast<Eigen::Index>(k));
    r[k] = from_centre(static_cast<Eigen::Index>(k));
    square = square + w[k] * w[k];
    along = along + w[k] * r[k];
  }
  const DoubleDouble speed = sqrt(square);
  const Turn turn = sine_and_cosine(speed * DoubleDouble(t));
  Point to;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3;
    const std::size_t j = (k + 2) % 3;
    to[k] = turn.cosine * r[k] + turn.sine * (w[i] * r[j] - w[j] * r[i]) / speed +
            (DoubleDouble(1) - turn.cosine) * along * w[k] / square;
  }
  return to;
}

/// The height of a ball's lowest point over its floor, after bounces with restitution e.
/// @param height at the start, m, greater than 0
/// @param speed downwards at the start, m/s, not negative
/// @param gravity downwards, m/s², greater than 0
/// @param e from 0 to 1; with e < 1 the bounces end: Σ 2 eⁿ w/g is finite
inline DoubleDouble bounced(DoubleDouble height, DoubleDouble speed, DoubleDouble gravity,
                            DoubleDouble e, double t) {
  const DoubleDouble two(2);
  const DoubleDouble hit = sqrt(speed * speed + two * gravity * height);
  const DoubleDouble first = two * height / (hit + speed);
  DoubleDouble since = DoubleDouble(t) - first;
  if (since < DoubleDouble(0)) return thrown(height, -speed, -gravity, t);
  DoubleDouble up = e * hit;
  if (since * gravity * (DoubleDouble(1) - e) >= two * up && e < DoubleDouble(1)) return 0;
  for (;;) {
    const DoubleDouble flight = two * up / gravity;
    if (flight.high() < 0x1p-90) return 0;
    if (since < flight) return thrown(0, up, -gravity, since);
    since = since - flight;
    up = e * up;
  }
}

/// How far a block has slid on a level floor: friction stops it, and it stays.
inline DoubleDouble slid(DoubleDouble speed, DoubleDouble friction, DoubleDouble gravity,
                         double t) {
  const DoubleDouble loss = friction * gravity;
  const DoubleDouble stop = speed / loss;
  return thrown(0, speed, -loss, stop < DoubleDouble(t) ? stop : DoubleDouble(t));
}

/// A ball on a line.
struct OnLine {
  DoubleDouble position, velocity, mass, radius;
};

/// Elastic balls on a line, left to right: a hit at a time, in its order.
inline std::vector<OnLine> collided(std::vector<OnLine> balls, double t) {
  DoubleDouble left(t);
  for (;;) {
    DoubleDouble first = left;
    std::size_t hit = 0;  // index of the right one
    for (std::size_t i = 1; i < balls.size(); ++i) {
      const DoubleDouble closing = balls[i - 1].velocity - balls[i].velocity;
      if (!(closing > DoubleDouble(0))) continue;
      const DoubleDouble gap =
          balls[i].position - balls[i - 1].position - balls[i].radius - balls[i - 1].radius;
      const DoubleDouble time = gap / closing;
      if (!(time < first)) continue;
      first = time;
      hit = i;
    }
    for (OnLine& ball : balls) ball.position = ball.position + ball.velocity * first;
    if (hit == 0) return balls;
    left = left - first;
    OnLine& a = balls[hit - 1];
    OnLine& b = balls[hit];
    const DoubleDouble twice = DoubleDouble(2) * (a.velocity - b.velocity) / (a.mass + b.mass);
    a.velocity = a.velocity - b.mass * twice;
    b.velocity = b.velocity + a.mass * twice;
  }
}

/// Rounded to doubles.
inline Vector3<double> rounded(const Point& x) { return {x[0].high(), x[1].high(), x[2].high()}; }

}  // namespace measured_scenes
