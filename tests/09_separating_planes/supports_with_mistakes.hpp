/// @file
/// Farthest points of bodies along directions, right or with one mistake that people make: what the
/// test of the exercise compares with and recognises.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <variant>

#include "support.hpp"

namespace supports_with_mistakes {

using exercise::Body;
using exercise::Cylinder;
using exercise::Ellipsoid;
using Vector = Eigen::Vector3d;
using Axes = Eigen::Matrix3d;
using Sphere = contact::Sphere<double>;
using Capsule = contact::Capsule<double>;
using Box = contact::OrientedBox<double>;

/// The rotation by a quaternion of whole numbers.
inline Axes rotation(int w, int x, int y, int z) {
  Axes whole;
  whole << w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y),
      2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x), 2 * (x * z - w * y),
      2 * (y * z + w * x), w * w - x * x - y * y + z * z;
  return whole / (w * w + x * x + y * y + z * z);
}

/// The direction of v with length 1, whatever its length; zero if it is zero.
inline Vector unit(const Vector& v) {
  const double largest = v.cwiseAbs().maxCoeff();
  return largest > 0 ? Vector((v / largest) / (v / largest).norm()) : v;
}

/// One mistake for each kind of body that it can be made with; the others are right.
enum class Way {
  rightly,
  not_unit,            ///< the direction is used with its length
  opposite,            ///< the farthest point along the opposite direction
  without_radius,      ///< the farthest point of the core
  of_radius_one,       ///< a radius of 1
  at_the_nearer_end,   ///< the end of the core that is less far
  along_the_core,      ///< the radius of a capsule is added along its core
  caps_inside,         ///< the core of a capsule ends where its caps do
  without_axes,        ///< axes of the world
  by_rows,             ///< rows of the matrix as axes
  signs_of_the_world,  ///< the signs of the direction's own coordinates choose the corner
  with_edges,          ///< half lengths doubled
  with_half_the_half,  ///< or halved
  as_capsule,          ///< a cylinder with round caps
  rim_too_near,        ///< the component perpendicular to the core is not made a unit vector
  scaled_once,         ///< the unit direction in the ellipsoid's coordinates is scaled alone
  divided              ///< the direction is divided by the half lengths of an ellipsoid
};

inline Vector farthest(const Sphere& sphere, const Vector& n, Way way) {
  const double radius = way == Way::without_radius  ? 0
                        : way == Way::of_radius_one ? 1
                                                    : sphere.radius;
  return sphere.centre + radius * n;
}

/// The end of a core that is farther along n.
inline Vector end_of(const contact::Segment<double>& core, const Vector& n, Way way) {
  const bool at_end = n.dot(core.end - core.start) > 0;
  return at_end == (way != Way::at_the_nearer_end) ? core.end : core.start;
}

inline Vector farthest(const Capsule& capsule, const Vector& n, Way way) {
  const Vector end = end_of(capsule.core, n, way);
  const Vector along =
      end_of(capsule.core, n, Way::rightly) - end_of(capsule.core, n, Way::at_the_nearer_end);
  if (way == Way::along_the_core) return end + capsule.radius * along.normalized();
  if (way == Way::caps_inside)
    return end - capsule.radius * along.normalized() + capsule.radius * n;
  return farthest(Sphere{end, capsule.radius}, n, way);
}

inline double scale(Way way) {
  return way == Way::with_edges ? 2 : way == Way::with_half_the_half ? 0.5 : 1;
}

inline Axes axes_of(const Axes& axes, Way way) {
  return way == Way::without_axes ? Axes::Identity()
         : way == Way::by_rows    ? Axes(axes.transpose())
                                  : axes;
}

inline Vector farthest(const Box& box, const Vector& n, Way way) {
  const Axes axes = axes_of(box.axes, way);
  Vector corner = box.centre;
  for (int i = 0; i < 3; ++i) {
    const double along = way == Way::signs_of_the_world ? n[i] : n.dot(axes.col(i));
    corner += (along < 0 ? -1 : 1) * scale(way) * box.half_lengths[i] * axes.col(i);
  }
  return corner;
}

inline Vector farthest(const Cylinder& cylinder, const Vector& n, Way way) {
  const Vector end = end_of(cylinder.core, n, way);
  if (way == Way::without_radius) return end;
  if (way == Way::as_capsule) return end + cylinder.radius * n;
  const Vector axis = (cylinder.core.end - cylinder.core.start).normalized();
  const Vector outwards = n - n.dot(axis) * axis;
  if (way == Way::rim_too_near) return end + cylinder.radius * outwards;
  return end + (way == Way::of_radius_one ? 1 : cylinder.radius) * unit(outwards);
}

