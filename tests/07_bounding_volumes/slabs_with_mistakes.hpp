/// @file
/// Slabs of bodies in integers, right or with one mistake that people make: what the test of the
/// exercise compares with and recognises.
#pragma once

#include <07_bounding_volumes/whole_points.hpp>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "slabs_overlap.hpp"

namespace slabs_with_mistakes {

using whole_points::Point;
using Points = std::vector<Point>;
using Slabs = std::vector<exercise::Slab>;

/// What is done to a dot product.
enum class Projected { rightly, by_unit, without_sign, in_float };

inline double projected(const Point& n, const Point& p, Projected way = Projected::rightly) {
  const auto exact = static_cast<double>(whole_points::dot(n, p));
  switch (way) {
    case Projected::by_unit:
      return exact / n.norm();
    case Projected::without_sign:
      return std::abs(exact);
    case Projected::in_float:
      return static_cast<float>(exact);
    case Projected::rightly:
      break;
  }
  return exact;
}

/// What slabs begin with, before the first vertex.
enum class Start { nothing, zero, smallest_positive, infinities };

struct Making {
  Start start = Start::nothing;
  Projected projected = Projected::rightly;
  bool either = false;   ///< a vertex that lowers the one plane cannot raise the other one
  bool corners = false;  ///< of the box around the body, instead of its vertices
};

inline Points corners(const Points& points) {
  Eigen::AlignedBox3d box;
  for (const Point& p : points) box.extend(p);
  Points all;
  for (int i = 0; i < 8; ++i)
    all.push_back(box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i)));
  return all;
}

inline Slabs slabs_of(const Points& directions, const Points& vertices, const Making& making = {}) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const Points points = making.corners ? corners(vertices) : vertices;
  Slabs slabs;
  for (const Point& n : directions) {
    double low = kInfinity, high = -kInfinity;
    if (making.start == Start::zero) low = high = 0;
    if (making.start == Start::smallest_positive) high = std::numeric_limits<double>::min();
    for (const Point& p : points) {
      const double d = projected(n, p, making.projected);
      const bool lowers = d < low;
      if (lowers) low = d;
      if (d > high && !(making.either && lowers)) high = d;
    }
    slabs.push_back({low, high});
  }
  return slabs;
}

struct Between {
  Projected projected = Projected::rightly;
  bool low = true, high = true;  ///< which planes are asked
  bool on_plane = true;          ///< a point on a plane is between
  bool some = false;             ///< one pair is enough
  bool flat = true;              ///< planes without a distance may have a point between them
  std::size_t left_out = 0;      ///< how many of the last pairs are not asked
};

inline bool between_each_pair(const Points& directions, const Slabs& slabs, const Point& point,
                              const Between& ways = {}) {
  const auto between = [&](std::size_t i) {
    const double d = projected(directions[i], point, ways.projected);
    const auto [low, high] = slabs[i];
    if (!ways.flat && low == high) return false;
    if (!ways.on_plane && (d == low || d == high)) return false;
    return (d >= low || !ways.low) && (d <= high || !ways.high);
  };
  std::size_t count = 0;
  for (std::size_t i = 0; i + ways.left_out < slabs.size(); ++i) count += between(i) ? 1 : 0;
  return ways.some ? count > 0 : count + ways.left_out >= slabs.size();
}

/// Which slabs count as apart.
enum class Apart {
  rightly,
  if_touching,
  if_first_before_second,
  if_second_before_first,
  if_no_end_in_first,   ///< the first slab contains no end of the second
  if_no_end_in_second,  ///< the other way round
  if_flat
};

