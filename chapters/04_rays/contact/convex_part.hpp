/// @file
/// A line in a convex part of a body that slabs and one quadratic bound: the decision without error
/// and without a root, and the two ends.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <limits>
#include <optional>

#include <contact/exact.hpp>
#include <contact/exact_ray_triangle.hpp>
#include <contact/passage.hpp>
#include <contact/running_error.hpp>
#include <contact/shapes.hpp>
#include <contact/sign_with_root.hpp>
#include <contact/vector.hpp>

namespace contact::detail {

// [convex-part]
/// All t with 0 ≤ along + rate t ≤ length.
template <class T>
struct LineSlab {
  T along{}, rate{}, length{};
};

/// All t with a t² + 2 b t + c ≤ 0 (if round) that are in every slab. These t form an interval.
template <class T>
struct ConvexPart {
  bool round = false;
  T a{}, b{}, c{};
  T depth{};  ///< b² − a c, in a form that loses less
  int slabs = 0;
  std::array<LineSlab<T>, 3> slab{};

  void add(const T& along, const T& rate, const T& length) {
    slab[static_cast<std::size_t>(slabs++)] = {along, rate, length};
  }
};

/// Which t of a line are asked about: all, t ≥ 0, or 0 ≤ t ≤ 1.
enum class LineExtent { line, ray, segment };

/// The end of an interval: above/below with below > 0; face = 2 slab + (1 for its far side).
template <class T>
struct Cut {
  T above{}, below{1.0};
  int face = -1;
};
// [/convex-part]

/// The interval that the slabs and the extent leave.
template <class T>
struct Clipped {
  bool empty = false;
  std::optional<Cut<T>> low, high;
};

template <class T>
Clipped<T> clip(const ConvexPart<T>& part, LineExtent extent, bool& sure) {
  Clipped<T> left;
  const auto less = [&sure](const Cut<T>& x, const Cut<T>& y) {
    return sign_of(x.above * y.below - y.above * x.below, sure) < 0;
  };
  const auto raise = [&](const Cut<T>& cut) {
    if (!left.low || less(*left.low, cut)) left.low = cut;
  };
  const auto lower = [&](const Cut<T>& cut) {
    if (!left.high || less(cut, *left.high)) left.high = cut;
  };
  if (extent != LineExtent::line) left.low = Cut<T>{T(0.0), T(1.0), -1};
  if (extent == LineExtent::segment) left.high = Cut<T>{T(1.0), T(1.0), -1};
  for (int i = 0; i < part.slabs; ++i) {
    const LineSlab<T>& slab = part.slab[static_cast<std::size_t>(i)];
    const T rest = slab.length - slab.along;
    const int rate = sign_of(slab.rate, sure);
    if (rate > 0) {
      raise({-slab.along, slab.rate, 2 * i});
      lower({rest, slab.rate, 2 * i + 1});
    } else if (rate < 0) {
      raise({-rest, -slab.rate, 2 * i + 1});
      lower({slab.along, -slab.rate, 2 * i});
    } else if (sign_of(slab.along, sure) < 0 || sign_of(rest, sure) < 0) {
      left.empty = true;
    }
    if (!sure) return left;
  }
  if (left.low && left.high && less(*left.high, *left.low)) left.empty = true;
  return left;
}

/// The sign of the quadratic at a cut; of its limit at −∞ (side −1) or +∞ (side +1) if there is
/// none.
template <class T>
int round_sign(const ConvexPart<T>& part, const std::optional<Cut<T>>& cut, int side, bool& sure) {
  if (cut) {
    const T& n = cut->above;
    const T& d = cut->below;
    const T twice = part.b + part.b;
    return sign_of((part.a * n + twice * d) * n + part.c * d * d, sure);
  }
  const int square = sign_of(part.a, sure);
  if (square != 0) return square;
  const int linear = side * sign_of(part.b, sure);
  return linear != 0 ? linear : sign_of(part.c, sure);
}

// [round-part]
/// Whether the quadratic, positive at both ends of the interval, is ≤ 0 between them: its vertex is
/// between them and its discriminant is not negative. No root is needed.
template <class T>
bool dips(const ConvexPart<T>& part, const Clipped<T>& in, bool& sure) {
  if (sign_of(part.a, sure) <= 0 || sign_of(part.depth, sure) < 0) return false;
  const auto beyond = [&](const Cut<T>& cut) {  // the sign of vertex − cut
    return sign_of(-(part.b * cut.below) - part.a * cut.above, sure);
  };
  return (!in.low || beyond(*in.low) > 0) && (!in.high || beyond(*in.high) < 0);
}

/// Whether a line of this extent meets the part.
template <class T>
bool meets(const ConvexPart<T>& part, LineExtent extent, bool& sure) {
  const Clipped<T> in = clip(part, extent, sure);
  if (in.empty || !part.round || !sure) return !in.empty;
  if (round_sign(part, in.low, -1, sure) <= 0) return true;
  if (round_sign(part, in.high, +1, sure) <= 0) return true;
  return dips(part, in, sure);
}
// [/round-part]

// [stable-root]
/// The root at which the quadratic falls, (−b − √depth)/a = c/(−b + √depth): the form in which
/// nothing cancels.
inline RunningError falling_root(const RunningError& a, const RunningError& b,
                                 const RunningError& c, const RunningError& depth) {
  const RunningError root = sqrt(depth);
  return b.value < 0 ? c / (root - b) : -((b + root) / a);
}
/// The same of exact numbers: at most four roundings and the root's two, so a relative error of at
/// most 8 u.
inline double falling_root(const Exact& a, const Exact& b, const Exact& c, const Exact& depth) {
  const Exact square = b * b;
  if (b.sign() == 0 && depth.sign() == 0) return 0;
  const bool b_leads = !(square < depth);
  const double other = root_of_quotient(b_leads ? depth : square, b_leads ? square : depth);
  if (b.sign() < 0) {
    if (c.sign() == 0) return 0;
    const double first = b_leads ? quotient<double>(c, -b)
                                 : (c.sign() < 0 ? -1 : 1) * root_of_quotient(c * c, depth);
    return first / (1 + other);
  }
  const double first =
      b_leads ? quotient<double>(b, a) : (a.sign() < 0 ? -1 : 1) * root_of_quotient(depth, a * a);
  return -first * (1 + other);
}
// [/stable-root]

/// A t with its face: −1 for the round surface, −2 where the interval is unbounded.
struct PartEnd {
  double t = 0;
  int face = -1;
};
/// The t of a line in a part.
struct PartPassage {
  PartEnd entry, exit;
};

/// t as long as it is finite; beyond the largest number that number; never 0 for another sign.
inline double in_range(double t, int sign) {
  constexpr double most = std::numeric_limits<double>::max();
  if (t == 0 && sign != 0) return sign * std::numeric_limits<double>::denorm_min();
  return std::clamp(t, -most, most);
}

/// A value that is certain to 2^-41 of itself; not sure if it is not.
inline double settled(const RunningError& t, int, bool& sure) {
  if (!(t.bound <= 0x1p-41 * std::abs(t.value)) || !std::isfinite(t.value)) sure = false;
  return t.value;
}
inline double settled_cut(const Cut<RunningError>& cut, bool& sure) {
  return settled(cut.above / cut.below, 0, sure);
}
inline double settled_cut(const Cut<Exact>& cut, bool&) {
  return in_range(quotient<double>(cut.above, cut.below), cut.above.sign());
}
inline double settled_root(const ConvexPart<RunningError>& part, bool rises, bool& sure) {
  const RunningError b = rises ? -part.b : part.b;
  const RunningError t = falling_root(part.a, b, part.c, part.depth);
  return settled(rises ? -t : t, 0, sure);
}
inline double settled_root(const ConvexPart<Exact>& part, bool rises, bool&) {
  const Exact b = rises ? -part.b : part.b;
  const double t = falling_root(part.a, b, part.c, part.depth);
  // The sign: that of c where b < 0, else that of −a unless the root is 0.
  const int sign = b.sign() < 0                              ? part.c.sign()
                   : b.sign() == 0 && part.depth.sign() == 0 ? 0
                                                             : -part.a.sign();
  const double got = in_range(t, sign);
  return rises ? -got : got;
}

/// The passage of an unbounded line; only if `sure` stays true is it meant.
template <class T>
std::optional<PartPassage> passage_in(const ConvexPart<T>& part, bool& sure) {
  constexpr double endless = std::numeric_limits<double>::infinity();
  const Clipped<T> in = clip(part, LineExtent::line, sure);
  if (in.empty || !sure) return std::nullopt;
  const int at_low = part.round ? round_sign(part, in.low, -1, sure) : -1;
  const int at_high = part.round ? round_sign(part, in.high, +1, sure) : -1;
  if (!sure || (at_low > 0 && at_high > 0 && !dips(part, in, sure))) return std::nullopt;
  PartPassage found{{-endless, -2}, {endless, -2}};
  if (at_low > 0) {
    found.entry = {settled_root(part, false, sure), -1};
  } else if (in.low) {
    found.entry = {settled_cut(*in.low, sure), in.low->face};
  }
  if (at_high > 0) {
    found.exit = {settled_root(part, true, sure), -1};
  } else if (in.high) {
    found.exit = {settled_cut(*in.high, sure), in.high->face};
  }
  return found;
}

// [filter-and-fallback]
/// Whether a line meets one of n parts: with a bound on every error first, and without error for
/// those parts for which that does not decide. make.part<T>(k) is part k in the arithmetic of T.
template <class Make>
bool meets_parts(int n, const Make& make, LineExtent extent) {
  for (int k = 0; k < n; ++k) {
    bool sure = true;
    bool met = meets(make.template part<RunningError>(k), extent, sure);
    if (!sure) met = meets(make.template part<Exact>(k), extent, sure = true);
    if (met) return true;
  }
  return false;
}
// [/filter-and-fallback]

/// The passage through n parts whose union is convex: the first entry and the last exit. Nothing if
/// the line of this extent meets no part; each part is computed once for both.
template <class Make>
std::optional<PartPassage> passage_in_parts(int n, const Make& make,
                                            LineExtent extent = LineExtent::line) {
  std::optional<PartPassage> all;
  bool met = extent == LineExtent::line;
  for (int k = 0; k < n; ++k) {
    bool decided = true, settled = true;
    std::optional<PartPassage> one;
    {
      const auto part = make.template part<RunningError>(k);
      one = passage_in(part, settled);
      if (settled && !one) continue;
      if (!met) met = meets(part, extent, decided) && decided;
    }
    if (!decided || !settled) {
      const auto part = make.template part<Exact>(k);
      bool sure = true;
      if (!settled) one = passage_in(part, sure);
      if (!met && one) met = meets(part, extent, sure);
    }
    if (!one) continue;
    if (!all) {
      all = one;
      continue;
    }
    if (one->entry.t < all->entry.t) all->entry = one->entry;
    if (all->exit.t < one->exit.t) all->exit = one->exit;
  }
  if (!met) return std::nullopt;
  if (all && all->exit.t < all->entry.t) all->exit.t = all->entry.t;
  return all;
}

/// A ray or a segment in double: its start, and its direction or its end.
struct DoubleLine {
  Vector3<double> start, second;
  LineExtent extent;

