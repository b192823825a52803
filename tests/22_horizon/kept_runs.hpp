/// @file
/// Which quantities runs of a scene keep, measured: random balls from event to event, with gravity,
/// smooth walls, restitution and friction between balls. No rule of conservation is used.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <support/generators.hpp>

namespace kept_runs {

using V3 = Eigen::Vector3d;

/// What is the same for all runs of a scene.
struct Scene {
  V3 gravity;
  std::vector<V3> normals;
  bool elastic;
  bool friction;
  bool on_z_axis;
};

/// What the book calls conserved, or how far a run changed it.
struct Changes {
  double energy = 0;
  std::array<double, 3> momentum{};
  std::array<double, 3> angular_momentum{};
  double order = 0;  ///< 1 if it changed
};

struct Ball {
  double radius, mass, inertia;  // m, kg, kg m²
  V3 position, velocity, angular_velocity;
};

struct Wall {
  V3 normal;
  double offset;  // m, along the normal
};

/// Three balls among walls.
class Run {
 public:
  Run(const Scene& scene, int number, generators::Random& random) : scene_(scene) {
    place(random);
    if (!scene.on_z_axis) aim(number, random);
    for (const V3& normal : scene.normals) {
      double nearest = std::numeric_limits<double>::infinity();
      for (const Ball& ball : balls_)
        nearest = std::min(nearest, normal.dot(ball.position) - ball.radius);
      walls_.push_back({normal, nearest - random.uniform(0.1, 0.4)});
    }
    restitution_ = scene.elastic ? 1 : random.uniform(0.3, 0.8);
    coefficient_ = scene.friction ? random.uniform(0.2, 0.8) : 0;
  }

  /// For 3 s, or up to 60 hits: with k < 1 they may follow ever sooner.
  Changes play() {
    const Totals start = totals();
    Changes most;
    double left = 3;
    for (int hits = 0; hits < 60 && left > 0; ++hits) {
      const Next next = next_hit();
      const double flight = std::min(left, next.time);
      fly(flight);
      left -= flight;
      if (next.time <= flight && left > 0) hit(next);
      compare(start, most);
    }
    return most;
  }

 private:
  struct Next {
    double time = std::numeric_limits<double>::infinity();
    std::size_t ball = 0, other = 0;  // `other`: of a ball, or of a wall
    bool on_wall = false;
  };
  struct Totals {
    double energy = 0;
    V3 momentum = V3::Zero(), angular_momentum = V3::Zero();
    std::vector<std::size_t> order;
  };

  Scene scene_;
  std::vector<Ball> balls_;
  std::vector<Wall> walls_;
  double restitution_ = 1, coefficient_ = 0;

  static V3 any(generators::Random& random, double size) {
    const double x = random.uniform(-size, size);
    const double y = random.uniform(-size, size);
    const double z = random.uniform(-size, size);
    return {x, y, z};
  }

  void place(generators::Random& random) {
    const V3 middle = any(random, 2);
    while (balls_.size() < 3) {
      const double radius = random.uniform(0.2, 0.4);
      const double mass = random.uniform(0.5, 2);
      Ball ball{radius, mass, 0.4 * mass * radius * radius, V3::Zero(), V3::Zero(), V3::Zero()};
      if (scene_.on_z_axis) {
        ball.position.z() = static_cast<double>(balls_.size()) * 1.5 + random.uniform(0, 0.5);
        // They approach each other, and at least one of them any wall.
        ball.velocity.z() = random.uniform(1, 3) * (balls_.empty() ? 1 : -1);
      } else {
        ball.position = middle + any(random, 1.2);
        ball.velocity = any(random, 1);
        ball.angular_velocity = any(random, 2);
      }
      const auto apart = [&](const Ball& other) {
        return (other.position - ball.position).norm() > other.radius + ball.radius + 0.05;
      };
      if (std::all_of(balls_.begin(), balls_.end(), apart)) balls_.push_back(ball);
    }
  }

  // The ball that is nearest to one of the walls flies towards it, and two others meet.
  void aim(int number, generators::Random& random) {
    if (!scene_.normals.empty()) {
      const V3& normal = scene_.normals[static_cast<std::size_t>(number) % scene_.normals.size()];
      const auto gap = [&](const Ball& ball) { return normal.dot(ball.position) - ball.radius; };
      std::iter_swap(balls_.begin(), std::min_element(balls_.begin(), balls_.end(),
                                                      [&](const Ball& a, const Ball& b) {
                                                        return gap(a) < gap(b);
                                                      }));
      balls_[0].velocity -= 4 * normal;
    }
    const V3 off = any(random, 0.15);
    const V3 towards = (balls_[2].position + off - balls_[1].position).normalized();
    balls_[1].velocity = balls_[2].velocity + random.uniform(2, 4) * towards;
  }

