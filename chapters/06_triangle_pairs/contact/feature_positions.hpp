/// @file
/// Where two features meet in one point: in double with a bound on the error, and exactly. Used by
/// `contact/triangle_intersection.hpp`.
#pragma once

#include <algorithm>
#include <cmath>
#include <contact/exact.hpp>
#include <contact/feature_pairs.hpp>
#include <contact/filter.hpp>
#include <contact/segments.hpp>
#include <contact/vector.hpp>
#include <limits>

namespace contact::feature_pairs_detail {

inline Vector3<Exact> in_exact(const Vector3<double>& v) {
  return {Exact(v.x()), Exact(v.y()), Exact(v.z())};
}
inline const Vector3<Exact>& in_exact(const Vector3<Exact>& v) { return v; }
template <class P>
PointSet<Vector3<Exact>> in_exact(const PointSet<P>& set) {
  return {{in_exact(set.at[0]), in_exact(set.at[1]), in_exact(set.at[2])}, set.size};
}

/// Two features that meet in a point x: a vertex, or an edge and an edge or a face that it crosses.
template <class P>
struct MeetingFeatures {
  const PointSet<P>& one;    ///< the vertex, or the edge
  const PointSet<P>& other;  ///< the other edge or face
  Feature of_one, of_other;

  /// An end of the edge of the one.
  const P& end(int i) const { return one[of_one.index + i]; }
  /// An end of the edge of the other.
  const P& other_end(int i) const { return other[of_other.index + i]; }
};

/// The two features of a pair, a vertex before an edge before a face.
template <class P>
MeetingFeatures<P> meeting_features(const FeaturePair& pair, const PointSet<P>& a,
                                    const PointSet<P>& b) {
  if (pair.of_second.kind < pair.of_first.kind) return {b, a, pair.of_second, pair.of_first};
  return {a, b, pair.of_first, pair.of_second};
}

// ---------------------------------------------------------------- exact

/// The point above/below.
struct ExactPosition {
  Vector3<Exact> above;  ///< m times the denominator
  Exact below;           ///< denominator, not 0

  /// The sign of coordinate k minus x.
  int compare(int k, const Exact& x) const {
    return Exact(above[k] - x * below).sign() * below.sign();
  }
};

/// The point as a fraction of the edge of the one: n/d from its first end.
struct ExactAlong {
  Exact n, d;
};
inline ExactAlong exact_along(const MeetingFeatures<Vector3<Exact>>& f) {
  if (f.of_other.kind == FeatureKind::face) {
    const auto volume = [&f](const Vector3<Exact>& x) {
      return signed_volume<Exact>(f.other[0], f.other[1], f.other[2], x);
    };
    const Exact start = volume(f.end(0));
    return {start, start - volume(f.end(1))};
  }
  const Vector3<Exact> along = f.end(1) - f.end(0);
  const Vector3<Exact> other = f.other_end(1) - f.other_end(0);
  const Vector3<Exact> between = f.other_end(0) - f.end(0);
  const Vector3<Exact> normal = along.cross(other);
  const int k = normal[0].sign() != 0 ? 0 : (normal[1].sign() != 0 ? 1 : 2);
  return {cross2<Exact>(drop_dimension<Exact>(between, k), drop_dimension<Exact>(other, k)),
          normal[k]};
}

/// Where two features of a pair meet.
inline ExactPosition exact_position(const FeaturePair& pair, const PointSet<Vector3<Exact>>& a,
                                    const PointSet<Vector3<Exact>>& b) {
  const MeetingFeatures<Vector3<Exact>> f = meeting_features(pair, a, b);
  if (f.of_one.kind == FeatureKind::vertex) return {f.end(0), Exact(1.0)};
  const ExactAlong along = exact_along(f);
  const Vector3<Exact> step = f.end(1) - f.end(0);
  return {f.end(0) * along.d + step * along.n, along.d};
}

// ---------------------------------------------------------------- in double

// [bounded-position]
/// A point in double; the exact coordinates differ by at most `bound`. `sharp`: the bound on the
/// fraction of the edge is at most 2^-40, and nothing has overflowed.
struct BoundedPosition {
  Vector3<double> value = Vector3<double>::Zero();  ///< m
  double bound = 0;                                 ///< m
  bool sharp = true;                                ///< false: better to compute exactly
};

/// The fraction n/d of the edge of the one at which it meets the other, with its bound.
///
/// Edge and face: n is the volume between the face and the start of the edge, d that of the face
/// and the whole edge; both are determinants of differences of stored numbers, with the bound of
/// `bounded_volume`. Two edges: by Cramer's rule in the projection in which the rounded e × f is
/// largest. Another projection would be right as well, with a larger bound.
inline Bounded bounded_along(const MeetingFeatures<Vector3<double>>& f) {
  using segments_detail::bounded_cross, segments_detail::bounded_fraction;
  const Vector3<double> backwards = f.end(0) - f.end(1);
  if (f.of_other.kind == FeatureKind::face) {
    const Vector3<double> ab = f.other[1] - f.other[0], ac = f.other[2] - f.other[0];
    return bounded_fraction(bounded_volume(f.end(0) - f.other[0], ab, ac),
                            bounded_volume(backwards, ab, ac));
  }
  const Vector3<double> other = f.other_end(1) - f.other_end(0);
  const int k = largest_dimension<double>(backwards.cross(other));
  const auto flat = [k](const Vector3<double>& v) { return drop_dimension<double>(v, k); };
  const Vector2<double> p = flat(f.end(0)), q = flat(f.end(1));
  const Vector2<double> r = flat(f.other_end(0)), s = flat(f.other_end(1));
  return bounded_fraction(bounded_cross(p, r, r, s), bounded_cross(p, q, r, s));
}

/// Where two features of a pair meet. A vertex is copied.
///
/// The fraction t of the edge and its bound give each coordinate as p + t (q − p) with the bound of
/// `bounded_between`.
inline BoundedPosition bounded_position(const FeaturePair& pair, const PointSet<Vector3<double>>& a,
                                        const PointSet<Vector3<double>>& b) {
  const MeetingFeatures<Vector3<double>> f = meeting_features(pair, a, b);
  if (f.of_one.kind == FeatureKind::vertex) return {f.end(0), 0, true};
  const Bounded along = bounded_along(f);
  BoundedPosition found;
  found.sharp = along.bound <= 0x1p-40;
  for (int k = 0; k < 3; ++k) {
    const Bounded x = segments_detail::bounded_between(f.end(0)[k], f.end(1)[k], along);
    found.value[k] = x.value;
    found.bound = std::max(found.bound, x.bound);
    found.sharp = found.sharp && std::isfinite(x.value) && std::isfinite(x.bound);
  }
  return found;
}
// [/bounded-position]

}  // namespace contact::feature_pairs_detail
