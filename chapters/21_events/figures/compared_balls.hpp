// Elastic balls, simulated by a plain loop from event to event, in steps that test for overlap at
// their end, and composed of effects: for the ladder, and for the figure that shows its inputs.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <vector>

#include <contact/double_double.hpp>
#include <contact/events/hard_spheres.hpp>

namespace compared_balls {

using contact::DoubleDouble;
using contact::HardSphereEffects;
using contact::HardSphereSetup;

enum class Motion { line, table, box };

inline constexpr double radius = 0.25;
inline constexpr double gravity = 9.8125;

struct Setting {
  Motion motion = Motion::line;
  HardSphereSetup setup;
  double room = 0;  // m, of a cube, or of what the motion has of it
  double time = 0;  // s
};

/// How the balls are at the end, and what happened before.
struct Course {
  std::vector<contact::Vector3<double>> positions;  // m
  double hits = 0;
  double energy_change = 0;  // relative
  double overlap = 0;        // deepest that occurred, m
};

/// An empty room of the motion, and for how long it is simulated.
inline Setting empty_room(Motion motion) {
  Setting setting;
  setting.motion = motion;
  setting.room = motion == Motion::line ? 5 : motion == Motion::table ? 3 : 2;
  setting.time = motion == Motion::box ? 0.5 : 1;
  if (motion == Motion::box) setting.setup.gravity = {0, 0, -gravity};
  const int dimension = motion == Motion::line ? 1 : motion == Motion::table ? 2 : 3;
  for (int k = 0; k < dimension; ++k) {
    const auto axis = contact::Vector3<double>::Unit(k);
    setting.setup.walls.push_back({axis, 0, 0});
    setting.setup.walls.push_back({-axis, -setting.room, 0});
  }
  return setting;
}

// ---------------------------------------------------------------- a plain loop

template <class S>
struct Ball {
  std::array<S, 3> x, v;
};
template <class S>
using Balls = std::vector<Ball<S>>;

template <class S>
Balls<S> start(const Setting& input) {
  Balls<S> all;
  for (const contact::HardBall& ball : input.setup.balls) {
    Ball<S> b;
    for (std::size_t k = 0; k < 3; ++k) {
      b.x[k] = S(ball.position(static_cast<Eigen::Index>(k)));
      b.v[k] = S(ball.velocity(static_cast<Eigen::Index>(k)));
    }
    all.push_back(b);
  }
  return all;
}

/// Down is along the last axis.
template <class S>
S pull_along(const Setting& input, std::size_t k) {
  return S(k == 2 && input.motion == Motion::box ? gravity : 0);
}

template <class S>
S energy_of(const Setting& input, const Balls<S>& all) {
  S sum(0);
  for (const Ball<S>& ball : all) {
    for (std::size_t k = 0; k < 3; ++k)
      sum = sum + S(0.5) * ball.v[k] * ball.v[k] + pull_along<S>(input, k) * ball.x[k];
  }
  return sum;
}

template <class S>
S squared_gap(const Ball<S>& a, const Ball<S>& b) {
  S square(0);
  for (std::size_t k = 0; k < 3; ++k) square = square + (b.x[k] - a.x[k]) * (b.x[k] - a.x[k]);
  return square - S(4 * radius * radius);
}

/// When two balls meet; a negative number if never. Gravity accelerates both equally.
template <class S>
S pair_time(const Ball<S>& a, const Ball<S>& b) {
  using std::sqrt;
  S closing(0);
  S speed(0);
  for (std::size_t k = 0; k < 3; ++k) {
    const S w = b.v[k] - a.v[k];
    closing = closing - (b.x[k] - a.x[k]) * w;
    speed = speed + w * w;
  }
  if (!(closing > S(0))) return S(-1);
  const S gap = squared_gap(a, b);
  if (!(gap > S(0))) return S(0);
  const S root = closing * closing - speed * gap;
  if (root < S(0)) return S(-1);
  return gap / (closing + sqrt(root));
}

/// When a ball meets the lower or the upper wall of an axis; a negative number if never.
template <class S>
S wall_time(const Ball<S>& ball, std::size_t k, bool upper, double room, S pull) {
  using std::sqrt;
  const S gap = upper ? S(room - radius) - ball.x[k] : ball.x[k] - S(radius);
  const S v = upper ? -ball.v[k] : ball.v[k];
  const S g = upper ? -pull : pull;
  if (g == S(0)) return v < S(0) ? (gap > S(0) ? gap / -v : S(0)) : S(-1);
  const S root = v * v + S(2) * g * gap;
  if (root < S(0) || (upper && !(v < S(0)))) return S(-1);
  // Down to a floor; or up to a ceiling, the first time.
  const S time = v > S(0) ? (v + sqrt(root)) / g : S(2) * gap / (sqrt(root) - v);
  return time > S(0) ? time : S(0);
}

template <class S>
void fly(Balls<S>& all, const Setting& input, S time) {
  for (Ball<S>& ball : all) {
    for (std::size_t k = 0; k < 3; ++k) {
      const S pull = pull_along<S>(input, k);
      ball.x[k] = ball.x[k] + time * (ball.v[k] - S(0.5) * pull * time);
      ball.v[k] = ball.v[k] - pull * time;
    }
  }
}

/// Equal balls exchange the normal components of their velocities.
template <class S>
void collide_equal(Ball<S>& a, Ball<S>& b) {
  S square(0);
  S closing(0);
  for (std::size_t k = 0; k < 3; ++k) {
    square = square + (b.x[k] - a.x[k]) * (b.x[k] - a.x[k]);
    closing = closing - (b.x[k] - a.x[k]) * (b.v[k] - a.v[k]);
  }
  if (!(closing > S(0))) return;
  for (std::size_t k = 0; k < 3; ++k) {
    const S push = (b.x[k] - a.x[k]) * closing / square;
    a.v[k] = a.v[k] - push;
    b.v[k] = b.v[k] + push;
  }
}

template <class S>
double as_double(const S& x) {
  if constexpr (std::is_same_v<S, DoubleDouble>)
    return x.high();
  else
    return static_cast<double>(x);
}

template <class S>
Course course(const Setting& input, const Balls<S>& all, double hits, double overlap) {
  Course got;
  for (const Ball<S>& ball : all)
    got.positions.push_back({as_double(ball.x[0]), as_double(ball.x[1]), as_double(ball.x[2])});
  got.hits = hits;
  const S before = energy_of(input, start<S>(input));
  got.energy_change = std::abs(as_double((energy_of(input, all) - before) / before));
  got.overlap = overlap;
  return got;
}

/// Is told where the balls are: here by nobody.
struct Unwatched {
  template <class S>
  void operator()(const Balls<S>&, const S&, const S&) const {}
};

/// Tests all pairs before each event. `watch(balls, left, flight)` is told before each flight of
/// the balls, of the time that is left and of the time that they fly.
template <class S, class Watch = Unwatched>
Course plain_loop(const Setting& input, Watch watch = {}) {
  const std::size_t walls = input.setup.walls.size();
  Balls<S> all = start<S>(input);
  S left = static_cast<S>(input.time);
  double hits = 0;
  double deepest = 0;
  for (;;) {
    S first = left;
    std::size_t who = all.size();
    std::size_t whom = 0;
    const auto offer = [&](const S& time, std::size_t i, std::size_t k) {
      if (time < S(0) || !(time < first)) return;
      first = time;
      who = i;
      whom = k;
    };
    for (std::size_t i = 0; i < all.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) offer(pair_time(all[i], all[k]), i, k);
      for (std::size_t w = 0; w < walls; ++w) {
        const S pull = pull_along<S>(input, w / 2);
        offer(wall_time(all[i], w / 2, w % 2 == 1, input.room, pull), i, all.size() + w);
      }
    }
    watch(all, left, first);
    fly(all, input, first);
    if (who == all.size()) return course(input, all, hits, deepest);
    left = left - first;
    ++hits;
    if (whom < all.size()) {
      deepest = std::max(deepest, -as_double(squared_gap(all[who], all[whom])) / (4 * radius));
      collide_equal(all[who], all[whom]);
    } else {
      const std::size_t wall = whom - all.size();
      all[who].v[wall / 2] = -all[who].v[wall / 2];
    }
  }
}

