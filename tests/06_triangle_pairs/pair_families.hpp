/// @file
/// Pairs of triangles that are hard to decide, for tests, the ladder and the comparison with other
/// programs. Every coordinate is a whole number, so that pair_truth.hpp can decide each pair in
/// integers. Eigen only: the ladder uses them in the page.
///
///     generators::Random random(1);
///     for (const auto family : pair_families::all) {
///       const auto p = pair_families::pair<float>(random, family);     // or <double>
///       triangles_meet(p.first, p.second);
///     }
#pragma once

#include <support/generators.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <contact/shapes.hpp>
#include <contact/vector.hpp>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>

namespace pair_families {

using generators::Random;

/// How two triangles are drawn.
enum class Family {
  random,                ///< vertices anywhere in a cube
  near,                  ///< two triangles whose boxes touch; most do not meet
  vertex_on_vertex,      ///< a vertex in common
  vertex_on_edge,        ///< a vertex of one is inside an edge of the other
  vertex_on_face,        ///< a vertex of one is inside the other
  edge_on_edge,          ///< an edge of each goes through a point
  edge_in_plane,         ///< an edge of one is in the other's plane, anywhere
  shared_edge,           ///< two vertices in common, at times in one plane
  coplanar_overlapping,  ///< in one plane, with a point inside both
  coplanar_touching,     ///< in one plane, on two sides of a line, with a point of it in common
  coplanar_apart,        ///< in one plane, on two sides of a line, at least a step apart
  coplanar_inside,       ///< in one plane, one in the other or on its border
  needles,               ///< as thin as the whole numbers allow, past or through each other
  degenerate,            ///< one or both are segments or points
  one_step,              ///< touching, then one coordinate moved by 1
  far,                   ///< small ones of all these families, far from the origin
  sheared                ///< small ones by a whole matrix of determinant 1 with large entries
};
inline constexpr std::array<Family, 17> all{Family::random,
                                            Family::near,
                                            Family::vertex_on_vertex,
                                            Family::vertex_on_edge,
                                            Family::vertex_on_face,
                                            Family::edge_on_edge,
                                            Family::edge_in_plane,
                                            Family::shared_edge,
                                            Family::coplanar_overlapping,
                                            Family::coplanar_touching,
                                            Family::coplanar_apart,
                                            Family::coplanar_inside,
                                            Family::needles,
                                            Family::degenerate,
                                            Family::one_step,
                                            Family::far,
                                            Family::sheared};
/// The name of a family.
inline constexpr std::string_view name(Family family) {
  constexpr std::array<std::string_view, all.size()> names{"random",
                                                           "near",
                                                           "vertex on vertex",
                                                           "vertex on edge",
                                                           "vertex on face",
                                                           "edge on edge",
                                                           "edge in plane",
                                                           "shared edge",
                                                           "coplanar, overlapping",
                                                           "coplanar, touching",
                                                           "coplanar, apart",
                                                           "coplanar, inside",
                                                           "needles",
                                                           "segments and points",
                                                           "one step off touching",
                                                           "far from the origin",
                                                           "sheared"};
  return names[static_cast<std::size_t>(family)];
}

/// Two triangles.
template <std::floating_point S>
struct Pair {
  contact::Triangle<S> first, second;
};

namespace detail {

using Whole = std::int64_t;
using Point = Eigen::Matrix<Whole, 3, 1>;
using Place = std::array<Whole, 2>;  ///< whole coordinates in a plane
struct Three {
  std::array<Point, 3> at;
  Point& operator[](int i) { return at[static_cast<std::size_t>(i)]; }
  const Point& operator[](int i) const { return at[static_cast<std::size_t>(i)]; }
};
struct WholePair {
  Three first, second;
};

// Numbers, points, planes --------------------------------------------------------------------

/// From -size to size.
inline Whole whole(Random& random, Whole size) {
  return static_cast<Whole>(random.bits() % static_cast<std::uint64_t>(2 * size + 1)) - size;
}
inline Point point(Random& random, Whole size) {
  return Point{whole(random, size), whole(random, size), whole(random, size)};
}
inline Point step(Random& random, Whole size) {
  return point(random, std::max<Whole>(1, size / 16));
}
/// From 1 to 3: a whole multiple of a step on one side of a point.
inline Whole share(Random& random) { return random.integer(1, 3); }

/// A plane with whole points: origin + i u + j v.
struct Lattice {
  Point origin, u, v;
  Point operator()(Whole i, Whole j) const { return origin + i * u + j * v; }
  Point operator()(const Place& p) const { return (*this)(p[0], p[1]); }
  Three operator()(const std::array<Place, 3>& t) const {
    return {{(*this)(t[0]), (*this)(t[1]), (*this)(t[2])}};
  }
};
inline Lattice lattice(Random& random, Whole size) {
  for (;;) {
    Lattice made{point(random, size / 2), step(random, size), step(random, size)};
    if (random.chance(0.2)) made.u[random.integer(0, 2)] = 0;
    if (random.chance(0.2)) made.v[random.integer(0, 2)] = 0;
    const contact::Vector3<double> u = made.u.cast<double>(), v = made.v.cast<double>();
    if (u.cross(v) != contact::Vector3<double>::Zero()) return made;  // the integers may overflow
  }
}

/// A triangle of a lattice that has its origin inside.
inline std::array<Place, 3> around_origin(Random& random) {
  return {{{share(random), 0}, {0, share(random)}, {-share(random), -share(random)}}};
}
inline Place position(Random& random, int size) {
  return {random.integer(-size, size), random.integer(-size, size)};
}

// Families -----------------------------------------------------------------------------------

inline WholePair anywhere(Random& random, Whole size) {
  return {{{point(random, size), point(random, size), point(random, size)}},
          {{point(random, size), point(random, size), point(random, size)}}};
}

/// Triangles half as large, moved until their boxes touch.
inline WholePair near(Random& random, Whole size) {
  for (;;) {
    WholePair pair = anywhere(random, std::max<Whole>(1, size / 2));
    const Point away = point(random, size / 2);
    bool touch = true;
    for (int k = 0; k < 3; ++k) {
      for (int i = 0; i < 3; ++i) pair.second[i][k] += away[k];
      const auto [low, high] = std::minmax({pair.first[0][k], pair.first[1][k], pair.first[2][k]});
      const auto [low2, high2] =
          std::minmax({pair.second[0][k], pair.second[1][k], pair.second[2][k]});
      touch = touch && low <= high2 && low2 <= high;
    }
    if (touch) return pair;
  }
}

/// A triangle with x where a family wants it.
inline Three with_vertex(Random& random, const Point& x, Whole size) {
  return {{x, point(random, size), point(random, size)}};
}
inline Three with_point_on_edge(Random& random, const Point& x, Whole size) {
  const Point along = step(random, size);
  return {{x - share(random) * along, x + share(random) * along, point(random, size)}};
}
inline Three with_point_inside(Random& random, const Lattice& plane) {
  return plane(around_origin(random));
}

inline WholePair with_edge_in_plane(Random& random, Whole size) {
  const Lattice plane = lattice(random, size);
  return {with_point_inside(random, plane),
          {{plane(position(random, 4)), plane(position(random, 4)), point(random, size)}}};
}
inline WholePair with_shared_edge(Random& random, Whole size) {
  const Lattice plane = lattice(random, size);
  const Three first = with_point_inside(random, plane);
  const Point other = random.chance(0.3) ? plane(position(random, 4)) : point(random, size);
  return {first, {{first[1], first[0], other}}};
}

// In one plane -------------------------------------------------------------------------------

/// The triangle reflected at the first axis of its lattice where it is below it (or above it), and
/// moved by `away` from the axis.
inline Place on_side(const Place& p, int side, Whole away) {
  return {p[0], side * (std::abs(p[1]) + away)};
}
/// Two triangles at both sides of the line j = 0, with the lattice sheared so that the line is
/// oblique. @param away 0: they touch at the origin
inline WholePair at_a_line(Random& random, const Lattice& plane, Whole away) {
  const Whole slope = random.integer(-1, 1);
  const auto oblique = [slope](const Place& p) { return Place{p[0] + slope * p[1], p[1]}; };
  const auto on = [&](int side, Whole off) {
    return oblique(on_side(position(random, 3), side, off));
  };
  const bool edge = random.chance(0.7);  // the first has an edge on the line, else a vertex
  const Place left{edge ? -Whole{random.integer(0, 3)} : 0, 0};
  const Place right{edge ? Whole{random.integer(0, 3)} : 0, 0};
  const Place start = random.chance(0.3) ? left : Place{0, 0};
  const Place touching = away == 0 ? start : on(-1, away);
  return {plane({left, edge ? right : on(1, 0), on(1, 0)}),
          plane({touching, on(-1, away), on(-1, away)})};
}

inline WholePair overlapping(Random& random, Whole size) {
  const Lattice plane = lattice(random, size);
  const Three first = with_point_inside(random, plane);
  std::array<Place, 3> second = around_origin(random);
  for (Place& p : second) p = {p[1], -p[0]};  // by a right angle
  return {first, plane(second)};
}

inline WholePair inside(Random& random, Whole size) {
  const Lattice plane = lattice(random, size / 2);
  const std::array<Place, 3> large{position(random, 1), position(random, 1), position(random, 1)};
  constexpr int parts = 6;
  const auto within = [&] {
    const Whole i = random.integer(0, parts);
    const Whole j = random.integer(0, parts - static_cast<int>(i));
    Place p{0, 0};
    for (std::size_t k = 0; k < 2; ++k) {
      p[k] = i * large[0][k] + j * large[1][k] + (parts - i - j) * large[2][k];
    }
    return p;
  };
  const std::array<Place, 3> small{within(), within(), within()};
  std::array<Place, 3> scaled = large;
  for (Place& p : scaled) p = {parts * p[0], parts * p[1]};
  return {plane(scaled), plane(small)};
}

// Thin, degenerate, one step off -------------------------------------------------------------

/// A triangle that is a segment but for some units, and passes x at most some units away. Every
/// second one has x as a vertex.
inline Three needle(Random& random, const Point& x, Whole size) {
  const Point along = step(random, 8 * size);
  const auto on = [&](Whole eighths) {
    Point p = x;
    for (int k = 0; k < 3; ++k) p[k] += along[k] / 8 * eighths + random.integer(-2, 2);
    return p;
  };
  const Whole back = random.integer(0, 8);
  const Point start = on(-back), end = on(8 - back);
  return {{start, end, random.chance(0.5) ? x : on(random.integer(-2, 10) - back)}};
}

/// Two touching triangles of one of the families from vertex_on_vertex to coplanar_inside.
inline WholePair touching(Random& random, Whole size);

/// All of one are points of a segment, or one point.
inline void flatten(Random& random, Three& t) {
  const int kind = random.integer(0, 3);
  if (kind == 0) t.at = {t[0], t[0], t[0]};
  if (kind == 1) t[2] = t[1];
  if (kind == 2) t[2] = t[0];
  if (kind == 3) t[2] = t[0] + random.integer(-1, 2) * (t[1] - t[0]);
}
inline WholePair flattened(Random& random, Whole size) {
  WholePair pair = touching(random, size / 2);
  const int which = random.integer(0, 2);
  if (which != 0) flatten(random, pair.first);
  if (which != 1) flatten(random, pair.second);
  return pair;
}

inline WholePair one_step_off(Random& random, Whole size) {
  WholePair pair = touching(random, size);
  Three& moved = random.chance(0.5) ? pair.first : pair.second;
  moved[random.integer(0, 2)][random.integer(0, 2)] += random.chance(0.5) ? 1 : -1;
  return pair;
}

// Moved as a whole ---------------------------------------------------------------------------

inline WholePair moved(const WholePair& pair, const Point& by) {
  WholePair made = pair;
  for (int i = 0; i < 3; ++i) {
    made.first[i] += by;
    made.second[i] += by;
  }
  return made;
}

/// Adds multiples of one coordinate to another while all entries of the matrix stay below
/// `largest`. Its inverse has whole entries too, so nothing else becomes of the pair: points that
/// are in one plane, on one line or on one side remain so, and all volumes are as they were.
inline Eigen::Matrix<Whole, 3, 3> shear(Random& random, Whole largest) {
  Eigen::Matrix<Whole, 3, 3> matrix = Eigen::Matrix<Whole, 3, 3>::Identity();
  for (;;) {
    const int row = random.integer(0, 2), other = (row + random.integer(1, 2)) % 3;
    const Whole times = random.integer(-16, 16);
    const Eigen::Matrix<Whole, 1, 3> sum = matrix.row(row) + times * matrix.row(other);
    if (sum.cwiseAbs().maxCoeff() > largest) return matrix;
    matrix.row(row) = sum;
  }
}
inline WholePair sheared(Random& random, const WholePair& pair, Whole largest) {
  const Eigen::Matrix<Whole, 3, 3> matrix = shear(random, largest);
  WholePair made = pair;
  for (int i = 0; i < 3; ++i) {
    made.first[i] = matrix * pair.first[i];
    made.second[i] = matrix * pair.second[i];
  }
  return made;
}

/// The families that stay where they are.
inline WholePair at_home(Random& random, Family family, Whole size) {
  const auto x = [&] { return point(random, size / 2); };
  switch (family) {
    case Family::near:
      return near(random, size);
    case Family::vertex_on_vertex: {
      const Point common = x();
      return {with_vertex(random, common, size), with_vertex(random, common, size)};
    }
    case Family::vertex_on_edge: {
      const Point common = x();
      return {with_vertex(random, common, size), with_point_on_edge(random, common, size)};
    }
    case Family::vertex_on_face: {
      const Lattice plane = lattice(random, size);
      return {with_vertex(random, plane.origin, size), with_point_inside(random, plane)};
    }
    case Family::edge_on_edge: {
      const Point common = x();
      return {with_point_on_edge(random, common, size), with_point_on_edge(random, common, size)};
    }
    case Family::edge_in_plane:
      return with_edge_in_plane(random, size);
    case Family::shared_edge:
      return with_shared_edge(random, size);
    case Family::coplanar_overlapping:
      return overlapping(random, size);
    case Family::coplanar_touching:
      return at_a_line(random, lattice(random, size), 0);
    case Family::coplanar_apart:
      return at_a_line(random, lattice(random, size), 1);
    case Family::coplanar_inside:
      return inside(random, size);
    case Family::needles: {
      const Point common = x();
      return {needle(random, common, size), needle(random, common, size)};
    }
    case Family::degenerate:
      return flattened(random, size);
    case Family::one_step:
      return one_step_off(random, size);
    default:
      return anywhere(random, size);
  }
}

inline WholePair touching(Random& random, Whole size) {
  constexpr int first = static_cast<int>(Family::vertex_on_vertex);
  constexpr int last = static_cast<int>(Family::coplanar_inside);
  return at_home(random, static_cast<Family>(random.integer(first, last)), size);
}
/// One of any family but far and sheared.
inline WholePair any_at_home(Random& random, Whole size) {
  constexpr int last = static_cast<int>(Family::one_step);
  return at_home(random, static_cast<Family>(random.integer(0, last)), size);
}

/// How large whole numbers of S are drawn, and how far from the origin.
template <std::floating_point S>
constexpr int size_bits = sizeof(S) == sizeof(float) ? 22 : 36;
template <std::floating_point S>
constexpr int far_bits = sizeof(S) == sizeof(float) ? 23 : 52;

template <std::floating_point S>
WholePair whole_pair(Random& random, Family family) {
  constexpr Whole one = 1;
  if (family == Family::far) {
    constexpr Whole away = one << far_bits<S>;
    Point by{away, away, away};
    for (Whole& x : by) {
      x += std::abs(whole(random, away / 2));
      if (random.chance(0.5)) x = -x;
    }
    return moved(any_at_home(random, one << random.integer(3, 8)), by);
  }
  if (family == Family::sheared) {
    return sheared(random, any_at_home(random, 8), one << (size_bits<S> - 5));
  }
  const int bits = random.chance(0.5) ? size_bits<S> : random.integer(3, size_bits<S>);
  return at_home(random, family, one << bits);
}

template <std::floating_point S>
contact::Vector3<S> as_stored(const Point& p) {
  return {static_cast<S>(p.x()), static_cast<S>(p.y()), static_cast<S>(p.z())};
}
/// In one of the six orders of its vertices.
template <std::floating_point S>
contact::Triangle<S> as_stored(Random& random, Three t) {
  if (random.chance(0.5)) std::swap(t[0], t[1]);
  const int i = random.integer(0, 2);
  return {as_stored<S>(t[i]), as_stored<S>(t[(i + 1) % 3]), as_stored<S>(t[(i + 2) % 3])};
}

}  // namespace detail

/// Two triangles of a family, in any order, each in any order of its vertices. In every family a
/// few have no area: small whole numbers are often on a line.
///
/// All coordinates are whole numbers that S holds: of a pair of float below 2^23 in magnitude, of
/// a pair of double below 2^37, and those of the far family below 2^24 and 2^53, where numbers of S
/// are 1 apart. Any two of them are less than 2^38 apart along each axis.
template <std::floating_point S>
Pair<S> pair(Random& random, Family family) {
  const detail::WholePair drawn = detail::whole_pair<S>(random, family);
  const Pair<S> made{detail::as_stored<S>(random, drawn.first),
                     detail::as_stored<S>(random, drawn.second)};
  return random.chance(0.5) ? made : Pair<S>{made.second, made.first};
}

/// The same pair in another type.
template <std::floating_point To, std::floating_point From>
Pair<To> in(const Pair<From>& pair) {
  return {generators::rounded<To>(pair.first), generators::rounded<To>(pair.second)};
}

/// Times a power of two, which nothing rounds within the range of S.
template <std::floating_point S>
Pair<S> scaled(const Pair<S>& pair, int exponent) {
  Pair<S> made = pair;
  for (auto* t : {&made.first, &made.second}) {
    for (auto* v : {&t->a, &t->b, &t->c}) {
      for (S& x : *v) x = std::ldexp(x, exponent);
    }
  }
  return made;
}

/// A pair of a family by a random matrix and offset, rounded, so that no coordinate is whole and
/// few differences are exact; in a third of them one coordinate is then moved by an ulp. What the
/// family promises holds to a rounding: only exact arithmetic on the stored numbers decides.
template <std::floating_point S>
Pair<S> rounded_pair(Random& random, Family family) {
  const Pair<double> drawn = in<double>(pair<S>(random, family));
  Eigen::Matrix3d matrix;
  for (double& x : matrix.reshaped()) x = random.uniform(-1, 1);
  const contact::Vector3<double> offset{random.uniform(-1, 1), random.uniform(-1, 1),
                                        random.uniform(-1, 1)};
  Pair<S> made;
  const auto map = [&](const contact::Vector3<double>& v) {
    return generators::rounded<S>(contact::Vector3<double>(matrix * v + offset));
  };
  made.first = {map(drawn.first.a), map(drawn.first.b), map(drawn.first.c)};
  made.second = {map(drawn.second.a), map(drawn.second.b), map(drawn.second.c)};
  if (random.chance(0.3)) {
    S& x = made.second.b[random.integer(0, 2)];
    x = std::nextafter(x, random.chance(0.5) ? S(1e9) : S(-1e9));
  }
  return made;
}

}  // namespace pair_families
