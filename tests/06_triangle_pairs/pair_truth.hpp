/// @file
/// Whether two triangles have a point in common, without rounding: what methods are compared with.
///
/// Not by the methods of the chapter: two triangles meet if and only if an edge of one meets the
/// other, and that is decided by signed volumes, in a plane by the orientations of a projection,
/// and on a line by order. Triangles without area are the segments and points that they are.
/// Touching counts.
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <contact/exact.hpp>
#include <contact/shapes.hpp>
#include <contact/vector.hpp>
#include <cstddef>
#include <cstdint>

namespace pair_truth {

__extension__ typedef __int128 Wide;

namespace detail {

/// A point with coordinates as they are stored (Of) whose differences are multiplied in Product.
template <class Of>
using Point = std::array<Of, 3>;
template <class Of>
struct Segment {
  Point<Of> from, to;
};
template <class Of>
struct Three {
  std::array<Point<Of>, 3> at;
  Segment<Of> edge(std::size_t i) const { return {at[i], at[(i + 1) % 3]}; }
};

/// The differences of coordinates below 2^62 are below 2^63; of differences below 2^41, six
/// products of three are below 2^126.
struct InIntegers {
  using Of = std::int64_t;
  using Product = Wide;
  static Product difference(Of x, Of y) { return Product{x} - Product{y}; }
  static int sign(Product x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }
};
struct InExact {
  using Of = contact::Exact;
  using Product = contact::Exact;
  static Product difference(const Of& x, const Of& y) { return x - y; }
  static int sign(const Product& x) { return x.sign(); }
};

template <class N>
struct Decides {
  using Of = typename N::Of;
  using Product = typename N::Product;
  using P = Point<Of>;
  using Vector = std::array<Product, 3>;

  static Vector from(const P& a, const P& b) {
    return {N::difference(b[0], a[0]), N::difference(b[1], a[1]), N::difference(b[2], a[2])};
  }
  static Vector cross(const Vector& u, const Vector& v) {
    return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  }
  /// Of n · (p − a).
  static int sign_along(const Vector& n, const P& a, const P& p) {
    const Vector v = from(a, p);
    return N::sign(n[0] * v[0] + n[1] * v[1] + n[2] * v[2]);
  }
  /// A coordinate in which n is not zero, or 3.
  static std::size_t nonzero(const Vector& n) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (N::sign(n[k]) != 0) return k;
    }
    return 3;
  }
  /// The orientation of a, b and c without coordinate k.
  static int flat(const P& a, const P& b, const P& c, std::size_t k) {
    const std::size_t x = (k + 1) % 3, y = (k + 2) % 3;
    return N::sign(N::difference(b[x], a[x]) * N::difference(c[y], a[y]) -
                   N::difference(b[y], a[y]) * N::difference(c[x], a[x]));
  }
  /// Of a point on the line of a segment.
  static bool within(const P& p, const Segment<Of>& s) {
    for (std::size_t k = 0; k < 3; ++k) {
      if ((p[k] < s.from[k] && p[k] < s.to[k]) || (s.from[k] < p[k] && s.to[k] < p[k])) {
        return false;
      }
    }
    return true;
  }

  /// Of segments in a plane that is not vertical when coordinate k is dropped.
  static bool meet_in_plane(const Segment<Of>& s, const Segment<Of>& t, std::size_t k) {
    const int a = flat(s.from, s.to, t.from, k), b = flat(s.from, s.to, t.to, k);
    const int c = flat(t.from, t.to, s.from, k), d = flat(t.from, t.to, s.to, k);
    if (a * b < 0 && c * d < 0) return true;
    return (a == 0 && within(t.from, s)) || (b == 0 && within(t.to, s)) ||
           (c == 0 && within(s.from, t)) || (d == 0 && within(s.to, t));
  }
  /// Of segments anywhere in space, which may be points.
  static bool meet(const Segment<Of>& s, const Segment<Of>& t) {
    const Vector n = cross(from(s.from, s.to), from(s.from, t.from));
    const Vector m = cross(from(s.from, s.to), from(s.from, t.to));
    const Vector l = cross(from(t.from, t.to), from(t.from, s.from));
    if (sign_along(n, s.from, t.to) != 0) return false;
    for (const Vector& normal : {n, m, l}) {
      if (nonzero(normal) < 3) return meet_in_plane(s, t, nonzero(normal));
    }
    // All on one line.
    return within(s.from, t) || within(s.to, t) || within(t.from, s) || within(t.to, s);
  }