// ---------------------------------------------------------------- steps that test at their end

/// As in engines: semi-implicit Euler; then overlapping balls collide and are moved apart.
/// `watch(balls, left, flight)` is told after each step, of no flight.
template <class Watch = Unwatched>
Course in_steps(const Setting& input, double rate, Watch watch = {}) {
  const auto steps = static_cast<int>(std::ceil(input.time * rate));
  const double h = input.time / steps;
  const std::size_t walls = input.setup.walls.size();
  Balls<double> all = start<double>(input);
  double hits = 0;
  double deepest = 0;
  for (int step = 0; step < steps; ++step) {
    for (Ball<double>& ball : all) {
      for (std::size_t k = 0; k < 3; ++k) {
        ball.v[k] -= h * pull_along<double>(input, k);
        ball.x[k] += h * ball.v[k];
      }
    }
    for (std::size_t i = 0; i < all.size(); ++i) {
      Ball<double>& a = all[i];
      for (std::size_t k = 0; k < i; ++k) {
        Ball<double>& b = all[k];
        const double gap = squared_gap(a, b);
        if (!(gap < 0)) continue;
        ++hits;
        const double distance = std::sqrt(gap + 4 * radius * radius);
        deepest = std::max(deepest, 2 * radius - distance);
        collide_equal(a, b);
        for (std::size_t axis = 0; axis < 3 && distance > 0; ++axis) {
          const double apart = (b.x[axis] - a.x[axis]) / distance * (radius - distance / 2);
          a.x[axis] -= apart;
          b.x[axis] += apart;
        }
      }
      for (std::size_t w = 0; w < walls; ++w) {
        double& x = a.x[w / 2];
        double& v = a.v[w / 2];
        const bool upper = w % 2 == 1;
        const double limit = upper ? input.room - radius : radius;
        if (upper ? !(x > limit) : !(x < limit)) continue;
        ++hits;
        deepest = std::max(deepest, std::abs(x - limit));
        x = limit;
        if ((v > 0) == upper) v = -v;
      }
    }
    watch(all, input.time - (step + 1) * h, 0.0);
  }
  return course(input, all, hits, deepest);
}

// ---------------------------------------------------------------- composed

template <HardSphereEffects E>
Course composed(const Setting& input) {
  contact::HardSpheres<E> run(input.setup);
  const double before = run.energy();
  run.advance(input.time);
  Course got;
  for (std::size_t i = 0; i < run.moving(); ++i) got.positions.push_back(run.position(i));
  const contact::HardSphereCounts did = run.counts();
  got.hits = static_cast<double>(did.hits);
  got.energy_change = std::abs((run.energy() - before) / before);
  got.overlap = std::max(0.0, did.largest_overlap);
  return got;
}

constexpr HardSphereEffects elastic(int dimension, bool pulled) {
  return {.dimension = dimension,
          .gravity = pulled,
          .sizes = false,
          .restitution = false,
          .grid = false};
}

inline Course planned(const Setting& input) {
  switch (input.motion) {
    case Motion::line:
      return composed<elastic(1, false)>(input);
    case Motion::table:
      return composed<elastic(2, false)>(input);
    case Motion::box:
      break;
  }
  return composed<elastic(3, true)>(input);
}

}  // namespace compared_balls
