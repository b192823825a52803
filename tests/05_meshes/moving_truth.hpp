/// @file
/// Whether a moving point meets a moving mesh, by intervals of 160 bits; straight paths by
/// fractions.
#pragma once

#include <05_meshes/polyhedra_truth.hpp>
#include <array>
#include <contact/mesh.hpp>
#include <contact/moving_mesh.hpp>
#include <optional>
#include <support/generators.hpp>
#include <support/oracle.hpp>
#include <vector>

namespace moving_truth {

using contact::Mesh;
using contact::RigidMotion;
using contact::Segment;
using contact::Triangle;
using contact::Vector3;
using oracle::Interval;
using oracle::Rational;
using oracle::Vector;

inline constexpr unsigned bits = 160;

/// Start and travel of the point relative to the body's origin, in the stored axes of the start.
struct Straight {
  Vector start, travel;
};
inline Straight straight(const RigidMotion<double>& motion, const Segment<double>& path) {
  const Vector from = oracle::exact(path.start) - oracle::exact(motion.start.origin);
  const Vector travel =
      oracle::exact(path.end) - oracle::exact(path.start) - oracle::exact(motion.displacement);
  Straight found;
  for (int k = 0; k < 3; ++k) {
    const Vector axis = oracle::exact(Vector3<double>(motion.start.axes.col(k)));
    found.start[k] = axis.dot(from);
    found.travel[k] = axis.dot(travel);
  }
  return found;
}

/// Intervals that contain the path on intervals of s, and what a triangle's plane and edges make of
/// them.
class IntervalPath {
 public:
  IntervalPath(const RigidMotion<double>& motion, const Segment<double>& path) {
    const Straight y = straight(motion, path);
    Rational square(0);
    std::array<Rational, 3> r;
    for (int k = 0; k < 3; ++k) {
      r[std::size_t(k)] = oracle::exact(motion.rotation[k]);
      square += r[std::size_t(k)] * r[std::size_t(k)];
    }
    angle_ = sqrt(Interval(square, bits));
    for (std::size_t k = 0; k < 3; ++k) {
      start_[k] = Interval(y.start[int(k)], bits);
      travel_[k] = Interval(y.travel[int(k)], bits);
      axis_[k] = Interval(r[k], bits) / angle_;
    }
  }
  std::array<Interval, 3> at(const Interval& s) const {
    std::array<Interval, 3> y{start_[0] + s * travel_[0], start_[1] + s * travel_[1],
                              start_[2] + s * travel_[2]};
    const Interval c = cos(s * angle_), sine = sin(s * angle_);
    const Interval along =
        (axis_[0] * y[0] + axis_[1] * y[1] + axis_[2] * y[2]) * (Interval(Rational(1), bits) - c);
    std::array<Interval, 3> q;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
      q[k] = y[k] * c - (axis_[l] * y[m] - axis_[m] * y[l]) * sine + axis_[k] * along;
    }
    return q;
  }

  /// The answer for a triangle, from bisection of s; nothing if a contact is too close to an edge
  /// or to touching.
  std::optional<bool> meets(const Triangle<Rational>& t) const {
    const std::array<Vector, 3> v{t.a, t.b, t.c};
    const Vector n = Vector(t.b - t.a).cross(Vector(t.c - t.a));
    const auto affine = [](const Vector& normal, const Vector& from,
                           const std::array<Interval, 3>& x) {
      Interval sum(Rational(-normal.dot(from)), bits);
      for (std::size_t k = 0; k < 3; ++k) sum = sum + Interval(normal[int(k)], bits) * x[k];
      return sum;
    };
    struct Part {
      Rational low, high;
      int depth;
    };
    std::vector<Part> open{{Rational(0), Rational(1), 0}};
    bool all_decided = true;
    while (!open.empty()) {
      const Part part = open.back();
      open.pop_back();
      const auto q = at(Interval(part.low, part.high, bits));
      if (affine(n, t.a, q).sign().value_or(0) != 0) continue;
      bool outside = false, inside = true;
      for (std::size_t k = 0; k < 3; ++k) {
        const Vector inwards = n.cross(Vector(v[(k + 1) % 3] - v[k]));
        const int side = affine(inwards, v[k], q).sign().value_or(0);
        outside = outside || side < 0;
        inside = inside && side > 0;
      }
      if (outside) continue;
      if (inside) {
        const auto height = [&](const Rational& s) {
          return affine(n, t.a, at(Interval(s, bits))).sign().value_or(0);
        };
        if (height(part.low) * height(part.high) < 0) return true;
      }
      if (part.depth == 60) {
        all_decided = false;
        continue;
      }
      const Rational middle = (part.low + part.high) / 2;
      open.push_back({part.low, middle, part.depth + 1});
      open.push_back({middle, part.high, part.depth + 1});
    }
    if (!all_decided) return std::nullopt;
    return false;
  }

 private:
  std::array<Interval, 3> start_, travel_, axis_;
  Interval angle_;
};

/// Whether the point meets a triangle of the mesh during the step, exactly at its start; nothing if
/// that was not found out.
inline std::optional<bool> hit(const RigidMotion<double>& motion, const Segment<double>& path,
                               const Mesh<double>& mesh) {
  const Straight y = straight(motion, path);
  const bool turns = motion.rotation != Vector3<double>::Zero();
  bool all_decided = true;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle<Rational> t = oracle::exact(contact::triangle_of(mesh, i));
    const oracle::Vector n = oracle::Vector(t.b - t.a).cross(oracle::Vector(t.c - t.a));
    if (n.dot(n) == 0) continue;
    if (polyhedra_truth::meet_by_axes<Rational>({y.start, y.start}, {t.a, t.b, t.c})) return true;
    const std::optional<bool> one =
        turns ? IntervalPath(motion, path).meets(t)
              : std::optional<bool>(polyhedra_truth::meet_by_axes<Rational>(
                    {y.start, oracle::Vector(y.start + y.travel)}, {t.a, t.b, t.c}));
    if (one.value_or(false)) return true;
    all_decided = all_decided && one.has_value();
  }
  if (!all_decided) return std::nullopt;
  return false;
}

/// A vector with each coordinate up to a size.
inline contact::Vector3<double> drawn(generators::Random& random, double size) {
  const double x = random.uniform(-size, size);
  const double y = random.uniform(-size, size);
  return {x, y, random.uniform(-size, size)};
}

}  // namespace moving_truth
