/// @file
/// Contact points from step to step: which point of a manifold is which of the previous step's.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <vector>

#include <contact/manifold_point.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace detail {

/// Whether one of the features is a vertex.
constexpr bool has_vertex(const PointFeatures& features) {
  const auto is_vertex = [](const SurfaceFeature& f) {
    return f.first >= 0 && f.first == f.second;
  };
  return is_vertex(features.of_a) || is_vertex(features.of_b);
}

}  // namespace detail

// [matched-points]
/// For each point of a manifold the index of the same point in the previous step's manifold, or −1.
///
/// Points of the same features are the same if a vertex is one of them, because it moves with its
/// body, however far it slides. The crossing of two edges must also be at most `radius` from the
/// previous one: if the edges are nearly parallel, rounding moves it along all of their length.
/// What is left is matched by distance: of all pairs at most `radius` apart the closest first, of
/// equally close ones the first. Each previous point is used at most once, so an impulse is never
/// given to two points.
///
/// Features alone would not do: where a face lies exactly on a face, rounding decides whether a
/// vertex of one is over the other, and the features change although the point does not move.
///
/// If the normals are more than 60° apart nothing is matched, because the bodies touch at other
/// faces, whose impulses have nothing to do with the previous ones.
/// @param now, previous manifolds of the same two bodies, in the same order
/// @param radius m, not negative
template <std::floating_point S>
std::vector<int> matched_points(const ContactManifold<S>& now, const ContactManifold<S>& previous,
                                const S& radius) {
  std::vector<int> matched(now.points.size(), -1);
  if (!(now.normal.dot(previous.normal) >= S(0.5))) return matched;
  std::vector<bool> used(previous.points.size(), false);
  const auto match = [&](std::size_t i, std::size_t k) {
    matched[i] = static_cast<int>(k);
    used[k] = true;
  };
  const auto between = [&](std::size_t i, std::size_t k) {
    const Vector3<S> d = now.points[i].point - previous.points[k].point;
    return std::sqrt(d.dot(d));
  };
  for (std::size_t i = 0; i < now.points.size(); ++i) {
    const PointFeatures& features = now.points[i].features;
    for (std::size_t k = 0; k < previous.points.size(); ++k) {
      if (used[k] || features != previous.points[k].features) continue;
      if (!detail::has_vertex(features) && !(between(i, k) <= radius)) continue;
      match(i, k);
      break;
    }
  }
  struct Near {
    S distance;
    std::size_t now, previous;
  };
  std::vector<Near> pairs;
  for (std::size_t i = 0; i < now.points.size(); ++i) {
    for (std::size_t k = 0; k < previous.points.size() && matched[i] < 0; ++k) {
      const S distance = between(i, k);
      if (!used[k] && distance <= radius) pairs.push_back({distance, i, k});
    }
  }
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const Near& x, const Near& y) { return x.distance < y.distance; });
  for (const Near& pair : pairs) {
    if (matched[pair.now] < 0 && !used[pair.previous]) match(pair.now, pair.previous);
  }
  return matched;
}
// [/matched-points]

}  // namespace contact
