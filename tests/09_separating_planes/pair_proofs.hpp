/// @file
/// Exact checks of what is said of two bodies of any kind, smooth ones included: whether a plane
/// separates them, and whether they have a point in common. It shares no code with the book.
#pragma once

#include <algorithm>
#include <cmath>
#include <contact/convex_bodies.hpp>
#include <contact/vector.hpp>
#include <optional>
#include <variant>

#include "pair_bodies.hpp"
#include "pair_truth.hpp"
#include "support/oracle.hpp"

namespace pair_proofs {

using oracle::Rational;
using oracle::Surd;
using oracle::Vector;
using pair_bodies::Body;

namespace detail {

inline Surd root(const Rational& squared) { return {0, 1, squared}; }

/// Half of each axis of an ellipsoid.
inline contact::Matrix3<Rational> half_axes(const contact::Ellipsoid<double>& b) {
  contact::Matrix3<Rational> m;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k)
      m(i, k) = oracle::exact(b.axes(i, k)) * oracle::exact(b.half_lengths(k));
  }
  return m;
}

struct Support {
  const Vector& n;

  template <class Polytope>
  Surd operator()(const Polytope& b) const {
    const pair_truth::Core core = pair_truth::core_of(b);
    Rational most = n.dot(core.vertices[0]);
    for (const Vector& v : core.vertices) most = std::max<Rational>(most, n.dot(v));
    return {most, core.radius, n.dot(n)};
  }
  Surd operator()(const contact::Cylinder<double>& b) const {
    const Vector s = oracle::exact(b.core.start), e = oracle::exact(b.core.end);
    const Vector d = e - s;
    const Rational along = n.dot(d);
    return {std::max<Rational>(n.dot(s), n.dot(e)), oracle::exact(b.radius),
            Rational(n.dot(n) - along * along / d.dot(d))};
  }
  Surd operator()(const contact::Ellipsoid<double>& b) const {
    const Vector turned = half_axes(b).transpose() * n;
    return {n.dot(oracle::exact(b.centre)), 1, turned.dot(turned)};
  }
};

/// 1: inside, 0: on the surface, −1: outside. Of a body without volume all points are on the
/// surface.
struct Inside {
  const Vector& p;

  template <class Polytope>
  int operator()(const Polytope& b) const {
    const pair_truth::Core core = pair_truth::core_of(b);
    const pair_truth::Core point{{p}, {}, {}, 0};
    return -pair_truth::truth(point, core).sign;
  }
  int operator()(const contact::Cylinder<double>& b) const {
    const Vector s = oracle::exact(b.core.start), d = oracle::exact(b.core.end) - s, w = p - s;
    const Rational along = w.dot(d), length = d.dot(d), radius = oracle::exact(b.radius);
    const Rational off = w.dot(w) * length - along * along;
    return std::min({oracle::sign(along), oracle::sign(Rational(length - along)),
                     oracle::sign(Rational(radius * radius * length - off))});
  }
  int operator()(const contact::Ellipsoid<double>& b) const {
    const contact::Matrix3<Rational> m = half_axes(b);
    const Vector w = p - oracle::exact(b.centre);
    const Vector x = m.col(0), y = m.col(1), z = m.col(2);
    const Rational volume = x.dot(y.cross(z));
    const Vector at(w.dot(y.cross(z)), w.dot(z.cross(x)), w.dot(x.cross(y)));
    return oracle::sign(Rational(volume * volume - at.dot(at)));
  }
};

}  // namespace detail

