/// @file
/// The quadratic of a line and a ball: its terms in double with error bounds and in exact numbers,
/// the signs that decide, and the roots.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <contact/exact.hpp>
#include <contact/few_digits.hpp>
#include <contact/filter.hpp>
#include <contact/passage.hpp>
#include <contact/shapes.hpp>
#include <contact/sign_with_root.hpp>
#include <contact/tolerance.hpp>
#include <contact/vector.hpp>
#include <limits>
#include <optional>

namespace contact {

// [terms]
/// The coefficients of |m + t d|² − r² = a t² + 2 b t + c, and a quarter of its discriminant.
template <Ring T>
struct SphereTerms {
  T a;      ///< d·d
  T b;      ///< d·m: negative while the line approaches the centre
  T c;      ///< m·m − r²: the start is outside (> 0), on the surface, or inside (< 0)
  T depth;  ///< b² − a c = r² a − |d × m|²: the line misses (< 0), touches, or crosses
};
// [/terms]

/// A sphere of floats or doubles, unchanged, as doubles: also infinities and NaN.
template <FloatOrDouble S>
Sphere<double> in_double(const Sphere<S>& sphere) {
  return {sphere.centre.template cast<double>(), static_cast<double>(sphere.radius)};
}

/// Whether every number is finite and the radius is not negative. 0 is a radius.
template <std::floating_point S>
bool is_ball(const Sphere<S>& sphere) {
  return all_finite(sphere.centre) && is_finite(sphere.radius) && sphere.radius >= S(0);
}

namespace detail {

inline constexpr double sphere_u = tolerance::unit_roundoff<double>;
inline constexpr double sphere_floor = 0x1p-1000;

// [rough-terms]
/// The terms in double, with bounds on their errors.
///
/// Each coordinate of m and of d is rounded once (d of a segment is). Then a is off by γ(5) a, b by
/// γ(5) √(a m·m), c by γ(6) s with s = m·m + r², and b² − a c, the textbook's discriminant, by less
/// than 28 u a s: one multiplication bounds it, because no term exceeds a s. Underflow adds less
/// than 2^-1000 (1 + a + s). If anything overflows, the bound is infinite or NaN.
struct RoughSphere {
  Vector3<double> m;  ///< from the centre to the start
  Vector3<double> d;  ///< direction
  double radius;
  double radius_squared;
  double s;  ///< m·m + r²
  SphereTerms<double> x;
  double c_bound;      ///< of x.c
  double depth_bound;  ///< of x.depth

