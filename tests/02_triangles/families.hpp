/// @file
/// Rays and triangles that are hard to decide. All coordinates are floats, so that a method in
/// float and one in double get the same input. Eigen only: the ladder uses them in the page.
#pragma once

#include <support/generators.hpp>

#include <array>
#include <contact/shapes.hpp>

namespace families {

/// One or two triangles, and a ray at them. Of two, the question is whether the ray hits at least
/// one.
struct Aimed {
  contact::Ray<float> ray;
  std::array<contact::Triangle<float>, 2> triangles;
  int count = 1;
};

inline contact::Vector3<float> random_point(generators::Random& random) {
  const auto coordinate = [&random] { return static_cast<float>(random.uniform(-1, 1)); };
  const float x = coordinate();
  const float y = coordinate();
  const float z = coordinate();
  return {x, y, z};
}

/// A direction from origin towards target, both floats, rounded to float.
inline contact::Ray<float> towards(const contact::Vector3<float>& origin,
                                   const contact::Vector3<float>& target) {
  return {origin, target - origin};
}

/// A point of the segment from p to q, rounded to float.
inline contact::Vector3<float> between(const contact::Vector3<float>& p,
                                       const contact::Vector3<float>& q, double share) {
  const contact::Vector3<double> exact = p.cast<double>() + share * (q - p).cast<double>();
  return exact.cast<float>();
}

/// Random points in a box, and a ray from one point of it into the triangle's neighbourhood.
inline Aimed random(generators::Random& random) {
  const contact::Triangle<float> triangle{random_point(random), random_point(random),
                                          random_point(random)};
  const contact::Vector3<float> origin = random_point(random);
  const double along_ab = random.uniform(-0.5, 1.5);
  const double towards_c = random.uniform(-0.5, 1.5);
  const contact::Vector3<float> target =
      between(between(triangle.a, triangle.b, along_ab), triangle.c, towards_c);
  return {towards(origin, target), {triangle, triangle}, 1};
}

/// At a point of an edge: the rounding of the target and of the direction decides on which side it
/// passes.
inline Aimed at_edge(generators::Random& random) {
  const contact::Triangle<float> triangle{random_point(random), random_point(random),
                                          random_point(random)};
  const contact::Vector3<float> origin = random_point(random);
  const contact::Vector3<float> target = between(triangle.a, triangle.b, random.uniform());
  return {towards(origin, target), {triangle, triangle}, 1};
}

/// A point with whole coordinates up to ±limit.
inline contact::Vector3<float> grid_point(generators::Random& random, int limit) {
  const auto coordinate = [&random, limit] {
    return static_cast<float>(random.integer(-limit, limit));
  };
  const float x = coordinate();
  const float y = coordinate();
  const float z = coordinate();
  return {x, y, z};
}

/// On a grid, exactly through an edge or a vertex: the ray goes to the midpoint of a b, which is a
/// grid point too, or to a. Touching counts, so every ray hits a triangle that it is not parallel
/// to; the products of its coordinates need more bits than a double has.
inline Aimed on_grid(generators::Random& random) {
  const contact::Vector3<float> a = grid_point(random, 1 << 20);
  const contact::Vector3<float> half = grid_point(random, 1 << 17);
  const contact::Triangle<float> triangle{a, a + 2 * half, grid_point(random, 1 << 20)};
  const contact::Vector3<float> target =
      random.chance(0.25) ? a : contact::Vector3<float>(a + half);
  return {towards(grid_point(random, 1 << 20), target), {triangle, triangle}, 1};
}

/// Between two triangles that share an edge, at a point of that edge well away from its ends. Their
/// other vertices are on either side of it as seen along the ray, so there is no gap.
inline Aimed at_shared_edge(generators::Random& random) {
  for (;;) {
    const contact::Vector3<float> a = random_point(random);
    const contact::Vector3<float> b = random_point(random);
    const contact::Vector3<float> c = random_point(random);
    const contact::Vector3<float> d = random_point(random);
    const contact::Vector3<float> origin = random_point(random);
    const contact::Ray<float> ray = towards(origin, between(a, b, random.uniform(0.1, 0.9)));
    // The sides of the plane through the ray and the edge, with a margin much larger than rounding
    // errors.
    const contact::Vector3<double> normal =
        (b - a).cast<double>().cross(ray.direction.cast<double>());
    const double of_c = normal.dot((c - a).cast<double>());
    const double of_d = normal.dot((d - a).cast<double>());
    if (!(of_c > 0.01 && of_d < -0.01)) continue;
    return {ray, {contact::Triangle<float>{a, b, c}, contact::Triangle<float>{b, a, d}}, 2};
  }
}

}  // namespace families
