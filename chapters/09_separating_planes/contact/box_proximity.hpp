/// @file
/// Disjoint, touching or overlapping: the decision for two boxes, exact and fast.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include <contact/box_axes.hpp>
#include <contact/oriented_box.hpp>
#include <contact/proximity_cases.hpp>
#include <contact/tolerance.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace detail {

/// a · b of column i of one matrix and column j of another.
[[gnu::always_inline]] inline double column_product(const Matrix3<double>& a, int i,
                                                    const Matrix3<double>& b, int j) {
  return a(0, i) * b(0, j) + a(1, i) * b(1, j) + a(2, i) * b(2, j);
}

// [box-pair-test]
/// The separations of two boxes along the fifteen axes, in floating point, with a bound on their
/// error. The members fill the tables in this order: faces of A, faces of B, edges.
///
/// With orthonormal axes, C = AᵀB holds all that the extents of the boxes along the fifteen axes
/// need. Stored axes are not quite orthonormal; `oblique` bounds the entries of |AᵀA − 1| and |BᵀB
/// − 1|, and margin() is above what this and rounding add up to. Everything is inlined and nothing
/// is a loop, because at -O2 the compiler leaves loops as they are, which doubles the time.
struct BoxPairTest {
  const OrientedBox<double>& a;  ///< in front
  const OrientedBox<double>& b;  ///< behind
  Vector3<double> d;             ///< from the centre of B to that of A, m
  double size;                   ///< |d|₁ and all half lengths, m
  double oblique;                ///< of the axes that were visited, and of their lengths
  double largest;                ///< the largest separation along a face normal so far, m
  double cosines[3][3];          ///< aᵢ · bⱼ
  double magnitudes[3][3];       ///< |aᵢ · bⱼ|
  double in_a[3];                ///< aᵢ · d, m

  [[gnu::always_inline]] BoxPairTest(const OrientedBox<double>& in_front,
                                     const OrientedBox<double>& behind)
      : a(in_front), b(behind), d(a.centre - b.centre) {
    const Vector3<double>& p = a.half_lengths;
    const Vector3<double>& q = b.half_lengths;
    size = ((std::abs(d.x()) + std::abs(d.y())) + (std::abs(d.z()) + p.x())) +
           ((p.y() + p.z()) + (q.x() + q.y())) + q.z();
    oblique = (off_unit(a, 0) + off_unit(a, 1)) + (off_unit(a, 2) + off_unit(b, 0)) +
              (off_unit(b, 1) + off_unit(b, 2)) + 8 * tolerance::unit_roundoff<double>;
    largest = -std::numeric_limits<double>::infinity();
  }

  /// Whether the bounds hold: axes of a length near 1, nothing overflows, and underflow does not
  /// matter beside a bound of 2^-650 at least.
  bool in_range() const { return oblique <= 0x1p-12 && in_filter_range(size); }

  /// At least the error of a separation along a stored axis: it has at most 14 roundings, so the
  /// error is at most γ(14) of the absolute values of its terms, which are below 1.1 size.
  double rounding() const { return 32 * tolerance::unit_roundoff<double> * size; }

  /// At least the error of a separation of the stored boxes, relative to the axis of box_axis()
  /// divided by |det A| or |det B|.
  ///
  /// Let ε be the bound `oblique`. Coordinates of x in the axes of A differ from Aᵀx by at most 3.1
  /// ε |x|, because (AᵀA)⁻¹ = 1 − E + ..., and so do C and d by 3.1 ε; |det A| and |det B| are 1
  /// within 2 ε. A face's separation is then off by at most 3.2 ε size, and that of two edges, a
  /// sum of products of two of these numbers, by at most 13 ε size; rounding adds less than 36 u
  /// size.
  double margin() const { return (16 * oblique + 48 * tolerance::unit_roundoff<double>)*size; }

  /// Whether face normal i of A separates the boxes, with certainty.
  template <int i>
  [[gnu::always_inline]] bool face_of_a_separates() {
    set_cosine(i, 0);
    set_cosine(i, 1);
    set_cosine(i, 2);
    in_a[i] = a.axes(0, i) * d.x() + a.axes(1, i) * d.y() + a.axes(2, i) * d.z();
    const Vector3<double>& other = b.half_lengths;
    return keep(std::abs(in_a[i]) - own_extent<i>(a) -
                (other.x() * magnitudes[i][0] + other.y() * magnitudes[i][1] +
                 other.z() * magnitudes[i][2]));
  }
  /// Whether face normal j of B separates the boxes, with certainty. After the faces of A.
  template <int j>
  [[gnu::always_inline]] bool face_of_b_separates() {
    const double in_b = b.axes(0, j) * d.x() + b.axes(1, j) * d.y() + b.axes(2, j) * d.z();
    const Vector3<double>& other = a.half_lengths;
    return keep(std::abs(in_b) - own_extent<j>(b) -
                (other.x() * magnitudes[0][j] + other.y() * magnitudes[1][j] +
                 other.z() * magnitudes[2][j]));
  }

