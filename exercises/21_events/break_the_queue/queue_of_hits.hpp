/// @file
/// Code to break: tiles from hit to hit, with a queue of predictions.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <contact/prelude.hpp>

namespace given {

/// The time at which a side of a hits a side of b, in s from now, if both move on as they do;
/// nothing if they do not hit along this axis.
///
/// @param axis 0 for sides that are perpendicular to x, 1 for those perpendicular to y
template <class Tile>
std::optional<double> time_to_hit(const Tile& a, const Tile& b, std::size_t axis) {
  const std::size_t other = 1 - axis;
  const double distance = b.position[axis] - a.position[axis];
  const double velocity = b.velocity[axis] - a.velocity[axis];
  const double gap = std::abs(distance) - 1;
  const double closing = distance > 0 ? -velocity : velocity;
  if (gap < -1e-9 || closing <= 0) return std::nullopt;
  const double time = std::max(0.0, gap) / closing;
  const double offset =
      b.position[other] - a.position[other] + (b.velocity[other] - a.velocity[other]) * time;
  if (std::abs(offset) >= 1) return std::nullopt;
  return time;
}

/// A hit that is expected.
struct Prediction {
  double time;          ///< s
  std::size_t owner;    ///< the tile for which it was computed
  std::size_t partner;  ///< the tile that the owner hits
  std::size_t axis;     ///< as in time_to_hit()
  int owner_hits;       ///< how many hits the owner had had when it was computed
};

/// A hit that happened.
struct Hit {
  double time;                ///< s
  std::size_t first, second;  ///< the tiles, by their indices
};

/// All hits in the order of their times, and the tiles at the end.
template <class Tile>
struct Run {
  std::vector<Hit> hits;
  std::vector<Tile> tiles;
};

/// The tiles from hit to hit, until the time `until` in s.
template <class Tile>
Run<Tile> run(std::vector<Tile> tiles, double until) {
  std::vector<Hit> happened;
  std::vector<Prediction> queue;
  std::vector<int> hits(tiles.size(), 0);  // of each tile
  double now = 0;

  const auto predict = [&](std::size_t owner) {
    for (std::size_t partner = 0; partner < tiles.size(); ++partner) {
      if (partner == owner) continue;
      for (const std::size_t axis : {0, 1}) {
        const auto time = time_to_hit(tiles[owner], tiles[partner], axis);
        if (time) queue.push_back({now + *time, owner, partner, axis, hits[owner]});
      }
    }
  };
  const auto advance_to = [&](double time) {
    for (Tile& tile : tiles)
      for (const std::size_t axis : {0, 1})
        tile.position[axis] += tile.velocity[axis] * (time - now);
    now = time;
  };

  for (std::size_t i = 0; i < tiles.size(); ++i) predict(i);
  while (!queue.empty()) {
    const auto earliest =
        std::min_element(queue.begin(), queue.end(),
                         [](const Prediction& a, const Prediction& b) { return a.time < b.time; });
    const Prediction next = *earliest;
    queue.erase(earliest);
    if (next.time > until) break;
    if (next.owner_hits != hits[next.owner]) continue;  // the owner moves otherwise by now
    advance_to(next.time);
    std::swap(tiles[next.owner].velocity[next.axis], tiles[next.partner].velocity[next.axis]);
    happened.push_back({now, next.owner, next.partner});
    ++hits[next.owner];
    ++hits[next.partner];
    predict(next.owner);
    predict(next.partner);
  }
  advance_to(until);
  return {happened, tiles};
}

}  // namespace given