inline bool are_apart(const exercise::Slab& a, const exercise::Slab& b, Apart apart) {
  const auto contains = [](const exercise::Slab& slab, double x) {
    return slab.low <= x && x <= slab.high;
  };
  switch (apart) {
    case Apart::if_touching:
      return a.high <= b.low || b.high <= a.low;
    case Apart::if_first_before_second:
      return a.high < b.low;
    case Apart::if_second_before_first:
      return b.high < a.low;
    case Apart::if_no_end_in_first:
      return !contains(a, b.low) && !contains(a, b.high);
    case Apart::if_no_end_in_second:
      return !contains(b, a.low) && !contains(b, a.high);
    case Apart::if_flat:
      return a.low == a.high || b.low == b.high || a.high < b.low || b.high < a.low;
    case Apart::rightly:
      break;
  }
  return a.high < b.low || b.high < a.low;
}

/// All directions in which the slabs are apart.
inline std::vector<int> separating(const Slabs& first, const Slabs& second,
                                   Apart apart = Apart::rightly) {
  std::vector<int> all;
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (are_apart(first[i], second[i], apart)) all.push_back(static_cast<int>(i));
  }
  return all;
}

inline int first_separating(const Slabs& first, const Slabs& second, Apart apart = Apart::rightly) {
  const std::vector<int> all = separating(first, second, apart);
  return all.empty() ? -1 : all.front();
}

inline int last_separating(const Slabs& first, const Slabs& second) {
  const std::vector<int> all = separating(first, second);
  return all.empty() ? -1 : all.back();
}

/// Apart only if the slabs are apart in every direction.
inline int separating_everywhere(const Slabs& first, const Slabs& second) {
  return separating(first, second).size() == first.size() ? 0 : -1;
}

inline int separating_but_in_the_last(const Slabs& first, const Slabs& second) {
  const int i = slabs_with_mistakes::first_separating(first, second);
  return i + 1 == std::ssize(first) ? -1 : i;
}

inline double gap(const exercise::Slab& a, const exercise::Slab& b) {
  return std::max(b.low - a.high, a.low - b.high);
}

/// The direction with the widest gap, as slabs have it.
inline int widest_gap(const Slabs& first, const Slabs& second) {
  int widest = -1;
  double width = 0;
  for (const int i : separating(first, second)) {
    const auto at = static_cast<std::size_t>(i);
    if (gap(first[at], second[at]) <= width) continue;
    width = gap(first[at], second[at]);
    widest = i;
  }
  return widest;
}

inline int size_if_none(const Slabs& first, const Slabs& second) {
  const int i = slabs_with_mistakes::first_separating(first, second);
  return i < 0 ? static_cast<int>(first.size()) : i;
}

struct Moving {
  Projected projected = Projected::rightly;
  bool by_length = false;        ///< of the displacement
  double sign = 1;               ///< of what is added
  bool low = true, high = true;  ///< which planes move
  bool swept = false;            ///< the slab before is kept as well
};

inline Slabs moved(const Points& directions, const Slabs& slabs, const Point& displacement,
                   const Moving& ways = {}) {
  Slabs after;
  for (std::size_t i = 0; i < slabs.size(); ++i) {
    const double by =
        ways.sign * (ways.by_length ? displacement.norm()
                                    : projected(directions[i], displacement, ways.projected));
    const bool low = ways.low && (!ways.swept || by < 0),
               high = ways.high && (!ways.swept || by > 0);
    after.push_back({slabs[i].low + (low ? by : 0), slabs[i].high + (high ? by : 0)});
  }
  return after;
}

/// Whether each number of `got` is near that of `other`, and the two lists differ from `right`.
inline bool near(const Slabs& got, const Slabs& other, const Slabs& right) {
  const auto close = [](double x, double y) { return std::abs(x - y) <= 1e-9 * (1 + std::abs(y)); };
  bool differs = false;
  if (got.size() != other.size() || got.size() != right.size()) return false;
  for (std::size_t i = 0; i < got.size(); ++i) {
    if (!close(got[i].low, other[i].low) || !close(got[i].high, other[i].high)) return false;
    differs |= !close(got[i].low, right[i].low) || !close(got[i].high, right[i].high);
  }
  return differs;
}

}  // namespace slabs_with_mistakes
