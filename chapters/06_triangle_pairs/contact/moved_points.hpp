/// @file
/// Points at an exact time of a translation, with the predicates that `contact/feature_pairs.hpp`
/// needs: used by `contact/feature_contacts.hpp`.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <contact/contact_time.hpp>
#include <contact/exact.hpp>
#include <contact/feature_pairs.hpp>
#include <contact/filter.hpp>
#include <contact/vector.hpp>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace contact::contact_time_detail {

/// A vertex x + t d at the time t = above/below.
class MovedVertex {
 public:
  /// @param d zero for a vertex at rest
  MovedVertex(const Vector3<double>& x, const Vector3<double>& d, const ContactTime& time)
      : start_(x), displacement_(d), time_(&time) {
    if (d == Vector3<double>::Zero()) {
      near_ = x;
      return;
    }
    // Three roundings: of t, of the product and of the sum. Underflow of t is left to the exact
    // type.
    constexpr double four_u = 2 * std::numeric_limits<double>::epsilon();
    const double t = time.nearest();
    const bool moves = time.above.sign() != 0;  // t may be 0 by underflow
    if (moves && t < 0x1p-900) error_ = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 3; ++k) {
      const double step = t * d[k];
      near_[k] = x[k] + step;
      error_ = std::max(error_, four_u * (std::abs(step) + std::abs(near_[k])));
    }
    error_ += 0x1p-1000;
  }

  /// Rounded.
  const Vector3<double>& near() const { return near_; }
  /// Each coordinate of the exact point differs from `near` by at most this; may be NaN.
  double error() const { return error_; }
  /// The exact point times the denominator of the time.
  const Vector3<Exact>& exact() const {
    if (!exact_) {
      const auto coordinate = [this](int k) {
        return Exact(start_[k]) * time_->below + Exact(displacement_[k]) * time_->above;
      };
      exact_ = Vector3<Exact>(coordinate(0), coordinate(1), coordinate(2));
    }
    return *exact_;
  }

 private:
  Vector3<double> start_, displacement_, near_ = Vector3<double>::Zero();
  const ContactTime* time_;
  double error_ = 0;
  mutable std::optional<Vector3<Exact>> exact_;
};

/// A pointer to one, as the type of a point.
struct MovedPoint {
  const MovedVertex* vertex = nullptr;

  const Vector3<double>& near() const { return vertex->near(); }
  const Vector3<Exact>& exact() const { return vertex->exact(); }
};

inline const Vector3<Exact>& in_exact(const MovedPoint& p) { return p.exact(); }

/// A difference of two points in double, with the largest of its coordinates and a bound on their
/// errors.
struct BoundedDifference {
  Vector3<double> value;
  double size, error;

  BoundedDifference(const MovedPoint& to, const MovedPoint& from)
      : value(to.near() - from.near()), size(value.cwiseAbs().maxCoeff()) {
    error =
        to.vertex->error() + from.vertex->error() + std::numeric_limits<double>::epsilon() * size;
  }
};

// [moved-signs]
/// The sign of the orientation of four points.
///
/// In double, the determinant of three differences of sizes P, Q, R with errors p, q, r has six
/// terms, so it is off by at most 6 ((P + p)(Q + q)(R + r) − PQR), and by less than 2^-47 PQR for
/// its own roundings. 8 instead of 6 and 2^-46 make room for those of the bound. Where this does
/// not decide, the exact points do.
inline int space_sign(const MovedPoint& a, const MovedPoint& b, const MovedPoint& c,
                      const MovedPoint& d) {
  const BoundedDifference ab(b, a), ac(c, a), ad(d, a);
  const double value = bounded_volume(ad.value, ab.value, ac.value).value;
  const double product = ab.size * ac.size * ad.size;
  const double most = (ab.size + ab.error) * (ac.size + ac.error) * (ad.size + ad.error);
  const double bound = 8 * (most - product) + 0x1p-46 * most + 0x1p-900 * (1 + ad.size);
  const int certain = Bounded{value, bound}.certain_sign();
  if (certain != 0) return certain;
  return signed_volume<Exact>(a.exact(), b.exact(), c.exact(), d.exact()).sign();
}

/// The same for three points in the projection without coordinate k; two terms.
inline int projected_sign(const MovedPoint& a, const MovedPoint& b, const MovedPoint& c, int k) {
  const BoundedDifference ab(b, a), ac(c, a);
  const double value =
      cross2<double>(drop_dimension<double>(ab.value, k), drop_dimension<double>(ac.value, k));
  const double product = ab.size * ac.size;
  const double most = (ab.size + ab.error) * (ac.size + ac.error);
  const double bound = 4 * (most - product) + 0x1p-46 * most + 0x1p-900;
  const int certain = Bounded{value, bound}.certain_sign();
  if (certain != 0) return certain;
  return feature_pairs_detail::projected_sign(a.exact(), b.exact(), c.exact(), k);
}
// [/moved-signs]

/// −1, 0 or 1: the order of coordinate k.
inline int compare_coordinate(const MovedPoint& p, const MovedPoint& q, int k) {
  if (p.vertex == q.vertex) return 0;
  const double apart = p.near()[k] - q.near()[k];
  const double error = 2 * (p.vertex->error() + q.vertex->error());
  const int certain = Bounded{apart, error + 0x1p-50 * std::abs(apart)}.certain_sign();
  if (certain != 0) return certain;
  return Exact(p.exact()[k] - q.exact()[k]).sign();
}
inline bool operator==(const MovedPoint& p, const MovedPoint& q) {
  return compare_coordinate(p, q, 0) == 0 && compare_coordinate(p, q, 1) == 0 &&
         compare_coordinate(p, q, 2) == 0;
}
/// The order of points by x, then y, then z.
inline bool is_before(const MovedPoint& p, const MovedPoint& q) {
  for (int k = 0; k < 3; ++k) {
    const int order = compare_coordinate(p, q, k);
    if (order != 0) return order < 0;
  }
  return false;
}

/// The vertices of a mesh at a time.
inline std::vector<MovedVertex> moved_vertices(const Mesh<double>& mesh, const Vector3<double>& d,
                                               const ContactTime& time) {
  std::vector<MovedVertex> moved;
  moved.reserve(mesh.vertices.size());
  for (const Vector3<double>& x : mesh.vertices) moved.emplace_back(x, d, time);
  return moved;
}

}  // namespace contact::contact_time_detail
