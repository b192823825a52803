/// @file
/// Contact points that rounding adds: those that coincide with another one, or lie between others.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <vector>

#include <contact/vector.hpp>

namespace contact {

namespace detail {

/// Lengths below this fraction of a polytope's size count as 0: then a face that rounding has bent
/// is one face.
template <std::floating_point S>
inline constexpr S flatness = std::numeric_limits<S>::digits <= 24 ? S(0x1p-12) : S(0x1p-20);

// [face-size]
/// How large a convex polygon is: twice its area over its perimeter, which is at least the radius
/// of the largest circle in it and at most twice that. So a needle is as large as it is wide. Of
/// two points their distance, of one 0.
/// @param polygon vertices in order, m
/// @see T. Bonnesen and W. Fenchel, *Theorie der konvexen Körper*, Springer 1934
template <std::floating_point S>
S face_size(const std::vector<Vector3<S>>& polygon) {
  const auto length = [](const Vector3<S>& v) { return std::sqrt(v.dot(v)); };
  if (polygon.size() < 2) return S(0);
  if (polygon.size() == 2) return length(Vector3<S>(polygon[1] - polygon[0]));
  Vector3<S> twice_the_area = Vector3<S>::Zero();
  S perimeter(0);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector3<S> here = polygon[i] - polygon[0];
    const Vector3<S> next = polygon[(i + 1) % polygon.size()] - polygon[0];
    twice_the_area += Vector3<S>(here.cross(next));
    perimeter += length(Vector3<S>(next - here));
  }
  return perimeter > S(0) ? length(twice_the_area) / perimeter : S(0);
}
// [/face-size]

// [close-points]
/// Removes each point that is as close to a previous one as rounding puts points that are one: in
/// every coordinate at most 2^-20 (float: 2^-12) of the size. The first one stays as it is, with
/// its features, and so does the order.
///
/// Where two faces have vertices or edges above each other, clipping finds one point twice, or
/// once, as rounding decides anew in every step: two equal boxes on each other have from four to
/// eight points. Twice a point is no more support than once, but it divides the impulse in another
/// way, and a number of points that changes disturbs a stack at rest. The fraction is far above
/// rounding, also of coordinates that are 10^8 times as large as the face, and far below what
/// support needs: the lever arm of a load changes by no more than that.
/// @param size of the smaller of the two faces or edges, m: a needle keeps both its sides
template <class Manifold, std::floating_point S>
void merge_close_points(Manifold& manifold, const S& size) {
  const S least = flatness<S> * size;
  auto& points = manifold.points;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    bool is_known = false;
    for (std::size_t k = 0; k < kept && !is_known; ++k) {
      is_known = (points[i].point - points[k].point).cwiseAbs().maxCoeff() <= least;
    }
    if (!is_known) points[kept++] = points[i];
  }
  points.resize(kept);
}
// [/close-points]

/// Whether p is at most this far from a segment, in every coordinate; false for a segment of length
/// 0.
template <std::floating_point S>
bool is_on_segment(const Vector3<S>& p, const Vector3<S>& start, const Vector3<S>& end,
                   const S& least) {
  const S scale = Vector3<S>(end - start).cwiseAbs().maxCoeff();
  if (!(scale > S(0))) return false;
  const Vector3<S> along = (end - start) / scale, to = (p - start) / scale;
  const S part = std::clamp(S(along.dot(to) / along.dot(along)), S(0), S(1));
  return Vector3<S>(to - along * part).cwiseAbs().maxCoeff() * scale <= least;
}

// [outline-points]
/// Of points that are the vertices of a convex polygon in order, up to rounding, those that are
/// vertices of it: without those that coincide with a previous one, or lie on the segment between
/// others, to within 2^-20 (float: 2^-12) of the size. The others stay as they are, in order.
///
/// Two edges that lie above each other up to rounding cross at any position along their length, or
/// do not cross. A point there supports nothing that the ends do not.
template <class Manifold, std::floating_point S>
void keep_outline(Manifold& manifold, const S& size) {
  merge_close_points(manifold, size);
  auto& points = manifold.points;
  const std::size_t count = points.size();
  if (count < 3) return;
  // The point farthest from the first one is a vertex. Relative to the size nothing underflows.
  std::size_t start = 0;
  S extent(0), farthest(0);
  for (const auto& p : points) {
    extent = std::max(extent, S((p.point - points[0].point).cwiseAbs().maxCoeff()));
  }
  for (std::size_t i = 1; i < count; ++i) {
    const Vector3<S> away = (points[i].point - points[0].point) / extent;
    if (away.dot(away) > farthest) start = i;
    farthest = std::max(farthest, S(away.dot(away)));
  }
  std::vector<bool> stays(count, true);
  std::size_t last = 0;  // that stays, counted from the start
  const auto at = [&](std::size_t i) { return Vector3<S>(points[(start + i) % count].point); };
  for (std::size_t i = 1; i < count; ++i) {
    bool is_between = true;
    for (std::size_t k = last + 1; k <= i; ++k) {
      is_between = is_between && is_on_segment<S>(at(k), at(last), at(i + 1), flatness<S> * size);
    }
    if (is_between) {
      stays[(start + i) % count] = false;
    } else {
      last = i;
    }
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (stays[i]) points[kept++] = points[i];
  }
  points.resize(kept);
}
// [/outline-points]

}  // namespace detail

}  // namespace contact
