/// @file
/// Points that are certainly inside a body, close to rounded ones on its surface.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <contact/body_contains.hpp>
#include <contact/certificates.hpp>
#include <contact/support.hpp>
#include <contact/vector.hpp>

namespace contact::detail {

// [certainly-inside]
/// Whether bounds on rounding prove that a point is inside a body: fast, and false means nothing.
template <ConvexBody Body>
bool certainly_inside(const Body&, const Vector3<double>&) {
  return false;
}

/// Of a cylinder with ends s and e and the core d = e − s: (p − s) · d > 0, (p − e) · d < 0 and
/// |(p − s) × d| < r |d|.
///
/// Differences, products and sums are at most five roundings, so a product with a difference is off
/// by at most γ(5) Σ|mₖ dₖ| ≤ 3 γ(5) M D for the largest coordinates M and D; so is each coordinate
/// of the cross product, its length by less than twice that and γ(4) of itself. 32 u M D is more.
inline bool certainly_inside(const Cylinder<double>& body, const Vector3<double>& p) {
  constexpr double u = std::numeric_limits<double>::epsilon() / 2;
  const Vector3<double> d = body.core.end - body.core.start;
  const Vector3<double> from_start = p - body.core.start, from_end = p - body.core.end;
  const double of_core = d.cwiseAbs().maxCoeff();
  const double of_point =
      std::max(from_start.cwiseAbs().maxCoeff(), from_end.cwiseAbs().maxCoeff());
  if (!(of_core > 0x1p-200 && of_core < 0x1p200 && of_point < 0x1p200)) return false;
  const double room = 32 * u * of_point * of_core + 0x1p-500;
  if (!(from_start.dot(d) > room && from_end.dot(d) < -room)) return false;
  const Vector3<double> moment = from_start.cross(d);
  return std::sqrt(moment.dot(moment)) * (1 + 8 * u) + room <
         body.radius * std::sqrt(d.dot(d)) * (1 - 8 * u);
}

/// Of an ellipsoid: Σ (dᵢ/hᵢ)² < D², with the determinants dᵢ of p − centre and two axes, and D of
/// the three.
///
/// Let m be the largest entry of the axes and W = |wₓ| + |w_y| + |w_z| for w = p − centre. A
/// coordinate of a cross product of axes is at most 2 m² and off by at most 2 γ(2) m², so dᵢ is off
/// by at most γ(6) 2 m² W, and D by at most γ(5) 6 m³. 16 u m² W and 48 u m³ are more.
inline bool certainly_inside(const Ellipsoid<double>& body, const Vector3<double>& p) {
  constexpr double u = std::numeric_limits<double>::epsilon() / 2;
  const Vector3<double> w = p - body.centre;
  const double m = body.axes.cwiseAbs().maxCoeff(), size = w.cwiseAbs().sum();
  const double least = body.half_lengths.minCoeff();
  if (!(m > 0x1p-50 && m < 0x1p50 && least > 0x1p-600 && size < 0x1p600)) return false;
  const Vector3<double> x = body.axes.col(0), y = body.axes.col(1), z = body.axes.col(2);
  const Vector3<double> yz = y.cross(z), zx = z.cross(x), xy = x.cross(y);
  const double room = 16 * u * m * m * size;
  const Vector3<double> at((std::abs(w.dot(yz)) + room) / body.half_lengths.x(),
                           (std::abs(w.dot(zx)) + room) / body.half_lengths.y(),
                           (std::abs(w.dot(xy)) + room) / body.half_lengths.z());
  const double volume = std::abs(x.dot(yz)) - 48 * u * m * m * m;
  return volume > 0x1p-400 && at.dot(at) < volume * volume * (1 - 32 * u);
}
// [/certainly-inside]

/// By which share of the size members are pulled inside at first: so far that contains() rarely has
/// to calculate exactly, or not at all.
inline constexpr double coarse_pull = 0x1p-46, no_pull = 0;

/// A point by about a distance farther inside than p, which is on the surface up to rounding:
/// towards an inner point.
template <ConvexBody Body>
Vector3<double> farther_inside(const Body&, const Vector3<double>& p, const Vector3<double>& inner,
                               double distance) {
  return p + unit_of_any_size<double>(Vector3<double>(inner - p)) * distance;
}
/// In a cylinder: along the core, and towards it.
inline Vector3<double> farther_inside(const Cylinder<double>& body, const Vector3<double>& p,
                                      const Vector3<double>& inner, double distance) {
  const Vector3<double> axis = unit_of_any_size<double>(Vector3<double>(body.core.end - inner));
  const Vector3<double> from_inner = p - inner;
  const double along = axis.dot(from_inner);
  const Vector3<double> across = from_inner - axis * along;
  const double off_axis = std::sqrt(across.dot(across));
  return p - axis * std::clamp(along, -distance, distance) -
         unit_of_any_size<double>(across) * std::min(distance, off_axis);
}
/// In an ellipsoid: against its normal, which is Σ axesᵢ (axesᵢ · (p − c))/hᵢ² up to rounding.
inline Vector3<double> farther_inside(const Ellipsoid<double>& body, const Vector3<double>& p,
                                      const Vector3<double>& inner, double distance) {
  const double largest = body.half_lengths.maxCoeff();
  Vector3<double> normal = Vector3<double>::Zero();
  for (int i = 0; i < 3; ++i) {
    const Vector3<double> axis = body.axes.col(i);
    const double share = largest / body.half_lengths(i);
    normal += axis * (axis.dot(Vector3<double>(p - inner)) * share * share);
  }
  return p - unit_of_any_size<double>(normal) * distance;
}

// [certainly-pulled]
/// A point that bounds prove to be inside a body, close to p, which is on its surface up to
/// rounding: pulled inside by `first` times the size, then by four times as much, and so on.
///
/// Bounds need a distance of 2^-48 of the products of lengths: of a flat cylinder or a thin
/// ellipsoid that is more than 2^-46 of the size. So it costs nothing but some distance to go
/// farther inside, where contains() would calculate exactly.
/// @param first greater than 0
/// @return nothing if none up to 2^-34 of the size is certain
template <ConvexBody Body>
std::optional<Vector3<double>> certainly_pulled(const Body& body, const Vector3<double>& p,
                                                const Vector3<double>& inner, double first) {
  const Vector3<double> nearer = p + (inner - p) * first;
  if (certainly_inside(body, nearer)) return nearer;
  const double size = p.cwiseAbs().maxCoeff() + Vector3<double>(p - inner).cwiseAbs().maxCoeff();
  for (double share = first; share <= 0x1p-34; share *= 4) {
    const Vector3<double> q = farther_inside(body, p, inner, share * size);
    if (certainly_inside(body, q)) return q;
  }
  return std::nullopt;
}
// [/certainly-pulled]

// [pulled-inside]
/// A member close to a rounded point of the body: the first that the body contains, of points
/// farther and farther inside, by `first` times the size, four times as much, and so on; at last of
/// points towards the inner point, up to that. If `first` is not 0, certainly_pulled() comes
/// before, because it costs least.
/// @return with a vertex of −2, which is no member, if there is none
template <ConvexBody Body>
Member pulled_inside(const Body& body, const Vector3<double>& p, const Vector3<double>& inner,
                     double first) {
  if (first == 0 && contains(body, p)) return {-1, p};
  if (first > 0) {
    if (const auto pulled = certainly_pulled(body, p, inner, first)) return {-1, *pulled};
  }
  const auto inside = [&body](const Vector3<double>& q) {
    return certainly_inside(body, q) || contains(body, q);
  };
  const double size = p.cwiseAbs().maxCoeff() + Vector3<double>(p - inner).cwiseAbs().maxCoeff();
  for (double share = std::max(first, 0x1p-54); share < 0x1p-20; share *= 4) {
    const Vector3<double> q = farther_inside(body, p, inner, share * size);
    if (inside(q)) return {-1, q};
  }
  for (double t = 0x1p-50; t <= 1; t *= 4) {
    const Vector3<double> q = p + (inner - p) * t;
    if (inside(q)) return {-1, q};
  }
  return {-2, p};
}
// [/pulled-inside]

}  // namespace contact::detail
