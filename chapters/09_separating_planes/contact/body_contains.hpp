/// @file
/// Whether a point is in a convex body, exactly, for every kind of body.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <contact/box_around.hpp>
#include <contact/convex_shapes.hpp>
#include <contact/enclosing_radius.hpp>
#include <contact/exact.hpp>
#include <contact/gjk.hpp>
#include <contact/gjk_simplex.hpp>
#include <contact/running_error.hpp>
#include <contact/support.hpp>
#include <contact/support_bounds.hpp>
#include <contact/vector.hpp>
#include <cstddef>
#include <utility>

namespace contact {

namespace contains_detail {

using detail::cross;
using detail::dot;
using detail::minus;
using detail::sign_of;
using detail::Triple;
using detail::triple;

/// A segment, a radius and a point in a number type.
template <class T>
struct RoundTerms {
  Triple<T> core, from_start, from_end;
  T radius;

  template <FloatOrDouble S>
  RoundTerms(const Segment<S>& segment, const S& r, const Vector3<S>& point)
      : core(minus(in<T>(segment.end), in<T>(segment.start))),
        from_start(minus(in<T>(point), in<T>(segment.start))),
        from_end(minus(in<T>(point), in<T>(segment.end))),
        radius(T(static_cast<double>(r))) {}

  template <class U, FloatOrDouble S>
  static Triple<U> in(const Vector3<S>& v) {
    return triple<U>(v.template cast<double>());
  }
};

// [round-bodies]
/// Whether a point is in a capsule: its distance from an end of the core, or between the planes
/// through the ends from the line, by |w × e|² ≤ r² e · e.
template <class T>
bool in_capsule(const RoundTerms<T>& terms, bool& sure) {
  const T square = terms.radius * terms.radius;
  if (sign_of(dot(terms.from_start, terms.core), sure) <= 0) {
    return sign_of(dot(terms.from_start, terms.from_start) - square, sure) <= 0;
  }
  if (sign_of(dot(terms.from_end, terms.core), sure) >= 0) {
    return sign_of(dot(terms.from_end, terms.from_end) - square, sure) <= 0;
  }
  const Triple<T> moment = cross(terms.from_start, terms.core);
  return sign_of(dot(moment, moment) - square * dot(terms.core, terms.core), sure) <= 0;
}
/// Whether a point is in a cylinder.
template <class T>
bool in_cylinder(const RoundTerms<T>& terms, bool& sure) {
  if (sign_of(dot(terms.from_start, terms.core), sure) < 0) return false;
  if (sign_of(dot(terms.from_end, terms.core), sure) > 0) return false;
  const Triple<T> moment = cross(terms.from_start, terms.core);
  return sign_of(dot(moment, moment) - terms.radius * terms.radius * dot(terms.core, terms.core),
                 sure) <= 0;
}
// [/round-bodies]

// [in-ellipsoid]
/// Whether a point is in an ellipsoid. It is centre + Σ xᵢ hᵢ axesᵢ with xᵢ = dᵢ/(hᵢ D), where dᵢ
/// and D are determinants (Cramer's rule), so Σ xᵢ² ≤ 1 is Σ (dᵢ hⱼ hₖ)² ≤ (D h₀ h₁ h₂)².
template <class T, FloatOrDouble S>
bool in_ellipsoid(const Ellipsoid<S>& body, const Vector3<S>& point, bool& sure) {
  using Terms = RoundTerms<T>;
  const Triple<T> w = minus(Terms::template in<T>(point), Terms::template in<T>(body.centre));
  std::array<Triple<T>, 3> axes;
  std::array<T, 3> half;
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    axes[k] = Terms::template in<T>(Vector3<S>(body.axes.col(i)));
    half[k] = T(static_cast<double>(body.half_lengths(i)));
  }
  const T all = dot(axes[0], cross(axes[1], axes[2])) * half[0] * half[1] * half[2];
  if (sign_of(all, sure) == 0) return false;
  T sum = -(all * all);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    const T term = dot(w, cross(axes[j], axes[k])) * half[j] * half[k];
    sum = sum + term * term;
  }
  return sign_of(sum, sure) <= 0;
}
// [/in-ellipsoid]

/// A decision in bounded numbers, and in doubt in exact ones.
template <class Decide>
bool decided(const Decide& decide) {
  bool sure = true;
  const bool inside = decide(RunningError(), sure);
  return sure ? inside : decide(Exact(), sure);
}

