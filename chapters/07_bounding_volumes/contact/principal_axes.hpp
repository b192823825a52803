/// @file
/// Principal axes of points and of a surface, and the boxes along them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>

#include <contact/aabb.hpp>
#include <contact/box_around.hpp>
#include <contact/drop_dimension.hpp>
#include <contact/exact_ray_triangle.hpp>
#include <contact/mesh.hpp>
#include <contact/oriented_box.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace principal_axes_detail {

/// Coordinates moved and scaled by a power of two, to about 1.
template <std::floating_point S>
struct Scaled {
  Vector3<S> from;  ///< the centre of the box of the points
  int power = 0;    ///< of two; 0 if all points are equal

  /// @param bounds the box of the points
  explicit Scaled(const Aabb<S>& bounds) : from(bounds.low / S(2) + bounds.high / S(2)) {
    const S size = (bounds.high / S(2) - bounds.low / S(2)).maxCoeff();
    if (size > S(0)) std::frexp(size, &power);
    power = -power;
    // One factor may be out of range where two are not.
    first_ = std::ldexp(S(1), power / 2);
    second_ = std::ldexp(S(1), power - power / 2);
  }
  /// (p − from) · 2^power
  Vector3<S> operator()(const Vector3<S>& p) const {
    return Vector3<S>(p - from) * first_ * second_;
  }

 private:
  S first_, second_;
};

// [jacobi]
/// The eigenvectors of a symmetric matrix as columns, by Jacobi's rotations: each makes the entries
/// (p, q) and (q, p) zero. Only + − × ÷ √, so the result is the same on every machine.
/// @param m symmetric; on return diagonal up to rounding, with the eigenvalues
template <std::floating_point S>
Matrix3<S> diagonalised(Matrix3<S>& m) {
  Matrix3<S> vectors = Matrix3<S>::Identity();
  for (int sweep = 0; sweep < 20; ++sweep) {
    bool rotated = false;
    for (const auto& [p, q] : {std::pair{0, 1}, {0, 2}, {1, 2}}) {
      const S size = std::sqrt(std::abs(m(p, p)) * std::abs(m(q, q)));
      if (!(std::abs(m(p, q)) > std::numeric_limits<S>::epsilon() * size / S(4))) continue;
      rotated = true;
      const S cotangent = (m(q, q) - m(p, p)) / (S(2) * m(p, q));  // of twice the angle
      const S root = std::sqrt(S(1) + cotangent * cotangent);
      const S tangent = (cotangent < S(0) ? S(-1) : S(1)) / (std::abs(cotangent) + root);
      const S c = S(1) / std::sqrt(S(1) + tangent * tangent), s = c * tangent;
      for (int k = 0; k < 3; ++k) {  // columns p and q, then rows p and q
        const S kp = m(k, p), kq = m(k, q), vp = vectors(k, p), vq = vectors(k, q);
        m(k, p) = c * kp - s * kq, m(k, q) = s * kp + c * kq;
        vectors(k, p) = c * vp - s * vq, vectors(k, q) = s * vp + c * vq;
      }
      for (int k = 0; k < 3; ++k) {
        const S pk = m(p, k), qk = m(q, k);
        m(p, k) = c * pk - s * qk, m(q, k) = s * pk + c * qk;
      }
      m(p, q) = m(q, p) = S(0);
    }
    if (!rotated) break;
  }
  return vectors;
}
// [/jacobi]

/// A right-handed frame, orthonormal to within a few u, with its x axis along the first vector and
/// its y axis in the plane of both: Gram and Schmidt, twice, as once leaves an error that is large
/// where the vectors are nearly parallel.
/// @param first, second neither parallel nor 0
template <std::floating_point S>
Matrix3<S> orthonormal(const Vector3<S>& first, const Vector3<S>& second) {
  const auto unit = [](const Vector3<S>& v) { return Vector3<S>(v / std::sqrt(v.dot(v))); };
  Matrix3<S> axes;
  const Vector3<S> x = unit(first);
  const Vector3<S> once = unit(Vector3<S>(second - x * x.dot(second)));
  const Vector3<S> y = unit(Vector3<S>(once - x * x.dot(once)));
  axes.col(0) = x;
  axes.col(1) = y;
  axes.col(2) = unit(x.cross(y));
  return axes;
}