inline Vector farthest(const Ellipsoid& ellipsoid, const Vector& n, Way way) {
  const Vector h = scale(way) * ellipsoid.half_lengths;
  const Axes axes = axes_of(ellipsoid.axes, way);
  const Vector along = axes.transpose() * n;
  if (way == Way::scaled_once) return ellipsoid.centre + axes * h.cwiseProduct(along);
  if (way == Way::divided)
    return ellipsoid.centre + axes * h.cwiseProduct(unit(along.cwiseQuotient(h)));
  return ellipsoid.centre + axes * h.cwiseProduct(unit(h.cwiseProduct(along)));
}

inline Vector support_of(const Body& body, const Vector& direction, Way way = Way::rightly) {
  if (way == Way::opposite) return support_of(body, -direction);
  if (way == Way::not_unit) {
    // A radius is multiplied by the length of the direction; corners and rims do not depend on it.
    const bool round =
        std::holds_alternative<Sphere>(body.shape) || std::holds_alternative<Capsule>(body.shape);
    const Vector n = round ? direction : unit(direction);
    return std::visit([&](const auto& shape) { return farthest(shape, n, Way::rightly); },
                      body.shape);
  }
  const Vector n = unit(direction);
  return std::visit([&](const auto& shape) { return farthest(shape, n, way); }, body.shape);
}

// ---------------------------------------------------------------- what is right

/// How far the body extends along n, which has length 1: the largest n · p.
inline double extent(const Body& body, const Vector& n) {
  return n.dot(supports_with_mistakes::support_of(body, n));
}

/// How far p is outside of the body, or a bound of it; at most 0 inside.
inline double outside(const Body& body, const Vector& p) {
  struct {
    Vector p;
    double operator()(const Sphere& s) const { return (p - s.centre).norm() - s.radius; }
    double operator()(const Capsule& c) const {
      const Vector axis = c.core.end - c.core.start;
      const double t = std::clamp((p - c.core.start).dot(axis) / axis.squaredNorm(), 0.0, 1.0);
      return (p - c.core.start - t * axis).norm() - c.radius;
    }
    double operator()(const Box& b) const {
      return ((b.axes.transpose() * (p - b.centre)).cwiseAbs() - b.half_lengths).maxCoeff();
    }
    double operator()(const Cylinder& c) const {
      const Vector axis = (c.core.end - c.core.start).normalized(), from = p - c.core.start;
      const double along = from.dot(axis);
      return std::max({-along, along - (c.core.end - c.core.start).norm(),
                       (from - along * axis).norm() - c.radius});
    }
    double operator()(const Ellipsoid& e) const {
      const Vector x = (e.axes.transpose() * (p - e.centre)).cwiseQuotient(e.half_lengths);
      return (x.norm() - 1) * e.half_lengths.minCoeff();
    }
  } const distance{p};
  return std::visit(distance, body.shape);
}

/// Whether exactly one point is farthest along the direction, and near it is clearly farther than
/// elsewhere.
inline bool is_unique(const Body& body, const Vector& direction) {
  const Vector n = unit(direction);
  const auto core_is_clear = [&](const contact::Segment<double>& core) {
    return std::abs(n.dot(core.end - core.start)) > 1e-6;
  };
  if (n.isZero(0)) return false;
  if (const auto* capsule = std::get_if<Capsule>(&body.shape)) return core_is_clear(capsule->core);
  if (const auto* box = std::get_if<Box>(&body.shape))
    return (box->axes.transpose() * n).cwiseAbs().minCoeff() > 1e-6;
  if (const auto* cylinder = std::get_if<Cylinder>(&body.shape)) {
    const Vector axis = cylinder->core.end - cylinder->core.start;
    return core_is_clear(cylinder->core) && n.cross(axis).norm() > 1e-3 * axis.norm();
  }
  return true;
}

/// Whether the contract allows the body.
inline bool is_body(const Body& body) {
  const auto position = [](const Vector& p) {
    return p == p.array().round().matrix() && p.cwiseAbs().maxCoeff() <= 1000;
  };
  const auto length = [](double x) { return x == std::round(x) && x >= 1 && x <= 1000; };
  const auto core = [&](const contact::Segment<double>& s) {
    return position(s.start) && position(s.end) && s.start != s.end;
  };
  const auto frame = [&](const Vector& centre, const Axes& axes, const Vector& h) {
    return position(centre) && axes.allFinite() &&
           (axes.transpose() * axes - Axes::Identity()).cwiseAbs().maxCoeff() < 1e-14 &&
           length(h.x()) && length(h.y()) && length(h.z());
  };
  if (const auto* s = std::get_if<Sphere>(&body.shape))
    return position(s->centre) && length(s->radius);
  if (const auto* c = std::get_if<Capsule>(&body.shape)) return core(c->core) && length(c->radius);
  if (const auto* c = std::get_if<Cylinder>(&body.shape)) return core(c->core) && length(c->radius);
  if (const auto* b = std::get_if<Box>(&body.shape))
    return frame(b->centre, b->axes, b->half_lengths);
  const Ellipsoid& e = std::get<Ellipsoid>(body.shape);
  return frame(e.centre, e.axes, e.half_lengths);
}

}  // namespace supports_with_mistakes
