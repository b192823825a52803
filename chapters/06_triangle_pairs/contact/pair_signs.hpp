/// @file
/// Signs of volumes and areas of the six vertices of two triangles, without error: in integers, by
/// a filter for each sign, or by exact arithmetic alone.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <contact/difference_determinant.hpp>
#include <contact/drop_dimension.hpp>
#include <contact/orientation.hpp>
#include <contact/vector.hpp>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace contact {

namespace pair_decision_detail {

/// The vertices of the first triangle, then those of the second.
using Vertices = std::array<Vector3<double>, 6>;
/// The number of a vertex, 0 to 5.
using Vertex = std::size_t;

}  // namespace pair_decision_detail

namespace pair_signs_detail {

using pair_decision_detail::Vertex;
using pair_decision_detail::Vertices;
template <std::size_t n>
using Digits = difference_detail::Digits<n>;

/// The plane of three vertices, to which points are compared one by one.
struct PlaneOf {
  Vertex a, b, c;
};

/// Signs by exact arithmetic alone.
struct Exactly {
  const Vertices& at;
  PlaneOf plane(Vertex a, Vertex b, Vertex c) const { return {a, b, c}; }
  int side(const PlaneOf& p, Vertex v) const {
    return orient_3d_exactly(at[p.a], at[p.b], at[p.c], at[v]);
  }
  /// In the projection without coordinate k.
  int area(int k, Vertex a, Vertex b, Vertex c) const {
    const auto flat = [this, k](Vertex v) { return drop_dimension<double>(at[v], k); };
    return orient_2d_exactly(flat(a), flat(b), flat(c));
  }
};

/// Signs by a filter for each, and exact arithmetic where it is not certain.
struct Filtered {
  const Vertices& at;
  PlaneOf plane(Vertex a, Vertex b, Vertex c) const { return {a, b, c}; }
  int side(const PlaneOf& p, Vertex v) const { return orient_3d(at[p.a], at[p.b], at[p.c], at[v]); }
  int area(int k, Vertex a, Vertex b, Vertex c) const {
    const auto flat = [this, k](Vertex v) { return drop_dimension<double>(at[v], k); };
    return orient_2d(flat(a), flat(b), flat(c));
  }
};

/// Signs of vertices whose coordinates are whole multiples of a unit, with differences below 2^36
/// of it: floats of similar size, points of a grid.
///
/// Each determinant is computed twice: rounded in double, and modulo 2^64 in integers. The two
/// together have its sign (see `sign_from_residue`).
class Whole {
 public:
  /// The vertices in whole numbers, if they are.
  static std::optional<Whole> of(const Vertices& vertices) {
    Vector3<double> low = vertices[0], high = low;
    for (const Vector3<double>& v : vertices) {
      low = low.cwiseMin(v);
      high = high.cwiseMax(v);
    }
    const Vector3<double> extents = high - low;
    const double longest = extents.maxCoeff();
    const double largest = std::max(high.cwiseAbs().maxCoeff(), low.cwiseAbs().maxCoeff());
    // The longest side is less than 2^36 units, and the largest coordinate less than 2^62.
    difference_detail::Multiples multiples(longest, largest, 36);
    if (!multiples.scalable()) return std::nullopt;
    Whole made;
    for (std::size_t i = 0; i < 6; ++i) {
      for (int k = 0; k < 3; ++k) {
        made.at_[i][static_cast<std::size_t>(k)] = multiples(vertices[i][k]);
      }
      if (!multiples.all_whole()) return std::nullopt;
    }
    return made;
  }

  /// A point of a plane, and a normal (b − a) × (c − a) of it, rounded and modulo 2^64.
  struct Plane {
    Vertex a;
    std::array<double, 3> rounded;
    std::array<std::uint64_t, 3> residue;
  };
  Plane plane(Vertex a, Vertex b, Vertex c) const {
    Plane made{a, {}, {}};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      const Minor minor = minor_of(a, b, c, j, k);
      made.rounded[i] = minor.rounded;
      made.residue[i] = minor.residue;
    }
    return made;
  }
  int side(const Plane& p, Vertex v) const {
    double rounded = 0;
    std::uint64_t residue = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::int64_t away = at_[v][i] - at_[p.a][i];
      rounded += static_cast<double>(away) * p.rounded[i];
      residue += static_cast<std::uint64_t>(away) * p.residue[i];
    }
    return difference_detail::sign_from_residue(rounded, residue);
  }
  int area(int dropped, Vertex a, Vertex b, Vertex c) const {
    const auto k = static_cast<std::size_t>(dropped);
    const Minor minor = minor_of(a, b, c, (k + 1) % 3, (k + 2) % 3);
    return difference_detail::sign_from_residue(minor.rounded, minor.residue);
  }

 private:
  std::array<std::array<std::int64_t, 3>, 6> at_;

  struct Minor {
    double rounded;
    std::uint64_t residue;
  };
  Minor minor_of(Vertex a, Vertex b, Vertex c, std::size_t j, std::size_t k) const {
    const std::int64_t bj = at_[b][j] - at_[a][j], bk = at_[b][k] - at_[a][k];
    const std::int64_t cj = at_[c][j] - at_[a][j], ck = at_[c][k] - at_[a][k];
    const auto real = [](std::int64_t x) { return static_cast<double>(x); };
    const auto modulo = [](std::int64_t x) { return static_cast<std::uint64_t>(x); };
    return {real(bj) * real(ck) - real(bk) * real(cj),
            modulo(bj) * modulo(ck) - modulo(bk) * modulo(cj)};
  }
};