  template <std::floating_point S>
  explicit DoubleLine(const Ray<S>& ray)
      : start(ray.origin.template cast<double>()),
        second(ray.direction.template cast<double>()),
        extent(LineExtent::ray) {}
  template <std::floating_point S>
  explicit DoubleLine(const Segment<S>& segment)
      : start(segment.start.template cast<double>()),
        second(segment.end.template cast<double>()),
        extent(LineExtent::segment) {}

  bool finite() const { return all_finite(start) && all_finite(second); }
  /// The start, relative to a point.
  template <class T>
  Triple<T> from(const Vector3<double>& point) const {
    return minus(triple<T>(start), triple<T>(point));
  }
  template <class T>
  Triple<T> direction() const {
    return extent == LineExtent::segment ? minus(triple<T>(second), triple<T>(start))
                                         : triple<T>(second);
  }
  /// The point at t, relative to a point, rounded.
  Vector3<double> at(double t, const Vector3<double>& point) const {
    if (extent == LineExtent::segment) {
      return (start - point) * (1 - t) + (second - point) * t;
    }
    return (start - point) + second * t;
  }
};

/// v divided by its length, whatever its range; 0 if it has none, or if v is a difference that
/// overflowed.
inline Vector3<double> unit_or_zero(const Vector3<double>& v) {
  const double largest = v.cwiseAbs().maxCoeff();
  if (!all_finite(v) || !(largest > 0)) return Vector3<double>::Zero();
  int power = 0;
  std::frexp(largest, &power);
  const Vector3<double> near_one(std::ldexp(v.x(), -power), std::ldexp(v.y(), -power),
                                 std::ldexp(v.z(), -power));
  return near_one / std::sqrt(near_one.dot(near_one));
}

/// t in S: never 0 for another sign, never infinite for a finite t.
template <std::floating_point S>
S to_scalar(double t) {
  using Limits = std::numeric_limits<S>;
  if (std::isinf(t)) return static_cast<S>(t);
  const double most = static_cast<double>(Limits::max());
  const S x = static_cast<S>(std::clamp(t, -most, most));
  if (x == S(0) && t != 0) return t < 0 ? -Limits::denorm_min() : Limits::denorm_min();
  return x;
}

/// A passage in S. normal(t, face) is the outward normal at a finite end, face(f) its number.
template <std::floating_point S, class Normal>
std::optional<Passage<S>> passage_with_normals(const std::optional<PartPassage>& found,
                                               const Normal& normal) {
  if (!found) return std::nullopt;
  Passage<S> passage;
  const auto fill = [&](const PartEnd& end, S& t, Vector3<S>& n, int& face) {
    t = to_scalar<S>(end.t);
    face = std::max(end.face, -1);
    if (end.face != -2) n = normal(end.t, end.face).template cast<S>();
  };
  fill(found->entry, passage.entry, passage.entry_normal, passage.entry_face);
  fill(found->exit, passage.exit, passage.exit_normal, passage.exit_face);
  return passage;
}

/// The first hit of a line that is known to meet the body.
template <std::floating_point S, class Normal>
std::optional<BodyHit<S>> hit_with_normal(const DoubleLine& line,
                                          const std::optional<PartPassage>& found,
                                          const Normal& normal) {
  if (!found) return std::nullopt;
  BodyHit<S> hit;
  if (found->entry.t < 0) {
    hit.point = line.start.template cast<S>();
    hit.inside = true;
    return hit;
  }
  const double t =
      line.extent == LineExtent::segment ? std::min(found->entry.t, 1.0) : found->entry.t;
  hit.t = to_scalar<S>(t);
  hit.point = line.at(t, Vector3<double>::Zero()).template cast<S>();
  hit.normal = normal(t, found->entry.face).template cast<S>();
  hit.face = found->entry.face;
  return hit;
}

}  // namespace contact::detail