/// The eigenvectors of a covariance, the largest eigenvalue first; of equal ones the first. The
/// largest entry of the first two is positive.
template <std::floating_point S>
Matrix3<S> sorted_axes(Matrix3<S> covariance) {
  const Matrix3<S> vectors = diagonalised(covariance);
  std::array<int, 3> order{0, 1, 2};
  // std::sort would be 2 kB of each figure that shows these axes.
  const auto put_larger_first = [&](std::size_t i, std::size_t j) {
    const int a = order[i], b = order[j];
    if (covariance(b, b) > covariance(a, a)) std::swap(order[i], order[j]);
  };
  put_larger_first(0, 1);
  put_larger_first(1, 2);
  put_larger_first(0, 1);
  const auto column = [&](std::size_t i) {
    const Vector3<S> v = vectors.col(order[i]);
    return Vector3<S>(v[largest_dimension<S>(v)] < S(0) ? Vector3<S>(-v) : v);
  };
  return orthonormal<S>(column(0), column(1));
}

}  // namespace principal_axes_detail

// [principal-axes]
/// The principal axes of points: the eigenvectors of their covariance (1/n) Σ (p − m)(p − m)ᵀ, the
/// direction of the largest variance first, right-handed, orthonormal to within a few u.
///
/// Limits: rounded in S. They are a property of how the points are distributed, not of their hull:
/// points in the interior and points stored twice turn them. Where two eigenvalues are equal (a
/// cube, a regular prism) or nearly so, rounding or the next point decides the direction.
/// @param points n ≥ 1 points, m, finite
/// @return the axes of the world if all points are equal
/// @throws std::invalid_argument if there is no point, or an entry is not finite
template <FloatOrDouble S>
Matrix3<S> principal_axes(std::span<const Vector3<S>> points) {
  const principal_axes_detail::Scaled<S> scaled(aabb_of_points<S>(points));
  const S count = static_cast<S>(points.size());
  Vector3<S> mean = Vector3<S>::Zero();
  for (const Vector3<S>& p : points) mean += scaled(p) / count;
  Matrix3<S> covariance = Matrix3<S>::Zero();
  for (const Vector3<S>& p : points) {
    const Vector3<S> off = scaled(p) - mean;
    covariance += off * off.transpose();
  }
  return principal_axes_detail::sorted_axes<S>(covariance / count);
}

/// The box along the principal axes of points, which contains them all (box_with_axes()).
///
/// Limits: it may be larger than the axis-aligned box, without a bound on the factor: see
/// principal_axes().
/// @throws std::invalid_argument as box_with_axes()
template <FloatOrDouble S>
OrientedBox<S> principal_box(std::span<const Vector3<S>> points) {
  return box_with_axes<S>(principal_axes<S>(points), points);
}
// [/principal-axes]

// [principal-surface]
/// The box of a mesh along the principal axes of its surface: the covariance is an integral over
/// the triangles, so neither points in the interior nor how finely a face is cut up counts.
///
/// A triangle with centroid m, vertices v and area a contributes a/12 (9 m mᵀ + Σ v vᵀ).
///
/// Limits: that of a convex hull's surface does not depend on dents either; take its mesh. Equal
/// eigenvalues remain undecided. If no triangle has an area (as rounded), the vertices count.
/// @param mesh m; contains all vertices, also those that no triangle has
/// @throws std::invalid_argument if there is no vertex, a coordinate is not finite, or the box
/// overflows
///
/// Source: Gottschalk, Lin and Manocha, *OBBTree*, SIGGRAPH 1996.
inline OrientedBox<double> principal_box_of_surface(const Mesh<double>& mesh) {
  const std::span<const Vector3<double>> points(mesh.vertices);
  const principal_axes_detail::Scaled<double> scaled(aabb_of_points<double>(points));
  double area = 0;
  Vector3<double> moment = Vector3<double>::Zero();
  Matrix3<double> second = Matrix3<double>::Zero();
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle<double> t = triangle_of(mesh, i);
    const Vector3<double> a = scaled(t.a), b = scaled(t.b), c = scaled(t.c);
    const Vector3<double> normal = Vector3<double>(b - a).cross(Vector3<double>(c - a));
    const double twice = std::sqrt(normal.dot(normal));
    const Vector3<double> m = (a + b + c) / 3;
    area += twice;
    moment += twice * m;
    second += twice / 12 *
              (9 * m * m.transpose() + a * a.transpose() + b * b.transpose() + c * c.transpose());
  }
  if (!(area > 0)) return principal_box<double>(points);
  const Vector3<double> mean = moment / area;
  const Matrix3<double> covariance = second / area - mean * mean.transpose();
  return box_with_axes<double>(principal_axes_detail::sorted_axes<double>(covariance), points);
}
// [/principal-surface]

}  // namespace contact