/// The largest n · x of a body, times |n|.
inline Surd support(const Body& body, const Vector& n) {
  return std::visit(detail::Support{n}, body);
}
/// The sign of the gap of A and B along n, which points from B to A: 1 if a plane perpendicular to
/// n separates them strictly, 0 if a plane touches both, −1 if none separates them.
inline int gap_sign(const Body& a, const Body& b, const Vector& n) {
  const Surd lowest = -support(a, Vector(-n));
  return oracle::compare(lowest, support(b, n));
}
/// The gap of A and B along n, divided by |n|, in m; rounded, with an error of some u of the
/// bodies' coordinates. For disjoint bodies no distance is smaller.
inline double gap_along(const Body& a, const Body& b, const contact::Vector3<double>& n) {
  const Vector e = oracle::exact(n);
  const Surd high = support(b, e), low = support(a, Vector(-e));
  const Surd rational = oracle::divided_by_root(Rational(-low.a - high.a), e.dot(e));
  const auto rest = [&e](const Surd& x) {
    return oracle::nearest(Surd{0, x.b, Rational(x.d / e.dot(e))});
  };
  return oracle::nearest(rational) - rest(low) - rest(high);
}
/// 1: a point is inside a body, 0: on its surface, −1: outside.
inline int inside(const Body& body, const Vector& p) { return std::visit(detail::Inside{p}, body); }

namespace detail {

using Long = contact::Vector3<long double>;
inline Long longer(const contact::Vector3<double>& v) { return v.cast<long double>(); }

/// How far a point is outside a body, in long double: its error is far below one u of double.
struct Outside {
  const contact::Vector3<double>& p;

  template <class Polytope>
  double operator()(const Polytope& b) const {
    const pair_truth::Core point{{oracle::exact(p)}, {}, {}, 0};
    return std::max(0.0,
                    oracle::nearest(pair_truth::truth(point, pair_truth::core_of(b)).distance));
  }
  double operator()(const contact::Cylinder<double>& b) const {
    const Long s = longer(b.core.start), w = longer(p) - s;
    const long double length = (longer(b.core.end) - s).norm();
    const Long axis = (longer(b.core.end) - s) / length;
    const long double along = axis.dot(w), off = (w - axis * along).norm() - b.radius;
    const long double beyond = std::max(-along, along - length);
    return static_cast<double>(std::hypot(std::max(0.0L, off), std::max(0.0L, beyond)));
  }
  /// The nearest point has coordinates xᵢ = hᵢ wᵢ / (hᵢ² + λ) along the axes, with λ ≥ 0 where
  /// x · x = 1. The axes are taken as orthogonal: they are, to some u.
  double operator()(const contact::Ellipsoid<double>& b) const {
    const Long w = b.axes.cast<long double>().transpose() * (longer(p) - longer(b.centre));
    const Long h = longer(b.half_lengths);
    const auto at = [&](long double lambda) {
      return Long(
          h.cwiseProduct(w).cwiseQuotient(Long(h.cwiseProduct(h) + Long::Constant(lambda))));
    };
    if (at(0).squaredNorm() <= 1) return 0;
    long double low = 0, high = h.maxCoeff() * w.norm();
    for (int i = 0; i < 200; ++i) {
      const long double middle = low + (high - low) / 2;
      (at(middle).squaredNorm() > 1 ? low : high) = middle;
    }
    return static_cast<double>((w - h.cwiseProduct(at(high))).norm());
  }
};

}  // namespace detail

/// The distance of a point from a body, rounded; 0 inside.
inline double distance_from(const Body& body, const contact::Vector3<double>& p) {
  return std::visit(detail::Outside{p}, body);
}

/// What a direction and a point prove of two bodies: 1 that they are disjoint, 0 that they touch,
/// −1 that they overlap; or nothing.
inline std::optional<int> proved(const Body& a, const Body& b, const Vector& n, const Vector& p) {
  const int gap = gap_sign(a, b, n);
  if (gap > 0) return 1;
  const int in_a = inside(a, p), in_b = inside(b, p);
  if (gap == 0 && in_a >= 0 && in_b >= 0) return 0;
  // A plane with A on one side has an inner point of A strictly on it; B has the point, too.
  if (std::min(in_a, in_b) >= 0 && std::max(in_a, in_b) > 0) return -1;
  return std::nullopt;
}

}  // namespace pair_proofs