  [[gnu::always_inline]] RoughSphere(const Ray<double>& ray, const Sphere<double>& sphere)
      : m(ray.origin - sphere.centre), d(ray.direction), radius(sphere.radius) {
    radius_squared = radius * radius;
    const double distance_squared = m.dot(m);
    s = distance_squared + radius_squared;
    x.a = d.dot(d);
    x.b = d.dot(m);
    x.c = distance_squared - radius_squared;
    x.depth = x.b * x.b - x.a * x.c;
    c_bound = 8 * sphere_u * s + sphere_floor;
    depth_bound = 16 * sphere_u * (x.a * (s + s)) + sphere_floor * (1 + x.a + s);
  }
};
// [/rough-terms]

/// The discriminant of the nearest point, r² a − |d × m|², with its error bound: sharp where the
/// line passes near the ball, also from far away.
///
/// A coordinate of d × m has four roundings, so it is off by e = 5 u of the sum of its two absolute
/// products, and its square by (2 |d × m| + e) e, which is small if d × m is. All else is relative
/// to r² a + |d × m|².
inline Bounded depth_by_cross(const RoughSphere& rough) {
  const double of_radius = rough.radius_squared * rough.x.a;
  double across = 0, error = 0;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const double left = rough.d[j] * rough.m[k];
    const double right = rough.d[k] * rough.m[j];
    const double off = 5 * sphere_u * (std::abs(left) + std::abs(right)) + sphere_floor;
    const double entry = left - right;
    across += entry * entry;
    error += (2 * std::abs(entry) + off) * off;
  }
  return {of_radius - across, 10 * sphere_u * (of_radius + across) + 1.001 * error +
                                  sphere_floor * (1 + rough.x.a + rough.radius_squared)};
}

/// The terms of a line in exact numbers.
inline SphereTerms<Exact> exact_terms(const Ray<Exact>& ray, const Sphere<double>& sphere) {
  const Vector3<Exact> m = ray.origin - exact_vector(sphere.centre);
  const Exact r(sphere.radius);
  const Exact a = ray.direction.dot(ray.direction);
  const Exact b = ray.direction.dot(m);
  const Exact c = m.dot(m) - r * r;
  return {a, b, c, b * b - a * c};
}

/// Whether the line meets the ball, by signs alone.
inline bool hits_exactly(const SphereTerms<Exact>& x, bool ends) {
  if (x.c.sign() <= 0) return true;
  if (x.b.sign() >= 0 || x.depth.sign() < 0) return false;
  // Outside and approaching. A segment must get to the nearest point or end in the ball.
  return !ends || (x.a + x.b).sign() >= 0 || (x.a + x.b + x.b + x.c).sign() <= 0;
}

/// The sign of the discriminant of finite input.
template <class Line>
int depth_sign(const Line& line, const Sphere<double>& sphere, const RoughSphere& rough) {
  int sign = Bounded{rough.x.depth, rough.depth_bound}.certain_sign();
  if (sign == 0) sign = depth_by_cross(rough).certain_sign();
  return sign != 0 ? sign : exact_terms(exact_ray_of(line), sphere).depth.sign();
}

/// Whether a line that is not decided at a glance meets the ball.
template <std::floating_point S, class Line>
[[gnu::noinline]] bool hits_sphere_closely(const Line& line, const Sphere<S>& sphere) {
  const auto stored = contact::in_double(line);
  const Sphere<double> ball = contact::in_double(sphere);
  const RoughSphere rough(ray_of(stored), ball);
  if constexpr (!has_end<Line>) {
    const auto& [a, b, c, depth] = rough.x;
    if (terms_are_exact(stored, ball))
      return sphere.radius >= S(0) && (c <= 0 || (b < 0 && depth >= 0));
  }
  if (rough.x.c > rough.c_bound && depth_by_cross(rough).certain_sign() < 0) return false;
  return is_finite(line) && is_ball(sphere) &&
         hits_exactly(exact_terms(exact_ray_of(stored), ball), has_end<Line>);
}

// [decide-sphere]
/// Whether a line meets a ball: 1 or −1 if that is certain, else 0.
///
/// Where c and the discriminant are certain to be positive, b² is at least a c, far more than the
/// error of b squared, so the sign of b is certain as well; likewise for the end of a segment.
template <class Line>
[[gnu::always_inline]] inline int sphere_at_a_glance(const Line& line,
                                                     const Sphere<double>& sphere) {
  const RoughSphere rough(ray_of(line), sphere);
  const auto& [a, b, c, depth] = rough.x;
  if (depth < -rough.depth_bound) return -1;
  if (!(sphere.radius >= 0)) return 0;
  if (c < -rough.c_bound && a <= 0x1p1000) return 1;
  if (!(depth > rough.depth_bound && c > rough.c_bound)) return 0;
  if (b > 0) return -1;
  if constexpr (has_end<Line>) {
    const Vector3<double> from_end = line.end - sphere.centre;
    const double size = from_end.dot(from_end);
    const double beyond = size - rough.radius_squared;
    const double bound = 8 * sphere_u * (size + rough.radius_squared) + sphere_floor;
    if (beyond > bound) return rough.d.dot(from_end) > 0 ? 1 : -1;
    if (!(beyond < -bound)) return 0;
  }
  return 1;
}

/// Whether a line meets a ball.
template <std::floating_point S, class Line>
bool decide_sphere(const Line& line, const Sphere<S>& sphere) {
  const int at_a_glance = sphere_at_a_glance(contact::in_double(line), contact::in_double(sphere));
  return at_a_glance != 0 ? at_a_glance > 0 : hits_sphere_closely(line, sphere);
}
// [/decide-sphere]

/// A passage in double, whose direction has been divided by 2^scale.
struct SphereRoots {
  double entry = 0;
  double exit = 0;
  Vector3<double> entry_normal = Vector3<double>::Zero();
  Vector3<double> exit_normal = Vector3<double>::Zero();
};

// [rough-roots]
/// Both t of a line that meets the ball, each within 2^-40 of the larger magnitude of the two; or
/// nothing if that is not certain.
///
/// With q = −b ∓ √ in which nothing cancels, the far root is q/a and the near one c/q. An error e
/// of the discriminant changes its root by at most e/√, an error of c the near root by e/q.
inline std::optional<SphereRoots> rough_roots(const RoughSphere& rough) {
  const auto& [a, b, c, unused] = rough.x;
  const Bounded depth = depth_by_cross(rough);
  const double root = std::sqrt(depth.value);
  const double size = std::abs(b) + root;  // |q|
  const double off = 6 * sphere_u * rough.d.cwiseAbs().dot(rough.m.cwiseAbs()) + sphere_floor;
  if (!(depth.bound + off * root <= 0x1p-42 * (size * root) &&
        a * rough.c_bound <= 0x1p-42 * (size * size) && size < 0x1p1000 &&
        depth.bound <= 0x1p-26 * depth.value && rough.s <= 0x1p50 * rough.radius_squared &&
        rough.s < 0x1p1000)) {
    return std::nullopt;
  }
  SphereRoots found;
  const double far = size / a;
  const double near = c / size;
  found.entry = b > 0 ? -far : std::min(near, far);
  found.exit = b > 0 ? std::max(-near, -far) : far;
  // From the centre to the nearest point, and from there along the line.
  const auto normal = [&](double t) {
    const Vector3<double> offset = rough.m + rough.d * t;
    return Vector3<double>(offset / offset.norm());
  };
  found.entry_normal = normal(found.entry);
  found.exit_normal = normal(found.exit);
  return found;
}
// [/rough-roots]

/// A direction in exact numbers, not 0, divided by a power of two so that its largest component is
/// from 1/2 to 2.
struct ScaledDirection {
  Vector3<Exact> direction;
  int exponent = 0;  ///< the direction is 2^exponent times this one

