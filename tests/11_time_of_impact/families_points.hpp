/// @file
/// Families of points that move linearly: a vertex and a face, or two edges.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>

#include "families.hpp"

namespace families {

/// Four points that move linearly from one position to another. Point 0 is a vertex and points 1,
/// 2 and 3 a face; or the edges are from point 0 to 1 and from 2 to 3. Each displacement is the
/// difference of end and start without rounding.
struct MovingPoints {
  std::array<V, 4> start, end;  ///< m
  V displacement(std::size_t k) const { return end[k] - start[k]; }
};

/// The families of moving points.
enum class Points {
  random,           ///< any positions; about half of them aimed
  grid,             ///< integers: exact coincidences everywhere
  nearly_coplanar,  ///< in one plane but for a few last bits, throughout
  coplanar,         ///< exactly in one plane throughout
  parallel,         ///< edges parallel but for a few units of the last bit, or exactly; faces thin
  touch_and_leave,  ///< they touch for an instant and go back: a double root
  at_the_start,     ///< they meet exactly at the start
  at_the_end,       ///< they meet exactly at the end
  at_rest,          ///< no relative motion
  no_area,          ///< two points of an edge or a face coincide, or three are on a line
  on_the_rim,       ///< aimed at an edge or a vertex of the face, at an end of the other edge
  missed_rim,       ///< the same, passed a last bit outside
  fast,             ///< hundreds of sizes in the step
  far,              ///< close to each other and far from the origin
  small             ///< of the size of 2^-20 m
};

inline constexpr std::array<Points, 15> all_points{
    Points::random,       Points::grid,       Points::nearly_coplanar,
    Points::coplanar,     Points::parallel,   Points::touch_and_leave,
    Points::at_the_start, Points::at_the_end, Points::at_rest,
    Points::no_area,      Points::on_the_rim, Points::missed_rim,
    Points::fast,         Points::far,        Points::small};

inline constexpr std::string_view name(Points family) {
  constexpr std::array<std::string_view, 15> names{"random",       "integers",   "nearly coplanar",
                                                   "coplanar",     "parallel",   "touch and leave",
                                                   "at the start", "at the end", "at rest",
                                                   "no area",      "on the rim", "past the rim",
                                                   "fast",         "far away",   "small"};
  return names[static_cast<std::size_t>(family)];
}

namespace detail {

/// Points are at multiples of 2^-26 m, and what is aimed at multiples of 2^-31 m: with weights in
/// quarters and times in eighths the aim is exact, and so are all differences up to 2^22 m.
inline constexpr int grid_bits = 26;
inline constexpr int aim_bits = 31;
inline double last_bit(Random& random, int most) {
  return std::ldexp(random.integer(-most, most), -grid_bits);
}

/// Moves a vertex, or the first edge, so that it has a point in common with the rest at a time.
/// @param weights barycentric coordinates of the common point: of the vertex and in the face, or on
/// each edge
inline void aim(MovingPoints& p, bool edges, const std::array<double, 4>& weights, double time) {
  const auto at = [&](std::size_t k) { return V(p.start[k] + (p.end[k] - p.start[k]) * time); };
  V error = V::Zero();
  for (std::size_t k = 0; k < 4; ++k) {
    const bool first = edges ? k < 2 : k < 1;
    error += at(k) * (first ? -weights[k] : weights[k]);
  }
  error = on_grid(error, aim_bits);
  for (std::size_t k = 0; k < (edges ? 2U : 1U); ++k) {
    p.start[k] += error;
    p.end[k] += error;
  }
}

}  // namespace detail

/// Moving points of a family.
/// @param edges whether they are for two edges, or for a vertex and a face
inline MovingPoints points(Random& random, Points family, bool edges) {
  MovingPoints p;
  for (std::size_t k = 0; k < 4; ++k) {
    p.start[k] = in_box(random, 1);
    p.end[k] = p.start[k] + in_box(random, 1);
  }
  // Barycentric coordinates of the common point: halves and quarters, so that the aim is exact.
  std::array<double, 4> weights{1, 0.25, 0.25, 0.5};
  if (edges) weights = {0.75, 0.25, 0.5, 0.5};
  double time = random.integer(0, 8) / 8.0;
  bool aimed = random.chance(0.5);
  double scale = 1;
  V shift = V::Zero();
  switch (family) {
    case Points::grid:
      for (std::size_t k = 0; k < 4; ++k) {
        p.start[k] = whole_in_box(random, 2);
        p.end[k] = whole_in_box(random, 2);
      }
      aimed = false;
      break;
    case Points::nearly_coplanar:
    case Points::coplanar:
      for (std::size_t k = 0; k < 4; ++k) {
        const bool exactly = family == Points::coplanar;
        p.start[k].z() = exactly ? 0 : detail::last_bit(random, 4);
        p.end[k].z() = exactly ? 0 : detail::last_bit(random, 4);
      }
      break;
    case Points::parallel: {
      // The second edge, or the third vertex of the face, follows the first but for a last bit.
      const double last = detail::last_bit(random, 1);
      const auto follow = [&](std::array<V, 4>& at) {
        const V along = on_grid(at[1] - at[0], 8);
        at[1] = at[0] + along;
        at[3] = at[2] + along + V{last, 0, -last};
        if (!edges) at[3] = at[2] + on_grid(at[2] - at[1], 8) + V{last, 0, -last};
      };
      follow(p.start);
      const V turn = random.chance(0.5) ? V(V::Zero()) : in_box(random, 1);
      p.end = p.start;
      for (std::size_t k = 0; k < 4; ++k) p.end[k] += k < 2 ? turn : V(-turn);
      if (random.chance(0.5)) follow(p.end);
      break;
    }
    case Points::touch_and_leave: {
      // An edge turns over another that slides below it, or a face over a vertex: the height
      // between them is 2 (t − 1/2)², but for a last bit that separates them or lets them cross.
      if (edges) {
        p.start = {V(-1, 0, 1), V(1, 0, 0), V(-1, -1, 0.5), V(-1, 1, 0.5)};
        p.end = {V(-1, 0, 0), V(1, 0, 1), V(1, -1, 0.5), V(1, 1, 0.5)};
      } else {
        p.start = {V(-1, 0, 0), V(-3, -3, -1.5), V(-3, 3, -1.5), V(3, 0, 1.5)};
        p.end = {V(1, 0, 0), V(-3, -3, 1.5), V(-3, 3, 1.5), V(3, 0, -1.5)};
      }
      const V turn = on_grid(in_box(random, 1), 4);
      const double last = detail::last_bit(random, 1);
      const int axis = random.integer(0, 2);
      for (auto* at : {&p.start, &p.end}) {
        for (V& v : *at) {
          if (at == &p.end) v += turn;
          v = V{v((axis + 0) % 3), v((axis + 1) % 3), v((axis + 2) % 3)};
        }
        for (std::size_t k = 0; k < (edges ? 2U : 1U); ++k) (*at)[k]((5 - axis) % 3) += last;
      }
      aimed = false;
      break;
    }
    case Points::at_the_start:
    case Points::at_the_end:
      aimed = true;
      time = family == Points::at_the_end ? 1 : 0;
      break;
    case Points::at_rest:
      for (std::size_t k = 0; k < 4; ++k) p.end[k] = p.start[k];
      break;
    case Points::no_area: {
      const bool same = random.chance(0.5);
      for (auto* at : {&p.start, &p.end}) {
        auto& x = *at;
        x[2] = on_grid(x[2], 8);
        x[3] = same ? x[2] : V(x[2] + (x[2] - on_grid(x[1], 8)));
        if (!same && !edges) x[1] = on_grid(x[1], 8);
      }
      if (same)
        weights =
            edges ? std::array<double, 4>{0.75, 0.25, 1, 0} : std::array<double, 4>{1, 0.5, 0.5, 0};
      break;
    }
    case Points::on_the_rim:
    case Points::missed_rim: {
      aimed = true;
      const bool corner = random.chance(0.5);
      if (edges) {
        weights =
            corner ? std::array<double, 4>{1, 0, 0, 1} : std::array<double, 4>{0.75, 0.25, 1, 0};
      } else {
        weights =
            corner ? std::array<double, 4>{1, 0, 1, 0} : std::array<double, 4>{1, 0.5, 0.5, 0};
      }
      break;
    }
    case Points::fast:
      for (std::size_t k = 0; k < 4; ++k) {
        const double speed = random.uniform(100, 1000);
        p.end[k] =
            p.start[k] + (k < (edges ? 2U : 1U) ? V(in_box(random, 1) * speed) : V(V::Zero()));
      }
      aimed = true;
      break;
    case Points::far:
      shift = in_box(random, 1 << 20);
      break;
    case Points::small:
      scale = 0x1p-20;
      break;
    case Points::random:
      break;
  }
  for (auto* at : {&p.start, &p.end}) {
    for (V& v : *at) v = on_grid(v + shift, detail::grid_bits);
  }
  if (aimed) detail::aim(p, edges, weights, time);
  if (family == Points::missed_rim) {
    const V out =
        V{detail::last_bit(random, 1), detail::last_bit(random, 1), detail::last_bit(random, 1)};
    for (std::size_t k = 0; k < (edges ? 2U : 1U); ++k) {
      p.start[k] += out;
      p.end[k] += out;
    }
  }
  for (auto* at : {&p.start, &p.end}) {
    for (V& v : *at) v *= scale;
  }
  return p;
}

}  // namespace families