  /// The separation along aᵢ × bⱼ, times its length. After the faces.
  template <int i, int j>
  [[gnu::always_inline]] double along_edges() const {
    constexpr int k = (i + 1) % 3, l = (i + 2) % 3, m = (j + 1) % 3, n = (j + 2) % 3;
    const double extent_a =
        a.half_lengths(k) * magnitudes[l][j] + a.half_lengths(l) * magnitudes[k][j];
    const double extent_b =
        b.half_lengths(m) * magnitudes[i][n] + b.half_lengths(n) * magnitudes[i][m];
    return std::abs(in_a[l] * cosines[k][j] - in_a[k] * cosines[l][j]) - (extent_a + extent_b);
  }

  /// Whether it is not certain that the projections on aᵢ × bⱼ overlap; `axis` becomes 6 + 3 i + j
  /// if it is certain that they do not.
  ///
  /// The rounded separation along a short axis is always in doubt. But if edges at an angle φ have
  /// an axis that separates the boxes, even weakly, then rotate B about this axis by φ: its
  /// projection stays as it is, and the edges become parallel, so a face normal of one of the two
  /// separates them, because four normals suffice in a plane. The rotation moves no point farther
  /// than 2 sin(φ/2) size ≤ √2 sin(φ) size. So if all faces overlap by more than that, this axis
  /// does not separate the boxes.
  template <int i, int j>
  [[gnu::always_inline]] bool edges_in_doubt(double margin, int& axis) const {
    const double separation = along_edges<i, j>();
    if (separation < -margin) return false;
    if (separation > margin) {
      axis = 6 + 3 * i + j;
      return true;
    }
    const double sine = magnitudes[(i + 1) % 3][j] + magnitudes[(i + 2) % 3][j] + 8 * oblique;
    return !(2 * sine * size < -largest - margin);
  }

 private:
  [[gnu::always_inline]] static double off_unit(const OrientedBox<double>& box, int i) {
    return std::abs(column_product(box.axes, i, box.axes, i) - 1);
  }
  [[gnu::always_inline]] void set_cosine(int i, int j) {
    cosines[i][j] = column_product(a.axes, i, b.axes, j);
    magnitudes[i][j] = std::abs(cosines[i][j]);
  }
  /// At least the extent of a box along its own axis i.
  template <int i>
  [[gnu::always_inline]] double own_extent(const OrientedBox<double>& box) {
    constexpr int j = (i + 1) % 3, k = (i + 2) % 3;
    const double to_j = std::abs(column_product(box.axes, i, box.axes, j));
    const double to_k = std::abs(column_product(box.axes, i, box.axes, k));
    oblique += to_j;
    return box.half_lengths(i) * (1 + off_unit(box, i)) +
           (box.half_lengths(j) * to_j + box.half_lengths(k) * to_k);
  }
  [[gnu::always_inline]] bool keep(double separation) {
    largest = std::max(largest, separation);
    return separation > rounding();
  }
};
// [/box-pair-test]

/// A decision, and the axis that proves it: one along which the boxes are disjoint, or touch; −1
/// for overlapping boxes.
struct BoxDecision {
  Proximity state = Proximity::undecided;
  int axis = -1;  ///< as in box_axis()
};

/// The decision if it is certain in floating point, else undecided.
inline BoxDecision rounded_box_decision(const OrientedBox<double>& a,
                                        const OrientedBox<double>& b) {
  BoxPairTest t(a, b);
  if (!t.in_range()) return {};
  if (t.face_of_a_separates<0>()) return {Proximity::disjoint, 0};
  if (t.face_of_a_separates<1>()) return {Proximity::disjoint, 1};
  if (t.face_of_a_separates<2>()) return {Proximity::disjoint, 2};
  if (t.face_of_b_separates<0>()) return {Proximity::disjoint, 3};
  if (t.face_of_b_separates<1>()) return {Proximity::disjoint, 4};
  if (t.face_of_b_separates<2>()) return {Proximity::disjoint, 5};
  const double margin = t.margin();
  if (!t.in_range()) return {};
  int axis = -1;
  const bool doubt = t.edges_in_doubt<0, 0>(margin, axis) || t.edges_in_doubt<0, 1>(margin, axis) ||
                     t.edges_in_doubt<0, 2>(margin, axis) || t.edges_in_doubt<1, 0>(margin, axis) ||
                     t.edges_in_doubt<1, 1>(margin, axis) || t.edges_in_doubt<1, 2>(margin, axis) ||
                     t.edges_in_doubt<2, 0>(margin, axis) || t.edges_in_doubt<2, 1>(margin, axis) ||
                     t.edges_in_doubt<2, 2>(margin, axis);
  if (axis >= 0) return {Proximity::disjoint, axis};
  if (doubt || !(t.largest < -margin)) return {};
  return {Proximity::overlapping, -1};
}