  explicit ScaledDirection(const Vector3<Exact>& d) {
    const Exact largest = std::max({abs(d.x()), abs(d.y()), abs(d.z())});
    const double size = rounded<double>(largest);
    exponent = std::isinf(size) ? std::numeric_limits<double>::max_exponent : std::ilogb(size);
    for (int k = 0; k < 3; ++k) direction(k) = times_power_of_two(d(k), -exponent);
  }
};

// [exact-roots]
/// Both t of terms whose discriminant is not negative and whose a is not 0, each with a relative
/// error of at most 5 u, without underflow.
///
/// The radicand is the quotient of the discriminant and b², or its inverse: whichever is below 1.
/// Neither root subtracts: the near one is c divided by what the far one is made of.
inline SphereRoots exact_roots(const SphereTerms<Exact>& x) {
  SphereRoots found;
  const int side = x.b.sign();
  const Exact b_squared = x.b * x.b;
  double far = 0, near = 0;  // magnitude of the far root; the near one, for b < 0
  if (x.depth <= b_squared && side != 0) {
    const double factor = 1 + root_of_quotient(x.depth, b_squared);
    far = quotient<double>(abs(x.b), x.a) * factor;
    near = quotient<double>(x.c, abs(x.b)) / factor;
  } else if (x.depth.sign() != 0) {
    const double factor = 1 + root_of_quotient(b_squared, x.depth);
    far = root_of_quotient(x.depth, x.a * x.a) * factor;
    near = x.c.sign() * (root_of_quotient(x.c * x.c, x.depth) / factor);
  }
  found.entry = side > 0 ? -far : std::min(near, far);
  found.exit = side > 0 ? std::max(-near, -far) : far;
  return found;
}

/// The same with normals: (f ± √(discriminant)/a d)/r, where a f = a m − b d goes from the centre
/// to the nearest point. Every term is rounded from its exact value, so nothing cancels.
[[gnu::noinline]] inline SphereRoots exact_roots(const Ray<Exact>& ray,
                                                 const Sphere<double>& sphere) {
  const ScaledDirection scaled(ray.direction);
  const Vector3<Exact>& d = scaled.direction;
  const SphereTerms<Exact> x = exact_terms({ray.origin, d}, sphere);
  SphereRoots found = exact_roots(x);
  const Vector3<Exact> m = ray.origin - exact_vector(sphere.centre);
  const Exact a_r = x.a * Exact(sphere.radius);
  const Vector3<double> along(rounded<double>(d.x()), rounded<double>(d.y()),
                              rounded<double>(d.z()));
  Vector3<double> middle = Vector3<double>::Zero();
  double half = 1;  // a ball of radius 0 has no normal: take the one that faces the line
  if (a_r.sign() != 0) {
    half = root_of_quotient(x.depth, a_r * a_r);
    for (int k = 0; k < 3; ++k) middle(k) = quotient<double>(x.a * m(k) - x.b * d(k), a_r);
  }
  found.entry_normal = Vector3<double>(middle - along * half).normalized();
  found.exit_normal = Vector3<double>(middle + along * half).normalized();
  found.entry = std::ldexp(found.entry, -scaled.exponent);
  found.exit = std::ldexp(found.exit, -scaled.exponent);
  return found;
}
// [/exact-roots]

/// Both t of a line that meets the ball and whose direction is not 0.
template <class Line>
SphereRoots sphere_roots(const Line& line, const Sphere<double>& sphere, const RoughSphere& rough) {
  if (const std::optional<SphereRoots> found = rough_roots(rough)) return *found;
  return exact_roots(exact_ray_of(line), sphere);
}

}  // namespace detail

}  // namespace contact
