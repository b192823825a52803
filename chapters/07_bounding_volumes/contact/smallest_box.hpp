/// @file
/// A small oriented box around points: by the hull, candidates and descent.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include <contact/box_around.hpp>
#include <contact/convex_hull.hpp>
#include <contact/exact_ray_triangle.hpp>
#include <contact/frame.hpp>
#include <contact/hull.hpp>
#include <contact/oriented_box.hpp>
#include <contact/principal_axes.hpp>
#include <contact/smallest_rectangle.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace smallest_box_detail {

using Point = Vector3<double>;
using Flat = Vector2<double>;

/// Axes, and the volume of the box along them in the units of the search.
struct Candidate {
  Matrix3<double> axes = Matrix3<double>::Identity();
  double volume = std::numeric_limits<double>::infinity();
};

/// The volume of the box of some points along three axes, rounded.
inline double volume_along(const std::vector<Point>& points, const Matrix3<double>& axes) {
  double volume = 1;
  for (int i = 0; i < 3; ++i) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Point& p : points) {
      const double y = axes(0, i) * p[0] + axes(1, i) * p[1] + axes(2, i) * p[2];
      low = std::min(low, y);
      high = std::max(high, y);
    }
    volume *= high - low;
  }
  return volume;
}

/// The hull of points in the plane with rounded decisions, counter-clockwise, without memory of its
/// own. @param points are sorted @param hull receives the vertices
inline void rounded_hull(std::vector<Flat>& points, std::vector<Flat>& hull) {
  std::sort(points.begin(), points.end(), [](const Flat& a, const Flat& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  });
  hull.clear();
  const auto add = [&hull](const Flat& p, std::size_t start) {
    while (hull.size() >= start + 2 &&
           !(orientation<double>(hull[hull.size() - 2], hull.back(), p) > 0)) {
      hull.pop_back();
    }
    hull.push_back(p);
  };
  for (const Flat& p : points) add(p, 0);
  const std::size_t lower = hull.size() - 1;
  hull.pop_back();
  for (std::size_t i = points.size(); i-- > 0;) add(points[i], lower);
  hull.pop_back();
}

/// The direction of the smallest rectangle around points of the plane, and its area, rounded.
struct Turn {
  Flat along{1, 0};
  double area = std::numeric_limits<double>::infinity();
};
inline Turn smallest_turn(const std::vector<Flat>& hull) {
  Turn best;
  const std::size_t n = hull.size();
  const auto at = [&hull, n](std::size_t i) -> const Flat& { return hull[i < n ? i : i - n]; };
  const auto next = [n](std::size_t i) { return i + 1 < n ? i + 1 : 0; };
  std::size_t first = 0, last = 0, top = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Flat a = at(i), e = at(next(i)) - a;
    const double squared = e.dot(e);
    if (!(squared > 0)) continue;
    const Flat n_e(-e.y(), e.x());
    const auto move = [&](std::size_t& vertex, const Flat& direction) {
      for (std::size_t steps = 0; steps < n; ++steps) {
        if (!(direction.dot(Flat(at(next(vertex)) - at(vertex))) > 0)) return;
        vertex = next(vertex);
      }
    };
    if (i == 0) last = next(i);
    move(last, e);
    if (i == 0) top = last;
    move(top, n_e);
    if (i == 0) first = top;
    move(first, -e);
    const double area = e.dot(Flat(at(last) - at(first))) * n_e.dot(Flat(at(top) - a)) / squared;
    if (area < best.area) best = {e / std::sqrt(squared), area};
  }
  return best;
}

/// The search on the vertices of a hull, moved and scaled to about 1.
class Search {
 public:
  explicit Search(std::vector<Point> points) : points_(std::move(points)) {}

  const std::vector<Point>& points() const { return points_; }

