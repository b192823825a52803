/// @file
/// Code to break: whether two boxes have a point in common, by the separating axis test. A pair of
/// boxes is any struct with the members of exercise::Pair.
#pragma once

#include <array>
#include <cmath>

#include <contact/prelude.hpp>

namespace given {

using Vector = Eigen::Vector3d;

/// The terms are added from left to right.
inline double dot(const Vector& u, const Vector& v) {
  return u.x() * v.x() + u.y() * v.y() + u.z() * v.z();
}

/// Half of each edge of a box.
using Edges = std::array<Vector, 3>;

template <class Pair>
Edges edges_of_a(const Pair& pair) {
  return {pair.u_a, pair.v_a, pair.w_a};
}

template <class Pair>
Edges edges_of_b(const Pair& pair) {
  return {pair.u_b, pair.v_b, pair.w_b};
}

/// How far a box reaches along n from its centre, times the length of n.
inline double projected_radius(const Edges& edges, const Vector& n) {
  return std::abs(dot(n, edges[0])) + std::abs(dot(n, edges[1])) + std::abs(dot(n, edges[2]));
}

/// Whether the projections of two boxes on n are apart. `between` goes from one centre to the
/// other.
inline bool separates(const Vector& n, const Vector& between, const Edges& a, const Edges& b) {
  return std::abs(dot(n, between)) > projected_radius(a, n) + projected_radius(b, n);
}

/// A cross product is skipped if its squared length is less than this: the edges are parallel, and
/// the rest is rounding.
inline constexpr double shortest = 1e-6;

/// Whether two boxes meet, as engines decide it that skip short cross products. Touching should
/// count.
template <class Pair>
bool meet_skipping(const Pair& pair) {
  const Edges a = edges_of_a(pair), b = edges_of_b(pair);
  const Vector between = pair.centre_b - pair.centre_a;
  for (std::size_t i = 0; i < 3; ++i)
    if (separates(a[i], between, a, b) || separates(b[i], between, a, b)) return false;
  for (const Vector& of_a : a) {
    for (const Vector& of_b : b) {
      const Vector n = of_a.cross(of_b);
      if (n.squaredNorm() < shortest) continue;
      if (separates(n, between, a, b)) return false;
    }
  }
  return true;
}

/// What is added to each cosine, so that parallel edges do not separate by rounding.
inline constexpr double padding = 1e-6;

/// Two boxes as Gottschalk has them: the half lengths of each, the cosines of the angles between
/// their axes, and the vector between the centres along the axes of each.
struct Cosines {
  Vector half_a, half_b;
  Eigen::Matrix3d cosine;  ///< of axis i of a and axis j of b
  Eigen::Matrix3d padded;  ///< its magnitude and the padding
  Vector along_a, along_b;
};

template <class Pair>
Cosines cosines(const Pair& pair) {
  const Edges a = edges_of_a(pair), b = edges_of_b(pair);
  const Vector between = pair.centre_b - pair.centre_a;
  Cosines c;
  for (int i = 0; i < 3; ++i) {
    const Vector &u = a[static_cast<std::size_t>(i)], &v = b[static_cast<std::size_t>(i)];
    c.half_a[i] = std::sqrt(dot(u, u));
    c.half_b[i] = std::sqrt(dot(v, v));
    c.along_a[i] = dot(u, between) / c.half_a[i];
    c.along_b[i] = dot(v, between) / c.half_b[i];
  }
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      c.cosine(i, j) = dot(a[static_cast<std::size_t>(i)], b[static_cast<std::size_t>(j)]) /
                       (c.half_a[i] * c.half_b[j]);
      c.padded(i, j) = std::abs(c.cosine(i, j)) + padding;
    }
  }
  return c;
}

/// Whether the boxes are apart along the normal of face i of a, or of face i of b.
inline bool face_separates(const Cosines& c, int i) {
  return std::abs(c.along_a[i]) > c.half_a[i] + dot(c.half_b, c.padded.row(i)) ||
         std::abs(c.along_b[i]) > c.half_b[i] + dot(c.half_a, c.padded.col(i));
}

/// Whether the boxes are apart along the cross product of axis i of a and axis j of b. Both sides
/// are times the sine of the angle between them.
inline bool edges_separate(const Cosines& c, int i, int j) {
  const int k = (i + 1) % 3, l = (i + 2) % 3, p = (j + 1) % 3, q = (j + 2) % 3;
  const double distance = std::abs(c.along_a[l] * c.cosine(k, j) - c.along_a[k] * c.cosine(l, j));
  const double of_a = c.half_a[k] * c.padded(l, j) + c.half_a[l] * c.padded(k, j);
  const double of_b = c.half_b[p] * c.padded(i, q) + c.half_b[q] * c.padded(i, p);
  return distance > of_a + of_b;
}

/// Whether two boxes meet, as engines decide it that add an epsilon to the projected radii.
template <class Pair>
bool meet_padded(const Pair& pair) {
  const Cosines c = cosines(pair);
  for (int i = 0; i < 3; ++i)
    if (face_separates(c, i)) return false;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j)
      if (edges_separate(c, i, j)) return false;
  }
  return true;
}

}  // namespace given