// [exactly-within]
/// Whether a point is at most the radius from a core, by GJK without rounding: the closest point of
/// a simplex is optimal if no vertex is beyond the plane through it; else such a vertex is added.
///
/// The distance falls in every step, and there are finitely many simplices; so it ends.
/// @param start a vertex of the core to begin with
template <PolytopeCore Body>
bool exactly_within(const Body& body, const Vector3<Exact>& point, int start) {
  const int count = vertex_count(body);
  const auto from_point = [&](int i) {
    const Vector3<Exact> v = exact_vertex(body, i) - point;
    return Triple<Exact>{v[0], v[1], v[2]};
  };
  const Exact radius(static_cast<double>(radius_of(body)));
  std::array<Triple<Exact>, 4> simplex{from_point(start)};
  int size = 1;
  for (;;) {
    const gjk_detail::SimplexTerms<Exact> terms(simplex, size);
    const auto face =
        std::find_if(gjk_detail::faces.begin(), gjk_detail::faces.end(),
                     [&](VertexSet f) { return f < 1U << size && terms.decide(f) > 0; });
    const auto foot = terms.foot(*face);
    const Exact squared = dot(foot.direction, foot.direction);
    if (squared <= radius * radius * foot.whole * foot.whole) return true;
    int kept = 0;
    for (int i = 0; i < size; ++i) {
      if ((*face >> i & 1U) != 0) {
        simplex[static_cast<std::size_t>(kept++)] = simplex[static_cast<std::size_t>(i)];
      }
    }
    size = kept;
    Exact lowest = dot(foot.direction, simplex[0]);
    Triple<Exact> farthest = simplex[0];
    bool beyond = false;
    for (int i = 0; i < count; ++i) {
      const Triple<Exact> w = from_point(i);
      const Exact along = dot(foot.direction, w);
      if (along < lowest) {
        lowest = along;
        farthest = w;
        beyond = true;
      }
    }
    if (!beyond) return false;
    simplex[static_cast<std::size_t>(size++)] = farthest;
  }
}
// [/exactly-within]

/// A vertex of a triangle, lozenge or hull less a point, in bounded numbers.
template <PolytopeCore Body>
Triple<RunningError> bounded_difference(const Body& body, int i,
                                        const Vector3<ScalarOf<Body>>& point) {
  using S = ScalarOf<Body>;
  const auto in = [](const Vector3<S>& v) {
    return triple<RunningError>(v.template cast<double>());
  };
  if constexpr (std::same_as<Body, Lozenge<S>>) {
    Triple<RunningError> v = minus(in(body.corner), in(point));
    for (const auto& [bit, edge] : {std::pair{1, &body.first_edge}, {2, &body.second_edge}}) {
      const Triple<RunningError> e = in(*edge);
      if ((i & bit) != 0) v = {v[0] + e[0], v[1] + e[1], v[2] + e[2]};
    }
    return v;
  } else {
    return minus(in(vertex(body, i)), in(point));
  }
}

// [within]
/// The same with a filter: rounded GJK finds a plane that is proved to have the body behind it and
/// the point in front, a point of the core that is certainly closer than the radius, or a
/// tetrahedron of vertices that certainly contains the point.
template <PolytopeCore Body>
bool within(const Body& body, const Vector3<ScalarOf<Body>>& point) {
  using S = ScalarOf<Body>;
  const GjkResult<S> near = gjk(Sphere<S>{point, S(0)}, body);
  const Vector3<double> n = near.between.template cast<double>();
  if (-support_up(Sphere<S>{point, S(0)}, -n) > support_up(body, n)) return false;
  const double radius = static_cast<double>(radius_of(body));
  double room = 0;
  for (int i = 0; i < near.count; ++i) {
    const GjkVertex<S>& v = near.simplex[static_cast<std::size_t>(i)];
    room = std::max(room, static_cast<double>(v.of_a.cwiseAbs().sum() + v.of_b.cwiseAbs().sum()));
  }
  room *= 64 * static_cast<double>(tolerance::unit_roundoff<S>);
  const Vector3<S> off = near.on_a - near.on_b;
  if (std::sqrt(static_cast<double>(off.dot(off))) + room < radius) return true;
  if (near.count == 4) {
    std::array<Triple<RunningError>, 4> corners;
    for (std::size_t i = 0; i < 4; ++i) {
      corners[i] = bounded_difference(body, near.simplex[i].b, point);
    }
    const gjk_detail::SimplexTerms<RunningError> terms(corners, 4);
    if (terms.decide(15U) > 0) return true;
  }
  return exactly_within(body, exact_vector<S>(point), std::max(near.simplex[0].b, 0));
}
// [/within]

}  // namespace contains_detail

