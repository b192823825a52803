/// @file
/// Which of two bodies a line enters first, decided without error: entries are numbers with one
/// square root each, and their order is a sign.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <variant>

#include <contact/aabb.hpp>
#include <contact/capsule.hpp>
#include <contact/convex_part.hpp>
#include <contact/oriented_box.hpp>
#include <contact/ray_capsule.hpp>
#include <contact/ray_cone.hpp>
#include <contact/ray_cylinder.hpp>
#include <contact/shapes.hpp>
#include <contact/sign_with_root.hpp>
#include <contact/vector.hpp>

namespace contact {

/// A body of a scene.
template <Ring S>
using Primitive =
    std::variant<Sphere<S>, Aabb<S>, OrientedBox<S>, Cylinder<S>, Capsule<S>, Cone<S>, Triangle<S>>;

namespace detail {

// [sign-with-two-roots]
/// The sign of a + b √d + c √e, for d ≥ 0 and e ≥ 0: by squaring twice.
inline int sign_with_two_roots(const Exact& a, const Exact& b, const Exact& d, const Exact& c,
                               const Exact& e) {
  const int first = sign_with_root(a, b, d);
  const int second = e.sign() == 0 ? 0 : c.sign();
  if (first * second >= 0) return first != 0 ? first : second;
  const int larger = sign_with_root(a * a + b * b * d - c * c * e, Exact(2.0) * a * b, d);
  return larger >= 0 ? (larger == 0 ? 0 : first) : second;
}
// [/sign-with-two-roots]

/// (a + b √d)/c with c > 0 and d ≥ 0.
struct EntryRoot {
  Exact a, b, d, c{1.0};

