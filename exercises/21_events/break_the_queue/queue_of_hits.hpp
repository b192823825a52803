/// @file
/// Code to break: tiles from hit to hit, with a queue of predictions.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <contact/prelude.hpp>

namespace given {

/// The time at which a side of one tile hits a side of another, in s from now, if both move on as
/// they do; nothing if they do not hit along this axis.
///
/// @param position, velocity of the one relative to the other, m and m/s
/// @param axis 0 for sides that are perpendicular to x, 1 for those perpendicular to y
inline std::optional<double> time_to_hit(const Eigen::Vector2d& position,
                                         const Eigen::Vector2d& velocity, int axis) {
  const double gap = std::abs(position[axis]) - 1;
  const double closing = position[axis] > 0 ? -velocity[axis] : velocity[axis];
  if (gap < -1e-9 || closing <= 0) return std::nullopt;
  const double time = std::max(0.0, gap) / closing;
  const int other = 1 - axis;
  if (std::abs(position[other] + velocity[other] * time) >= 1) return std::nullopt;
  return time;
}

/// A hit that is expected.
struct Prediction {
  double time;          ///< s
  std::size_t owner;    ///< the tile for which it was computed
  std::size_t partner;  ///< the tile that the owner hits
  int axis;             ///< as in time_to_hit()
  int owner_hits;       ///< how many hits the owner had had when it was computed
};

/// A hit that happened.
struct Hit {
  double time;                ///< s
  std::size_t first, second;  ///< the tiles, by their indices
};

/// All hits in the order of their times, and how the tiles move at the end.
struct Run {
  std::vector<Hit> hits;
  std::vector<Eigen::Vector2d> positions, velocities;
};

/// The tiles from hit to hit, until the time `until` in s.
inline Run run(std::vector<Eigen::Vector2d> positions, std::vector<Eigen::Vector2d> velocities,
               double until) {
  std::vector<Hit> happened;
  std::vector<Prediction> queue;
  std::vector<int> hits(positions.size(), 0);  // of each tile
  double now = 0;

  const auto predict = [&](std::size_t owner) {
    for (std::size_t partner = 0; partner < positions.size(); ++partner) {
      if (partner == owner) continue;
      for (const int axis : {0, 1}) {
        const auto time = time_to_hit(positions[partner] - positions[owner],
                                      velocities[partner] - velocities[owner], axis);
        if (time) queue.push_back({now + *time, owner, partner, axis, hits[owner]});
      }
    }
  };
  const auto advance_to = [&](double time) {
    for (std::size_t i = 0; i < positions.size(); ++i) positions[i] += velocities[i] * (time - now);
    now = time;
  };

  for (std::size_t i = 0; i < positions.size(); ++i) predict(i);
  while (!queue.empty()) {
    const auto earliest =
        std::min_element(queue.begin(), queue.end(),
                         [](const Prediction& a, const Prediction& b) { return a.time < b.time; });
    const Prediction next = *earliest;
    queue.erase(earliest);
    if (next.time > until) break;
    if (next.owner_hits != hits[next.owner]) continue;  // the owner moves otherwise by now
    advance_to(next.time);
    std::swap(velocities[next.owner][next.axis], velocities[next.partner][next.axis]);
    happened.push_back({now, next.owner, next.partner});
    ++hits[next.owner];
    ++hits[next.partner];
    predict(next.owner);
    predict(next.partner);
  }
  advance_to(until);
  return {happened, positions, velocities};
}

}  // namespace given