// [contains-body]
/// Whether a point is in a body, exactly, for the stored numbers. Touching counts. For spheres see
/// also enclosing_radius.hpp, for boxes box_around.hpp.
///
/// Polynomials of the stored numbers decide for a capsule, a cylinder and an ellipsoid: in double
/// with bounds on the errors, and in doubt exactly. For a triangle, a lozenge and a hull GJK
/// decides, in doubt exactly.
/// @return false if a number is not finite, a radius is negative or a half length not greater
/// than 0, a cylinder's core has no length or the axes of an ellipsoid are linearly dependent
template <FloatOrDouble S>
bool contains(const Capsule<S>& body, const Vector3<S>& point) {
  if (!all_finite(point) || !is_finite(gjk_detail::largest_number(body))) return false;
  if (body.radius < S(0)) return false;
  return contains_detail::decided([&]<class T>(const T&, bool& sure) {
    return contains_detail::in_capsule(
        contains_detail::RoundTerms<T>(body.core, body.radius, point), sure);
  });
}
/// Whether a cylinder contains a point, exactly.
template <FloatOrDouble S>
bool contains(const Cylinder<S>& body, const Vector3<S>& point) {
  if (!all_finite(point) || !is_finite(gjk_detail::largest_number(body))) return false;
  if (body.radius < S(0) || body.core.start == body.core.end) return false;
  return contains_detail::decided([&]<class T>(const T&, bool& sure) {
    return contains_detail::in_cylinder(
        contains_detail::RoundTerms<T>(body.core, body.radius, point), sure);
  });
}
/// Whether an ellipsoid contains a point, exactly.
template <FloatOrDouble S>
bool contains(const Ellipsoid<S>& body, const Vector3<S>& point) {
  if (!all_finite(point) || !all_finite(body.centre) || !all_finite(body.axes) ||
      !all_finite(body.half_lengths) || body.half_lengths.minCoeff() < S(0)) {
    return false;
  }
  return contains_detail::decided([&]<class T>(const T&, bool& sure) {
    return contains_detail::in_ellipsoid<T>(body, point, sure);
  });
}
/// Whether a triangle contains a point, exactly.
template <FloatOrDouble S>
bool contains(const Triangle<S>& body, const Vector3<S>& point) {
  if (!all_finite(point) || !is_finite(gjk_detail::largest_number(body))) return false;
  return contains_detail::within(body, point);
}
/// Whether a lozenge contains a point, exactly.
template <FloatOrDouble S>
bool contains(const Lozenge<S>& body, const Vector3<S>& point) {
  if (!all_finite(point) || !is_finite(gjk_detail::largest_number(body))) return false;
  return !(body.radius < S(0)) && contains_detail::within(body, point);
}
/// Whether a convex hull contains a point, exactly.
template <FloatOrDouble S>
bool contains(const ConvexHull<S>& body, const Vector3<S>& point) {
  if (!all_finite(point) || body.vertices.empty()) return false;
  if (!is_finite(gjk_detail::largest_number(body)) || body.radius < S(0)) return false;
  return contains_detail::within(body, point);
}
// [/contains-body]

/// Whether a point is in a half-space as stored, n · x ≤ k for n of any length, exactly.
/// @return false if a number is not finite
template <FloatOrDouble S>
bool contains(const HalfSpace<S>& body, const Vector3<S>& point) {
  if (!all_finite(point) || !all_finite(body.boundary.normal)) return false;
  if (!is_finite(body.boundary.offset)) return false;
  return contains_detail::decided([&]<class T>(const T&, bool& sure) {
    using contains_detail::RoundTerms;
    const T above = contains_detail::dot(RoundTerms<T>::template in<T>(body.boundary.normal),
                                         RoundTerms<T>::template in<T>(point)) -
                    T(static_cast<double>(body.boundary.offset));
    return contains_detail::sign_of(above, sure) <= 0;
  });
}

}  // namespace contact