  Totals totals() const {
    Totals sums;
    for (const Ball& ball : balls_) {
      const V3 momentum = ball.mass * ball.velocity;
      sums.energy += momentum.dot(ball.velocity) / 2 -
                     ball.mass * scene_.gravity.dot(ball.position) +
                     ball.inertia * ball.angular_velocity.squaredNorm() / 2;
      sums.momentum += momentum;
      sums.angular_momentum += ball.position.cross(momentum) + ball.inertia * ball.angular_velocity;
    }
    for (std::size_t i = 0; i < balls_.size(); ++i) sums.order.push_back(i);
    std::sort(sums.order.begin(), sums.order.end(), [this](std::size_t a, std::size_t b) {
      return balls_[a].position.z() < balls_[b].position.z();
    });
    return sums;
  }

  void compare(const Totals& start, Changes& most) const {
    const Totals now = totals();
    most.energy = std::max(most.energy, std::abs(now.energy - start.energy));
    for (int k = 0; k < 3; ++k) {
      const auto i = static_cast<std::size_t>(k);
      most.momentum[i] = std::max(most.momentum[i], std::abs(now.momentum(k) - start.momentum(k)));
      most.angular_momentum[i] = std::max(
          most.angular_momentum[i], std::abs(now.angular_momentum(k) - start.angular_momentum(k)));
    }
    if (now.order != start.order) most.order = 1;
  }

  Next next_hit() const {
    Next next;
    const auto earlier = [&](double time, std::size_t ball, std::size_t other, bool on_wall) {
      if (time < next.time) next = {time, ball, other, on_wall};
    };
    for (std::size_t i = 0; i < balls_.size(); ++i) {
      for (std::size_t j = i + 1; j < balls_.size(); ++j) earlier(meeting(i, j), i, j, false);
      for (std::size_t j = 0; j < walls_.size(); ++j) earlier(landing(i, j), i, j, true);
    }
    return next;
  }

  // Relative to each other, balls fly straight.
  double meeting(std::size_t i, std::size_t j) const {
    const V3 off = balls_[j].position - balls_[i].position;
    const V3 rate = balls_[j].velocity - balls_[i].velocity;
    const double along = off.dot(rate), reach = balls_[i].radius + balls_[j].radius;
    const double gap = std::max(0.0, off.squaredNorm() - reach * reach);
    const double squared = along * along - rate.squaredNorm() * gap;
    if (!(along < 0) || squared < 0) return std::numeric_limits<double>::infinity();
    return gap / (-along + std::sqrt(squared));
  }

  // The first root of gap + rate t + pull t²/2 at which the gap closes.
  double landing(std::size_t i, std::size_t j) const {
    const V3& normal = walls_[j].normal;
    const double gap =
        std::max(0.0, normal.dot(balls_[i].position) - balls_[i].radius - walls_[j].offset);
    const double rate = normal.dot(balls_[i].velocity), pull = normal.dot(scene_.gravity);
    const double squared = rate * rate - 2 * pull * gap;
    if (squared < 0 || (rate >= 0 && pull >= 0)) return std::numeric_limits<double>::infinity();
    if (rate < 0) return 2 * gap / (-rate + std::sqrt(squared));
    return (-rate - std::sqrt(squared)) / pull;
  }

  void fly(double time) {
    for (Ball& ball : balls_) {
      ball.position += time * ball.velocity + time * time / 2 * scene_.gravity;
      ball.velocity += time * scene_.gravity;
    }
  }

  void hit(const Next& next) {
    Ball& ball = balls_[next.ball];
    if (next.on_wall) {
      const V3& normal = walls_[next.other].normal;
      ball.velocity -= (1 + restitution_) * normal.dot(ball.velocity) * normal;
      return;
    }
    Ball& other = balls_[next.other];
    const V3 normal = (other.position - ball.position).normalized();
    const V3 lever = ball.radius * normal, other_lever = -other.radius * normal;
    const V3 rate = other.velocity + other.angular_velocity.cross(other_lever) - ball.velocity -
                    ball.angular_velocity.cross(lever);
    const double closing = -normal.dot(rate);
    const double push = (1 + restitution_) * closing / (1 / ball.mass + 1 / other.mass);
    V3 impulse = push * normal;  // on `other`
    const V3 slip = rate + closing * normal;
    if (const double speed = slip.norm(); coefficient_ > 0 && speed > 0) {
      // At most what stops the slip of solid balls: their tangential effective mass is 2/7 of the
      // normal one.
      const double stops = speed * 2 / 7 / (1 / ball.mass + 1 / other.mass);
      impulse -= std::min(coefficient_ * push, stops) / speed * slip;
    }
    ball.velocity -= impulse / ball.mass;
    other.velocity += impulse / other.mass;
    ball.angular_velocity -= lever.cross(impulse) / ball.inertia;
    other.angular_velocity += other_lever.cross(impulse) / other.inertia;
  }
};

/// The largest changes in some runs.
inline Changes changes(const Scene& scene, int runs, generators::Random& random) {
  Changes most;
  for (int i = 0; i < runs; ++i) {
    const Changes one = Run(scene, i, random).play();
    most.energy = std::max(most.energy, one.energy);
    most.order = std::max(most.order, one.order);
    for (std::size_t k = 0; k < 3; ++k) {
      most.momentum[k] = std::max(most.momentum[k], one.momentum[k]);
      most.angular_momentum[k] = std::max(most.angular_momentum[k], one.angular_momentum[k]);
    }
  }
  return most;
}

}  // namespace kept_runs