  /// Of a point in the plane of a triangle that has area in the projection.
  static bool in_plane_inside(const P& p, const Three<Of>& t, std::size_t k) {
    bool left = false, right = false;
    for (std::size_t i = 0; i < 3; ++i) {
      const int side = flat(t.at[i], t.at[(i + 1) % 3], p, k);
      left = left || side > 0;
      right = right || side < 0;
    }
    return !(left && right);
  }

  static bool meet(const Segment<Of>& s, const Three<Of>& t, const Vector& normal) {
    const std::size_t k = nonzero(normal);
    if (k == 3) return meet(s, t.edge(0)) || meet(s, t.edge(1)) || meet(s, t.edge(2));
    const int a = sign_along(normal, t.at[0], s.from), b = sign_along(normal, t.at[0], s.to);
    if (a * b > 0) return false;
    if (a == 0 && b == 0) {
      if (in_plane_inside(s.from, t, k)) return true;
      for (std::size_t i = 0; i < 3; ++i) {
        if (meet_in_plane(s, t.edge(i), k)) return true;
      }
      return false;
    }
    if (a == 0) return in_plane_inside(s.from, t, k);
    if (b == 0) return in_plane_inside(s.to, t, k);
    const Vector along = from(s.from, s.to);
    bool left = false, right = false;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector n = cross(along, from(s.from, t.at[i]));
      const int side = sign_along(n, s.from, t.at[(i + 1) % 3]);
      left = left || side > 0;
      right = right || side < 0;
    }
    return !(left && right);
  }

  static Vector normal(const Three<Of>& t) {
    return cross(from(t.at[0], t.at[1]), from(t.at[0], t.at[2]));
  }
  static bool meet(const Three<Of>& s, const Three<Of>& t) {
    const Vector n = normal(s), m = normal(t);
    for (std::size_t i = 0; i < 3; ++i) {
      if (meet(s.edge(i), t, m) || meet(t.edge(i), s, n)) return true;
    }
    return false;
  }
};

template <class Of, std::floating_point S>
Three<Of> three(const contact::Triangle<S>& t) {
  const auto convert = [](const contact::Vector3<S>& v) {
    if constexpr (std::same_as<Of, contact::Exact>) {
      return Point<Of>{Of(double{v.x()}), Of(double{v.y()}), Of(double{v.z()})};
    } else {
      return Point<Of>{static_cast<Of>(v.x()), static_cast<Of>(v.y()), static_cast<Of>(v.z())};
    }
  };
  return {{convert(t.a), convert(t.b), convert(t.c)}};
}

}  // namespace detail

/// Of triangles with whole coordinates of magnitude below 2^62 of which any two along an axis are
/// less than 2^41 apart (as all of pair_families::pair are).
template <std::floating_point S>
bool meet_in_integers(const contact::Triangle<S>& first, const contact::Triangle<S>& second) {
  using detail::three;
  return detail::Decides<detail::InIntegers>::meet(three<std::int64_t>(first),
                                                   three<std::int64_t>(second));
}

/// Of triangles with any finite coordinates: slow.
template <std::floating_point S>
bool meet_exactly(const contact::Triangle<S>& first, const contact::Triangle<S>& second) {
  using detail::three;
  return detail::Decides<detail::InExact>::meet(three<contact::Exact>(first),
                                                three<contact::Exact>(second));
}

}  // namespace pair_truth