/// Signs of vertices whose coordinates span at most 84 bits, by a filter with one bound, and where
/// it is not certain by integers of three digits. Each vertex is converted once, and the normal of
/// a plane is computed once for all vertices.
class Wide {
 public:
  /// The vertices in digits, if they can be converted.
  /// @param bound of the error of every volume, as in `meet_filtered`; may be infinite
  static std::optional<Wide> of(const Vertices& vertices, double bound) {
    double largest = 0;
    for (const Vector3<double>& v : vertices) largest = std::max(largest, v.cwiseAbs().maxCoeff());
    if (!(largest < 0x1p900 && largest > 0x1p-900)) return std::nullopt;
    Wide made(vertices, bound);
    const difference_detail::Scaling<3> scaling(difference_detail::stored_exponent(largest));
    bool whole = true;
    for (std::size_t i = 0; i < 6; ++i) {
      for (int k = 0; k < 3; ++k) {
        made.digits_[i][static_cast<std::size_t>(k)] = scaling.digits(vertices[i][k], 0, whole);
      }
      if (!whole) return std::nullopt;
    }
    return made;
  }

  /// A plane with its normal, rounded, and in digits as soon as a sign needs it.
  struct Plane {
    PlaneOf vertices;
    Vector3<double> rounded;
    mutable std::optional<std::array<Digits<6>, 3>> exact;
  };
  Plane plane(Vertex a, Vertex b, Vertex c) const {
    const Vector3<double> ab = (*at_)[b] - (*at_)[a], ac = (*at_)[c] - (*at_)[a];
    return {{a, b, c}, ab.cross(ac), std::nullopt};
  }
  int side(const Plane& p, Vertex v) const {
    const Vector3<double> away = (*at_)[v] - (*at_)[p.vertices.a];
    const double volume = away.dot(p.rounded);
    if (std::abs(volume) > bound_) return volume > 0 ? 1 : -1;
    return side_in_digits(p, v);
  }
  int area(int k, Vertex a, Vertex b, Vertex c) const { return Filtered{*at_}.area(k, a, b, c); }

 private:
  const Vertices* at_;
  double bound_;
  std::array<std::array<Digits<3>, 3>, 6> digits_;

  Wide(const Vertices& vertices, double bound) : at_(&vertices), bound_(bound) {}

  /// Coordinate k of v − a. Its digits are below 2^29 in magnitude.
  Digits<3> difference(Vertex v, Vertex a, std::size_t k) const {
    const Digits<3>&x = digits_[v][k], &y = digits_[a][k];
    return {x[0] - y[0], x[1] - y[1], x[2] - y[2]};
  }
  /// Sums of at most six products of two such digits are below 2^61. After the carry the last
  /// digit of a component of the normal is at most 2^31, and all others are below 2^28.
  std::array<Digits<6>, 3> normal(const PlaneOf& p) const {
    std::array<Digits<6>, 3> n;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      n[i] = difference_detail::area<3>(difference(p.b, p.a, j), difference(p.b, p.a, k),
                                        difference(p.c, p.a, j), difference(p.c, p.a, k));
      difference_detail::carry_and_sign(n[i]);
    }
    return n;
  }
  /// A digit of the volume is below three times 2^60 + 2^58.
  [[gnu::noinline]] int side_in_digits(const Plane& p, Vertex v) const {
    if (!p.exact) p.exact = normal(p.vertices);
    Digits<9> volume{};
    for (std::size_t i = 0; i < 3; ++i) {
      difference_detail::add_product(volume, difference(v, p.vertices.a, i), (*p.exact)[i], 1);
    }
    return difference_detail::carry_and_sign(volume);
  }
};

}  // namespace pair_signs_detail

}  // namespace contact