/// The decision by the exact sign of every axis.
[[gnu::noinline]] inline BoxDecision exact_box_decision(const OrientedBox<double>& a,
                                                        const OrientedBox<double>& b) {
  if (!is_finite_body(a) || !is_finite_body(b)) return {};
  BoxDecision decision{Proximity::overlapping, -1};
  for (int k = 0; k < box_axis_count; ++k) {
    const int sign = sign_of_separation(a, b, k);
    if (sign == 1) return {Proximity::disjoint, k};
    if (sign == 0 && decision.axis < 0) decision = {Proximity::touching, k};
  }
  return decision;
}

// [box-decision]
/// The exact decision of two boxes, in floating point if that is certain.
inline BoxDecision box_decision(const OrientedBox<double>& a, const OrientedBox<double>& b) {
  const BoxDecision rounded = rounded_box_decision(a, b);
  return rounded.state == Proximity::undecided ? exact_box_decision(a, b) : rounded;
}
// [/box-decision]

// [box-witness]
/// Whether axis k, as in box_axis(), certainly separates two boxes. It is recomputed, so it rotates
/// with them.
///
/// A face normal is a stored axis here: any direction that separates is a proof. With a sum s ≤ 16
/// of the magnitudes of all entries, no axis is longer than 16, no cross product longer than 64
/// (two factors of that sum), and the terms of the separation add up to at most 64 · 16 size. It
/// has at most 17 roundings; 2^15 u size is above their error, and still small enough for a
/// witness.
inline bool box_axis_separates(const OrientedBox<double>& a, const OrientedBox<double>& b, int k) {
  const Matrix3<double>& p = a.axes;
  const Matrix3<double>& q = b.axes;
  const auto entries = [](const Matrix3<double>& m, int i) {
    return std::abs(m(0, i)) + std::abs(m(1, i)) + std::abs(m(2, i));
  };
  const double sum = ((entries(p, 0) + entries(p, 1)) + (entries(p, 2) + entries(q, 0))) +
                     (entries(q, 1) + entries(q, 2));
  const double d[3] = {a.centre.x() - b.centre.x(), a.centre.y() - b.centre.y(),
                       a.centre.z() - b.centre.z()};
  const Vector3<double>& g = a.half_lengths;
  const Vector3<double>& h = b.half_lengths;
  const double size = ((std::abs(d[0]) + std::abs(d[1])) + (std::abs(d[2]) + g.x())) +
                      ((g.y() + g.z()) + (h.x() + h.y())) + h.z();
  if (!(sum <= 16) || !in_filter_range(size)) return false;
  double n[3];
  if (k < 6) {
    const Matrix3<double>& m = k < 3 ? p : q;
    const int i = k < 3 ? k : k - 3;
    for (int c = 0; c < 3; ++c) n[c] = m(c, i);
  } else {
    const int i = (k - 6) / 3, j = (k - 6) % 3;
    n[0] = p(1, i) * q(2, j) - p(2, i) * q(1, j);
    n[1] = p(2, i) * q(0, j) - p(0, i) * q(2, j);
    n[2] = p(0, i) * q(1, j) - p(1, i) * q(0, j);
  }
  const auto along = [&n](const Matrix3<double>& m, int i) {
    return std::abs(n[0] * m(0, i) + n[1] * m(1, i) + n[2] * m(2, i));
  };
  const double extents = (g.x() * along(p, 0) + g.y() * along(p, 1) + g.z() * along(p, 2)) +
                         (h.x() * along(q, 0) + h.y() * along(q, 1) + h.z() * along(q, 2));
  return std::abs(n[0] * d[0] + n[1] * d[1] + n[2] * d[2]) - extents >
         0x1p15 * tolerance::unit_roundoff<double> * size;
}
// [/box-witness]

}  // namespace detail

}  // namespace contact