  /// The best axes of which one is given: those of the smallest rectangle of the projection.
  Candidate about(const Point& axis) {
    const CoordinateFrame<double> frame = frame_on_normal<double>(Point::Zero(), axis);
    return about(frame.axes);
  }
  /// The same for the third of the axes.
  Candidate about(const Matrix3<double>& axes) {
    flat_.clear();
    double low = std::numeric_limits<double>::infinity(), high = -low;
    const Point x = axes.col(0), y = axes.col(1), z = axes.col(2);
    for (const Point& p : points_) {
      flat_.push_back({x.dot(p), y.dot(p)});
      low = std::min(low, z.dot(p));
      high = std::max(high, z.dot(p));
    }
    rounded_hull(flat_, hull_);
    const Turn turn = smallest_turn(hull_);
    Candidate found;
    const Point along = turn.along.x() * x + turn.along.y() * y;
    found.axes = principal_axes_detail::orthonormal<double>(along, Point(z.cross(along)));
    found.volume = turn.area * (high - low);
    return found;
  }

  /// Turns about one axis after the other until the volume no longer falls.
  Candidate descend(Candidate candidate) {
    int unchanged = 0;
    for (int step = 0; step < 60 && unchanged < 3; ++step) {
      Matrix3<double> axes;  // the next axis becomes the third
      for (int i = 0; i < 3; ++i) axes.col(i) = candidate.axes.col((i + 1) % 3);
      const Candidate turned = about(axes);
      unchanged = turned.volume < candidate.volume * (1 - 1e-12) ? 0 : unchanged + 1;
      candidate = unchanged == 0 ? turned : Candidate{axes, candidate.volume};
    }
    return candidate;
  }

 private:
  std::vector<Point> points_;
  std::vector<Flat> flat_, hull_;
};

}  // namespace smallest_box_detail

/// A small oriented box that contains all points.
template <FloatOrDouble S>
OrientedBox<S> smallest_box(std::span<const Vector3<S>> points) {
  using namespace smallest_box_detail;
  const Aabb<S> bounds = aabb_of_points<S>(points);
  std::vector<Point> stored;
  stored.reserve(points.size());
  for (const Vector3<S>& p : points) stored.push_back(p.template cast<double>());
  const Hull hull = convex_hull(stored);
  std::vector<Vector3<S>> vertices;
  std::vector<Point> scaled_vertices;
  const principal_axes_detail::Scaled<double> scaled(
      {bounds.low.template cast<double>(), bounds.high.template cast<double>()});
  for (const int i : hull.vertices) {
    vertices.push_back(points[static_cast<std::size_t>(i)]);
    scaled_vertices.push_back(scaled(stored[static_cast<std::size_t>(i)]));
  }
  const std::span<const Vector3<S>> span(vertices);
  const OrientedBox<S> aabb = box_with_axes<S>(Matrix3<S>::Identity(), span);
  if (hull.dimension < 1) return aabb;
  Search search(scaled_vertices);
  std::vector<Candidate> starts;
  const auto add = [&](const Matrix3<double>& axes) {
    starts.push_back({axes, volume_along(search.points(), axes)});
  };
  add(Matrix3<double>::Identity());
  add(principal_axes<double>(std::span<const Point>(search.points())));
  if (hull.dimension == 1) {
    starts.push_back(search.about(Point(scaled_vertices[1] - scaled_vertices[0])));
  }
  const int step = std::max(1, hull.face_count() / 200);
  for (int f = 0; f < hull.face_count(); f += step) {
    const auto face = hull.face(f);
    const auto at = [&](std::size_t i) {
      return scaled(stored[static_cast<std::size_t>(face[i])]);
    };
    const Point normal = Point(at(1) - at(0)).cross(Point(at(2) - at(0)));
    if (normal.cwiseAbs().maxCoeff() > 0) starts.push_back(search.about(normal));
  }
  std::stable_sort(starts.begin(), starts.end(),
                   [](const Candidate& a, const Candidate& b) { return a.volume < b.volume; });
  Candidate best = starts.front();
  for (std::size_t i = 0; i < std::min<std::size_t>(starts.size(), 8); ++i) {
    const Candidate found = search.descend(starts[i]);
    if (found.volume < best.volume) best = found;
  }
  const Matrix3<S> axes =
      principal_axes_detail::orthonormal<S>(Vector3<S>(best.axes.col(0).template cast<S>()),
                                            Vector3<S>(best.axes.col(1).template cast<S>()));
  const OrientedBox<S> box = box_with_axes<S>(axes, span);
  return best.volume < starts.front().volume ||
                 best.volume < volume_along(search.points(), Matrix3<double>::Identity())
             ? box
             : aabb;
}

}  // namespace contact
