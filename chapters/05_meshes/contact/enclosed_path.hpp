/// @file
/// The path of a point in the frame of a moving body, with bounds on every rounding error.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>

#include <contact/moving_mesh.hpp>
#include <contact/running_error.hpp>
#include <contact/shapes.hpp>
#include <contact/sine_cosine.hpp>
#include <contact/vector.hpp>

namespace contact::detail {

/// An upper bound of the length of a vector that is known with errors.
inline double length_at_most(const Triple<RunningError>& v) {
  const double x = std::abs(v[0].value) + v[0].bound, y = std::abs(v[1].value) + v[1].bound,
               z = std::abs(v[2].value) + v[2].bound;
  return RunningError::up(std::sqrt(x * x + y * y + z * z)) + 0x1p-500;
}
/// The larger of two bounds; infinite if one is not a number, which std::max may lose.
inline double larger_bound(double x, double y) {
  return x >= y ? x : y > x ? y : std::numeric_limits<double>::infinity();
}
inline Triple<RunningError> times(const Triple<RunningError>& v, const RunningError& x) {
  return {v[0] * x, v[1] * x, v[2] * x};
}
inline Triple<RunningError> plus(const Triple<RunningError>& v, const Triple<RunningError>& w) {
  return {v[0] + w[0], v[1] + w[1], v[2] + w[2]};
}

/// sin x and cos x of a number with an error, by `sine_cosine`, which is off by at most 8 u + u
/// |x|: u/3 |x| from the stored full turn, and less than 5 u from the reduction and the series,
/// whose terms have a ratio below 1/3.
struct EnclosedSineCosine {
  RunningError sine, cosine;

  explicit EnclosedSineCosine(const RunningError& x) {
    if (x.is_zero()) {
      cosine = RunningError(1.0);
      return;
    }
    constexpr double endless = std::numeric_limits<double>::infinity();
    if (!std::isfinite(x.value)) {
      sine = cosine = RunningError(0, endless);
      return;
    }
    const SineCosine<double> near = sine_cosine(x.value);
    const double error = RunningError::up(x.bound + RunningError::u * (8 + std::abs(x.value)));
    sine = RunningError(near.sine, error);
    cosine = RunningError(near.cosine, error);
  }
};

// [enclosed-path]
/// The path of a point in the body's frame with bounds on all rounding errors.
class EnclosedPath {
 public:
  EnclosedPath(const RigidMotion<double>& motion, const Segment<double>& path) {
    const auto known = [](const Vector3<double>& v) { return triple<RunningError>(v); };
    const auto turned = [&motion, &known](const Triple<RunningError>& v) {
      return Triple<RunningError>{dot(known(motion.start.axes.col(0)), v),
                                  dot(known(motion.start.axes.col(1)), v),
                                  dot(known(motion.start.axes.col(2)), v)};
    };
    start_ = turned(minus(known(path.start), known(motion.start.origin)));
    rate_ = turned(minus(minus(known(path.end), known(path.start)), known(motion.displacement)));
    const double largest = motion.rotation.cwiseAbs().maxCoeff();
    turns_ = largest > 0;
    if (!turns_) return;
    // With the largest coordinate near 1 nothing underflows that matters.
    int power = 0;
    std::frexp(largest, &power);
    Triple<RunningError> near_one;
    for (int k = 0; k < 3; ++k) {
      const double scaled = std::ldexp(motion.rotation[k], -power);
      near_one[std::size_t(k)] = std::ldexp(scaled, power) == motion.rotation[k]
                                     ? RunningError(scaled)
                                     : RunningError(scaled, RunningError::floor);
    }
    const RunningError length = sqrt(dot(near_one, near_one));
    for (std::size_t k = 0; k < 3; ++k) axis_[k] = near_one[k] / length;
    angle_ = RunningError(std::ldexp(length.value, power),
                          std::ldexp(length.bound, power) + 4 * RunningError::floor);
  }

  bool turns() const { return turns_; }

  /// A point of the path as a stored point, and a bound on the distance between them.
  struct Sample {
    Vector3<double> at;
    double error = 0;
  };
  Sample sample(double s) const {
    Triple<RunningError> q = unturned(s);
    if (turns_ && s != 0) {
      // Rodrigues: y cos φ − (k × y) sin φ + k (k·y) (1 − cos φ).
      const EnclosedSineCosine of(RunningError(s) * angle_);
      const RunningError along = dot(axis_, q) * (RunningError(1.0) - of.cosine);
      q = plus(minus(times(q, of.cosine), times(cross(axis_, q), of.sine)), times(axis_, along));
    }
    Sample found{{q[0].value, q[1].value, q[2].value}, 0};
    found.error = length_at_most({RunningError(q[0].bound), q[1].bound, q[2].bound});
    return found;
  }

  /// A bound on the distance between path and chord from s0 to s1: θ |k × (θ k × y − 2 δ)| is the
  /// length of q'', its argument is linear in s, and so its maximum is at an end.
  double chord_error(double s0, double s1) const {
    if (!turns_) return 0;
    const double h = s1 - s0;
    const double most = larger_bound(bend(s0), bend(s1));
    return RunningError::up(most * (h * h) / 8);
  }

 private:
  Triple<RunningError> start_, rate_, axis_;
  RunningError angle_;
  bool turns_ = false;

  Triple<RunningError> unturned(double s) const { return plus(start_, times(rate_, s)); }
  double bend(double s) const {
    const Triple<RunningError> swept = times(cross(axis_, unturned(s)), angle_);
    const Triple<RunningError> both = cross(axis_, minus(swept, plus(rate_, rate_)));
    return length_at_most(times(both, angle_));
  }
};
// [/enclosed-path]

}  // namespace contact::detail