  int sign() const { return sign_with_root(a, b, d); }
};
inline int compare(const EntryRoot& x, const EntryRoot& y) {
  return sign_with_two_roots(x.a * y.c - y.a * x.c, x.b * y.c, x.d, -(y.b * x.c), y.d);
}

/// Where an unbounded line enters a part; 0 if it has no first point; nothing if it misses.
inline std::optional<EntryRoot> exact_entry(const ConvexPart<Exact>& part) {
  bool sure = true;
  const Clipped<Exact> in = clip(part, LineExtent::line, sure);
  if (in.empty) return std::nullopt;
  const int at_low = part.round ? round_sign(part, in.low, -1, sure) : -1;
  if (at_low <= 0) return in.low ? EntryRoot{in.low->above, {}, {}, in.low->below} : EntryRoot{};
  if (round_sign(part, in.high, +1, sure) > 0 && !dips(part, in, sure)) return std::nullopt;
  // (−b − √depth)/a; for a = 0 the root of the linear equation.
  if (part.a.sign() > 0) return EntryRoot{-part.b, Exact(-1.0), part.depth, part.a};
  if (part.a.sign() < 0) return EntryRoot{part.b, Exact(1.0), part.depth, -part.a};
  return EntryRoot{part.c, {}, {}, -(part.b + part.b)};
}

/// The parts of the other bodies, as CylinderParts.
struct SphereParts {
  const DoubleLine& line;
  Vector3<double> centre;
  double radius;
  template <class T>
  ConvexPart<T> part(int) const {
    return ball_part(line.from<T>(centre), line.direction<T>(), T(radius));
  }
};
struct AabbParts {
  const DoubleLine& line;
  Vector3<double> low, high;
  template <class T>
  ConvexPart<T> part(int) const {
    const Triple<T> m = line.from<T>(low), w = line.direction<T>();
    const Triple<T> size = minus(triple<T>(high), triple<T>(low));
    ConvexPart<T> box;
    for (std::size_t k = 0; k < 3; ++k) box.add(m[k], w[k], size[k]);
    return box;
  }
};
inline RunningError magnitude(const RunningError& x) { return {std::abs(x.value), x.bound}; }
inline Exact magnitude(const Exact& x) { return abs(x); }
struct OrientedBoxParts {
  const DoubleLine& line;
  Vector3<double> centre;
  Matrix3<double> axes;
  Vector3<double> half_lengths;
  template <class T>
  ConvexPart<T> part(int) const {
    const Triple<T> m = line.from<T>(centre), w = line.direction<T>();
    ConvexPart<T> box;
    for (int k = 0; k < 3; ++k) {
      const auto axis = [&](int i) { return triple<T>(Vector3<double>(axes.col(i % 3))); };
      const Triple<T> n = cross(axis(k + 1), axis(k + 2));
      const T half = magnitude(dot(n, axis(k))) * T(half_lengths(k));
      box.add(dot(n, m) + half, dot(n, w), half + half);
    }
    return box;
  }
};
/// The plane of a triangle: a slab without thickness.
struct TriangleParts {
  const DoubleLine& line;
  Vector3<double> a, b, c;
  template <class T>
  ConvexPart<T> part(int) const {
    const Triple<T> from = triple<T>(a);
    const Triple<T> n = cross(minus(triple<T>(b), from), minus(triple<T>(c), from));
    ConvexPart<T> plane;
    plane.add(dot(n, line.from<T>(a)), dot(n, line.direction<T>()), T(0.0));
    return plane;
  }
};

/// Calls ask(parts, count) with the parts of a body.
template <FloatOrDouble S, class Ask>
auto ask_parts(const DoubleLine& line, const Primitive<S>& body, const Ask& ask) {
  const auto wide = [](const auto& v) { return v.template cast<double>().eval(); };
  struct Visit {
    const DoubleLine& line;
    const Ask& ask;
    decltype(wide)& in_double;
    auto operator()(const Sphere<S>& x) const {
      return ask(SphereParts{line, in_double(x.centre), double(x.radius)}, 1);
    }
    auto operator()(const Aabb<S>& x) const {
      return ask(AabbParts{line, in_double(x.low), in_double(x.high)}, 1);
    }
    auto operator()(const OrientedBox<S>& x) const {
      return ask(
          OrientedBoxParts{line, in_double(x.centre), in_double(x.axes), in_double(x.half_lengths)},
          1);
    }
    auto operator()(const Cylinder<S>& x) const {
      const DoubleCore core(x.core, x.radius);
      return ask(CylinderParts{line, core, true}, 1);
    }
    auto operator()(const Capsule<S>& x) const {
      const DoubleCore core(x.core, x.radius);
      const CapsuleParts parts{line, core};
      return ask(parts, parts.count());
    }
    auto operator()(const Cone<S>& x) const {
      const DoubleCore core(Segment<S>{x.apex, x.base}, x.radius);
      return ask(ConeParts{line, core}, 1);
    }
    auto operator()(const Triangle<S>& x) const {
      return ask(TriangleParts{line, in_double(x.a), in_double(x.b), in_double(x.c)}, 1);
    }
  };
  return std::visit(Visit{line, ask, wide}, body);
}

/// The t at which a line that hits the body enters it, 0 if it starts inside; within 2^-40 |t|.
template <FloatOrDouble S>
double entry_key(const DoubleLine& line, const Primitive<S>& body) {
  return ask_parts<S>(line, body, [](const auto& parts, int count) {
    const std::optional<PartPassage> found = passage_in_parts(count, parts);
    return found ? std::max(found->entry.t, 0.0) : 0.0;
  });
}
/// The same without error.
template <FloatOrDouble S>
EntryRoot exact_entry(const DoubleLine& line, const Primitive<S>& body) {
  return ask_parts<S>(line, body, [](const auto& parts, int count) {
    std::optional<EntryRoot> first;
    for (int k = 0; k < count; ++k) {
      const auto one = exact_entry(parts.template part<Exact>(k));
      if (one && (!first || compare(*one, *first) < 0)) first = one;
    }
    return first && first->sign() > 0 ? *first : EntryRoot{};
  });
}

}  // namespace detail

// [entered-before]
/// A body that a line hits, and its t as a double.
template <FloatOrDouble S>
struct Entered {
  const Primitive<S>* body;  ///< not owned
  double t;                  ///< within 2^-40 of itself
};

/// Whether the line enters the first body before the second: exact. Only if the two t are closer
/// than their errors, they are compared as numbers with a root.
///
/// Two t of 0: no. A t that is infinite or NaN leaves the decision to the numbers with a root;
/// there a body that the line misses counts as entered at t = 0. A line or a body that is not
/// finite is an error of the program, as for Exact.
template <FloatOrDouble S>
bool entered_before(const detail::DoubleLine& line, const Entered<S>& x, const Entered<S>& y) {
  const double difference = x.t - y.t;
  if (x.t == 0 && y.t == 0) return false;
  if (std::abs(difference) > 0x1p-38 * std::max(x.t, y.t)) return difference < 0;
  return detail::compare(detail::exact_entry<S>(line, *x.body),
                         detail::exact_entry<S>(line, *y.body)) < 0;
}
// [/entered-before]

}  // namespace contact
